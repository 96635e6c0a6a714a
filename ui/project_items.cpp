#include "ui/project_items.h"

#include "core/output/post/post.h"
#include "core/setup/machine.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QTreeWidget>

namespace facetmill::ui {

namespace {

QString stock_label(const Project& project) {
    switch (project.stock.kind) {
    case StockSpec::Kind::box:
        return QObject::tr("Stock: box");
    case StockSpec::Kind::cylinder:
        return QObject::tr("Stock: cylinder");
    case StockSpec::Kind::mesh:
        return QObject::tr("Stock: %1").arg(path_text(project.stock_path().filename()));
    case StockSpec::Kind::rest:
        return QObject::tr("Stock: rest of “%1”")
            .arg(text(project.before.empty() ? std::string() : project.before.back().name));
    }
    return {};
}

class ProjectItems {
public:
    ProjectItems(QTreeWidget& tree, const Document& document) : tree_(tree), project_(document.project()) {}
    void build();

private:
    QTreeWidgetItem* add_item(QTreeWidgetItem* parent, TreeNode node, Icon which, const QString& label,
                              const QString& help = {}) {
        return add_tree_item(parent ? parent : tree_.invisibleRootItem(), node, which, label, help);
    }
    /// Stock, fixtures, boundaries and machine of the chosen setup, below its item where there are several.
    void add_setup_items(QTreeWidgetItem* setup);
    void add_operations(QTreeWidgetItem* setup);
    void add_other_setup(std::size_t i, QTreeWidgetItem* setup);

    QTreeWidget& tree_;
    const Project& project_;
};

void ProjectItems::build() {
    const LengthUnit unit = project_.unit;
    const auto file = project_.part_path();
    add_item(nullptr, {TreeNode::Kind::part, 0}, Icon::part, path_text(file.filename()), path_text(file));
    const std::size_t setups = setup_count(project_);
    if (setups == 1) add_setup_items(nullptr);
    add_item(nullptr, {TreeNode::Kind::limits, 0}, Icon::verify, QObject::tr("Verification limits"));
    auto* tools = add_item(nullptr, {TreeNode::Kind::tools, 0}, Icon::tool, QObject::tr("Tools"));
    for (std::size_t i = 0; i < project_.tools.size(); ++i) {
        const Tool& t = project_.tools[i];
        const QString size = QStringLiteral("⌀ %1").arg(shown_length(t.diameter, unit, 5));
        add_item(
            tools, {TreeNode::Kind::tool, i}, Icon::tool,
            QObject::tr("T%1  %2").arg(t.number).arg(text(t.name)),
            QObject::tr("T%1  %2\n%3, %4").arg(t.number).arg(text(t.name), worded(t.shape_name()), size));
    }
    if (setups == 1) add_operations(nullptr);
    for (std::size_t i = 0; setups > 1 && i < setups; ++i) {
        const QString name = text(setup_at(project_, i).name);
        const bool chosen = i == chosen_setup(project_);
        auto* setup = add_item(nullptr, {TreeNode::Kind::setup, i}, Icon::place, name,
                               chosen ? QObject::tr("%1: shown, planned and verified now").arg(name)
                                      : QObject::tr("%1: a double click goes there").arg(name));
        QFont font = setup->font(0);
        font.setBold(chosen);
        setup->setFont(0, font);
        if (chosen) {
            add_setup_items(setup);
            add_operations(setup);
        } else {
            add_other_setup(i, setup);
        }
    }
}

void ProjectItems::add_setup_items(QTreeWidgetItem* setup) {
    add_item(setup, {TreeNode::Kind::stock, 0}, Icon::stock, stock_label(project_));
    for (std::size_t i = 0; i < project_.fixtures.size(); ++i)
        add_item(setup, {TreeNode::Kind::fixture, i}, Icon::fixture, text(project_.fixtures[i].name),
                 QObject::tr("%1: no tool comes nearer than %2")
                     .arg(text(project_.fixtures[i].name),
                          shown_length(project_.fixtures[i].clearance, project_.unit, 4)));
    for (std::size_t i = 0; i < project_.boundaries.size(); ++i)
        add_item(setup, {TreeNode::Kind::boundary, i}, Icon::boundary, text(project_.boundaries[i].name),
                 QObject::tr("%1: a region that operations cut within or keep off")
                     .arg(text(project_.boundaries[i].name)));
    QString machine = text(project_.machine);
    for (const Machine& m : machines())
        if (m.name == project_.machine) machine = worded(m.label);
    if (const std::string& post = project_.programs.post; !post.empty()) {
        QString control = text(post);
        for (const Post& p : posts())
            if (p.name == post) control = worded(p.label);
        machine = QObject::tr("%1, %2").arg(machine, control);
    }
    add_item(setup, {TreeNode::Kind::machine, 0}, Icon::machine, machine);
}

void ProjectItems::add_operations(QTreeWidgetItem* setup) {
    auto* operations =
        add_item(setup, {TreeNode::Kind::operations, 0}, Icon::operations, QObject::tr("Operations"));
    for (std::size_t i = 0; i < project_.operations.size(); ++i)
        add_item(operations, {TreeNode::Kind::operation, i}, Icon::not_planned,
                 text(project_.operations[i]->common().name));
}

void ProjectItems::add_other_setup(std::size_t i, QTreeWidgetItem* setup) {
    std::size_t place = 0;
    for (std::size_t k = 0; k < i; ++k)
        place += setup_at(project_, k).operations.size();
    for (const auto& operation : setup_at(project_, i).operations) {
        auto* item = add_item(setup, {TreeNode::Kind::elsewhere, place++}, Icon::operation,
                              text(operation->common().name));
        item->setForeground(0, tree_.palette().color(QPalette::PlaceholderText));
    }
}

} // namespace

TreeNode node_of(const QTreeWidgetItem* item) {
    return {TreeNode::Kind(item->data(0, kind_role).toInt()), item->data(0, index_role).toULongLong()};
}

QTreeWidgetItem* add_tree_item(QTreeWidgetItem* parent, TreeNode node, Icon which, const QString& label,
                               const QString& help) {
    auto* item = new QTreeWidgetItem(parent);
    item->setText(0, label);
    item->setIcon(0, icon(which));
    item->setToolTip(0, (help.isEmpty() ? label : help));
    item->setData(0, kind_role, int(node.kind));
    item->setData(0, index_role, qulonglong(node.index));
    using Kind = TreeNode::Kind;
    for (const Kind named : {Kind::operation, Kind::setup, Kind::fixture, Kind::boundary})
        if (node.kind == named) item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setFlags(item->flags() & ~Qt::ItemIsDragEnabled);
    if (node.kind == Kind::operation) item->setFlags(item->flags() | Qt::ItemIsDragEnabled);
    return item;
}

std::optional<std::size_t> setup_of(const Project& project, const std::optional<TreeNode>& node) {
    if (!node) return std::nullopt;
    if (node->kind == TreeNode::Kind::setup) return node->index;
    if (node->kind != TreeNode::Kind::elsewhere) return std::nullopt;
    const std::vector<const Operation*> all = all_operations(project);
    if (node->index >= all.size()) return std::nullopt;
    return setup_of_operation(project, all[node->index]->common().name);
}

void fill_tree(QTreeWidget& tree, const Document& document) {
    ProjectItems(tree, document).build();
}

} // namespace facetmill::ui
