#include "ui/node_names.h"

#include "core/base/text.h"
#include "ui/boundary_list.h"
#include "ui/text.h"

#include <algorithm>

namespace facetmill::ui {

namespace {

using NodeKind = TreeNode::Kind;

/// All names that have to differ from each other, with that of the node among them at `own`.
struct Names {
    std::vector<std::string> all;
    std::size_t own = 0;
    const char* what = ""; ///< none: it has no name
};

Names names_of(const Project& project, const TreeNode& node) {
    Names names;
    names.own = node.index;
    const auto add = [&](const char* what, const auto& list, const auto& name) {
        names.what = what;
        for (const auto& one : list)
            names.all.push_back(name(one));
    };
    const auto own_name = [](const auto& one) { return one.name; };
    if (node.kind == NodeKind::operation) {
        add("operation", all_operations(project), [](const Operation* o) { return o->common().name; });
        names.own += operations_before(project);
    } else if (node.kind == NodeKind::setup) {
        names.what = "setup";
        for (std::size_t k = 0; k < setup_count(project); ++k)
            names.all.push_back(setup_at(project, k).name);
    } else if (node.kind == NodeKind::fixture) {
        add("fixture", project.fixtures, own_name);
    } else if (node.kind == NodeKind::boundary) {
        add("boundary", project.boundaries, own_name);
    }
    return names;
}

} // namespace

QString node_name(const Document& document, const TreeNode& node) {
    const Names names = names_of(document.project(), node);
    return names.own < names.all.size() ? text(names.all[names.own]) : QString();
}

void rename_node(Document& document, const TreeNode& node, const std::string& name) {
    const Names names = names_of(document.project(), node);
    if (names.own >= names.all.size() || names.all[names.own] == name) return;
    const std::string what = names.what, where = what + " '" + printable(names.all[names.own]) + "'";
    if (name.find_first_not_of(' ') == std::string::npos)
        throw Error(ErrorCode::out_of_range, where, "the name is empty", "give it a name");
    check_text(name, where);
    if (std::find(names.all.begin(), names.all.end(), name) != names.all.end())
        throw Error(ErrorCode::out_of_range, where,
                    "another " + what + " is called '" + printable(name) + "'", "choose another name");
    if (node.kind == NodeKind::boundary) return rename_boundary(document, node.index, name);
    const QString step = node.kind == NodeKind::operation ? Document::tr("Rename operation")
                         : node.kind == NodeKind::setup   ? Document::tr("Rename setup")
                                                          : Document::tr("Rename fixture");
    document.change(step, [&](Project& p) {
        if (node.kind == NodeKind::operation)
            p.operations[node.index]->common().name = name;
        else if (node.kind == NodeKind::setup)
            setup_at(p, node.index).name = name;
        else
            p.fixtures[node.index].name = name;
    });
}

} // namespace facetmill::ui
