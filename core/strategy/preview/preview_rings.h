// Rings about the pieces of a part that go round, as passes of finishing with five axes may (five_axis/
// ring_map.h). Millimetres, coordinates of the view.
//
// They are laid on the part itself, since a ground seen from above has no walls. Where it has many facets,
// its vertices are drawn together cell by cell of a coarse lattice first. What a tool reaches is not asked:
// only what is nearly level and faces down is taken to be what the part stands on.
#pragma once

#include "core/strategy/preview/pass_preview.h"

namespace facetmill {

struct PreviewRings {
    std::vector<std::vector<Vec3>> lines; ///< closed: each ends where it begins, unless it is cut off
    std::vector<char> facets;             ///< per facet of the part: it is on a piece that has rings
    std::size_t passes = 0;
    std::size_t drawn_every = 1; ///< as in PassPreview
    double spacing = 0;          ///< what the lines are true to, mm
};

/// `apart`: between passes, mm. `radius`: of the cutter; pieces of a few of its squares are left out.
PreviewRings preview_rings(const PreviewRequest& request, double apart, double radius,
                           const Progress& progress);

} // namespace facetmill
