#include "ui/project_tree.h"

#include "ui/boundary_list.h"
#include "ui/boundary_menu.h"
#include "ui/fixture_list.h"
#include "ui/fixture_menu.h"
#include "ui/operation_actions.h"
#include "ui/operation_list.h"
#include "ui/operation_menu.h"
#include "ui/project_items.h"
#include "ui/project_tree_view.h"
#include "ui/setup_list.h"
#include "ui/text.h"
#include "ui/tool_library_dialog.h"
#include "ui/tool_list.h"
#include "ui/verification_model.h"
#include "ui/worded.h"

#include <QAction>
#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace facetmill::ui {

namespace {

constexpr int badge_column = 1, badge_width = 26;

Icon state_icon(OperationState state) {
    switch (state) {
    case OperationState::not_planned:
        return Icon::not_planned;
    case OperationState::planning:
        return Icon::planning;
    case OperationState::planned:
        return Icon::planned;
    case OperationState::stale:
        return Icon::stale;
    case OperationState::failed:
        return Icon::error;
    case OperationState::off:
        return Icon::switched_off;
    }
    return Icon::not_planned;
}

/// One of a list that is no setup; false for anything else.
bool duplicate_in_list(Document& document, const TreeNode& node) {
    if (node.kind == TreeNode::Kind::tool)
        duplicate_tool(document, node.index);
    else if (node.kind == TreeNode::Kind::fixture)
        duplicate_fixture(document, node.index);
    else if (node.kind == TreeNode::Kind::boundary)
        duplicate_boundary(document, node.index);
    else if (node.kind == TreeNode::Kind::operation)
        duplicate_operation(document, node.index);
    else
        return false;
    return true;
}

/// Throws Error(missing_reference) where an operation needs it.
void remove_from_list(Document& document, const TreeNode& node) {
    if (node.kind == TreeNode::Kind::tool)
        remove_tool(document, node.index);
    else if (node.kind == TreeNode::Kind::fixture)
        remove_fixture(document, node.index);
    else if (node.kind == TreeNode::Kind::boundary)
        remove_boundary(document, node.index);
    else if (node.kind == TreeNode::Kind::operation)
        document.remove_operation(node.index);
}

/// What can be done with a tool, and with the part: actions of the tree that say so by their data.
void add_own_actions(QMenu& menu, TreeNode::Kind kind, QAction* edit_tool, const QList<QAction*>& all) {
    if (kind == TreeNode::Kind::tool) menu.addAction(edit_tool);
    for (QAction* action : all)
        if (kind == TreeNode::Kind::part && action->data().toString() == QLatin1String(part_action))
            menu.addAction(action);
}

/// How the part may lie in a setup that is added.
QMenu* setup_menu(QWidget* parent, const std::function<void(NewSetup)>& add) {
    auto* menu = new QMenu(ProjectTree::tr("Add setup"), parent);
    menu->setIcon(icon(Icon::place));
    const auto entry = [&](NewSetup how, const char* name, const QString& label) {
        QAction* a = menu->addAction(icon(Icon::place), label, parent, [add, how] { add(how); });
        a->setObjectName(QString::fromLatin1(name));
    };
    entry(NewSetup::flipped_about_x, "setup_about_x", ProjectTree::tr("Turned over about X, same zero"));
    entry(NewSetup::flipped_about_y, "setup_about_y", ProjectTree::tr("Turned over about Y, same zero"));
    entry(NewSetup::as_it_lies, "setup_as_it_lies", ProjectTree::tr("As the part lies"));
    return menu;
}

/// What comes into a tree meanwhile does not push what is chosen out of the view.
class KeptInSight {
public:
    explicit KeptInSight(QTreeWidget& tree) : tree_(tree) {
        const QTreeWidgetItem* chosen = tree_.currentItem();
        was_ = chosen && view().intersects(tree_.visualItemRect(chosen));
    }
    KeptInSight(const KeptInSight&) = delete;
    KeptInSight& operator=(const KeptInSight&) = delete;
    ~KeptInSight() {
        const QTreeWidgetItem* chosen = tree_.currentItem();
        if (was_ && chosen && !view().contains(tree_.visualItemRect(chosen))) tree_.scrollToItem(chosen);
    }

private:
    QRect view() const { return tree_.viewport()->rect(); }

