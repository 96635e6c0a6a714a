#include "ui/properties_panel.h"

#include "core/base/tolerances.h"
#include "core/job/cutting_choice.h"
#include "core/job/setting_remarks.h"
#include "core/job/work_estimate.h"
#include "core/mesh/mesh_format.h"
#include "core/output/post/post.h"
#include "core/setup/machine.h"
#include "core/strategy/lathe/lathe.h"
#include "ui/boundary_box.h"
#include "ui/boundary_list.h"
#include "ui/cutting_button.h"
#include "ui/elided_label.h"
#include "ui/icons.h"
#include "ui/parameter_form.h"
#include "ui/repair_button.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/tool_sketch.h"
#include "ui/worded.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <string_view>
#include <utility>

namespace facetmill::ui {

namespace {

/// The choice of machine, described like any other parameter.
struct MachineChoice {
    std::string machine = "generic-3-axis";
};

/// The name of a setup, likewise.
struct SetupName {
    std::string name;
};

const ParameterTable<SetupName>& setup_name() {
    static const auto table = [] {
        ParameterTable<SetupName> t;
        t.add(&SetupName::name, {.key = "name",
                                 .label = "Name",
                                 .help = "Of the setup. Each has its own.",
                                 .kind = ParameterKind::text});
        return t;
    }();
    return table;
}

const ParameterTable<MachineChoice>& machine_choice() {
    static const auto table = [] {
        ParameterTable<MachineChoice> t;
        std::vector<std::string> names;
        for (const Machine& m : machines())
            names.push_back(m.name);
        t.add(&MachineChoice::machine, {.key = "machine",
                                        .label = "Machine",
                                        .help = "Its axes and speeds decide the machining time.",
                                        .kind = ParameterKind::choice,
                                        .words = names});
        return t;
    }();
    return table;
}

/// Two structs in one form: the second's parameters stand behind `after` of the first's, or behind all.
template <class First, class Second>
class JoinedView : public Parameterized {
public:
    JoinedView(ParameterView<First> first, ParameterView<Second> second, std::string_view after = {})
        : first_(std::move(first)), second_(std::move(second)), after_(after) {}
    std::vector<const ParameterInfo*> parameters() const override {
        std::vector<const ParameterInfo*> all = first_.parameters();
        const auto at = std::find_if(all.begin(), all.end(),
                                     [&](const ParameterInfo* info) { return info->key == after_; });
        const auto more = second_.parameters();
        all.insert(at == all.end() ? at : at + 1, more.begin(), more.end());
        return all;
    }
    ParameterValue get(std::string_view key) const override {
        return first_.has(key) ? first_.get(key) : second_.get(key);
    }
    void set(std::string_view key, const ParameterValue& value) override {
        if (first_.has(key))
            first_.set(key, value);
        else
            second_.set(key, value);
    }

private:
    ParameterView<First> first_;
    ParameterView<Second> second_;
    std::string_view after_;
};

/// The size of a box that is stock: margins as what they come to.
struct StockSize {
    std::array<double, 3> size{0, 0, 0};
};

const ParameterTable<StockSize>& stock_size() {
    static const auto table = [] {
        ParameterTable<StockSize> t;
        t.add(&StockSize::size, {.key = "size",
                                 .label = "Size",
                                 .help = "Of the stock in all, X, Y and Z: the part and its margins. Either "
                                         "can be typed; the project keeps the margins.",
                                 .kind = ParameterKind::triple,
                                 .quantity = Quantity::length,
                                 .minimum = 0,
                                 .maximum = 3e6});
        return t;
    }();
    return table;
}

/// Zero of what is no block or has no part yet.
StockSize total_size(const StockSpec& stock, const std::shared_ptr<const PreparedPart>& part) {
    StockSize total;
    for (std::size_t k = 0; k < 3 && part && stock.kind == StockSpec::Kind::box; ++k)
        total.size[k] = stock_box(stock, part->box).size()[int(k)];
    return total;
}

/// Round the middle of the part in x and y, on its bottom. Throws Error(out_of_range) where the part is
/// larger.
std::array<double, 3> margins_for(const std::array<double, 3>& size, const Box3& part, LengthUnit unit) {
    std::array<double, 3> margin{};
    if (size == StockSize().size) return margin; // back to the default: as large as the part
    for (std::size_t k = 0; k < 3; ++k) {
        const double own = part.size()[int(k)], more = size[k] - own;
        if (more < -tolerance::figure_rounding * own)
            throw Error(ErrorCode::out_of_range, "size", std::string("the part is larger along ") + "XYZ"[k],
                        "write " + format_number(own / mm_per(unit), 6) + " or more");
        margin[k] = std::max(0.0, k == 2 ? more : more / 2);
    }
    return margin;
}

std::vector<FormChoice> machine_choices(const Project& project) {
    std::vector<FormChoice> choices;
    for (const Machine& m : machines())
        choices.push_back({worded(m.label), m.name});
    if (is_machine_file(project.machine)) choices.push_back({text(project.machine), project.machine});
    return choices;
}

std::vector<FormChoice> control_choices(const Project& project) {
    std::vector<FormChoice> controls = {{PropertiesPanel::tr("none: APT only"), std::string()}};
    for (const Post& p : posts())
        controls.push_back({worded(p.label), p.name});
    if (is_post_file(project.programs.post))
        controls.push_back({text(project.programs.post), project.programs.post});
    return controls;
}

/// The kinds of stock that the setup can have: the first has nothing before it that left some.
std::vector<FormChoice> stock_kinds(const Project& project) {
    std::vector<FormChoice> kinds;
    for (const std::string& word : stock_parameters().find("kind")->info.words)
        if (chosen_setup(project) > 0 || word != stock_kind_name(StockSpec::Kind::rest))
            kinds.push_back({worded(word), word});
    return kinds;
}

/// What fields know by name: sizes of part and stock, and of the operation's tool.
NamedLengths field_names(const Document& document, const TreeNode& node) {
    NamedLengths names;
    const Project& project = document.project();
    const auto add_box = [&](const std::string& of, const Box3& box) {
        const Vec3 size = box.size();
        for (const auto& [axis, length] : {std::pair("x", size.x()), {"y", size.y()}, {"z", size.z()}})
            names.push_back({of + "." + axis, length});
        names.push_back({of + ".top", box.hi.z()});
        names.push_back({of + ".bottom", box.lo.z()});
    };
    if (const auto& part = document.part()) {
        add_box("part", part->box);
        add_box("stock", stock_box(project.stock, part->box));
    }
    if (node.kind != TreeNode::Kind::operation || node.index >= project.operations.size()) return names;
    if (const Tool* tool = find_tool(project.tools, project.operations[node.index]->common().tool)) {
        names.push_back({"tool.diameter", tool->diameter});
        names.push_back({"tool.corner", tool->corner_radius});
        names.push_back({"tool.flutes", tool->flute_length});
    }
    return names;
}

JoinedView<StockSpec, StockSize> stock_view(StockSpec& stock, StockSize& size) {
    return {{stock, stock_parameters()}, {size, stock_size()}, "margin"};
}

std::vector<std::string> stock_form_keys(const StockSpec& stock, const StockSize& total) {
    std::vector<std::string> keys = stock_keys(stock.kind);
    if (total.size[0] > 0) keys.push_back("size");
    return keys;
}

/// Empty where the part is as large as its file says.
QString scale_text(const PartSpec& part) {
    if (part.scale == 1) return {};
    return PropertiesPanel::tr(
               "The part is %1 times as large as its file says; cutters and tolerances are not.")
        .arg(number_text(part.scale, 6));
}

/// What the form of a part leaves out: its file and its recipe, which are chosen elsewhere, and what says
/// nothing of such a file.
std::vector<std::string> hidden_part_keys(const PartSpec& part) {
    const MeshFormat* format = mesh_format_named(part.file);
    std::vector<std::string> hidden{"file", repair_list.key};
    if (!format || !format->has_objects) hidden.emplace_back("objects");
    if (format && !format->needs_unit()) hidden.emplace_back("units");
    if (format && !format->has_surfaces) hidden.insert(hidden.end(), {"chord_tolerance", "angle_tolerance"});
    if (!format || !format->is_picture)
        hidden.insert(hidden.end(), relief_keys().begin(), relief_keys().end());
    return hidden;
}

/// The keys that a form does not show because they say nothing of this kind.
std::vector<std::string> all_but(const std::vector<std::string>& keys, const Parameterized& values) {
    std::vector<std::string> hidden;
    for (const ParameterInfo* info : values.parameters())
        if (std::find(keys.begin(), keys.end(), info->key) == keys.end()) hidden.push_back(info->key);
    return hidden;
}

const std::vector<std::string> axis_points{"axis_from", "axis_to"};

bool through_points(const LatheCommon& turning) {
    return turning.axis == LatheCommon::Axis::points;
}

/// Whatever says otherwise where the turning axis runs, and what is said of boundaries that are not named:
/// an operation on a part that turns names none.
std::vector<std::string> hidden_keys(const Operation& operation) {
    const LatheCommon* turning = operation.turning();
    if (turning) {
        std::vector<std::string> hidden{"boundary", "contain", "avoid", "avoid_distance"};
        if (through_points(*turning))
            hidden.push_back("axis_through");
        else
            hidden.insert(hidden.end(), axis_points.begin(), axis_points.end());
        return hidden;
    }
    std::vector<std::string> hidden;
    if (operation.common().boundary.empty()) hidden.push_back("contain");
    if (operation.common().avoid.empty()) hidden.push_back("avoid_distance");
    return hidden;
}

/// The boundaries of the setup, after a word for none of them.
std::vector<FormChoice> boundary_choices(const Project& project, const QString& none) {
    std::vector<FormChoice> choices{{none, std::string()}};
    for (const Boundary& b : project.boundaries)
        choices.push_back({text(b.name), b.name});
    return choices;
}

std::map<std::string, std::vector<FormChoice>> operation_choices(const Project& project) {
    return {{"tool", tool_choices(project, false)},
            {"previous_tool", tool_choices(project, false)},
            {"rework_tool", tool_choices(project, true)},
            {"boundary", boundary_choices(project, PropertiesPanel::tr("everywhere"))},
            {"avoid", boundary_choices(project, PropertiesPanel::tr("none"))},
            {"curve", boundary_choices(project, PropertiesPanel::tr("the outline"))},
            {"first_curve", boundary_choices(project, PropertiesPanel::tr("half of the outline"))},
            {"second_curve", boundary_choices(project, PropertiesPanel::tr("the other half"))}};
}

/// Where the manual tells of the parameters of a node.
QString help_scope(const Document& document, const TreeNode& node) {
    using Kind = TreeNode::Kind;
    switch (node.kind) {
    case Kind::part:
        return QStringLiteral("part");
    case Kind::stock:
        return QStringLiteral("stock");
    case Kind::fixture:
        return QStringLiteral("fixtures");
    case Kind::boundary:
        return QStringLiteral("boundaries");
    case Kind::setup:
        return QStringLiteral("setups place");
    case Kind::limits:
        return QStringLiteral("verification");
    case Kind::machine:
        return QStringLiteral("project_file");
    case Kind::operation:
        return text(document.operation(node.index).kind());
    default:
        return {};
    }
}

/// What its fields know by name, and where their help stands.
void tell_about(ParameterForm& form, const Document& document, const TreeNode& node) {
    form.set_names(field_names(document, node));
    form.set_help_scope(help_scope(document, node));
}

std::map<std::string, QString> remarks_on(const Project& project, std::size_t operation) {
    std::map<std::string, QString> remarks;
    for (const SettingRemark& r : setting_remarks(project, operation))
        remarks[r.key] = worded(r.message);
    return remarks;
}

/// "/1 Ball/2 Flat": a form offers them by these.
QString tools_text(const Project& project) {
    QString all;
    for (const Tool& t : project.tools)
        all += QStringLiteral("/%1 %2").arg(t.number).arg(text(t.name));
    return all;
}

/// Keys of a boundary in its form: what is painted or drawn is no text to edit.
std::vector<std::string> boundary_form_keys(Boundary::Kind kind) {
    std::vector<std::string> keys = boundary_keys(kind);
    std::erase_if(
        keys, [](const std::string& key) { return key == "facets" || key == "of_facets" || key == "curve"; });
    return keys;
}

/// What planning an operation takes, where that is a minute or more; empty where it is less, or where the
/// project says by other means that it cannot be planned.
QString work_hint(const Project& project, const std::shared_ptr<const PreparedPart>& part,
                  const Operation& operation) {
    if (!part) return {};
    try {
        check_project(project);
        for (const WorkEstimate& e : estimate_plan(project, *part, operation.common().name))
            if (e.notable()) return PropertiesPanel::tr("Planning it takes %1.").arg(worded(e.text()));
    } catch (const Error&) {
        return {};
    }
    return {};
}

/// That something has to rough first; empty where nothing has to.
QString roughing_hint(UnroughedLook& look, const Project& project,
                      const std::shared_ptr<const PreparedPart>& part, const Operation& operation) {
    const auto unroughed = part ? look.of(project, *part, operation) : std::nullopt;
    if (!unroughed) return {};
    return PropertiesPanel::tr("Add Rough before it: the stock stands up to %1 above the part, and the tool "
                               "comes %2 deep into it.")
        .arg(shown_length(unroughed->highest, project.unit, 3),
             shown_length(unroughed->reach, project.unit, 3));
}

QString operation_hint(UnroughedLook& look, const Project& project,
                       const std::shared_ptr<const PreparedPart>& part, const Operation& operation) {
    const QString roughing = roughing_hint(look, project, part, operation);
    return roughing.isEmpty() ? work_hint(project, part, operation) : roughing;
}

/// The id of the operation that is chosen; 0: none is.
int chosen_operation_id(const Document& document, const std::optional<TreeNode>& node) {
    const bool shown =
        node && node->kind == TreeNode::Kind::operation && node->index < document.operation_count();
    return shown ? document.operation_id(node->index) : 0;
}

/// Says which fields a form has: another one builds it anew.
QString form_shape(const Document& document, const std::optional<TreeNode>& node) {
    if (!document.has_part() || !node) return {};
    QString shape = QString::number(int(node->kind)) + QChar('/');
    if (chosen_operation_id(document, node) != 0) {
        // One form does for all of a kind.
        shape += text(document.operation(node->index).kind()) + tools_text(document.project());
        if (const LatheCommon* turning = document.operation(node->index).turning())
            shape += through_points(*turning) ? QStringLiteral("/points") : QStringLiteral("/axis");
        const OperationCommon& common = document.operation(node->index).common();
        shape += common.boundary.empty() ? QStringLiteral("/everywhere") : QStringLiteral("/within");
        shape += common.avoid.empty() ? QStringLiteral("/") : QStringLiteral("/off");
        for (const Boundary& b : document.project().boundaries)
            shape += QChar('/') + text(b.name);
    } else {
        shape += QString::number(node->index);
    }
    if (node->kind == TreeNode::Kind::stock || node->kind == TreeNode::Kind::fixture
        || node->kind == TreeNode::Kind::boundary)
        shape += QChar('/') + QString::number(chosen_setup(document.project()));
    if (node->kind == TreeNode::Kind::fixture && node->index < document.project().fixtures.size())
        shape += QChar('/') + text(fixture_kind_name(document.project().fixtures[node->index].kind));
    if (node->kind == TreeNode::Kind::boundary && node->index < document.project().boundaries.size())
        shape += QChar('/') + text(boundary_kind_name(document.project().boundaries[node->index].kind))
                 + tools_text(document.project());
    if (node->kind == TreeNode::Kind::part)
        for (const std::string& key : hidden_part_keys(document.project().part))
            shape += QChar('/') + text(key);
    if (node->kind == TreeNode::Kind::stock)
        shape += QChar('/') + text(stock_kind_name(document.project().stock.kind))
                 + (document.part() ? QStringLiteral("/sized") : QString());
    return shape;
}

/// How far a tool is out of its holder, and how far it has to be to come down to the foot of the part.
QString stick_out_text(const Tool& tool, const Project& project,
                       const std::shared_ptr<const PreparedPart>& part) {
    if (!part) return {};
    const double top = project.stock.kind == StockSpec::Kind::box ? stock_box(project.stock, part->box).hi.z()
                                                                  : part->box.hi.z();
    return PropertiesPanel::tr(". Stick-out: %1; the part needs %2")
        .arg(shown_length(tool.flute_length + tool.shank_length, project.unit, 4),
             shown_length(top - part->box.lo.z(), project.unit, 4));
}

} // namespace

std::vector<FormChoice> tool_choices(const Project& project, bool none) {
    std::vector<FormChoice> tools;
    if (none) tools.push_back({PropertiesPanel::tr("none"), 0L});
    for (const Tool& t : project.tools)
        tools.push_back({PropertiesPanel::tr("T%1  %2").arg(t.number).arg(text(t.name)), t.number});
    return tools;
}

PropertiesPanel::PropertiesPanel(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 6, 0, 0);
    column->setSpacing(2);
    title_ = new ElidedLabel(content);
    title_->setObjectName(QStringLiteral("properties_title"));
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    title_->setIndent(8);
    hint_ = new QLabel(content);
    hint_->setObjectName(QStringLiteral("properties_hint"));
    hint_->setWordWrap(true);
    hint_->setMargin(8);
    hint_->setForegroundRole(QPalette::PlaceholderText);
    form_ = new ParameterForm(content);
    sketch_ = new ToolSketch(content);
    sketch_->set_compact(true);
    sketch_->setMinimumHeight(220);
    edit_tool_ = new QPushButton(icon(Icon::edit), tr("Edit tool…"), content);
    edit_tool_->setObjectName(QStringLiteral("edit_tool"));
    choose_mesh_ = new QPushButton(icon(Icon::open), tr("Choose mesh…"), content);
    choose_mesh_->setObjectName(QStringLiteral("choose_stock"));
    edit_regions_ = new QPushButton(icon(Icon::edit), tr("Rework regions…"), content);
    edit_regions_->setObjectName(QStringLiteral("edit_regions"));
    edit_regions_->setToolTip(
        tr("Settings of Rework Region: see, limit and edit what the smaller tool cuts"));
    column->addWidget(title_);
    column->addWidget(hint_);
    auto* region_box = new QVBoxLayout;
    region_box->setContentsMargins(8, 4, 8, 4);
    region_box->addWidget(edit_regions_);
    cutting_ = new CuttingButton(document_, content);
    region_box->addWidget(cutting_);
    repair_ = new RepairButton(document_, content);
    region_box->addWidget(repair_);
    column->addLayout(region_box);
    column->addWidget(form_);
    boundary_box_ = new BoundaryBox(content);
    column->addWidget(boundary_box_);
    auto* stock_box = new QVBoxLayout;
    stock_box->setContentsMargins(8, 4, 8, 4);
    stock_box->addWidget(choose_mesh_);
    column->addLayout(stock_box);
    auto* tool_box = new QVBoxLayout;
    tool_box->setContentsMargins(8, 4, 8, 4);
    tool_box->addWidget(sketch_, 1);
    tool_box->addWidget(edit_tool_);
    column->addLayout(tool_box, 1);
    column->addStretch(0);

