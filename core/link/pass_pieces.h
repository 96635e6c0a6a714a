// Passes of which only pieces may be cut: what fixtures and boundaries leave of them, put in order again.
// Millimetres, part coordinates.
#pragma once

#include "core/gouge/axial_lift.h"
#include "core/strategy/finish3/left_out.h"
#include "core/strategy/plan/operation.h"

#include <functional>
#include <vector>

namespace facetmill {

/// What of passes may be cut.
struct PassPieces {
    std::vector<Pass> kept;
    double left = 0; ///< length of what may not, mm
    bool all = true;
};

/// True where every tool axis is +Z.
bool is_upright(const std::vector<Pass>& passes);

/// Where an upright cutter touches part, fixtures or whatever else a mesh holds.
class UprightContact {
public:
    UprightContact(const ContactIndexPtr& index, const Tool& tool, double allowance);

    /// The place touched by the tip lowered over its place; where there is nothing below, the tip itself.
    CutterContact at(const Vec3& tip) const;
    /// The same with the number of the facet, or no_index.
    CutterContact at(const Vec3& tip, Index& facet) const;
    const CutterProfile& profile() const { return profile_; }

private:
    ContactIndexPtr index_;
    CutterProfile profile_;
    AxialLift lift_;
};

/// Divides every pass, side by side.
PassPieces divide_passes(const std::vector<Pass>& passes,
                         const std::function<PassPieces(const Pass&, const Progress&)>& divide,
                         const Progress& progress);

/// The pieces of a pass over ranges of its length, but for those shorter than `shortest_piece`.
PassPieces pieces_over(const Pass& pass, std::span<const double> arc, std::vector<Interval> ranges,
                       const UprightContact& contact);
/// The pieces of a pass of its locations for which `may` is true; a piece goes on from one to the next where
/// `joined` is true for the number of the second.
PassPieces pieces_of_locations(const Pass& pass, const std::function<bool(std::size_t)>& may,
                               const std::function<bool(std::size_t)>& joined, const Progress& progress);

/// Puts pieces in an order in which the tool travels less between them. Those of an upright tool (`upright`
/// not null) are kept clear once more of what stands: what is left out stays in the way of shank and holder.
/// Throws Error(empty_result) where nothing is left then.
void settle_pieces(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
                   const UprightContact* upright, const Progress& progress);

} // namespace facetmill