    QTreeWidget& tree_;
    bool was_ = false;
};

/// Where the tree gets smaller its selection stays in sight.
class SelectionKeeper : public QObject {
public:
    explicit SelectionKeeper(QTreeWidget* tree) : QObject(tree), tree_(tree) {}
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Resize)
            QMetaObject::invokeMethod(
                tree_,
                [tree = tree_] {
                    if (QTreeWidgetItem* item = tree->currentItem()) tree->scrollToItem(item);
                },
                Qt::QueuedConnection);
        return false;
    }

private:
    QTreeWidget* tree_;
};

} // namespace

QString state_text(OperationState state) {
    switch (state) {
    case OperationState::not_planned:
        return ProjectTree::tr("Not planned");
    case OperationState::planning:
        return ProjectTree::tr("Being planned");
    case OperationState::planned:
        return ProjectTree::tr("Planned");
    case OperationState::stale:
        return ProjectTree::tr("Out of date: plan again");
    case OperationState::failed:
        return ProjectTree::tr("Failed");
    case OperationState::off:
        return ProjectTree::tr("Switched off");
    }
    return {};
}

std::vector<std::pair<const char*, QAction*>> tree_commands(ProjectTree& tree) {
    std::vector<std::pair<const char*, QAction*>> commands = tree.operations().commands();
    const std::pair<const char*, QAction*> own[] = {
        {"add_operation", tree.add_operation_menu()->menuAction()},
        {"add_fixture", tree.add_fixture_menu()->menuAction()},
        {"add_boundary", tree.add_boundary_menu()->menuAction()},
        {"add_setup", tree.add_setup_menu()->menuAction()},
        {"go_to_setup", tree.go_to_setup_action()},
        {"add_tool", tree.add_tool_action()},
        {"tool_library", tree.tool_library_action()},
        {"edit", tree.edit_action()},
        {"duplicate", tree.duplicate_action()},
        {"remove", tree.remove_action()},
        {"up", tree.up_action()},
        {"rename", tree.rename_action()},
        {"down", tree.down_action()}};
    commands.insert(commands.end(), std::begin(own), std::end(own));
    return commands;
}

ProjectTree::~ProjectTree() {
    tree_->blockSignals(true); // its items go one by one
}

QTreeWidget* ProjectTree::tree() {
    return tree_;
}

ProjectTree::ProjectTree(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
    make_tree();
    make_actions();
    auto* bar = make_bar();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(tree_, 1);
    column->addWidget(bar);
    connect(&document_, &Document::opened, this, &ProjectTree::rebuild);
    connect(&document_, &Document::changed, this, &ProjectTree::rebuild);
    connect(&document_, &Document::part_changed, this, &ProjectTree::show_states);
    connect(&document_, &Document::part_changed, this, &ProjectTree::update_actions);
    connect(&document_, &Document::states_changed, this, &ProjectTree::show_states);
    rebuild();
}

void ProjectTree::make_tree() {
    tree_ = new ProjectTreeView(document_, this);
    tree_->installEventFilter(new SelectionKeeper(tree_));
    tree_->setObjectName(QStringLiteral("project_tree"));
    tree_->setColumnCount(2);
    tree_->setHeaderHidden(true);
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setUniformRowHeights(true);
    tree_->setIndentation(16);
    tree_->setTextElideMode(Qt::ElideMiddle);
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setMinimumSectionSize(badge_width);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(badge_column, QHeaderView::Fixed);
    tree_->header()->resizeSection(badge_column, badge_width);
    tree_->setColumnHidden(badge_column, true); // until there is a verdict
    tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    tree_->setContextMenuPolicy(Qt::CustomContextMenu);
    tree_->setExpandsOnDoubleClick(false);
    connect(tree_, &QTreeWidget::customContextMenuRequested, this, &ProjectTree::menu);
    connect(tree_, &QTreeWidget::currentItemChanged, this, [this] {
        if (rebuilding_) return;
        update_actions();
        emit selection_changed();
    });
    connect(tree_, &ProjectTreeView::refused, this, &ProjectTree::refused);
    connect(tree_, &ProjectTreeView::placed, this, [this](std::size_t place) {
        select({TreeNode::Kind::operation, place});
    });
    connect(tree_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item) {
        const auto kind = TreeNode::Kind(item->data(0, kind_role).toInt());
        if (kind == TreeNode::Kind::tool)
            emit edit_tool(item->data(0, index_role).toULongLong());
        else if (go_to_setup_->isEnabled())
            QMetaObject::invokeMethod(this, &ProjectTree::go_to_setup, Qt::QueuedConnection); // ends the item
        else
            item->setExpanded(!item->isExpanded());
    });
}

