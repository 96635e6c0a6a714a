#include "ui/tool_dialog.h"

#include "core/base/usual_value.h"
#include "core/tools/library_file.h"
#include "ui/icons.h"
#include "ui/own_folders.h"
#include "ui/parameter_form.h"
#include "ui/record_table.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/tool_list.h"
#include "ui/tool_sketch.h"
#include "ui/worded.h"
#include "viz/tool_shape.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

ToolDialog* ToolDialog::open_for(Document& document, std::optional<std::size_t> index, QWidget* parent) {
    if (!document.has_part()) return nullptr;
    const auto& tools = document.project().tools;
    Tool tool;
    std::vector<long> taken;
    for (std::size_t i = 0; i < tools.size(); ++i)
        if (!index || i != *index) taken.push_back(tools[i].number);
    if (index) {
        if (*index >= tools.size()) return nullptr;
        tool = tools[*index];
    } else {
        ParameterView<Tool> view(tool, tool_parameters());
        take_usual_values(view, document.unit());
        if (!tools.empty()) tool = tools.back();
        tool.flutes = 0; // how that one is run says nothing of another size
        tool.cutting.clear();
        tool.number = document.free_tool_number();
        tool.name = usual_tool_name_said(tool, document.unit());
    }
    auto* dialog = new ToolDialog(tool, document.unit(), taken, parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // A part that was still being read can bring another project: its tools are not the one on the screen.
    connect(&document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, dialog, [&document, dialog, index] {
        if (index && *index < document.project().tools.size())
            set_tool(document, *index, dialog->tool());
        else
            add_tool(document, dialog->tool());
        emit dialog->taken(index ? *index : document.project().tools.size() - 1);
    });
    dialog->open();
    return dialog;
}

ToolDialog::ToolDialog(const Tool& tool, LengthUnit unit, std::vector<long> taken, QWidget* parent)
    : QDialog(parent), edit_(tool, unit, spoken_tool_names()), unit_(unit), taken_(std::move(taken)) {
    setWindowTitle(tr("Tool"));
    setObjectName(QStringLiteral("tool_dialog"));

    shape_ = new QComboBox(this);
    shape_->setObjectName(QStringLiteral("shape"));
    // The names are those of Tool::shape_name, in the order of CutterShape.
    shape_->addItems({tr("Special"), tr("Ball end"), tr("Flat end"), tr("Bull nose"), tr("Tapered flat"),
                      tr("Tapered ball"), tr("Drill point"), tr("Cone")});
    shape_->setToolTip(tr("Sets corner radius and angles; every value can be changed afterwards."));
    connect(shape_, &QComboBox::activated, this, [this](int index) {
        edit_.set_shape(CutterShape(index));
        show_values();
    });

    form_ = new ParameterForm(this);
    form_->set_help_scope(QStringLiteral("tools"));
    form_->set_live(true);
    Tool shown = tool;
    const ParameterView<Tool> view(shown, tool_parameters());
    form_->set_parameters(view.parameters(), unit_, {}, {holder_list.key, cutting_list.key});
    form_->set_values(view, unit_);
    connect(form_, &ParameterForm::edited, this, &ToolDialog::set_value);
    connect(form_, &ParameterForm::validity_changed, this, &ToolDialog::validate);

    QWidget* lists = make_lists();

    auto* shape_row = new QHBoxLayout;
    shape_row->setContentsMargins(8, 0, 4, 0);
    shape_row->addWidget(new QLabel(tr("Shape"), this));
    shape_row->addWidget(shape_, 1);

    auto* scroll = new QScrollArea(this);
    scroll->setWidget(form_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumSize(300, 200);

    auto* left = new QVBoxLayout;
    left->addLayout(shape_row);
    left->addWidget(scroll, 1);

    sketch_ = new ToolSketch(this);
    sketch_->setMinimumWidth(300);
    auto* columns = new QHBoxLayout;
    columns->addLayout(left, 2);
    columns->addWidget(sketch_, 3);

    problem_ = new QLabel(this);
    problem_->setObjectName(QStringLiteral("problem"));
    problem_->setWordWrap(true);
    problem_->setMinimumWidth(120);
    buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons_, &QDialogButtonBox::accepted, this, &ToolDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* foot = new QHBoxLayout;
    foot->addWidget(problem_, 1);
    foot->addWidget(buttons_);

    auto* all = new QVBoxLayout(this);
    all->addLayout(columns, 1);
    all->addWidget(lists);
    all->addLayout(foot);
    resize(780, 620);
    show_lists();
    validate();
}

QWidget* ToolDialog::make_lists() {
    auto* lists = new QTabWidget(this); // first: Tab comes to its tabs before what stands below them
    lists->setObjectName(QStringLiteral("lists"));
    holder_ = new RecordTable(
        holder_parameters().infos(), unit_,
        {QStringLiteral("holder"), QStringLiteral("section"), tr("Holder section"),
         tr("Add a section above the others"), tr("Remove the selected section"),
         tr("No holder: nothing above the shank is watched. + adds a section.")},
        [this](const ParameterRecords& before) {
            if (!before.all.empty()) return before.all.back();
            const double shank = tool().shank_diameter;
            return holder_list.values({{shank * 2, shank * 3}}).all.front();
        },
        this);
    auto* library = new QToolButton(holder_);
    library->setObjectName(QStringLiteral("library_holder"));
    library->setIcon(icon(Icon::tool));
    library->setToolTip(tr("Take a holder of the tool library"));
    library->setAccessibleName(library->toolTip());
    library->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(library);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { list_holders(*menu); });
    library->setMenu(menu);
    holder_->add_button(library);
    connect(holder_, &RecordTable::edited, this, [this] {
        if (holder_->problem().isEmpty()) edit_.set_holder(holder_list.structs(holder_->records()));
        validate();
    });

    cutting_ = new RecordTable(
        cutting_parameters().infos(), unit_,
        {QStringLiteral("cutting"), QStringLiteral("cutting"), tr("Feeds and speeds, row"),
         tr("Add a material"), tr("Remove the selected material"),
         tr("No material yet: operations have feeds of their own. + adds one.")},
        [](const ParameterRecords& before) {
            if (!before.all.empty()) return before.all.back();
            return cutting_list.values({CuttingData()}).all.front();
        },
        this);
    connect(cutting_, &RecordTable::edited, this, [this] {
        if (cutting_->problem().isEmpty()) edit_.set_cutting(cutting_list.structs(cutting_->records()));
        validate();
    });

    lists->addTab(holder_, tr("&Holder, from the shank upward"));
    lists->addTab(cutting_, tr("&Feeds and speeds"));
    return lists;
}

void ToolDialog::list_holders(QMenu& menu) {
    menu.clear();
    std::vector<ToolHolder> holders;
    for (const KeptLibrary& kept : kept_libraries(own_library_folder())) {
        holders.insert(holders.end(), kept.library.holders.begin(), kept.library.holders.end());
        for (const LibraryTool& t : kept.library.tools)
            if (!t.holder.outline.empty()) holders.push_back(t.holder);
    }
    std::vector<ToolHolder> listed;
    for (const ToolHolder& holder : holders) {
        if (std::find(listed.begin(), listed.end(), holder) != listed.end()) continue;
        listed.push_back(holder);
        const QString named = holder.name.empty() ? tr("Holder %1").arg(listed.size()) : text(holder.name);
        menu.addAction(elided(named, 48), this, [this, outline = holder.outline] {
            edit_.set_holder(holder_steps(outline));
            holder_->set_records(holder_list.values(tool().holder));
            validate();
        });
    }
    if (listed.empty()) menu.addAction(tr("The library has no holders"))->setEnabled(false);
}

void ToolDialog::set_value(const std::string& key, const ParameterValue& value) {
    edit_.set(key, value);
    show_values();
}

void ToolDialog::show_values() {
    Tool shown = tool();
    form_->set_values(ParameterView<Tool>(shown, tool_parameters()), unit_);
    validate();
}

void ToolDialog::show_lists() {
    holder_->set_records(holder_list.values(tool().holder));
    cutting_->set_records(cutting_list.values(tool().cutting));
}

QString ToolDialog::problem() const {
    for (const RecordTable* list : {holder_, cutting_})
        if (!list->problem().isEmpty()) return list->problem();
    if (!check_message_.isEmpty()) return check_message_;
    return form_->valid() ? QString() : tr("A value is not valid");
}

/// The picture shows the cone, so that it must be said that more of it is kept clear.
QString ToolDialog::holder_remark() const {
    const std::vector<HolderPiece> pieces = holder_pieces(tool().holder);
    const bool cones =
        std::any_of(pieces.begin(), pieces.end(), [](const HolderPiece& p) { return p.lower != p.upper; });
    constexpr double largest_step = 1; // mm: holder_steps
    return cones ? tr("Cones of the holder are kept clear as the steps above, which stand out of them by up "
                      "to %1.")
                       .arg(shown_length(largest_step, unit_, 3))
                 : QString();
}

void ToolDialog::validate() {
    if (validating_) return; // the form tells of every message that is shown under a field
    validating_ = true;
    if (!marked_.empty()) form_->set_error(marked_, {});
    marked_.clear();
    check_message_.clear();
    if (std::find(taken_.begin(), taken_.end(), tool().number) != taken_.end()) {
        marked_ = "number";
        check_message_ = tr("Number %1 belongs to another tool").arg(tool().number);
    } else {
        try {
            check_tool(tool());
        } catch (const Error& e) {
            marked_ = e.where();
            check_message_ = with_lengths_in(failure_text(e), unit_);
        }
    }
    if (!form_->error(marked_).isEmpty())
        marked_.clear(); // the field already says what is wrong with it
    else if (!marked_.empty())
        form_->set_error(marked_, check_message_);
    const QString why = problem();
    problem_->setText(kept_together(why.isEmpty() ? holder_remark() : why));
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText,
                    why.isEmpty() ? signal_colors(palette()).quiet : signal_colors(palette()).bad);
    problem_->setPalette(colors);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(why.isEmpty());
    sketch_->set_tool(tool(), unit_);
    // What makes no cutter keeps the shape that it had: the message says what is wrong.
    const std::string name = tool().shape_name();
    const bool special = edit_.shape() == CutterShape::special && name != "Invalid";
    shape_->setItemText(int(CutterShape::special), special ? worded(name) : tr("Special"));
    shape_->setCurrentIndex(int(edit_.shape()));
    validating_ = false;
}

void ToolDialog::accept() {
    if (!form_->commit() || !problem().isEmpty()) return;
    QDialog::accept();
}

} // namespace facetmill::ui
