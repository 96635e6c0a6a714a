#include "core/strategy/rough_reach.h"

#include "core/base/parallel.h"
#include "core/strategy/lift_line.h"

#include <cmath>
#include <unordered_map>

namespace facetmill {

namespace {

constexpr double most_places = 2e7;
constexpr std::size_t line_block = 1;
/// Halvings of a grid's edge: down to a thousandth of the margin on any edge that is allowed.
constexpr int most_halvings = 40;
constexpr std::size_t longest_thinned = 256;

} // namespace

RoughReach::RoughReach(ContactIndexPtr index, const PlanContext& context, double allowance, double margin,
                       double lowest_tip)
    : margin_(margin), spacing_(1), cutter_(index, CutterProfile(context.tool.cutter()), allowance + margin) {
    // Half of the margin for what lies between places, half for thinning.
    spacing_ = std::max(safe_spacing(cutter_.profile(), 0.5 * margin), margin);
    const Tool& tool = context.tool;
    double base = tool.flute_length;
    const auto add = [&](double diameter, double length) {
        if (diameter > 0 && length > 0 && lowest_tip + base < context.part_box.hi.z() + allowance)
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
    double z = cutter_.tip_z(p.x(), p.y(), hints.cutter);
    if (bodies_.empty()) return z;
    hints.bodies.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        z = std::max(z, bodies_[i].lift.tip_z(p.x(), p.y(), hints.bodies[i]) - bodies_[i].base);
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
}

double RoughReach::highest(const Vec2& a, const Vec2& b, Hints& hints) const {
    const double n = std::max(1.0, std::ceil((b - a).norm() / spacing_));
    double z = -infinity;
    for (double i = 0; i <= n; ++i)
        z = std::max(z, tip_z(a + (i / n) * (b - a), hints));
    return z;
}

bool RoughReach::is_free(const Vec2& a, const Vec2& b, double z, Hints& hints) const {
    const double n = std::max(1.0, std::ceil((b - a).norm() / spacing_));
    for (double i = 0; i <= n; ++i)
        if (!(tip_z(a + (i / n) * (b - a), hints) <= z)) return false;
    return true;
}

double RoughReach::last_free(const Vec2& free, const Vec2& blocked, double z, Hints& hints) const {
    double low = 0, high = 1;
    const double length = (blocked - free).norm();
    for (int i = 0; i < most_halvings && (high - low) * length > 0.1 * margin_; ++i) {
        const double mid = 0.5 * (low + high);
        (tip_z(free + mid * (blocked - free), hints) <= z ? low : high) = mid;
    }
    return low;
}

double Contour::length() const {
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
    if (!(columns * rows <= most_places))
        throw Error(ErrorCode::limit_exceeded, "tolerance",
                    "the part asks for more than " + format_number(most_places)
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
}

std::vector<Contour> ReachGrid::contours(double z, const Progress& progress) const {
    // Crossings are named by the grid's edge: 2 * node + 0 to the right, + 1 upward. Walking round a cell
    // counter-clockwise one leaves the free side at one edge and comes back at another; the contour goes from
    // the first to the second. Each crossing is left once and met once, in the two cells beside its edge.
    constexpr std::size_t nowhere = std::size_t(-1);
    struct Crossing {
        Vec2 free, blocked, at;
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
            crossings.push_back({place(f % columns_, f / columns_), place(o % columns_, o / columns_), {}});
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
        c.at = c.free + reach_.last_free(c.free, c.blocked, z, hints) * (c.blocked - c.free);
    });

    std::vector<Contour> all;
    std::vector<char> used(crossings.size(), 0);
    const auto follow = [&](std::size_t start) {
        Contour contour;
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
        contour.points = thinned_way(contour.points, 0.5 * reach_.margin());
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
        return u(inside) + reach_.last_free(a, b, z, hints) * (u(outside) - u(inside));
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

std::vector<Vec2> thinned_way(const std::vector<Vec2>& way, double beside) {
    if (way.size() < 3) return way;
    std::vector<Vec2> kept{way.front()};
    std::size_t from = 0;
    while (from + 1 < way.size()) {
        std::size_t best = from + 1;
        for (std::size_t to = from + 2; to < way.size() && to - from < longest_thinned; ++to) {
            const Vec2 chord = way[to] - way[from];
            const double length = chord.norm();
            bool near = length > 0;
            for (std::size_t k = from + 1; near && k < to; ++k) {
                const Vec2 d = way[k] - way[from];
                const double along = d.dot(chord) / length;
                const double across = std::abs(d.x() * chord.y() - d.y() * chord.x()) / length;
                near = across <= beside && along >= -beside && along <= length + beside;
            }
            if (!near) break;
            best = to;
        }
        kept.push_back(way[best]);
        from = best;
    }
    return kept;
}

} // namespace facetmill
