// Stock that finishing would find too high above the part for its tool, since nothing roughs before it: said
// before minutes of planning end in passes that are left out for the shank.
#pragma once

#include "core/job/planner.h"

#include <memory>
#include <optional>

namespace facetmill {

struct UnroughedStock {
    double highest = 0; ///< of stock over the part's surface, mm
    double reach = 0;   ///< how deep the tool comes into solid stock, mm
    double share = 0;   ///< of the surface that faces up, by area, is deeper below the stock's top than that
};

/// Asks again and again, of the same part mostly: facets are walked once for each part, stock and reach.
class UnroughedLook {
public:
    /// What `unroughed_stock` says.
    std::optional<UnroughedStock> of(const Project& project, const PreparedPart& part,
                                     const Operation& finishing);

private:
    std::weak_ptr<const Mesh> mesh_; ///< of `kept_`, as top and reach
    double top_ = 0, reach_ = 0;
    UnroughedStock kept_;
};

/// What an operation of the shown setup would find, in the setup's coordinates. None where an operation of
/// the setup roughs, where this one is no finishing along the setup's Z, where no more of the surface is deep
/// than may stay uncut, and where how high the stock stands over the part is not known: a mesh, or what the
/// setup before left. Walks all facets.
std::optional<UnroughedStock> unroughed_stock(const Project& project, const PreparedPart& part,
                                              const Operation& finishing);

} // namespace facetmill
