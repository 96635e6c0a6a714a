// A stock field that is cut no sooner than somebody asks: most of what a finishing pass cuts is never asked
// about before the tool is gone. Millimetres, part coordinates, the tool's axis +Z.
#pragma once

#include "core/strategy/surface/stock_field.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace facetmill {

class LaterCuts {
public:
    /// `lowest`: no tip that is fed is lower. Where the order of cuts counts, because the cutter is undercut
    /// or shorter than what stands over that, they are made at once.
    LaterCuts(StockField field, const CutterProfile& cutter, double lowest, const Progress& progress);

    void feed(const Vec3& from, const Vec3& to);
    /// The field, as all cuts so far have left it within `radius` of the line from a to b; elsewhere more may
    /// stand.
    const StockField& about(const Vec2& a, const Vec2& b, double radius);
    /// Nothing stands higher, wherever: what stood highest before all cuts.
    double highest() const { return field_.no_higher(); }

private:
    struct Tiles {
        int column0, column1, row0, row1;
    };
    Tiles tiles(const Vec2& lo, const Vec2& hi) const;
    void take(const Tiles& all, std::vector<std::uint32_t>& cuts);

    StockField field_;
    StockCutter cutter_;
    Progress progress_;
    double tile_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<StockField::Motion> fed_;
    std::vector<char> cut_;                        ///< of those fed
    std::vector<std::vector<std::uint32_t>> near_; ///< what is to be cut in each tile; none: at once
};

} // namespace facetmill
