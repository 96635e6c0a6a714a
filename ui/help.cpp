#include "ui/help.h"

#include "ui/help_pages.h"
#include "ui/help_window.h"

#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QKeyEvent>

#include <utility>

namespace facetmill::ui {

namespace {

/// Chapters of docks, dialogs and other parts of the window, by the names of their widgets.
constexpr std::pair<const char*, const char*> help_chapters[] = {
    {"project_dock", "operations.html"},
    {"properties_dock", "operations.html"},
    {"report_dock", "planning.html#report"},
    {"verification_dock", "verification.html"},
    {"cspace_dock", "configuration_space.html"},
    {"unrolled_dock", "lathe.html#unrolled"},
    {"strips_dock", "operations.html#cleanup"},
    {"place_dock", "part.html#place"},
    {"scan_dock", "scan_room.html"},
    {"log_dock", "planning.html#messages"},
    {"chart_dock", "simulation.html#charts"},
    {"study_dialog", "studies.html"},
    {"tool_dialog", "tools.html#dialog"},
    {"tool_library", "tools.html#library"},
    {"region_dialog", "regions.html"},
    {"axis_dialog", "operations.html#tool_axis"},
    {"part_dialog", "part.html#unit"},
    {"preferences", "preferences.html"},
    {"export_dialog", "export.html"},
    {"unpack_dialog", "export.html#packed"},
    {"boundary_box", "boundaries.html#paint"},
    {"playback_bar", "simulation.html"},
    {"rough_bar", "operations.html#rough"},
    {"start_hint", "first_job.html"},
    {"first_steps", "first_job.html"},
    {"layer_bar", "simulation.html#layers"},
    {"workspaces", "simulation.html#layers"},
    {"message_bar", "planning.html#messages"},
    {"unit", "part.html#unit"},
    {"unsaved_changes", "export.html#files"},
    {"viewport", "keyboard.html#mouse"},
    {"main_window", "keyboard.html"}, // of what has no place of its own
};

constexpr std::pair<const char*, const char*> help_scopes[] = {
    {"part", "part.html"},
    {"stock", "setup.html#stock"},
    {"fixtures", "setup.html#fixtures"},
    {"boundaries", "boundaries.html"},
    {"setups", "setup.html#second_side"},
    {"project_file", "export.html#controls"},
    {"verification", "verification.html#limits"},
    {"tools", "tools.html"},
    {"part-repair", "scan_room.html"},
};

/// The entry of a parameter in the reference, or an empty text.
QString reference_topic(const QString& scope_list, const QString& key) {
    for (const QString& scope : scope_list.split(QChar(' '), Qt::SkipEmptyParts))
        for (const QString& page : {QStringLiteral("reference_") + scope, QStringLiteral("reference")})
            if (const QString topic = QStringLiteral("%1.html#%2-%3").arg(page, scope, key); has_help(topic))
                return topic;
    return {};
}

} // namespace

QString help_chapter(const QString& scope) {
    const QString first = scope.section(QChar(' '), 0, 0);
    for (const auto& [name, topic] : help_scopes)
        if (first == QLatin1String(name)) return QLatin1String(topic);
    const QString operation = QStringLiteral("operations.html#") + first;
    return has_help(operation) ? operation : QString();
}

QString help_topic(const QWidget* at) {
    QString key;
    for (const QWidget* w = at; w; w = w->parentWidget()) {
        if (const QString own = w->property(help_topic_property).toString(); !own.isEmpty()) return own;
        if (key.isEmpty()) key = w->property(help_key_property).toString();
        if (const QString scope = w->property(help_scope_property).toString(); !scope.isEmpty()) {
            if (const QString topic = reference_topic(scope, key); !topic.isEmpty()) return topic;
            if (const QString topic = help_chapter(scope); !topic.isEmpty()) return topic;
        }
        if (qobject_cast<const QFileDialog*>(w)) return QStringLiteral("export.html#files");
        if (const auto* start = w->findChild<const QWidget*>(QStringLiteral("start_hint"));
            start && start->isVisible())
            return QStringLiteral("first_job.html");
        for (const auto& [name, topic] : help_chapters)
            if (w->objectName() == QLatin1String(name)) return QLatin1String(topic);
    }
    return {};
}

Help::Help(QWidget* window) : QObject(window), owner_(window) {
    qApp->installEventFilter(this);
}

Help::~Help() {
    delete opened_;
}

HelpWindow* Help::window() {
    return opened_;
}

void Help::open_here() {
    const QWidget* focus = QApplication::focusWidget();
    open(help_topic(focus ? focus : owner_));
}

void Help::open(const QString& topic) {
    QWidget* modal = QApplication::activeModalWidget();
    // A dialog that blocks all windows lets only its own through.
    if (modal && modal->windowModality() == Qt::ApplicationModal) {
        auto* above = new HelpWindow(modal);
        above->setAttribute(Qt::WA_DeleteOnClose);
        above->show_topic(topic);
        above->show();
        return;
    }
    if (!opened_) opened_ = new HelpWindow;
    opened_->show_topic(topic);
    opened_->show();
    opened_->raise();
    opened_->activateWindow();
}

bool Help::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_F1)
        return false;
    // In the window itself the command of the menu has the key.
    const auto* at = qobject_cast<const QWidget*>(object);
    if (!at || at->window() == owner_ || qobject_cast<const HelpWindow*>(at->window())) return false;
    const QWidget* above = at->window()->parentWidget();
    if (!above || above->window() != owner_) return false; // another window's
    open(help_topic(at));
    return true;
}

} // namespace facetmill::ui
