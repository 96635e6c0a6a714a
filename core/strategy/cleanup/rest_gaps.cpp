#include "core/strategy/cleanup/rest_gaps.h"

#include "core/base/parallel.h"
#include "core/strategy/cleanup/cut_tree.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/cleanup/rest_band.h"
#include "core/strategy/cleanup/standing.h"

#include <algorithm>

namespace facetmill {

namespace {

/// Normals nearer to each other than this (cosine) ask the same.
constexpr double same_gap_normal = 0.9999;
/// Tips are asked that leave no more than so many radii.
constexpr double farthest_left = 3;
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
    GapMeasuring(const ValleyInput& input, const Valleys& valleys, const RestFacets& rest,
                 const Progress& progress)
        : in_(input), valleys_(valleys), rest_(rest), radius_(input.cover->radius()),
          places_(places(valleys)), tips_(*input.cover, places_, 0, progress) {}

    RestGaps run(const Progress& progress) {
        const FacetsOfPoints around(rest_);
        progress.check();
        RestGaps result{std::vector<double>(rest_.points.size(), 0),
                        std::vector<int>(rest_.points.size(), -1)};
        const auto& used = around.used();
        parallel_blocks(used.size(), 256, progress, [&](std::size_t begin, std::size_t end) {
            std::vector<RestSample> first(end - begin);
            for (std::size_t s = begin; s < end; ++s) {
                first[s - begin].point = rest_.points[used[s]];
                first[s - begin].normal = normal_of(around.of(used[s]).front());
            }
            nearest_touches(in_, first, progress.part(0, 0));
            Near near;
            for (std::size_t s = begin; s < end; ++s)
                measure(used[s], around.of(used[s]), first[s - begin], result, near);
        });
        return result;
    }

private:
    /// What the tips of one curve leave, of those that come near.
    struct ByCurve {
        int curve;
        double left;
    };

    /// What helps to find it for the next point.
    struct Near {
        LiftHint lift;
        Standing::Hint cut;
    };

    Vec3 normal_of(Index facet) const { return in_.side->towards_tool(in_.mesh->facet_normal(facet)); }

    /// Given the cutter that touches at the first facet.
    void measure(Index v, std::span<const Index> facets, const RestSample& first, RestGaps& result,
                 Near& near) const {
        const Vec3& p = rest_.points[v];
        RestSample nearest = nearest_by_normals(first, facets.subspan(1), near.lift);
        if (nearest.gap > in_.tolerance) {
            std::vector<ByCurve> by_curve;
            const double least = min_by_tips(p, by_curve);
            result.curve[v] = curve_of(p, by_curve, least);
            // In a valley's band the valley's own tips come nearest; a place for which they do not may have
            // a normal that says nothing, of a needle on a noisy plane.
            double left = std::min(nearest.gap, least);
            if (in_.standing)
                left = in_.standing->uncut(p, std::min(left, raw_over(p, facets)),
                                           asked_tolerances * in_.tolerance, near.cut);
            if (left > in_.tolerance && nearest.gap < least)
                left = std::min(
                    left, nearest_about(in_, nearest, in_.tolerance, last_step * radius_, near.lift).gap);
            nearest.gap = left;
        }
        result.gap[v] = nearest.gap;
    }

    /// The raw material over the facet of those about a point on which most of it stands.
    double raw_over(const Vec3& p, std::span<const Index> facets) const {
        double most = 0;
        for (const Index f : facets)
            most = std::max(most, in_.standing->raw_over(p, normal_of(f)));
        return most;
    }

    RestSample nearest_by_normals(const RestSample& first, std::span<const Index> further,
                                  LiftHint& hint) const {
        RestSample nearest = first;
        Vec3 last = first.normal;
        for (const Index f : further) {
            if (!(nearest.gap > in_.tolerance)) break;
            const Vec3 n = normal_of(f);
            if (n.dot(last) > same_gap_normal) continue;
            last = n;
            const RestSample by = nearest_touch(in_, first.point, n, hint);
            if (by.gap < nearest.gap) nearest = by;
        }
        return nearest;
    }

    static std::vector<CutTree::Motion> places(const Valleys& valleys) {
        std::vector<CutTree::Motion> all;
        for (const Valleys::Tip& t : valleys.tips)
            all.push_back({t.tip, t.tip});
        return all;
    }

    /// The least that any tip leaves; what those leave that leave alike, and perhaps others, by their curves.
    double min_by_tips(const Vec3& p, std::vector<ByCurve>& by_curve) const {
        double least = infinity;
        tips_.nearer(p, farthest_left * radius_, [&](std::size_t t, double d) {
            least = std::min(least, d);
            const int curve = valleys_.tips[t].curve;
            const auto by = std::find_if(by_curve.begin(), by_curve.end(),
                                         [&](const ByCurve& b) { return b.curve == curve; });
            if (by == by_curve.end())
                by_curve.push_back({curve, d});
            else
                by->left = std::min(by->left, d);
            return least + alike_share * in_.tolerance;
        });
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
    std::vector<CutTree::Motion> places_; ///< of the valleys' tips
    CutTree tips_;
};

} // namespace

RestGaps measure_gaps(const ValleyInput& input, const Valleys& valleys, const RestFacets& rest,
                      const Progress& progress) {
    return GapMeasuring(input, valleys, rest, progress).run(progress);
}

double square_from_centers(const Vec3& p, const ValleyCurve& curve) {
    double least = infinity;
    for (const PencilPoint& q : curve.points)
        least = std::min(least, (q.center - p).squaredNorm());
    return least;
}

} // namespace facetmill
