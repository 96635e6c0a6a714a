// Bounds of lifts over boxes with a roof, eight at a time. The lift z - g(rho) over a point of a facet is a
// concave function where z is a plane, so its tangent plane at one place bounds it everywhere. For a child of
// a node the plane is its roof, and the tangent that at the point of its box nearest to where the roof
// touches; the bound is wrong by second order in the size of the box only. So hardly a block is opened but
// those where the cutter touches.
//
// Bounds are floats, widened above their rounding.
#pragma once

#include "core/base/tolerances.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/simd_wide.h"

namespace facetmill::simd {

namespace {

/// What bounds need to know of a cutter at a place. They are shorter where the shape is known.
template <bool tilted, SurfaceShape shape>
struct Bounds {
    static constexpr bool ball = shape == SurfaceShape::ball, flat = shape == SurfaceShape::flat;

    const IndexView& index;
    const SurfaceTable& surface;
    const AxialQuery& query;

    float rim;        ///< roughly known distances beyond this may be at the rim
    float inner;      ///< distances below this are surely within the cutter
    float radius;     ///< of the cutter, widened
    float slack;      ///< positions of boxes in the frame are wrong by less
    float margin;     ///< bounds are wrong by less
    float uncertain;  ///< how much a bound changes with a position, at most
    float at[3];      ///< the index's origin from the place
    float at_low[2];  ///< what its rounding leaves out; vertical axis
    float turn[3][3]; ///< the frame
    double zero;      ///< bounds are relative to this height

    FACETMILL_MEMBER Bounds(const IndexView& i, const SurfaceTable& s, const AxialQuery& q)
        : index(i), surface(s), query(q) {
        double away = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
            const double d = index.origin[k] - query.place[k];
            if (k < 2 || tilted) away += d < 0 ? -d : d;
            size += index.half_size[k];
            at[k] = float(d);
            if (k < 2) at_low[k] = float(d - double(at[k]));
            if constexpr (tilted)
                for (int j = 0; j < 3; ++j)
                    turn[k][j] = float(query.frame[k][j]);
        }
        zero = tilted ? 0 : index.origin[2];
        if (!tilted) at[2] = 0;
        const double r = surface.max_radius, scale = away + size + r;
        const double steep = tolerance::steepest_roof + tolerance::steepest_tangent;
        slack = float(tolerance::float_slack * scale);
        inner = float(r * (1 - tolerance::rim_share));
        rim = float(r) * (1 - 4 * rough_share);
        radius = float(r * (1 + tolerance::float_slack)) + slack;
        margin = float(tolerance::float_slack * ((1 + steep) * (tilted ? 4 : 1) * scale + 4 * steep * r));
        uncertain = float(4 * (1 + steep));
    }

    /// How much boxes and their bounds may be wrong.
    template <class F>
    struct Doubt {
        F slack, margin; ///< positions, bounds by less than this
        FACETMILL_MEMBER F of_bound(const F&, const F&, const F&, const F&) const { return margin; }
    };
    template <class F>
    FACETMILL_MEMBER Doubt<F> doubt() const {
        return {all_of<F>(slack), all_of<F>(margin)};
    }
    /// The same of boxes whose positions are taken from `at` and then `at_low`, vertical axis: those that
    /// matter are as near as the cutter's radius and their size, and so exactly known are they.
    struct NearDoubt {
        Float8 slack, margin, per_slope;
        /// For a roof of slopes (px, py) and a tangent plane of (sx, sy).
        FACETMILL_MEMBER Float8 of_bound(const Float8& px, const Float8& py, const Float8& sx,
                                         const Float8& sy) const {
            if constexpr (!ball) return margin;
            return margin + per_slope * (magnitude(px) + magnitude(py) + magnitude(sx) + magnitude(sy));
        }
    };
    FACETMILL_MEMBER NearDoubt near_doubt(const Float8& hx, const Float8& hy) const {
        constexpr auto share = float(tolerance::float_slack),
                       steep = float(tolerance::steepest_roof + tolerance::steepest_tangent);
        const auto r = float(surface.max_radius), z = float(index.half_size[2]);
        const Float8 size = hx + hy, near = 2 * share * (r + size);
        if constexpr (ball) {
            const float arc = surface.rough[0].r;
            return {near, all(2 * share * (z + arc)), near + 2 * share * arc};
        }
        return {near, share * (2 * z + (1 + 5 * steep) * r) + share * (1 + steep) * size, all(0.0f)};
    }

