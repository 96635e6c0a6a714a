// The tree widget of the project: operations are dragged to another place of it.
#pragma once

#include <QTreeWidget>

namespace facetmill::ui {

class ProjectTreeView : public QTreeWidget {
    Q_OBJECT
public:
    explicit ProjectTreeView(QWidget* parent = nullptr);

signals:
    /// An operation was let go over another item, or between it and the next: then `behind`.
    void moved(QTreeWidgetItem* operation, QTreeWidgetItem* onto, bool behind);

protected:
    void startDrag(Qt::DropActions actions) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// Where a drop at a place of the view goes; null: nowhere.
    std::pair<QTreeWidgetItem*, bool> target(const QPoint& at) const;
};

} // namespace facetmill::ui
