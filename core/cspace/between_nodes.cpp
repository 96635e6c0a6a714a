#include "core/cspace/between_nodes.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

/// Axes that are started from, what is found, and turns from one of them, at most.
constexpr std::size_t max_starts = 16, max_found = 4;
constexpr int max_turns = 10;
/// Axes that are started from are farther apart than this many steps of the grid.
constexpr double apart_steps = 1.5;

class BetweenNodes {
public:
    BetweenNodes(const CSpaceBuilder& builder, const CSpace& space, std::span<const RaisedCurve> curves)
        : builder_(builder), grid_(*builder.input().grid), space_(space), curves_(curves),
          step_(std::max(step_of(grid_.lead), step_of(grid_.yaw))) {}

    std::vector<PostureValue> run() const {
        std::vector<PostureValue> found;
        if (0.5 * step_ < finest_between_nodes) return found;
        for (const Vec3& start : starts()) {
            if (const auto at = search(start)) found.push_back(*at);
            if (found.size() == max_found) break;
        }
        return found;
    }

private:
    static double step_of(const std::vector<double>& angles) {
        return angles.size() > 1 ? angles[1] - angles[0] : 0;
    }

    /// Axes of nodes that hold the strip and hit the part, spread over the grid, the nearest to the normal
    /// first. How far a node has to be lifted tells nothing of how near a free one is: a tool that leans far
    /// comes out over a wall sooner than one that stands in a hollow and all but fits.
    std::vector<Vec3> starts() const {
        std::vector<Vec3> chosen;
        const double near = std::cos(apart_steps * step_);
        for (std::size_t l = 0; l < grid_.lead.size(); ++l)
            for (std::size_t o = 0; o < grid_.yaw.size(); ++o) {
                const std::size_t n = grid_.node(l, o);
                if (!(space_.top[n] >= 0) || !(space_.bottom[n] > space_.top[n])
                    || !(space_.bottom[n] < infinity))
                    continue;
                const Vec3 axis = posture_axis(space_.frame, grid_.lead[l], grid_.yaw[o]);
                if (std::any_of(chosen.begin(), chosen.end(),
                                [&](const Vec3& other) { return other.dot(axis) >= near; }))
                    continue;
                chosen.push_back(axis);
                if (chosen.size() == max_starts) return chosen;
            }
        return chosen;
    }

    /// Away from what is hit, and back by half as much where that is then on the other side.
    std::optional<PostureValue> search(Vec3 axis) const {
        Vec3 last = Vec3::Zero();
        double turn = 0.5 * step_;
        for (int k = 0; k < max_turns; ++k) {
            PostureValue p = posture_of_axis(space_.frame, axis);
            p.lead = std::clamp(p.lead, grid_.lead.front(), grid_.lead.back());
            p.yaw = std::clamp(p.yaw, grid_.yaw.front(), grid_.yaw.back());
            axis = posture_axis(space_.frame, p.lead, p.yaw);
            const auto here = builder_.reason(space_.frame, p.lead, p.yaw, curves_);
            p.delta = here.bottom;
            if (here.block == PostureBlock::free) return p;
            if (!(here.top >= 0) || here.contact.body == ToolBody::none) return std::nullopt;
            const Vec3 tip =
                posture_pose(builder_.input().lift->cutter(), space_.frame, {p.lead, p.yaw, 0}).tip;
            Vec3 aside = here.contact.point - tip;
            aside -= aside.dot(axis) * axis;
            const double distance = aside.norm();
            if (!(distance > tolerance::contact_distance)) return std::nullopt;
            aside /= distance;
            if (aside.dot(last) < 0) turn *= 0.5;
            if (turn < finest_between_nodes) return std::nullopt;
            last = aside;
            axis = (std::cos(turn) * axis - std::sin(turn) * aside).normalized();
        }
        return std::nullopt;
    }

    const CSpaceBuilder& builder_;
    const PostureGrid& grid_;
    const CSpace& space_;
    std::span<const RaisedCurve> curves_;
    double step_;
};

} // namespace

std::vector<PostureValue> free_between_nodes(const CSpaceBuilder& builder, const CSpace& space,
                                             std::span<const RaisedCurve> curves) {
    return BetweenNodes(builder, space, curves).run();
}

} // namespace facetmill
