// What of a contour is cut, as passes: where the cutter touches the part with a slope that is asked for,
// within the operation's boundary. Millimetres, part coordinates.
#pragma once

#include "core/mesh/box_tree.h"
#include "core/strategy/plan/path.h"
#include "core/strategy/surface/boundary_region.h"
#include "core/strategy/waterline/level_contours.h"

#include <functional>

namespace facetmill {

class ContourPasses {
public:
    struct Options {
        Interval slopes;     ///< radians from level
        double chord = 0.01; ///< of the path
        double radius = 1;   ///< of the cutter
        double shoulder = 0; ///< height at which it is that wide
        const KeptWithin* within = nullptr;
        std::size_t facets = 0; ///< of the part
    };
    /// `mesh`: what is touched, the part's facets first.
    ContourPasses(const AxialLift& lift, const TouchTeller& tell, const Mesh& mesh, const Options& options,
                  const Progress& progress);

    /// A pass over all of a closed contour ends where it begins.
    std::vector<Pass> passes(const Contour& contour, double z, const Progress& progress) const;
    /// Where a tip on a contour touches; `left`: towards what is too high there (zero: not known).
    CutterContact contact(const Vec3& tip, const Vec2& left) const;
    /// Whether the tool may go straight from pass to pass within the boundary, lowered onto the surface.
    bool may_link(const Vec3& from, const Vec3& to) const;

private:
    struct Touched {
        CutterContact cc;
        bool wanted = false;
    };
    bool touch(const Vec2& p, const AxialContact& at, Touched& result) const;
    Touched touched(const Vec2& p, double z, const Vec2& left, LiftHint& hint) const;
    std::optional<Vec3> wall_at(const Vec3& p) const;
    bool is_border(Index facet, const Vec3& p) const;
    bool is_within(const Vec2& tip, const Vec3& contact, Index facet) const;
    Pass thinned_pass(std::span<const ContourPlace> places, std::span<const Touched> touched, double z) const;

    const AxialLift& lift_;
    const TouchTeller& tell_;
    const Mesh& mesh_;
    Options options_;
    bool closed_;
    std::vector<char> borders_; ///< of an open mesh, a bit an edge
    BoxTree facets_;            ///< of an open mesh
};

/// The places of a polyline, both ends among them, that those left out lie within `beside` of.
std::vector<std::size_t> kept_places(std::span<const Vec2> line, double beside);

} // namespace facetmill
