// The part of a cutter that meets a mesh when it comes down its axis, in the form the kernel wants. The
// height g(rho) of the lower surface above the tip is convex and never falls with the distance rho from the
// axis, and it ends at the largest radius. The lift over a point q at distance rho is z(q) - g(rho); over an
// edge or a facet it is the largest of these, and because g is convex it is the maximum of a concave
// function.
#pragma once

#include "core/cutter/cutter.h"

#include <array>
#include <cmath>

namespace facetmill::scalar {

class LowerSurface {
public:
    explicit LowerSurface(const CutterProfile& profile);

    double max_radius() const { return max_radius_; }
    /// g(rho) for 0 <= rho <= max_radius; a little beyond counts as max_radius.
    double height(double rho) const {
        const Piece* p = pieces_.data();
        const Piece* const last = p + count_ - 1;
        while (p != last && rho > p->rho1)
            ++p;
        if (p->r == 0) return p->z0 + p->slope0 * (std::min(rho, p->rho1) - p->rho0);
        const double out = rho - p->e;
        return p->f - std::sqrt(std::max(0.0, (p->r - out) * (p->r + out)));
    }

    /// Where a line touches that passes the axis at distance l and rises by `rise` >= 0 over `run` > 0: the
    /// distance, uphill along the line's projection, from its point nearest to the axis. Needs l <=
    /// max_radius.
    double line_contact(double l, double rise, double run) const;

    /// Where a plane touches whose normal has horizontal part `horizontal` >= 0 and vertical part `vertical`
    /// > 0: the distance from the axis (uphill). The nearest such point where there are many.
    double plane_contact(double horizontal, double vertical) const;

    /// No more than g(rho) for every rho >= 0, by tangents of the convex g: a bound for boxes.
    double bound(double rho) const {
        double b = 0;
        for (const Tangent& t : tangents_)
            b = std::max(b, t.at0 + t.slope * rho);
        return b;
    }

private:
    struct Piece {
        double rho0, rho1;     ///< range of distances
        double slope0, slope1; ///< dg/drho at its ends; +inf where the arc is vertical
        double z0;             ///< line: g(rho0)
        double e, f, r;        ///< arc: centre and radius; r = 0 for a line
    };
    struct Tangent {
        double at0, slope;
    };
    double arc_contact(const Piece& piece, double l, double rise, double run, double s0, double s1) const;

    static constexpr std::size_t max_pieces = 8;
    std::array<Piece, max_pieces> pieces_{};
    std::array<Tangent, 3> tangents_{};
    std::size_t count_ = 0;
    double max_radius_ = 0;
};

} // namespace facetmill::scalar
