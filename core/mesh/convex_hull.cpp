#include "core/mesh/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace facetmill {

namespace {

/// Share of the points' box, and of their distance from the origin, that points may stand out of a facet and
/// still count as on it: rounding. More would tilt small facets, and leave points far outside of them.
constexpr double on_face_share = 1e-11, on_face_rounding = 1e-14;
/// Share of the box below which points spread in a direction no more.
constexpr double flat_share = 1e-7;
/// And by which corners are apart at least.
constexpr double apart_share = 1e-8;
/// Sine of the angle by which an outline must turn at a corner.
constexpr double straight_sine = 1e-9;

struct HullFacet {
    Facet corners{};
    std::array<Index, 3> across{}; ///< the facet on the side from corner k to the next
    Vec3 normal = Vec3::Zero();
    double offset = 0;
    std::vector<Index> outside; ///< points that no other facet has, the farthest one last
    bool gone = false;

    double height(const Vec3& p) const { return normal.dot(p) - offset; }
};

/// An edge between what a point sees of the hull and what it does not.
struct HorizonEdge {
    Index from, to, beyond; ///< `beyond`: the facet that stays
};

class Quickhull {
public:
    Quickhull(const std::vector<Vec3>& points, double slack)
        : points_(points), slack_(slack), at_start_(points.size(), no_index), at_end_(at_start_) {}

    std::vector<Facet> run(const std::array<Index, 4>& first, const Progress& progress) {
        begin(first);
        std::size_t taken = 0;
        while (!open_.empty()) {
            progress.check();
            if (++taken % 1024 == 0) progress.set(1 - 1.0 / (1 + 1e-4 * double(taken)));
            const Index f = open_.back();
            if (facets_[f].gone || facets_[f].outside.empty()) {
                open_.pop_back();
                continue;
            }
            const Index p = facets_[f].outside.back();
            find_horizon(f, p);
            // Rounding can tear the edge of what is seen: such a point is as good as on the hull.
            if (!is_ring(p))
                drop_last(f);
            else
                raise(p);
        }
        std::vector<Facet> all;
        for (const HullFacet& f : facets_)
            if (!f.gone) all.push_back(f.corners);
        progress.set(1);
        return all;
    }

private:
    Index add(const Facet& corners) {
        HullFacet f;
        f.corners = corners;
        const Vec3 &a = points_[corners[0]], &b = points_[corners[1]], &c = points_[corners[2]];
        f.normal = (b - a).cross(c - a).normalized();
        f.offset = std::max({f.normal.dot(a), f.normal.dot(b), f.normal.dot(c)});
        facets_.push_back(std::move(f));
        return Index(facets_.size() - 1);
    }

    void begin(const std::array<Index, 4>& t) {
        const bool outward = (points_[t[1]] - points_[t[0]])
                                 .cross(points_[t[2]] - points_[t[0]])
                                 .dot(points_[t[3]] - points_[t[0]])
                             < 0;
        const Index a = t[0], b = outward ? t[1] : t[2], c = outward ? t[2] : t[1], d = t[3];
        add({a, b, c});
        add({a, d, b});
        add({b, d, c});
        add({c, d, a});
        facets_[0].across = {1, 2, 3};
        facets_[1].across = {3, 2, 0};
        facets_[2].across = {1, 3, 0};
        facets_[3].across = {2, 1, 0};
        std::vector<Index> all(points_.size());
        std::iota(all.begin(), all.end(), Index(0));
        hand_out(all, 0);
    }

    /// Every point goes to the facet from `first` on that it is farthest outside of, or is inside.
    void hand_out(const std::vector<Index>& points, std::size_t first) {
        for (const Index p : points) {
            double best = slack_;
            std::size_t to = facets_.size();
            for (std::size_t f = first; f < facets_.size(); ++f)
                if (const double h = facets_[f].height(points_[p]); h > best) {
                    best = h;
                    to = f;
                }
            if (to < facets_.size()) facets_[to].outside.push_back(p);
        }
        for (std::size_t f = first; f < facets_.size(); ++f)
            if (!facets_[f].outside.empty()) {
                farthest_last(facets_[f]);
                open_.push_back(Index(f));
            }
    }

    void farthest_last(HullFacet& f) const {
        std::size_t far = 0;
        for (std::size_t i = 1; i < f.outside.size(); ++i)
            if (f.height(points_[f.outside[i]]) > f.height(points_[f.outside[far]])) far = i;
        std::swap(f.outside[far], f.outside.back());
    }

