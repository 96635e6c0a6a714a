// The exact test of facets, four at a time.
#pragma once

#include "core/base/tolerances.h"
#include "core/gouge/axial_elements.h"
#include "core/gouge/contact_blocks.h"

namespace facetmill::simd {

namespace {

/// No lift over the facets of a block is higher: that of their highest corner.
FACETMILL_LANES double top_of(const FacetBlock& block) {
    Double4 top = load(block.z[0]);
    for (int k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < block_width; i += double_lanes)
            top = larger(top, load(block.z[k] + i));
    double highest = top[0];
    for (int i = 1; i < double_lanes; ++i)
        highest = top[i] > highest ? top[i] : highest;
    return highest;
}

/// A flat bottom on a level floor touches many facets as high: those are told from higher ones by their own
/// coordinates, which bounds in single precision cannot.
FACETMILL_LANES bool has_flat_bottom(const SurfaceTable& surface) {
    return surface.piece[0].r == 0 && surface.piece[0].slope0 == 0;
}

/// Up to four facets under the exact test, in the cutter's frame.
struct FacetTest {
    alignas(32) double x[3][4], y[3][4], z[3][4];
    alignas(32) double max_lift[4]; ///< bounds of their lifts
    alignas(32) std::int64_t has_edge[3][4], has_plane[4];

    FACETMILL_MEMBER static Mask4 mask(const std::int64_t* m) {
        Mask4 v;
        __builtin_memcpy(&v, m, sizeof v);
        return v;
    }

    FACETMILL_MEMBER void set_duty(unsigned duty, int w) {
        for (int k = 0; k < 3; ++k)
            has_edge[k][w] = duty & (duty_edge << k) ? -1 : 0;
        has_plane[w] = duty & duty_plane ? -1 : 0;
    }

    /// A facet of a block as a vertical cutter at this place sees it.
    FACETMILL_MEMBER void set(const FacetBlock& block, std::uint32_t lane, double at_x, double at_y, int w) {
        for (int k = 0; k < 3; ++k) {
            x[k][w] = block.x[k][lane] - at_x;
            y[k][w] = block.y[k][lane] - at_y;
            z[k][w] = block.z[k][lane];
        }
        set_duty(block.duty[lane], w);
    }

    /// A facet as it lies in its block, to be turned.
    FACETMILL_MEMBER void set_unturned(const FacetBlock& block, std::uint32_t lane, int w) {
        for (int k = 0; k < 3; ++k) {
            x[k][w] = block.x[k][lane];
            y[k][w] = block.y[k][lane];
            z[k][w] = block.z[k][lane];
            has_edge[k][w] = block.duty[lane] & (duty_edge_anyway << k) ? -1 : 0;
        }
    }

    /// Turns the first `taken` facets, as they lie in their blocks, into a frame (rows) at a place.
    FACETMILL_MEMBER void turn(const double (&place)[3], const double (&frame)[3][3], int taken) {
        for (int w = taken; w < double_lanes; ++w)
            for (int k = 0; k < 3; ++k) {
                x[k][w] = x[k][0];
                y[k][w] = y[k][0];
                z[k][w] = z[k][0];
                has_edge[k][w] = 0;
            }
        Double4 px[3], py[3], pz[3], square[3];
        for (int k = 0; k < 3; ++k) {
            const Double4 ax = load(x[k]) - place[0], ay = load(y[k]) - place[1], az = load(z[k]) - place[2];
            px[k] = frame[0][0] * ax + frame[0][1] * ay + frame[0][2] * az;
            py[k] = frame[1][0] * ax + frame[1][1] * ay + frame[1][2] * az;
            pz[k] = frame[2][0] * ax + frame[2][1] * ay + frame[2][2] * az;
        }
        for (int k = 0; k < 3; ++k) {
            const int n = k == 2 ? 0 : k + 1;
            const Double4 ex = px[n] - px[k], ey = py[n] - py[k];
            square[k] = ex * ex + ey * ey;
        }
        // The longest edge first, as the lift over the plane wants it.
        const Mask4 second = square[1] > square[0], third = square[2] > larger(square[1], square[0]);
        const auto store_turned = [&](const Double4(&v)[3], double(&out)[3][4])
            __attribute__((always_inline)) {
            for (int k = 0; k < 3; ++k)
                store(select(third, v[(k + 2) % 3], select(second, v[(k + 1) % 3], v[k])), out[k]);
        };
        store_turned(px, x);
        store_turned(py, y);
        store_turned(pz, z);
        Mask4 edge[3];
        for (int k = 0; k < 3; ++k)
            edge[k] = mask(has_edge[k]);
        for (int k = 0; k < 3; ++k) {
            const Mask4 turned = third ? edge[(k + 2) % 3] : second ? edge[(k + 1) % 3] : edge[k];
            __builtin_memcpy(has_edge[k], &turned, sizeof turned);
        }
        // The coordinates themselves carry rounding from being turned: a projection that it could have made
        // has no area, and then its edges say everything.
        const Double4 x0 = load(x[0]), y0 = load(y[0]);
        const Double4 left = (load(x[1]) - x0) * (load(y[2]) - y0),
                      right = (load(y[1]) - y0) * (load(x[2]) - x0);
        const Double4 area = left - right, noise = tolerance::area_roundings * 0.5 * __DBL_EPSILON__
                                                   * (magnitude(left) + magnitude(right));
        const Mask4 plane = (area > noise) | (area < -noise);
        __builtin_memcpy(has_plane, &plane, sizeof plane);
    }

