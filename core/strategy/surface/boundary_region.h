// A boundary of a setup on its part: which facets it has, which contact points lie in it, and how deep a
// place lies in it that is looked at along Z. Millimetres, coordinates of the setup.
//
// On the surface a boundary is a set of facets; a curve, the silhouette and what a tool leaves (tool_rest.h)
// are looked at along Z instead, and have the facets some of which lies in them. In the plan the region is
// the union of its facets looked at along Z, whichever way they face.
#pragma once

#include "core/base/progress.h"
#include "core/cutter/cutter.h"
#include "core/mesh/box_tree.h"
#include "core/setup/boundary.h"
#include "core/strategy/surface/plan_region.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

/// "boundary 'NAME'", as errors say where something is wrong.
std::string boundary_place(const std::string& name);

/// Whether a boundary is looked at along Z; others are facets.
bool is_looked_at_along_z(Boundary::Kind kind);

/// Which facets of the part a boundary has that is painted or a range of slope, 1 or 0 for each. Throws
/// Error(out_of_range, syntax) for painted facets that the part does not have; its place is "boundary
/// 'NAME'".
std::vector<char> boundary_facets(const Boundary& boundary, const Mesh& part);

class BoundaryRegion {
public:
    /// `cutter`: of its tool, for what that leaves; not asked otherwise. Throws what boundary_facets and
    /// ToolRest do, and Error(empty_result) where nothing of the part lies in it.
    BoundaryRegion(const Boundary& boundary, MeshPtr part, const Progress& progress,
                   const std::optional<AptCutter>& cutter = std::nullopt);

    const std::string& name() const { return name_; }
    const std::vector<char>& facets() const { return facets_; }
    /// Its facets as a mesh of their own.
    const MeshPtr& piece() const { return piece_; }
    /// What of the part's surface lies in it, looked at along Z at least `depth` from its border (0: facets
    /// count, not the border), as a mesh that is divided there; edges across the border are at most `longest`
    /// long before that. Throws Error(empty_result) where there is none.
    MeshPtr surface(double depth, double longest, const Progress& progress) const;
    /// Whether the place of the part nearest to p lies in it. `hint`: a facet of the part that may be near,
    /// or no_index; becomes the nearest one.
    bool holds(const Vec3& p, Index& hint) const;
    /// What bounds it looked at along Z, without its offset.
    const std::vector<PlanEdge>& border() const { return plan_.border(); }
    /// How far within the region's border a place lies, looked at along Z; below 0 outside; mm.
    double depth(const Vec2& p) const;

private:
    double distance2(const Vec3& p, std::size_t facet) const;

    std::string name_;
    MeshPtr part_;
    std::vector<char> facets_;
    MeshPtr piece_;
    BoxTree tree_; ///< of the part's facets
    PlanRegion plan_;
    bool by_plan_ = false, inverted_ = false; ///< it is looked at along Z; all but `plan_`
    double offset_ = 0, same_ = 0;            ///< distances that differ by less are the same
};

/// What an operation's tool is kept within.
struct KeptWithin {
    std::shared_ptr<const BoundaryRegion> region;
    Containment contain = Containment::contact;
    double radius = 0; ///< of the cutter

    /// How far within its region the tip has to be, looked at along Z; mm.
    double min_depth() const { return contain == Containment::tool ? radius : 0; }
};

} // namespace facetmill
