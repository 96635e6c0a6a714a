#include "ui/verdict_advice.h"

#include "core/job/project.h"
#include "core/job/project_setup.h"
#include "core/job/usual_tools.h"
#include "core/strategy/surface/slope_facets.h"
#include "core/strategy/tilt/axis_tilt.h"
#include "core/verify/judged_radius.h"
#include "core/verify/verify.h"
#include "ui/operation_list.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <optional>

namespace facetmill::ui {

namespace {

/// The reason for which most of the surface that counts stays uncut; nullptr: there is none.
const UncutReason* main_reason(const Verification& v) {
    const UncutReason* most = nullptr;
    for (const UncutReason& r : v.uncut)
        if (r.counts() && (!most || r.area > most->area)) most = &r;
    return most;
}

/// Which operations of a setup are there already, of those that could be advised.
struct Present {
    Present(const Project& of, const Verification& v) : project(of), verification(v) {
        for (const Operation* o : operations_on(of)) {
            rough = rough || o->purpose() == Purpose::roughing;
            clean = clean || o->purpose() == Purpose::cleaning;
        }
    }

    /// The tool of the operation of this name where no clean-up has it yet; nullptr: one has.
    const Tool* unused_in_clean_up(const std::string& operation) const {
        const Tool* tool = nullptr;
        for (const Operation* o : operations_on(project))
            if (o->common().name == operation) tool = find_tool(project.tools, o->common().tool);
        for (const Operation* o : operations_on(project))
            if (tool && o->purpose() == Purpose::cleaning && o->common().tool == tool->number) return nullptr;
        return tool;
    }

    /// The narrowest that finishes or cleans up, where one that can be bought is narrower yet; nullptr: none,
    /// or nothing cleans up. `too_fine`: nobody could judge what that one leaves.
    const Tool* last_but_narrowest(bool& too_fine) const {
        const Tool* last = nullptr;
        for (const Operation* o : operations_on(project)) {
            const Tool* tool = find_tool(project.tools, o->common().tool);
            if (clean && o->purpose() != Purpose::roughing && tool
                && (!last || tool->diameter < last->diameter))
                last = tool;
        }
        if (!last) return nullptr;
        const NewOperation next = new_operation("cleanup", project, {{}, last->number});
        const Tool& tool = next.tool ? *next.tool : project.tool_of(*next.operation);
        too_fine = verification.surface
                   && !can_be_judged(0.5 * tool.diameter, *verification.surface, verification.used);
        return !next.tool || usual_diameter(next.tool->diameter, project.unit) <= next.tool->diameter
                   ? last
                   : nullptr;
    }

    /// The operation of this name where its tool could lean, and may not; nullptr: it cannot, or may.
    const Operation* could_lean(const std::string& operation) const {
        for (const Operation* o : operations_on(project)) {
            if (o->common().name != operation || !o->has("tilt_limit")) continue;
            const Tool* tool = find_tool(project.tools, o->common().tool);
            if (!tool || ball_radius(CutterProfile(tool->cutter())) == 0 || !o->three_axis()) return nullptr;
            return project_machine(project).rotary.size() == 2 ? o : nullptr;
        }
        return nullptr;
    }

    const Project& project;
    const Verification& verification;
    bool rough = false, clean = false;
};

/// What finishes cut by their limits of slope, and whose limits these are; null: one of them cuts all that
/// is so steep, or so level.
struct FinishedSlopes {
    explicit FinishedSlopes(const Project& project) {
        bool all_steep = false, all_level = false;
        for (const Operation* o : operations_on(project)) {
            if (o->purpose() != Purpose::finishing) continue;
            const Interval slopes = slope_limits_of(*o).value_or(Interval{0, 0.5 * pi});
            all_steep = all_steep || slopes.hi > radians(85);
            all_level = all_level || slopes.lo < radians(5);
            if (!steepest || slopes.hi > cut.hi) {
                steepest = o;
                cut.hi = slopes.hi;
            }
            if (!shallowest || slopes.lo < cut.lo) {
                shallowest = o;
                cut.lo = slopes.lo;
            }
        }
        if (all_steep) steepest = nullptr;
        if (all_level) shallowest = nullptr;
    }

