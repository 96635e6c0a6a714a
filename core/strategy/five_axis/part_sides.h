// The sides of a part, as finishing with five axes cuts them: connected pieces of its surface, each with a
// direction from which it is looked at. Drive planes are upright in that view, so that they cross the piece
// at a good angle, whichever way it faces: walls, undersides, both faces of a blade. How the tool stands is
// another matter: the axis is chosen per contact point, among all that machine and part allow.
#pragma once

#include "core/strategy/five_axis/axis_reach.h"
#include "core/strategy/surface/region_field.h"

#include <array>
#include <vector>

namespace facetmill {

/// A piece that is cut by itself.
struct SidePiece {
    PartPiece piece;
    Mat3 view = Mat3::Identity(); ///< turns the part so that the side faces up
    double area = 0;              ///< mm^2
    /// The settings' own; or up to `reach_lead`, from the least by which the piece is reached, where it has
    /// places that these do not reach.
    std::array<double, 2> lead_limits{0, 0};
    /// The settings' own; where these ask for rings `around` for pieces that go round, `morph` for others.
    Finish5Settings::Passes passes = Finish5Settings::Passes::parallel;
};

/// A connected piece of the surface that no axis of the operation reaches.
struct UnreachedPiece {
    double area = 0;                                                   ///< mm^2
    Vec3 place = Vec3::Zero();                                         ///< the middle of its largest facet
    std::array<double, std::size_t(ReachBlock::below) + 1> by_block{}; ///< mm^2 that each keeps the tool from
};

struct PartSides {
    /// Nearly all that can be reached faces up: the part is cut as a whole, from above.
    bool top_only = true;
    std::vector<SidePiece> pieces;             ///< none where `top_only`; the top first
    std::vector<UnreachedPiece> unreached;     ///< the largest first; crumbs left out
    double unreached_area = 0, whole_area = 0; ///< mm^2
    /// Where `top_only`: surface that only leads above the limits reach, and the middle of its largest facet.
    double far_area = 0; ///< mm^2
    Vec3 far_place = Vec3::Zero();
};

/// How pieces that do not go round are cut.
Finish5Settings::Passes passes_but_round(Finish5Settings::Passes asked);

/// Settings for the pieces of a part that is cut side by side: seen from the side the axis comes from above,
/// whichever way a pass travels, so the yaw is free; and the grid is so much coarser that spaces are as large
/// as before.
Finish5Settings side_settings(const Finish5Settings& settings);

PartSides find_sides(const PlanContext& context, const Finish5Settings& settings, const Progress& progress);

} // namespace facetmill