void ProjectTree::make_actions() {
    add_tool_ = new QAction(icon(Icon::tool), tr("Add tool…"), this);
    tool_library_ = ToolLibraryDialog::make_action(document_, this);
    add_operation_ = operation_menu(this, [this](const std::string& kind) {
        select({TreeNode::Kind::operation, document_.add_operation(kind)});
    });
    add_setup_ =
        setup_menu(this, [this](NewSetup how) { change_setups([&] { ui::add_setup(document_, how); }); });
    add_fixture_ = fixture_menu(
        this, document_,
        [this](std::size_t at) {
            select({TreeNode::Kind::fixture, at});
        },
        [this](std::size_t at) { emit new_mesh_fixture(at); },
        [this](const QString& why) { emit refused(why); });
    add_boundary_ = boundary_menu(this, document_, [this](std::size_t at) {
        select({TreeNode::Kind::boundary, at});
    });
    go_to_setup_ = new QAction(icon(Icon::place), tr("Go to this setup"), this);
    connect(go_to_setup_, &QAction::triggered, this, &ProjectTree::go_to_setup);
    edit_ = new QAction(icon(Icon::edit), tr("Edit tool…"), this);
    operations_ = new OperationActions(document_, this);
    connect(operations_, &OperationActions::pasted, this, [this](std::size_t place) {
        select({TreeNode::Kind::operation, place});
    });
    connect(operations_, &OperationActions::refused, this, &ProjectTree::refused);
    rename_ = new QAction(tr("Rename"), this);
    rename_->setShortcut(Qt::Key_F2);
    rename_->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(rename_);
    connect(rename_, &QAction::triggered, this, [this] {
        if (!tree_->edit_name()) edit_selected();
    });
    duplicate_ = new QAction(icon(Icon::duplicate), tr("Duplicate"), this);
    remove_ = new QAction(icon(Icon::remove), tr("Remove"), this);
    remove_->setShortcut(QKeySequence::Delete);
    remove_->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    up_ = new QAction(icon(Icon::up), tr("Move up"), this);
    down_ = new QAction(icon(Icon::down), tr("Move down"), this);
    addAction(remove_);
    // What a double click does, by keys.
    for (const int key : {Qt::Key_Return, Qt::Key_Enter}) {
        auto* by_key = new QAction(this);
        by_key->setShortcut(key);
        by_key->setShortcutContext(Qt::WidgetShortcut);
        connect(by_key, &QAction::triggered, this, &ProjectTree::edit_selected);
        tree_->addAction(by_key);
    }
    connect(add_tool_, &QAction::triggered, this, &ProjectTree::new_tool);
    connect(edit_, &QAction::triggered, this, &ProjectTree::edit_selected); // enabled for tools alone
    connect(duplicate_, &QAction::triggered, this, &ProjectTree::duplicate);
    connect(remove_, &QAction::triggered, this, &ProjectTree::remove);
    connect(up_, &QAction::triggered, this, [this] { move(-1); });
    connect(down_, &QAction::triggered, this, [this] { move(+1); });
}

QToolBar* ProjectTree::make_bar() {
    auto* bar = new QToolBar(this);
    bar->setIconSize(QSize(16, 16));
    auto* add = new QToolButton(bar);
    add->setObjectName(QStringLiteral("add"));
    add->setAccessibleName(tr("Add"));
    add->setIcon(icon(Icon::add));
    add->setToolTip(tr("Add an operation, a tool, a fixture, a boundary or a setup"));
    add->setPopupMode(QToolButton::InstantPopup);
    auto* add_menu = new QMenu(add);
    show_pictures(add_menu);
    add_menu->addActions(add_operation_->actions());
    add_menu->addSeparator();
    add_menu->addActions({add_tool_, tool_library_});
    add_menu->addMenu(add_fixture_);
    add_menu->addMenu(add_boundary_);
    add_menu->addMenu(add_setup_);
    add->setMenu(add_menu);
    bar->addWidget(add);
    bar->addActions({duplicate_, remove_});
    bar->addSeparator();
    bar->addActions({up_, down_});
    bar->addSeparator();
    bar->addAction(edit_);
    return bar;
}

