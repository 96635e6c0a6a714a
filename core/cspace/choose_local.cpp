// Lu's local optimum (3.5.5.2): at every contact point by itself the posture nearest in joint-motion time to
// the ideal one. He minimises
//
//   F(lambda, omega, delta) = time(posture, ideal) + r (violation of S2 <= delta <= S1)^2,   r = 10000
//
// from the CM2 posture. The ideal axis is any that stays the same along the pass (3.119, Fig. 3-28 c: the
// spindle's way is then shortest). Lu takes Z; but on machines with a head or table that turns about Z that
// is the singular direction, next to which the axes turn most. Here it is the mean of the pass's CM2 axes.
// The time is that of the machine's own joints (his 3.122 takes lambda and omega for joint angles, see
// core/cspace/README.md). The surfaces are read off the grid between nodes; what comes out is then judged
// exactly, and where it is not free, moved towards the nearest free node as little as it takes.
#include "core/cspace/choose.h"
#include "core/cspace/joint_path.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

constexpr double penalty = 10000; // Lu's r; lengths in mm, times in s
constexpr std::size_t points_per_block = 4;
/// Of the time that the tip takes from the CM2 posture at feed: a flat end that hardly leans is anywhere
/// about its contact point in no joint-motion time to speak of, but the part is cut at feed.
constexpr double near_start_share = 0.5;
constexpr int most_steps = 60;
/// Of the first step: the search ends when its steps are this small.
constexpr double last_step_share = 1.0 / 64;
constexpr int border_halvings = 8;
constexpr double first_delta_step = 0.01; // mm

/// Where a grid value lies: node and share to the next.
std::pair<std::size_t, double> place_in(const std::vector<double>& values, double v) {
    if (values.size() == 1) return {0, 0.0};
    const auto after = std::upper_bound(values.begin() + 1, values.end() - 1, v);
    const auto i = std::size_t(after - values.begin()) - 1;
    return {i, std::clamp((v - values[i]) / (values[i + 1] - values[i]), 0.0, 1.0)};
}

class LocalSearch {
public:
    LocalSearch(const PassPoint& point, const CSpaceBuilder& builder, const JointClock& clock,
                const Vec3& ideal_axis, double feed)
        : point_(point), builder_(builder), grid_(*builder.input().grid), clock_(clock),
          cutter_(builder.input().lift->cutter()), feed_(feed),
          start_tip_(posture_pose(cutter_, point.frame, {point.cm2_lambda, 0, 0}).tip) {
        const PostureValue ideal = posture_of_axis(point.frame, ideal_axis);
        const ToolPose pose = posture_pose(cutter_, point.frame, ideal);
        const JointClock::Ways ways = clock_.ways({pose.tip, ideal_axis});
        if (ways.count > 0) ideal_ = ways.at[0];
    }

    ChosenPosture run() const {
        // From CM2, as Lu does, and from the best node: the objective has valleys with flat floors, one for
        // each axis of the machine that may be the slowest.
        PostureValue best = search(start());
        double least = objective(best);
        if (const auto node = best_node()) {
            const PostureValue other = search(*node);
            if (const double f = objective(other); f < least) {
                least = f;
                best = other;
            }
        }
        if (const auto exact = judged(best)) return *exact;
        // The optimum lies on the border of the space most often, and the grid knows it only so well: back
        // towards a posture that is free, as little as it takes.
        ChosenPosture inside = nearest_node(best);
        if (!inside.free) return inside;
        PostureValue outside = best;
        for (int i = 0; i < border_halvings; ++i) {
            const PostureValue middle{0.5 * (outside.lambda + inside.posture.lambda),
                                      0.5 * (outside.omega + inside.posture.omega),
                                      0.5 * (outside.delta + inside.posture.delta)};
            if (const auto exact = judged(middle))
                inside = *exact;
            else
                outside = middle;
        }
        return inside;
    }

private:
    /// Pattern search by halved steps.
    PostureValue search(PostureValue best) const {
        double least = objective(best);
        const double lambda_step = grid_.lambda.size() > 1 ? grid_.lambda[1] - grid_.lambda[0] : 0;
        const double omega_step = grid_.omega.size() > 1 ? grid_.omega[1] - grid_.omega[0] : 0;
        double scale = 1;
        for (int step = 0; step < most_steps && scale > last_step_share; ++step) {
            PostureValue next = best;
            const auto look = [&](const PostureValue& tried) {
                if (const double f = objective(tried); f < least) {
                    least = f;
                    next = tried;
                }
            };
            for (const int l : {0, 1, -1})
                for (const int o : {0, 1, -1})
                    if (l != 0 || o != 0)
                        look(held({best.lambda + l * scale * lambda_step, best.omega + o * scale * omega_step,
                                   best.delta}));
            for (const int d : {1, -1})
                look({best.lambda, best.omega, best.delta + d * scale * first_delta_step});
            if (next.lambda == best.lambda && next.omega == best.omega && next.delta == best.delta)
                scale *= 0.5;
            best = next;
        }
        return best;
    }

