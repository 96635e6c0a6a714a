#include "core/strategy/cleanup/valley_nodes.h"

#include "core/base/tolerances.h"
#include "core/strategy/cleanup/pencil_probe.h"
#include "core/strategy/cleanup/valley_scale.h"
#include "core/strategy/surface/point_grid.h"

#include <optional>

namespace facetmill {

namespace {

/// Ends nearer to each other than this many steps meet.
constexpr double node_steps = 2;
/// Planes whose normals span less than this meet in no one place.
constexpr double flat_corner = 0.02;
/// What is farther from the touched points than so many radii is no corner under the cutter.
constexpr double corner_reach = 3;
/// What is left ahead of the last centre is looked for up to this angle from the fitted vector, by turns that
/// move the centre by about this share of a step.
constexpr double max_node_turn = 1.2, turn_share = 0.5;
/// A cutter that leaves less than this, of the tolerance, leaves as much as another.
constexpr double alike_direction = 0.1;

/// Where the planes at the touched points meet, if they do in one place.
std::optional<Vec3> corner(const std::vector<Vec3>& touches, const std::vector<Vec3>& normals) {
    Mat3 sum = Mat3::Zero();
    Vec3 right = Vec3::Zero();
    for (std::size_t k = 0; k < touches.size(); ++k) {
        sum += normals[k] * normals[k].transpose();
        right += normals[k] * normals[k].dot(touches[k]);
    }
    if (std::abs(sum.determinant()) < flat_corner) return std::nullopt;
    return Vec3(sum.inverse() * right);
}

class NodeJoiner {
public:
    NodeJoiner(const ValleyInput& input, Valleys& result) : in_(input), out_(result), scale_(input) {}

    void run(const std::vector<std::array<bool, 2>>& open) {
        for (std::size_t c = 0; c < out_.curves.size(); ++c)
            for (std::size_t s = 0; s < 2; ++s)
                if (!out_.curves[c].closed && open[c][s]) ends_.push_back({c, s});
        join_ends();
        PointGrid tips(scale_.radius);
        for (const Valleys::Tip& t : out_.tips)
            tips.add(t.tip);
        for (const EndOf& e : ends_)
            if (out_.curves[e.curve].node[e.side] < 0) turn_ahead(e, tips);
    }

private:
    struct EndOf {
        std::size_t curve, side;
    };

    const PencilPoint& last(const EndOf& e) const {
        const auto& p = out_.curves[e.curve].points;
        return e.side == 0 ? p.front() : p.back();
    }

    /// Puts points on to an end, in order outwards.
    void add_to(const EndOf& e, std::vector<PencilPoint> more) {
        auto& p = out_.curves[e.curve].points;
        if (e.side == 0) {
            std::reverse(more.begin(), more.end());
            p.insert(p.begin(), more.begin(), more.end());
        } else {
            p.insert(p.end(), more.begin(), more.end());
        }
    }

    void join_ends() {
        std::vector<char> taken(ends_.size(), 0);
        for (std::size_t i = 0; i < ends_.size(); ++i) {
            if (taken[i]) continue;
            std::vector<EndOf> group{ends_[i]};
            std::vector<std::size_t> members{i};
            for (std::size_t k = i + 1; k < ends_.size(); ++k)
                if (!taken[k]
                    && (last(ends_[k]).tip - last(ends_[i]).tip).norm() < node_steps * scale_.step) {
                    group.push_back(ends_[k]);
                    members.push_back(k);
                }
            if (group.size() < 2) continue;
            for (const std::size_t m : members)
                taken[m] = 1;
            const auto node = node_of(group);
            if (!node) continue;
            const int number = int(out_.nodes.size());
            out_.nodes.push_back(node->center);
            for (const EndOf& e : group)
                lead_to(*node, number, e);
        }
    }

    /// The corner that some ends have come to: from between the touched points of all of them a ray along the
    /// sum of all normals meets it.
    std::optional<PencilPoint> node_of(const std::vector<EndOf>& group) const {
        std::vector<Vec3> touches, normals;
        Vec3 tip = last(group.front()).tip;
        for (const EndOf& e : group) {
            const PencilPoint& p = last(e);
            if (p.tip.z() > tip.z()) tip = p.tip;
            for (std::size_t s = 0; s < 2; ++s) {
                bool known = false;
                for (const Vec3& t : touches)
                    known = known || (t - p.touch[s]).norm() < PencilProbe::max_move * scale_.radius;
                if (known) continue;
                touches.push_back(p.touch[s]);
                normals.push_back(p.normal[s]);
            }
        }
        PencilPoint node;
        node.tip = tip;
        node.touch = {touches.front(), touches.back()};
        node.normal = {normals.front(), normals.back()};
        node.from = Vec3::Zero();
        Vec3 up = Vec3::Zero();
        for (std::size_t k = 0; k < touches.size(); ++k) {
            node.from += touches[k] / double(touches.size());
            up += normals[k];
        }
        up.z() = std::max(up.z(), 0.0);
        if (up.norm() < tolerance::level_angle) return std::nullopt;
        node.up = up.normalized();
        Vec3 down = -node.up;
        if (const auto meet = corner(touches, normals); meet && (*meet - node.from).dot(down) > 0)
            down = (*meet - node.from).normalized();
        const auto hit = in_.grid->first_hit(node.from, down, corner_reach * scale_.radius);
        if (!hit) return std::nullopt;
        node.on_part = true;
        node.center = node.from + hit->distance * down;
        node.gap = in_.cover->distance(node.center - node.tip);
        // Three flanks that the cutter touches without leaving anything between them are no corner: as where
        // a floor becomes too narrow for it.
        if (!(node.gap > in_.tolerance)) return std::nullopt;
        return node;
    }

