#include "tests/screenshot/cut_texts.h"

#include "ui/elided_label.h"
#include "ui/help_browser.h"
#include "ui/whole_text.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabBar>
#include <QTextDocument>
#include <QTextEdit>
#include <QToolButton>
#include <QToolTip>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>

namespace facetmill::test {

namespace {

constexpr int slack = 1; ///< pixels that rounding takes

/// What is at fault, in a line.
class Faults {
public:
    explicit Faults(const QWidget& widget) : widget_(widget) {}

    void add(const QString& words, int room, int need) {
        if (need > room + slack) found << name(words) + QStringLiteral(": %1 of %2 px").arg(room).arg(need);
    }
    void add(const QString& words, const char* why) { found << name(words) + QLatin1String(why); }

    QStringList found;

private:
    QString name(const QString& words) const {
        QString place;
        for (const QWidget* w = &widget_; w && place.size() < 60; w = w->parentWidget())
            if (!w->objectName().isEmpty()) place = w->objectName() + QChar('/') + place;
        return QStringLiteral("%1 %2“%3”")
            .arg(QLatin1String(widget_.metaObject()->className()), place, words.left(60));
    }
    const QWidget& widget_;
};

/// To the right and left there is nothing to scroll to.
void look_at_edges(const QWidget& w, const QString& words, int need, Faults& faults) {
    const QRect seen = w.visibleRegion().boundingRect();
    if (!words.isEmpty() && !seen.isEmpty()) faults.add(words, seen.width(), std::min(need, w.width()));
}

void look_at_label(const QLabel& label, Faults& faults) {
    const QString words = label.text();
    if (words.isEmpty() || !label.pixmap(Qt::ReturnByValue).isNull()) return;
    if (qobject_cast<const ui::ElidedLabel*>(&label)) {
        if (label.fontMetrics().horizontalAdvance(words) > label.contentsRect().width()
            && !label.toolTip().contains(words))
            faults.add(words, ": shortened without a tool tip");
        return;
    }
    const QSize need = label.wordWrap() ? QSize(0, label.heightForWidth(label.width())) : label.sizeHint();
    faults.add(words, label.width(), need.width());
    faults.add(words, label.height(), need.height());
    if (label.wordWrap() && Qt::mightBeRichText(words)) { // a table has a least width of its own
        QTextDocument whole;
        whole.setDefaultFont(label.font());
        whole.setDocumentMargin(0);
        whole.setHtml(words);
        whole.setTextWidth(label.contentsRect().width());
        faults.add(words, label.contentsRect().width(),
                   int(std::ceil(std::max(whole.size().width(), whole.idealWidth()))));
    }
    look_at_edges(label, words, need.width(), faults);
    if (!label.wordWrap() || Qt::mightBeRichText(words)) return;
    // Lines break between words alone.
    for (const QString& word : words.split(QChar(' ')))
        faults.add(word, label.contentsRect().width(), label.fontMetrics().horizontalAdvance(word));
}

void look_at_button(const QAbstractButton& button, Faults& faults) {
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    const QString words = button.text();
    if (words.isEmpty()
        || (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()))
        return;
    // Frames may be narrower than a style would like; words may not.
    int need = button.sizeHint().width();
    if (tool || qobject_cast<const QPushButton*>(&button))
        need = button.fontMetrics().size(Qt::TextShowMnemonic, words).width()
               + (button.icon().isNull() ? 0 : button.iconSize().width() + 4);
    faults.add(words, button.width(), need);
    look_at_edges(button, words, need, faults);
}

void look_at_tabs(const QTabBar& tabs, Faults& faults) {
    for (int i = 0; i < tabs.count(); ++i)
        faults.add(tabs.tabText(i), tabs.tabRect(i).width(),
                   tabs.fontMetrics().size(Qt::TextShowMnemonic, tabs.tabText(i)).width());
}

void look_at_heads(const QHeaderView& heads, Faults& faults) {
    if (heads.orientation() != Qt::Horizontal) return;
    const int beside = 2 * heads.style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &heads);
    for (int i = 0; i < heads.count(); ++i) {
        const QString words = heads.model()->headerData(i, Qt::Horizontal).toString();
        int need = 0;
        for (const QString& line : words.split(QChar('\n')))
            need = std::max(need, heads.fontMetrics().horizontalAdvance(line));
        if (!heads.isSectionHidden(i)) faults.add(words, heads.sectionSize(i), need + beside);
    }
}

void look_at_menus(const QMenuBar& menus, Faults& faults) {
    for (const QAction* a : menus.actions())
        if (a->isVisible())
            faults.add(a->text(), menus.width(), menus.actionGeometry(const_cast<QAction*>(a)).right());
}

/// A field or a choice is shortened with "…" where the pointer is told the whole.
void look_at_field(QWidget& field, Faults& faults) {
    const QString whole = ui::shortened_text(field);
    if (whole.isEmpty()) return;
    QHelpEvent event(QEvent::ToolTip, field.rect().center(), field.mapToGlobal(field.rect().center()));
    QApplication::sendEvent(&field, &event);
    const QString told = QToolTip::text();
    if (!told.contains(whole.toHtmlEscaped()) && !told.contains(whole))
        faults.add(whole, ": shortened without a tool tip");
    QToolTip::hideText();
}

void look_at_tree(const QTreeWidget& tree, Faults& faults) {
    for (QTreeWidgetItemIterator it(const_cast<QTreeWidget*>(&tree)); *it; ++it) {
        const QTreeWidgetItem& item = **it;
        const QRect row = tree.visualItemRect(&item);
        if (row.isEmpty() || item.isHidden() || item.isFirstColumnSpanned()) continue;
        for (int c = 0; c < tree.columnCount(); ++c) {
            const QString words = item.text(c);
            if (words.isEmpty() || tree.isColumnHidden(c) || !item.toolTip(c).isEmpty()) continue;
            const int indent = c == tree.header()->logicalIndex(0) ? row.left() : 0;
            const int icon = item.icon(c).isNull()       ? 0
                             : tree.iconSize().isValid() ? tree.iconSize().width()
                                                         : 16;
            faults.add(words, tree.columnWidth(c) - indent - icon,
                       tree.fontMetrics().horizontalAdvance(words));
        }
    }
}

void gather(const QLayout& layout, QList<const QWidget*>& widgets) {
    for (int i = 0; i < layout.count(); ++i) {
        const QLayoutItem& item = *layout.itemAt(i);
        if (const QWidget* w = const_cast<QLayoutItem&>(item).widget(); w && w->isVisible())
            widgets << w;
        else if (const QLayout* inner = const_cast<QLayoutItem&>(item).layout())
            gather(*inner, widgets);
    }
}

/// What stands in one layout stands side by side: where its room is too small, things lie over each other.
void look_at_places(const QWidget& w, Faults& faults) {
    if (!w.layout()) return;
    QList<const QWidget*> widgets;
    gather(*w.layout(), widgets);
    for (qsizetype i = 0; i < widgets.size(); ++i)
        for (qsizetype j = 0; j < i; ++j)
            if (const QRect both = widgets[i]->geometry() & widgets[j]->geometry();
                both.width() > slack && both.height() > slack)
                faults.add(widgets[i]->objectName() + QStringLiteral(" and ") + widgets[j]->objectName(),
                           ": one lies over the other");
}

/// What is worked with is there whole, also what has no words.
void look_at_control(const QWidget& w, Faults& faults) {
    const bool control = qobject_cast<const QAbstractButton*>(&w) || qobject_cast<const QComboBox*>(&w)
                         || qobject_cast<const QLineEdit*>(&w) || qobject_cast<const QAbstractSpinBox*>(&w);
    if (control && !qobject_cast<const QTabBar*>(w.parentWidget()))
        look_at_edges(w, QStringLiteral("-"), w.width(), faults);
}

void look_at_progress(const QProgressBar& bar, Faults& faults) {
    if (bar.isTextVisible())
        faults.add(bar.text(), bar.contentsRect().width(), bar.fontMetrics().horizontalAdvance(bar.text()));
}

QStringList look_at(const QWidget& w) {
    Faults faults(w);
    look_at_control(w, faults);
    look_at_places(w, faults);
    if (const auto* label = qobject_cast<const QLabel*>(&w))
        look_at_label(*label, faults);
    else if (const auto* button = qobject_cast<const QAbstractButton*>(&w))
        look_at_button(*button, faults);
    else if (const auto* bar = qobject_cast<const QProgressBar*>(&w))
        look_at_progress(*bar, faults);
    else if (const auto* tabs = qobject_cast<const QTabBar*>(&w))
        look_at_tabs(*tabs, faults);
    else if (const auto* heads = qobject_cast<const QHeaderView*>(&w))
        look_at_heads(*heads, faults);
    else if (const auto* menus = qobject_cast<const QMenuBar*>(&w))
        look_at_menus(*menus, faults);
    else if (qobject_cast<const QComboBox*>(&w) || qobject_cast<const QLineEdit*>(&w))
        look_at_field(const_cast<QWidget&>(w), faults);
    else if (const auto* tree = qobject_cast<const QTreeWidget*>(&w))
        look_at_tree(*tree, faults);
    else if (const auto* group = qobject_cast<const QGroupBox*>(&w))
        faults.add(group->title(), group->width(), group->fontMetrics().horizontalAdvance(group->title()));
    return faults.found;
}

} // namespace

