// Opening, saving and exporting.
#include "ui/main_window.h"

#include "core/base/file.h"
#include "core/job/program_files.h"
#include "core/job/setup_sheet.h"
#include "core/mesh/sample.h"
#include "core/output/apt.h"
#include "ui/export.h"
#include "ui/part_dialog.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QBuffer>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>

namespace facetmill::ui {

namespace {

bool is_project(const std::filesystem::path& path) {
    return path_text(path.extension()).compare(QStringLiteral(".facetmill"), Qt::CaseInsensitive) == 0;
}

/// Copies `from` into `folder` unless the same bytes are there already; a name that is taken by other bytes
/// gets a number.
std::filesystem::path copy_beside(const std::filesystem::path& from, const std::filesystem::path& folder) {
    const InputFile source(from);
    for (int n = 1;; ++n) {
        std::filesystem::path to = folder / from.filename();
        if (n > 1)
            to.replace_filename(from.stem().string() + "-" + std::to_string(n) + from.extension().string());
        if (std::filesystem::exists(to)) {
            try {
                if (InputFile(to).bytes() == source.bytes()) return to;
            } catch (const Error&) {
                // unreadable, empty or a folder: another file that keeps its name
            }
            continue;
        }
        OutputFile out(to);
        out.write(source.bytes());
        out.commit();
        return to;
    }
}

} // namespace

bool MainWindow::may_discard() {
    if (!document_.has_part() || !document_.modified()) return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Save the changes to “%1”?").arg(elided(document_.name(), 60)),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
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

void MainWindow::close_project() {
    if (!may_discard()) return;
    job_.cancel();
    document_.clear();
    update_actions();
}

void MainWindow::open_with_dialog() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open"), settings::last_folder(),
        tr("Meshes and projects (%1 *.facetmill);;All files (*)").arg(mesh_patterns()));
    if (!path.isEmpty()) open_file(path);
}

void MainWindow::choose_stock() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Stock mesh"), settings::last_folder(),
                                                      tr("Meshes (%1);;All files (*)").arg(mesh_patterns()));
    if (path.isEmpty())
        properties_->reset(); // the kind is what it was
    else
        set_stock_file(path);
}

void MainWindow::set_stock_file(const QString& path) {
    const std::filesystem::path file = path_of(QFileInfo(path).absoluteFilePath());
    const std::filesystem::path& project = document_.project().path;
    const std::filesystem::path relative = file.lexically_relative(project.parent_path());
    const bool below = !project.empty() && !relative.empty() && *relative.begin() != "..";
    settings::set_last_folder(QFileInfo(path).absolutePath());
    document_.change(tr("Choose stock"), [&](Project& p) {
        p.stock.kind = StockSpec::Kind::mesh;
        p.stock.file = (below ? relative : file).generic_string();
    });
}

void MainWindow::open_file(const QString& path, std::optional<LengthUnit> unit) {
    if (!may_discard()) return;
    const QFileInfo info(path);
    settings::set_last_folder(info.absolutePath());
    const std::filesystem::path absolute = path_of(info.absoluteFilePath());
    if (is_project(absolute))
        open_project(absolute);
    else
        open_mesh(absolute, unit);
}

void MainWindow::open_project(const std::filesystem::path& path) {
    try {
        Project project = load_project(path);
        project.path = path;
        document_.open(std::move(project), QString(), false);
    } catch (const Error& e) {
        settings::remove_recent_file(path_text(path));
        fail(text(e.what()));
        check_settled();
        return;
    }
    settings::add_recent_file(path_text(path));
    last_failure_.clear();
    tell(MessageBar::Kind::information, tr("Opened %1.").arg(path_text(path)), false);
    tree_->select({document_.operation_count() > 0 ? TreeNode::Kind::operation : TreeNode::Kind::part, 0});
    reload_part();
}