std::optional<TreeNode> ProjectTree::selected() const {
    const QTreeWidgetItem* item = tree_->currentItem();
    if (!item) return std::nullopt;
    return node_of(item);
}

QTreeWidgetItem* ProjectTree::item(const TreeNode& node) const {
    return tree_->item_of(node);
}

void ProjectTree::select(const TreeNode& node) {
    if (QTreeWidgetItem* found = item(node)) tree_->setCurrentItem(found);
}

void ProjectTree::rebuild() {
    const auto before = selected();
    rebuilding_ = true;
    tree_->clear();
    if (document_.has_part()) {
        fill_tree(*tree_, document_);
        tree_->expandAll();
        show_states();
    }
    if (before)
        if (QTreeWidgetItem* same = item(*before)) tree_->setCurrentItem(same);
    rebuilding_ = false;
    update_actions();
    if (selected() != before || document_.has_part()) emit selection_changed();
}

std::optional<std::size_t> ProjectTree::selected_setup() const {
    return setup_of(document_.project(), selected());
}

void ProjectTree::go_to_setup() {
    const auto setup = selected_setup();
    if (!setup) return;
    const auto node = *selected();
    choose_setup(document_, *setup);
    if (node.kind == TreeNode::Kind::elsewhere)
        select({TreeNode::Kind::operation, node.index - operations_before(document_.project())});
    else
        select({TreeNode::Kind::setup, *setup});
}

void ProjectTree::change_setups(const std::function<void()>& change) {
    try {
        change();
        if (setup_count(document_.project()) > 1)
            select({TreeNode::Kind::setup, chosen_setup(document_.project())});
    } catch (const Error& e) {
        emit refused(sentence(worded(e)));
    }
}

void ProjectTree::show_states() {
    const KeptInSight chosen(*tree_);
    // What stands after an operation is known when all of them are planned: then they can be played back.
    const bool known = document_.has_stock() && document_.all_planned();
    for (std::size_t i = 0; i < document_.operation_count(); ++i) {
        QTreeWidgetItem* it = item({TreeNode::Kind::operation, i});
        if (!it) continue;
        const OperationState state = document_.state(i);
        const bool all = known && state != OperationState::off;
        it->setIcon(0, icon(state_icon(state)));
        it->setForeground(0, state == OperationState::off
                                 ? QBrush(tree_->palette().color(QPalette::PlaceholderText))
                                 : QBrush());
        QString help =
            QStringLiteral("%1 (%2)\n%3")
                .arg(text(document_.operation(i).common().name),
                     operation_label(std::string(document_.operation(i).kind())), state_text(state));
        if (state == OperationState::failed) help = said_of(help, document_.failure(i));
        it->setToolTip(0, help);
        QTreeWidgetItem* after = item({TreeNode::Kind::stock_after, i});
        if (all && !after) {
            add_tree_item(it, {TreeNode::Kind::stock_after, i}, Icon::stock, tr("Stock after it"),
                          tr("Shows the stock as it stands after “%1”")
                              .arg(text(document_.operation(i).common().name)));
            it->setExpanded(true);
        } else if (!all && after) {
            if (tree_->currentItem() == after) tree_->setCurrentItem(it);
            delete after;
        }
    }
    show_verdicts();
}

void ProjectTree::set_verification(const VerificationModel& model) {
    verification_ = &model;
    connect(&model, &VerificationModel::changed, this, &ProjectTree::show_verdicts);
    show_verdicts();
}

void ProjectTree::show_verdicts() {
    if (!verification_) return;
    bool any = false;
    for (std::size_t i = 0; i < document_.operation_count(); ++i) {
        QTreeWidgetItem* it = item({TreeNode::Kind::operation, i});
        if (!it) continue;
        const Verdict verdict = verification_->verdict(i);
        any |= verdict != Verdict::none;
        it->setIcon(badge_column, verdict == Verdict::verified ? icon(Icon::verified)
                                  : verdict == Verdict::failed ? icon(Icon::verify_failed)
                                  : verdict == Verdict::stale || verdict == Verdict::not_judged
                                      ? icon(Icon::verify_stale)
                                      : QIcon());
        it->setToolTip(badge_column, verdict == Verdict::none ? QString() : verification_->why(i));
        it->setData(badge_column, Qt::AccessibleTextRole, verdict_text(verdict));
    }
    tree_->setColumnHidden(badge_column, !any);
}

