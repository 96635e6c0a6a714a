#include "ui/project_tree_view.h"

#include "ui/node_names.h"
#include "ui/operation_list.h"
#include "ui/project_items.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QDropEvent>
#include <QSignalBlocker>

#include <functional>

namespace facetmill::ui {

namespace {

TreeNode::Kind kind_of(const QTreeWidgetItem* item) {
    return node_of(item).kind;
}

} // namespace

ProjectTreeView::ProjectTreeView(Document& document, QWidget* parent)
    : QTreeWidget(parent), document_(document) {
    setAccessibleName(tr("Project"));
    setDragDropMode(QAbstractItemView::InternalMove);
    setDragEnabled(true);
    setDropIndicatorShown(true);
    setEditTriggers(QAbstractItemView::NoEditTriggers); // F2 does, not a click
    connect(this, &QTreeWidget::itemChanged, this, &ProjectTreeView::take_name);
    // The drag, and the field over a name, are still on their way through items that a change makes anew.
    connect(this, &ProjectTreeView::moved, this,
            [this](QTreeWidgetItem* operation, QTreeWidgetItem* onto, bool behind) {
                QMetaObject::invokeMethod(
                    this,
                    [this, what = node_of(operation), where = node_of(onto), behind] {
                        drop(what, where, behind);
                    },
                    Qt::QueuedConnection);
            });
}

QTreeWidgetItem* ProjectTreeView::item_of(const TreeNode& node) const {
    const std::function<QTreeWidgetItem*(QTreeWidgetItem*)> find =
        [&](QTreeWidgetItem* from) -> QTreeWidgetItem* {
        for (int i = 0; i < from->childCount(); ++i) {
            QTreeWidgetItem* child = from->child(i);
            if (node_of(child) == node) return child;
            if (QTreeWidgetItem* below = find(child)) return below;
        }
        return nullptr;
    };
    return find(invisibleRootItem());
}

bool ProjectTreeView::edit_name() {
    QTreeWidgetItem* item = currentItem();
    if (!item || !(item->flags() & Qt::ItemIsEditable)) return false;
    editItem(item, 0);
    return true;
}

void ProjectTreeView::take_name(QTreeWidgetItem* item) {
    if (state() != QAbstractItemView::EditingState) return; // an item that is made or shows a state
    const TreeNode node = node_of(item);
    if (item->text(0) == node_name(document_, node)) return;
    QMetaObject::invokeMethod(
        this, [this, node, name = utf8(item->text(0).trimmed())] { rename(node, name); },
        Qt::QueuedConnection);
}

void ProjectTreeView::rename(const TreeNode& node, const std::string& name) {
    try {
        rename_node(document_, node, name);
    } catch (const Error& e) {
        emit refused(sentence(worded(e)));
    }
    if (QTreeWidgetItem* now = item_of(node)) {
        const QSignalBlocker still(this);
        now->setText(0, node_name(document_, node));
    }
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

void ProjectTreeView::drop(const TreeNode& operation, const TreeNode& onto, bool behind) {
    const Project& project = document_.project();
    const std::size_t own = chosen_setup(project);
    std::size_t setup = own, at = document_.operation_count();
    if (onto.kind == TreeNode::Kind::operation) {
        at = onto.index + (behind ? 1 : 0);
    } else if (const auto there = setup_of(project, onto)) {
        setup = *there;
        at = setup_at(project, setup).operations.size();
        if (onto.kind == TreeNode::Kind::elsewhere) {
            at = onto.index + (behind ? 1 : 0);
            for (std::size_t k = 0; k < setup; ++k)
                at -= setup_at(project, k).operations.size();
        }
    }
    const int id = document_.operation_id(operation.index);
    if (!place_operation(document_, operation.index, setup, at)) return;
    if (const auto place = document_.index_of(id)) emit placed(*place);
}

} // namespace facetmill::ui
