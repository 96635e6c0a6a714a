#include "ui/operation_actions.h"

#include "core/job/copied_operations.h"
#include "ui/axis_dialog.h"
#include "ui/icons.h"
#include "ui/operation_list.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

namespace facetmill::ui {

OperationActions::OperationActions(Document& document, QWidget* tree)
    : QObject(tree), document_(document), tree_(tree) {
    const auto make = [this](const QString& text, auto&& run) {
        auto* action = new QAction(text, this);
        connect(action, &QAction::triggered, this, std::forward<decltype(run)>(run));
        return action;
    };
    plan_ = make(tr("Plan this operation"), [this] { emit plan_wanted(*operation_); });
    plan_->setIcon(icon(Icon::plan));
    verify_ = make(tr("Verify up to this operation"), [this] { emit verify_wanted(*operation_); });
    verify_->setIcon(icon(Icon::verify));
    verify_->setToolTip(tr("Cut the stock up to this operation, and judge what it is to leave"));
    export_ = make(tr("Export its program…"), [this] { emit export_wanted(*operation_); });
    export_->setIcon(icon(Icon::export_program));
    switch_ = make(tr("Switched off"), [this](bool off) {
        if (operation_) switch_operation(document_, *operation_, off);
    });
    switch_->setCheckable(true);
    switch_->setToolTip(tr("Leave it out of plan, verification and programs, as if it were not there"));
    copy_ = make(tr("Copy"), [this] { copy(); });
    copy_->setShortcut(QKeySequence::Copy);
    paste_ = make(tr("Paste"), [this] { paste(); });
    paste_->setShortcut(QKeySequence::Paste);
    for (QAction* a : {copy_, paste_}) { // elsewhere these keys are those of fields
        a->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        tree->addAction(a);
    }
    set_operation(std::nullopt);
}

void OperationActions::set_operation(std::optional<std::size_t> place) {
    operation_ = place;
    const bool off = place && document_.is_off(*place);
    for (QAction* a : {plan_, verify_, export_})
        a->setEnabled(place && !off);
    for (QAction* a : {switch_, copy_})
        a->setEnabled(place.has_value());
    switch_->setChecked(off);
    paste_->setEnabled(document_.has_part());
}

void OperationActions::add_to(QMenu& menu) {
    if (!operation_) return;
    menu.addActions({plan_, verify_, export_});
    menu.addSeparator();
    menu.addAction(switch_);
    if (has_tool_axis(document_, *operation_)) {
        menu.addAction(tr("Tool axis by angles…"), this,
                       [this, i = *operation_] { ask_tool_axis(document_, i, tree_->window()); });
        menu.addAction(tr("Same tool axis for all operations"), this,
                       [this, i = *operation_] { share_tool_axis(document_, i); });
    }
    menu.addSeparator();
}

std::vector<std::pair<const char*, QAction*>> OperationActions::commands() {
    return {{"copy_operation", copy_}, {"paste_operation", paste_}, {"switch_off", switch_}};
}

void OperationActions::copy() {
    if (!operation_) return;
    try {
        QGuiApplication::clipboard()->setText(text(copied_operation(document_.project(), *operation_)));
    } catch (const Error& e) {
        emit refused(sentence(worded(e)));
    }
}

void OperationActions::paste() {
    const std::string copied = utf8(QGuiApplication::clipboard()->text());
    if (!may_be_operations(copied))
        return emit refused(tr("The clipboard holds no operation: copy one in the tree first (Ctrl+C)."));
    try {
        const Pasted made = paste_operations(document_, copied, operation_);
        emit pasted(made.place);
        for (const QString& remark : made.remarks)
            emit refused(remark);
    } catch (const Error& e) {
        emit refused(sentence(worded(e)));
    }
}

} // namespace facetmill::ui
