#include "core/strategy/cleanup/cut_tree.h"

#include "core/base/golden_section.h"

#include <limits>
#include <numeric>

namespace facetmill {

namespace {

/// Beside a wall motions of all layers are about as near: boxes may be so many times as high as wide.
constexpr double height_share = 0.1;
constexpr std::uint32_t motions_per_check = 1024;
/// Single precision is off by less than so many of its roundings, of the lengths that are computed with.
constexpr double leaf_roundings = 100;

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
    if (end - begin <= leaf_motions) {
        if (cover_.rounded_disc() && cover_.rounded_disc()->disc == 0) make_leaf(nodes_.back());
        return number;
    }
    int axis = 0;
    Vec3 size = node.hi - node.lo;
    size.z() *= height_share;
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

void CutTree::make_leaf(Node& node) {
    node.leaf = std::uint32_t(leaves_.size());
    Leaf& leaf = leaves_.emplace_back();
    for (std::uint32_t k = 0; k < leaf_motions; ++k) {
        // The last stands for those that lack.
        const auto& [a, b] = motions_[order_[std::min(node.begin + k, node.end - 1)]];
        const Vec3 from = a - node.lo, route = b - a;
        for (std::size_t x = 0; x < 3; ++x) {
            leaf.from[x][k] = float(from[Eigen::Index(x)]);
            leaf.route[x][k] = float(route[Eigen::Index(x)]);
        }
        const double level = route.head<2>().squaredNorm(), space = route.squaredNorm();
        leaf.level[k] = level > 0 ? float(1 / level) : 0.0F;
        leaf.space[k] = space > 0 ? float(1 / space) : 0.0F;
        leaf.lower[k] = route.z() > 0 ? 0.0F : 1.0F;
    }
}

/// As `distance` has it. Above the lower end nothing comes nearer than level with the place: there the
/// clamped share is that at which it comes nearest seen from above.
std::pair<CutTree::Lanes, double> CutTree::leaf_squares(const Vec3& p, const Node& node) const {
    const Leaf& leaf = leaves_[node.leaf];
    const auto rounding = float(cover_.rounded_disc()->rounding);
    const Vec3 rel = p - node.lo;
    const Lanes x = float(rel.x()) - leaf.from[0], y = float(rel.y()) - leaf.from[1],
                z = float(rel.z()) - rounding - leaf.from[2];
    const Lanes along = x * leaf.route[0] + y * leaf.route[1];
    const Lanes level = (along * leaf.level).max(0.0F).min(1.0F);
    const Lanes t =
        ((along + z * leaf.route[2]) * leaf.space).max(level.min(leaf.lower)).min(level.max(leaf.lower));
    const Lanes below = (t * leaf.route[2] - z).max(0.0F);
    const double size = (node.hi - node.lo).cwiseAbs().sum() + rel.cwiseAbs().sum() + double(rounding);
    return {(x - t * leaf.route[0]).square() + (y - t * leaf.route[1]).square() + below.square(),
            leaf_roundings * double(std::numeric_limits<float>::epsilon()) * size};
}

double CutTree::distance(const Vec3& p, std::size_t motion) const {
    const auto& [a, b] = motions_[motion];
    const Vec3 rel = p - a, d = b - a;
    // Seen from above the cutter comes nearest in one place, and it reaches deepest at the lower end: in
    // space it is nearest between the two.
    const double square = d.head<2>().squaredNorm(), lower = d.z() > 0 ? 0 : 1,
                 level = square > 0 ? std::clamp(rel.head<2>().dot(d.head<2>()) / square, 0.0, 1.0) : lower;
    const auto at = [&](double t) { return cover_.distance(rel - t * d); };
    if (level == lower || d.z() == 0) return at(level);
    if (cover_.rounded_disc()) return at(rounded_nearest(rel, d, level, lower));
    // The cutter is convex, so its distance falls and rises once along a straight motion.
    const double length = d.norm(), lo = std::min(level, lower), hi = std::max(level, lower);
    return golden_minimum(at, lo, hi, accuracy_ / length, 0).value;
}

double CutTree::rounded_nearest(const Vec3& rel, const Vec3& d, double level, double lower) const {
    const CutterCover::RoundedDisc shape = *cover_.rounded_disc();
    const double disc = shape.disc, rounding = shape.rounding;
    const auto below = [&](double t) { return rounding + t * d.z() - rel.z(); };
    // Beside the shaft.
    if (below(level) <= 0) return level;
    double lo = std::min(level, lower), hi = std::max(level, lower);
    const Vec3 middle = rel - Vec3(0, 0, rounding);
    if (disc == 0) return std::clamp(middle.dot(d) / d.squaredNorm(), lo, hi);
    // Half the slope of the square of the distance from the disc.
    const auto slope = [&](double t) {
        const Vec2 beside = t * d.head<2>() - rel.head<2>();
        const double far = beside.norm();
        return (far > disc ? (1 - disc / far) * beside.dot(d.head<2>()) : 0)
               + std::max(below(t), 0.0) * d.z();
    };
    for (const double accuracy = accuracy_ / d.norm(); hi - lo > accuracy;) {
        const double t = 0.5 * (lo + hi);
        if (t == lo || t == hi) break;
        (slope(t) > 0 ? hi : lo) = t;
    }
    return 0.5 * (lo + hi);
}

} // namespace facetmill
