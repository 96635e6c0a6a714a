// Lu's local optimum (3.5.5.2): at every contact point by itself the posture nearest in joint-motion time to
// the ideal one. He minimises
//
//   F(λ, ω, δ) = time(posture, ideal) + r (violation of S2 <= δ <= S1)^2,   r = 10000
//
// from the CM2 posture. The ideal axis is any that stays the same along the pass (3.119, Fig. 3-28 c: the
// spindle then travels least). Lu takes Z for all points; but on machines with a head or table that turns
// about Z that is the singular direction, next to which the axes turn most, and nothing ties neighbours
// together. Here it is the axis that the point before has: where it can stay, it stays, and where the
// configuration space does not allow it, it moves by as little as it takes. The time is that of the machine's
// own joints (his 3.122 takes λ and ω for joint angles), and at least
// that of the tip at feed: a flat end that hardly leans is anywhere about its contact point in no joint time
// to speak of. The surfaces are read off the grid between nodes; what comes out is then judged exactly, and
// where it is not free, moved towards the nearest free node as little as it takes.
#include "core/cspace/choose.h"
#include "core/cspace/joint_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

constexpr double penalty = 10000; // Lu's r; lengths in mm, times in s
constexpr int max_steps = 60;
/// The search ends when its steps are this share of the first one.
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
    /// `from`: how the tool stands at the point before.
    LocalSearch(const PassPoint& point, const CSpaceBuilder& builder, const MoveClock& clock,
                const Stand& from, double room)
        : point_(point), builder_(builder), grid_(*builder.input().grid), clock_(clock),
          cutter_(builder.input().lift->cutter()), from_(from), room_(room) {}

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
            const PostureValue middle{0.5 * (outside.lead + inside.posture.lead),
                                      0.5 * (outside.yaw + inside.posture.yaw),
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
        const double lead_step = grid_.lead.size() > 1 ? grid_.lead[1] - grid_.lead[0] : 0;
        const double yaw_step = grid_.yaw.size() > 1 ? grid_.yaw[1] - grid_.yaw[0] : 0;
        double scale = 1;
        for (int step = 0; step < max_steps && scale > last_step_share; ++step) {
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
                        look(held({best.lead + l * scale * lead_step, best.yaw + o * scale * yaw_step,
                                   best.delta}));
            for (const int d : {1, -1})
                look({best.lead, best.yaw, best.delta + d * scale * first_delta_step});
            if (next.lead == best.lead && next.yaw == best.yaw && next.delta == best.delta) scale *= 0.5;
            best = next;
        }
        return best;
    }

    std::optional<PostureValue> best_node() const {
        std::optional<PostureValue> best;
        double least = infinity;
        for (std::size_t l = 0; l < grid_.lead.size(); ++l)
            for (std::size_t o = 0; o < grid_.yaw.size(); ++o) {
                const std::size_t n = grid_.node(l, o);
                if (point_.space->block[n] != PostureBlock::free) continue;
                const PostureValue p{grid_.lead[l], grid_.yaw[o], point_.space->bottom[n]};
                if (const double f = objective(p); f < least) {
                    least = f;
                    best = p;
                }
            }
        return best;
    }

    PostureValue held(PostureValue p) const {
        p.lead = std::clamp(p.lead, grid_.lead.front(), grid_.lead.back());
        p.yaw = std::clamp(p.yaw, grid_.yaw.front(), grid_.yaw.back());
        return p;
    }
    PostureValue start() const {
        PostureValue p = held({point_.cm2_lead, 0, 0});
        p.delta = std::max(between(point_.space->bottom, p), 0.0);
        return std::isfinite(p.delta) ? p : PostureValue{p.lead, 0, 0};
    }

    double between(const std::vector<double>& surface, const PostureValue& p) const {
        const auto [l, s] = place_in(grid_.lead, p.lead);
        const auto [o, t] = place_in(grid_.yaw, p.yaw);
        const std::size_t l1 = std::min(l + 1, grid_.lead.size() - 1),
                          o1 = std::min(o + 1, grid_.yaw.size() - 1);
        const auto weighted = [&](double w, std::size_t node) { return w > 0 ? w * surface[node] : 0.0; };
        return weighted((1 - s) * (1 - t), grid_.node(l, o)) + weighted(s * (1 - t), grid_.node(l1, o))
               + weighted((1 - s) * t, grid_.node(l, o1)) + weighted(s * t, grid_.node(l1, o1));
    }

    double objective(const PostureValue& p) const {
        const double under = std::max(between(point_.space->bottom, p) - p.delta, 0.0);
        const double over = std::max(p.delta - between(point_.space->top, p), 0.0);
        const double f = clock_.to(posture_pose(cutter_, point_.frame, p), from_)
                         + penalty * (under * under + over * over);
        return std::isnan(f) ? infinity : f;
    }

    std::optional<ChosenPosture> judged(PostureValue p) const {
        ToolLift::Hint hint;
        const double bottom = builder_.bottom(point_.frame, p.lead, p.yaw, hint);
        const double top = builder_.top(point_.frame, p.lead, p.yaw, *point_.curves);
        if (!(bottom <= top)) return std::nullopt;
        p.delta = std::clamp(p.delta, bottom, std::max(bottom, top - room_));
        if (!builder_.holds(point_.frame, p)) return std::nullopt;
        return ChosenPosture{true, p};
    }

    /// The free node whose angles are nearest.
    ChosenPosture nearest_node(const PostureValue& from) const {
        ChosenPosture best;
        double least = infinity;
        for (std::size_t l = 0; l < grid_.lead.size(); ++l)
            for (std::size_t o = 0; o < grid_.yaw.size(); ++o) {
                const std::size_t n = grid_.node(l, o);
                if (point_.space->block[n] != PostureBlock::free) continue;
                const PostureValue p{grid_.lead[l], grid_.yaw[o], point_.space->bottom[n]};
                const double away = std::hypot(p.lead - from.lead, p.yaw - from.yaw);
                if (!(away < least) || !builder_.holds(point_.frame, p)) continue;
                least = away;
                best = {true, p};
            }
        return best;
    }

    const PassPoint& point_;
    const CSpaceBuilder& builder_;
    const PostureGrid& grid_;
    const MoveClock& clock_;
    const CutterProfile& cutter_;
    const Stand& from_;
    double room_;
};

} // namespace

std::vector<ChosenPosture> choose_local(std::span<const PassPoint> points, const ChooseInput& input,
                                        const Progress& progress) {
    const CSpaceBuilder& builder = *input.builder;
    const CutterProfile& cutter = builder.input().lift->cutter();
    const MoveClock clock(builder.input().kinematics, input.feed);
    std::optional<Stand> last;
    if (input.before) last = clock.stand(*input.before, nullptr);
    std::vector<ChosenPosture> chosen;
    chosen.reserve(points.size());
    for (const PassPoint& point : points) {
        progress.check();
        if (!last) last = clock.stand(posture_pose(cutter, point.frame, {point.cm2_lead, 0, 0}), nullptr);
        chosen.push_back(point.kept ? ChosenPosture{true, *point.kept}
                                    : LocalSearch(point, builder, clock, *last, input.room).run());
        if (chosen.back().free)
            last = clock.stand(posture_pose(cutter, point.frame, chosen.back().posture), &*last);
    }
    return chosen;
}

} // namespace facetmill
