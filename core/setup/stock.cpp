#include "core/setup/stock.h"

namespace facetmill {

const ParameterTable<StockSpec>& stock_parameters() {
    static const auto table = [] {
        ParameterTable<StockSpec> t;
        t.add_choice(&StockSpec::kind, {.key = "kind",
                                        .label = "Kind",
                                        .help = "Shape of the raw material.",
                                        .words = {"box"},
                                        .stage = Stage::contact});
        t.add(
            &StockSpec::margin,
            {.key = "margin",
             .label = "Margin",
             .help =
                 "What the box is larger than the part: on both sides in x, on both sides in y, on top in z.",
             .kind = ParameterKind::triple,
             .quantity = Quantity::length,
             .minimum = 0,
             .maximum = 1e6,
             .stage = Stage::contact});
        return t;
    }();
    return table;
}

Box3 stock_box(const StockSpec& stock, const Box3& part) {
    if (part.empty()) return part;
    const auto& [x, y, z] = stock.margin;
    Box3 box;
    box.lo = part.lo - Vec3(x, y, 0);
    box.hi = part.hi + Vec3(x, y, z);
    return box;
}

} // namespace facetmill
