// The items of the project's tree: which there are, and what they say while nothing is planned.
#pragma once

#include "ui/icons.h"
#include "ui/project_tree.h"

class QTreeWidget;
class QTreeWidgetItem;

namespace facetmill::ui {

/// Data of an item: its TreeNode.
inline constexpr int kind_role = Qt::UserRole, index_role = Qt::UserRole + 1;

TreeNode node_of(const QTreeWidgetItem* item);
QTreeWidgetItem* add_tree_item(QTreeWidgetItem* parent, TreeNode node, Icon which, const QString& label,
                               const QString& help = {});
/// The setup that an item stands for, or has its operation, where that is not the chosen one's.
std::optional<std::size_t> setup_of(const Project& project, const std::optional<TreeNode>& node);
/// All items of a document with a part, into an empty tree. Setups have items where there are several.
void fill_tree(QTreeWidget& tree, const Document& document);

} // namespace facetmill::ui
