// The configuration spaces of the contact points of one pass, and the postures that a method chooses in them.
#pragma once

#include "core/cspace/choose.h"
#include "core/strategy/five_axis/five_axis_field.h"

#include <vector>

namespace facetmill {

/// Studies of a row of contact places, in the order of travel. Cannot be copied: the points refer to the
/// other members.
struct PostureStudy {
    std::vector<std::vector<RaisedCurve>> curves;
    std::vector<CSpace> spaces;
    std::vector<PassPoint> points;
    std::vector<char> narrowed;   ///< places whose strip was made narrower, see study_postures
    CSpaceBuilder::Stages stages; ///< processor seconds

    PostureStudy() = default;
    PostureStudy(PostureStudy&&) = default;
    PostureStudy& operator=(PostureStudy&&) = default;
};

/// Postures kept by hand at the places are taken where they are free (PassPoint::kept). Where no posture on
/// the grid clears the strip of a place, for the global choice that by which its width was estimated is taken
/// or those between nodes are looked at (PassPoint::between); where none is found less of the strip is asked
/// for, in the end the pass's own line alone; where that helps, the place has the narrower strip from then
/// on.
PostureStudy study_postures(const FiveAxisField& field, std::vector<ContactPlace>& places,
                            const Progress& progress);

/// `before`: where the tool comes from, the end of the pass before; `next`: the points of the next, if any.
std::vector<ChosenPosture> choose_postures(const FiveAxisField& field, const PostureStudy& study,
                                           Finish5Settings::PostureChoice method,
                                           const std::optional<ToolPose>& before,
                                           std::span<const PassPoint> next, const Progress& progress);

} // namespace facetmill
