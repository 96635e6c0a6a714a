// Body of axial_kernel_*.cpp: the highest lift over a polyline. The lift is concave on every segment, and
// below each of its tangent planes everywhere. Planes at the corners about the segment that was touched last
// tell which other segments could reach higher; only those get the exact test, and none does where nothing
// reaches what is asked for.
#pragma once

#include "core/base/tolerances.h"
#include "core/gouge/axial_elements.h"
#include "core/gouge/axial_kernel.h"

namespace facetmill::simd {

namespace {

struct CurveSearch {
    const SurfaceTable& surface;
    const AxialQuery& query;
    const double* points;
    std::uint32_t count;
    AxialAnswer& best;

    /// Points of the polyline in the cutter's frame.
    FACETMILL_MEMBER Point4 corners(const std::uint32_t (&which)[double_lanes]) const {
        Double4 d[3];
        for (int w = 0; w < double_lanes; ++w)
            for (std::size_t k = 0; k < 3; ++k)
                d[k][w] = points[3 * std::size_t(which[w]) + k] - query.place[k];
        const auto& m = query.frame;
        return {m[0][0] * d[0] + m[0][1] * d[1] + m[0][2] * d[2],
                m[1][0] * d[0] + m[1][1] * d[1] + m[1][2] * d[2],
                m[2][0] * d[0] + m[2][1] * d[1] + m[2][2] * d[2]};
    }

    FACETMILL_MEMBER static Double4 distance(const Point4& p) { return root(p.x * p.x + p.y * p.y); }

    /// Lifts of points; -inf for those that are not under the cutter.
    FACETMILL_MEMBER Double4 corner_lift(const Point4& p, const Double4& rho) const {
        const Double4 r = all(surface.max_radius);
        return select(rho <= r, p.z - height(surface, smaller(rho, r)), all(no_lift));
    }

    /// dg/drho for rho <= max_radius.
    FACETMILL_MEMBER Double4 slope(const Double4& rho) const {
        Double4 result = all(0.0);
        for (int i = 0; i < surface.count; ++i) {
            const SurfacePiece& p = surface.piece[i];
            Double4 here = all(p.slope0);
            if (p.r != 0) {
                const Double4 out = larger(rho - p.e, all(0.0));
                here = out / root(larger((p.r - out) * (p.r + out), all(0.0)));
            }
            result = i == 0 ? here : select(rho > surface.piece[i - 1].rho1, here, result);
        }
        return result;
    }

    FACETMILL_MEMBER void test(const Point4& a, const Point4& b, const std::uint32_t (&segment)[double_lanes],
                               int segments) {
        const Mask4 wanted = Mask4{0, 1, 2, 3} < std::int64_t(segments);
        const Lift4 lift = edge_lift(surface, wanted, a, b, all(0.0));
        for (int w = 0; w < segments; ++w)
            if (lift.tip[w] > best.tip) {
                best.tip = lift.tip[w];
                best.slot = segment[w];
                best.point[0] = lift.point.x[w];
                best.point[1] = lift.point.y[w];
                best.point[2] = lift.point.z[w];
            }
    }

    FACETMILL_CALLED void test(const std::uint32_t (&segment)[double_lanes], int segments) {
        std::uint32_t from[double_lanes], to[double_lanes];
        for (int w = 0; w < double_lanes; ++w) {
            from[w] = segment[w < segments ? w : 0];
            to[w] = from[w] + 1;
        }
        test(corners(from), corners(to), segment, segments);
    }

    /// The segment at the point with the highest lift; the middle one where no point is under the cutter.
    FACETMILL_CALLED std::uint32_t first_guess() const {
        std::uint32_t guess = count / 2;
        double highest = no_lift;
        for (std::uint32_t first = 0; first < count; first += double_lanes) {
            std::uint32_t which[double_lanes];
            for (std::uint32_t w = 0; w < double_lanes; ++w)
                which[w] = first + w < count ? first + w : count - 1;
            const Point4 p = corners(which);
            const Double4 lift = corner_lift(p, distance(p));
            for (int w = 0; w < double_lanes; ++w)
                if (lift[w] > highest) {
                    highest = lift[w];
                    guess = which[w];
                }
        }
        return guess;
    }

