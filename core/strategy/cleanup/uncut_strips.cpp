#include "core/strategy/cleanup/uncut_strips.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/cleanup/cut_tree.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/surface/cell_set.h"
#include "core/strategy/surface/point_grid.h"

#include <optional>

namespace facetmill {

namespace {

using Triangle = std::array<Vec3, 3>;

/// A facet with less area than this share of the square of its longest edge has no sure normal.
constexpr double needle_share = 0.02;
/// What stays is measured at places so far apart, in radii,
constexpr double judge_share = 0.15;
/// and by cutters so far apart along passes that a ridge between two is this share of the tolerance.
constexpr double uncut_stand_share = 0.1;
/// Distances from motions of an upright one are known to this share of it.
constexpr double uncut_accuracy = 0.02;
/// Where less than this share of the tolerance stays it is not measured further.
constexpr double good_enough = 0.5;
/// Where the cutter must leave no more than this share of the tolerance it reaches the place.
constexpr double reached_share = 0.25;
constexpr std::size_t stands_per_check = 2048;

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
    Measuring(const CleanupJob& job, const std::vector<Pass>& passes, const Progress& progress)
        : job_(job), with_(job.cutting()), reach_of_(reach_of(with_)), near_(job.radius) {
        const double corner = std::max(job.profile.cutter().r, 0.1 * job.radius);
        const double spacing = std::sqrt(8 * corner * uncut_stand_share * job.cusp);
        for (const Pass& pass : passes)
            for (std::size_t k = 0; k < pass.cl.size(); ++k) {
                if (k % stands_per_check == 0) progress.check();
                const CutterLocation &from = pass.cl[k > 0 ? k - 1 : 0], &to = pass.cl[k];
                if (from.axis == Vec3::UnitZ() && to.axis == Vec3::UnitZ())
                    motions_.push_back({from.tip, to.tip});
                else
                    stand_along(from, to, spacing);
            }
        upright_.emplace(job.cover, motions_, uncut_accuracy * job.cusp, progress);
    }

    UncutStrips add(UncutStrips total, const RestBand& band, const Progress& progress) const {
        const std::vector<std::size_t> few = thinned(band.band);
        return parallel_reduce(
            few.size(), 64, total, progress,
            [&](std::size_t begin, std::size_t end) {
                UncutStrips sum;
                Near near;
                for (std::size_t i = begin; i < end; ++i)
                    measure(band.band[few[i]], before(band, few[i]), sum, near);
                return sum;
            },
            joined);
    }

private:
    /// What helps to find it for the next place.
    struct Near {
        LiftHint lift;
        Standing::Hint cut;
        std::uint32_t pass = CutTree::no_motion;
    };

    void stand_along(const CutterLocation& a, const CutterLocation& b, double spacing) {
        const auto parts = std::size_t((b.tip - a.tip).norm() / spacing) + 1;
        for (std::size_t i = 1; i <= parts; ++i) {
            const double t = double(i) / double(parts);
            stands_.push_back({a.tip + t * (b.tip - a.tip), (a.axis + t * (b.axis - a.axis)).normalized()});
            near_.add(Vec3(stands_.back().tip.x(), stands_.back().tip.y(), 0));
        }
    }

    /// Where facets are small against the cutter, one a cell is enough.
    std::vector<std::size_t> thinned(const std::vector<Triangle>& band) const {
        const double cell = judge_share * job_.radius;
        CellSet seen(cell);
        std::vector<std::size_t> kept;
        for (std::size_t i = 0; i < band.size(); ++i) {
            const Triangle& t = band[i];
            if (longest_square(t) > cell * cell || seen.add_first((t[0] + t[1] + t[2]) / 3))
                kept.push_back(i);
        }
        return kept;
    }

    /// What stands on a triangle before the passes.
    static double before(const RestBand& band, std::size_t triangle) {
        if (triangle >= band.left.size()) return infinity; // around places that were left
        const auto& left = band.left[triangle];
        return double(std::max({left[0], left[1], left[2]}));
    }

    double distance(const Vec3& p, const CutterLocation& at) const {
        const Vec3 rel = p - at.tip;
        const double along = rel.dot(at.axis);
        return job_.cover.distance(Vec3((rel - along * at.axis).norm(), 0, along));
    }

    /// What stays over a place on which so much stood, or anything that is good enough.
    double rest_over(const Vec3& p, double before, Near& near) const {
        const double enough = good_enough * job_.cusp;
        double rest =
            std::min(before, upright_->nearest(p, enough, std::min(before, job_.radius), near.pass));
        if (stands_.empty()) return rest;
        // An inclined cutter's contacts are farther from its tip, seen from above, by up to its radius.
        near_.near_until(Vec3(p.x(), p.y(), 0), 2.1 * job_.radius + job_.cusp, [&](std::size_t t) {
            rest = std::min(rest, distance(p, stands_[t]));
            return rest <= enough;
        });
        return rest;
    }

    /// `before`: what stands where no pass comes.
    void measure(const Triangle& t, double before, UncutStrips& sum, Near& near) const {
        const auto& [a, b, c] = t;
        const double cusp = job_.cusp;
        const Vec3 cross = (b - a).cross(c - a);
        const double area = 0.5 * cross.norm();
        if (!(area > needle_share * longest_square(t))) return;
        const Vec3 n = job_.side.towards_tool(cross.normalized());
        const Vec3 p = (a + b + c) / 3 + job_.allowance * n;
        double rest = rest_over(p, before, near);
        sum.area += area;
        // Where it is good enough the cutter has been; else what it must leave matters no more where less
        // stays than elsewhere.
        if (rest <= good_enough * cusp) sum.reached = std::max(sum.reached, rest);
        if (rest <= std::min(cusp, sum.reached)) return;
        const double limit = nearest_touch(reach_of_, p, n, near.lift).gap;
        const double missed_from = limit + (1 + tolerance::uncut_margin) * cusp;
        // What operations before left of thick material is not known yet, and matters seldom.
        if (rest < infinity && rest > cusp
            && (rest > missed_from || rest > (limit > cusp ? sum.hollow : sum.reached)))
            rest = job_.standing.uncut(p, rest, infinity, near.cut);
        if (limit > cusp && rest < infinity && rest > std::max(sum.hollow, cusp)) {
            sum.hollow = rest;
            sum.hollow_at = p;
        }
        if (limit <= reached_share * cusp && rest < infinity) sum.reached = std::max(sum.reached, rest);
        if (rest > missed_from) {
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
    std::vector<CutTree::Motion> motions_; ///< of the upright cutter
    std::optional<CutTree> upright_;
    std::vector<CutterLocation> stands_; ///< of the inclined one
    PointGrid near_;                     ///< their tips, seen from above
};

} // namespace

UncutStrips measure_uncut(const CleanupJob& job, const std::vector<FoundStrip>& found,
                          const std::vector<Strip>& described, const std::vector<Pass>& passes,
                          const Progress& progress) {
    const Measuring measuring(job, passes, progress);
    UncutStrips total;
    for (std::size_t s = 0; s < found.size(); ++s)
        if (described[s].enabled)
            total = measuring.add(total, found[s].band, progress.part(double(s) / double(found.size()), 1));
    return total;
}

} // namespace facetmill