void MainWindow::read_mesh(const std::filesystem::path& path, LengthUnit unit,
                           std::function<void(LoadedPart)> then) {
    auto loaded = std::make_shared<LoadedPart>();
    Project probe;
    probe.part.file = path.string();
    probe.part.unit = probe.unit = unit;
    job_.start(
        tr("Reading %1").arg(elided(path_text(path.filename()), 30)),
        [loaded, probe, planner = planner_](const Progress& p) { *loaded = load_part(*planner, probe, p); },
        [this, loaded, path, then](const JobEnd& end) {
            if (end.done()) {
                last_failure_.clear();
                then(*loaded);
            } else if (end.how == JobEnd::How::failed) {
                settings::remove_recent_file(path_text(path));
            }
        });
}

void MainWindow::open_mesh(const std::filesystem::path& path, std::optional<LengthUnit> unit) {
    if (!unit) unit = settings::remembered_unit(path_text(path));
    if (unit) {
        read_mesh(path, *unit,
                  [this, path, u = *unit](const LoadedPart& loaded) { take_mesh(path, u, loaded, {}); });
        return;
    }
    // Read in millimetres first: that shows whether it is a mesh at all, and how large its numbers are.
    read_mesh(path, LengthUnit::mm, [this, path](const LoadedPart& loaded) { ask_unit(path, loaded); });
}

void MainWindow::ask_unit(const std::filesystem::path& path, LoadedPart loaded) {
    auto* dialog =
        new PartDialog(path_text(path.filename()), loaded.part->report, loaded.part->report.unit_guess, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path, loaded] {
        const LengthUnit unit = dialog->unit();
        if (dialog->remember()) settings::remember_unit(path_text(path), unit);
        if (unit == LengthUnit::mm)
            take_mesh(path, unit, loaded, {});
        else
            read_mesh(path, unit,
                      [this, path, unit](const LoadedPart& again) { take_mesh(path, unit, again, {}); });
    });
    dialog->open();
}

void MainWindow::take_mesh(const std::filesystem::path& path, LengthUnit unit, LoadedPart loaded,
                           const QString& name, bool turned) {
    Project project = turned ? default_turned_project(path, unit, loaded.part->box)
                             : default_project(path, unit, loaded.part->box);
    loaded.key = Document::part_key(project);
    document_.open(std::move(project), name.isEmpty() ? path_text(path.stem()) : name, true);
    if (name.isEmpty()) settings::add_recent_file(path_text(path));
    tell(MessageBar::Kind::information,
         tr("Read %1: %2 facets.").arg(path_text(path.filename()), count_text(loaded.part->report.facets)),
         false);
    for (const std::string& word : loaded.part->report.warnings)
        tell(MessageBar::Kind::warning, sentence(text(explain_warning(word))), false);
    show_part(loaded, true);
    tree_->select({TreeNode::Kind::part, 0});
    check_settled();
}

void MainWindow::new_from_sample(const std::string& name) {
    if (!may_discard()) return;
    const SampleKind* kind = nullptr;
    for (const SampleKind& k : sample_kinds())
        if (k.name == name) kind = &k;
    if (!kind) {
        fail(tr("There is no sample “%1”").arg(text(name)));
        return;
    }
    const std::filesystem::path path = path_of(sample_folder_) / (name + ".stl");
    const LengthUnit unit = kind->natural_unit;
    auto loaded = std::make_shared<LoadedPart>();
    job_.start(
        tr("Making %1").arg(text(kind->label)),
        [=, planner = planner_](const Progress& p) {
            const MeshPtr mesh = make_sample(name, default_sample_tolerance, p.part(0, 0.4, "Tessellating"));
            std::error_code ec;
            std::filesystem::create_directories(path.parent_path(),
                                                ec); // a failure shows when the file is written
            save_stl(*mesh, path, unit, p.part(0.4, 0.5, "Writing the part"));
            Project probe;
            probe.part.file = path.string();
            probe.part.unit = probe.unit = unit;
            *loaded = load_part(*planner, probe, p.part(0.5, 1));
        },
        [this, loaded, path, unit, label = text(name), turned = kind->turned](const JobEnd& end) {
            if (!end.done()) return;
            last_failure_.clear();
            take_mesh(path, unit, *loaded, label, turned);
        });
}

