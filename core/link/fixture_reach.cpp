#include "core/link/fixture_reach.h"

#include "core/gouge/tool_lift.h"
#include "core/link/pass_pieces.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/surface/lift_line.h"

#include <algorithm>
#include <optional>

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

/// What of a pass an upright tool may cut.
class UprightDivider {
public:
    UprightDivider(const KeptFixtures& fixtures, const Tool& tool, const UprightContact& contact)
        : reach_(fixtures.grown, tool), contact_(contact) {}

    PassPieces operator()(const Pass& pass, const Progress& progress) const {
        const std::vector<double> arc = arc_lengths(pass);
        return pieces_over(
            pass, arc,
            free_ranges(
                pass, arc, reach_.spacing(), [&](const Vec3& tip) { return reach_.is_free(tip); }, progress),
            contact_);
    }

private:
    FixtureReach reach_;
    const UprightContact& contact_;
};

/// Passes of a tilted tool end at the last location from which the way to the next one is free.
class TiltedDivider {
public:
    TiltedDivider(const PlanContext& context, const KeptFixtures& fixtures)
        : lift_(fixtures.grown, context.tool), slack_(tilted_slack * fixtures.clearance) {}

    PassPieces operator()(const Pass& pass, const Progress& progress) const {
        ToolLift::Hint hint;
        return pieces_of_locations(
            pass,
            [&](std::size_t i) {
                return !lift_.is_deeper({pass.cl[i].tip, pass.cl[i].axis}, slack_, hint);
            },
            [&](std::size_t i) {
                return keeps_clear_between(lift_, pass.cl[i - 1], pass.cl[i], slack_, slack_, hint);
            },
            progress);
    }

private:
    ToolLift lift_;
    double slack_;
};

} // namespace

void keep_off_fixtures(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
                       const KeptFixtures& fixtures, const Progress& progress) {
    std::optional<UprightContact> upright;
    if (is_upright(path.passes)) upright.emplace(context.contact, context.tool, 0);
    const auto divide = [&](const auto& divider) {
        return divide_passes(path.passes, std::cref(divider), progress.part(0, 0.7));
    };
    PassPieces pieces = upright ? divide(UprightDivider(fixtures, context.tool, *upright))
                                : divide(TiltedDivider(context, fixtures));
    if (pieces.all) return;
    if (pieces.kept.empty())
        throw Error(ErrorCode::empty_result, "fixtures",
                    fixtures.names + " would be in the way of all passes, with the clearance",
                    "move what is in the way, make it smaller, or give it less clearance");
    path.passes = std::move(pieces.kept);
    path.warnings.push_back(fixtures.names + " would be in the way of " + PlanText{context.unit}(pieces.left)
                            + " of the passes, which are left out");
    settle_pieces(path, context, common, upright ? &*upright : nullptr, progress.part(0.7, 1));
}

} // namespace facetmill
