// What roughing leaves above the allowance where the cutter could have gone: a look at the stock as planned,
// cell by cell, so that what was overlooked is said.
#pragma once

#include "core/gouge/axial_lift.h"
#include "core/strategy/surface/boundary_region.h"
#include "core/strategy/surface/stock_field.h"

namespace facetmill {

struct RemainingInput {
    const Mesh* mesh = nullptr;
    ContactIndexPtr contact;
    const CutterProfile* profile = nullptr;
    const StockField* field = nullptr;
    double allowance = 0;               ///< all that is to stay along the normal
    double lowest_tip = 0;              ///< no layer is lower
    const KeptWithin* within = nullptr; ///< places less than a cutter within its border are not judged
    double allowed = 0; ///< height that is expected; more than a share of it makes a place out of reach
};

struct Remaining {
    /// The most, along the normal, if that is more than expected by more than the field can tell; mm.
    double height = 0;
    Vec3 at = Vec3::Zero(); ///< on the part
    std::size_t places = 0; ///< that were looked at
    std::size_t out_of_reach =
        0;             ///< places that the part keeps the cutter from, where more stays than allowed
    double beyond = 0; ///< the most there
    Vec3 beyond_at = Vec3::Zero();
    std::size_t too_low = 0; ///< places that ask for a tip below the lowest, where more stays than allowed
    double low_height = 0;   ///< the most there
    Vec3 low_at = Vec3::Zero();
};

/// Looks at up to 200 000 cells that the part is seen in from above, flatter than 85 degrees, and at whose
/// facet's plane the cutter could stand; the plane stands for the part round the cell.
Remaining find_remaining(const RemainingInput& input, const Progress& progress);

} // namespace facetmill
