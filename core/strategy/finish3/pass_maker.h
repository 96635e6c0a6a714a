// The passes of a planned line: tips along it, close enough together, and what they touch.
#pragma once

#include "core/strategy/finish3/partial_lines.h"

namespace facetmill {

class PassMaker {
public:
    /// `tolerance`: of the tips' path; `normal_limit` (radians): the most that the surface's normal turns
    /// from contact to contact. What is given has to live as long as this; `field` has no bodies.
    PassMaker(const StepOver& stepover, const LiftField& field, const CutterCover& cover,
              const DriveFrame& frame, const LineTolerance& tolerance, double normal_limit)
        : stepover_(stepover), field_(field), cover_(cover), frame_(frame), fine_(tolerance),
          normal_limit_(normal_limit) {}

    /// One for each piece of the domain, in order, from smaller to larger u. Any thread may ask.
    std::vector<Pass> passes(const PlannedLine& line, const Progress& progress) const;
    /// Where a tip that stands on the part touches it.
    CutterContact contact(const Vec3& tip) const {
        return contact_of(tip, field_.lift->contact(tip.x(), tip.y()));
    }

private:
    CutterContact contact_of(const Vec3& tip, const AxialContact& contact) const;
    Pass pass(const std::vector<LinePoint>& points, double v, const Progress& progress) const;

    const StepOver& stepover_;
    LiftField field_;
    const CutterCover& cover_;
    DriveFrame frame_;
    LineTolerance fine_;
    double normal_limit_;
};

} // namespace facetmill
