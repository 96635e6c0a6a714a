// The tree widget of the project: names are changed over its items, operations are dragged to another place.
#pragma once

#include "ui/project_tree.h"

#include <QTreeWidget>

#include <utility>

namespace facetmill::ui {

class ProjectTreeView : public QTreeWidget {
    Q_OBJECT
public:
    explicit ProjectTreeView(Document& document, QWidget* parent = nullptr);

    /// Null: there is none.
    QTreeWidgetItem* item_of(const TreeNode& node) const;
    /// Opens a field over the current item; false where that has no name of its own.
    bool edit_name();

signals:
    /// An operation was let go over another item, or between it and the next: then `behind`.
    void moved(QTreeWidgetItem* operation, QTreeWidgetItem* onto, bool behind);
    /// An operation of the shown setup has come to this place of it.
    void placed(std::size_t operation);
    /// A name that the project refuses.
    void refused(const QString& why);

protected:
    void startDrag(Qt::DropActions actions) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// Where a drop at a place of the view goes; null: nowhere.
    std::pair<QTreeWidgetItem*, bool> target(const QPoint& at) const;
    void drop(const TreeNode& operation, const TreeNode& onto, bool behind);
    void take_name(QTreeWidgetItem* item);
    void rename(const TreeNode& node, const std::string& name);

    Document& document_;
};

} // namespace facetmill::ui
