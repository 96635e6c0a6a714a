#include "core/strategy/rough/rough_reach.h"

#include "core/base/parallel.h"
#include "core/strategy/surface/lift_line.h"

#include <cmath>
#include <unordered_map>

namespace facetmill {

namespace {

/// Places of a layer, at most: 160 MB of heights.
constexpr double max_places = 2e7;
constexpr std::size_t line_block = 1;
/// Halvings of a grid's edge: down to a thousandth of the margin on any edge that is allowed.
constexpr int max_reach_halvings = 40;
/// Points that one straight piece may stand for: each is looked at again for every piece that is tried.
constexpr std::size_t longest_thinned = 256;
/// Ends of what is free are known to this share of the margin.
constexpr double border_share = 0.25;

} // namespace

RoughReach::RoughReach(ContactIndexPtr index, const PlanContext& context, double allowance, double margin,
                       double lowest_tip)
    : margin_(margin), spacing_(1), within_(context.within),
      cutter_(index, CutterProfile(context.tool.cutter()), allowance + margin) {
    // Half of the margin for what lies between places, half for thinning.
    spacing_ = std::max(safe_spacing(cutter_.profile(), 0.5 * margin), margin);
    const Tool& tool = context.tool;
    double base = tool.flute_length;
    const auto add = [&](double diameter, double length) {
        if (diameter > 0 && length > 0 && lowest_tip + base < context.kept_off_box().hi.z() + allowance)
            bodies_.push_back(
                {AxialLift(context.contact, CutterProfile(AptCutter::flat(diameter, unlimited_height)),
                           allowance + margin),
                 base});
        base += std::max(length, 0.0);
    };
    add(tool.shank_diameter, tool.shank_length);
    for (const HolderSection& s : tool.holder)
        add(s.diameter, s.length);
}

double RoughReach::tip_z(const Vec2& p, Hints& hints) const {
    if (is_outside(p)) return infinity;
    return raised(p, cutter_.tip_z(p.x(), p.y(), hints.cutter), hints);
}

double RoughReach::raised(const Vec2& p, double z, Hints& hints) const {
    hints.bodies.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const double under = z + bodies_[i].base;
        const double body = bodies_[i].lift.tip_z(p.x(), p.y(), hints.bodies[i], under);
        if (body > under) z = body - bodies_[i].base;
    }
    return z;
}

void RoughReach::tip_z(std::span<const Vec2> points, std::span<double> heights,
                       const Progress& progress) const {
    cutter_.tip_z(points, heights, progress);
    std::vector<double> body(bodies_.empty() ? 0 : points.size());
    for (const Body& b : bodies_) {
        b.lift.tip_z(points, body, progress);
        for (std::size_t i = 0; i < body.size(); ++i)
            heights[i] = std::max(heights[i], body[i] - b.base);
    }
    if (within_)
        parallel_for(points.size(), 256, progress.part(1, 1), [&](std::size_t i) {
            if (is_outside(points[i])) heights[i] = infinity;
        });
}

double RoughReach::highest(const Vec2& a, const Vec2& b, Hints& hints, double least) const {
    const double n = std::max(1.0, std::ceil((b - a).norm() / spacing_));
    double z = least;
    for (double i = 0; i <= n; ++i) {
        const Vec2 p = a + (i / n) * (b - a);
        if (is_outside(p)) return infinity;
        z = raised(p, cutter_.tip_z(p.x(), p.y(), hints.cutter, z), hints);
    }
    return z;
}

bool RoughReach::is_free(const Vec2& p, double z, Hints& hints) const {
    if (is_outside(p) || cutter_.is_above(p.x(), p.y(), z, hints.cutter)) return false;
    hints.bodies.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].lift.is_above(p.x(), p.y(), z + bodies_[i].base, hints.bodies[i])) return false;
    return true;
}

bool RoughReach::is_free(const Vec2& a, const Vec2& b, double z, Hints& hints) const {
    const double n = std::max(1.0, std::ceil((b - a).norm() / spacing_));
    for (double i = 0; i <= n; ++i)
        if (!is_free(a + (i / n) * (b - a), z, hints)) return false;
    return true;
}

double RoughReach::last_free(const Vec2& free, double lift_free, const Vec2& blocked, double lift_blocked,
                             double z, Hints& hints) const {
    double low = 0, high = 1;
    const double length = (blocked - free).norm();
    if (!(length > 0)) return 0;
    const double enough = std::min(1.0, border_share * margin_ / length);
    // As if the lift were straight between the two, now a little on one side of the root and now on the
    // other, so that both ends close in on it; by halves where that does not help, as at a jump.
    bool straight = std::isfinite(lift_free) && std::isfinite(lift_blocked), was_free = false;
    for (int i = 0; i < max_reach_halvings && high - low > enough; ++i) {
        double mid = 0.5 * (low + high);
        if (straight) {
            const double root = low + (high - low) * (z - lift_free) / (lift_blocked - lift_free);
            mid = std::clamp(root + (was_free ? 0.45 : -0.45) * enough, low + 0.45 * enough,
                             high - 0.45 * enough);
        }
        const double before = high - low, lift = tip_z(free + mid * (blocked - free), hints);
        was_free = lift <= z;
        (was_free ? low : high) = mid;
        (was_free ? lift_free : lift_blocked) = lift;
        straight = straight && (i == 0 || high - low < 0.5 * before) && std::isfinite(lift);
    }
    return low;
}

