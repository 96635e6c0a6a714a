// Comparing lifts along vectors with the reference over many cases at once.
#pragma once

#include <QString>

#include <cstdint>

namespace facetmill::test {

struct VectorCheck {
    QString first_failure; ///< empty when all cases agree
    std::uint64_t failures = 0, touched = 0, compared = 0, maximised = 0;
    /// Cases that hang on the last digits of the coordinates: the lift is right for a body that is larger or
    /// smaller by them.
    std::uint64_t borderline = 0;
    double worst = 0; ///< largest difference from the reference beside those, mm
};

/// Cases [begin, end) of vector_case, each a mesh of one facet through the whole index. Each lift is proved
/// from both sides; every `compare_every`th is compared with the reference's own least bound, and every
/// `maximise_every`th that bound with the reference's concave maximisation.
VectorCheck check_vector_cases(std::uint64_t begin, std::uint64_t end, unsigned compare_every,
                               unsigned maximise_every);

} // namespace facetmill::test
