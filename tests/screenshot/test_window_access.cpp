// Access by keys and by assistive technology: every control says what it is, Tab goes on as one reads, and
// words can be read in both palettes.
#include "tests/screenshot/window_support.h"
#include "tests/screenshot/window_tour.h"
#include "ui/document.h"
#include "ui/preferences_dialog.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/theme.h"
#include "ui/tool_dialog.h"
#include "ui/tool_library_dialog.h"
#include "ui/window_docks.h"
#include "ui/workspaces.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;
using ui::Workspace;

namespace {

/// WCAG 2.1: relative luminance and contrast ratio.
double luminance(const QColor& c) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const double l = luminance(a), m = luminance(b);
    return (std::max(l, m) + 0.05) / (std::min(l, m) + 0.05);
}

/// What a screen reader stops at: takes the keys, and is there to be seen.
std::vector<QWidget*> controls_of(QWidget& window) {
    std::vector<QWidget*> controls;
    for (QWidget* w : window.findChildren<QWidget*>())
        if (w->isVisible() && w->isEnabled() && (w->focusPolicy() & Qt::TabFocus) && w->window() == &window)
            controls.push_back(w);
    return controls;
}

QString described(const QWidget& w) {
    QString path;
    for (const QWidget* p = &w; p; p = p->parentWidget())
        path = QLatin1String(p->metaObject()->className()) + QChar('(') + p->objectName()
               + QStringLiteral(") ") + path;
    return path;
}

/// Those without a name or without a role.
QStringList nameless(QWidget& window) {
    QStringList found;
    for (QWidget* w : controls_of(window)) {
        // Stand for what lies in them.
        if (qobject_cast<QScrollArea*>(w) || qobject_cast<QTabWidget*>(w)) continue;
        const QWidget* around = w->parentWidget();
        if (qobject_cast<const QComboBox*>(around) || qobject_cast<const QAbstractSpinBox*>(around))
            continue; // one with that
        const QAccessibleInterface* access = QAccessible::queryAccessibleInterface(w);
        if (!access) {
            found << described(*w);
            continue;
        }
        const QAccessible::Role role = access->role();
        if (access->text(QAccessible::Name).trimmed().isEmpty() || role == QAccessible::NoRole
            || role == QAccessible::Client)
            found << described(*w) + QStringLiteral("as %1").arg(int(role));
    }
    found.removeDuplicates();
    return found;
}

/// What stands behind a widget's words.
QColor ground_of(const QWidget& w) {
    for (const QWidget* p = &w; p; p = p->parentWidget())
        if (p == &w ? qobject_cast<const QAbstractButton*>(p) || p->autoFillBackground()
                    : p->autoFillBackground() || p->isWindow())
            return p->palette().color(p->backgroundRole());
    return w.palette().color(QPalette::Window);
}

/// The first control that Tab reaches too late or too early; empty where there is none.
QString out_of_order(QWidget& area) {
    std::vector<QWidget*> fields;
    QWidget* first = nullptr;
    for (QWidget* c : controls_of(*area.window()))
        if (area.isAncestorOf(c) && !c->visibleRegion().isEmpty() && !qobject_cast<QScrollArea*>(c)) {
            // Where the way of the keys comes into the area.
            const QWidget* before = c->previousInFocusChain();
            if (!first || !area.isAncestorOf(before)) first = c;
        }
    if (!first) return {};
    const QWidget* end = area.window();
    QSet<const QWidget*> been;
    for (QWidget* f = first; f && f != end && !been.contains(f); f = f->nextInFocusChain()) {
        been << f;
        const QWidget* around = f->parentWidget();
        const bool part =
            qobject_cast<const QComboBox*>(around) || qobject_cast<const QAbstractSpinBox*>(around);
        if (area.isAncestorOf(f) && !part && f->isVisible() && f->isEnabled()
            && (f->focusPolicy() & Qt::TabFocus) && !f->visibleRegion().isEmpty()
            && !qobject_cast<QScrollArea*>(f) && !qobject_cast<QTabWidget*>(f))
            fields.push_back(f);
    }
    QRect last;
    for (const QWidget* f : fields) {
        const QRect at(f->mapTo(&area, QPoint(0, 0)), f->size());
        // Below what was before, or beside it: columns that stand beside each other are read one by one.
        if (!last.isNull() && at.bottom() < last.top() && at.left() <= last.right()) return described(*f);
        last = at;
    }
    return {};
}

} // namespace

