// Tools beside fixtures: what of a path cutter, shank and holder can cut without coming nearer to them than
// their clearance. Millimetres, part coordinates.
//
// Fixtures are no surface to be cut. Finishing with an upright tool and clean-up are planned as if there were
// none, and their passes end where the tool would come too near. Where a planner chooses postures or layers,
// fixtures are for it a part of what must not be touched, so that it finds ways round them; what rests on a
// fixture all the same is left out here.
#pragma once

#include "core/gouge/axial_lift.h"
#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/holder_reach.h"

#include <string>

namespace facetmill {

/// An upright tool over fixtures.
class FixtureReach {
public:
    /// `fixtures`: grown by their clearance. A straight line that is free where it is looked at, as often as
    /// `spacing`, is nowhere nearer to them than that.
    FixtureReach(const ContactIndexPtr& fixtures, const Tool& tool);

    /// There, and all the way up.
    bool is_free(const Vec3& tip) const;
    double spacing() const { return spacing_; }

private:
    Box3 box_; ///< of tips at which anything could be touched
    AxialLift cutter_;
    HolderReach bodies_;
    double spacing_;
};

/// What an operation's path has to keep off.
struct KeptFixtures {
    ContactIndexPtr grown; ///< by their clearance
    double clearance = 0;  ///< the smallest
    std::string names;     ///< for people
};

/// Leaves out what of the passes is not free of fixtures, and warns of it. Tilted tools may be nearer than
/// the clearance by a tenth of it. Pieces come in an order in which the tool travels less between them, and
/// an upright tool's are kept clear once more of what stands: what is left out stays in the way of shank and
/// holder. `common`: the operation's. Throws Error(empty_result) when nothing is left.
void keep_off_fixtures(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
                       const KeptFixtures& fixtures, const Progress& progress);

} // namespace facetmill
