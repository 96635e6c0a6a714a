#include "ui/templates.h"

#include "core/base/file.h"
#include "core/job/job_template.h"
#include "ui/file_writing.h"
#include "ui/icons.h"
#include "ui/messages.h"
#include "ui/own_folders.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QUrl>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr const char* ending = ".fmtemplate";
constexpr int shown_template = 48;

std::vector<std::filesystem::path> templates_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
        if (entry.path().extension() == ending) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

Templates::Templates(Document& document, Messages& messages, QWidget* window)
    : QObject(window), document_(document), messages_(messages), window_(window) {
    menu_ = new QMenu(tr("Apply &template"), window);
    menu_->setIcon(icon(Icon::operation));
    menu_->setToolTipsVisible(true);
    connect(menu_, &QMenu::aboutToShow, this, &Templates::list);
}

void Templates::list() {
    menu_->clear();
    for (const auto& file : templates_in(own_template_folder())) {
        QAction* action = menu_->addAction(elided(path_text(file.stem()), shown_template));
        connect(action, &QAction::triggered, this, [this, file] { apply(file); });
        action->setEnabled(document_.has_part());
        try {
            const std::string name = file.filename().string();
            action->setToolTip(worded(template_summary(InputFile(file).bytes(), name)));
        } catch (const Error& e) {
            action->setToolTip(worded(e));
            action->setEnabled(false);
        }
    }
    if (menu_->isEmpty()) menu_->addAction(tr("None is kept yet"))->setEnabled(false);
    menu_->addSeparator();
    QAction* from = menu_->addAction(tr("From a file…"), this, &Templates::apply_with_dialog);
    from->setEnabled(document_.has_part());
    QAction* show = menu_->addAction(tr("Show their folder"), this, [this] {
        QDesktopServices::openUrl(QUrl::fromLocalFile(path_text(own_template_folder())));
    });
    std::error_code failed;
    show->setEnabled(std::filesystem::is_directory(own_template_folder(), failed));
}

std::filesystem::path Templates::file_of(const QString& name) const {
    return own_template_folder() / path_of(name + QString::fromLatin1(ending));
}

void Templates::save_with_dialog() {
    if (!document_.has_part()) return;
    const std::filesystem::path& own = document_.project().path;
    bool taken = false;
    const QString name =
        QInputDialog::getText(window_, tr("Save as template"), tr("Operations, tools and settings as"),
                              QLineEdit::Normal, own.empty() ? QString() : path_text(own.stem()), &taken)
            .trimmed();
    if (!taken || name.isEmpty()) return;
    std::error_code failed;
    if (std::filesystem::exists(file_of(name), failed)
        && QMessageBox::question(
               window_, tr("Save as template"),
               tr("There is a template “%1”. Replace it?").arg(elided(name, shown_template)))
               != QMessageBox::Yes)
        return;
    try {
        save(name);
    } catch (const Error& e) {
        messages_.fail(tr("The template was not kept. %1").arg(sentence(worded(e))));
    }
}

void Templates::save(const QString& name) {
    if (name.isEmpty() || name.startsWith(QChar('.')) || name.contains(QChar('/'))
        || name.contains(QChar('\\')))
        throw Error(ErrorCode::out_of_range, "name", "no file can be called so",
                    "write a name without slashes");
    const std::string kept = template_text(document_.project());
    const std::filesystem::path target = file_of(name);
    FileWriting::own().start(
        *this,
        [kept, target] {
            std::error_code failed; // the file says it
            std::filesystem::create_directories(target.parent_path(), failed);
            OutputFile file(target);
            file.write(kept);
            file.commit();
        },
        [this, kept, name](const QString& wrong) {
            if (!wrong.isEmpty())
                return messages_.fail(tr("The template was not kept. %1").arg(sentence(wrong)));
            messages_.information(
                tr("Kept as template “%1”: %2.")
                    .arg(elided(name, shown_template), worded(template_summary(kept, utf8(name)))));
        });
}

void Templates::apply(const std::filesystem::path& file) {
    if (!document_.has_part()) return;
    const QString name = elided(path_text(file.stem()), shown_template);
    try {
        const InputFile kept(file);
        AppliedTemplate applied = apply_template(kept.bytes(), file.filename().string(), document_.project());
        document_.replace_operations(tr("Apply template"), std::move(applied.project));
        for (const std::string& remark : applied.remarks)
            messages_.warning(worded(remark), false);
        const QString what =
            tr("“%1” applied: %2").arg(name, worded(template_summary(kept.bytes(), utf8(name))));
        if (applied.remarks.empty())
            messages_.information(what + QChar('.'));
        else if (applied.remarks.size() == 1)
            messages_.warning(what + tr("; it does not fit in one place. ")
                              + worded(applied.remarks.front()));
        else
            messages_.warning(
                what + tr("; it does not fit in %1 places, which the log has. ").arg(applied.remarks.size())
                + worded(applied.remarks.front()));
    } catch (const Error& e) {
        messages_.fail(tr("The template cannot be applied: %1").arg(worded(e)));
    }
}

void Templates::apply_with_dialog() {
    const QString path = QFileDialog::getOpenFileName(window_, tr("Apply template"), settings::last_folder(),
                                                      tr("Templates (*%1)").arg(QString::fromLatin1(ending)));
    if (!path.isEmpty()) apply(path_of(path));
}

} // namespace facetmill::ui
