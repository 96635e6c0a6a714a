#include "core/strategy/cleanup/uncut_strips.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/surface/point_grid.h"

namespace facetmill {

namespace {

using Triangle = std::array<Vec3, 3>;

/// A facet with less area than this share of the square of its longest edge has no sure normal.
constexpr double needle_share = 0.02;
/// What stays is measured at places so far apart, in radii,
constexpr double judge_share = 0.1;
/// and by cutters so far apart along passes that a ridge between two is this share of the tolerance.
constexpr double stand_share = 0.1;
/// Where less than this share of the tolerance stays it is not measured further.
constexpr double good_enough = 0.5;
/// Where the cutter must leave no more than this share of the tolerance it reaches the place.
constexpr double reached_share = 0.25;

double longest_square(const Triangle& t) {
    const auto& [a, b, c] = t;
    return std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
}

UncutStrips joined(UncutStrips x, const UncutStrips& y) {
    x.area += y.area;
    x.reached = std::max(x.reached, y.reached);
    x.missed_area += y.missed_area;
    if (y.hollow > x.hollow) {
        x.hollow = y.hollow;
        x.hollow_at = y.hollow_at;
    }
    if (y.missed > x.missed) {
        x.missed = y.missed;
        x.missed_at = y.missed_at;
    }
    return x;
}

class Measuring {
public:
    Measuring(const CleanupJob& job, const std::vector<Pass>& passes)
        : job_(job), with_(job.cutting()), reach_of_(reach_of(with_)), near_(job.radius) {
        bool inclined = false;
        const double corner = std::max(job.profile.cutter().r, 0.1 * job.radius);
        const double spacing = std::sqrt(8 * corner * stand_share * job.cusp);
        for (const Pass& pass : passes)
            for (std::size_t k = 0; k < pass.cl.size(); ++k) {
                inclined = inclined || pass.cl[k].axis != Vec3::UnitZ();
                stand_along(k > 0 ? pass.cl[k - 1] : pass.cl[k], pass.cl[k], spacing);
            }
        // An inclined cutter's contacts are farther from its tip, seen from above, by up to its radius.
        reach_ = (inclined ? 2.1 : 1.1) * job.radius + job.cusp;
    }

    UncutStrips add(UncutStrips total, const std::vector<Triangle>& band, const Progress& progress) const {
        const std::vector<Triangle> few = thinned(band);
        return parallel_reduce(
            few.size(), 64, total, progress,
            [&](std::size_t begin, std::size_t end) {
                UncutStrips sum;
                LiftHint hint;
                for (std::size_t i = begin; i < end; ++i)
                    measure(few[i], sum, hint);
                return sum;
            },
            joined);
    }

private:
    void stand_along(const CutterLocation& a, const CutterLocation& b, double spacing) {
        const auto parts = std::size_t((b.tip - a.tip).norm() / spacing) + 1;
        for (std::size_t i = 1; i <= parts; ++i) {
            const double t = double(i) / double(parts);
            stands_.push_back({a.tip + t * (b.tip - a.tip), (a.axis + t * (b.axis - a.axis)).normalized()});
            near_.add(Vec3(stands_.back().tip.x(), stands_.back().tip.y(), 0));
        }
    }

    /// Where facets are small against the cutter, one a cell is enough.
    std::vector<Triangle> thinned(const std::vector<Triangle>& band) const {
        const double cell = judge_share * job_.radius;
        PointGrid seen(cell);
        std::vector<Triangle> kept;
        for (const Triangle& t : band)
            if (longest_square(t) > cell * cell || seen.add_first((t[0] + t[1] + t[2]) / 3))
                kept.push_back(t);
        return kept;
    }

    double distance(const Vec3& p, const CutterLocation& at) const {
        const Vec3 rel = p - at.tip;
        const double along = rel.dot(at.axis);
        return job_.cover.distance(Vec3((rel - along * at.axis).norm(), 0, along));
    }

    /// What stays over a place, or anything that is good enough.
    double rest_over(const Vec3& p) const {
        double rest = infinity;
        near_.near_until(Vec3(p.x(), p.y(), 0), reach_, [&](std::size_t t) {
            rest = std::min(rest, distance(p, stands_[t]));
            return rest <= good_enough * job_.cusp;
        });
        return rest;
    }

    void measure(const Triangle& t, UncutStrips& sum, LiftHint& hint) const {
        const auto& [a, b, c] = t;
        const double cusp = job_.cusp;
        const Vec3 cross = (b - a).cross(c - a);
        const double area = 0.5 * cross.norm();
        if (!(area > needle_share * longest_square(t))) return;
        const Vec3 n = job_.side.towards_tool(cross.normalized());
        const Vec3 p = (a + b + c) / 3 + job_.allowance * n;
        const double limit = nearest_touch(reach_of_, p, n, hint).gap;
        const double rest = rest_over(p);
        sum.area += area;
        if (limit > cusp && rest < infinity && rest > std::max(sum.hollow, cusp)) {
            sum.hollow = rest;
            sum.hollow_at = p;
        }
        if (limit <= reached_share * cusp && rest < infinity) sum.reached = std::max(sum.reached, rest);
        if (rest > limit + (1 + tolerance::uncut_margin) * cusp) {
            sum.missed_area += area;
            if (rest > sum.missed) {
                sum.missed = rest;
                sum.missed_at = p;
            }
        }
    }

    const CleanupJob& job_;
    StripCutting with_;
    ValleyInput reach_of_;
    double reach_ = 0;
    std::vector<CutterLocation> stands_;
    PointGrid near_; ///< their tips, seen from above
};

} // namespace

UncutStrips measure_uncut(const CleanupJob& job, const std::vector<FoundStrip>& found,
                          const std::vector<Strip>& described, const std::vector<Pass>& passes,
                          const Progress& progress) {
    const Measuring measuring(job, passes);
    UncutStrips total;
    for (std::size_t s = 0; s < found.size(); ++s)
        if (described[s].enabled)
            total =
                measuring.add(total, found[s].band.band, progress.part(double(s) / double(found.size()), 1));
    return total;
}

} // namespace facetmill