double FreeContour::length() const {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        sum += (points[i] - points[i - 1]).norm();
    return sum;
}

ReachGrid::ReachGrid(const RoughReach& reach, const DriveFrame& frame, const Vec2& lo, const Vec2& hi,
                     const Progress& progress)
    : reach_(reach), frame_(frame), lo_(lo) {
    // The diagonal of a cell is no longer than what a cutter may move unseen.
    const double wanted = reach.spacing() / std::numbers::sqrt2;
    const double columns = std::ceil((hi.x() - lo.x()) / wanted) + 1,
                 rows = std::ceil((hi.y() - lo.y()) / wanted) + 1;
    if (!(columns * rows <= max_places))
        throw Error(ErrorCode::limit_exceeded, "tolerance",
                    "the part asks for more than " + format_number(max_places)
                        + " places of this tool on a layer",
                    "check the part's units, or take a larger tool or tolerance");
    columns_ = std::size_t(std::max(columns, 2.0));
    rows_ = std::size_t(std::max(rows, 2.0));
    step_ = {(hi.x() - lo.x()) / double(columns_ - 1), (hi.y() - lo.y()) / double(rows_ - 1)};
    heights_.resize(columns_ * rows_);
    // In bands of rows, for the points' memory.
    const std::size_t band = std::max<std::size_t>(1, 1'000'000 / columns_);
    std::vector<Vec2> points;
    for (std::size_t row = 0; row < rows_; row += band) {
        const std::size_t end = std::min(rows_, row + band);
        points.clear();
        for (std::size_t r = row; r < end; ++r)
            for (std::size_t c = 0; c < columns_; ++c)
                points.push_back(place(c, r));
        reach.tip_z(points, std::span(heights_).subspan(row * columns_, points.size()),
                    progress.part(double(row) / double(rows_), double(end) / double(rows_)));
    }
    for (const double z : heights_)
        lowest_ = std::min(lowest_, z);
    if (!reach.has_bodies()) return;
    std::vector<double> alone;
    for (std::size_t row = 0; row < rows_; row += band) {
        points.clear();
        for (std::size_t r = row; r < std::min(rows_, row + band); ++r)
            for (std::size_t c = 0; c < columns_; ++c)
                points.push_back(place(c, r));
        alone.resize(points.size());
        reach.cutter().tip_z(points, alone, progress.part(1, 1));
        for (std::size_t i = 0; i < points.size(); ++i)
            if (const double tool = heights_[row * columns_ + i]; alone[i] < tool)
                held_up_.push_back({points[i], alone[i], tool});
    }
}

