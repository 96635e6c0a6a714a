#include "core/strategy/cleanup/rest_gaps.h"

#include "core/base/parallel.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/surface/point_grid.h"

namespace facetmill {

namespace {

/// Normals nearer to each other than this (cosine) ask the same.
constexpr double same_gap_normal = 0.9999;
/// Tips are asked within so many radii, one after the other until none farther away can be nearer: an upright
/// wall is just at the radius.
constexpr std::array asked_radii{1.02, 1.5, 2.5, 4.0};
/// Two valleys that leave the same within this share of the tolerance leave alike.
constexpr double alike_share = 0.25;
/// The place where the cutter leaves least is looked for in steps down to this, in radii.
constexpr double last_step = 0.02;

/// The facets that meet in each point.
class FacetsOfPoints {
public:
    explicit FacetsOfPoints(const RestFacets& rest) : first_(rest.points.size() + 1, 0) {
        for (const RestFacet& f : rest.facets)
            for (const Index c : f.corner)
                ++first_[c + 1];
        for (std::size_t c = 0; c < rest.points.size(); ++c) {
            if (first_[c + 1] > 0) used_.push_back(Index(c));
            first_[c + 1] += first_[c];
        }
        facets_.resize(first_.back());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (const RestFacet& f : rest.facets)
            for (const Index c : f.corner)
                facets_[next[c]++] = f.facet;
    }

    /// Points of any facet.
    const std::vector<Index>& used() const { return used_; }
    std::span<const Index> of(Index point) const {
        return {facets_.data() + first_[point], facets_.data() + first_[point + 1]};
    }

private:
    std::vector<std::uint32_t> first_;
    std::vector<Index> facets_, used_;
};

class GapMeasuring {
public:
    GapMeasuring(const ValleyInput& input, const Valleys& valleys, const RestFacets& rest)
        : in_(input), valleys_(valleys), rest_(rest), radius_(input.cover->radius()), tips_(radius_) {}

    RestGaps run(const Progress& progress) {
        const FacetsOfPoints around(rest_);
        progress.check();
        for (const Valleys::Tip& t : valleys_.tips)
            tips_.add(Vec3(t.tip.x(), t.tip.y(), 0));
        RestGaps result{std::vector<double>(rest_.points.size(), 0),
                        std::vector<int>(rest_.points.size(), -1)};
        const auto& used = around.used();
        parallel_blocks(used.size(), 64, progress, [&](std::size_t begin, std::size_t end) {
            LiftHint hint;
            for (std::size_t s = begin; s < end; ++s)
                measure(used[s], around.of(used[s]), result, hint);
        });
        return result;
    }

private:
    /// What the tips of one curve leave, of those that come near.
    struct ByCurve {
        int curve;
        double left;
    };

    void measure(Index v, std::span<const Index> facets, RestGaps& result, LiftHint& hint) const {
        const Vec3& p = rest_.points[v];
        RestSample nearest = nearest_by_normals(p, facets, hint);
        if (nearest.gap > in_.tolerance) {
            std::vector<ByCurve> by_curve;
            const double least = min_by_tips(p, by_curve);
            result.curve[v] = curve_of(p, by_curve, least);
            // In a valley's band the valley's own tips come nearest; a place for which they do not may have
            // a normal that says nothing, of a needle on a noisy plane.
            nearest.gap = nearest.gap < least
                              ? nearest_about(in_, nearest, in_.tolerance, last_step * radius_, hint).gap
                              : least;
        }
        result.gap[v] = nearest.gap;
    }

    RestSample nearest_by_normals(const Vec3& p, std::span<const Index> facets, LiftHint& hint) const {
        RestSample nearest;
        nearest.gap = infinity;
        Vec3 last = Vec3::Zero();
        for (const Index f : facets) {
            if (!(nearest.gap > in_.tolerance)) break;
            const Vec3 n = in_.side->towards_tool(in_.mesh->facet_normal(f));
            if (n.dot(last) > same_gap_normal) continue;
            last = n;
            const RestSample by = nearest_touch(in_, p, n, hint);
            if (by.gap < nearest.gap) nearest = by;
        }
        return nearest;
    }

    double min_by_tips(const Vec3& p, std::vector<ByCurve>& by_curve) const {
        double least = infinity;
        // A cutter is nearer than the distance of its axis less the radius nowhere.
        for (const double share : asked_radii) {
            const double within = share * radius_;
            by_curve.clear();
            tips_.near(Vec3(p.x(), p.y(), 0), within, [&](std::size_t t) {
                const Valleys::Tip& tip = valleys_.tips[t];
                const Vec3 rel = p - tip.tip;
                const double most = least + alike_share * in_.tolerance + radius_;
                if (rel.head<2>().squaredNorm() > most * most) return;
                const double d = in_.cover->distance(rel);
                least = std::min(least, d);
                for (ByCurve& by : by_curve)
                    if (by.curve == tip.curve) {
                        by.left = std::min(by.left, d);
                        return;
                    }
                by_curve.push_back({tip.curve, d});
            });
            if (least + radius_ <= within) break;
        }
        return least;
    }

    /// The curve that a place of a band belongs to. Where two leave alike, as about the corner in which
    /// they meet, it is the one with the nearer centre; -1 where none comes near.
    int curve_of(const Vec3& p, const std::vector<ByCurve>& left, double least) const {
        const auto is_alike = [&](const ByCurve& by) {
            return by.left <= least + alike_share * in_.tolerance;
        };
        // Mostly there is one, and nothing to compare.
        if (std::count_if(left.begin(), left.end(), is_alike) == 1)
            return std::find_if(left.begin(), left.end(), is_alike)->curve;
        int owner = -1;
        double nearest = infinity;
        for (const ByCurve& by : left) {
            if (!is_alike(by)) continue;
            const int c = by.curve;
            const double away = c >= 0 ? square_from_centers(p, valleys_.curves[std::size_t(c)]) : infinity;
            if (away > nearest || (away == nearest && owner >= 0 && (c < 0 || owner < c))) continue;
            owner = c;
            nearest = away;
        }
        return owner;
    }

    const ValleyInput& in_;
    const Valleys& valleys_;
    const RestFacets& rest_;
    double radius_;
    PointGrid tips_; ///< seen from above
};

} // namespace

RestGaps measure_gaps(const ValleyInput& input, const Valleys& valleys, const RestFacets& rest,
                      const Progress& progress) {
    return GapMeasuring(input, valleys, rest).run(progress);
}

double square_from_centers(const Vec3& p, const ValleyCurve& curve) {
    double least = infinity;
    for (const PencilPoint& q : curve.points)
        least = std::min(least, (q.center - p).squaredNorm());
    return least;
}

} // namespace facetmill
