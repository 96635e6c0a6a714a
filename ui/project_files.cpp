#include "ui/project_files.h"
#include "ui/fixture_list.h"

#include "core/base/file.h"
#include "core/job/kept_folder.h"
#include "core/job/packed_project.h"
#include "core/job/project_inputs.h"
#include "core/mesh/sample.h"
#include "core/output/apt.h"
#include "core/output/post/post.h"
#include "core/setup/machine.h"
#include "ui/autosave.h"
#include "ui/dropped_files.h"
#include "ui/export.h"
#include "ui/file_writing.h"
#include "ui/messages.h"
#include "ui/operation_list.h"
#include "ui/part_dialog.h"
#include "ui/project_saving.h"
#include "ui/properties_panel.h"
#include "ui/scan_words.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/tool_list.h"
#include "ui/unpack_dialog.h"
#include "ui/worded.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QStandardPaths>

#include <algorithm>

namespace facetmill::ui {

namespace {

/// The document's name without the ending that it has once it is saved.
QString unended_name(const Document& document) {
    const std::filesystem::path& path = document.project().path;
    return path.empty() ? document.name() : path_text(path.stem());
}

} // namespace

ProjectFiles::ProjectFiles(Document& document, std::shared_ptr<Planner> planner, BackgroundJob& job,
                           Messages& messages, PartController& part, PropertiesPanel& properties,
                           ProjectTree& tree, QWidget* window)
    : QObject(window), document_(document), planner_(std::move(planner)), job_(job), messages_(messages),
      part_(part), properties_(properties), tree_(tree), window_(window),
      sample_folder_(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)
                     + QStringLiteral("/samples")),
      autosave_(std::make_unique<Autosave>(document, job, *this, messages, window)),
      saving_(new ProjectSaving(document, messages, properties, path_of(sample_folder_), window)) {
    saving_->setParent(this);
    connect(saving_, &ProjectSaving::saved, this, &ProjectFiles::renamed);
    connect(saving_, &ProjectSaving::settled, this, &ProjectFiles::settled);
    connect(&FileWriting::own(), &FileWriting::settled, this, &ProjectFiles::settled);
}

ProjectFiles::~ProjectFiles() = default;

bool ProjectFiles::busy() const {
    return saving_->busy() || FileWriting::own().busy();
}

bool ProjectFiles::may_discard() {
    saving_->finish();
    if (!document_.has_part() || !document_.modified()) return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Save the changes to “%1”?").arg(elided(document_.name(), 60)),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    box.setObjectName(QStringLiteral("unsaved_changes"));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return save();
    case QMessageBox::Discard:
        return true;
    default:
        return false;
    }
}

bool ProjectFiles::may_close() {
    if (!may_discard()) return false;
    autosave_->discard();
    return true;
}

void ProjectFiles::close_project() {
    if (!may_discard()) return;
    job_.cancel();
    document_.clear();
}

QString ProjectFiles::chosen_file(const QString& title, const QString& filter) const {
    return QFileDialog::getOpenFileName(window_, title, settings::last_folder(), filter);
}

void ProjectFiles::open_with_dialog() {
    const QString path = chosen_file(
        tr("Open"), tr("Meshes and projects (%1 *.facetmill);;All files (*)").arg(mesh_patterns()));
    if (!path.isEmpty()) open(path);
}

void ProjectFiles::open_program_with_dialog() {
    const QStringList files = QFileDialog::getOpenFileNames(
        window_, tr("Open program"), settings::last_folder(),
        tr("%1 programs (*%2);;All files (*)")
            .arg(worded(apt_writer().label), program_endings().join(QStringLiteral(" *"))));
    if (!files.isEmpty()) open_program(files);
}