class TestWindowAccess : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void every_control_has_a_name_and_a_role() {
        QStringList found = nameless(w()); // the start page
        action(w(), "first_steps")->trigger();
        found << nameless(w());
        QVERIFY(open_and_plan());
        tour_window(w(), [&](QWidget& top, const QString&) { found << nameless(top); });
        found.removeDuplicates();
        for (const QString& each : found)
            qWarning().noquote() << each;
        QVERIFY(found.isEmpty());
    }

    void every_control_of_dialogs_too() {
        QVERIFY(open_and_plan());
        QStringList found;
        const QSet<QString> seen =
            tour_dialogs(w(), [&](QWidget& top, const QString&) { found << nameless(top); });
        const QSet<QString> missing = dialog_classes() - seen;
        QVERIFY2(missing.isEmpty(), qPrintable(QStringList(missing.values()).join(QChar(' '))));
        QVERIFY(dialog_classes().size() > 6);
        found.removeDuplicates();
        for (const QString& each : found)
            qWarning().noquote() << each;
        QVERIFY(found.isEmpty());
    }

    /// In the forms of all nodes, in the panels, in dialogs: down from row to row, to the right within one.
    void tab_goes_on_as_one_reads_everywhere() {
        QVERIFY(open_and_plan());
        QStringList found;
        const auto look = [&](QWidget& top, const QString& page) {
            // What scrolls or is docked stands for itself.
            std::vector<QWidget*> areas;
            if (qobject_cast<QDialog*>(&top))
                areas.push_back(&top);
            else
                for (QDockWidget* dock : top.findChildren<QDockWidget*>())
                    if (dock->isVisible() && !dock->visibleRegion().isEmpty())
                        areas.push_back(dock->widget());
            for (QWidget* area : areas)
                if (const QString wrong = out_of_order(*area); !wrong.isEmpty())
                    found << page + QStringLiteral(": ") + wrong;
        };
        tour_window(w(), look);
        tour_dialogs(w(), look);
        found.removeDuplicates();
        for (const QString& each : found)
            qWarning().noquote() << each;
        QVERIFY(found.isEmpty());
    }

    void words_of_all_pages_can_be_read_data() { words_can_be_read_data(); }
    /// What labels and buttons really have for colours, wherever they stand.
    void words_of_all_pages_can_be_read() {
        QFETCH(bool, dark);
        w().set_theme(dark ? ui::Theme::dark : ui::Theme::light);
        QVERIFY(open_and_plan());
        QStringList found;
        const auto look = [&](QWidget& top, const QString& page) {
            for (const QWidget* words : top.findChildren<QWidget*>()) {
                const auto* label = qobject_cast<const QLabel*>(words);
                const bool button = qobject_cast<const QAbstractButton*>(words);
                if ((!label && !button) || !words->isVisible() || !words->isEnabled()) continue;
                if (label && label->text().isEmpty()) continue;
                const double ratio =
                    contrast(words->palette().color(words->foregroundRole()), ground_of(*words));
                if (ratio < 4.5) found << QStringLiteral("%1: %2 %3").arg(page, described(*words)).arg(ratio);
            }
        };
        tour_window(w(), look);
        tour_dialogs(w(), look);
        w().set_theme(ui::Theme::system);
        found.removeDuplicates();
        for (const QString& each : found)
            qWarning().noquote() << each;
        QVERIFY(found.isEmpty());
    }

    void menus_have_letters() {
        for (const QAction* menu : w().menuBar()->actions())
            QVERIFY2(menu->text().contains(QChar('&')), qPrintable(menu->text()));
        // In one menu no letter twice.
        for (const QAction* top : w().menuBar()->actions()) {
            QStringList letters;
            for (const QAction* entry : top->menu()->actions()) {
                const qsizetype at = entry->text().indexOf(QChar('&'));
                if (at < 0 || !entry->isVisible()) continue;
                const QString letter = entry->text().mid(at + 1, 1).toLower();
                QVERIFY2(!letters.contains(letter), qPrintable(top->text() + QChar(' ') + entry->text()));
                letters << letter;
            }
        }
    }

    void tab_goes_on_as_one_reads() {
        QVERIFY(open_and_plan());
        w().tree().select({TreeNode::Kind::operation, 0});
        QTest::qWait(20);
        QWidget& panel = w().properties();
        std::vector<QWidget*> fields;
        QWidget* first = nullptr;
        for (QWidget* c : controls_of(w()))
            if (panel.isAncestorOf(c) && !qobject_cast<QScrollArea*>(c) && !first) first = c;
        QVERIFY(first);
        for (QWidget* f = first; f && panel.isAncestorOf(f); f = f->nextInFocusChain())
            if (f->isVisible() && (f->focusPolicy() & Qt::TabFocus)) fields.push_back(f);
        QVERIFY(fields.size() > 8);
        // Down from row to row, to the right within one.
        QPoint last(-1, -1);
        for (const QWidget* f : fields) {
            const QRect at(f->mapTo(&panel, QPoint(0, 0)), f->size());
            const bool below = at.top() > last.y();
            QVERIFY2(below || at.left() > last.x(), qPrintable(described(*f)));
            last = QPoint(at.left(), below ? at.center().y() : last.y());
        }
    }

    void words_can_be_read_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    /// WCAG AA: 4.5 to 1.
    void words_can_be_read() {
        QFETCH(bool, dark);
        const QPalette p = dark ? ui::dark_palette() : ui::light_palette();
        const std::pair<QPalette::ColorRole, QPalette::ColorRole> pairs[] = {
            {QPalette::WindowText, QPalette::Window},
            {QPalette::Text, QPalette::Base},
            {QPalette::Text, QPalette::AlternateBase},
            {QPalette::ButtonText, QPalette::Button},
            {QPalette::HighlightedText, QPalette::Highlight},
            {QPalette::PlaceholderText, QPalette::Base},
            {QPalette::PlaceholderText, QPalette::Window},
            {QPalette::ToolTipText, QPalette::ToolTipBase},
            {QPalette::Link, QPalette::Base},
            {QPalette::Link, QPalette::Window}};
        for (const auto& [word, ground] : pairs) {
            const double ratio = contrast(p.color(word), p.color(ground));
            QVERIFY2(
                ratio >= 4.5,
                qPrintable(QStringLiteral("role %1 on %2: %3").arg(int(word)).arg(int(ground)).arg(ratio)));
        }
        const ui::SignalColors s = ui::signal_colors(p);
        const std::pair<const char*, QColor> signals_[] = {{"good", s.good},
                                                           {"attention", s.attention},
                                                           {"bad", s.bad},
                                                           {"busy", s.busy},
                                                           {"quiet", s.quiet}};
        for (const auto& [name, color] : signals_)
            for (const auto ground : {QPalette::Window, QPalette::Base}) {
                const double ratio = contrast(color, p.color(ground));
                QVERIFY2(ratio >= 4.5,
                         qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(name)).arg(ratio)));
            }
    }
};

FACETMILL_TEST(TestWindowAccess)
#include "test_window_access.moc"
