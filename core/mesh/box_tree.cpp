#include "core/mesh/box_tree.h"

#include "core/base/error.h"

#include <limits>

namespace facetmill {

/// Puts the items in the order of the tree, and then makes its nodes.
class BoxTree::Builder {
public:
    Builder(BoxTree& tree, const Progress& progress) : tree_(tree), progress_(progress) {
        const std::size_t n = tree.boxes_.size();
        {
            std::vector<Middle> middles(n);
            for (std::size_t i = 0; i < n; ++i) {
                check(i);
                middles[i] = {tree.boxes_[i].lo + tree.boxes_[i].hi, std::uint32_t(i)};
            }
            halve(middles, 0, n);
            tree.order_.resize(n);
            for (std::size_t i = 0; i < n; ++i)
                tree.order_[i] = middles[i].item;
        }
        sort_boxes();
        std::size_t nodes = 0;
        count(0, n, nodes);
        tree.nodes_.reserve(nodes);
        add_nodes(0, n);
    }

private:
    /// An item, and twice the middle of its box.
    struct Middle {
        Vec3 at;
        std::uint32_t item;
    };

    void check(std::size_t i) const {
        if (i % 65536 == 0) progress_.check();
    }

    void halve(std::vector<Middle>& middles, std::size_t begin, std::size_t end) const {
        if (end - begin < 2) return;
        if (end - begin > 4096) progress_.check();
        Box3 box;
        for (std::size_t i = begin; i < end; ++i)
            box.add(middles[i].at);
        int k = 0;
        box.size().maxCoeff(&k);
        const std::size_t half = half_of(begin, end);
        const auto at = [&](std::size_t i) { return middles.begin() + std::ptrdiff_t(i); };
        std::nth_element(at(begin), at(half), at(end), [k](const Middle& a, const Middle& b) {
            return a.at[k] < b.at[k] || (a.at[k] == b.at[k] && a.item < b.item);
        });
        halve(middles, begin, half);
        halve(middles, half, end);
    }

    /// Boxes into the order of the items, one ring of those that change places after the other.
    void sort_boxes() {
        std::vector<Box3>& boxes = tree_.boxes_;
        std::vector<bool> done(boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            check(i);
            if (done[i]) continue;
            const Box3 first = boxes[i];
            std::size_t to = i;
            for (std::size_t from = tree_.order_[to]; from != i; from = tree_.order_[to]) {
                boxes[to] = boxes[from];
                done[to] = true;
                to = from;
            }
            boxes[to] = first;
            done[to] = true;
        }
    }

    static void count(std::size_t begin, std::size_t end, std::size_t& nodes) {
        ++nodes;
        if (end - begin <= max_in_leaf) return;
        count(begin, half_of(begin, end), nodes);
        count(half_of(begin, end), end, nodes);
    }

    /// Returns the box of what was added.
    Box3 add_nodes(std::size_t begin, std::size_t end) {
        std::vector<Node>& nodes = tree_.nodes_;
        const std::size_t place = nodes.size();
        check(place);
        nodes.emplace_back();
        Box3 box;
        if (end - begin <= max_in_leaf) {
            box = tree_.box_of(begin, end);
            nodes[place].begin = std::uint32_t(begin);
            nodes[place].end = std::uint32_t(end);
        } else {
            box = add_nodes(begin, half_of(begin, end));
            box.add(add_nodes(half_of(begin, end), end));
        }
        nodes[place].box = box;
        nodes[place].next = std::uint32_t(nodes.size());
        return box;
    }

    BoxTree& tree_;
    const Progress& progress_;
};

BoxTree::BoxTree(std::vector<Box3> boxes, const Progress& progress) : boxes_(std::move(boxes)) {
    if (boxes_.size() >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::too_large, "mesh", "has more facets than a tree of their boxes can hold",
                    "use a smaller mesh");
    if (!boxes_.empty()) Builder(*this, progress);
}

} // namespace facetmill