    auto* scroll = new QScrollArea(this);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(scroll);

    connect(form_, &ParameterForm::edited, this, &PropertiesPanel::take);
    connect(form_, &ParameterForm::pick_requested, this, &PropertiesPanel::pick_requested);
    connect(edit_tool_, &QPushButton::clicked, this, [this] {
        if (node_ && node_->kind == TreeNode::Kind::tool) emit edit_tool(node_->index);
    });
    connect(choose_mesh_, &QPushButton::clicked, this, [this] {
        if (node_ && node_->kind == TreeNode::Kind::fixture)
            emit choose_fixture(node_->index);
        else
            emit choose_stock();
    });
    connect(edit_regions_, &QPushButton::clicked, this, [this] {
        if (node_ && node_->kind == TreeNode::Kind::operation && commit()) emit edit_regions(node_->index);
    });
    connect(&document_, &Document::opened, this, &PropertiesPanel::refresh);
    connect(&document_, &Document::changed, this, &PropertiesPanel::refresh);
    connect(&document_, &Document::part_changed, this, [this] {
        // The stock's size, whether a boundary fits and what planning takes follow from the part.
        if (node_
            && (node_->kind == TreeNode::Kind::stock || node_->kind == TreeNode::Kind::boundary
                || node_->kind == TreeNode::Kind::operation))
            refresh();
    });
    refresh();
}

