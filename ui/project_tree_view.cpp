#include "ui/project_tree_view.h"

#include "ui/project_items.h"

#include <QDropEvent>

namespace facetmill::ui {

namespace {

TreeNode::Kind kind_of(const QTreeWidgetItem* item) {
    return TreeNode::Kind(item->data(0, kind_role).toInt());
}

} // namespace

ProjectTreeView::ProjectTreeView(QWidget* parent) : QTreeWidget(parent) {
    setDragDropMode(QAbstractItemView::InternalMove);
    setDragEnabled(true);
    setDropIndicatorShown(true);
    setEditTriggers(QAbstractItemView::NoEditTriggers); // F2 does, not a click
}

void ProjectTreeView::startDrag(Qt::DropActions actions) {
    if (currentItem() && kind_of(currentItem()) == TreeNode::Kind::operation) QTreeWidget::startDrag(actions);
}

std::pair<QTreeWidgetItem*, bool> ProjectTreeView::target(const QPoint& at) const {
    QTreeWidgetItem* item = itemAt(at);
    if (!item) return {nullptr, false};
    switch (kind_of(item)) {
    case TreeNode::Kind::operation:
    case TreeNode::Kind::elsewhere: {
        const QRect rect = visualItemRect(item);
        return {item, at.y() > rect.center().y()};
    }
    case TreeNode::Kind::stock_after:
        return {item->parent(), true};
    case TreeNode::Kind::operations:
    case TreeNode::Kind::setup:
        return {item, true};
    default:
        return {nullptr, false};
    }
}

void ProjectTreeView::dragMoveEvent(QDragMoveEvent* event) {
    QTreeWidget::dragMoveEvent(event); // scrolls, and draws where it would go
    if (event->source() != this || !target(event->position().toPoint()).first)
        event->ignore();
    else
        event->acceptProposedAction();
}

void ProjectTreeView::dropEvent(QDropEvent* event) {
    // The items are made anew from the project: none is moved here.
    setState(QAbstractItemView::NoState);
    viewport()->update();
    const auto [onto, behind] = target(event->position().toPoint());
    if (event->source() != this || !onto || !currentItem()) return event->ignore();
    event->setDropAction(Qt::CopyAction);
    event->accept();
    emit moved(currentItem(), onto, behind);
}

} // namespace facetmill::ui
