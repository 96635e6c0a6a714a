// Comparing lifts with the reference over many cases at once.
#pragma once

#include <QString>

#include <cstdint>

namespace facetmill::test {

struct LiftCheck {
    QString first_failure; ///< empty when all cases agree
    double worst = 0;      ///< largest difference, mm
    std::uint64_t touched = 0;
    std::uint64_t borderline =
        0; ///< where the disc's rim decides by rounding whether there is a contact at all
};

/// Cases [begin, end) of lift_case, each a mesh of one facet through the whole index.
LiftCheck check_lift_cases(std::uint64_t begin, std::uint64_t end);

} // namespace facetmill::test
