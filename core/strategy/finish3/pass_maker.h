// The passes of a planned line: tips along it, close enough together, and what they touch.
#pragma once

#include "core/strategy/finish3/partial_lines.h"
#include "core/strategy/finish3/upright_walls.h"

namespace facetmill {

class PassMaker {
public:
    /// `near`: the lift of the cutter grown by the cusp that may stay: what it does not meet is not cut from
    /// there. `tolerance`: of the tips' path; `normal_limit` (radians): the most that the surface's normal
    /// turns from contact to contact. What is given has to live as long as this; `field` has no bodies.
    PassMaker(const StepOver& stepover, const LiftField& field, const AxialLift& near,
              const UprightWalls& walls, const CutterCover& cover, const DriveFrame& frame,
              const LineTolerance& tolerance, double normal_limit)
        : stepover_(stepover), field_(field), near_(near), walls_(walls), cover_(cover), frame_(frame),
          fine_(tolerance), normal_limit_(normal_limit) {}

    /// One for each piece of the domain, in order, from smaller to larger u, without what reaches nothing: a
    /// line serves the places beside it too, so it may go on beyond the part, past the edge of an overhang
    /// for example, where the tool would fall to the floor and take nothing of the part. Any thread may ask.
    std::vector<Pass> passes(const PlannedLine& line, const Progress& progress) const;
    /// Where a tip that stands on the part touches it.
    CutterContact contact(const Vec3& tip) const {
        return contact_of(tip, field_.lift->contact(tip.x(), tip.y()));
    }

private:
    CutterContact contact_of(const Vec3& tip, const AxialContact& contact) const;
    /// The runs of a line's points that the part is within reach of. Beside it the tool goes down to where
    /// its side is as deep as the part's edge or, along an upright wall, the wall's foot, and no farther.
    std::vector<std::vector<LinePoint>> beside_part(std::vector<LinePoint> points, double v) const;
    Pass pass(const std::vector<LinePoint>& points, double v, const Progress& progress) const;

    const StepOver& stepover_;
    LiftField field_;
    const AxialLift& near_;
    const UprightWalls& walls_;
    const CutterCover& cover_;
    DriveFrame frame_;
    LineTolerance fine_;
    double normal_limit_;
};

} // namespace facetmill