    FACETMILL_MEMBER int pieces() const { return ball || flat ? 1 : surface.count; }
    FACETMILL_MEMBER static bool is_arc(const RoughPiece& p) { return ball || (!flat && p.r != 0); }

    /// A tip from `zero`, rounded down: what is higher by the last digit of a double must not be passed over.
    FACETMILL_MEMBER float rounded_down(double tip) const {
        const double from_zero = tip - zero;
        const auto rounded = float(from_zero);
        return double(rounded) > from_zero ? __builtin_nextafterf(rounded, -__builtin_inff()) : rounded;
    }

    /// About where a plane touches the cutter; (ux, uy): uphill, as long as the sine of its slope.
    template <class F>
    FACETMILL_MEMBER void touched(const F& ux, const F& uy, F& x_out, F& y_out) const {
        if (ball || (surface.guess_e == 0 && surface.guess_level == 0)) {
            x_out = ux * surface.guess_r;
            y_out = uy * surface.guess_r;
            return;
        }
        const F square = ux * ux + uy * uy;
        const F scale =
            select(square > surface.guess_level * surface.guess_level,
                   surface.guess_e * rough_inverse_root(larger(square, __FLT_MIN__)) + surface.guess_r,
                   all_of<F>(0.0f));
        x_out = ux * scale;
        y_out = uy * scale;
    }

    /// The slope of g at this distance; where it jumps that of one side.
    template <class F>
    FACETMILL_MEMBER F slope_at(const F& rho) const {
        F slope = all_of<F>(0.0f);
        for (int i = 0; i < pieces(); ++i) {
            const RoughPiece& p = surface.rough[i];
            F here = all_of<F>(p.slope0);
            if (is_arc(p)) {
                const F sine = larger((rho - p.e) * p.per_r, 0.0f);
                here = sine * rough_inverse_root(larger(1.0f - sine * sine, 1e-3f));
            }
            slope = i == 0 ? here : select(rho > surface.rough[i - 1].rho1, here, slope);
        }
        return smaller(slope, all_of<F>(float(tolerance::steepest_tangent)));
    }

    /// The highest line of a slope >= 0 that is nowhere above g: its height on the axis. Not a number where
    /// the slope is none.
    template <class F>
    FACETMILL_MEMBER F support(const F& slope) const {
        F at0 = surface.rim_height - slope * radius;
        for (int i = 0; i < pieces(); ++i) {
            const RoughPiece& p = surface.rough[i];
            at0 = smaller(p.z0 - slope * p.rho0, at0);
            if (!is_arc(p)) continue;
            const F on_arc = p.f - p.e * slope - p.r * root(1.0f + slope * slope);
            at0 = select((slope >= p.slope0) & (slope <= p.slope1), smaller(on_arc, at0), at0);
        }
        return at0;
    }

