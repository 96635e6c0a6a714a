#include "core/job/verify_limits.h"

namespace facetmill {

const ParameterTable<VerifyLimits>& verify_limit_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<VerifyLimits> t;
        t.add(&VerifyLimits::gouge_limit,
              {.key = "gouge_limit",
               .label = "Gouge limit",
               .help =
                   "How deep surface may come to lie inside a cutter before it counts as a gouge; `auto`: "
                   "twice the chord tolerance that the paths keep.",
               .kind = K::number_or_word,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 100,
               .words = {"auto"},
               .stage = Stage::output});
        t.add(&VerifyLimits::uncut_limit,
              {.key = "uncut_limit",
               .label = "Uncut limit",
               .help =
                   "The share of the surface to be cut, seen by a tool axis and away from open borders, on "
                   "which more than twice the tolerance may stay: 0.02 is 2 %.",
               .minimum = 0,
               .maximum = 1,
               .stage = Stage::output});
        return t;
    }();
    return table;
}

} // namespace facetmill
