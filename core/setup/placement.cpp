#include "core/setup/placement.h"

namespace facetmill {

ParameterInfo mesh_unit_parameter() {
    return {.key = "units",
            .label = "Units",
            .help = "Unit of the numbers in the mesh file. Default: the project's.",
            .words = unit_names(),
            .stage = Stage::mesh};
}

ParameterInfo scale_parameter(const std::string& what) {
    return {.key = "scale",
            .label = "Scale",
            .help =
                "Makes the " + what
                + " so many times as large as its file and unit say, about the file's origin; 1 leaves it. "
                  "Unit, scale, mirror, rotate and translate are applied in this order.",
            .minimum = 0,
            .maximum = 1e6,
            .open_minimum = true,
            .stage = Stage::mesh};
}

ParameterInfo mirror_parameter(const std::string& what) {
    return {.key = "mirror",
            .label = "Mirror",
            .help = "Turns the " + what
                    + " into its mirror image, before it is turned: this coordinate of its points changes "
                      "sign.",
            .words = {"none", "x", "y", "z"},
            .stage = Stage::mesh};
}

ParameterInfo rotate_parameter(std::string help) {
    return {.key = "rotate",
            .label = "Rotate",
            .help = std::move(help),
            .kind = ParameterKind::triple,
            .quantity = Quantity::angle,
            .minimum = -2 * pi,
            .maximum = 2 * pi,
            .stage = Stage::mesh};
}

ParameterInfo translate_parameter(std::string help) {
    return {.key = "translate",
            .label = "Translate",
            .help = std::move(help),
            .kind = ParameterKind::triple,
            .quantity = Quantity::length,
            .minimum = -1e6,
            .maximum = 1e6,
            .stage = Stage::mesh};
}

} // namespace facetmill
