#include "ui/tool_library_dialog.h"

#include "core/base/file.h"
#include "ui/file_writing.h"
#include "ui/icons.h"
#include "ui/own_folders.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>

namespace facetmill::ui {

namespace {

enum ToolColumn { number, name, shape, diameter, flutes, material, cutting, library, columns };

/// The row's tool; rows are sorted and filtered, the list is not.
constexpr int entry_role = Qt::UserRole + 1;

/// A cell that is sorted by its number.
class NumberItem : public QTableWidgetItem {
public:
    NumberItem(const QString& shown, double value) : QTableWidgetItem(shown), value_(value) {
        setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    bool operator<(const QTableWidgetItem& other) const override {
        const auto* number_item = dynamic_cast<const NumberItem*>(&other);
        return number_item ? value_ < number_item->value_ : QTableWidgetItem::operator<(other);
    }

private:
    double value_;
};

QString counted(std::size_t tools) {
    return ToolLibraryDialog::tr("%1 tools", nullptr, int(tools)).arg(tools);
}

QStringList worded_lines(const std::vector<std::string>& lines) {
    QStringList all;
    for (const std::string& line : lines)
        all << worded(line);
    return all;
}

/// The materials that a tool has feeds for.
QString feeds_of(const Tool& tool) {
    QStringList materials;
    for (const CuttingData& data : tool.cutting) {
        const QString called = text(data.material.empty() ? data.name : data.material);
        if (!called.isEmpty() && !materials.contains(called)) materials << called;
    }
    return materials.join(QStringLiteral(", "));
}

} // namespace

QAction* ToolLibraryDialog::make_action(Document& document, QWidget* parent) {
    auto* action = new QAction(icon(Icon::tool), tr("Tool library…"), parent);
    connect(action, &QAction::triggered, parent, [&document, parent] {
        auto* dialog = new ToolLibraryDialog(document, own_library_folder(), parent->window());
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    return action;
}

ToolLibraryDialog::ToolLibraryDialog(Document& document, std::filesystem::path folder, QWidget* parent)
    : QDialog(parent), document_(document), folder_(std::move(folder)) {
    setObjectName(QStringLiteral("tool_library"));
    setWindowTitle(tr("Tool library"));
    filter_ = new QLineEdit(this);
    filter_->setObjectName(QStringLiteral("filter"));
    filter_->setAccessibleName(tr("Words to look for"));
    filter_->setPlaceholderText(tr("Find by name, shape, material or library"));
    filter_->setClearButtonEnabled(true);
    connect(filter_, &QLineEdit::textChanged, this, &ToolLibraryDialog::show_tools);

    table_ = new QTableWidget(0, columns, this);
    table_->setObjectName(QStringLiteral("tools"));
    table_->setAccessibleName(tr("Tools of the library"));
    table_->setHorizontalHeaderLabels({tr("No."), tr("Name"), tr("Shape"),
                                       tr("Diameter (%1)").arg(text(unit_name(document_.unit()))),
                                       tr("Flutes"), tr("Material"), tr("Feeds for"), tr("Library")});
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->verticalHeader()->setVisible(false);
    table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 8);
    table_->setWordWrap(false);
    table_->horizontalHeader()->setSectionResizeMode(name, QHeaderView::Stretch);
    table_->horizontalHeader()->setMinimumSectionSize(table_->fontMetrics().averageCharWidth() * 10);
    table_->setSortingEnabled(true);
    table_->sortByColumn(library, Qt::AscendingOrder);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &ToolLibraryDialog::update_buttons);
    connect(table_, &QTableWidget::cellDoubleClicked, this, &ToolLibraryDialog::add_chosen);
    empty_ = new QLabel(table_);
    empty_->setObjectName(QStringLiteral("empty"));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    auto* over = new QVBoxLayout(table_);
    over->addWidget(empty_);

    title_ = new QLabel(this);
    title_->setObjectName(QStringLiteral("told"));
    title_->setWordWrap(true);
    title_->setVisible(false);
    remarks_ = new QPlainTextEdit(this);
    remarks_->setObjectName(QStringLiteral("remarks"));
    remarks_->setReadOnly(true);
    remarks_->setMaximumHeight(110);
    remarks_->setVisible(false);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    add_ = buttons->addButton(tr("&Add to project"), QDialogButtonBox::ActionRole);
    add_->setObjectName(QStringLiteral("add"));
    add_->setDefault(true);
    auto* import = buttons->addButton(tr("&Import…"), QDialogButtonBox::ActionRole);
    import->setToolTip(tr("Take over tools of FreeCAD, Fusion, LinuxCNC, CAMotics or Kiri:Moto"));
    keep_ = buttons->addButton(tr("&Keep project’s tools"), QDialogButtonBox::ActionRole);
    keep_->setObjectName(QStringLiteral("keep"));
    keep_->setToolTip(tr("Put the tools of the project into a library of its name"));
    export_ = buttons->addButton(tr("&Export…"), QDialogButtonBox::ActionRole);
    export_->setObjectName(QStringLiteral("export"));
    export_->setToolTip(tr("Write the chosen tools, or all that are shown, for another program"));
    for (QPushButton* b : {import, keep_, export_})
        b->setAutoDefault(false);
    connect(add_, &QPushButton::clicked, this, &ToolLibraryDialog::add_chosen);
    connect(import, &QPushButton::clicked, this, &ToolLibraryDialog::ask_for_file);
    connect(keep_, &QPushButton::clicked, this, &ToolLibraryDialog::keep_project_tools);
    connect(export_, &QPushButton::clicked, this, &ToolLibraryDialog::ask_where);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* column = new QVBoxLayout(this);
    column->addWidget(filter_);
    column->addWidget(table_, 1);
    column->addWidget(title_);
    column->addWidget(remarks_);
    column->addWidget(buttons);
    resize(760, 480);
    read_folder();
}

void ToolLibraryDialog::read_folder() {
    entries_.clear();
    std::vector<std::string> trouble;
    for (const KeptLibrary& kept : kept_libraries(folder_)) {
        if (!kept.trouble.empty()) trouble.push_back(kept.trouble);
        for (const LibraryTool& tool : kept.library.tools)
            entries_.push_back({tool, path_text(kept.file.stem())});
    }
    if (!trouble.empty()) tell(tr("Some libraries cannot be read"), worded_lines(trouble));
    show_tools();
}

void ToolLibraryDialog::show_tools() {
    const QString wanted = filter_->text().trimmed();
    const double per = mm_per(document_.unit());
    table_->setSortingEnabled(false); // rows would move while they are filled
    table_->setRowCount(0);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const LibraryTool& t = entries_[i].tool;
        const QString named = text(t.tool.name), shaped = worded(t.tool.shape_name()),
                      made = text(t.material);
        if (!(named + QChar(' ') + shaped + QChar(' ') + made + QChar(' ') + entries_[i].library)
                 .contains(wanted, Qt::CaseInsensitive))
            continue;
        const int row = table_->rowCount();
        table_->insertRow(row);
        const QString size = number_text(t.tool.diameter / per, 5);
        table_->setItem(row, number, new NumberItem(QString::number(t.tool.number), double(t.tool.number)));
        table_->setItem(row, name, new QTableWidgetItem(named));
        table_->setItem(row, shape, new QTableWidgetItem(shaped));
        table_->setItem(row, diameter, new NumberItem(size, t.tool.diameter));
        table_->setItem(row, flutes,
                        new NumberItem(t.tool.flutes > 0 ? QString::number(t.tool.flutes) : QString(),
                                       double(t.tool.flutes)));
        table_->setItem(row, material, new QTableWidgetItem(made));
        const QString run = feeds_of(t.tool);
        table_->setItem(row, cutting, new QTableWidgetItem(run));
        table_->item(row, cutting)->setToolTip(run);
        table_->setItem(row, library, new QTableWidgetItem(entries_[i].library));
        table_->item(row, number)->setData(entry_role, qulonglong(i));
        table_->item(row, name)->setToolTip(named);
    }
    table_->horizontalHeader()->setMinimumSectionSize(table_->fontMetrics().averageCharWidth() * 10);
    table_->setSortingEnabled(true);
    table_->resizeColumnsToContents();
    table_->horizontalHeader()->setSectionResizeMode(name, QHeaderView::Stretch);
    empty_->setVisible(table_->rowCount() == 0);
    empty_->setText(entries_.empty()
                        ? tr("No tool is kept yet. Import a library of another program, or keep the "
                             "tools of this project.")
                        : tr("No tool has “%1”.").arg(wanted));
    update_buttons();
}

void ToolLibraryDialog::tell(const QString& title, const QStringList& lines) {
    title_->setText(title);
    title_->setVisible(true);
    remarks_->setPlainText(lines.join(QChar('\n')));
    remarks_->setVisible(!lines.isEmpty());
}

std::vector<LibraryTool> ToolLibraryDialog::shown(bool only_chosen) const {
    std::vector<LibraryTool> tools;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QTableWidgetItem* item = table_->item(row, number);
        if (!only_chosen || item->isSelected())
            tools.push_back(entries_[std::size_t(item->data(entry_role).toULongLong())].tool);
    }
    return tools;
}