    void drop_last(Index f) {
        facets_[f].outside.pop_back();
        if (!facets_[f].outside.empty()) farthest_last(facets_[f]);
    }

    void find_horizon(Index from, Index p) {
        seen_.assign(1, from);
        horizon_.clear();
        facets_[from].gone = true;
        for (std::size_t i = 0; i < seen_.size(); ++i) {
            const HullFacet& f = facets_[seen_[i]];
            for (std::size_t k = 0; k < 3; ++k) {
                HullFacet& next = facets_[f.across[k]];
                if (next.gone) continue;
                if (next.height(points_[p]) > slack_) {
                    next.gone = true;
                    seen_.push_back(f.across[k]);
                }
            }
        }
        for (const Index s : seen_)
            for (std::size_t k = 0; k < 3; ++k)
                if (const HullFacet& f = facets_[s]; !facets_[f.across[k]].gone)
                    horizon_.push_back({f.corners[k], f.corners[(k + 1) % 3], f.across[k]});
    }

    /// The horizon is one closed ring, and the point makes a facet with each of its edges. What was seen is
    /// there again where not.
    bool is_ring(Index p) {
        bool good = horizon_.size() >= 3;
        for (const HorizonEdge& e : horizon_) {
            const Vec3 &a = points_[e.from], &b = points_[e.to];
            good = good && at_start_[e.from] == no_index && (b - a).cross(points_[p] - a).norm() > 0;
            at_start_[e.from] = Index(&e - horizon_.data());
        }
        std::size_t steps = 0;
        if (good) {
            Index at = 0;
            do {
                at = at_start_[horizon_[at].to];
                ++steps;
            } while (at != no_index && at != 0 && steps <= horizon_.size());
            good = at == 0 && steps == horizon_.size();
        }
        if (good) return true;
        for (const HorizonEdge& e : horizon_)
            at_start_[e.from] = no_index;
        for (const Index s : seen_)
            facets_[s].gone = false;
        return false;
    }

    void raise(Index p) {
        const std::size_t first = facets_.size();
        for (const HorizonEdge& e : horizon_) {
            const Index f = add({e.from, e.to, p});
            facets_[f].across[0] = e.beyond;
            HullFacet& beyond = facets_[e.beyond];
            for (std::size_t k = 0; k < 3; ++k)
                if (beyond.corners[k] == e.to && beyond.corners[(k + 1) % 3] == e.from) beyond.across[k] = f;
            at_start_[e.from] = at_end_[e.to] = f;
        }
        for (std::size_t f = first; f < facets_.size(); ++f) {
            facets_[f].across[1] = at_start_[facets_[f].corners[1]];
            facets_[f].across[2] = at_end_[facets_[f].corners[0]];
        }
        for (const HorizonEdge& e : horizon_)
            at_start_[e.from] = at_end_[e.to] = no_index;
        std::vector<Index> left;
        for (const Index s : seen_) {
            for (const Index q : facets_[s].outside)
                if (q != p) left.push_back(q);
            facets_[s].outside = {};
        }
        hand_out(left, first);
    }

    const std::vector<Vec3>& points_;
    const double slack_;
    std::vector<HullFacet> facets_;
    std::vector<Index> open_, seen_;
    std::vector<HorizonEdge> horizon_;
    std::vector<Index> at_start_, at_end_; ///< of a vertex on the horizon: its edge, then its new facet
};

/// The point that `measure` is largest for.
template <class Measure>
Index farthest(const std::vector<Vec3>& points, Measure&& measure) {
    Index best = 0;
    double most = measure(points[0]);
    for (std::size_t i = 1; i < points.size(); ++i)
        if (const double here = measure(points[i]); here > most) {
            most = here;
            best = Index(i);
        }
    return best;
}

} // namespace

