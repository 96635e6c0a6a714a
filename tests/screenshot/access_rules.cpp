#include "tests/screenshot/access_rules.h"

#include "ui/help.h"
#include "ui/help_pages.h"
#include "ui/help_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QGroupBox>
#include <QHash>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QTabBar>
#include <QTabWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>

namespace facetmill::test {

namespace {

constexpr double least_contrast = 4.5; ///< WCAG AA

/// WCAG 2.1: relative luminance.
double luminance(const QColor& c) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

/// One with what it stands in.
bool part_of_a_field(const QWidget& w) {
    const QWidget* around = w.parentWidget();
    return qobject_cast<const QComboBox*>(around) || qobject_cast<const QAbstractSpinBox*>(around);
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
QString misplaced(QWidget& area) {
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
        if (area.isAncestorOf(f) && !part_of_a_field(*f) && f->isVisible() && f->isEnabled()
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

/// Buttons that Qt adds, whose work keys do by themselves: those of docks stand in the menu "View".
bool is_qts_own(const QWidget& w) {
    const QString name = w.objectName();
    return name.startsWith(QLatin1String("qt_")) || name == QLatin1String("ScrollLeftButton")
           || name == QLatin1String("ScrollRightButton") || qobject_cast<const QScrollBar*>(&w)
           || qobject_cast<const QHeaderView*>(&w) || qobject_cast<const QLineEdit*>(w.parentWidget())
           || qobject_cast<const QTabBar*>(w.parentWidget())
           || qobject_cast<const QMenuBar*>(w.parentWidget());
}

bool is_worked_with(const QWidget& w) {
    return qobject_cast<const QAbstractButton*>(&w) || qobject_cast<const QComboBox*>(&w)
           || qobject_cast<const QAbstractSpinBox*>(&w) || qobject_cast<const QLineEdit*>(&w)
           || qobject_cast<const QAbstractSlider*>(&w) || qobject_cast<const QAbstractItemView*>(&w);
}

void add_actions(const QMenu& menu, QSet<const QAction*>& all) {
    for (const QAction* a : menu.actions()) {
        all << a;
        if (a->menu()) add_actions(*a->menu(), all);
    }
}

QChar mnemonic(QString text) {
    text = text.section(QChar('\t'), 0, 0).replace(QStringLiteral("&&"), QStringLiteral("__"));
    const qsizetype at = text.indexOf(QChar('&'));
    return at >= 0 && at + 1 < text.size() ? text[at + 1].toLower() : QChar();
}

using TakenLetters = QHash<QChar, QString>;

void take_letter(TakenLetters& taken, const QString& text, QStringList& found) {
    const QChar key = mnemonic(text);
    if (key.isNull()) return;
    if (taken.contains(key) && taken[key] != text) found << taken[key] + QStringLiteral(" / ") + text;
    taken.insert(key, text);
}

/// Colours of words, and what lies behind them.
class WordColors {
public:
    explicit WordColors(QStringList& found) : found_(found) {}
    void look(const QWidget& w, const QColor& words, const QColor& ground, const QString& what = {}) {
        if (const double ratio = contrast(words, ground); ratio < least_contrast)
            found_ << QStringLiteral("%1 “%2”: %3 %4 on %5")
                          .arg(described(w), what.left(40))
                          .arg(ratio)
                          .arg(words.name(), ground.name());
    }
    void look_at_tree(const QTreeWidget& tree) {
        const QColor base = tree.palette().color(QPalette::Base);
        for (QTreeWidgetItemIterator it(const_cast<QTreeWidget*>(&tree)); *it; ++it)
            for (int c = 0; c < tree.columnCount(); ++c) {
                const QTreeWidgetItem& item = **it;
                if (item.text(c).isEmpty() || !(item.flags() & Qt::ItemIsEnabled)) continue;
                const QBrush words = item.foreground(c), ground = item.background(c);
                look(tree,
                     words.style() == Qt::NoBrush ? tree.palette().color(QPalette::Text) : words.color(),
                     ground.style() == Qt::NoBrush ? base : ground.color(), item.text(c));
            }
    }
    void look_at_page(const QTextBrowser& page) {
        const QColor base = page.palette().color(QPalette::Base);
        for (QTextBlock block = page.document()->begin(); block.isValid(); block = block.next())
            for (auto it = block.begin(); !it.atEnd(); ++it) {
                const QTextCharFormat format = it.fragment().charFormat();
                const QColor words = format.foreground().style() == Qt::NoBrush
                                         ? page.palette().color(QPalette::Text)
                                         : format.foreground().color();
                const QColor ground =
                    format.background().style() == Qt::NoBrush ? base : format.background().color();
                look(page, words, ground, it.fragment().text());
            }
    }
    void look_at_marks(const QLabel& label) {
        static const QRegularExpression color(QStringLiteral("[^-]color:\\s*(#[0-9a-fA-F]{6})"));
        for (auto it = color.globalMatch(label.text()); it.hasNext();)
            look(label, QColor(it.next().captured(1)), ground_of(label), label.text());
    }

private:
    QStringList& found_;
};

} // namespace

double contrast(const QColor& a, const QColor& b) {
    const double l = luminance(a), m = luminance(b);
    return (std::max(l, m) + 0.05) / (std::min(l, m) + 0.05);
}

QString described(const QWidget& w) {
    QString path;
    for (const QWidget* p = &w; p; p = p->parentWidget())
        path = QLatin1String(p->metaObject()->className()) + QChar('(') + p->objectName()
               + QStringLiteral(") ") + path;
    return path;
}

std::vector<QWidget*> controls_of(QWidget& window) {
    std::vector<QWidget*> controls;
    for (QWidget* w : window.findChildren<QWidget*>())
        if (w->isVisible() && w->isEnabled() && (w->focusPolicy() & Qt::TabFocus) && w->window() == &window)
            controls.push_back(w);
    return controls;
}

QStringList nameless(QWidget& window) {
    QStringList found;
    for (QWidget* w : controls_of(window)) {
        // Stand for what lies in them.
        if (qobject_cast<QScrollArea*>(w) || qobject_cast<QTabWidget*>(w) || part_of_a_field(*w)) continue;
        // What Qt leaves standing of docks that were beside each other has nothing to stop at.
        if (const auto* tabs = qobject_cast<const QTabBar*>(w); tabs && tabs->count() == 0) continue;
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
    return found;
}

QStringList out_of_order(QWidget& window) {
    QStringList found;
    const auto look = [&](QWidget& area) {
        if (const QString wrong = misplaced(area); !wrong.isEmpty()) found << wrong;
    };
    if (!qobject_cast<QMainWindow*>(&window)) {
        look(window);
        return found;
    }
    // What scrolls or is docked stands for itself.
    for (QDockWidget* dock : window.findChildren<QDockWidget*>())
        if (dock->isVisible() && !dock->visibleRegion().isEmpty()) look(*dock->widget());
    return found;
}

QStringList out_of_reach(QWidget& window) {
    QSet<const QAction*> in_menus;
    if (const auto* main = qobject_cast<const QMainWindow*>(&window))
        for (const QAction* top : main->menuBar()->actions())
            if (top->menu()) add_actions(*top->menu(), in_menus);
    QStringList found;
    for (const QWidget* w : window.findChildren<const QWidget*>()) {
        if (!w->isVisible() || !w->isEnabled() || w->window() != &window || !is_worked_with(*w)
            || is_qts_own(*w) || part_of_a_field(*w) || (w->focusPolicy() & Qt::TabFocus))
            continue;
        const auto* button = qobject_cast<const QToolButton*>(w);
        const QAction* command = button ? button->defaultAction() : nullptr;
        if (command && (in_menus.contains(command) || !command->shortcut().isEmpty())) continue;
        found << described(*w);
    }
    return found;
}

QStringList shared_mnemonics(QWidget& window) {
    QStringList found;
    TakenLetters taken;
    for (const QWidget* w : window.findChildren<const QWidget*>()) {
        if (!w->isVisible() || w->window() != &window || w->visibleRegion().isEmpty()) continue;
        if (const auto* button = qobject_cast<const QAbstractButton*>(w))
            take_letter(taken, button->text(), found);
        else if (const auto* label = qobject_cast<const QLabel*>(w); label && label->buddy())
            take_letter(taken, label->text(), found);
        else if (const auto* group = qobject_cast<const QGroupBox*>(w))
            take_letter(taken, group->title(), found);
        else if (const auto* tabs = qobject_cast<const QTabBar*>(w))
            for (int i = 0; i < tabs->count(); ++i)
                take_letter(taken, tabs->tabText(i), found);
        else if (const auto* menus = qobject_cast<const QMenuBar*>(w))
            for (const QAction* menu : menus->actions())
                take_letter(taken, menu->text(), found);
    }
    return found;
}

QStringList faint_words(QWidget& window) {
    QStringList found;
    WordColors words(found);
    for (const QWidget* w : window.findChildren<const QWidget*>()) {
        if (!w->isVisible() || !w->isEnabled() || w->window() != &window) continue;
        const auto* label = qobject_cast<const QLabel*>(w);
        const QPalette p = w->palette();
        if ((label && !label->text().isEmpty()) || qobject_cast<const QAbstractButton*>(w))
            words.look(*w, p.color(w->foregroundRole()), ground_of(*w),
                       label ? label->text() : static_cast<const QAbstractButton*>(w)->text());
        if (label) words.look_at_marks(*label);
        if (qobject_cast<const QLineEdit*>(w) || qobject_cast<const QAbstractItemView*>(w)
            || qobject_cast<const QAbstractSpinBox*>(w)) {
            words.look(*w, p.color(QPalette::Text), p.color(QPalette::Base));
            words.look(*w, p.color(QPalette::HighlightedText), p.color(QPalette::Highlight));
        }
        if (qobject_cast<const QComboBox*>(w))
            words.look(*w, p.color(QPalette::ButtonText), p.color(QPalette::Button));
        if (const auto* tree = qobject_cast<const QTreeWidget*>(w)) words.look_at_tree(*tree);
        if (const auto* page = qobject_cast<const QTextBrowser*>(w)) words.look_at_page(*page);
    }
    return found;
}

QStringList without_help(QWidget& window) {
    QStringList found;
    if (qobject_cast<ui::HelpWindow*>(&window)) return found;
    for (const QWidget* w : controls_of(window)) {
        const QString topic = ui::help_topic(w);
        const QString key = w->property(ui::help_key_property).toString();
        if (topic.isEmpty() || !ui::has_help(topic))
            found << described(*w) + QStringLiteral("F1 leads to “%1”").arg(topic);
        else if (!key.isEmpty() && topic.startsWith(QLatin1String("reference"))
                 && !topic.endsWith(QChar('-') + key))
            found << described(*w) + key + QStringLiteral(": F1 leads to “%1”").arg(topic);
    }
    return found;
}

} // namespace facetmill::test
