// A tree of boxes over things that are known by their boxes.
#pragma once

#include "core/base/progress.h"
#include "core/base/vec.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace facetmill {

/// The square of how far a point is from a box; 0 within it.
inline double squared_distance(const Box3& box, const Vec3& p) {
    return (p - p.cwiseMax(box.lo).cwiseMin(box.hi)).squaredNorm();
}

/// Items are numbers of boxes, in the order in which these were given. Takes about 80 bytes for each, and 50
/// more while it is made. Throws Error(too_large) for more than 2^32 - 2 of them.
class BoxTree {
public:
    BoxTree() = default;
    BoxTree(std::vector<Box3> boxes, const Progress& progress);

    bool empty() const { return nodes_.empty(); }
    /// Calls visit(item) for each item for whose box, and all boxes around it, enter(box) is true.
    template <class Enter, class Visit>
    void each(Enter&& enter, Visit&& visit) const {
        each_until(enter, [&](std::size_t item) {
            visit(item);
            return true;
        });
    }

    /// The same until visit(item) is false; whether it never was.
    template <class Enter, class Visit>
    bool each_until(Enter&& enter, Visit&& visit) const {
        for (std::size_t i = 0; i < nodes_.size();) {
            const Node& node = nodes_[i];
            const bool in = enter(node.box), is_leaf = node.next == i + 1;
            if (in && is_leaf) {
                const bool alone = node.end - node.begin == 1;
                for (std::uint32_t k = node.begin; k < node.end; ++k)
                    if ((alone || enter(boxes_[k])) && !visit(std::size_t(order_[k]))) return false;
            }
            i = in ? i + 1 : node.next;
        }
        return true;
    }

    /// Calls visit(item) for each item whose box is nearer to p than the square root of `near2`, which visit
    /// may make smaller; what is nearer comes first, roughly.
    template <class Visit>
    void nearest(const Vec3& p, double& near2, Visit&& visit) const {
        if (!nodes_.empty()) nearest(p, near2, visit, 0, squared_distance(nodes_[0].box, p));
    }

private:
    /// A leaf has a few items, whose own tree, halved as those above are, is not kept.
    static constexpr std::size_t max_in_leaf = 8;

    template <class Visit>
    void nearest(const Vec3& p, double& near2, Visit&& visit, std::size_t i, double d2) const {
        while (d2 < near2) {
            if (nodes_[i].next == i + 1)
                return nearest_in_leaf(p, near2, visit, nodes_[i].begin, nodes_[i].end, d2);
            std::size_t near = i + 1, far = nodes_[i + 1].next;
            double near_d2 = squared_distance(nodes_[near].box, p),
                   far_d2 = squared_distance(nodes_[far].box, p);
            if (far_d2 < near_d2) {
                std::swap(near, far);
                std::swap(near_d2, far_d2);
            }
            nearest(p, near2, visit, near, near_d2);
            i = far;
            d2 = far_d2;
        }
    }
    template <class Visit>
    void nearest_in_leaf(const Vec3& p, double& near2, Visit&& visit, std::size_t begin, std::size_t end,
                         double d2) const {
        while (d2 < near2) {
            if (end - begin == 1) return visit(std::size_t(order_[begin]));
            const std::size_t half = half_of(begin, end);
            const double low_d2 = squared_distance(box_of(begin, half), p),
                         high_d2 = squared_distance(box_of(half, end), p);
            const bool swapped = high_d2 < low_d2;
            nearest_in_leaf(p, near2, visit, swapped ? half : begin, swapped ? end : half,
                            swapped ? high_d2 : low_d2);
            (swapped ? end : begin) = half;
            d2 = swapped ? low_d2 : high_d2;
        }
    }
    static std::size_t half_of(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }
    Box3 box_of(std::size_t begin, std::size_t end) const {
        Box3 box = boxes_[begin];
        for (std::size_t k = begin + 1; k < end; ++k)
            box.add(boxes_[k]);
        return box;
    }

    struct Node {
        Box3 box;
        std::uint32_t next = 0; ///< the node behind this one and all below it; a leaf has none below
        std::uint32_t begin = 0, end = 0; ///< leaf: its items' places in the order
    };
    class Builder;

    std::vector<std::uint32_t> order_; ///< the items
    std::vector<Box3> boxes_;          ///< theirs, in this order
    std::vector<Node> nodes_;
};

} // namespace facetmill
