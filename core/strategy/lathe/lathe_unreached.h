// Samples of a turning part that no place of the cutter serves, and why. Millimetres, radians.
#pragma once

#include "core/gouge/tool_lift.h"
#include "core/strategy/lathe/lathe_samples.h"

#include <span>

namespace facetmill {

class UnreachedSearch {
public:
    /// `probe` must outlive this.
    UnreachedSearch(const LatheProbe& probe, const ContactIndexPtr& contact);

    /// Those of the samples that no place serves, each with the distance at the best and the reason.
    std::vector<ReachSample> unreached(std::vector<ReachSample> doubtful, const Progress& progress) const;

    /// Looks for a better place than the sample has, from places all around it: downhill alone may end in a
    /// dip that is not the deepest. False where one serves it after all.
    bool search_again(ReachSample& s, LatheField::Hint& hint, const Progress& progress) const;

private:
    struct Lattice;

    Lattice lattice_around(std::span<const ReachSample> samples, const Progress& progress) const;
    bool serve(ReachSample& s, const Lattice& lattice, LatheField::Hint& hint,
               const Progress& progress) const;
    UnreachedRegion::Why reason(const Vec3& p, const Vec3& n, const LathePoint& at) const;
    bool is_covered(const Vec3& p, const Vec3& n) const;

    const LatheProbe& probe_;
    ToolLift needle_;
};

} // namespace facetmill
