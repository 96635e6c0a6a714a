// A row of a list that is sorted by the numbers behind its texts.
#pragma once

#include <QTreeWidget>
#include <QVariant>

namespace facetmill::ui {

class SortedItem : public QTreeWidgetItem {
public:
    /// Data of a column under this role: the number it is sorted by. Columns without one are sorted by text.
    static constexpr int sort_role = Qt::UserRole + 1;

    bool operator<(const QTreeWidgetItem& other) const override {
        const int column = treeWidget()->sortColumn();
        const QVariant a = data(column, sort_role), b = other.data(column, sort_role);
        if (a.isValid() && b.isValid()) return a.toDouble() < b.toDouble();
        return QString::localeAwareCompare(text(column), other.text(column)) < 0;
    }
};

} // namespace facetmill::ui
