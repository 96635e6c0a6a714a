#include "core/link/fixture_reach.h"

#include "core/base/parallel.h"
#include "core/gouge/tool_lift.h"
#include "core/strategy/finish3/left_out.h"
#include "core/strategy/finish3/left_stock.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/surface/lift_line.h"

#include <algorithm>

namespace facetmill {

namespace {

/// What may be nearer between two places that are looked at is kept beyond the clearance: in radii of the
/// cutter. Nothing of a job hangs on the exact distance from a clamp, and so places can be far apart.
constexpr double margin_share = 0.02;

/// What a tilted tool may be nearer than the clearance, in clearances: five-axis planners keep their distance
/// to a share of the chord tolerance.
constexpr double tilted_slack = 0.1;

double widest_of(const Tool& tool, double cutter_radius) {
    double widest = std::max(cutter_radius, tool.shank_length > 0 ? 0.5 * tool.shank_diameter : 0.0);
    for (const HolderSection& s : tool.holder)
        widest = std::max(widest, 0.5 * s.diameter);
    return widest;
}

} // namespace

FixtureReach::FixtureReach(const ContactIndexPtr& fixtures, const Tool& tool)
    : box_(fixtures->mesh().box()), cutter_(fixtures, CutterProfile(tool.cutter()),
                                            margin_share * CutterProfile(tool.cutter()).max_radius()),
      bodies_(fixtures, tool, 0, margin_share * cutter_.profile().max_radius()) {
    const double radius = cutter_.profile().max_radius(), margin = margin_share * radius;
    spacing_ = std::min(safe_spacing(cutter_.profile(), margin), bodies_.spacing());
    const double widest = widest_of(tool, radius) + 2 * margin;
    box_.lo -= Vec3(widest, widest, 0);
    box_.hi += Vec3(widest, widest, 2 * margin);
}

bool FixtureReach::is_free(const Vec3& tip) const {
    // The way up is asked too, so that nothing below the tool's tip is in its way but what reaches over it.
    if (tip.x() < box_.lo.x() || tip.y() < box_.lo.y() || tip.x() > box_.hi.x() || tip.y() > box_.hi.y()
        || tip.z() > box_.hi.z())
        return true;
    LiftHint hint;
    HolderReach::Hints hints;
    return !cutter_.is_above(tip.x(), tip.y(), tip.z(), hint) && bodies_.is_free(tip, hints);
}

namespace {

/// What of passes is free.
struct FreePasses {
    std::vector<Pass> kept;
    double left = 0; ///< length of what is not, mm
    bool all = true;
};

bool is_upright(const std::vector<Pass>& passes) {
    return std::all_of(passes.begin(), passes.end(), [](const Pass& pass) {
        return std::all_of(pass.cl.begin(), pass.cl.end(),
                           [](const CutterLocation& c) { return c.axis == Vec3::UnitZ(); });
    });
}

/// Passes of an upright tool are divided where it comes too near.
class UprightDivider {
public:
    UprightDivider(const PlanContext& context, const KeptFixtures& fixtures)
        : mesh_(context.contact->mesh()), profile_(context.tool.cutter()), lift_(context.contact, profile_),
          reach_(fixtures.grown, context.tool) {}

    FreePasses operator()(const Pass& pass, const Progress& progress) const {
        FreePasses free;
        const std::vector<double> arc = arc_lengths(pass);
        std::vector<Interval> kept = free_ranges(
            pass, arc, reach_.spacing(), [&](const Vec3& tip) { return reach_.is_free(tip); }, progress);
        if (kept.size() == 1 && kept[0].lo <= 0 && kept[0].hi >= arc.back()) {
            free.kept.push_back(pass);
            return free;
        }
        free.all = false;
        std::erase_if(kept,
                      [&](const Interval& r) { return r.length() < shortest_piece * profile_.max_radius(); });
        for (const Interval& r : gaps_between(kept, arc.back()))
            free.left += r.length();
        free.kept = pieces_of(pass, arc, kept, [&](const Vec3& tip) { return contact(tip); });
        return free;
    }

