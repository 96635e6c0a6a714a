// Straight motions of one upright cutter in a tree, and how near the nearest of them comes to a place.
// Millimetres, part coordinates.
#pragma once

#include "core/base/progress.h"
#include "core/base/tolerances.h"
#include "core/strategy/surface/cutter_cover.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace facetmill {

class CutTree {
public:
    using Motion = std::array<Vec3, 2>; ///< tip from, to; the same twice: a place

    /// Distances from motions are known to `accuracy`, and are not too small. The motions must outlive the
    /// tree.
    CutTree(const CutterCover& cover, std::span<const Motion> motions, double accuracy,
            const Progress& progress);

    /// How far a place is from the cutter, taken endless upward, anywhere on a motion.
    double distance(const Vec3& p, std::size_t motion) const;
    /// use(motion, distance) for motions that come nearer to p than `bound`, the nearest about first; what it
    /// returns is the bound from there on.
    template <class Use>
    void nearer(const Vec3& p, double bound, Use&& use) const {
        if (!nodes_.empty() && min_square(p, nodes_.front()) < square_within(bound)) visit(0, p, bound, use);
    }
    /// The distance of the nearest, or of any that is not above `enough`; infinite where none comes nearer
    /// than `limit`.
    double nearest(const Vec3& p, double enough, double limit = infinity) const {
        std::uint32_t none = no_motion;
        return nearest(p, enough, limit, none);
    }
    /// Sooner where the motion that came nearest to a place close by is known: `hint` is that of p then.
    double nearest(const Vec3& p, double enough, double limit, std::uint32_t& hint) const {
        double best = infinity;
        const auto closer = [&](std::size_t m, double d) {
            best = d;
            hint = std::uint32_t(m);
            return d <= enough ? -infinity : d;
        };
        if (hint != no_motion)
            if (const double d = distance(p, hint); d < limit) limit = closer(hint, d);
        nearer(p, limit, closer);
        return best;
    }
    static constexpr std::uint32_t no_motion = 0xFFFFFFFFu;

private:
    struct Node {
        Vec3 lo, hi;               ///< around the tips
        std::uint32_t begin, end;  ///< of order_
        std::uint32_t further = 0; ///< the second child, the first is the next node; 0: a leaf
        std::uint32_t leaf = 0;    ///< of a leaf: which of leaves_
    };
    static constexpr int leaf_motions = 8;
    using Lanes = Eigen::Array<float, leaf_motions, 1>;
    /// The motions of a leaf for a ball, from the node's lowest corner, in single precision: where they
    /// begin, where they go, 1 over the square of their length seen from above and in space, 0 for none, and
    /// the share at which they are lowest.
    struct Leaf {
        std::array<Lanes, 3> from, route;
        Lanes level, space, lower;
    };
    std::uint32_t build(std::uint32_t begin, std::uint32_t end, const Progress& progress);
    /// No motion whose tips are in the box comes nearer: for a rounded disc the square of the distance from
    /// the disc itself, so that no root is taken.
    double min_square(const Vec3& p, const Vec3& lo, const Vec3& hi) const {
        const double x = std::max({lo.x() - p.x(), p.x() - hi.x(), 0.0}),
                     y = std::max({lo.y() - p.y(), p.y() - hi.y(), 0.0});
        // The lowest tip covers what higher ones do.
        const double z = p.z() - lo.z();
        if (!cover_.rounded_disc()) {
            const double d = cover_.distance({x, y, z});
            return d * d;
        }
        const auto [disc, rounding] = *cover_.rounded_disc();
        const double below = std::max(rounding - z, 0.0);
        if (disc == 0) return x * x + y * y + below * below;
        const double beside = std::max(std::sqrt(x * x + y * y) - disc, 0.0);
        return beside * beside + below * below;
    }
    double min_square(const Vec3& p, const Node& node) const { return min_square(p, node.lo, node.hi); }
    /// What `min_square` is less than where something may come nearer than `bound`.
    double square_within(double bound) const {
        if (!(bound > 0)) return 0;
        const double from_disc = bound + (cover_.rounded_disc() ? cover_.rounded_disc()->rounding : 0);
        return (1 + tolerance::float_slack) * from_disc * from_disc;
    }
    /// About the squares of the distances of a leaf's motions from the middle of the ball; they are no larger
    /// than those by more than rounding, for which the second is added to distances.
    std::pair<Lanes, double> leaf_squares(const Vec3& p, const Node& node) const;
    void make_leaf(Node& node);
    template <class Use>
    void visit(std::uint32_t at, const Vec3& p, double& bound, Use& use) const {
        const Node& node = nodes_[at];
        if (node.further == 0) {
            visit_leaf(node, p, bound, use);
            return;
        }
        std::array<std::uint32_t, 2> child{at + 1, node.further};
        std::array<double, 2> from{min_square(p, nodes_[child[0]]), min_square(p, nodes_[child[1]])};
        if (from[1] < from[0]) {
            std::swap(child[0], child[1]);
            std::swap(from[0], from[1]);
        }
        for (const std::size_t k : {0, 1})
            if (from[k] < square_within(bound)) visit(child[k], p, bound, use);
    }
    template <class Use>
    void visit_leaf(const Node& node, const Vec3& p, double& bound, Use& use) const {
        const auto ask = [&](std::uint32_t motion) {
            if (const double d = distance(p, motion); d < bound) bound = use(motion, d);
        };
        if (leaves_.empty()) {
            for (std::uint32_t k = node.begin; k < node.end; ++k) {
                const auto& [a, b] = motions_[order_[k]];
                if (cover_.rounded_disc()
                    || min_square(p, a.cwiseMin(b), a.cwiseMax(b)) < square_within(bound))
                    ask(order_[k]);
            }
            return;
        }
        const auto [squares, slack] = leaf_squares(p, node);
        for (std::uint32_t k = node.begin; k < node.end; ++k)
            if (double(squares[k - node.begin]) < square_within(bound + slack)) ask(order_[k]);
    }

    /// Where on a motion d, 0 to 1, a cutter that is a rounded disc comes nearest to a place, given from the
    /// start: between where it does so seen from above and the lower end.
    double rounded_nearest(const Vec3& rel, const Vec3& d, double level, double lower) const;

    CutterCover cover_;
    std::span<const Motion> motions_;
    double accuracy_;
    std::vector<std::uint32_t> order_; ///< motions, leaf by leaf
    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_; ///< for a ball only
};

} // namespace facetmill
