#include "ui/window_docks.h"

#include "ui/controller.h"

#include <QAction>
#include <QChildEvent>
#include <QDockWidget>
#include <QShortcut>
#include <QTabBar>
#include <QTimer>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <utility>

namespace facetmill::ui {

namespace {

/// Width of those on the left: a form of lengths with their units, and at most, where choices with long names
/// can be read whole.
constexpr int left_width = 312, widest_left = 440;
/// Width of the docks on the right at which their tabs can be read whole in most languages, and at most.
constexpr int right_width = 306, widest_right = 360;
/// A window below this width has no room for docks on both sides.
constexpr int narrow_window = 1000;

/// A share of the window, within these.
int left_width_in(const QWidget& window) {
    return std::clamp(window.width() * 23 / 100, left_width, widest_left);
}

/// Of docks on the right whose tabs stand side by side.
int width_of_tabs(std::initializer_list<const QDockWidget*> docks) {
    constexpr int beside = 26; // a tab is wider than its name
    int width = 0;
    for (const QDockWidget* dock : docks)
        width += dock->fontMetrics().horizontalAdvance(dock->windowTitle()) + beside;
    return std::clamp(width, right_width, widest_right);
}

} // namespace

WindowDocks::WindowDocks(QMainWindow* window) : QObject(window), window_(*window) {
    window_.installEventFilter(this);
}

bool WindowDocks::eventFilter(QObject* object, QEvent* event) {
    // Names of docks are read whole: where there is no room for all of them their tabs are scrolled.
    if (event->type() == QEvent::ChildPolished)
        if (auto* bar = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child())) {
            bar->setElideMode(Qt::ElideNone);
            bar->setUsesScrollButtons(true);
            bar->setAccessibleName(QObject::tr("Panels"));
        }
    return QObject::eventFilter(object, event);
}

void WindowDocks::add(const Place& place) {
    auto* dock = new QDockWidget(place.title, &window_);
    docks_[place.name] = dock;
    dock->setObjectName(place.name);
    dock->setWidget(place.content);
    window_.addDockWidget(place.area, dock);
    if (!place.beside.isEmpty()) window_.tabifyDockWidget(docks_.at(place.beside), dock);
    if (place.hidden) dock->hide();
    give_key(dock);
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool on) {
        if (!on) return;
        arrange(); // in a narrow window it has no place of its own
        dock->raise();
    });
    if (!place.controller) return;
    connect(dock, &QDockWidget::visibilityChanged, place.controller,
            [this, dock, controller = place.controller,
             below = place.area == Qt::BottomDockWidgetArea](bool seen) {
                // The log beside the charts is content with a few lines.
                if (below && seen && !dock->isFloating() && !std::exchange(charts_sized_, true))
                    window_.resizeDocks({dock}, {std::clamp(window_.height() * 3 / 10, 150, 300)},
                                        Qt::Vertical);
                controller->panel_seen(seen);
            });
    connect(place.controller, &Controller::offered, this, [this, dock] { bring_to_light(dock); });
}

void WindowDocks::give_key(QDockWidget* dock) {
    const int number = int(docks_.size());
    if (number > 10) return;
    const QKeySequence key(Qt::ALT | Qt::Key(Qt::Key_0 + number % 10));
    connect(new QShortcut(key, &window_), &QShortcut::activated, this,
            [this, name = dock->objectName()] { enter(name); });
    // Menus show it; the entry itself shows and hides the dock.
    dock->toggleViewAction()->setText(dock->windowTitle() + QChar('\t')
                                      + key.toString(QKeySequence::NativeText));
}

void WindowDocks::enter(const QString& name) {
    QDockWidget* dock = docks_.at(name);
    show(name);
    const auto takes_keys = [](const QWidget* w) {
        return w->isEnabled() && w->isVisibleTo(w->window()) && (w->focusPolicy() & Qt::TabFocus);
    };
    QWidget* content = dock->widget();
    if (!takes_keys(content))
        for (QWidget* child : content->findChildren<QWidget*>())
            if (takes_keys(child)) {
                content = child;
                break;
            }
    content->setFocus(Qt::ShortcutFocusReason);
}

std::vector<QDockWidget*> WindowDocks::all() const {
    std::vector<QDockWidget*> docks;
    for (const auto& [name, dock] : docks_)
        docks.push_back(dock);
    return docks;
}

void WindowDocks::clear() {
    for (const auto& [name, dock] : std::exchange(docks_, {}))
        delete dock;
}

