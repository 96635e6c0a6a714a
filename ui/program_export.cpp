#include "ui/program_export.h"

#include "core/base/file.h"
#include "core/job/posting.h"
#include "core/job/program_files.h"
#include "core/job/setup_sheet.h"
#include "core/output/apt.h"
#include "ui/export.h"
#include "ui/export_dialog.h"
#include "ui/file_writing.h"
#include "ui/language.h"
#include "ui/mesh_export.h"
#include "ui/messages.h"
#include "ui/properties_panel.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"
#include "ui/worded.h"

#include <QBuffer>
#include <QDesktopServices>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QUrl>

#include <functional>

namespace facetmill::ui {

ProgramExport::ProgramExport(const Document& document, BackgroundJob& job, Messages& messages,
                             PropertiesPanel& properties, Viewport& viewport,
                             VerificationController& verification, QWidget* window)
    : QObject(window), document_(document), job_(job), messages_(messages), properties_(properties),
      viewport_(viewport), verification_(verification), window_(window),
      meshes_(new MeshExport(document, job, messages, verification, window)) {}

void ProgramExport::programs_with_dialog() {
    ask_folder(std::nullopt);
}

void ProgramExport::ask_folder(std::optional<std::size_t> only) {
    if (!document_.complete_plan(only)) {
        save_programs({}, only); // says why not
        return;
    }
    if (!may_export()) return;
    const auto plan = document_.complete_plan(only);
    const Project& project = document_.project();
    QStringList files, endings{text(apt_writer().extension)};
    try {
        for (const std::string& name : plan_file_names(project, *plan))
            files << text(name);
        if (const std::string& post = project.programs.post; !post.empty())
            endings << text(project_post(project, post).extension);
    } catch (const Error& e) { // a post that cannot be read
        messages_.fail(worded(e));
        return;
    }
    auto* dialog = new ExportDialog(settings::last_folder(), files, endings, window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, only] {
        settings::set_last_folder(dialog->folder());
        save_programs(dialog->folder(), only);
    });
    dialog->open();
}

namespace {

struct DoubtWords {
    QString question, advice;
    QString verify; ///< what a button to verify first says; empty where that would tell nothing new
};

DoubtWords words_of_doubt(Verdict verdict) {
    using P = ProgramExport;
    switch (verdict) {
    case Verdict::failed:
        return {P::tr("Export programs that failed?"),
                P::tr("Running these programs can damage part, tool and machine."),
                {}};
    case Verdict::not_judged:
        return {P::tr("Export programs that cannot be judged?"),
                P::tr("Nobody knows what these programs leave of part, tool and machine."),
                {}};
    case Verdict::stale:
        return {P::tr("Export programs that were verified as they no longer are?"),
                P::tr("Verify again (F6), or export programs that nobody has checked since."),
                P::tr("Verify again")};
    case Verdict::verified:
        return {P::tr("Export programs of which only some are verified?"),
                P::tr("Verify all of them (F6), or export some that nobody has checked."), P::tr("Verify")};
    case Verdict::none:
        break;
    }
    return {P::tr("Export unverified programs?"),
            P::tr("Verify first (F6), or export programs that nobody has checked."), P::tr("Verify")};
}

} // namespace

bool ProgramExport::may_export() {
    const QString doubt = verification_.doubt();
    if (doubt.isEmpty()) return true;
    const DoubtWords words = words_of_doubt(verification_.model().verdict());
    QMessageBox box(QMessageBox::Warning, words.question, kept_together(doubt), QMessageBox::Cancel, window_);
    box.setInformativeText(words.advice);
    QPushButton* verify_first =
        words.verify.isEmpty() ? nullptr : box.addButton(words.verify, QMessageBox::AcceptRole);
    const QAbstractButton* go_on = box.addButton(tr("Export anyway"), QMessageBox::DestructiveRole);
    if (verify_first)
        box.setDefaultButton(verify_first);
    else
        box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    const QAbstractButton* pressed = box.clickedButton();
    if (verify_first && pressed == static_cast<QAbstractButton*>(verify_first)) emit verify_wanted();
    return pressed == go_on;
}

