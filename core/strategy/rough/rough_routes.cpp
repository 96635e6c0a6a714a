#include "core/strategy/rough/rough_routes.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

/// A place on a polyline.
struct OnRoute {
    std::size_t segment = 0;
    Vec2 point = Vec2::Zero();
    double arc = 0, distance = infinity;
};

OnRoute nearest_on(const std::vector<Vec2>& route, const Vec2& p) {
    OnRoute best;
    double arc = 0;
    for (std::size_t i = 1; i < route.size(); ++i) {
        const Vec2 d = route[i] - route[i - 1];
        const double length = d.norm();
        const double t = length > 0 ? std::clamp((p - route[i - 1]).dot(d) / (length * length), 0.0, 1.0) : 0;
        const Vec2 q = route[i - 1] + t * d;
        if (const double distance = (p - q).norm(); distance < best.distance)
            best = {i - 1, q, arc + t * length, distance};
        arc += length;
    }
    return best;
}

/// Points of the polyline between two places, without them, in the order from a to b.
void between(const std::vector<Vec2>& route, const OnRoute& a, const OnRoute& b, bool closed, bool forward,
             std::vector<Vec2>& out) {
    const std::size_t n = route.size() - 1; // segments
    if (forward) {
        const bool wraps = closed && a.arc > b.arc;
        for (std::size_t i = a.segment + 1; i < (wraps ? n : b.segment + 1); ++i)
            out.push_back(route[i]);
        if (wraps)
            for (std::size_t i = 0; i <= b.segment; ++i)
                out.push_back(route[i]);
    } else {
        const bool wraps = closed && a.arc < b.arc;
        for (std::size_t i = a.segment + 1; i-- > (wraps ? 0 : b.segment + 1);)
            out.push_back(route[i]);
        if (wraps)
            for (std::size_t i = n; i-- > b.segment + 1;)
                out.push_back(route[i]);
    }
}

/// Lengths along a contour, in radii of the cutter: of the steps that have work or none; of gaps between them
/// that are shorter than what leaving and coming back takes, and are run through; and how far before its work
/// the tool begins, to come in where nothing stands.
constexpr double step_radii = 0.5, gap_radii = 2.2, entry_radii = 1.1;
/// Steps of a contour that a thread looks at at a time.
constexpr std::size_t block_steps = 32;

/// The points of a contour, and more between them, no more than `step` apart.
std::vector<Vec2> in_steps(const FreeContour& contour, double step) {
    std::vector<Vec2> points{contour.points.front()};
    for (std::size_t i = 1; i < contour.points.size(); ++i) {
        const Vec2 a = points.back(), b = contour.points[i];
        const double n = std::max(1.0, std::ceil((b - a).norm() / step));
        for (double k = 1; k <= n; ++k)
            points.push_back(k == n ? b : Vec2(a + (k / n) * (b - a)));
    }
    return points;
}

/// Adds to `cut` the steps between busy ones that are no longer than `gap` together.
void close_gaps(const std::vector<Vec2>& points, bool closed, const std::vector<char>& busy, double gap,
                std::vector<char>& cut) {
    const std::size_t n = busy.size();
    const auto after = [&](std::size_t i) { return closed ? (i + 1) % n : i + 1; };
    for (std::size_t i = 0; i < n; ++i) {
        if (!busy[i]) continue;
        std::size_t k = after(i);
        double arc = 0;
        for (std::size_t steps = 1; steps < n && k < n && !busy[k] && arc <= gap; ++steps, k = after(k))
            arc += (points[k + 1] - points[k]).norm();
        if (k >= n || !busy[k] || arc > gap) continue;
        for (std::size_t j = after(i); j != k; j = after(j))
            cut[j] = 1;
    }
}

/// Adds the stretches of steps that are to be cut; one step at least is not.
void add_stretches(const std::vector<Vec2>& points, bool closed, const std::vector<char>& cut, double radius,
                   std::vector<RoughRoute>& routes) {
    const std::size_t n = cut.size();
    std::size_t start = 0;
    if (closed)
        while (cut[start])
            ++start;
    for (std::size_t k = 0; k < n;) {
        if (!cut[(start + k) % n]) {
            ++k;
            continue;
        }
        RoughRoute route;
        route.reversible = false;
        route.points.push_back(points[(start + k) % n]);
        for (; k < n && cut[(start + k) % n]; ++k)
            route.points.push_back(points[(start + k) % n + 1]);
        route.points = thinned_route(route.points, tolerance::route_rounding * radius);
        routes.push_back(std::move(route));
    }
}

