#include "core/strategy/surface/holder_reach.h"

#include "core/base/tolerances.h"
#include "core/strategy/surface/lift_line.h"

#include <algorithm>

namespace facetmill {

HolderReach::HolderReach(ContactIndexPtr index, const Tool& tool, double clearance, double margin) {
    const CutterProfile cutter(tool.cutter());
    double base = tool.flute_length, widest = 2 * cutter.max_radius();
    const auto add = [&](double diameter, double length, bool is_shank) {
        // What is no wider than a body below it with the same distance from the part never stops the tool.
        const bool is_hidden =
            diameter <= (1 + tolerance::same_shape) * widest && (!is_shank || !(clearance > 0));
        if (diameter > 0 && length > 0 && !is_hidden) {
            const CutterProfile cylinder(AptCutter::flat(diameter, unlimited_height));
            bodies_.push_back({AxialLift(index, cylinder, clearance + margin), base, is_shank});
            spacing_ = std::min(spacing_, safe_spacing(cylinder, margin));
            widest = std::max(widest, diameter);
        }
        base += std::max(length, 0.0);
    };
    add(tool.shank_diameter, tool.shank_length, true);
    for (const HolderSection& s : tool.holder)
        add(s.diameter, s.length, false);
}

double HolderReach::raised(const Vec2& p, double z, Hints& hints) const {
    hints.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const double under = z + bodies_[i].base;
        const double body = bodies_[i].lift.tip_z(p.x(), p.y(), hints[i], under);
        if (body > under) z = body - bodies_[i].base;
    }
    return z;
}

bool HolderReach::is_free(const Vec3& tip, Hints& hints) const {
    hints.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].lift.is_above(tip.x(), tip.y(), tip.z() + bodies_[i].base, hints[i])) return false;
    return true;
}

HolderReach::Lack HolderReach::lack(const Vec3& tip) const {
    Lack lack;
    for (const Body& b : bodies_) {
        double& mine = b.is_shank ? lack.shank : lack.holder;
        mine = std::max(mine, b.lift.tip_z(tip.x(), tip.y()) - (tip.z() + b.base));
    }
    return lack;
}

} // namespace facetmill