void WindowDocks::show(const QString& name) {
    docks_.at(name)->show();
    docks_.at(name)->raise();
}

void WindowDocks::bring(const QString& name) {
    bring_to_light(docks_.at(name));
    docks_.at(name)->raise();
}

/// Shows a dock that has something to see for the first time; in a narrow window only its tab.
void WindowDocks::bring_to_light(QDockWidget* dock) {
    dock->show();
    arrange();
    if (!stands_right(dock)) return;
    dock->raise();
    window_.resizeDocks({dock}, {std::max(280, window_.width() * 3 / 10)}, Qt::Horizontal);
}

bool WindowDocks::stands_right(QDockWidget* dock) const {
    return !dock->isFloating() && window_.dockWidgetArea(dock) == Qt::RightDockWidgetArea;
}

void WindowDocks::size_as_new() {
    const auto at = [this](const char* name) { return docks_.at(QLatin1String(name)); };
    window_.resizeDocks({at("project_dock"), at("properties_dock")}, {230, 420}, Qt::Vertical);
    const int right = width_of_tabs({at("report_dock"), at("verification_dock"), at("cspace_dock")});
    left_given_ = left_width_in(window_);
    window_.resizeDocks({at("project_dock"), at("report_dock")}, {left_given_, right}, Qt::Horizontal);
    window_.resizeDocks({at("log_dock")}, {96}, Qt::Vertical);
}

void WindowDocks::arrange() {
    if (docks_.empty()) return;
    follow_window();
    if (window_.width() < narrow_window) {
        if (!make_room()) return;
    } else {
        if (made_room_.empty()) return;
        go_back();
    }
    // Qt leaves the bar of tabs that are gone standing, as a line; also after it has laid out the docks.
    const auto hide_empty_bars = [this] {
        for (QTabBar* bar : window_.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
            if (bar->count() == 0) bar->hide();
    };
    hide_empty_bars();
    QTimer::singleShot(0, this, hide_empty_bars);
}

void WindowDocks::follow_window() {
    QDockWidget* parameters = docks_.at(QStringLiteral("properties_dock"));
    const int wanted = left_width_in(window_);
    constexpr int same = 2;
    if (wanted == left_given_ || parameters->isHidden() || parameters->isFloating()
        || window_.dockWidgetArea(parameters) != Qt::LeftDockWidgetArea
        || std::abs(parameters->width() - left_given_) > same)
        return;
    left_given_ = wanted;
    window_.resizeDocks({parameters}, {wanted}, Qt::Horizontal);
}

bool WindowDocks::make_room() {
    QDockWidget* parameters = docks_.at(QStringLiteral("properties_dock"));
    if (parameters->isFloating() || window_.dockWidgetArea(parameters) != Qt::LeftDockWidgetArea)
        return false;
    bool moved = false;
    for (const char* name : {"report_dock", "verification_dock", "cspace_dock", "strips_dock",
                             "unrolled_dock", "place_dock", "scan_dock"}) {
        QDockWidget* dock = docks_.at(QLatin1String(name));
        if (!stands_right(dock) || dock->isHidden()) continue;
        window_.tabifyDockWidget(parameters, dock);
        parameters->raise();
        made_room_.push_back(dock);
        moved = true;
    }
    // The form keeps its width.
    if (moved) window_.resizeDocks({parameters}, {left_width_in(window_)}, Qt::Horizontal);
    return moved;
}

void WindowDocks::go_back() {
    for (QDockWidget* dock : std::exchange(made_room_, {}))
        if (!dock->isFloating()) window_.addDockWidget(Qt::RightDockWidgetArea, dock);
    const auto at = [this](const char* name) { return docks_.at(QLatin1String(name)); };
    QDockWidget *report = at("report_dock"), *verification = at("verification_dock");
    const auto beside_report = [&](QDockWidget* dock) {
        return window_.dockWidgetArea(report) == window_.dockWidgetArea(dock);
    };
    if (beside_report(verification)) {
        window_.tabifyDockWidget(report, verification);
        for (QDockWidget* dock :
             {at("cspace_dock"), at("strips_dock"), at("unrolled_dock"), at("place_dock"), at("scan_dock")})
            if (beside_report(dock)
                && !((dock == at("strips_dock") || dock == at("place_dock") || dock == at("scan_dock"))
                     && dock->isHidden()))
                window_.tabifyDockWidget(verification, dock);
        report->raise();
    }
    window_.resizeDocks({report}, {width_of_tabs({report, verification, at("cspace_dock")})}, Qt::Horizontal);
}

} // namespace facetmill::ui
