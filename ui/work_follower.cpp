#include "ui/work_follower.h"

#include "ui/controllers.h"
#include "ui/kept_plans.h"
#include "ui/main_window.h"
#include "ui/plan_runner.h"
#include "ui/project_tree.h"
#include "ui/verification_controller.h"
#include "ui/window_docks.h"
#include "ui/workspaces.h"

namespace facetmill::ui {

namespace {

/// A path to see: an opened program, or that of an operation that is chosen.
void leave_preparing(MainWindow& w) {
    if (w.workspaces().current() != Workspace::prepare) return;
    const auto node = w.tree().selected();
    if (w.document().program()
        || (node && node->kind == TreeNode::Kind::operation && w.document().result(node->index)))
        w.workspaces().enter(Workspace::plan);
}

void follow_playback(MainWindow& w) {
    VerificationController& verification = w.verification();
    QObject::connect(&verification, &VerificationController::played, &w,
                     [&w] { w.workspaces().enter(Workspace::simulate); });
    QObject::connect(&w.controllers(), &Controllers::verified, &w, [&w, &verification] {
        if (!verification.playback().playing()) w.workspaces().enter(Workspace::verify);
    });
    QObject::connect(&w.workspaces(), &Workspaces::entered, &w, [&w, &verification](Workspace now) {
        if (now != Workspace::simulate) verification.playback().pause();
        w.update_commands();
    });
}

} // namespace

void follow_work(MainWindow& w, WindowDocks& docks) {
    QObject::connect(&w.document(), &Document::opened, &w,
                     [&w] { w.workspaces().enter(Workspace::prepare); });
    QObject::connect(&w.document(), &Document::states_changed, &w, [&w] {
        if (w.document().program()) leave_preparing(w);
    });
    QObject::connect(&w.tree(), &ProjectTree::selection_changed, &w, [&w] { leave_preparing(w); });
    QObject::connect(&w.planning(), &PlanRunner::about_to_plan, &w,
                     [&w] { w.workspaces().enter(Workspace::plan); });
    QObject::connect(&w.controllers().kept(), &KeptPlans::taken_up, &w, [&w] { leave_preparing(w); });
    follow_playback(w);
    QObject::connect(&w.workspaces(), &Workspaces::chosen, &w, [&docks](Workspace now) {
        if (now == Workspace::verify) docks.show(QStringLiteral("verification_dock"));
    });
}

} // namespace facetmill::ui
