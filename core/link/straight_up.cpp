#include "core/link/straight_up.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace facetmill {

namespace {

/// In radii of the cutter, where the clearance is more.
constexpr double near_share = 0.5;

/// Whether shank and holder, all of them, are as wide as the cutter.
bool is_wide_above(const Tool& tool, double radius) {
    double narrowest = tool.shank_length > 0 ? tool.shank_diameter : infinity;
    for (const HolderSection& s : tool.holder)
        if (s.length > 0) narrowest = std::min(narrowest, s.diameter);
    return narrowest < infinity && narrowest >= 2 * radius * (1 - tolerance::same_shape);
}

} // namespace

StraightUp::StraightUp(const Tool& tool) {
    const CutterProfile profile(tool.cutter());
    radius_ = profile.max_radius();
    height_ = profile.height();
    undercut_ = facetmill::is_undercut(profile);
    wide_above_ = is_wide_above(tool, radius_);
}

bool StraightUp::stands_above(const StockField& field, const Vec2& a, const Vec2& b, double z) const {
    return field.no_higher() > z + height_ && field.highest_near(a, b, radius_, z + height_) > z + height_;
}

bool StraightUp::is_free(const StockField& field, const Vec3& tip) const {
    const Vec2 p = tip.head<2>();
    return !undercut_ && (wide_above_ || !stands_above(field, p, p, tip.z()));
}

double StraightUp::near_to_stock(double clearance) const {
    return std::min(clearance, near_share * radius_);
}

} // namespace facetmill
