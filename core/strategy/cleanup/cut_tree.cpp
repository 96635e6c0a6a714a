#include "core/strategy/cleanup/cut_tree.h"

#include "core/base/golden_section.h"

#include <numeric>

namespace facetmill {

namespace {

constexpr std::uint32_t leaf_motions = 8, motions_per_check = 1024;

} // namespace

CutTree::CutTree(const CutterCover& cover, std::span<const Motion> motions, double accuracy,
                 const Progress& progress)
    : cover_(cover), motions_(motions), accuracy_(accuracy), order_(motions_.size()) {
    std::iota(order_.begin(), order_.end(), std::uint32_t(0));
    if (!motions_.empty()) build(0, std::uint32_t(motions_.size()), progress);
}

std::uint32_t CutTree::build(std::uint32_t begin, std::uint32_t end, const Progress& progress) {
    if (end - begin > motions_per_check) progress.check();
    const auto number = std::uint32_t(nodes_.size());
    Node node{Vec3::Constant(infinity), Vec3::Constant(-infinity), begin, end};
    for (std::uint32_t k = begin; k < end; ++k)
        for (const Vec3& tip : motions_[order_[k]]) {
            node.lo = node.lo.cwiseMin(tip);
            node.hi = node.hi.cwiseMax(tip);
        }
    nodes_.push_back(node);
    if (end - begin <= leaf_motions) return number;
    int axis = 0;
    const Vec3 size = node.hi - node.lo;
    size.maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto twice_middle = [&](std::uint32_t m) { return motions_[m][0][axis] + motions_[m][1][axis]; };
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double x = twice_middle(a), y = twice_middle(b);
                         return x < y || (x == y && a < b);
                     });
    build(begin, middle, progress);
    const std::uint32_t further = build(middle, end, progress);
    nodes_[number].further = further;
    return number;
}

double CutTree::distance(const Vec3& p, std::size_t motion) const {
    const auto& [a, b] = motions_[motion];
    const Vec3 rel = p - a, d = b - a;
    const double length = d.norm();
    if (length <= accuracy_) return std::min(cover_.distance(rel), cover_.distance(p - b));
    // The cutter is convex, so its distance falls and rises once along a straight motion.
    const auto at = [&](double t) { return cover_.distance(rel - t * d); };
    return golden_minimum(at, 0, 1, accuracy_ / length, 0).value;
}

} // namespace facetmill
