// Holes are joined to the area around them by a bridge to a corner that sees them, and then ears are cut, the
// best shaped first (Eberly, "Triangulation by ear clipping").
#include "core/repair/plane_polygon.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace facetmill::detail {

namespace {

using Ring = std::vector<Index>;

double turn_of(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool is_inside(const std::vector<Vec2>& points, const Ring& ring, const Vec2& p) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Vec2 &a = points[ring[i]], &b = points[ring[j]];
        if ((a.y() > p.y()) != (b.y() > p.y())
            && p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

/// The corner of the ring that the point, which lies in it, sees: where a ray along +X meets the ring, or the
/// corner next to the ray that hides that.
std::optional<std::size_t> seen_corner(const std::vector<Vec2>& points, const Ring& ring, const Vec2& m) {
    double nearest = infinity;
    std::optional<std::size_t> corner;
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 &a = points[ring[i]], &b = points[ring[(i + 1) % n]];
        if (std::min(a.y(), b.y()) > m.y() || std::max(a.y(), b.y()) < m.y()) continue;
        const double t = a.y() == b.y() ? (a.x() < b.x() ? 0.0 : 1.0) : (m.y() - a.y()) / (b.y() - a.y());
        const double x = a.x() + t * (b.x() - a.x());
        if (x < m.x() || x >= nearest) continue;
        nearest = x;
        corner = a.x() > b.x() ? i : (i + 1) % n;
    }
    if (!corner) return std::nullopt;
    const Vec2 met(nearest, m.y()), p = points[ring[*corner]];
    double best = infinity;
    std::size_t result = *corner;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2& q = points[ring[i]];
        if (q == p || q.x() < m.x()) continue;
        if (turn_of(points[ring[(i + n - 1) % n]], q, points[ring[(i + 1) % n]]) > 0)
            continue; // sees past it
        const double s = turn_of(m, met, p) >= 0 ? 1 : -1;
        if (s * turn_of(m, met, q) < 0 || s * turn_of(met, p, q) < 0 || s * turn_of(p, m, q) < 0) continue;
        const Vec2 d = q - m;
        const double slope = std::abs(d.y()) / std::max(d.x(), 1e-300);
        if (slope < best) {
            best = slope;
            result = i;
        }
    }
    return result;
}

/// One ring through all: the holes hang in it by bridges that it runs along twice.
bool join_holes(const std::vector<Vec2>& points, Ring& outer, std::vector<Ring> holes) {
    const auto rightmost = [&](const Ring& ring) {
        return std::size_t(std::max_element(ring.begin(), ring.end(),
                                            [&](Index a, Index b) {
                                                return points[a].x() < points[b].x()
                                                       || (points[a].x() == points[b].x() && a < b);
                                            })
                           - ring.begin());
    };
    std::stable_sort(holes.begin(), holes.end(), [&](const Ring& a, const Ring& b) {
        return points[a[rightmost(a)]].x() > points[b[rightmost(b)]].x();
    });
    for (const Ring& hole : holes) {
        const std::size_t from = rightmost(hole);
        const auto to = seen_corner(points, outer, points[hole[from]]);
        if (!to) return false;
        Ring joined(outer.begin(), outer.begin() + std::ptrdiff_t(*to) + 1);
        for (std::size_t i = 0; i <= hole.size(); ++i)
            joined.push_back(hole[(from + i) % hole.size()]);
        joined.insert(joined.end(), outer.begin() + std::ptrdiff_t(*to), outer.end());
        outer = std::move(joined);
    }
    return true;
}

class Ears {
public:
    Ears(const std::vector<Vec2>& points, const Ring& ring, std::vector<Facet>& facets)
        : points_(points), ring_(ring), facets_(facets), next_(ring.size()), previous_(ring.size()),
          stamp_(ring.size(), 0) {
        const std::size_t n = ring.size();
        for (std::size_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            previous_[i] = (i + n - 1) % n;
        }
    }