void PropertiesPanel::show_node(const std::optional<TreeNode>& node) {
    if (node == node_) return;
    // What was typed for the old node still belongs to it.
    form_->commit();
    node_ = node;
    refresh();
    emit shown();
}

bool PropertiesPanel::commit() {
    return form_->commit();
}

bool PropertiesPanel::take_shape() {
    const int operation = chosen_operation_id(document_, node_);
    if (std::exchange(operation_, operation) != operation) form_->forget_entries();
    const QString shape = form_shape(document_, node_);
    return std::exchange(shape_, shape) != shape;
}

void PropertiesPanel::refresh() {
    using Kind = TreeNode::Kind;
    const Project& project = document_.project();
    const LengthUnit unit = document_.unit();
    const bool build = take_shape();
    QString title, hint;
    bool form = false, tool = false, mesh = false, regions = false, alarm = false; // the last: of the hint
    const auto show = [&](const Parameterized& values,
                          const std::map<std::string, std::vector<FormChoice>>& choices = {},
                          const std::vector<std::string>& hidden = {}) {
        form = true;
        if (build) form_->set_parameters(values.parameters(), unit, choices, hidden);
        tell_about(*form_, document_, *node_);
        form_->set_values(values, unit);
    };
    if (!document_.has_part()) {
        hint = tr("Nothing is open.");
    } else if (!node_) {
        hint = tr("Select something in the project to see its parameters.");
    } else if (node_->kind == Kind::part) {
        title = path_text(project.part_path().filename());
        PartSpec copy = project.part;
        show(ParameterView<PartSpec>(copy, part_parameters()), {}, hidden_part_keys(copy));
        hint = scale_text(copy);
    } else if (node_->kind == Kind::stock) {
        title = tr("Stock");
        StockSpec copy = project.stock;
        StockSize total = total_size(copy, document_.part());
        const auto view = stock_view(copy, total);
        show(view, {{"kind", stock_kinds(project)}}, all_but(stock_form_keys(copy, total), view));
        mesh = copy.kind == StockSpec::Kind::mesh;
    } else if (node_->kind == Kind::fixture && node_->index < project.fixtures.size()) {
        Fixture copy = project.fixtures[node_->index];
        title = text(copy.name);
        const ParameterView<Fixture> view(copy, fixture_parameters());
        show(view, {}, all_but(fixture_keys(copy.kind), view));
        mesh = copy.kind == Fixture::Kind::mesh;
    } else if (node_->kind == Kind::boundary && node_->index < project.boundaries.size()) {
        Boundary copy = project.boundaries[node_->index];
        title = text(copy.name);
        const ParameterView<Boundary> view(copy, boundary_parameters());
        show(view, {{"tool", tool_choices(project, false)}}, all_but(boundary_form_keys(copy.kind), view));
        hint = boundary_mismatch(copy, document_.part());
        if (alarm = !hint.isEmpty(); !alarm) hint = boundary_extent(copy);
    } else if (node_->kind == Kind::setup && node_->index < setup_count(project)) {
        const Setup& setup = setup_at(project, node_->index);
        title = text(setup.name);
        SetupName name{setup.name};
        SetupPlace place = setup.place;
        show(JoinedView(ParameterView(name, setup_name()), ParameterView(place, place_parameters())));
        if (node_->index != chosen_setup(project))
            hint = tr("Another setup is shown. A double click in the tree goes to this one.");
    } else if (node_->kind == Kind::elsewhere) {
        hint = tr("This operation belongs to another setup. A double click in the tree goes there.");
    } else if (node_->kind == Kind::limits) {
        title = tr("Verification limits");
        VerifyLimits copy = project.limits;
        show(ParameterView<VerifyLimits>(copy, verify_limit_parameters()));
    } else if (node_->kind == Kind::machine) {
        title = tr("Machine and control");
        MachineChoice machine{project.machine};
        ProgramSpec programs = project.programs;
        show(JoinedView(ParameterView(machine, machine_choice()),
                        ParameterView(programs, program_parameters())),
             {{"machine", machine_choices(project)}, {"post", control_choices(project)}});
    } else if (node_->kind == Kind::tool && node_->index < project.tools.size()) {
        const Tool& t = project.tools[node_->index];
        title = tr("T%1  %2").arg(t.number).arg(text(t.name));
        hint = worded(t.shape_name()) + stick_out_text(t, project, document_.part());
        sketch_->set_tool(t, unit);
        tool = true;
    } else if (node_->kind == Kind::operation && node_->index < project.operations.size()) {
        const Operation& operation = *project.operations[node_->index];
        title = text(operation.common().name);
        std::map<std::string, QString> remarks = remarks_on(project, node_->index);
        alarm = remarks.contains({});
        hint = alarm ? remarks[{}] : operation_hint(unroughed_, project, document_.part(), operation);
        form_->set_pickable(operation.turning() ? axis_points : std::vector<std::string>{"tool_axis"});
        show(operation, operation_choices(project), hidden_keys(operation));
        form_->set_remarks(remarks);
        regions = operation.rework() != nullptr;
    } else if (node_->kind == Kind::stock_after && node_->index < project.operations.size()) {
        title = tr("Stock after “%1”").arg(text(project.operations[node_->index]->common().name));
        hint = tr("The view shows the stock as it stands when this operation has ended. The bar below the "
                  "view plays it back.");
    } else {
        hint = node_->kind == Kind::tools
                   ? tr("Add a tool below the tree; a double click edits one.")
                   : tr("Add an operation below the tree. They run from top to bottom.");
    }
    show_head(title, hint, alarm);
    show_boxes();
    form_->setVisible(form);
    sketch_->setVisible(tool);
    edit_tool_->setVisible(tool);
    choose_mesh_->setVisible(mesh);
    edit_regions_->setVisible(regions);
    if (build && !form) form_->set_parameters({}, unit);
}

