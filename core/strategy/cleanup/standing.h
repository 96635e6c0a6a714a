// What stands over places of the part before a clean-up: the raw material, less what the operations before
// came near to. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/cut_tree.h"
#include "core/strategy/plan/operation.h"

#include <memory>
#include <vector>

namespace facetmill {

class Standing {
public:
    /// Reads PlanContext::stock and `earlier`. What is not above `enough` is not measured further. Motions of
    /// a cutter that is asked about itself, `asked`, are left out: how near it can come is known already.
    /// Places are asked up to `over` above the part.
    Standing(const PlanContext& context, const AptCutter& asked, double enough, double over,
             const Progress& progress);

    /// The motions that came nearest to a place, for places close by. For one thread at a time.
    using Hint = std::vector<std::uint32_t>;

    /// How far the raw material, seen as its box, reaches over a place of the part along the unit normal n;
    /// infinite where it has no end, 0 beside it.
    double raw_over(const Vec3& p, const Vec3& n) const;
    /// What of material so thick over a place was not cut: how far the place is from all motions, no more
    /// than `thick`. Or any thickness that is not above `enough`; and `thick` where that is no nearer than
    /// `asked`.
    double uncut(const Vec3& p, double thick, double asked, Hint& hint) const;
    double uncut(const Vec3& p, double thick) const {
        Hint none;
        return uncut(p, thick, infinity, none);
    }
    /// Does as much as `least` of it stand there? Much sooner known than how much.
    bool stands(const Vec3& p, double thick, double least, Hint& hint) const;
    bool stands(const Vec3& p, double thick, double least) const {
        Hint none;
        return stands(p, thick, least, none);
    }
    /// What counts as nothing, mm.
    double enough() const { return enough_; }

private:
    struct Cuts {
        std::shared_ptr<const EarlierCuts> motions;
        std::unique_ptr<const CutTree> tree;
        double no_nearer; ///< to a place that is asked
    };
    Box3 raw_; ///< empty: without end
    double enough_;
    std::vector<Cuts> cuts_; ///< the last operation first: mostly it came nearest
};

} // namespace facetmill
