#include "ui/verdict_advice.h"

#include "core/job/project.h"
#include "core/job/project_setup.h"
#include "core/verify/verify.h"
#include "ui/operation_list.h"
#include "ui/text.h"

#include <algorithm>

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
    explicit Present(const Project& project) {
        for (const Operation* o : operations_on(project)) {
            rough = rough || o->purpose() == Purpose::roughing;
            clean = clean || o->purpose() == Purpose::cleaning;
        }
    }
    bool rough = false, clean = false;
};

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

VerdictAdvice advice_on(const UncutReason& r, const Present& there) {
    using Why = UncutReason::Why;
    switch (r.why) {
    case Why::no_tool:
        if (there.clean)
            return {tr("What to do: a smaller tool in Clean-up; or accept what stays, by Uncut limit in "
                       "Verification limits."),
                    {}};
        return {tr("What to do: add Clean-up, which takes a smaller tool; or accept what stays, by Uncut "
                   "limit in Verification limits."),
                "cleanup"};
    case Why::no_operation:
        if (there.clean)
            return {tr("What to do: a finish with the tool that fits; or accept what stays, by Uncut limit "
                       "in Verification limits."),
                    {}};
        return {tr("What to do: add Clean-up, or a finish with the tool that fits."), "cleanup"};
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

} // namespace

VerdictAdvice verdict_advice(const Verification& v, const Project& project) {
    if (v.verdict() != facetmill::Verdict::failed) return {};
    const Present there(project);
    if (!v.collisions.empty()) return advice_on(v.collisions.front(), there);
    const UncutReason* reason = v.left_uncut() ? main_reason(v) : nullptr;
    return reason ? advice_on(*reason, there) : VerdictAdvice();
}

QString advised_button(const VerdictAdvice& advice) {
    return advice.add.empty() ? QString() : tr("Add %1").arg(text(first_name_of(advice.add)));
}

} // namespace facetmill::ui