void PropertiesPanel::show_boxes() {
    const bool operation = node_ && node_->kind == TreeNode::Kind::operation && document_.has_part();
    repair_->show_part(node_ && node_->kind == TreeNode::Kind::part && document_.has_part());
    cutting_->set_operation(operation ? std::optional(node_->index) : std::nullopt);
    const auto& boundaries = document_.project().boundaries;
    const bool chosen = node_ && node_->kind == TreeNode::Kind::boundary && node_->index < boundaries.size();
    const auto kind = chosen ? boundaries[node_->index].kind : Boundary::Kind::silhouette;
    boundary_box_->setVisible(kind == Boundary::Kind::facets || kind == Boundary::Kind::curve);
    boundary_box_->show_kind(kind, document_.unit());
}

void PropertiesPanel::show_head(const QString& title, const QString& hint, bool alarm) {
    title_->set_text(title);
    title_->setVisible(!title.isEmpty());
    hint_->setText(kept_together(hint));
    hint_->setForegroundRole(alarm ? QPalette::WindowText : QPalette::PlaceholderText);
    QPalette shades = palette();
    if (alarm) shades.setColor(QPalette::WindowText, signal_colors(shades).bad);
    hint_->setPalette(shades);
    hint_->setVisible(!hint.isEmpty());
}