void ToolLibraryDialog::update_buttons() {
    add_->setEnabled(document_.has_part() && !table_->selectedItems().isEmpty());
    keep_->setEnabled(document_.has_part() && !document_.project().tools.empty());
    export_->setEnabled(table_->rowCount() > 0);
}

void ToolLibraryDialog::import_file(const QString& path) {
    struct Taken {
        ReadLibrary read;
        std::filesystem::path place;
    };
    const auto taken = std::make_shared<Taken>();
    FileWriting::own().start(
        *this,
        [taken, file = path_of(path), unit = document_.unit(), folder = folder_] {
            taken->read = load_library(file, unit);
            taken->place = keep_library(taken->read.library, folder, file.stem().string());
        },
        [this, taken](const QString& wrong) {
            if (!wrong.isEmpty()) return tell(tr("Nothing was taken over"), {wrong});
            read_folder();
            const ToolLibrary& library = taken->read.library;
            const QString holders =
                library.holders.empty()
                    ? QString()
                    : tr(", holders for the dialog of a tool: %1").arg(library.holders.size());
            tell(tr("%1 kept as “%2”").arg(counted(library.tools.size()), path_text(taken->place.stem()))
                     + holders + (taken->read.remarks.empty() ? QString() : tr("; not carried:")),
                 worded_lines(taken->read.remarks));
        });
}

