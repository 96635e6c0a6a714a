// The parameters of all operations that finish with five axes, described once for Finish5Settings and what is
// derived from it. Lead limits are finish5's own.
#pragma once

#include "core/strategy/five_axis/finish5.h"
#include "core/strategy/plan/shared_parameters.h"

namespace facetmill {

template <class S>
void add_five_axis_parameters(ParameterTable<S>& t) {
    using K = ParameterKind;
    const auto member = []<class T>(T Finish5Settings::*m) -> T S::* { return m; };
    t.add_choice(member(&S::posture),
                 {.key = "posture",
                  .label = "Posture",
                  .help = "How tool axes are chosen: cm2 matches curvatures, local stays closest to one axis "
                          "point by point, global takes the path that needs least machining time.",
                  .words = {"cm2", "local", "global"}});
    t.add(member(&S::grid_step), {.key = "grid_degrees",
                                  .label = "Posture grid",
                                  .help = "Step of inclination and yaw in the configuration space.",
                                  .kind = K::number,
                                  .quantity = Quantity::angle,
                                  .minimum = radians(0.25),
                                  .maximum = radians(30)});
    if constexpr (std::is_same_v<S, Finish5Settings>)
        t.add(member(&S::lead_limits),
              {.key = "lead_limits",
               .label = "Lead limits",
               .help = "Smallest and largest inclination of the tool axis from the surface "
                       "normal towards the travel.",
               .kind = K::pair,
               .quantity = Quantity::angle,
               .minimum = 0,
               .maximum = radians(89),
               .ordered = true});
    t.add(member(&S::yaw_limits),
          {.key = "yaw_limits",
           .label = "Yaw limits",
           .help = "How far the inclination may turn about the surface normal, to the "
                   "right (below 0) and to the left of the travel.",
           .kind = K::pair,
           .quantity = Quantity::angle,
           .minimum = -pi,
           .maximum = pi,
           .ordered = true});
    t.add(member(&S::stepover),
          length_or_word_parameter({.key = "stepover",
                                    .label = "Step-over",
                                    .help = "Distance between neighbouring drive planes: adaptive is "
                                            "everywhere the largest that the tolerance allows; a length is "
                                            "kept.",
                                    .words = {"adaptive"}}));
    t.add_choice(member(&S::pattern),
                 pattern_parameter("zigzag cuts to and fro; oneway always cuts in the direction of travel "
                                   "and returns above the part."));
    t.add(member(&S::chord_tolerance),
          chord_tolerance_parameter("How far motions may run beside the exact path"));
    t.add(member(&S::normal_limit), normal_limit_parameter());
    t.add(member(&S::turn_limit),
          {.key = "turn_limit",
           .label = "Turn limit",
           .help = "Largest turn of the tool axis between neighbouring points of a pass.",
           .kind = K::number,
           .quantity = Quantity::angle,
           .minimum = radians(0.5),
           .maximum = pi,
           .advanced = true});
    t.add(member(&S::holder_clearance), holder_clearance_parameter());
    t.add(member(&S::accelerations),
          {.key = "accelerations",
           .label = "Accelerations",
           .help = "Choose global postures, and count the time, with what the machine's "
                   "axes take to change their speed, where its file says.",
           .kind = K::boolean,
           .advanced = true});
}

} // namespace facetmill