    std::optional<PostureValue> best_node() const {
        std::optional<PostureValue> best;
        double least = infinity;
        for (std::size_t l = 0; l < grid_.lambda.size(); ++l)
            for (std::size_t o = 0; o < grid_.omega.size(); ++o) {
                const std::size_t n = grid_.node(l, o);
                if (point_.space->block[n] != PostureBlock::free) continue;
                const PostureValue p{grid_.lambda[l], grid_.omega[o], point_.space->bottom[n]};
                if (const double f = objective(p); f < least) {
                    least = f;
                    best = p;
                }
            }
        return best;
    }

    PostureValue held(PostureValue p) const {
        p.lambda = std::clamp(p.lambda, grid_.lambda.front(), grid_.lambda.back());
        p.omega = std::clamp(p.omega, grid_.omega.front(), grid_.omega.back());
        return p;
    }
    PostureValue start() const {
        PostureValue p = held({point_.cm2_lambda, 0, 0});
        p.delta = std::max(between(point_.space->bottom, p), 0.0);
        return std::isfinite(p.delta) ? p : PostureValue{p.lambda, 0, 0};
    }

    double between(const std::vector<double>& surface, const PostureValue& p) const {
        const auto [l, s] = place_in(grid_.lambda, p.lambda);
        const auto [o, t] = place_in(grid_.omega, p.omega);
        const std::size_t l1 = std::min(l + 1, grid_.lambda.size() - 1),
                          o1 = std::min(o + 1, grid_.omega.size() - 1);
        const auto weighted = [&](double w, std::size_t node) { return w > 0 ? w * surface[node] : 0.0; };
        return weighted((1 - s) * (1 - t), grid_.node(l, o)) + weighted(s * (1 - t), grid_.node(l1, o))
               + weighted((1 - s) * t, grid_.node(l, o1)) + weighted(s * t, grid_.node(l1, o1));
    }

    double time_to_ideal(const PostureValue& p) const {
        const ToolPose pose = posture_pose(cutter_, point_.frame, p);
        if (!ideal_) return pose.axis.z() > 0 ? 1 - pose.axis.z() : infinity;
        const JointClock::Ways ways = clock_.ways(pose, &*ideal_);
        double least = infinity;
        for (int w = 0; w < ways.count; ++w)
            least = std::min(least, clock_.between(ways.at[std::size_t(w)], *ideal_));
        return least;
    }

    double objective(const PostureValue& p) const {
        const double under = std::max(between(point_.space->bottom, p) - p.delta, 0.0);
        const double over = std::max(p.delta - between(point_.space->top, p), 0.0);
        const Vec3 tip = posture_pose(cutter_, point_.frame, p).tip;
        const double f = time_to_ideal(p) + near_start_share * (tip - start_tip_).norm() / feed_
                         + penalty * (under * under + over * over);
        return std::isnan(f) ? infinity : f;
    }

    bool reachable(const PostureValue& p) const {
        const ToolPose pose = posture_pose(cutter_, point_.frame, p);
        const Kinematics* machine = builder_.input().kinematics;
        return pose.axis.z() >= tolerance::lowest_axis_z && (!machine || machine->reaches(pose));
    }

    std::optional<ChosenPosture> judged(PostureValue p) const {
        ToolLift::Hint hint;
        const double bottom = builder_.bottom(point_.frame, p.lambda, p.omega, hint);
        const double top = builder_.top(point_.frame, p.lambda, p.omega, *point_.curves);
        if (!(bottom <= top)) return std::nullopt;
        p.delta = std::clamp(p.delta, bottom, top);
        if (!reachable(p)) return std::nullopt;
        return ChosenPosture{true, p};
    }

    /// The free node whose angles are nearest.
    ChosenPosture nearest_node(const PostureValue& from) const {
        ChosenPosture best;
        double least = infinity;
        for (std::size_t l = 0; l < grid_.lambda.size(); ++l)
            for (std::size_t o = 0; o < grid_.omega.size(); ++o) {
                const std::size_t n = grid_.node(l, o);
                if (point_.space->block[n] != PostureBlock::free) continue;
                const PostureValue p{grid_.lambda[l], grid_.omega[o], point_.space->bottom[n]};
                const double away = std::hypot(p.lambda - from.lambda, p.omega - from.omega);
                if (!(away < least) || !reachable(p)) continue;
                least = away;
                best = {true, p};
            }
        return best;
    }

    const PassPoint& point_;
    const CSpaceBuilder& builder_;
    const PostureGrid& grid_;
    const JointClock& clock_;
    const CutterProfile& cutter_;
    double feed_;
    Vec3 start_tip_;
    std::optional<JointClock::Times> ideal_;
};

} // namespace

std::vector<ChosenPosture> choose_local(std::span<const PassPoint> points, const ChooseInput& input,
                                        const Progress& progress) {
    const JointClock clock(input.builder->input().kinematics);
    Vec3 sum = Vec3::Zero();
    for (const PassPoint& point : points)
        sum += posture_axis(point.frame, point.cm2_lambda, 0);
    const Vec3 ideal = sum.norm() > tolerance::vanishing_sum * double(points.size()) ? Vec3(sum.normalized())
                                                                                     : Vec3(Vec3::UnitZ());
    std::vector<ChosenPosture> chosen(points.size());
    parallel_for(points.size(), points_per_block, progress.part(0, 0), [&](std::size_t i) {
        chosen[i] = points[i].kept ? ChosenPosture{true, *points[i].kept}
                                   : LocalSearch(points[i], *input.builder, clock, ideal, input.feed).run();
    });
    return chosen;
}

} // namespace facetmill