namespace {

/// One of all points that lie nearer together than `apart`, by number: facets between such points would be
/// rounding.
std::vector<Index> thinned(const std::vector<Vec3>& points, const Vec3& origin, double apart) {
    using Cell = std::array<std::int64_t, 3>;
    struct Hash {
        std::size_t operator()(const Cell& c) const {
            return std::size_t(c[0]) * 73856093u ^ std::size_t(c[1]) * 19349663u
                   ^ std::size_t(c[2]) * 83492791u;
        }
    };
    std::unordered_multimap<Cell, Index, Hash> by_cell;
    by_cell.reserve(points.size());
    std::vector<Index> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 at = (points[i] - origin) / (2 * apart);
        Cell own{}, beside{};
        for (int k = 0; k < 3; ++k) {
            const double floor = std::floor(at[k]);
            own[std::size_t(k)] = std::int64_t(floor);
            beside[std::size_t(k)] = own[std::size_t(k)] + (at[k] - floor < 0.5 ? -1 : 1);
        }
        bool near = false;
        for (unsigned corner = 0; corner < 8 && !near; ++corner) {
            Cell cell = own;
            for (std::size_t k = 0; k < 3; ++k)
                if (corner >> k & 1) cell[k] = beside[k];
            for (auto [c, end] = by_cell.equal_range(cell); c != end && !near; ++c)
                near = (points[c->second] - points[i]).norm() < apart;
        }
        if (near) continue;
        by_cell.emplace(own, Index(i));
        kept.push_back(Index(i));
    }
    return kept;
}

} // namespace

std::vector<Index> convex_outline(const std::vector<Vec2>& points) {
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto less = [&](Index a, Index b) {
        const Vec2 &p = points[a], &q = points[b];
        return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
    };
    std::sort(order.begin(), order.end(), less);
    order.erase(
        std::unique(order.begin(), order.end(), [&](Index a, Index b) { return points[a] == points[b]; }),
        order.end());
    if (order.size() < 3) return order;
    const auto bends_left = [&](Index a, Index b, Index c) {
        const Vec2 u = points[b] - points[a], v = points[c] - points[a];
        return u.x() * v.y() - u.y() * v.x() > straight_sine * u.norm() * v.norm();
    };
    // Andrew's chains: the lower side, then back along the upper one.
    std::vector<Index> ring;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = ring.size();
        for (const Index p : order) {
            while (ring.size() >= first + 2 && !bends_left(ring[ring.size() - 2], ring.back(), p))
                ring.pop_back();
            ring.push_back(p);
        }
        ring.pop_back(); // begins the other side
        std::reverse(order.begin(), order.end());
    }
    return ring;
}

ConvexHull convex_hull(const std::vector<Vec3>& points, const Progress& progress) {
    ConvexHull hull;
    if (points.empty()) return hull;
    Box3 box;
    for (const Vec3& p : points)
        box.add(p);
    const double far = std::max(box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff());
    const double slack = on_face_share * box.diagonal() + on_face_rounding * far,
                 flat = flat_share * box.diagonal() + on_face_rounding * far;
    int longest = 0;
    box.size().maxCoeff(&longest);
    if (box.diagonal() <= on_face_rounding * far) return hull;
    std::array<Index, 4> t{};
    t[0] = farthest(points, [&](const Vec3& p) { return -p[longest]; });
    t[1] = farthest(points, [&](const Vec3& p) { return (p - points[t[0]]).squaredNorm(); });
    const Vec3 origin = points[t[0]], along = (points[t[1]] - origin).normalized();
    const auto beside = [&](const Vec3& p) { return (p - origin).cross(along).norm(); };
    t[2] = farthest(points, beside);
    hull.dimension = 1;
    if (beside(points[t[2]]) <= flat) return hull;
    const Vec3 normal = along.cross(points[t[2]] - origin).normalized();
    const auto above = [&](const Vec3& p) { return std::abs((p - origin).dot(normal)); };
    t[3] = farthest(points, above);
    hull.dimension = 2;
    if (above(points[t[3]]) <= flat) {
        hull.normal = normal;
        const Vec3 side = normal.cross(along);
        std::vector<Vec2> level;
        level.reserve(points.size());
        for (const Vec3& p : points)
            level.emplace_back((p - origin).dot(along), (p - origin).dot(side));
        hull.outline = convex_outline(level);
        return hull;
    }
    hull.dimension = 3;
    // The first four corners stay whatever is near them.
    std::vector<Vec3> ends;
    ends.reserve(t.size() + points.size());
    for (const Index v : t)
        ends.push_back(points[v]);
    ends.insert(ends.end(), points.begin(), points.end());
    const std::vector<Index> kept = thinned(ends, box.lo, apart_share * box.diagonal());
    std::vector<Vec3> corners;
    corners.reserve(kept.size());
    for (const Index v : kept)
        corners.push_back(ends[v]);
    hull.facets = Quickhull(corners, slack).run({0, 1, 2, 3}, progress);
    for (Facet& f : hull.facets)
        for (Index& v : f)
            v = v < 4 ? t[v] : Index(kept[v] - 4);
    return hull;
}

} // namespace facetmill
