#include "ui/command.h"

#include <QAction>
#include <QWidget>

namespace facetmill::ui {

Command::Command(CommandSpec spec, QWidget* window)
    : spec_(std::move(spec)), action_(new QAction(spec_.text, window)) {
    action_->setObjectName(spec_.name);
    if (spec_.icon) action_->setIcon(icon(*spec_.icon));
    action_->setShortcuts(spec_.keys);
    QString tip = spec_.tip;
    if (tip.isEmpty()) {
        tip = QString(spec_.text).remove(QChar('&')).remove(QStringLiteral("…"));
        if (!spec_.keys.isEmpty() && !spec_.keys.front().isEmpty())
            tip += QStringLiteral(" (%1)").arg(spec_.keys.front().toString(QKeySequence::NativeText));
    }
    action_->setToolTip(tip);
    action_->setCheckable(bool(spec_.checked));
    window->addAction(action_); // so that its keys work wherever the focus is
    connect(action_, &QAction::triggered, this, &Command::execute);
    refresh();
}

void Command::execute() {
    spec_.execute();
    refresh();
}

void Command::refresh() {
    action_->setEnabled(is_enabled());
    if (spec_.checked) action_->setChecked(spec_.checked());
}

void Commands::add(CommandSpec spec) {
    const QString name = spec.name;
    commands_.push_back(std::make_unique<Command>(std::move(spec), window_));
    adopt(name, commands_.back()->action());
}

void Commands::adopt(const QString& name, QAction* action) {
    actions_[name] = action;
}

QAction* Commands::action(const QString& name) const {
    const auto at = actions_.find(name);
    if (at == actions_.end()) qFatal("there is no command '%s'", qPrintable(name));
    return at->second;
}

void Commands::refresh() {
    for (const auto& command : commands_)
        command->refresh();
}

} // namespace facetmill::ui
