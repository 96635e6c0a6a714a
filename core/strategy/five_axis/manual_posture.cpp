#include "core/strategy/five_axis/manual_posture.h"

#include "core/strategy/plan/shared_parameters.h"

namespace facetmill {

const ParameterTable<ManualPosture>& manual_posture_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<ManualPosture> t;
        t.add(&ManualPosture::point,
              place_parameter({.key = "point",
                               .label = "Point",
                               .help = "Place on the part whose nearest contact point it is for.",
                               .required = "give the place on the part"}));
        t.add(&ManualPosture::lead, {.key = "lead",
                                     .label = "Lead",
                                     .help = "Inclination of the tool axis from the surface normal towards "
                                             "the travel. The lead limits do not hold it.",
                                     .kind = K::number,
                                     .quantity = Quantity::angle,
                                     .minimum = 0,
                                     .maximum = radians(89),
                                     .required = "give the inclination"});
        t.add(&ManualPosture::yaw, {.key = "yaw",
                                    .label = "Yaw",
                                    .help = "How far the inclination is turned about the surface normal, to "
                                            "the left of the travel; to the right below 0.",
                                    .kind = K::number,
                                    .quantity = Quantity::angle,
                                    .minimum = -pi,
                                    .maximum = pi,
                                    .required = "give the yaw"});
        return t;
    }();
    return table;
}

} // namespace facetmill