std::vector<FreeContour> ReachGrid::contours(double z, const Progress& progress, double thinned) const {
    // Crossings are named by the grid's edge: 2 * node + 0 to the right, + 1 upward. Walking round a cell
    // counter-clockwise one leaves the free side at one edge and comes back at another; the contour goes from
    // the first to the second. Each crossing is left once and met once, in the two cells beside its edge.
    constexpr std::size_t nowhere = std::size_t(-1);
    struct Crossing {
        std::size_t free, blocked;
        Vec2 at;
        std::size_t next = nowhere;
        bool met = false;
    };
    std::vector<Crossing> crossings;
    std::unordered_map<std::size_t, std::size_t> of_edge;
    const auto is_free = [&](std::size_t node) { return heights_[node] <= z; };
    const auto crossing = [&](std::size_t a, std::size_t b) {
        const std::size_t low = std::min(a, b), edge = 2 * low + (std::max(a, b) - low == 1 ? 0 : 1);
        const auto [found, is_new] = of_edge.try_emplace(edge, crossings.size());
        if (is_new) {
            const std::size_t f = is_free(a) ? a : b, o = f == a ? b : a;
            crossings.push_back({f, o, {}});
        }
        return found->second;
    };
    for (std::size_t row = 0; row + 1 < rows_; ++row) {
        progress.check();
        for (std::size_t column = 0; column + 1 < columns_; ++column) {
            const std::size_t n = at(column, row);
            const std::array<std::size_t, 4> corner{n, n + 1, n + columns_ + 1, n + columns_};
            const std::array<bool, 4> free{is_free(corner[0]), is_free(corner[1]), is_free(corner[2]),
                                           is_free(corner[3])};
            const int count = free[0] + free[1] + free[2] + free[3];
            if (count == 0 || count == 4) continue;
            // Runs of free corners; two opposite ones are two runs, so what is blocked stays joined.
            for (std::size_t k = 0; k < 4; ++k) {
                if (!free[k] || free[(k + 3) % 4]) continue;
                std::size_t end = k;
                while (free[(end + 1) % 4])
                    end = (end + 1) % 4;
                const std::size_t out = crossing(corner[end], corner[(end + 1) % 4]);
                const std::size_t in = crossing(corner[(k + 3) % 4], corner[k]);
                crossings[out].next = in;
                crossings[in].met = true;
            }
        }
    }
    parallel_for(crossings.size(), 64, progress.part(0, 0), [&](std::size_t i) {
        Crossing& c = crossings[i];
        RoughReach::Hints hints;
        const Vec2 a = place(c.free % columns_, c.free / columns_),
                   b = place(c.blocked % columns_, c.blocked / columns_);
        c.at = a + reach_.last_free(a, heights_[c.free], b, heights_[c.blocked], z, hints) * (b - a);
    });

    std::vector<FreeContour> all;
    std::vector<char> used(crossings.size(), 0);
    const auto follow = [&](std::size_t start) {
        FreeContour contour;
        std::size_t i = start;
        for (; i != nowhere && !used[i]; i = crossings[i].next) {
            used[i] = 1;
            contour.points.push_back(crossings[i].at);
        }
        if (i == start) {
            contour.closed = true;
            contour.points.push_back(crossings[start].at);
        }
        if (contour.points.size() < 2) return;
        contour.points = thinned_route(contour.points, thinned * reach_.margin());
        all.push_back(std::move(contour));
    };
    for (std::size_t i = 0; i < crossings.size(); ++i)
        if (!crossings[i].met) follow(i);
    for (std::size_t i = 0; i < crossings.size(); ++i)
        if (!used[i]) follow(i);
    return all;
}

ReachLine::ReachLine(const RoughReach& reach, const DriveFrame& frame, double v, double u0, double u1)
    : reach_(reach), frame_(frame), v_(v), u0_(u0) {
    const auto n = std::size_t(std::max(1.0, std::ceil((u1 - u0) / reach.spacing())));
    step_ = (u1 - u0) / double(n);
    RoughReach::Hints hints;
    heights_.resize(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
        heights_[i] = reach.tip_z(frame_.xy(u0 + double(i) * step_, v), hints);
        lowest_ = std::min(lowest_, heights_[i]);
    }
}

std::vector<Interval> ReachLine::free(double z, RoughReach::Hints& hints) const {
    std::vector<Interval> all;
    if (lowest_ > z) return all;
    const auto u = [&](std::size_t i) { return u0_ + double(i) * step_; };
    const auto end = [&](std::size_t inside, std::size_t outside) {
        const Vec2 a = frame_.xy(u(inside), v_), b = frame_.xy(u(outside), v_);
        return u(inside)
               + reach_.last_free(a, heights_[inside], b, heights_[outside], z, hints)
                     * (u(outside) - u(inside));
    };
    for (std::size_t i = 0; i < heights_.size(); ++i) {
        if (!(heights_[i] <= z)) continue;
        Interval interval;
        interval.lo = i == 0 ? u(0) : end(i, i - 1);
        while (i + 1 < heights_.size() && heights_[i + 1] <= z)
            ++i;
        interval.hi = i + 1 == heights_.size() ? u(i) : end(i, i + 1);
        all.push_back(interval);
    }
    return all;
}

namespace {

template <class Point>
std::vector<Point> thinned_points(const std::vector<Point>& route, double beside) {
    if (route.size() < 3) return route;
    std::vector<Point> kept{route.front()};
    std::size_t from = 0;
    while (from + 1 < route.size()) {
        std::size_t best = from + 1;
        for (std::size_t to = from + 2; to < route.size() && to - from < longest_thinned; ++to) {
            const Point chord = route[to] - route[from];
            const double length = chord.norm();
            bool near = length > 0;
            for (std::size_t k = from + 1; near && k < to; ++k) {
                const Point d = route[k] - route[from];
                const double along = d.dot(chord) / length;
                const double across = (d - along / length * chord).norm();
                near = across <= beside && along >= -beside && along <= length + beside;
            }
            if (!near) break;
            best = to;
        }
        kept.push_back(route[best]);
        from = best;
    }
    return kept;
}

} // namespace

std::vector<Vec2> thinned_route(const std::vector<Vec2>& route, double beside) {
    return thinned_points(route, beside);
}

std::vector<Vec3> thinned_route(const std::vector<Vec3>& route, double beside) {
    return thinned_points(route, beside);
}

} // namespace facetmill
