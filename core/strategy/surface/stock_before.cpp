#include "core/strategy/surface/stock_before.h"

namespace facetmill {

StockField stock_before(const PlanContext& context, double cell, const Progress& progress, double from,
                        const Box3& within) {
    StockSolid solid = context.stock;
    if (solid.box.empty()) {
        solid = StockSolid();
        solid.box = context.stock_box;
    }
    StockField field(solid, cell, progress.part(0, 0.5));
    if (from > -infinity) field.forget_below(from);
    for (const auto& earlier : context.earlier) {
        const StockCutter cutter{CutterProfile(earlier->cutter)};
        field.cut(cutter, earlier->motions, progress.part(0.5, 0.5), within);
    }
    progress.set(1);
    return field;
}

} // namespace facetmill
