#include "ui/verdict_advice.h"

#include "core/verify/verify.h"
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

QString advice_on(const Collision& c) {
    if (!c.fixture.empty())
        return tr("What to do: move the fixture, or keep the operation out of its way by a boundary.");
    if (c.kind == Collision::Kind::cutter || c.kind == Collision::Kind::rapid)
        return tr("What to do: raise the clearance of the operation that the list names.");
    return c.with_part
               ? tr("What to do: a longer shank or flutes, a slimmer holder, or the part laid another way.")
               : tr("What to do: add Rough before it, so that less stock stands there, or take a tool "
                    "with longer flutes.");
}

QString advice_on(const UncutReason& r) {
    using Why = UncutReason::Why;
    switch (r.why) {
    case Why::no_tool:
        return tr(
            "What to do: add Clean-up, which takes a smaller tool; or accept what stays, by Uncut limit "
            "in Verification limits.");
    case Why::no_operation:
        return tr("What to do: add Clean-up, or a finish with the tool that fits.");
    case Why::not_cut:
    case Why::passes_apart:
        return tr("What to do: add Clean-up, or finish with a smaller tolerance.");
    case Why::stock:
        return tr("What to do: add Rough before the finish, which takes the stock away that is in the way.");
    case Why::held:
        return tr("What to do: a longer shank, a slimmer holder, or the part laid another way.");
    case Why::below_bottom:
        return tr(
            "What to do: a stock that reaches lower, or Below the bottom where nothing holds it there.");
    case Why::fixture:
        return tr("What to do: move the fixture, or cut that place in a second setup.");
    case Why::tab:
        return tr("What to do: smaller tabs; or accept what stays, by Uncut limit in Verification limits.");
    case Why::boundary:
        return tr(
            "What to do: widen the boundary; or accept what stays, by Uncut limit in Verification limits.");
    case Why::outside_stock:
        return tr("What to do: a larger stock.");
    case Why::not_seen:
        break;
    }
    return {};
}

} // namespace

QString verdict_advice(const Verification& v) {
    if (v.verdict() != facetmill::Verdict::failed) return {};
    if (!v.collisions.empty()) return advice_on(v.collisions.front());
    const UncutReason* reason = v.left_uncut() ? main_reason(v) : nullptr;
    return reason ? advice_on(*reason) : QString();
}

} // namespace facetmill::ui
