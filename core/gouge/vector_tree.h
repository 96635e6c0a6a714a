// The contact index as lifts along a vector read it: boxes, and facets by their corners. The one place of
// these lifts that knows how the index lies in memory.
#pragma once

#include "core/gouge/contact_impl.h"

namespace facetmill {

class VectorTree {
public:
    static constexpr std::size_t width = block_width;

    explicit VectorTree(const ContactIndex& index)
        : view_(index.impl().view()), origin_(view_.origin[0], view_.origin[1], view_.origin[2]) {}

    bool empty() const { return view_.nodes == nullptr; }
    static bool is_leaf(Index child) { return (child & TreeNode::leaf) != 0; }

    /// Calls visit(child, middle, half) for the children of a node: boxes, rounded outward; the root is node
    /// 0.
    template <class Visit>
    void children(Index node, Visit&& visit) const {
        const TreeNode& n = view_.nodes[node];
        for (std::size_t lane = 0; lane < width; ++lane)
            if (n.hx[lane] >= 0)
                visit(n.child[lane], Vec3(origin_ + Vec3(n.cx[lane], n.cy[lane], n.cz[lane])),
                      Vec3(n.hx[lane], n.hy[lane], n.hz[lane]));
    }

    /// Calls visit(facet, a, b, c) for the facets of a leaf, corners in the order of the mesh or turned.
    template <class Visit>
    void facets(Index leaf, Visit&& visit) const {
        const FacetBlock& b = view_.blocks[leaf & ~TreeNode::leaf];
        for (std::size_t lane = 0; lane < width; ++lane) {
            if (b.facet[lane] == no_index) continue;
            visit(b.facet[lane], Vec3(b.x[0][lane], b.y[0][lane], b.z[0][lane]),
                  Vec3(b.x[1][lane], b.y[1][lane], b.z[1][lane]),
                  Vec3(b.x[2][lane], b.y[2][lane], b.z[2][lane]));
        }
    }

private:
    IndexView view_;
    Vec3 origin_;
};

} // namespace facetmill