    /// Points from an end to a node, on the part: rays from within the same cutter.
    void lead_to(const PencilPoint& node, int number, const EndOf& e) {
        out_.curves[e.curve].node[e.side] = number;
        const PencilPoint from = last(e);
        const double length = (node.center - from.center).norm();
        const auto steps = std::size_t(std::ceil(length / scale_.step));
        std::vector<PencilPoint> more;
        for (std::size_t k = 1; k <= steps; ++k) {
            const double x = double(k) / double(steps);
            PencilPoint p = from;
            p.tip = node.tip;
            p.from = (1 - x) * from.from + x * node.from;
            p.up = ((1 - x) * from.up + x * node.up).normalized();
            const Vec3 aim = (1 - x) * from.center + x * node.center - p.from;
            if (aim.norm() < tolerance::level_angle) continue;
            const auto hit = in_.grid->first_hit(p.from, aim.normalized(), scale_.reach);
            if (!hit) continue;
            p.center = p.from + hit->distance * aim.normalized();
            p.gap = in_.cover->distance(p.center - p.tip);
            p.on_part = true;
            more.push_back(p);
        }
        add_to(e, std::move(more));
    }

    /// Along the curve at an end, outwards, across its fitted vector; zero where it does not say.
    Vec3 ahead_of(const EndOf& e) const {
        const auto& p = out_.curves[e.curve].points;
        const PencilPoint& end = last(e);
        Vec3 ahead = Vec3::Zero();
        for (std::size_t i = 1; i < p.size() && ahead.norm() < scale_.fit; ++i)
            ahead = end.tip - p[e.side == 0 ? i : p.size() - 1 - i].tip;
        ahead -= ahead.dot(end.up) * end.up;
        if (ahead.norm() < tolerance::contact_distance) return Vec3::Zero();
        return ahead.normalized();
    }

    /// Does the cutter at every other place leave as much over q as the one at q's tip?
    bool is_nearest(const PencilPoint& q, const PointGrid& tips) const {
        const double within = 2 * scale_.radius + q.gap;
        return !tips.near_until(q.center, within, [&](std::size_t i) {
            const Vec3& tip = tips.points()[i];
            return (tip - q.tip).norm() > ValleyScale::min_step * scale_.step
                   && in_.cover->distance(q.center - tip) < q.gap - alike_direction * in_.tolerance;
        });
    }

    /// Where a third flank stops the cutter that came along two, the fitted vector may lean back: what is
    /// left ahead of the last centre is the valley's too, until the cutter at another place leaves less, or
    /// none is left.
    void turn_ahead(const EndOf& e, const PointGrid& tips) {
        const PencilPoint end = last(e);
        const Vec3 ahead = ahead_of(e);
        if (ahead == Vec3::Zero()) return;
        const double turn = turn_share * scale_.step / (end.center - end.from).norm();
        std::vector<PencilPoint> more;
        PencilPoint q = end;
        for (double angle = turn; angle < max_node_turn; angle += turn) {
            const Vec3 ray = std::sin(angle) * ahead - std::cos(angle) * end.up;
            const auto hit = in_.grid->first_hit(end.from, ray, scale_.reach);
            if (!hit) break;
            q.center = end.from + hit->distance * ray;
            q.gap = in_.cover->distance(q.center - q.tip);
            if (!(q.gap > in_.tolerance) || !is_nearest(q, tips)) break;
            more.push_back(q);
        }
        add_to(e, std::move(more));
    }

    const ValleyInput& in_;
    Valleys& out_;
    ValleyScale scale_;
    std::vector<EndOf> ends_;
};

} // namespace

void join_valleys(const ValleyInput& input, const std::vector<std::array<bool, 2>>& open, Valleys& valleys) {
    NodeJoiner(input, valleys).run(open);
}

} // namespace facetmill