void ProjectFiles::open_program(const QStringList& files) {
    if (!document_.has_part() || files.isEmpty()) return;
    settings::set_last_folder(QFileInfo(files.front()).absolutePath());
    std::vector<std::filesystem::path> paths;
    for (const QString& file : files)
        paths.push_back(path_of(QFileInfo(file).absoluteFilePath()));
    auto opened = std::make_shared<OpenedProgram>();
    auto project = std::make_shared<Project>(document_.project());
    job_.start(
        tr("Reading %1").arg(elided(QFileInfo(files.front()).fileName(), 30)),
        [=](const Progress& p) { *opened = facetmill::open_program(*project, paths, p); },
        [this, opened](const JobEnd& end) {
            if (!end.done()) return;
            messages_.succeeded();
            for (const std::string& line : opened->ignored)
                messages_.information(tr("Read over: %1").arg(text(line)), false);
            for (const std::string& remark : opened->remarks)
                messages_.warning(sentence(worded(remark)), false);
            document_.show_program(opened);
            messages_.show(tr("Showing %1 in place of the plan, until something is planned or File > Close "
                              "program.")
                               .arg(text(opened->name)));
        });
}

void ProjectFiles::choose_stock() {
    const QString path = chosen_file(tr("Stock mesh"), mesh_filters());
    if (path.isEmpty())
        properties_.reset(); // the kind is what it was
    else
        set_stock_file(path);
}

void ProjectFiles::set_stock_file(const QString& path) {
    settings::set_last_folder(QFileInfo(path).absolutePath());
    document_.change(tr("Choose stock"), [&](Project& p) {
        p.stock.kind = StockSpec::Kind::mesh;
        set_input(p, {ProjectInput::Kind::stock, {}}, path_of(QFileInfo(path).absoluteFilePath()));
    });
}

void ProjectFiles::choose_fixture(std::size_t index) {
    const QString path = chosen_file(tr("Fixture mesh"), mesh_filters());
    if (path.isEmpty()) return properties_.reset();
    settings::set_last_folder(QFileInfo(path).absolutePath());
    set_fixture_file(document_, index, path_of(QFileInfo(path).absoluteFilePath()));
}

void ProjectFiles::open(const QString& path, std::optional<LengthUnit> unit) {
    if (!may_discard()) return;
    const QFileInfo info(path);
    settings::set_last_folder(info.absolutePath());
    const std::filesystem::path absolute = path_of(info.absoluteFilePath());
    if (is_project_file(path) && is_packed(absolute))
        open_packed(absolute);
    else if (is_project_file(path))
        open_project(absolute);
    else
        open_mesh(absolute, unit);
}

void ProjectFiles::open_dropped(const QStringList& paths) {
    const DroppedFiles dropped = sort_dropped(paths, document_.has_part());
    if (!dropped.refusal.isEmpty()) return messages_.warning(dropped.refusal);
    if (!dropped.programs.isEmpty()) return open_program(dropped.programs);
    open(dropped.open);
}

void ProjectFiles::open_project(const std::filesystem::path& path) {
    try {
        show_project(load_project(path), QString(), false);
    } catch (const Error& e) {
        settings::remove_recent_file(path_text(path));
        messages_.fail(worded(e));
        emit settled();
        return;
    }
    settings::add_recent_file(path_text(path));
    messages_.information(tr("Opened %1.").arg(path_text(path)), false);
}

void ProjectFiles::open_packed(const std::filesystem::path& path) {
    auto* dialog = new UnpackDialog(path, window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, path] { unpack(path, path_of(dialog->folder())); });
    dialog->open();
}

void ProjectFiles::unpack(const std::filesystem::path& path, const std::filesystem::path& folder) {
    auto files = std::make_shared<std::vector<PackedFile>>();
    part_.begin_opening();
    job_.start(
        tr("Unpacking %1").arg(elided(path_text(path.filename()), 30)),
        [=](const Progress& p) {
            *files = unpack_project(path, folder, p.part(0, 0.8));
            copy_kept(path, files->front().path, p.part(0.8, 1));
        },
        [this, files, folder](const JobEnd& end) {
            if (!end.done()) return part_.end_opening();
            messages_.succeeded();
            messages_.information(
                tr("Unpacked %1 files into %2.").arg(count_text(files->size()), path_text(folder)), false);
            settings::set_last_folder(path_text(folder));
            open_project(files->front().path);
            part_.end_opening();
        });
}

void ProjectFiles::restore(Project project, const QString& name) {
    show_project(std::move(project), name, true);
}

