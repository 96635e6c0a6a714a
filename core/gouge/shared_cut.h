// Queries that lie close together share the way down the tree: a cut through it below which is all that
// matters to any of them.
#pragma once

#include "core/gouge/contact_blocks.h"

#include <array>

namespace facetmill {

/// A cut through the tree, as a few nodes to start from.
class SharedCut {
public:
    static constexpr std::size_t max_nodes = 4;

    /// Makes the cut as far down as the children for which `reached(node, lane)` is true fit into
    /// `wanted_nodes` <= max_nodes nodes. What is below a child that is not reached must not matter to any of
    /// the queries.
    template <class Reached>
    void make(const IndexView& index, std::size_t wanted_nodes, Reached&& reached) {
        Children children, finer;
        const std::size_t room = wanted_nodes * block_width;
        std::size_t size = 0;
        // False when there are too many.
        const auto add_reached = [&](const TreeNode& node, Children& to, std::size_t& n) {
            for (std::size_t lane = 0; lane < block_width; ++lane) {
                if (!(node.hx[lane] >= 0) || !reached(node, lane)) continue;
                if (n == room) return false;
                to[n++] = {&node, lane};
            }
            return true;
        };
        if (index.nodes) add_reached(index.nodes[0], children, size);
        for (bool divided = true; divided;) {
            divided = false;
            std::size_t n = 0;
            bool fits = true;
            for (std::size_t i = 0; i < size && fits; ++i) {
                const std::uint32_t child = children[i].node->child[children[i].lane];
                if (child & TreeNode::leaf) {
                    fits = n < room;
                    if (fits) finer[n++] = children[i];
                } else {
                    fits = add_reached(index.nodes[child], finer, n);
                    divided = true;
                }
            }
            if (!fits) break;
            children = finer;
            size = n;
        }
        fill(children, size);
    }

    /// True when nothing is reached.
    bool empty() const { return empty_; }
    /// The nodes to start from, at least one.
    const TreeNode* nodes() const { return nodes_.data(); }
    int count() const { return count_; }

private:
    struct Child {
        const TreeNode* node;
        std::size_t lane;
    };
    using Children = std::array<Child, max_nodes * block_width>;
    void fill(const Children& children, std::size_t size);

    std::array<TreeNode, max_nodes> nodes_;
    int count_ = 0;
    bool empty_ = true;
};

} // namespace facetmill