    FACETMILL_MEMBER void run() {
        const std::uint32_t last = count - 1;
        // Four corners in a row, the segment that is likely touched between the second and the third.
        std::uint32_t middle = query.hint == no_slot ? first_guess() : query.hint;
        middle = middle < last ? middle : (last > 0 ? last - 1 : 0);
        const std::uint32_t start = middle > 0 ? middle - 1 : 0;
        std::uint32_t which[double_lanes];
        for (std::uint32_t w = 0; w < double_lanes; ++w)
            which[w] = start + w < last ? start + w : last;
        const Point4 p = corners(which);
        const Double4 rho = distance(p), lift = corner_lift(p, rho);
        const Double4 size = magnitude(p.x) + magnitude(p.y) + magnitude(p.z) + surface.max_radius;
        // A corner may say that it is enough, but not by its rounding.
        const Mask4 enough = lift - tolerance::bound_slack * size > query.enough;
        if (bits(enough) != 0) {
            for (int w = 0; w < double_lanes; ++w)
                if (enough[w] && lift[w] > best.tip) best.tip = lift[w];
            best.slot = middle;
            return;
        }
        std::uint32_t near_count = last - start;
        near_count = near_count < 3 ? near_count : 3;
        // Where none of the corners is as high as is asked for most likely nothing is, and bounds tell.
        const bool low = last > 0 && query.least > no_lift && bits(lift > query.least) == 0;
        if (!low) {
            const std::uint32_t segment[double_lanes] = {start, start + 1, start + 2, start + 3};
            const Point4 next{Double4{p.x[1], p.x[2], p.x[3], p.x[3]},
                              Double4{p.y[1], p.y[2], p.y[3], p.y[3]},
                              Double4{p.z[1], p.z[2], p.z[3], p.z[3]}};
            // One point is a segment without length.
            test(p, next, segment, last == 0 ? 1 : int(near_count));
        }
        if ((!low && last <= near_count) || best.tip > query.enough) return;

        // Tangent planes of the lift: z - at0 - s (along the radius of the corner). Beyond the rim, and where
        // the cutter is steep, its steep support line stands in for the tangent.
        const Double4 here = slope(smaller(rho, all(surface.max_radius)));
        const Mask4 outer = ~(here <= surface.outer_slope) | ~(rho <= surface.max_radius);
        const Double4 s = select(outer, all(surface.outer_slope), here);
        const Double4 at0 = select(outer, all(surface.outer_at0),
                                   height(surface, smaller(rho, all(surface.max_radius))) - s * rho);
        // On the axis itself a level plane is a support too.
        const Double4 share = select(rho > 0.0, s / rho, all(0.0)), sx = share * p.x, sy = share * p.y;
        Double4 plane[3];
        for (int k = 0; k < 3; ++k)
            plane[k] = query.frame[2][k] - sx * query.frame[0][k] - sy * query.frame[1][k];
        const double slack = tolerance::bound_slack * (1 + surface.outer_slope);
        const auto bound = [&](std::uint32_t i) __attribute__((always_inline)) {
            const double* q = points + 3 * std::size_t(i);
            const double x = q[0] - query.place[0], y = q[1] - query.place[1], z = q[2] - query.place[2];
            const auto size_of = [](double v) { return v < 0 ? -v : v; };
            const double noise = slack * (size_of(x) + size_of(y) + size_of(z) + surface.max_radius);
            return plane[0] * x + plane[1] * y + plane[2] * z - at0 + noise;
        };
        std::uint32_t segment[double_lanes];
        int waiting = 0;
        // Above every plane's bound: not told from the best.
        const auto look_at = [&](std::uint32_t i) __attribute__((always_inline)) {
            if (bits(larger(bound(i), bound(i + 1)) <= best.tip) != 0) return;
            segment[waiting++] = i;
            if (waiting < double_lanes) return;
            test(segment, waiting);
            waiting = 0;
        };
        // The plane of the corner on that side alone tells of most segments, four ends at a time.
        const auto scan = [&](std::uint32_t from, std::uint32_t to, int corner)
            __attribute__((always_inline)) {
            std::uint32_t i = from;
            bool before = false; // the end before may be higher
            for (; i + double_lanes <= to + 1 && from < to; i += double_lanes) {
                const double* q = points + 3 * std::size_t(i);
                const Double4 x = Double4{q[0], q[3], q[6], q[9]} - query.place[0],
                              y = Double4{q[1], q[4], q[7], q[10]} - query.place[1],
                              z = Double4{q[2], q[5], q[8], q[11]} - query.place[2];
                const Double4 noise =
                    slack * (magnitude(x) + magnitude(y) + magnitude(z) + surface.max_radius);
                const Double4 most =
                    plane[0][corner] * x + plane[1][corner] * y + plane[2][corner] * z - at0[corner] + noise;
                const Mask4 higher = ~(most <= best.tip);
                if (bits(higher) == 0 && !before) continue;
                for (std::uint32_t w = 0; w < double_lanes; ++w) {
                    const bool after = higher[w] != 0;
                    if (i + w > from && (before || after)) look_at(i + w - 1);
                    before = after;
                }
            }
            for (std::uint32_t k = i > from ? i - 1 : from; k < to; ++k)
                look_at(k);
        };
        const std::uint32_t before = low ? start + (near_count + 1) / 2 : start;
        scan(0, before, 0);
        scan(low ? before : start + near_count, last, int(near_count));
        if (waiting > 0) test(segment, waiting);
        if (best.slot != no_slot) return;
        // The next question begins at the highest of them.
        std::uint32_t highest = 0;
        for (std::uint32_t w = 1; w < double_lanes; ++w)
            if (lift[int(w)] > lift[int(highest)]) highest = w;
        best.slot = lift[int(highest)] > no_lift ? which[highest] : middle;
    }
};

void curve(const SurfaceTable& surface, const AxialQuery& query, const double* points, std::uint32_t count,
           AxialAnswer& answer) {
    answer.tip = query.least;
    answer.slot = no_slot;
    if (count == 0) return;
    CurveSearch search{surface, query, points, count, answer};
    search.run();
    if (answer.slot == no_slot) answer.slot = query.hint;
}

} // namespace

} // namespace facetmill::simd
