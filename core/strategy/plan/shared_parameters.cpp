#include "core/strategy/plan/shared_parameters.h"

namespace facetmill {

ParameterInfo chord_tolerance_parameter(const std::string& what) {
    return {.key = "chord_tolerance",
            .label = "Chord tolerance",
            .help = what
                    + "; the deepest gouge that the verification lets pass. auto is a twentieth of the "
                      "tolerance, but at most 0.01 mm (0.0004 in). At most half the tolerance is used.",
            .kind = ParameterKind::number_or_word,
            .quantity = Quantity::length,
            .minimum = 0,
            .maximum = 1000,
            .open_minimum = true,
            .words = {"auto"},
            .advanced = true};
}

ParameterInfo holder_clearance_parameter() {
    return {.key = "holder_clearance",
            .label = "Holder clearance",
            .help = "Distance that shank and holder keep from the part.",
            .kind = ParameterKind::number,
            .quantity = Quantity::length,
            .minimum = 0,
            .maximum = 1000,
            .advanced = true};
}

} // namespace facetmill
