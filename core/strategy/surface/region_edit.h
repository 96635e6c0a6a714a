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

/// One of them: in files the members of the lists `region_edits` and `boundary_drags` of an operation.
const ParameterTable<RegionEdit>& region_edit_parameters();
const ParameterTable<BoundaryDrag>& boundary_drag_parameters();

/// An operation whose regions can be edited, beside its parameters.
class TakesRegionEdits {
public:
    static constexpr const char* edits_key = "region_edits";
    static constexpr const char* drags_key = "boundary_drags";
    virtual const std::vector<RegionEdit>& region_edits() const = 0;
    virtual const std::vector<BoundaryDrag>& boundary_drags() const = 0;
    /// Takes them as they are; check_project checks.
    virtual void set_region_edits(std::vector<RegionEdit> edits) = 0;
    virtual void set_boundary_drags(std::vector<BoundaryDrag> drags) = 0;

protected:
    ~TakesRegionEdits() = default;
};

} // namespace facetmill