/// A closed route from another of its places on.
std::vector<Vec2> begun_at(const std::vector<Vec2>& points, const OnRoute& begin) {
    std::vector<Vec2> turned{begin.point};
    turned.insert(turned.end(), points.begin() + std::ptrdiff_t(begin.segment) + 1, points.end());
    turned.insert(turned.end(), points.begin() + 1, points.begin() + std::ptrdiff_t(begin.segment) + 1);
    turned.push_back(begin.point);
    return turned;
}

/// Routes along contours, always that next which begins nearest to where the tool is; a closed one may begin
/// anywhere.
std::vector<RoughRoute> nearest_first(std::vector<RoughRoute> all, Vec2& at) {
    std::vector<RoughRoute> ordered;
    while (!all.empty()) {
        std::size_t best = 0;
        double nearest = infinity;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double d =
                all[i].closed ? nearest_on(all[i].points, at).distance : (all[i].points.front() - at).norm();
            if (d < nearest) {
                nearest = d;
                best = i;
            }
        }
        RoughRoute route = std::move(all[best]);
        all.erase(all.begin() + std::ptrdiff_t(best));
        if (route.closed) route.points = begun_at(route.points, nearest_on(route.points, at));
        route.before = route.points.front();
        route.after = route.points.back();
        at = route.points.back();
        ordered.push_back(std::move(route));
    }
    return ordered;
}

} // namespace

void LayerRoutes::add_pieces(int line, double v, std::span<const Interval> free, double z, double merge,
                             bool but_ends, std::vector<LinePiece>& pieces) const {
    for (const Interval& range : free) {
        const Vec3 a = frame_.point(range.lo, v, z), b = frame_.point(range.hi, v, z);
        const std::size_t first = pieces.size();
        for (const Interval& share : field_.work(cutter_, a, b, min_)) {
            const double slack = field_.cell();
            const Interval cut{std::max(range.lo, range.lo + share.lo * range.length() - slack),
                               std::min(range.hi, range.lo + share.hi * range.length() + slack)};
            if (pieces.size() > first && cut.lo - pieces.back().cut.hi <= merge)
                pieces.back().cut.hi = cut.hi;
            else
                pieces.push_back({line, v, cut, range});
        }
        if (!but_ends) continue;
        const auto at_end = [&](const LinePiece& p) {
            return p.cut.length() < cutter_.radius() && (p.cut.lo <= range.lo || p.cut.hi >= range.hi);
        };
        pieces.erase(std::remove_if(pieces.begin() + std::ptrdiff_t(first), pieces.end(), at_end),
                     pieces.end());
    }
}

bool LayerRoutes::connect(const Vec2& from, const Vec2& to, std::span<const FreeContour> contours, double z,
                          double longest, std::vector<Vec2>& route) const {
    RoughReach::Hints hints;
    if ((to - from).norm() <= longest && reach_.is_free(from, to, z, hints)) return true;
    const double near = 4 * reach_.spacing();
    for (const FreeContour& c : contours) {
        const OnRoute a = nearest_on(c.points, from);
        if (a.distance > near) continue;
        const OnRoute b = nearest_on(c.points, to);
        if (b.distance > near) continue;
        const double whole = c.closed ? c.length() : 0;
        double ahead = b.arc - a.arc, back = -ahead;
        if (c.closed) {
            if (ahead < 0) ahead += whole;
            if (back < 0) back += whole;
        } else if (ahead < 0)
            ahead = infinity;
        else
            back = infinity;
        const bool forward = ahead <= back;
        if (std::min(ahead, back) > longest) continue;
        if (!reach_.is_free(from, a.point, z, hints) || !reach_.is_free(b.point, to, z, hints)) continue;
        route.push_back(a.point);
        between(c.points, a, b, c.closed, forward, route);
        route.push_back(b.point);
        return true;
    }
    return false;
}