void ToolLibraryDialog::export_to(const QString& path) {
    ToolLibrary out;
    out.unit = document_.has_part() ? document_.unit() : LengthUnit::mm;
    out.name = utf8(QFileInfo(path).completeBaseName());
    out.tools = shown(true);
    if (out.tools.empty()) out.tools = shown(false);
    const auto remarks = std::make_shared<std::vector<std::string>>();
    FileWriting::own().start(
        *this,
        [remarks, out, file = path_of(path)] {
            const WrittenLibrary written = write_library(out, format_of(file), file.filename().string());
            OutputSet set;
            for (const WrittenLibrary::File& f : written.files)
                set.add(file.parent_path() / f.name).write(f.bytes);
            set.commit();
            *remarks = written.remarks;
        },
        [this, remarks, path](const QString& wrong) {
            if (!wrong.isEmpty()) return tell(tr("Nothing was written"), {wrong});
            tell(tr("Written to %1").arg(elided(path, 60))
                     + (remarks->empty() ? QString() : tr("; not carried:")),
                 worded_lines(*remarks));
        });
}

void ToolLibraryDialog::add_chosen() {
    const std::vector<LibraryTool> tools = shown(true);
    if (tools.empty() || !document_.has_part()) return;
    document_.change(tr("Add tools of the library"), [&](Project& project) {
        for (const LibraryTool& tool : tools)
            project.tools.push_back(numbered_for(tool, project.tools));
    });
    tell(tr("%1 added to the project").arg(counted(tools.size())), {});
    update_buttons();
}

void ToolLibraryDialog::keep_project_tools() {
    if (!document_.has_part()) return;
    const Project& project = document_.project();
    const std::string named = project.path.empty() ? utf8(tr("Project")) : project.path.stem().string();
    const auto place = std::make_shared<std::filesystem::path>();
    FileWriting::own().start(
        *this,
        [place, library = library_of(project.tools, project.unit, named), folder = folder_, named] {
            *place = keep_library(library, folder, named);
        },
        [this, place, tools = project.tools.size()](const QString& wrong) {
            if (!wrong.isEmpty()) return tell(tr("Nothing was kept"), {wrong});
            read_folder();
            tell(tr("%1 kept as “%2”").arg(counted(tools), path_text(place->stem())), {});
        });
}

void ToolLibraryDialog::ask_for_file() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Import tools"), {},
        tr("Tool libraries (*.fmtools *.json *.tools *.fctb *.fctl *.fcholder *.tbl);;All files (*)"));
    if (!path.isEmpty()) import_file(path);
}

void ToolLibraryDialog::ask_where() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Export tools"), {},
                                     tr("Facetmill (*.fmtools);;Fusion (*.json);;Fusion, packed "
                                        "(*.tools);;FreeCAD (*.fctl);;LinuxCNC (*.tbl)"));
    if (!path.isEmpty()) export_to(path);
}

} // namespace facetmill::ui