bool MainWindow::save() {
    if (document_.project().path.empty()) return save_as();
    return save_to(path_text(document_.project().path));
}

bool MainWindow::save_as() {
    const QString name = document_.name();
    const QString start = document_.project().path.empty()
                              ? settings::last_folder() + QChar('/') + name + QStringLiteral(".facetmill")
                              : path_text(document_.project().path);
    QFileDialog dialog(this, tr("Save project"), QFileInfo(start).absolutePath(),
                       tr("Facetmill projects (*.facetmill)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("facetmill")); // before the question whether to replace
    dialog.selectFile(QFileInfo(start).fileName());
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return false;
    return save_to(dialog.selectedFiles().front());
}

bool MainWindow::save_to(const QString& path) {
    if (!document_.has_part()) return false;
    if (!properties_->commit()) {
        tell(MessageBar::Kind::warning,
             tr("A parameter is not valid: correct it before the project is saved."));
        return false;
    }
    try {
        const std::filesystem::path target = path_of(QFileInfo(path).absoluteFilePath());
        Project copy = document_.project();
        const std::filesystem::path part = copy.part_path();
        move_project(copy, target);
        // A sample lies among the program's own files: the project takes it along.
        if (part.parent_path() == path_of(sample_folder_))
            copy.part.file = copy_beside(part, target.parent_path()).filename().string();
        save_project(copy, target);
        document_.saved(copy);
    } catch (const Error& e) {
        fail(text(e.what()));
        return false;
    }
    settings::add_recent_file(QFileInfo(path).absoluteFilePath());
    settings::set_last_folder(QFileInfo(path).absolutePath());
    message_->dismiss();
    tell(MessageBar::Kind::information, tr("Saved %1.").arg(path), false);
    update_title();
    return true;
}

void MainWindow::export_with_dialog() {
    if (!document_.complete_plan()) {
        export_to({}); // says why not
        return;
    }
    if (!may_export()) return;
    const QString folder = QFileDialog::getExistingDirectory(
        this, tr("Export %1 programs into").arg(text(apt_writer().label)), settings::last_folder());
    if (folder.isEmpty()) return;
    const QStringList there = QDir(folder).entryList(
        {QLatin1Char('*') + text(apt_writer().extension), QStringLiteral("report.json")}, QDir::Files);
    if (!there.isEmpty()
        && QMessageBox::question(
               this, tr("Replace files?"),
               tr("The folder holds %1 and %n more. Programs of the same name are replaced.", nullptr,
                  int(there.size()) - 1)
                   .arg(elided(there.front(), 40)),
               QMessageBox::Ok | QMessageBox::Cancel)
               != QMessageBox::Ok)
        return;
    settings::set_last_folder(folder);
    export_to(folder);
}

bool MainWindow::may_export() {
    const QString doubt = controller_->doubt();
    if (doubt.isEmpty()) return true;
    const Verdict verdict = controller_->model().verdict();
    QMessageBox box(QMessageBox::Warning, tr("Export unverified programs?"), doubt, QMessageBox::Cancel,
                    this);
    box.setInformativeText(verdict == Verdict::failed
                               ? tr("Running these programs can damage part, tool and machine.")
                               : tr("Verify first (F6), or export programs that nobody has checked."));
    QPushButton* verify_first =
        verdict == Verdict::failed ? nullptr : box.addButton(tr("Verify"), QMessageBox::AcceptRole);
    const QAbstractButton* go_on = box.addButton(tr("Export anyway"), QMessageBox::DestructiveRole);
    if (verify_first)
        box.setDefaultButton(verify_first);
    else
        box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    const QAbstractButton* pressed = box.clickedButton();
    if (verify_first && pressed == static_cast<QAbstractButton*>(verify_first)) verify();
    return pressed == go_on;
}

void MainWindow::export_to(const QString& folder) {
    if (!properties_->commit()) {
        tell(MessageBar::Kind::warning,
             tr("A parameter is not valid: correct it before programs are written."));
        return;
    }
    // Only what was planned from the present values is written: an old path under new values would lie.
    const auto plan = document_.complete_plan();
    if (!plan) {
        tell(MessageBar::Kind::warning, tr("There is nothing to export yet: not every operation is planned "
                                           "as it stands. Press Plan (F5) first."));
        return;
    }
    auto project = std::make_shared<Project>(document_.project());
    auto written = std::make_shared<std::vector<std::filesystem::path>>();
    const std::filesystem::path target = path_of(folder);
    job_.start(
        tr("Writing programs"),
        [=](const Progress& p) {
            *written = write_plan(*project, *plan, target, p.part(0, 1, "Writing programs"));
        },
        [this, written, doubt = controller_->doubt()](const JobEnd& end) {
            if (!end.done()) return;
            last_failure_.clear();
            for (const auto& path : *written)
                tell(MessageBar::Kind::information, tr("Wrote %1.").arg(path_text(path)), false);
            if (written->empty()) return;
            const QString wrote = tr("Wrote %n file(s) into %1.", nullptr, int(written->size()))
                                      .arg(path_text(written->front().parent_path()));
            // A wrong path is worse than none: it does not leave without a word.
            if (doubt.isEmpty())
                message_->show_message(MessageBar::Kind::information, wrote);
            else
                tell(MessageBar::Kind::warning, wrote + QChar(' ') + doubt);
        });
}

void MainWindow::sheet_with_dialog() {
    if (!may_write_sheet()) return;
    QFileDialog dialog(this, tr("Export setup sheet"), settings::last_folder(), tr("Web pages (*.html)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("html"));
    dialog.selectFile(QFileInfo(document_.name()).completeBaseName() + QStringLiteral(".html"));
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
    save_sheet(dialog.selectedFiles().front());
}

bool MainWindow::may_write_sheet() {
    if (!document_.complete_plan()) {
        tell(MessageBar::Kind::warning, tr("There is nothing to tell yet: not every operation is planned as "
                                           "it stands. Press Plan (F5) first."));
        return false;
    }
    if (controller_->model().current()) return true;
    tell(MessageBar::Kind::warning, tr("A setup sheet begins with the verdict of the verification. Press "
                                       "Verify (F6) first."));
    return false;
}

void MainWindow::save_sheet(const QString& path) {
    if (!properties_->commit()) {
        tell(MessageBar::Kind::warning,
             tr("A parameter is not valid: correct it before the setup sheet is written."));
        return;
    }
    if (!may_write_sheet()) return;
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    viewport_->full_picture().save(&buffer, "PNG");
    auto project = std::make_shared<Project>(document_.project());
    const auto plan = document_.complete_plan(); // what was verified, with what is said of the stock
    const auto verification = controller_->model().outcome().verification;
    const std::filesystem::path target = path_of(path);
    job_.start(
        tr("Writing the setup sheet"),
        [=](const Progress& p) {
            const SheetPicture picture{"As the workbench showed it", png.toStdString()};
            OutputFile file(target);
            file.write(
                setup_sheet(*project, *plan, verify_programs(*project, plan), *verification, {&picture, 1}));
            p.check();
            file.commit();
        },
        [this, path](const JobEnd& end) {
            if (!end.done()) return;
            last_failure_.clear();
            tell(MessageBar::Kind::information, tr("Wrote %1.").arg(path));
        });
}

void MainWindow::picture_with_dialog() {
    QFileDialog dialog(this, tr("Export picture"), settings::last_folder(), tr("Pictures (*.png)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("png"));
    dialog.selectFile(QFileInfo(document_.name()).completeBaseName() + QStringLiteral(".png"));
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
    save_picture(dialog.selectedFiles().front());
}

bool MainWindow::save_picture(const QString& path) {
    if (const QString wrong = write_picture(path, viewport_->full_picture()); !wrong.isEmpty()) {
        fail(wrong);
        return false;
    }
    tell(MessageBar::Kind::information, tr("Wrote %1.").arg(path), false);
    return true;
}

} // namespace facetmill::ui
