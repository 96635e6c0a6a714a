#include "core/strategy/five_axis/manual_posture.h"

#include "core/base/tolerances.h"

namespace facetmill {

const ParameterTable<ManualPosture>& manual_posture_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<ManualPosture> t;
        t.add(&ManualPosture::point, {.key = "point",
                                      .label = "Point",
                                      .help = "Place on the part whose nearest contact point it is for.",
                                      .kind = K::triple,
                                      .quantity = Quantity::length,
                                      .minimum = -tolerance::largest_coordinate,
                                      .maximum = tolerance::largest_coordinate});
        t.add(&ManualPosture::lead, {.key = "lead",
                                     .label = "Lead",
                                     .help = "Inclination of the tool axis from the surface normal towards "
                                             "the travel. The lead limits do not hold it.",
                                     .kind = K::number,
                                     .quantity = Quantity::angle,
                                     .minimum = 0,
                                     .maximum = radians(89)});
        t.add(&ManualPosture::yaw, {.key = "yaw",
                                    .label = "Yaw",
                                    .help = "How far the inclination is turned about the surface normal, to "
                                            "the left of the travel; to the right below 0.",
                                    .kind = K::number,
                                    .quantity = Quantity::angle,
                                    .minimum = -pi,
                                    .maximum = pi});
        return t;
    }();
    return table;
}

} // namespace facetmill