std::vector<RoughRoute> LayerRoutes::joined_lines(std::vector<LinePiece> pieces,
                                                  std::span<const FreeContour> contours, double z,
                                                  double longest, bool oneway, Vec2& at,
                                                  const Progress& progress) const {
    std::vector<RoughRoute> routes;
    std::vector<char> done(pieces.size(), 0);
    int lines = 0;
    for (const LinePiece& p : pieces)
        lines = std::max(lines, p.line + 1);
    std::vector<std::vector<std::size_t>> of_line(static_cast<std::size_t>(lines));
    for (std::size_t i = 0; i < pieces.size(); ++i)
        of_line[std::size_t(pieces[i].line)].push_back(i);
    const auto end = [&](std::size_t i, bool high, const Interval LinePiece::*range) {
        const LinePiece& p = pieces[i];
        return frame_.xy(high ? (p.*range).hi : (p.*range).lo, p.v);
    };

    for (std::size_t left = pieces.size(); left > 0;) {
        progress.check();
        // Go on with what is nearest.
        std::size_t next = 0;
        bool from_high = false;
        double nearest = infinity;
        for (std::size_t i = 0; i < pieces.size(); ++i)
            for (const bool high : {false, true}) {
                if (done[i] || (oneway && high)) continue;
                const double d = (end(i, high, &LinePiece::cut) - at).norm();
                if (d < nearest) {
                    nearest = d;
                    next = i;
                    from_high = high;
                }
            }
        RoughRoute route;
        route.line = pieces[next].line;
        route.offset = pieces[next].v;
        route.reversible = !oneway;
        route.before = end(next, from_high, &LinePiece::free);
        int turn = 0; // to which side the lines went on
        for (;;) {
            done[next] = 1;
            --left;
            route.points.push_back(end(next, from_high, &LinePiece::cut));
            route.points.push_back(end(next, !from_high, &LinePiece::cut));
            route.after = end(next, !from_high, &LinePiece::free);
            at = route.points.back();
            if (oneway) break;
            std::optional<std::size_t> best;
            bool best_high = false;
            std::vector<Vec2> best_route;
            double shortest = infinity;
            for (const int side : {-1, 1}) {
                const int line = pieces[next].line + side;
                if (line < 0 || line >= lines || (turn != 0 && side != turn)) continue;
                for (const std::size_t i : of_line[std::size_t(line)])
                    for (const bool high : {false, true}) {
                        if (done[i]) continue;
                        const Vec2 start = end(i, high, &LinePiece::cut);
                        if ((start - at).norm() >= shortest) continue;
                        std::vector<Vec2> link;
                        if (!connect(at, start, contours, z, longest, link)) continue;
                        best = i;
                        best_high = high;
                        best_route = std::move(link);
                        shortest = (start - at).norm();
                    }
            }
            if (!best) break;
            turn = pieces[*best].line - pieces[next].line;
            route.points.insert(route.points.end(), best_route.begin(), best_route.end());
            next = *best;
            from_high = best_high;
        }
        routes.push_back(std::move(route));
    }
    return routes;
}

std::vector<RoughRoute>
LayerRoutes::along_contours(std::span<const FreeContour> contours, double z, Vec2& at,
                            const Progress& progress,
                            const std::function<bool(const Vec2&, const Vec2&)>& wanted_too) const {
    std::vector<RoughRoute> all;
    for (const FreeContour& contour : contours) {
        progress.check();
        const std::vector<Vec2> points = in_steps(contour, step_radii * cutter_.radius());
        const std::size_t n = points.size() - 1;
        std::vector<char> busy(n, 0);
        parallel_for(n, block_steps, progress.part(0, 0), [&](std::size_t i) {
            const Vec3 a(points[i].x(), points[i].y(), z), b(points[i + 1].x(), points[i + 1].y(), z);
            busy[i] =
                field_.has_work(cutter_, a, b, min_) || (wanted_too && wanted_too(points[i], points[i + 1]));
        });
        if (std::find(busy.begin(), busy.end(), 1) == busy.end()) continue;
        std::vector<char> cut = busy;
        close_gaps(points, contour.closed, busy, gap_radii * cutter_.radius(), cut);
        begin_earlier(points, contour.closed, z, cut);
        if (std::find(cut.begin(), cut.end(), 0) == cut.end()) {
            RoughRoute route;
            route.points = contour.points;
            route.closed = contour.closed;
            route.reversible = false;
            all.push_back(std::move(route));
        } else {
            add_stretches(points, contour.closed, cut, cutter_.radius(), all);
        }
    }
    return nearest_first(std::move(all), at);
}

/// The tool comes in where nothing stands, if that is so within a radius before a stretch that is to be cut.
void LayerRoutes::begin_earlier(const std::vector<Vec2>& points, bool closed, double z,
                                std::vector<char>& cut) const {
    const std::size_t n = cut.size();
    const std::vector<char> wanted = cut;
    for (std::size_t i = 0; i < n; ++i) {
        const bool starts = i == 0 ? !closed || !wanted[n - 1] : !wanted[i - 1];
        if (!wanted[i] || !starts) continue;
        double arc = 0;
        for (std::size_t j = i; arc < entry_radii * cutter_.radius();) {
            if (field_.stand_height(cutter_, points[j], points[j]) <= z + min_) break;
            if (j == 0 && !closed) break;
            j = (j + n - 1) % n;
            if (wanted[j]) break;
            cut[j] = 1;
            arc += (points[j + 1] - points[j]).norm();
        }
    }
}

} // namespace facetmill
