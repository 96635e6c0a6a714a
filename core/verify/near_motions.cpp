// What MotionProbes asks of straight motions where many places close together are asked.
#include "core/base/tolerances.h"
#include "core/verify/probes.h"

#include <algorithm>

namespace facetmill {

void NearMotions::clear(const Vec3& center) {
    center_ = center;
    motions_.clear();
    for (std::vector<double>* values : {&x_, &y_, &z_, &height_})
        values->clear();
}

void NearMotions::add(Index motion, const Vec3& normal, double at_center) {
    motions_.push_back(motion);
    x_.push_back(normal.x());
    y_.push_back(normal.y());
    z_.push_back(normal.z());
    height_.push_back(at_center);
}

template <class Bound>
std::span<const NearMotions::Promising> NearMotions::promising(double least, const Bound& bound) {
    const std::size_t n = motions_.size();
    bounds_.resize(n);
    double most = -infinity;
    for (std::size_t k = 0; k < n; ++k)
        bounds_[k] = bound(k);
    for (std::size_t k = 0; k < n; ++k)
        most = std::max(most, bounds_[k]);
    promising_.clear();
    if (!(most > least)) return promising_;
    for (std::size_t k = 0; k < n; ++k)
        if (bounds_[k] > least) promising_.push_back({k, bounds_[k]});
    std::sort(promising_.begin(), promising_.end(), [](const Promising& a, const Promising& b) {
        return a.bound > b.bound || (a.bound == b.bound && a.place < b.place);
    });
    return promising_;
}

bool NearMotions::find(const MotionProbes& probes, const Vec3& center, double radius, double depth,
                       std::span<const Index> among) {
    // As many as are asked faster one after the other than through the tree.
    constexpr std::size_t max_motions = 1024;
    const MotionTree& tree = *probes.tree_;
    const BodySupport& support = probes.support_;
    const double least = depth - radius - tolerance::probe_rounding;
    clear(center);
    if (tree.turns()) return false;
    open_.assign(among.begin(), among.end());
    while (!open_.empty()) {
        const Index at = open_.back();
        open_.pop_back();
        const MotionTree::Node& node = tree.nodes_[at];
        if (node.right != 0) {
            for (const Index child : {node.right, at + 1})
                if (probes.max_depth(tree.nodes_[child], center, least) > least) open_.push_back(child);
            continue;
        }
        const CutterLocation &a = tree.from(node.motion), &b = tree.to(node.motion);
        const Vec3 up = support.middle() * b.axis, route = b.tip - a.tip;
        const double square = route.squaredNorm();
        const double s = square > 0 ? std::clamp((center - up - a.tip).dot(route) / square, 0.0, 1.0) : 0.0;
        const BodySupport::Plane plane = support.nearest(center - a.tip - s * route, b.axis);
        const double along = plane.normal.dot(route);
        const double height = plane.inside + std::max(-s * along, (1 - s) * along);
        if (!(height > least)) continue;
        if (motions_.size() == max_motions) return false;
        add(node.motion, plane.normal, height);
    }
    return true;
}

bool MotionProbes::lower(const Vec3& p, const Vec3& n, LineProbe& probe, NearMotions& near,
                         RecentSweeps& recent) const {
    Line line{p, n};
    line.set(probe.value, slack_);
    const Vec3 off = p - near.center_;
    const auto bound = [&](std::size_t k) {
        const double slope = near.x_[k] * n.x() + near.y_[k] * n.y() + near.z_[k] * n.z();
        return near.inside(k, off) - std::min(slope * line.near, slope * line.far);
    };
    bool lowered = false;
    for (const NearMotions::Promising& next : near.promising(0, bound)) {
        if (lowered && !(bound(next.place) > 0)) continue;
        lowered = ask(near.motions_[next.place], line, probe, &recent) || lowered;
    }
    return lowered;
}

bool MotionProbes::deepen(const Vec3& p, Index hint, DepthProbe& probe, NearMotions& near) const {
    bool deeper = hint != no_index && ask_depth(hint, p, probe);
    const Vec3 off = p - near.center_;
    const auto bound = [&](std::size_t k) { return near.inside(k, off); };
    for (const NearMotions::Promising& next : near.promising(probe.depth, bound)) {
        if (!(next.bound > probe.depth)) break;
        if (near.motions_[next.place] != hint)
            deeper = ask_depth(near.motions_[next.place], p, probe) || deeper;
    }
    return deeper;
}

} // namespace facetmill