    /// A plane below g that is near it at (mx, my): level + sx x + sy y. On the axis, where g may have a tip,
    /// and at the rim, where g ends, the one of those that is as steep there as the part's plane with slopes
    /// (px, py).
    template <class F>
    FACETMILL_MEMBER void tangent_plane(const F& mx, const F& my, const F& px, const F& py, F& level, F& sx,
                                        F& sy) const {
        const F square = mx * mx + my * my;
        if constexpr (ball) {
            // The slope of a sphere is the distance from the axis over the height of the middle above.
            constexpr auto most = float(tolerance::steepest_tangent);
            const RoughPiece& arc = surface.rough[0];
            const float rr = arc.r * arc.r;
            const F per = (1 - 2 * rough_share) * rough_inverse_root(larger(rr - square, rr / (most * most)));
            sx = mx * per;
            sy = my * per;
            level = arc.f - arc.r * root(1.0f + square * per * per);
            return;
        }
        if constexpr (flat) {
            const F per = (1 - 2 * rough_share) * rough_inverse_root(larger(square, __FLT_MIN__));
            const F ux = mx * per, uy = my * per;
            const F steep = smaller(larger(px * ux + py * uy, 0.0f), float(tolerance::steepest_tangent));
            const F slope = select(square * per >= rim, steep, 0.0f);
            level = surface.rough[0].z0 - slope * radius;
            sx = slope * ux;
            sy = slope * uy;
            return;
        }
        // A little short, so that no direction is longer than 1.
        const F per = (1 - 2 * rough_share) * rough_inverse_root(larger(square, __FLT_MIN__));
        const F rho = square * per;
        const F ux = mx * per, uy = my * per;
        F slope = slope_at(rho);
        const F steep =
            smaller(larger(px * ux + py * uy, slope), all_of<F>(float(tolerance::steepest_tangent)));
        slope = select(rho >= rim, steep, slope);
        level = support(slope);
        sx = slope * ux;
        sy = slope * uy;
        if (surface.rough[0].slope0 > 0) {
            constexpr auto most = float(tolerance::steepest_tangent);
            const float steepest = surface.rough[0].slope0 < most ? surface.rough[0].slope0 : most;
            const auto at_tip = (square <= 0.0f) & (px * px + py * py <= steepest * steepest);
            level = select(at_tip, all_of<F>(surface.rough[0].z0), level);
            sx = select(at_tip, px, sx);
            sy = select(at_tip, py, sy);
        }
    }

    /// The distances from the axis at which a plane of this slope touches, where there are several the least
    /// and the largest.
    FACETMILL_MEMBER Float8 touching(const Float8& slope) const {
        const Float8 sine = slope / root(1.0f + slope * slope);
        Float8 rho = all(float(surface.max_radius));
        for (int i = pieces() - 1; i >= 0; --i) {
            const RoughPiece& p = surface.rough[i];
            if (is_arc(p)) {
                const Float8 on_arc = smaller(larger(p.e + p.r * sine, all(p.rho0)), all(p.rho1));
                rho = select(slope <= p.slope1, on_arc, rho);
            }
            rho = select(slope <= p.slope0, all(p.rho0), rho);
        }
        return rho;
    }
    FACETMILL_MEMBER Float8 touching_last(const Float8& slope) const {
        const Float8 sine = slope / root(1.0f + slope * slope);
        Float8 rho = all(0.0f);
        for (int i = 0; i < pieces(); ++i) {
            const RoughPiece& p = surface.rough[i];
            const Float8 here =
                !is_arc(p) ? all(p.rho1) : smaller(larger(p.e + p.r * sine, all(p.rho0)), all(p.rho1));
            rho = select(slope >= p.slope0, here, rho);
        }
        return rho;
    }

    /// Where, from the axis, a surface can be touched whose slopes lie in rectangles: rectangles that hold
    /// it.
    struct Contact {
        Float8 lo_x, hi_x, lo_y, hi_y;
    };
    FACETMILL_MEMBER Contact contact(const Float8& lo_x, const Float8& hi_x, const Float8& lo_y,
                                     const Float8& hi_y) const {
        const Float8 zero8 = all(0.0f), slack8 = all(float(tolerance::contact_slack * surface.max_radius));
        const Float8 near_x = larger(larger(lo_x, -hi_x), zero8), near_y = larger(larger(lo_y, -hi_y), zero8);
        const Float8 far_x = larger(hi_x, -lo_x), far_y = larger(hi_y, -lo_y);
        const Float8 inner_rho = touching(root(near_x * near_x + near_y * near_y)),
                     outer_rho = touching_last(root(far_x * far_x + far_y * far_y));
        const auto most = [&](const Float8& hi, const Float8& near, const Float8& far)
            __attribute__((always_inline)) {
            const Float8 other = select(hi > 0.0f, near, far);
            const Float8 along = hi * rough_inverse_root(larger(hi * hi + other * other, all(__FLT_MIN__)));
            return along * select(hi > 0.0f, outer_rho, inner_rho) + slack8;
        };
        return {-most(-lo_x, near_y, far_y), most(hi_x, near_y, far_y), -most(-lo_y, near_x, far_x),
                most(hi_y, near_x, far_x)};
    }

