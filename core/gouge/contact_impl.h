// The data behind a ContactIndex, for the files of this room.
#pragma once

#include "core/base/large_pages.h"
#include "core/gouge/contact_blocks.h"
#include "core/gouge/contact_index.h"

#include <array>
#include <vector>

namespace facetmill {

struct ContactIndex::Impl {
    LargeVector<FacetBlock> blocks;
    LargeVector<TreeNode> nodes; ///< root first; empty for a mesh without facets
    std::array<double, 3> origin{}, half_size{};
    bool has_strips = false, mostly_needles = false;

    IndexView view() const {
        IndexView v{blocks.data(), nodes.empty() ? nullptr : nodes.data()};
        for (std::size_t k = 0; k < 3; ++k) {
            v.origin[k] = origin[k];
            v.half_size[k] = half_size[k];
        }
        v.has_strips = has_strips;
        v.mostly_needles = mostly_needles;
        return v;
    }
};

} // namespace facetmill
