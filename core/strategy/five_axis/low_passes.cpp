#include "core/strategy/five_axis/low_passes.h"

#include "core/base/tolerances.h"
#include "core/gouge/curve_lift.h"
#include "core/gouge/tool_lift.h"
#include "core/setup/kinematics.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/plan/stock_bottom.h"
#include "core/strategy/surface/point_grid.h"

#include <algorithm>
#include <optional>
#include <span>

namespace facetmill {

namespace {

/// What a raised cutter may stay away from its contact, in radii: farther up a wall the pass above does as
/// well.
constexpr double farthest_share = 0.5;
/// The share of the chord tolerance that motions to raised places may cut, as elsewhere
/// (Finish5Settings::motion_share).
constexpr double raised_motion_share = 0.6;

class LowPasses {
public:
    LowPasses(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
              double holder_clearance)
        : path_(path), lowest_(lowest_allowed(context, common)),
          allowance_(common.allowance + context.tessellation_tolerance[1]),
          lift_(context.contact, context.tool, {allowance_, holder_clearance, holder_clearance}),
          radius_(lift_.cutter().max_radius()), curve_(lift_.cutter()),
          kinematics_(context.machine, gauge_length(context.tool),
                      default_part_origin(context.machine, context.part_box)),
          step_(looking_step(radius_, path.chord_tolerance)), places_(step_) {}

    void run() {
        for (Pass& pass : path_.passes) {
            all_ += pass.cl.size();
            if (is_low(pass)) raise(pass);
        }
    }

    std::size_t all() const { return all_; }
    std::size_t raised() const { return raised_; }
    double deepest() const { return deepest_; } ///< how far below the limit a raised location was, mm

private:
    double below(const CutterLocation& c) const {
        return lowest_ - (c.tip.z() - reach_below_tip(lift_.cutter(), c.axis));
    }
    bool is_low(const CutterLocation& c) const { return below(c) > tolerance::contact_distance; }
    bool is_low(const Pass& pass) const {
        // A pass that is upright all along is raised as a whole (keep_above_bottom).
        const auto leans = [](const CutterLocation& c) { return c.axis != Vec3::UnitZ(); };
        return (std::any_of(pass.cl.begin(), pass.cl.end(), leans)
                || std::any_of(pass.entry.begin(), pass.entry.end(), leans))
               && std::any_of(pass.cl.begin(), pass.cl.end(), [&](const auto& c) { return is_low(c); });
    }

    bool keeps_clear(const CutterLocation& a, const CutterLocation& b) {
        return keeps_clear_between(lift_, a, b, step_, raised_motion_share * path_.chord_tolerance, hint_);
    }

    /// The lowest free place of a location above the limit, if it is of use.
    std::optional<CutterLocation> lifted(const CutterLocation& c, const CutterContact& contact) {
        CutterLocation at = c;
        at.tip.z() += below(c);
        const double in_part = lift_.lift_above({at.tip, at.axis}, 0, radius_, hint_);
        if (!(in_part < radius_)) return std::nullopt;
        at.tip += in_part * at.axis;
        const Vec3 near = contact.point + (allowance_ + farthest_share * radius_) * contact.normal;
        CurveLift::Hint unused;
        if (is_low(at) || !kinematics_.reaches({at.tip, at.axis})
            || !curve_.reaches({at.tip, at.axis}, std::span(&near, 1), unused, 0) || is_cut_there(at))
            return std::nullopt;
        return at;
    }

    /// Whether another pass was raised to about this place.
    bool is_cut_there(const CutterLocation& at) const {
        return places_.near_until(at.tip, step_, [&](std::size_t i) {
            return (places_.points()[i] - at.tip).norm() + radius_ * (axes_[i] - at.axis).norm() <= step_;
        });
    }

    void raise(Pass& pass) {
        Pass made = pass;
        made.cl.clear();
        made.cc.clear();
        std::vector<char> is_raised; // of what was made
        std::vector<double> depths;
        const auto add = [&](std::size_t i, const CutterLocation& c, bool raised) {
            made.cl.push_back(c);
            if (i < pass.cc.size()) made.cc.push_back(pass.cc[i]);
            is_raised.push_back(raised ? 1 : 0);
            depths.push_back(raised ? below(pass.cl[i]) : 0);
        };
        std::size_t last = 0; // location of the pass that was added last
        for (std::size_t i = 0; i < pass.cl.size(); ++i) {
            const CutterLocation& c = pass.cl[i];
            const bool goes_on = !made.cl.empty() && !is_low(made.cl.back());
            if (!is_low(c)) {
                // What does not come back from where it was raised to is not raised.
                if (goes_on && is_raised.back() != 0 && !keeps_clear(made.cl.back(), c)) {
                    made.cl.back() = pass.cl[last];
                    is_raised.back() = 0;
                }
                add(i, c, false);
            } else {
                const auto at = i < pass.cc.size() ? lifted(c, pass.cc[i]) : std::nullopt;
                if (at && goes_on && is_same(made.cl.back(), *at)) continue;
                const bool raised = at && (!goes_on || keeps_clear(made.cl.back(), *at));
                add(i, raised ? *at : c, raised);
            }
            last = i;
        }
        for (std::size_t i = 0; i < made.cl.size(); ++i) {
            if (is_raised[i] == 0) continue;
            places_.add(made.cl[i].tip);
            axes_.push_back(made.cl[i].axis);
            deepest_ = std::max(deepest_, depths[i]);
            ++raised_;
        }
        pass = std::move(made);
    }

    /// Down a wall with one axis all raised locations are the same.
    bool is_same(const CutterLocation& a, const CutterLocation& b) const {
        return (a.tip - b.tip).norm() <= tolerance::contact_distance
               && (a.axis - b.axis).norm() <= tolerance::level_angle;
    }

    StrategyResult& path_;
    double lowest_, allowance_;
    ToolLift lift_;
    double radius_;
    CurveLift curve_;
    Kinematics kinematics_;
    double step_; ///< how closely motions are looked at; places nearer than this are the same
    PointGrid places_;
    std::vector<Vec3> axes_; ///< of `places_`
    ToolLift::Hint hint_;
    std::size_t all_ = 0, raised_ = 0;
    double deepest_ = 0;
};

} // namespace

void raise_low_passes(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
                      double holder_clearance) {
    if (!(path.chord_tolerance > 0)) return; // without one motions to raised places cannot be judged
    LowPasses low(path, context, common, holder_clearance);
    low.run();
    if (low.raised() == 0) return;
    const PlanText text{context.unit, context.to_setup};
    path.warnings.push_back(
        "the leaning cutter is kept from going below the bottom of the stock, by up to " + text(low.deepest())
        + " at " + share_text(double(low.raised()), double(low.all()))
        + " of the points: some material stays there unless 'Below the bottom' allows it");
}

void keep_passes_up(StrategyResult& path, const PlanContext& context, const Operation& operation) {
    raise_low_passes(path, context, operation.common(), operation.holder_clearance());
    keep_above_bottom(path, context, operation.common());
}

} // namespace facetmill
