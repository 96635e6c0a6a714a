// Straight up out of a cut and down to one: how much of that may be a rapid. Millimetres, part coordinates,
// the tool's axis +Z.
#pragma once

#include "core/setup/tool.h"
#include "core/strategy/surface/stock_field.h"

namespace facetmill {

class StraightUp {
public:
    explicit StraightUp(const Tool& tool);

    /// Whether the cutter is narrower above than below: what stands beside its neck is cut on the way up.
    bool is_undercut() const { return undercut_; }
    /// Whether something may stand higher than the flutes of a tip at z, beside a level line from a to b.
    bool stands_above(const StockField& field, const Vec2& a, const Vec2& b, double z) const;
    /// Whether the cutter comes up from a tip without cutting: beside a shank and a holder that are as wide
    /// what would stand in its way stood in theirs; beside slimmer ones nothing may stand above the flutes.
    bool is_free(const StockField& field, const Vec3& tip) const;
    /// Whether a tool that has stood with its tip at a place has left all free above it: shank and holder,
    /// all of them as wide as the cutter, were there.
    bool frees_column() const { return !undercut_ && wide_above_; }
    /// How near to what stands a rapid straight up or down comes: the clearance, or half the cutter's radius
    /// where that is less.
    double near_to_stock(double clearance) const;

private:
    double radius_, height_;
    bool undercut_, wide_above_;
};

} // namespace facetmill