    /// Strips in the plan, (x, y) across them, from lo to hi as seen from the place.
    template <class F>
    struct Strips {
        F x, y, lo, hi;

        FACETMILL_MEMBER F across(const F& at_x, const F& at_y) const { return x * at_x + y * at_y; }
        FACETMILL_MEMBER F along(const F& at_x, const F& at_y) const { return x * at_y - y * at_x; }
        /// Moves a point into the strip, across it: over a needle it goes on to where its own slope leads.
        FACETMILL_MEMBER void move_into(F& at_x, F& at_y) const {
            const F at = across(at_x, at_y), shift = smaller(larger(at, lo), hi) - at;
            at_x = at_x + shift * x;
            at_y = at_y + shift * y;
        }
        /// The most that a slope makes between lo and hi, and between these along the strip.
        FACETMILL_MEMBER F most(const F& slope_x, const F& slope_y, const F& lo_along,
                                const F& hi_along) const {
            const F by = across(slope_x, slope_y), to = along(slope_x, slope_y);
            return larger(by * lo, by * hi) + larger(to * lo_along, to * hi_along);
        }
    };
    /// Gives a tangent plane, where wanted, this slope along the strip: then what is long there is level to
    /// it.
    template <class F, class Mask>
    FACETMILL_MEMBER void turn_along(const Strips<F>& strips, const Mask& wanted, const F& slope, F& level,
                                     F& sx, F& sy) const {
        const F by = select(wanted, slope - strips.along(sx, sy), 0.0f);
        sx = sx - by * strips.y;
        sy = sy + by * strips.x;
        level = support(root(sx * sx + sy * sy));
    }
    /// Moves points into the strips along the first edges, the longest, of facets with these corners, and
    /// abreast of these edges. Where that is, as a share of the edge; returns what the cutter may reach.
    FACETMILL_MEMBER Int8 move_into_strip(const Float8 (&px)[3], const Float8 (&py)[3], Float8& mx,
                                          Float8& my, Float8& on_longest) const {
        const Float8 ux = px[1] - px[0], uy = py[1] - py[0], zero8 = all(0.0f);
        const Float8 per_length = 1.0f / root(larger(ux * ux + uy * uy, all(__FLT_MIN__)));
        Strips<Float8> strip{-uy * per_length, ux * per_length, {}, {}};
        const Float8 a = strip.across(px[0], py[0]), b = strip.across(px[2], py[2]);
        strip.lo = smaller(a, b);
        strip.hi = larger(a, b);
        strip.move_into(mx, my);
        const Float8 c = strip.along(px[0], py[0]), d = strip.along(px[1], py[1]);
        const Float8 from = smaller(c, d), to = larger(c, d), at_first = strip.along(mx, my);
        const Float8 at_last = smaller(larger(at_first, from), to);
        mx = mx - (at_last - at_first) * strip.y;
        my = my + (at_last - at_first) * strip.x;
        on_longest = smaller(larger((c - at_last) * per_length, zero8), all(1.0f));
        const Float8 aside = larger(larger(strip.lo, -strip.hi), zero8),
                     ahead = larger(larger(from, -to), zero8), reach = all(radius + slack);
        return aside * aside + ahead * ahead <= reach * reach;
    }
    /// turn_along for facets whose longest edges are these.
    FACETMILL_MEMBER void turn_along_needle(const Float8& ux, const Float8& uy, const Float8& uz,
                                            const Int8& wanted, Float8& level, Float8& sx, Float8& sy) const {
        const Float8 per_length = 1.0f / root(larger(ux * ux + uy * uy, all(__FLT_MIN__)));
        const Strips<Float8> strip{-uy * per_length, ux * per_length, {}, {}};
        const Float8 slope = -uz * per_length;
        const Int8 known = magnitude(slope) < float(tolerance::steepest_roof);
        turn_along(strip, wanted & known, slope, level, sx, sy);
    }
    /// Those of a node's children, for a place from which they are (ax, ay) away.
    FACETMILL_MEMBER Strips<Float8> strips_of(const TreeNode& node, const Float8& ax, const Float8& ay,
                                              const Float8& doubt) const {
        const Float8 x = load(node.across_x), y = load(node.across_y), middle = x * ax + y * ay;
        return {x, y, middle + load(node.strip_lo) - 2 * doubt, middle + load(node.strip_hi) + 2 * doubt};
    }