void ProgramExport::save_programs(const QString& folder, std::optional<std::size_t> only) {
    if (!properties_.commit()) {
        messages_.warning(tr("A parameter is not valid: correct it before programs are written."));
        return;
    }
    // Only what was planned from the present values is written: an old path under new values would lie.
    const auto plan = document_.complete_plan(only);
    if (!plan) {
        messages_.warning(
            only ? tr("There is nothing to export yet: this operation is not planned as it stands.")
                 : tr("There is nothing to export yet: not every operation is planned "
                      "as it stands. Press Plan (F5) first."));
        return;
    }
    auto project = std::make_shared<Project>(document_.project());
    auto written = std::make_shared<std::vector<std::filesystem::path>>();
    const std::filesystem::path target = path_of(folder);
    job_.start(
        tr("Writing programs"),
        [=](const Progress& p) {
            const std::vector<double> air = feed_in_air(*project, plan, p.part(0, 0.7));
            *written = write_plan(*project, *plan, target, p.part(0.7, 1, "Writing programs"), air);
        },
        [this, written, doubt = verification_.doubt()](const JobEnd& end) {
            if (!end.done()) return;
            messages_.succeeded();
            for (const auto& path : *written)
                messages_.information(tr("Wrote %1.").arg(path_text(path)), false);
            if (written->empty()) return;
            const QString wrote = tr("Wrote %n files into %1.", nullptr, int(written->size()))
                                      .arg(path_text(written->front().parent_path()));
            // A wrong path is worse than none: it does not leave without a word.
            if (doubt.isEmpty())
                messages_.show(wrote);
            else
                messages_.warning(wrote + QChar(' ') + doubt);
            const QUrl place = QUrl::fromLocalFile(path_text(written->front().parent_path()));
            messages_.offer({tr("Open folder"), [place] { QDesktopServices::openUrl(place); }});
            emit programs_written();
        });
}

void ProgramExport::sheet_with_dialog() {
    if (!may_write_sheet()) return;
    export_file(window_, tr("Export setup sheet"), ExportFormat::web_page,
                QFileInfo(document_.name()).completeBaseName(),
                std::bind_front(&ProgramExport::save_sheet, this));
}

bool ProgramExport::may_write_sheet() {
    if (!document_.complete_plan()) {
        messages_.warning(tr("There is nothing to tell yet: not every operation is planned as "
                             "it stands. Press Plan (F5) first."));
        return false;
    }
    if (verification_.model().current() && verification_.model().last_judged().isEmpty()) return true;
    messages_.warning(tr("A setup sheet begins with the verdict of the verification. Press "
                         "Verify (F6) first."));
    return false;
}

void ProgramExport::save_sheet(const QString& path) {
    if (!properties_.commit()) {
        messages_.warning(tr("A parameter is not valid: correct it before the setup sheet is written."));
        return;
    }
    if (!may_write_sheet()) return;
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    viewport_.full_picture().save(&buffer, "PNG");
    auto project = std::make_shared<Project>(document_.project());
    const auto plan = document_.complete_plan(); // what was verified, with what is said of the stock
    const auto judged = verification_.model().outcome_shared();
    const std::filesystem::path target = path_of(path);
    try {
        keep_files(document_, target);
    } catch (const Error& e) {
        messages_.fail(worded(e));
        return;
    }
    job_.start(
        tr("Writing the setup sheet"),
        [=](const Progress& p) {
            const SheetLanguage language{utf8(spoken_language()), [](const std::string& english) {
                                             return utf8(in_user_numbers(worded(english)));
                                         }};
            const SheetPicture picture{utf8(tr("As the workbench showed it")), png.toStdString()};
            OutputFile file(target);
            if (judged->chain.size() > 1) {
                std::vector<std::vector<SheetPicture>> pictures(judged->chain.size());
                for (std::size_t k = 0; k < judged->chain.size(); ++k)
                    if (chosen_setup(judged->chain[k].project) == chosen_setup(*project))
                        pictures[k].push_back(picture);
                const JudgedChain chain{judged->chain,
                                        chain_programs(judged->chain, planned_programs(judged->chain)),
                                        judged->verification, judged->posted_blocks};
                file.write(setup_sheet({&chain, 1}, pictures, language));
            } else {
                file.write(setup_sheet(*project, *plan, verify_programs(*project, plan),
                                       *judged->verification, {&picture, 1}, language));
            }
            p.check();
            file.commit();
        },
        [this, path](const JobEnd& end) {
            if (!end.done()) return;
            messages_.succeeded();
            messages_.information(tr("Wrote %1.").arg(path));
        });
}

void ProgramExport::picture_with_dialog() {
    export_file(window_, tr("Export picture"), ExportFormat::picture,
                QFileInfo(document_.name()).completeBaseName(),
                std::bind_front(&ProgramExport::save_picture, this));
}

void ProgramExport::save_picture(const QString& path) {
    write_file(
        *this, document_, path, [picture = viewport_.full_picture()] { return png_bytes(picture); },
        [this, path](const QString& wrong) {
            if (!wrong.isEmpty()) return messages_.fail(wrong);
            messages_.succeeded();
            messages_.information(tr("Wrote %1.").arg(path), false);
        });
}

} // namespace facetmill::ui
