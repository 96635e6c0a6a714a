#include "core/strategy/cleanup/standing.h"

#include "core/base/tolerances.h"

namespace facetmill {

namespace {

/// Distances from what was cut are known to this share of what counts as nothing.
constexpr double standing_accuracy = 0.02;

} // namespace

Standing::Standing(const PlanContext& context, const AptCutter& asked, double enough, double over,
                   const Progress& progress)
    : raw_(context.stock.box.empty() ? context.stock_box : context.stock.box), enough_(enough) {
    for (auto earlier = context.earlier.rbegin(); earlier != context.earlier.rend(); ++earlier) {
        progress.check();
        if ((*earlier)->motions.empty() || (*earlier)->cutter == asked) continue;
        const CutterCover cover(CutterProfile((*earlier)->cutter), 0);
        cuts_.push_back({*earlier,
                         std::make_unique<const CutTree>(cover, (*earlier)->motions,
                                                         standing_accuracy * enough, progress),
                         (*earlier)->no_nearer - over});
    }
}

double Standing::raw_over(const Vec3& p, const Vec3& n) const {
    double thick = infinity;
    if (raw_.empty()) return thick;
    for (int k = 0; k < 3; ++k) {
        if (p[k] < raw_.lo[k] - tolerance::contact_distance
            || p[k] > raw_.hi[k] + tolerance::contact_distance)
            return 0;
        if (n[k] > tolerance::level_angle) thick = std::min(thick, (raw_.hi[k] - p[k]) / n[k]);
        if (n[k] < -tolerance::level_angle) thick = std::min(thick, (raw_.lo[k] - p[k]) / n[k]);
    }
    return std::max(thick, 0.0);
}

double Standing::uncut(const Vec3& p, double thick, double asked, Hint& hint) const {
    hint.resize(cuts_.size(), CutTree::no_motion);
    for (std::size_t i = 0; i < cuts_.size() && thick > enough_; ++i)
        if (const Cuts& c = cuts_[i]; std::min(thick, asked) > c.no_nearer)
            thick = std::min(thick, c.tree->nearest(p, enough_, std::min(thick, asked), hint[i]));
    return thick;
}

bool Standing::stands(const Vec3& p, double thick, double least, Hint& hint) const {
    if (!(thick > least)) return false;
    hint.resize(cuts_.size(), CutTree::no_motion);
    for (std::size_t i = 0; i < cuts_.size(); ++i)
        if (const Cuts& c = cuts_[i];
            least > c.no_nearer && c.tree->nearest(p, least, least, hint[i]) < least)
            return false;
    return true;
}

} // namespace facetmill
