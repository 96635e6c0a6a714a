#include "core/strategy/cleanup/pencil_probe.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/cleanup/valley_scale.h"
#include "core/strategy/surface/point_grid.h"

namespace facetmill {

namespace {

/// Touched points nearer to each other than this, in radii, are the same flank's: more than noise lets a
/// touched point jump about on one flank, less than the width of any valley that leaves something.
constexpr double min_jump = 0.12;
/// By more, in radii, the tip falls only beside an upright wall.
constexpr double fall_share = 0.02;
/// Strides of the tip on its way to the other flank, and how far it goes, in radii.
constexpr double stride_share = 0.15, farthest_share = 2.2;
/// The other flank is found to so many halvings of a stride, where a valley is followed; most samples lie in
/// valleys that are known by then, and say so sooner.
constexpr int seed_halvings = 30, about_halvings = 10;

/// Moves the tip on, starting from a place where `last` is touched, until another flank holds it.
std::optional<PencilSeed> seed_on(const PencilProbe& probe, const Vec2& at, const Vec2& ahead,
                                  CutterTouch last, int halvings, LiftHint& hint) {
    const auto touch = [&](double x) { return probe.touch_at(at + x * ahead, hint); };
    const double stride = stride_share * probe.radius();
    for (double x = 0; x < farthest_share * probe.radius(); x += stride) {
        const CutterTouch next = touch(x + stride);
        if (!next.valid) return std::nullopt;
        if (const auto jump = probe.jump(touch, x, x + stride, last, next, halvings))
            return PencilSeed{probe.pencil((*jump)[0], (*jump)[1]), at + x * ahead, ahead};
        last = next;
    }
    return std::nullopt;
}

/// From a sample away from the flank that holds the cutter up there.
std::optional<PencilSeed> seed_from(const PencilProbe& probe, const RestSample& s) {
    const Vec2 at = s.tip.head<2>();
    LiftHint hint;
    const CutterTouch touch = probe.touch_at(at, hint);
    if (!touch.valid) return std::nullopt;
    Vec2 ahead = (touch.normal - s.normal).head<2>();
    if (ahead.norm() < tolerance::level_angle) ahead = -s.normal.head<2>();
    if (ahead.norm() < tolerance::level_angle) return std::nullopt;
    return seed_on(probe, at, ahead.normalized(), touch, about_halvings, hint);
}

} // namespace

bool PencilProbe::same_flank(const CutterTouch& a, const CutterTouch& b) {
    return apart(a, b) < min_jump;
}

CutterTouch PencilProbe::touch_at(const Vec2& at, LiftHint& hint) const {
    CutterTouch t;
    const AxialContact c = in_.lift->contact(at.x(), at.y(), hint);
    if (!(c.tip_z > -infinity)) return t;
    t.valid = true;
    t.tip = Vec3(at.x(), at.y(), c.tip_z);
    t.point = c.point;
    const Vec3 rel = c.point - t.tip;
    const Vec3 facet = in_.side->towards_tool(in_.mesh->facet_normal(c.facet));
    t.normal = in_.cover->contact_normal(rel).value_or(facet);
    t.feature = rel / radius_;
    // All places of a flat bottom are one.
    if (in_.cover->has_flat_bottom() && rel.z() <= in_.tolerance
        && (t.normal.z() > tolerance::level_normal_z || facet.z() > tolerance::level_normal_z))
        t.feature = Vec3::Zero();
    return t;
}

PencilPoint PencilProbe::pencil(const CutterTouch& left, const CutterTouch& right) const {
    PencilPoint p;
    p.touch = {left.point, right.point};
    p.normal = {left.normal, right.normal};
    p.tip = left.tip.z() > right.tip.z() ? left.tip : right.tip;
    const double fall = left.tip.z() - right.tip.z();
    if (std::abs(fall) > fall_share * radius_) {
        // An upright wall: the lower one passes along it, the higher one stands on its top.
        const CutterTouch& low = fall > 0 ? right : left;
        const CutterTouch& high = fall > 0 ? left : right;
        p.tip = low.tip;
        Vec3 out(high.point.x() - low.tip.x(), high.point.y() - low.tip.y(), 0);
        if (out.norm() > 0) out.normalize();
        const std::size_t side = fall > 0 ? 0 : 1;
        p.touch[side] = low.tip + radius_ * out + Vec3(0, 0, in_.cover->shoulder());
        p.normal[side] = -out;
    }
    return p;
}

double PencilProbe::moved(const PencilPoint& a, const PencilPoint& b) const {
    return std::max((feature(a, 0) - feature(b, 0)).norm(), (feature(a, 1) - feature(b, 1)).norm());
}

PencilPoint turned_round(PencilPoint p) {
    std::swap(p.touch[0], p.touch[1]);
    std::swap(p.normal[0], p.normal[1]);
    return p;
}

std::optional<PencilPoint> pencil_at(const PencilProbe& probe, const PencilSeed& seed) {
    LiftHint hint;
    const CutterTouch touch = probe.touch_at(seed.from, hint);
    if (!touch.valid) return std::nullopt;
    const auto found = seed_on(probe, seed.from, seed.ahead, touch, seed_halvings, hint);
    return found ? std::optional(found->about) : std::nullopt;
}

std::vector<PencilSeed> pencil_seeds(const ValleyInput& input, const std::vector<RestSample>& samples,
                                     const Progress& progress) {
    const PencilProbe probe(input);
    const ValleyScale scale(input);
    // One sample a cell is enough to meet every curve many times.
    PointGrid seen(2 * scale.step);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (seen.add_first(samples[i].point)) chosen.push_back(i);
    std::vector<std::optional<PencilSeed>> found(chosen.size());
    parallel_for(chosen.size(), 32, progress,
                 [&](std::size_t i) { found[i] = seed_from(probe, samples[chosen[i]]); });
    std::vector<PencilSeed> seeds;
    for (const auto& f : found)
        if (f) seeds.push_back(*f);
    return seeds;
}

} // namespace facetmill
