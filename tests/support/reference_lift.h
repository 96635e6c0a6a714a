// The reference for lifts along any vector, of a tool with any axis: slow and obviously right, in extended
// precision, every facet, no closed form, no index and no code of the kernel; of the cutter it takes the APT
// letters only. Two answers from two sides:
//
//  - `reference_lift` maximises: the lift over a point is where the line through it along -v leaves the body,
//    and over a facet, because the body is convex, the maximum of a concave function: one golden-section
//    search inside another.
//  - `reference_bound` proves that no lift is higher: for every vector m with m . v < 0 the plane with normal
//  m
//    that supports the moved body parts it from the facet as soon as s > (H(m) - min m . q) / (-m . v), where
//    H is the body's support function. That bound, for any m whatever, is a proof; the least of all is the
//    lift (convex duality), and is found by one golden-section search inside another too.
#pragma once

#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"

#include <array>
#include <vector>

namespace facetmill::test {

using Real = long double;

struct Real3 {
    Real x = 0, y = 0, z = 0;
};

/// A convex body of revolution straight from the APT letters: corner points and at most one arc in the
/// half-plane (rho, z).
class ReferenceBody {
public:
    /// The cutter with its full height and flat top, raised by `height`.
    explicit ReferenceBody(const AptCutter& cutter, double height = 0);

    /// Support function in direction (mr >= 0, mz).
    Real extent(Real mr, Real mz) const;
    /// How far a point is outside (negative inside), by the most violated of the lines and the arc, and that
    /// one's unit normal. Convex in space.
    struct Outside {
        Real value, nr, nz;
    };
    Outside outside(Real rho, Real z) const;
    /// No point is farther from the tip.
    Real reach() const { return reach_; }

private:
    struct Corner {
        Real rho, z;
    };
    struct Line {
        Real nr, nz, c;
    };
    std::vector<Corner> corners_;
    std::vector<Line> lines_;
    bool rounded_ = false;
    Real e_ = 0, f_ = 0, r_ = 0;                             ///< the arc
    Real start_r_ = 0, start_z_ = 0, end_r_ = 0, end_z_ = 0; ///< its normals at the ends
    Real reach_ = 0;
};

/// Where the tool stands: tip, axis and direction, made unit in extended precision.
struct ReferencePosture {
    ReferencePosture(const Vec3& tip, const Vec3& axis, const Vec3& direction);
    Real3 tip, axis, v;
};

using ReferenceFacet = std::array<Vec3, 3>;

constexpr Real no_lift = -std::numeric_limits<Real>::infinity();

/// The lift over a facet by concave maximisation; no_lift where the body passes it by.
Real reference_lift(const ReferenceBody& body, const ReferencePosture& posture, const ReferenceFacet& facet);

/// The bound that the direction m gives, the body grown by `grow`; +inf when m . v >= 0.
Real bound_of(const ReferenceBody& body, const ReferencePosture& posture, const ReferenceFacet& facet,
              const Vec3& m, Real grow = 0);

/// The least bound, the body grown by `grow` (of either sign); no_lift where a plane along v parts them. The
/// search ends as soon as a bound is at most `enough`.
Real reference_bound(const ReferenceBody& body, const ReferencePosture& posture, const ReferenceFacet& facet,
                     Real grow = 0, Real enough = no_lift);

/// How far `point` is from the facet, and, moved back by `lift`, outside of the body: proof that the lift is
/// at least that.
struct Witness {
    Real from_facet, from_body;
};
Witness witness(const ReferenceBody& body, const ReferencePosture& posture, const ReferenceFacet& facet,
                const Vec3& point, double lift);

/// Outward normal, in part coordinates, of the constraint of the body that is the tightest at `point` moved
/// back by `lift`.
Vec3 normal_at(const ReferenceBody& body, const ReferencePosture& posture, const Vec3& point, double lift);

/// The highest `reference_bound` of all facets of a mesh.
Real reference_bound(const ReferenceBody& body, const ReferencePosture& posture, const Mesh& mesh,
                     Real grow = 0);

} // namespace facetmill::test