QStringList cut_texts(const QWidget& window) {
    QStringList found;
    for (const QWidget* w : window.findChildren<const QWidget*>())
        if (w->isVisible() && w->window() == &window && !w->visibleRegion().isEmpty()) found << look_at(*w);
    found.removeDuplicates();
    return found;
}

QStringList parted_numbers(const QWidget& window) {
    static const QRegularExpression parted(
        QStringLiteral("(?:(?<![\\w.,])\\d[\\d.,]*|\\)) (?:%|(?:mm|in|s|min|h|rpm)\\b)"));
    QStringList found;
    const auto look = [&](const QString& words) {
        if (const auto match = parted.match(words); match.hasMatch())
            found << QStringLiteral("“%1” may part in “%2”").arg(match.captured(), words.left(200));
    };
    for (const QWidget* w : window.findChildren<const QWidget*>()) {
        if (!w->isVisible() || w->window() != &window) continue;
        if (const auto* label = qobject_cast<const QLabel*>(w); label && label->wordWrap())
            look(label->text());
        else if (const auto* text = qobject_cast<const QTextEdit*>(w);
                 text && !qobject_cast<const ui::HelpBrowser*>(w))
            look(text->document()->toRawText());
        else if (const auto* log = qobject_cast<const QPlainTextEdit*>(w))
            look(log->document()->toRawText());
    }
    return found;
}

} // namespace facetmill::test