void ProjectFiles::show_project(Project project, const QString& name, bool unsaved) {
    messages_.succeeded();
    document_.open(std::move(project), name, unsaved); // tells what is missing
    tree_.select({document_.operation_count() > 0 ? TreeNode::Kind::operation : TreeNode::Kind::part, 0});
    part_.reload();
}

/// A project to read a part for.
static Project probe_of(const std::filesystem::path& path, LengthUnit unit) {
    Project probe;
    probe.part.file = path.string();
    probe.part.unit = unit;
    probe.unit = project_unit(unit);
    return probe;
}

static void write_sample(const std::string& name, const std::filesystem::path& path, LengthUnit unit,
                         const Progress& progress) {
    const MeshPtr mesh = make_sample(name, default_sample_tolerance, progress.part(0, 0.8, "Tessellating"));
    std::error_code ec;
    std::filesystem::create_directories(path.parent_path(), ec); // a failure shows when the file is written
    save_stl(*mesh, path, unit, progress.part(0.8, 1, "Writing the part"));
}

void ProjectFiles::read_mesh(const std::filesystem::path& path, LengthUnit unit,
                             std::function<void(LoadedPart)> then) {
    auto loaded = std::make_shared<LoadedPart>();
    part_.begin_opening();
    job_.start(
        tr("Reading %1").arg(elided(path_text(path.filename()), 30)),
        [loaded, probe = probe_of(path, unit), planner = planner_](const Progress& p) {
            *loaded = load_part(*planner, probe, p.part(0, 0.95));
            loaded->remark = scan_remark(*loaded->part->mesh, loaded->part->report, p.part(0.95, 1));
        },
        [this, loaded, path, then](const JobEnd& end) {
            if (end.done()) {
                messages_.succeeded();
                then(*loaded);
            } else if (end.how == JobEnd::How::failed) {
                settings::remove_recent_file(path_text(path));
            }
            part_.end_opening();
        });
}

/// The unit that a file is in, which may state it; none where the user has to be asked.
static std::optional<LengthUnit> known_unit(const MeshReport& report, std::optional<LengthUnit> asked) {
    if (report.unit_known) return report.assumed_unit;
    return report.is_relief ? asked.value_or(LengthUnit::mm) : asked;
}

void ProjectFiles::open_mesh(const std::filesystem::path& path, std::optional<LengthUnit> unit) {
    if (!unit) unit = settings::remembered_unit(path_text(path));
    if (!unit) unit = settings::usual_project().unit;
    // Millimetres at first where nothing is known: they show how large the numbers are.
    const LengthUnit read_in = unit.value_or(LengthUnit::mm);
    read_mesh(path, read_in, [this, path, unit, read_in](const LoadedPart& loaded) {
        const std::optional<LengthUnit> known = known_unit(loaded.part->report, unit);
        if (known == read_in) return take_mesh(path, read_in, loaded, {});
        known ? open_mesh(path, known) : ask_unit(path, loaded);
    });
}

void ProjectFiles::ask_unit(const std::filesystem::path& path, const LoadedPart& loaded) {
    auto* dialog = new PartDialog(path_text(path.filename()), loaded.part->report,
                                  loaded.part->report.unit_guess, window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path, loaded] {
        const LengthUnit unit = dialog->unit();
        if (dialog->remember()) settings::remember_unit(path_text(path), unit);
        unit == LengthUnit::mm ? take_mesh(path, unit, loaded, {}) : open_mesh(path, unit);
    });
    dialog->open();
}

/// Machine and control that the user has, as far as there are such.
static void take_usual(Project& project) {
    const settings::UsualProject usual = settings::usual_project();
    const auto has = [](const auto& all, const std::string& name) {
        return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    };
    if (has(machines(), usual.machine)) project.machine = usual.machine;
    if (has(posts(), usual.post)) project.programs.post = usual.post;
}

/// Surfaces are tessellated as closely as the operations of a project want it.
static bool is_read_as_planned(const MeshReport& report, const Project& project) {
    return !report.surfaces || report.surfaces->chord == project.part_reading().chord;
}

