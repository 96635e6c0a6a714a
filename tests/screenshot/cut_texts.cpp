#include "tests/screenshot/cut_texts.h"

#include "ui/elided_label.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QStyleOptionGroupBox>
#include <QTabBar>
#include <QTextDocument>
#include <QToolButton>

namespace facetmill::test {

namespace {

constexpr int slack = 1; ///< pixels that rounding takes

QString cut(const QWidget& widget, const QString& words, int room, int need) {
    QString place;
    for (const QWidget* w = &widget; w && place.size() < 60; w = w->parentWidget())
        if (!w->objectName().isEmpty()) place = w->objectName() + QChar('/') + place;
    return QStringLiteral("%1 %2“%3”: %4 of %5 px")
        .arg(QLatin1String(widget.metaObject()->className()), place, words.left(60))
        .arg(room)
        .arg(need);
}

void look_at_label(const QLabel& label, QStringList& found) {
    if (label.text().isEmpty() || !label.pixmap(Qt::ReturnByValue).isNull()
        || qobject_cast<const ui::ElidedLabel*>(&label))
        return;
    const QSize need = label.wordWrap() ? QSize(0, label.heightForWidth(label.width())) : label.sizeHint();
    if (need.width() > label.width() + slack) found << cut(label, label.text(), label.width(), need.width());
    if (need.height() > label.height() + slack)
        found << cut(label, label.text(), label.height(), need.height());
    if (!label.wordWrap() || Qt::mightBeRichText(label.text())) return;
    // Lines break between words alone.
    for (const QString& word : label.text().split(QChar(' ')))
        if (const int width = label.fontMetrics().horizontalAdvance(word);
            width > label.contentsRect().width())
            found << cut(label, word, label.contentsRect().width(), width);
}

void look_at_button(const QAbstractButton& button, QStringList& found) {
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (button.text().isEmpty()
        || (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()))
        return;
    const int need = button.sizeHint().width();
    if (need > button.width() + slack) found << cut(button, button.text(), button.width(), need);
}

void look_at_tabs(const QTabBar& tabs, QStringList& found) {
    for (int i = 0; i < tabs.count(); ++i) {
        const int need = tabs.fontMetrics().horizontalAdvance(tabs.tabText(i));
        if (tabs.tabRect(i).width() < need)
            found << cut(tabs, tabs.tabText(i), tabs.tabRect(i).width(), need);
    }
}

void look_at_heads(const QHeaderView& heads, QStringList& found) {
    if (heads.orientation() != Qt::Horizontal) return;
    for (int i = 0; i < heads.count(); ++i) {
        const QString words = heads.model()->headerData(i, Qt::Horizontal).toString();
        int need = 0;
        for (const QString& line : words.split(QChar('\n')))
            need = std::max(need, heads.fontMetrics().horizontalAdvance(line));
        if (!heads.isSectionHidden(i) && heads.sectionSize(i) < need)
            found << cut(heads, words, heads.sectionSize(i), need);
    }
}

void look_at_menus(const QMenuBar& menus, QStringList& found) {
    for (const QAction* a : menus.actions())
        if (const QRect at = menus.actionGeometry(const_cast<QAction*>(a));
            a->isVisible() && at.right() > menus.width())
            found << cut(menus, a->text(), menus.width(), at.right());
}

} // namespace

QStringList cut_texts(const QWidget& window) {
    QStringList found;
    for (const QWidget* w : window.findChildren<const QWidget*>()) {
        if (!w->isVisible() || w->window() != &window) continue;
        if (const auto* label = qobject_cast<const QLabel*>(w))
            look_at_label(*label, found);
        else if (const auto* button = qobject_cast<const QAbstractButton*>(w))
            look_at_button(*button, found);
        else if (const auto* tabs = qobject_cast<const QTabBar*>(w))
            look_at_tabs(*tabs, found);
        else if (const auto* heads = qobject_cast<const QHeaderView*>(w))
            look_at_heads(*heads, found);
        else if (const auto* menus = qobject_cast<const QMenuBar*>(w))
            look_at_menus(*menus, found);
        else if (const auto* group = qobject_cast<const QGroupBox*>(w);
                 group && group->fontMetrics().horizontalAdvance(group->title()) > group->width())
            found << cut(*group, group->title(), group->width(),
                         group->fontMetrics().horizontalAdvance(group->title()));
    }
    found.removeDuplicates();
    return found;
}

} // namespace facetmill::test