    /// Places from `taken` on ask for nothing.
    FACETMILL_MEMBER void fill(int taken) {
        for (int w = taken; w < double_lanes; ++w) {
            for (int k = 0; k < 3; ++k) {
                x[k][w] = x[k][0];
                y[k][w] = y[k][0];
                z[k][w] = z[k][0];
                has_edge[k][w] = 0;
            }
            has_plane[w] = 0;
            max_lift[w] = -__builtin_inf();
        }
    }

    /// Lifts and the edges they lie on (-1: the inside) go to consider(lift, edge); those that are not above
    /// floor() are not wanted.
    template <class Floor, class Consider>
    FACETMILL_MEMBER void run(const SurfaceTable& surface, Floor&& floor, Consider&& consider) const {
        const Point4 p[3] = {{load(x[0]), load(y[0]), load(z[0])},
                             {load(x[1]), load(y[1]), load(z[1])},
                             {load(x[2]), load(y[2]), load(z[2])}};
        const PlaneLift4 plane = plane_lift(surface, mask(has_plane), p, tolerance::contact_roundings);
        static constexpr int no_edge[] = {-1, -1, -1, -1};
        consider(plane.lift, no_edge);
        const Mask4 edges[3] = {mask(has_edge[0]), mask(has_edge[1]), mask(has_edge[2])};
        Mask4 open = ~plane.inside & (load(max_lift) > floor());
        // First the edge that the way to the plane's contact leaves by. If it is touched between its ends the
        // facet is done: from a higher place y of the facet a straight way to the plane's contact, on which
        // the lift is nowhere lower than at y, would cross the edge's line where it is higher than its
        // highest.
        const Mask4 first_is_1 = plane.side[1] < plane.side[0];
        const Double4 lower = select(first_is_1, plane.side[1], plane.side[0]);
        const Mask4 first_is_2 = plane.side[2] < lower;
        Mask4 asked_first = open & plane.outside & (edges[0] | edges[1] | edges[2]);
        if (bits(asked_first) != 0) {
            const auto one = [&](const Double4& v0, const Double4& v1, const Double4& v2)
                __attribute__((always_inline)) {
                return select(first_is_2, v2, select(first_is_1, v1, v0));
            };
            const Point4 a{one(p[0].x, p[1].x, p[2].x), one(p[0].y, p[1].y, p[2].y),
                           one(p[0].z, p[1].z, p[2].z)};
            const Point4 b{one(p[1].x, p[2].x, p[0].x), one(p[1].y, p[2].y, p[0].y),
                           one(p[1].z, p[2].z, p[0].z)};
            Lift4 lift = edge_lift(surface, asked_first, a, b, all(0.0));
            const unsigned one_bits = bits(first_is_1), two_bits = bits(first_is_2);
            int edge[double_lanes];
            for (int k = 0; k < double_lanes; ++k)
                edge[k] = two_bits >> k & 1 ? 2 : int(one_bits >> k & 1);
            // What lies on an edge is its owner's to say: the last digits do not depend on who was asked.
            const Mask4 owned = (first_is_2 & edges[2])
                                | (~first_is_2 & ((first_is_1 & edges[1]) | (~first_is_1 & edges[0])));
            lift.tip = select(owned, lift.tip, all(no_lift));
            consider(lift, edge);
            open &= ~lift.between & (load(max_lift) > floor());
        }
        if (bits(open) != 0) {
            const Mask4 was_first[3] = {asked_first & ~first_is_1 & ~first_is_2,
                                        asked_first & first_is_1 & ~first_is_2, asked_first & first_is_2};
            static constexpr int number[3][double_lanes] = {{0, 0, 0, 0}, {1, 1, 1, 1}, {2, 2, 2, 2}};
            for (int k = 0; k < 3; ++k) {
                const Point4 &a = p[k], &b = p[k == 2 ? 0 : k + 1];
                const Mask4 border = plane.border & (plane.side[k] < 0.0);
                const Mask4 asked = open & (edges[k] | border) & ~was_first[k] & (larger(a.z, b.z) > floor());
                if (bits(asked) == 0) continue;
                consider(edge_lift(surface, asked, a, b, select(border, plane.edge_slack, all(0.0))),
                         number[k]);
            }
        }
    }
};

} // namespace

} // namespace facetmill::simd
