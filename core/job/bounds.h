// What an operation's tool keeps off and within: fixtures of the setup, boundaries that the operation names.
#pragma once

#include "core/job/planner.h"
#include "core/link/fixture_reach.h"
#include "core/strategy/surface/boundary_region.h"

#include <map>
#include <memory>
#include <string>

namespace facetmill {

struct OperationBounds {
    ContactIndexPtr contact;                  ///< part, and after its facets what is kept off beside it
    KeptFixtures off;                         ///< `grown` is null where there is nothing
    std::shared_ptr<const KeptWithin> within; ///< null: everywhere
    std::vector<NamedCurves> curves;          ///< that its passes follow
};

/// Another text where an operation's boundaries say something else. Empty where it names none.
std::string bounds_key(const Project& project, const Operation& operation);

/// A boundary that names faces of the part's file as one that has their facets; others as they are. Throws
/// Error(missing_reference) where the file has no faces, Error(syntax, out_of_range); the place is "boundary
/// 'NAME'".
Boundary with_facets_of_faces(const Boundary& boundary, const PreparedPart& part);

/// A boundary that is drawn as a curve, in the plane, looked at along the tool axis that `turn` makes
/// upright.
PlanCurve curve_seen(const Boundary& boundary, const Mat3& turn);

/// Boundaries of a part, each made once.
class BoundsCache {
public:
    /// `turn`: from the setup's coordinates, in which boundaries are said, to those of the part. What is
    /// looked at along Z, outlines and drawn curves, is looked at along the tool axis then, and so are
    /// slopes.
    explicit BoundsCache(const Mat3& turn = Mat3::Identity()) : turn_(turn) {}

    /// What a setup holds: indexes of the part and its fixtures, of the grown fixtures alone (null: none).
    struct Held {
        ContactIndexPtr all, fixtures;
    };
    /// Throws what BoundaryRegion does; Error(limit_exceeded) where too many facets are to be avoided.
    OperationBounds of(const Project& project, const Operation& operation, const PreparedPart& part,
                       const Held& held, const Progress& progress);

private:
    std::shared_ptr<const BoundaryRegion> region(const Project& project, const Boundary& boundary,
                                                 const Progress& progress);
    /// A drawn curve as it is drawn, of another boundary its border, looked at along the tool axis.
    NamedCurves curves(const Project& project, const std::string& name, const Progress& progress);
    void avoid(const Project& project, const Boundary& boundary, double distance, OperationBounds& bounds,
               const Progress& progress);

    Mat3 turn_;
    MeshPtr part_;
    const PreparedPart* prepared_ = nullptr; ///< while `of` runs
    Held held_;
    std::map<std::string, std::shared_ptr<const BoundaryRegion>> regions_;
    std::map<std::string, Held> avoided_;
};

} // namespace facetmill
