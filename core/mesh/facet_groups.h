// Facets that belong together, whatever it is that joins them.
#pragma once

#include "core/mesh/mesh.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace facetmill {

/// Every facet is a group at first. A group is known by its first facet.
class FacetGroups {
public:
    explicit FacetGroups(std::size_t facets) : parent_(facets) {
        std::iota(parent_.begin(), parent_.end(), Index(0));
    }
    Index of(Index f) {
        while (parent_[f] != f)
            f = parent_[f] = parent_[parent_[f]];
        return f;
    }
    void join(Index a, Index b) {
        a = of(a);
        b = of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<Index> parent_;
};

} // namespace facetmill