    /// Bounds of the lifts over eight boxes in the cutter's frame: middle, half size, top, and a roof that
    /// has height `roof` over (rx, ry); with strips only over what lies in those. -inf where the cutter does
    /// not reach.
    template <class F, class AnyDoubt>
    FACETMILL_MEMBER F bounds(const F& cx, const F& cy, const F& hx, const F& hy, const F& top, const F& rx,
                              const F& ry, const F& roof, const F& px, const F& py, const AnyDoubt& doubt,
                              const Strips<F>* strips = nullptr) const {
        const F reach = all_of<F>(radius), wide_x = hx + doubt.slack, wide_y = hy + doubt.slack;
        const F lo_x = larger(cx - wide_x, -reach), hi_x = smaller(cx + wide_x, reach);
        const F lo_y = larger(cy - wide_y, -reach), hi_y = smaller(cy + wide_y, reach);
        const F near_x = larger(larger(lo_x, -hi_x), 0.0f), near_y = larger(larger(lo_y, -hi_y), 0.0f);
        auto reached = (lo_x <= hi_x) & (lo_y <= hi_y) & (near_x * near_x + near_y * near_y <= reach * reach);
        if (strips) reached = reached & (strips->lo <= reach) & (strips->hi >= -reach);
        // The tangent plane of the lift over the roof is taken at the point of the box nearest to where the
        // roof touches the cutter: there the lift is about highest.
        const F per = rough_inverse_root(1.0f + px * px + py * py);
        F mx, my;
        touched(px * per, py * per, mx, my);
        const auto within = (mx >= lo_x) & (mx <= hi_x) & (my >= lo_y) & (my <= hi_y);
        mx = smaller(larger(mx, lo_x), hi_x);
        my = smaller(larger(my, lo_y), hi_y);
        if (strips) strips->move_into(mx, my);
        F level, sx, sy;
        tangent_plane(mx, my, px, py, level, sx, sy);
        if (strips) turn_along(*strips, within, strips->along(px, py), level, sx, sy);
        const F gx = px - sx, gy = py - sy;
        F most = larger(gx * lo_x, gx * hi_x) + larger(gy * lo_y, gy * hi_y);
        if (strips) most = smaller(most, strips->most(gx, gy, -reach, reach));
        const F over = roof - px * rx - py * ry - level + most;
        return select(reached, smaller(over, top) + doubt.of_bound(px, py, sx, sy),
                      all_of<F>(-__builtin_inff()));
    }

    /// g in single precision; rho within the radius.
    template <class F>
    FACETMILL_MEMBER F rough_height(const F& rho) const {
        F g = all_of<F>(0.0f);
        for (int i = 0; i < pieces(); ++i) {
            const RoughPiece& p = surface.rough[i];
            F here;
            if (!is_arc(p)) {
                here = p.z0 + p.slope0 * (rho - p.rho0);
            } else {
                const F out = rho - p.e;
                here = p.f - root(larger((p.r - out) * (p.r + out), 0.0f));
            }
            g = i == 0 ? here : select(rho > surface.rough[i - 1].rho1, here, g);
        }
        return g;
    }
};

} // namespace

} // namespace facetmill::simd