    bool cut(const Progress& progress) {
        std::size_t left = ring_.size(), at = 0;
        bool flat = false; // ears without area are cut where there are no others
        while (left > 3) {
            collect(at, left, flat);
            bool any = false;
            while (left > 3 && !queue_.empty()) {
                const Ear ear = queue_.top();
                queue_.pop();
                if (stamp_[ear.place] != ear.stamp || !is_clear(ear.place)) continue;
                if (left % 64 == 0) progress.check();
                const std::size_t p = previous_[ear.place], n = next_[ear.place];
                facets_.push_back({ring_[p], ring_[ear.place], ring_[n]});
                next_[p] = n;
                previous_[n] = p;
                stamp_[ear.place] = dead;
                at = n;
                --left;
                any = true;
                offer(p, false);
                offer(n, false);
                if (flat) break;
            }
            if (!any && flat) return false;
            flat = !any;
        }
        facets_.push_back({ring_[previous_[at]], ring_[at], ring_[next_[at]]});
        return true;
    }

private:
    static constexpr std::uint32_t dead = 0xFFFFFFFFu;
    struct Ear {
        double shape; ///< its height as a share of its longest side
        std::size_t place;
        std::uint32_t stamp;
        bool operator<(const Ear& other) const {
            return shape < other.shape || (shape == other.shape && place > other.place);
        }
    };

    const Vec2& at(std::size_t i) const { return points_[ring_[i]]; }

    void collect(std::size_t first, std::size_t left, bool flat) {
        queue_ = {};
        std::size_t i = first;
        for (std::size_t k = 0; k < left; ++k, i = next_[i])
            offer(i, flat);
    }
    void offer(std::size_t i, bool flat) {
        const Vec2 &a = at(previous_[i]), &b = at(i), &c = at(next_[i]);
        const double area = turn_of(a, b, c);
        const double longest =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        ++stamp_[i];
        if (area > thin * longest || (flat && area >= -thin * longest))
            queue_.push({longest > 0 ? area / longest : 0, i, stamp_[i]});
    }
    /// No other corner lies in the ear.
    bool is_clear(std::size_t i) const {
        const std::size_t p = previous_[i], n = next_[i];
        const Vec2 &a = at(p), &b = at(i), &c = at(n);
        const Vec2 lo = a.cwiseMin(b).cwiseMin(c), hi = a.cwiseMax(b).cwiseMax(c);
        for (std::size_t k = next_[n]; k != p; k = next_[k]) {
            const Vec2& q = at(k);
            if (q.x() < lo.x() || q.x() > hi.x() || q.y() < lo.y() || q.y() > hi.y()) continue;
            if (q == a || q == b || q == c) continue;
            if (turn_of(a, b, q) >= 0 && turn_of(b, c, q) >= 0 && turn_of(c, a, q) >= 0) return false;
        }
        return true;
    }

    static constexpr double thin = 1e-9;
    const std::vector<Vec2>& points_;
    const Ring& ring_;
    std::vector<Facet>& facets_;
    std::vector<std::size_t> next_, previous_;
    std::vector<std::uint32_t> stamp_;
    std::priority_queue<Ear> queue_;
};

} // namespace

double ring_area(const std::vector<Vec2>& points, const Ring& ring) {
    double twice = 0;
    const Vec2& base = points[ring[0]];
    for (std::size_t i = 0; i < ring.size(); ++i)
        twice += turn_of(base, points[ring[i]], points[ring[(i + 1) % ring.size()]]);
    return 0.5 * twice;
}

std::optional<std::vector<Facet>>
triangulate_rings(const std::vector<Vec2>& points, const std::vector<Ring>& rings, const Progress& progress) {
    struct Area {
        Ring ring;
        double area;
        std::vector<Ring> holes;
    };
    std::vector<Area> areas;
    std::vector<const Ring*> holes;
    for (const Ring& ring : rings) {
        const double area = ring_area(points, ring);
        if (area > 0)
            areas.push_back({ring, area, {}});
        else
            holes.push_back(&ring);
    }
    for (const Ring* hole : holes) {
        Area* around = nullptr;
        for (Area& area : areas)
            if (is_inside(points, area.ring, points[hole->front()]) && (!around || area.area < around->area))
                around = &area;
        if (!around) return std::nullopt;
        around->holes.push_back(*hole);
    }
    std::vector<Facet> facets;
    for (Area& area : areas) {
        progress.check();
        if (!join_holes(points, area.ring, area.holes)) return std::nullopt;
        if (!Ears(points, area.ring, facets).cut(progress)) return std::nullopt;
    }
    return facets;
}

} // namespace facetmill::detail