static void tell_read(Messages& messages, const std::filesystem::path& path, const MeshReport& report) {
    messages.information(
        ProjectFiles::tr("Read %1: %2 facets.").arg(path_text(path.filename()), count_text(report.facets)),
        false);
    for (const std::string& word : report.warnings)
        messages.warning(sentence(worded(explain_warning(word))), false);
}

void ProjectFiles::take_mesh(const std::filesystem::path& path, LengthUnit unit, LoadedPart loaded,
                             const QString& name, bool turned) {
    Project project = turned ? default_turned_project(path, unit, loaded.part->box)
                             : default_project(path, unit, loaded.part->box);
    if (!turned) take_usual(project);
    name_operations(project);
    name_tools(project);
    loaded.key = Document::part_key(project);
    document_.open(std::move(project), name.isEmpty() ? path_text(path.stem()) : name, false);
    if (name.isEmpty()) settings::add_recent_file(path_text(path));
    tell_read(messages_, path, loaded.part->report);
    if (is_read_as_planned(loaded.part->report, document_.project()))
        part_.show(loaded, true);
    else
        part_.reload();
    tree_.select({TreeNode::Kind::part, 0});
    emit settled();
}

void ProjectFiles::new_from_sample(const std::string& name) {
    if (!may_discard()) return;
    const SampleKind* kind = nullptr;
    for (const SampleKind& k : sample_kinds())
        if (k.name == name) kind = &k;
    if (!kind) {
        messages_.fail(tr("There is no sample “%1”").arg(text(name)));
        return;
    }
    const std::filesystem::path path = path_of(sample_folder_) / (name + ".stl");
    const LengthUnit unit = kind->natural_unit;
    auto loaded = std::make_shared<LoadedPart>();
    part_.begin_opening();
    job_.start(
        tr("Making %1").arg(worded(kind->label)),
        [=, planner = planner_](const Progress& p) {
            write_sample(name, path, unit, p.part(0, 0.5));
            *loaded = load_part(*planner, probe_of(path, unit), p.part(0.5, 1));
        },
        [this, loaded, path, unit, label = text(name), turned = kind->turned](const JobEnd& end) {
            if (!end.done()) return part_.end_opening();
            messages_.succeeded();
            take_mesh(path, unit, *loaded, label, turned);
            part_.end_opening();
        });
}

bool ProjectFiles::save() {
    return saving_->save() && saving_->finish();
}

bool ProjectFiles::save_to(const QString& path) {
    return saving_->save_to(path) && saving_->finish();
}

void ProjectFiles::save_packed_with_dialog() {
    const QString start =
        settings::last_folder() + QChar('/') + unended_name(document_) + QStringLiteral("-packed.facetmill");
    const QString path = ask_project_name(window_, tr("Save packed copy"), start);
    if (!path.isEmpty()) save_packed_to(path);
}

void ProjectFiles::save_packed_to(const QString& path) {
    if (!document_.has_part()) return;
    if (!properties_.commit()) {
        messages_.warning(tr("A parameter is not valid: correct it before the project is packed."));
        return;
    }
    const std::filesystem::path target = path_of(QFileInfo(path).absoluteFilePath());
    try {
        keep_files(document_, target);
    } catch (const Error& e) {
        messages_.fail(worded(e));
        return;
    }
    auto project = std::make_shared<const Project>(document_.project());
    auto files = std::make_shared<std::vector<PackedFile>>();
    job_.start(
        tr("Packing %1").arg(elided(document_.name(), 30)),
        [=, name = unended_name(document_).toStdString()](const Progress& p) {
            *files = pack_project(*project, name, target, p.part(0, 0.8));
            if (!project->path.empty()) copy_kept(project->path, target, p.part(0.8, 1));
        },
        [this, files, target](const JobEnd& end) {
            if (!end.done()) return;
            messages_.succeeded();
            settings::set_last_folder(path_text(target.parent_path()));
            messages_.information(
                tr("Packed %1 files into %2.").arg(count_text(files->size()), path_text(target)));
        });
}

} // namespace facetmill::ui
