// A cutter over a part, and what clean-up is asked of the two.
#pragma once

#include "core/strategy/cleanup/strip_passes.h"
#include "core/strategy/cleanup/valley.h"
#include "tests/property/shapes.h"

namespace facetmill::test {

struct CutterOver {
    CutterOver(const Mesh& mesh, const Tool& tool)
        : part(mesh), context(context_of(mesh, tool)), grid(mesh, Progress()), side(mesh, Progress()),
          profile(tool.cutter()), lift(context.contact, profile), cover(profile, 0.001) {}

    /// Where it leaves more than the tolerance; what waves less than a millimetre along a valley is noise.
    ValleyInput valleys(double tolerance) const {
        ValleyInput in;
        in.mesh = &part;
        in.grid = &grid;
        in.side = &side;
        in.lift = &lift;
        in.cover = &cover;
        in.tolerance = tolerance;
        in.ripple = 1;
        return in;
    }
    StripCutting cutting() const {
        StripCutting with;
        with.mesh = context.part;
        with.grid = &grid;
        with.side = &side;
        with.lift = &lift;
        with.cover = &cover;
        return with;
    }

    const Mesh& part;
    const PlanContext context;
    const FacetGrid grid;
    const UpSide side;
    const CutterProfile profile;
    const AxialLift lift;
    const CutterCover cover;
};

} // namespace facetmill::test
