#include "ui/workspaces.h"

#include "ui/settings.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace facetmill::ui {

namespace {

struct Entry {
    Workspace workspace;
    const char *name, *label, *help;
    LayerSet shown; ///< at first
};

const Entry entries[] = {
    {Workspace::prepare,
     "prepare",
     QT_TRANSLATE_NOOP("Workspaces", "Prepare"),
     QT_TRANSLATE_NOOP("Workspaces", "The part as it lies, its stock and fixtures (F7)"),
     {ViewLayer::part, ViewLayer::stock, ViewLayer::preview}},
    {Workspace::plan,
     "plan",
     QT_TRANSLATE_NOOP("Workspaces", "Plan"),
     QT_TRANSLATE_NOOP("Workspaces", "The paths on the part (F8)"),
     {ViewLayer::part, ViewLayer::preview, ViewLayer::regions, ViewLayer::cuts, ViewLayer::links,
      ViewLayer::rapids, ViewLayer::tool}},
    {Workspace::verify,
     "verify",
     QT_TRANSLATE_NOOP("Workspaces", "Verify"),
     QT_TRANSLATE_NOOP("Workspaces", "The part in the colours of what the verification found (F9)"),
     {ViewLayer::part, ViewLayer::deviation}},
    {Workspace::simulate,
     "simulate",
     QT_TRANSLATE_NOOP("Workspaces", "Simulate"),
     QT_TRANSLATE_NOOP("Workspaces", "The stock as the tool cuts it (F10)"),
     {ViewLayer::part, ViewLayer::stock, ViewLayer::tool}},
};

} // namespace

const char* workspace_name(Workspace workspace) {
    return entries[std::size_t(workspace)].name;
}

QString workspace_label(Workspace workspace) {
    return Workspaces::tr(entries[std::size_t(workspace)].label);
}

QString workspace_help(Workspace workspace) {
    return Workspaces::tr(entries[std::size_t(workspace)].help);
}

Workspaces::Workspaces(LayerBar& layers, const std::vector<QWidget*>& operation_bars, QWidget& playback_bar,
                       QWidget* parent)
    : QWidget(parent), layers_(layers), playback_(playback_bar) {
    setObjectName(QStringLiteral("workspaces"));
    const LayerSet known = layers_named(settings::known_layers());
    for (const Entry& e : entries) {
        const auto kept = settings::shown_layers(QLatin1String(e.name));
        LayerSet& shown = shown_[std::size_t(e.workspace)];
        shown = kept ? layers_named(*kept) : e.shown;
        // What an earlier version did not know is shown as at first.
        for (const ViewLayer layer : e.shown)
            if (kept && !known.contains(layer)) shown.insert(layer);
    }
    const auto holder = [this](const std::vector<QWidget*>& bars) {
        auto* w = new QWidget(this);
        auto* column = new QVBoxLayout(w);
        column->setContentsMargins(0, 0, 0, 0);
        for (QWidget* bar : bars)
            column->addWidget(bar);
        return w;
    };
    plan_bars_ = holder(operation_bars);
    play_bars_ = holder({&playback_bar});
    nothing_ = new QLabel(tr("Nothing to play back yet: plan first (F5)."), play_bars_);
    nothing_->setObjectName(QStringLiteral("nothing_to_play"));
    nothing_->setContentsMargins(8, 6, 8, 6);
    nothing_->setWordWrap(true);
    play_bars_->layout()->addWidget(nothing_);
    playback_.installEventFilter(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(plan_bars_);
    column->addWidget(play_bars_);
    add_row();
    layers_.set_shown_set(shown_[std::size_t(current_)]);
    show_bars();
}

void Workspaces::add_row() {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 2, 0, 2);
    row->setSpacing(0);
    auto* group = new QButtonGroup(this);
    for (const Entry& e : entries) {
        auto* b = new QToolButton(this);
        b->setObjectName(QStringLiteral("workspace_") + QLatin1String(e.name));
        b->setText(workspace_label(e.workspace));
        b->setToolTip(workspace_help(e.workspace));
        b->setCheckable(true);
        b->setAutoRaise(true);
        b->setFocusPolicy(Qt::TabFocus);
        b->setChecked(e.workspace == current_);
        group->addButton(b);
        connect(b, &QToolButton::clicked, this, [this, w = e.workspace] {
            enter(w);
            emit chosen(w);
        });
        buttons_[std::size_t(e.workspace)] = b;
        row->addWidget(b, 0, Qt::AlignTop); // beside the first line of what may be shown
    }
    row->addWidget(&layers_, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void Workspaces::enter(Workspace workspace) {
    if (workspace == current_) return;
    shown_[std::size_t(current_)] = layers_.shown_set();
    current_ = workspace;
    buttons_[std::size_t(workspace)]->setChecked(true);
    layers_.set_shown_set(shown_[std::size_t(workspace)]);
    show_bars();
    emit entered(workspace);
}

void Workspaces::show_bars() {
    plan_bars_->setVisible(current_ == Workspace::prepare || current_ == Workspace::plan);
    play_bars_->setVisible(current_ == Workspace::simulate);
    nothing_->setVisible(playback_.isHidden());
    layers_.offer_colours(current_ == Workspace::plan);
}

bool Workspaces::eventFilter(QObject* watched, QEvent* event) {
    // The playback's bar comes and goes with what there is to play.
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) show_bars();
    return QWidget::eventFilter(watched, event);
}

void Workspaces::keep_layers() const {
    settings::set_known_layers(all_layer_names());
    for (const Entry& e : entries) {
        const bool here = e.workspace == current_;
        settings::set_shown_layers(
            QLatin1String(e.name),
            layer_names(here ? layers_.shown_set() : shown_[std::size_t(e.workspace)]));
    }
}

} // namespace facetmill::ui