void PropertiesPanel::take_point(const std::string& key, const Vec3& point) {
    if (!node_ || node_->kind != TreeNode::Kind::operation || node_->index >= document_.operation_count())
        return;
    try {
        document_.change(tr("Pick %1").arg(form_->spoken_label(key)), [&, index = node_->index](Project& p) {
            Operation& operation = *p.operations.at(index);
            if (operation.turning()) operation.set("axis", std::string("points"));
            operation.set(key, std::array<double, 3>{point.x(), point.y(), point.z()});
        });
    } catch (const Error& e) {
        form_->set_error(key, failure_text(e));
    }
}

void PropertiesPanel::take(const std::string& key, const ParameterValue& value) {
    if (!node_) return;
    using Kind = TreeNode::Kind;
    const TreeNode node = *node_;
    const auto wrong = [&](const QString& why) { form_->set_error(key, why); };
    if (node.kind == Kind::operation && key == "name") {
        const QString name = text(std::get<std::string>(value)).trimmed();
        if (name.isEmpty()) return wrong(tr("Give the operation a name"));
        for (const Operation* o : all_operations(document_.project()))
            if (o != &document_.operation(node.index) && text(o->common().name) == name)
                return wrong(tr("Another operation has this name"));
    }
    if (node.kind == Kind::setup && key == "name") {
        const QString name = text(std::get<std::string>(value)).trimmed();
        if (name.isEmpty()) return wrong(tr("Give the setup a name"));
        for (std::size_t i = 0; i < setup_count(document_.project()); ++i)
            if (i != node.index && text(setup_at(document_.project(), i).name) == name)
                return wrong(tr("Another setup has this name"));
    }
    if (node.kind == Kind::stock && key == "kind" && std::get<std::string>(value) == "mesh"
        && document_.project().stock.file.empty())
        return emit choose_stock(); // no project without a file for it
    if (node.kind == Kind::fixture && key == "kind" && std::get<std::string>(value) == "mesh"
        && document_.project().fixtures.at(node.index).file.empty())
        return emit choose_fixture(node.index);
    if (node.kind == Kind::fixture && key == "name") {
        const QString name = text(std::get<std::string>(value)).trimmed();
        if (name.isEmpty()) return wrong(tr("Give the fixture a name"));
        for (std::size_t i = 0; i < document_.project().fixtures.size(); ++i)
            if (i != node.index && text(document_.project().fixtures[i].name) == name)
                return wrong(tr("Another fixture has this name"));
    }
    if (node.kind == Kind::boundary && key == "name") {
        const QString name = text(std::get<std::string>(value)).trimmed();
        if (name.isEmpty()) return wrong(tr("Give the boundary a name"));
        for (std::size_t i = 0; i < document_.project().boundaries.size(); ++i)
            if (i != node.index && text(document_.project().boundaries[i].name) == name)
                return wrong(tr("Another boundary has this name"));
        return rename_boundary(document_, node.index, utf8(name));
    }
    if (node.kind == Kind::boundary && key == "kind") {
        const auto& words = boundary_parameters().find("kind")->info.words;
        const auto at = std::find(words.begin(), words.end(), std::get<std::string>(value)) - words.begin();
        return set_boundary_kind(document_, node.index, Boundary::Kind(at));
    }
    if ((node.kind == Kind::stock || node.kind == Kind::fixture) && key == "file"
        && std::get<std::string>(value).empty())
        return wrong(tr("Name a mesh file"));
    // Of a list the form only says how many there are.
    const bool clears =
        node.kind == Kind::operation && document_.operation(node.index).parameter(key).is_list();
    const QString what = (clears ? tr("Clear %1") : tr("Edit %1")).arg(form_->spoken_label(key));
    try {
        document_.change(what, [&](Project& p) {
            if (node.kind == Kind::part)
                ParameterView<PartSpec>(p.part, part_parameters()).set(key, value);
            else if (node.kind == Kind::stock && key == "size")
                ParameterView<StockSpec>(p.stock, stock_parameters())
                    .set("margin",
                         margins_for(std::get<std::array<double, 3>>(value), document_.part()->box, p.unit));
            else if (node.kind == Kind::stock)
                ParameterView<StockSpec>(p.stock, stock_parameters()).set(key, value);
            else if (node.kind == Kind::fixture)
                ParameterView<Fixture>(p.fixtures.at(node.index), fixture_parameters()).set(key, value);
            else if (node.kind == Kind::boundary)
                ParameterView<Boundary>(p.boundaries.at(node.index), boundary_parameters()).set(key, value);
            else if (node.kind == Kind::setup && key == "name")
                setup_at(p, node.index).name = std::get<std::string>(value);
            else if (node.kind == Kind::setup)
                ParameterView<SetupPlace>(setup_at(p, node.index).place, place_parameters()).set(key, value);
            else if (node.kind == Kind::limits)
                ParameterView<VerifyLimits>(p.limits, verify_limit_parameters()).set(key, value);
            else if (node.kind == Kind::machine && key == "machine")
                p.machine = std::get<std::string>(value);
            else if (node.kind == Kind::machine)
                ParameterView<ProgramSpec>(p.programs, program_parameters()).set(key, value);
            else if (node.kind == Kind::operation && key == "tool")
                change_tool(*p.operations.at(node.index), p.tools, std::get<long>(value));
            else if (node.kind == Kind::operation)
                p.operations.at(node.index)->set(key, value);
        });
    } catch (const Error& e) {
        wrong(failure_text(e));
    }
}

} // namespace facetmill::ui
