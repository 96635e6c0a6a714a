#include "core/strategy/surface/region_edit.h"

#include "core/base/tolerances.h"

namespace facetmill {

const ParameterTable<RegionEdit>& region_edit_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<RegionEdit> t;
        t.add(&RegionEdit::place, {.key = "place",
                                   .label = "Place",
                                   .help = "A place on the part: the region nearest to it is meant.",
                                   .kind = K::triple,
                                   .quantity = Quantity::length,
                                   .minimum = -tolerance::largest_coordinate,
                                   .maximum = tolerance::largest_coordinate});
        t.add(
            &RegionEdit::enabled,
            {.key = "enabled", .label = "Cut", .help = "false: the region is not cut.", .kind = K::boolean});
        t.add(&RegionEdit::grow, {.key = "grow",
                                  .label = "Grow",
                                  .help = "How far its boundary lies outside the offset; inside below 0, but "
                                          "never inside of what is uncut.",
                                  .kind = K::number,
                                  .quantity = Quantity::length,
                                  .minimum = -1e4,
                                  .maximum = 1e4});
        return t;
    }();
    return table;
}

const ParameterTable<BoundaryDrag>& boundary_drag_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<BoundaryDrag> t;
        const auto info = [](const char* key, const char* label, const char* help) {
            return ParameterInfo{.key = key,
                                 .label = label,
                                 .help = help,
                                 .kind = K::triple,
                                 .quantity = Quantity::length,
                                 .minimum = -tolerance::largest_coordinate,
                                 .maximum = tolerance::largest_coordinate};
        };
        t.add(&BoundaryDrag::from, info("from", "From", "Where the boundary was."));
        t.add(&BoundaryDrag::to, info("to", "To", "Where it was dragged to."));
        return t;
    }();
    return table;
}

} // namespace facetmill
