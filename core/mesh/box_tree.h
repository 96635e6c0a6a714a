// A tree of boxes over things that are known by their boxes.
#pragma once

#include "core/base/progress.h"
#include "core/base/vec.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace facetmill {

/// The square of how far a point is from a box; 0 within it.
inline double squared_distance(const Box3& box, const Vec3& p) {
    return (p - p.cwiseMax(box.lo).cwiseMin(box.hi)).squaredNorm();
}

/// Items are numbers of boxes, in the order in which these were given.
class BoxTree {
public:
    BoxTree() = default;
    BoxTree(const std::vector<Box3>& boxes, const Progress& progress) {
        if (boxes.empty()) return;
        std::vector<std::size_t> order(boxes.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        nodes_.reserve(2 * boxes.size() - 1);
        build(boxes, order, 0, order.size(), progress);
    }

    bool empty() const { return nodes_.empty(); }
    /// Calls visit(item) for each item for whose box, and all boxes around it, enter(box) is true.
    template <class Enter, class Visit>
    void each(Enter&& enter, Visit&& visit) const {
        for (std::size_t i = 0; i < nodes_.size();) {
            const Node& node = nodes_[i];
            const bool in = enter(node.box);
            if (in && node.next == i + 1) visit(node.item);
            i = in ? i + 1 : node.next;
        }
    }

    /// The same until visit(item) is false; whether it never was.
    template <class Enter, class Visit>
    bool each_until(Enter&& enter, Visit&& visit) const {
        for (std::size_t i = 0; i < nodes_.size();) {
            const Node& node = nodes_[i];
            const bool in = enter(node.box);
            if (in && node.next == i + 1 && !visit(node.item)) return false;
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
    template <class Visit>
    void nearest(const Vec3& p, double& near2, Visit&& visit, std::size_t i, double d2) const {
        while (d2 < near2) {
            if (nodes_[i].next == i + 1) return visit(nodes_[i].item);
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
    struct Node {
        Box3 box;
        std::size_t next = 0; ///< the node behind this one and all below it; a leaf has none below
        std::size_t item = 0; ///< leaf
    };
    void build(const std::vector<Box3>& boxes, std::vector<std::size_t>& order, std::size_t begin,
               std::size_t end, const Progress& progress) {
        const std::size_t place = nodes_.size();
        nodes_.emplace_back();
        Box3 all, middles;
        for (std::size_t i = begin; i < end; ++i) {
            all.add(boxes[order[i]]);
            middles.add(boxes[order[i]].center());
        }
        nodes_[place].box = all;
        if (end - begin == 1) {
            nodes_[place].item = order[begin];
        } else {
            if (end - begin > 4096) progress.check();
            int k = 0;
            middles.size().maxCoeff(&k);
            const std::size_t half = begin + (end - begin) / 2;
            const auto at = [&](std::size_t i) { return order.begin() + std::ptrdiff_t(i); };
            std::nth_element(at(begin), at(half), at(end), [&](std::size_t a, std::size_t b) {
                const double x = boxes[a].lo[k] + boxes[a].hi[k], y = boxes[b].lo[k] + boxes[b].hi[k];
                return x < y || (x == y && a < b);
            });
            build(boxes, order, begin, half, progress);
            build(boxes, order, half, end, progress);
        }
        nodes_[place].next = nodes_.size();
    }
    std::vector<Node> nodes_;
};

} // namespace facetmill