    Interval cut;
    const Operation *steepest = nullptr, *shallowest = nullptr;
};

/// What two finishes both cut where one ends and the other begins.
const double slopes_shared = radians(5);

/// Most of what stays is steeper, or more level, than any finish cuts: another one for that.
std::optional<VerdictAdvice> beyond_slopes(const Verification& v, const UncutReason& reason,
                                           const Project& project) {
    using Why = UncutReason::Why;
    if (reason.why != Why::not_cut && reason.why != Why::passes_apart) return std::nullopt;
    const FinishedSlopes finished(project);
    double all = 0, steep = 0, level = 0;
    for (const SlopeBand& band : v.bands) {
        const double uncut = band.figures.area * band.figures.uncut_fraction;
        all += uncut;
        if (finished.steepest && band.to > finished.cut.hi) steep += uncut;
        if (finished.shallowest && band.from < finished.cut.lo) level += uncut;
    }
    if (finished.steepest && steep > 0.5 * all)
        return VerdictAdvice{
            tr("What to do: add %1, which goes round what is steeper than %2 cuts.")
                .arg(text(first_name_of("waterline")), text(finished.steepest->common().name)),
            "waterline",
            {finished.steepest->common().tool, {}, finished.cut.hi - slopes_shared}};
    if (finished.shallowest && level > 0.5 * all)
        return VerdictAdvice{
            tr("What to do: add %1, which cuts what is more level than %2 does.")
                .arg(text(first_name_of("scallop")), text(finished.shallowest->common().name)),
            "scallop",
            {finished.shallowest->common().tool}};
    return std::nullopt;
}

VerdictAdvice advice_on(const Collision& c, const Present& there) {
    if (!c.fixture.empty())
        return {tr("What to do: move the fixture, or keep the operation out of its way by a boundary."), {}};
    if (c.kind == Collision::Kind::cutter || c.kind == Collision::Kind::rapid)
        return {tr("What to do: raise the clearance of the operation that the list names."), {}};
    if (c.with_part)
        return {tr("What to do: a longer shank or flutes, a slimmer holder, or the part laid another way."),
                {}};
    if (there.rough)
        return {tr("What to do: a tool with longer flutes, or a smaller allowance in Rough."), {}};
    return {tr("What to do: add Rough before it, so that less stock stands there, or take a tool with longer "
               "flutes."),
            "rough"};
}

/// No tool is narrow enough.
VerdictAdvice advice_for_hollows(const Present& there) {
    bool too_fine = false;
    if (const Tool* last = there.last_but_narrowest(too_fine)) {
        if (too_fine)
            return {tr("What to do: accept what stays, by Uncut limit in Verification limits: what a smaller "
                       "tool than %1 leaves on a part so large is too fine to be judged.")
                        .arg(text(last->name)),
                    {}};
        return {tr("What to do: add another Clean-up, with a smaller tool after %1; or accept what stays, "
                   "by Uncut limit in Verification limits.")
                    .arg(text(last->name)),
                "cleanup",
                {{}, last->number}};
    }
    if (there.clean)
        return {tr("What to do: a smaller tool in Clean-up; or accept what stays, by Uncut limit in "
                   "Verification limits."),
                {}};
    return {tr("What to do: add Clean-up, which takes a smaller tool; or accept what stays, by Uncut "
               "limit in Verification limits."),
            "cleanup"};
}

VerdictAdvice advice_on(const UncutReason& r, const Present& there) {
    using Why = UncutReason::Why;
    switch (r.why) {
    case Why::no_tool:
        return advice_for_hollows(there);
    case Why::no_operation:
        if (const Tool* fits = there.unused_in_clean_up(r.program))
            return {tr("What to do: add Clean-up with %1, which fits there.").arg(text(fits->name)),
                    "cleanup",
                    {fits->number, {}}};
        return {tr("What to do: a finish with the tool that fits; or accept what stays, by Uncut limit in "
                   "Verification limits."),
                {}};
    case Why::not_cut:
    case Why::passes_apart:
        if (there.clean) return {tr("What to do: finish with a smaller tolerance."), {}};
        return {tr("What to do: add Clean-up, or finish with a smaller tolerance."), "cleanup"};
    case Why::stock:
        if (there.rough)
            return {tr("What to do: a tool with longer flutes, or a smaller allowance in Rough."), {}};
        return {tr("What to do: add Rough before the finish, which takes the stock away that is in the way."),
                "rough"};
    case Why::held:
        if (const Operation* leans = there.could_lean(r.program))
            return {
                tr("What to do: a tilt limit in %1, by which the tool leans there; or a longer shank, or a "
                   "slimmer holder.")
                    .arg(text(leans->common().name)),
                {}};
        return {tr("What to do: a longer shank, a slimmer holder, or the part laid another way."), {}};
    case Why::below_bottom:
        return {tr("What to do: a stock that reaches lower, or Below the bottom where nothing holds it "
                   "there."),
                {}};
    case Why::fixture:
        return {tr("What to do: move the fixture, or cut that place in a second setup."), {}};
    case Why::tab:
        return {tr("What to do: smaller tabs; or accept what stays, by Uncut limit in Verification limits."),
                {}};
    case Why::boundary:
        return {tr("What to do: widen the boundary; or accept what stays, by Uncut limit in Verification "
                   "limits."),
                {}};
    case Why::outside_stock:
        return {tr("What to do: a larger stock."), {}};
    case Why::not_seen:
    case Why::upright:
        break;
    }
    return {};
}

/// An operation that takes away enough of what stays for the verdict, though most of that has another reason,
/// about which more is to be done than to add something.
std::optional<VerdictAdvice> enough_to_add(const Verification& v, const Present& there) {
    double all = 0;
    for (const UncutReason& r : v.uncut)
        if (r.counts()) all += r.area;
    for (const UncutReason& r : v.uncut) {
        if (!r.counts() || v.uncut_share * (1 - r.area / all) > v.used.uncut_limit) continue;
        VerdictAdvice advice = advice_on(r, there);
        if (!advice.add.empty()) return advice;
    }
    return std::nullopt;
}

/// Where nothing can be verified: the narrowest tool asks for places nearer to each other than there are on a
/// part so large.
QString unjudged_advice(const std::string& why, const Project& project) {
    static const QString id = QStringLiteral(
        "places looked at are {1} apart, and a cutter has a radius of {2}: a resolution and a spacing of at "
        "most {3} would do");
    if (!filled_places(text(why), id)) return {};
    const Operation *narrowest = nullptr, *first = nullptr;
    double least = infinity;
    for (const Operation* o : operations_on(project)) {
        if (!first) first = o;
        const Tool* tool = find_tool(project.tools, o->common().tool);
        if (!tool || tool->diameter >= least) continue;
        least = tool->diameter;
        narrowest = o;
    }
    if (!narrowest) return {};
    const QString name = text(narrowest->common().name);
    return narrowest == first
               ? tr("What to do: a larger tool in %1.").arg(name)
               : tr("What to do: a larger tool in %1, or verify up to the operation before it.").arg(name);
}

} // namespace

QString not_begun_message(const std::string& why, const Project& project) {
    const QString advice = unjudged_advice(why, project);
    return tr("Verifying was not begun, as it cannot be judged: %1.")
               .arg(with_lengths_in(worded(why), project.unit))
           + (advice.isEmpty() ? QString() : QChar(' ') + advice);
}

VerdictAdvice verdict_advice(const Verification& v, const Project& project) {
    if (v.verdict() == facetmill::Verdict::not_judged) return {unjudged_advice(v.not_judged, project), {}};
    if (v.verdict() != facetmill::Verdict::failed) return {};
    const Present there(project, v);
    if (!v.collisions.empty()) return advice_on(v.collisions.front(), there);
    const UncutReason* reason = v.left_uncut() ? main_reason(v) : nullptr;
    if (!reason) return {};
    if (const auto other = beyond_slopes(v, *reason, project)) return *other;
    const VerdictAdvice advice = advice_on(*reason, there);
    return advice.add.empty() ? enough_to_add(v, there).value_or(advice) : advice;
}

QString advised_button(const VerdictAdvice& advice) {
    return advice.add.empty() ? QString() : tr("Add %1").arg(text(first_name_of(advice.add)));
}

} // namespace facetmill::ui
