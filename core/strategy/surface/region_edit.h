// What the user changes of regions on the surface that an operation finds: switched off, grown or shrunk,
// boundary points dragged. Regions are named by places on the part, so that an edit stays with its region
// when settings change.
#pragma once

#include "core/base/parameter.h"

#include <array>
#include <vector>

namespace facetmill {

/// What the user changed of one region: the one that holds `place`, or is nearest to it.
struct RegionEdit {
    std::array<double, 3> place{0, 0, 0}; ///< on the part, mm
    bool enabled = true;                  ///< false: not cut
    double grow = 0;                      ///< outward beyond the offset; inward below 0; mm
    bool operator==(const RegionEdit&) const = default;
};

/// A boundary point that was dragged over the surface.
struct BoundaryDrag {
    std::array<double, 3> from{0, 0, 0}, to{0, 0, 0}; ///< mm
    bool operator==(const BoundaryDrag&) const = default;
};

const ParameterTable<RegionEdit>& region_edit_parameters();
const ParameterTable<BoundaryDrag>& boundary_drag_parameters();
/// Among the parameters of an operation whose regions can be edited.
inline constexpr RecordList<RegionEdit> region_edit_list{"region_edits", region_edit_parameters};
inline constexpr RecordList<BoundaryDrag> boundary_drag_list{"boundary_drags", boundary_drag_parameters};

} // namespace facetmill
