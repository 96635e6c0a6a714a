#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/plan/shared_parameters.h"

#include <algorithm>

namespace facetmill {

const ParameterTable<CleanupSettings>& cleanup_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = CleanupSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        add_tool_axis_parameter(t);
        t.add(&S::previous_tool,
              further_tool_parameter({.key = "previous_tool",
                                      .label = "Previous tool",
                                      .help = "Number of the tool that cut the part before: clean-up looks "
                                              "for what it could not enter.",
                                      .stage = Stage::cutter},
                                     1));
        t.add(&S::normal_change_limit,
              {.key = "normal_change_limit",
               .label = "Normal change limit",
               .help = "Turn of the surface's normal per length, in radians per mm, above which a hollow is "
                       "a strip "
                       "even where the previous tool could enter it; auto leaves that to the previous tool.",
               .kind = K::number_or_word,
               .minimum = 1e-4,
               .maximum = 1e3,
               .words = {"auto"},
               .advanced = true});
        t.add_choice(&S::lift,
                     {.key = "lift",
                      .label = "Lift",
                      .help = "How the tool is moved out of what it would cut: along a vector fitted to "
                              "the strip, or along Z.",
                      .words = {"strip", "z"}});
        t.add(&S::overlap,
              {.key = "overlap",
               .label = "Overlap",
               .help = "How far passes go on over what the previous tool has cut; auto is half the "
                       "tool's radius.",
               .kind = K::number_or_word,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1000,
               .words = {"auto"}});
        t.add(&S::smallest_strip,
              {.key = "smallest_strip",
               .label = "Smallest strip",
               .help =
                   "Valleys shorter than this are left out as noise, and shorter interruptions are bridged; "
                   "auto is the tool's radius.",
               .kind = K::number_or_word,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1000,
               .words = {"auto"},
               .advanced = true});
        t.add_choice(&S::pattern, pattern_parameter("zigzag cuts neighbouring passes to and fro; oneway "
                                                    "all in the same direction."));
        t.add(&S::left_points,
              {.key = "left_points",
               .label = "Also points left out",
               .help = "Strips also around contact points that operations before left to clean-up, as those "
                       "without a free posture.",
               .kind = K::boolean});
        t.add(&S::rest_material,
              {.key = "rest_material",
               .label = "Rest material",
               .help = "Strips also where more than the tolerance stands after the operations before: their "
                       "programs are verified first.",
               .kind = K::boolean});
        t.add(&S::tilt_limit, tilt_limit_parameter());
        t.add(&S::switched_off, {.key = switched_off_key,
                                 .label = "Switched off",
                                 .help = "Names of strips that are found but not cut, separated by commas.",
                                 .kind = K::names,
                                 .nouns = {"strip", "strips"}});
        return t;
    }();
    return table;
}

bool is_switched_off(const std::string& list, const std::string& name) {
    const auto names = listed_names(list);
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string with_switched(const std::string& list, const std::string& name, bool on) {
    std::string result;
    for (const std::string& n : listed_names(list))
        if (n != name) result += (result.empty() ? "" : ", ") + n;
    if (!on) result += (result.empty() ? "" : ", ") + name;
    return result;
}

} // namespace facetmill
