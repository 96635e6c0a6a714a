#include "core/strategy/surface/region_edit.h"

#include "core/strategy/plan/shared_parameters.h"

namespace facetmill {

const ParameterTable<RegionEdit>& region_edit_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<RegionEdit> t;
        t.add(&RegionEdit::place,
              place_parameter({.key = "place",
                               .label = "Place",
                               .help = "A place on the part: the region nearest to it is meant.",
                               .required = "give a place in the region"}));
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
        ParameterTable<BoundaryDrag> t;
        t.add(&BoundaryDrag::from, place_parameter({.key = "from",
                                                    .label = "From",
                                                    .help = "Where the boundary was.",
                                                    .required = "give the boundary's place"}));
        t.add(&BoundaryDrag::to, place_parameter({.key = "to",
                                                  .label = "To",
                                                  .help = "Where it was dragged to.",
                                                  .required = "give the place it moves to"}));
        return t;
    }();
    return table;
}

} // namespace facetmill
