#include "core/strategy/lathe/lathe_line.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/surface/line_refiner.h"

#include <cmath>

namespace facetmill {

namespace {

/// Places that a thread takes at a time.
constexpr std::size_t line_points_per_block = 256;

LathePlace between(const LathePlace& a, const LathePlace& b, double t) {
    return {a.angle + t * (b.angle - a.angle), a.y + t * (b.y - a.y)};
}

/// One line over a field, for one thread.
struct FieldLine {
    using Point = LathePoint;
    const LatheField& field;
    const Progress& progress;
    LatheField::Hint hint;

    LathePoint middle(const LathePoint& a, const LathePoint& b) {
        return field.point(between(a.place, b.place, 0.5), hint);
    }
    LinePoint flat(const LathePoint& from, const LathePoint& p) const {
        return {lathe_distance(from.place, p.place, field.part_radius()), p.u};
    }
    static LathePoint over(const LathePoint& high, const LathePoint& low) {
        LathePoint corner = high;
        corner.place = low.place;
        return corner;
    }
    void check() const { progress.check(); }
};

} // namespace

double safe_lathe_spacing(const CutterProfile& profile, double part_radius, double below) {
    // How much of `below` the arc takes is free: a quarter, or less where that is already wide.
    constexpr double arc_share = 0.25;
    const double chord = safe_spacing(profile, (1 - arc_share) * below);
    return std::min(chord, std::sqrt(8 * part_radius * arc_share * below));
}

double lathe_distance(const LathePlace& a, const LathePlace& b, double part_radius) {
    return std::hypot(part_radius * (b.angle - a.angle), b.y - a.y);
}

std::vector<LathePoint> trace(const LatheField& field, std::span<const LathePlace> route,
                              const LineTolerance& tolerance, const Progress& progress) {
    // Places to look at: every piece of the route in even parts.
    std::vector<LathePlace> places;
    double count = 1;
    const auto parts = [&](std::size_t i) {
        return std::max(
            1.0, std::ceil(lathe_distance(route[i - 1], route[i], field.part_radius()) / tolerance.spacing));
    };
    for (std::size_t i = 1; i < route.size(); ++i)
        count += parts(i);
    if (!(count <= max_lathe_points))
        throw Error(ErrorCode::limit_exceeded, "side_feed",
                    "the path asks for more than " + format_number(max_lathe_points) + " places of this tool",
                    "check the part's units, or take a larger tool, tolerance or side feed");
    places.reserve(std::size_t(count));
    places.push_back(route[0]);
    for (std::size_t i = 1; i < route.size(); ++i) {
        const double n = parts(i);
        for (double k = 1; k < n; ++k)
            places.push_back(between(route[i - 1], route[i], k / n));
        places.push_back(route[i]);
    }

    const std::size_t n = places.size();
    std::vector<LathePoint> nodes(n);
    parallel_blocks(n, line_points_per_block, progress.part(0, 0.7), [&](std::size_t begin, std::size_t end) {
        LatheField::Hint hint;
        for (std::size_t i = begin; i < end; ++i)
            nodes[i] = field.point(places[i], hint);
    });

    // Between two nodes no farther apart than the safe spacing, along the path itself, nothing is cut that is
    // deeper than allowed. What is left to find are bends where the straight motion would stay too high:
    // there the slope changes from one interval to the next.
    const auto slope = [&](std::size_t i) { // in the interval that ends at i
        const double ds = lathe_distance(nodes[i - 1].place, nodes[i].place, field.part_radius());
        return ds > 0 ? (nodes[i].u - nodes[i - 1].u) / ds : 0.0;
    };
    const auto bends = [&](std::size_t i) {
        const double ds = lathe_distance(nodes[i - 1].place, nodes[i].place, field.part_radius());
        if (std::hypot(ds, nodes[i].u - nodes[i - 1].u)
            > tolerance.spacing * (1 + tolerance::figure_rounding))
            return true;
        const double s = slope(i);
        const double before = i > 1 ? std::abs(s - slope(i - 1)) : infinity;
        const double after = i + 1 < n ? std::abs(slope(i + 1) - s) : infinity;
        // A kink between two nodes with the slopes of the neighbours is no higher than a quarter of this.
        const double least = 0.5 * std::min(tolerance.below, tolerance.above);
        return 0.25 * ds * std::max(before, after) / std::hypot(1.0, s) > least;
    };
    std::vector<std::vector<LathePoint>> extra((n - 1) / line_points_per_block + 1);
    std::vector<std::uint32_t> extra_before(n, 0); // points to put in before each node
    parallel_blocks(n, line_points_per_block, progress.part(0.7, 1), [&](std::size_t begin, std::size_t end) {
        FieldLine line{field, progress, {}};
        const LineRefiner refiner(line, tolerance);
        auto& more = extra[begin / line_points_per_block];
        for (std::size_t i = std::max<std::size_t>(begin, 1); i < end; ++i) {
            if (!bends(i)) continue;
            const std::size_t had = more.size();
            refiner.add(nodes[i - 1], line.middle(nodes[i - 1], nodes[i]), nodes[i], more);
            more.pop_back(); // the node itself
            extra_before[i] = std::uint32_t(more.size() - had);
            progress.check();
        }
    });
    std::size_t total = n;
    for (const auto& more : extra)
        total += more.size();
    if (total == n) return nodes;
    std::vector<LathePoint> points;
    points.reserve(total);
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (i % line_points_per_block == 0) at = 0;
        const auto& more = extra[i / line_points_per_block];
        for (std::uint32_t k = 0; k < extra_before[i]; ++k)
            points.push_back(more[at++]);
        points.push_back(nodes[i]);
    }
    return points;
}

std::vector<LathePoint> thinned(const std::vector<LathePoint>& points, std::span<const LathePlace> route,
                                double part_radius, double below, double above) {
    std::vector<LathePoint> kept;
    std::vector<LinePoint> line;
    std::size_t from = 0;
    for (std::size_t w = 1; w < route.size() && from + 1 < points.size(); ++w) {
        // The piece of the route up to its place w; radial moves at its end belong to it.
        const auto here = [&](std::size_t i) {
            return points[i].place.angle == route[w].angle && points[i].place.y == route[w].y;
        };
        std::size_t to = from + 1;
        while (to + 1 < points.size() && !here(to))
            ++to;
        while (to + 1 < points.size() && here(to + 1))
            ++to;
        line.clear();
        for (std::size_t i = from; i <= to; ++i)
            line.push_back({lathe_distance(points[from].place, points[i].place, part_radius), points[i].u});
        std::size_t next = from;
        for (const LinePoint& p : facetmill::thinned(line, below, above)) {
            while (line[next - from].s != p.s || line[next - from].z != p.z)
                ++next;
            if (kept.empty() || next != from) kept.push_back(points[next]);
        }
        from = to;
    }
    if (kept.empty()) kept = points;
    return kept;
}

} // namespace facetmill