void ProjectTree::update_actions() {
    const auto node = selected();
    const bool tool = node && node->kind == TreeNode::Kind::tool;
    const bool operation = node && node->kind == TreeNode::Kind::operation;
    const bool setup = node && node->kind == TreeNode::Kind::setup;
    const bool fixture = node && node->kind == TreeNode::Kind::fixture;
    const bool boundary = node && node->kind == TreeNode::Kind::boundary;
    const std::size_t setups = setup_count(document_.project());
    const auto there = selected_setup();
    go_to_setup_->setEnabled(there && *there != chosen_setup(document_.project()));
    for (const QMenu* menu : {add_setup_, add_fixture_, add_boundary_})
        for (QAction* a : menu->actions())
            a->setEnabled(document_.part_is_current());
    add_tool_->setEnabled(document_.has_part());
    for (QAction* a : add_operation_->actions())
        a->setEnabled(document_.has_part());
    edit_->setEnabled(tool);
    operations_->set_operation(operation ? std::optional(node->index) : std::nullopt);
    rename_->setEnabled(node.has_value());
    for (QAction* a : {duplicate_, remove_})
        a->setEnabled(tool || operation || setup || fixture || boundary);
    up_->setEnabled((operation || setup) && node->index > 0);
    down_->setEnabled((operation && node->index + 1 < document_.operation_count())
                      || (setup && node->index + 1 < setups));
}

void ProjectTree::edit_selected() {
    const auto node = selected();
    if (node && node->kind == TreeNode::Kind::tool)
        emit edit_tool(node->index);
    else if (node)
        emit edit_parameters();
}

void ProjectTree::duplicate() {
    const auto node = selected();
    if (!node) return;
    if (node->kind == TreeNode::Kind::setup)
        return change_setups([&] { duplicate_setup(document_, node->index); });
    if (duplicate_in_list(document_, *node)) select({node->kind, node->index + 1});
}

void ProjectTree::remove() {
    const auto node = selected();
    if (!node) return;
    if (node->kind == TreeNode::Kind::setup)
        return change_setups([&] { remove_setup(document_, node->index); });
    try {
        remove_from_list(document_, *node);
    } catch (const Error& e) {
        emit refused(sentence(worded(e)));
    }
}

void ProjectTree::move(int by) {
    const auto node = selected();
    if (node && node->kind == TreeNode::Kind::setup) {
        change_setups([&] { move_setup(document_, node->index, by); });
        const std::size_t there = std::size_t(std::ptrdiff_t(node->index) + by);
        if (there < setup_count(document_.project())) select({TreeNode::Kind::setup, there});
        return;
    }
    if (!node || node->kind != TreeNode::Kind::operation) return;
    move_operation(document_, node->index, by);
    select({node->kind, std::size_t(std::ptrdiff_t(node->index) + by)});
}

void ProjectTree::menu(const QPoint& at) {
    if (!document_.has_part()) return;
    if (QTreeWidgetItem* under = tree_->itemAt(at)) tree_->setCurrentItem(under);
    const auto node = selected();
    QMenu menu(this);
    operations_->add_to(menu);
    if (node) add_own_actions(menu, node->kind, edit_, tree_->actions());
    if (selected_setup()) menu.addAction(go_to_setup_);
    if (duplicate_->isEnabled()) {
        if (node->kind != TreeNode::Kind::tool) menu.addAction(rename_);
        if (node->kind == TreeNode::Kind::operation) menu.addAction(operations_->copy_action());
        menu.addActions({duplicate_, remove_});
        if (node->kind == TreeNode::Kind::operation || node->kind == TreeNode::Kind::setup)
            menu.addActions({up_, down_});
        menu.addSeparator();
    }
    menu.addAction(operations_->paste_action());
    menu.addMenu(add_operation_);
    menu.addActions({add_tool_, tool_library_});
    menu.addMenu(add_fixture_);
    menu.addMenu(add_boundary_);
    menu.addMenu(add_setup_);
    menu.exec(tree_->viewport()->mapToGlobal(at));
}

} // namespace facetmill::ui
