// Names of operations, setups, fixtures and boundaries, as the tree shows and changes them.
#pragma once

#include "ui/document.h"
#include "ui/project_tree.h"

namespace facetmill::ui {

/// Empty for what has no name of its own, and for what is not there.
QString node_name(const Document& document, const TreeNode& node);
/// As one step of the history; operations that name a boundary follow. Throws Error(out_of_range): an empty
/// name, or one that another of its kind has; what check_text throws.
void rename_node(Document& document, const TreeNode& node, const std::string& name);

} // namespace facetmill::ui