    CutterContact contact(const Vec3& tip) const {
        const AxialContact at = lift_.contact(tip.x(), tip.y());
        if (at.facet == no_index) return {tip, Vec3::UnitZ()};
        const Vec3 n = mesh_.facet_normal(at.facet);
        return {at.point, n.z() < 0 ? Vec3(-n) : n};
    }

private:
    const Mesh& mesh_;
    CutterProfile profile_;
    AxialLift lift_;
    FixtureReach reach_;
};

/// Passes of a tilted tool end at the last location from which the way to the next one is free.
class TiltedDivider {
public:
    TiltedDivider(const PlanContext& context, const KeptFixtures& fixtures)
        : lift_(fixtures.grown, context.tool), slack_(tilted_slack * fixtures.clearance) {}

    FreePasses operator()(const Pass& pass, const Progress& progress) const {
        FreePasses free;
        ToolLift::Hint hint;
        Pass piece = emptied(pass);
        const auto end = [&] {
            if (piece.cl.size() > 1 || piece.cl.size() == pass.cl.size()) free.kept.push_back(piece);
            piece = emptied(pass);
        };
        for (std::size_t i = 0; i < pass.cl.size(); ++i) {
            progress.check();
            const CutterLocation& c = pass.cl[i];
            const bool goes_on = !piece.cl.empty();
            if (goes_on && !keeps_clear_between(lift_, pass.cl[i - 1], c, slack_, slack_, hint)) {
                free.all = false;
                free.left += (c.tip - pass.cl[i - 1].tip).norm();
                end();
            }
            if (lift_.is_deeper({c.tip, c.axis}, slack_, hint)) {
                if (!goes_on && i > 0) free.left += (c.tip - pass.cl[i - 1].tip).norm();
                free.all = false;
                continue;
            }
            piece.cl.push_back(c);
            if (i < pass.cc.size()) piece.cc.push_back(pass.cc[i]);
        }
        if (!piece.cl.empty()) end();
        return free;
    }

private:
    static Pass emptied(Pass pass) {
        pass.cc.clear();
        pass.cl.clear();
        return pass;
    }
    ToolLift lift_;
    double slack_;
};

} // namespace

void keep_off_fixtures(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
                       const KeptFixtures& fixtures, const Progress& progress) {
    std::vector<FreePasses> parts(path.passes.size());
    const auto divide = [&](const auto& divider) {
        parallel_for(path.passes.size(), 1, progress.part(0, 0.7), [&](std::size_t i) {
            if (!path.passes[i].cl.empty()) parts[i] = divider(path.passes[i], progress);
        });
    };
    std::optional<UprightDivider> upright;
    if (is_upright(path.passes)) upright.emplace(context, fixtures);
    if (upright)
        divide(*upright);
    else
        divide(TiltedDivider(context, fixtures));
    FreePasses all;
    for (FreePasses& part : parts) {
        all.left += part.left;
        all.all = all.all && part.all;
        std::move(part.kept.begin(), part.kept.end(), std::back_inserter(all.kept));
    }
    if (all.all) return;
    if (all.kept.empty())
        throw Error(ErrorCode::empty_result, "fixtures",
                    fixtures.names + " would be in the way of all passes, with the clearance",
                    "move what is in the way, make it smaller, or give it less clearance");
    path.passes = std::move(all.kept);
    path.warnings.push_back(fixtures.names + " would be in the way of " + PlanText{context.unit}(all.left)
                            + " of the passes, which are left out");
    const double top = std::max(context.kept_off_box().hi.z(), context.stock_box.hi.z()) + common.clearance;
    order_by_travel(path.passes, false, top, progress.part(0.7, 0.8));
    if (!upright) return;
    const auto clear = keep_clear_of_left_stock(
        path.passes, context, CutterProfile(context.tool.cutter()).max_radius(), common.tolerance,
        [&](const Vec3& tip) { return upright->contact(tip); }, progress.part(0.8, 1));
    if (!clear) return;
    if (path.passes.empty()) refuse_beside_stock(common.name, *clear, context);
    if (clear->left_length > 0) path.warnings.push_back(beside_stock_warning(*clear, context));
}

} // namespace facetmill
