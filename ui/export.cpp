#include "ui/export.h"

#include "core/base/file.h"
#include "core/mesh/mesh_writer.h"
#include "ui/document.h"
#include "ui/settings.h"
#include "ui/text.h"

#include <QFileDialog>
#include <QObject>

namespace facetmill::ui {

namespace {

QString mesh_filter() {
    QStringList endings;
    for (const MeshFileKind& kind : mesh_file_kinds())
        endings << QChar('*') + text(kind.extension);
    return QObject::tr("Meshes (%1)").arg(endings.join(QChar(' ')));
}

/// The file that the user names; empty: none.
QString ask(QWidget* window, const QString& title, ExportFormat format, QString name) {
    struct Format {
        QString filter, suffix;
    };
    const Format formats[] = {{QObject::tr("Pictures (*.png)"), QStringLiteral("png")},
                              {QObject::tr("Tables (*.csv)"), QStringLiteral("csv")},
                              {QObject::tr("Web pages (*.html)"), QStringLiteral("html")},
                              {mesh_filter(), QStringLiteral("stl")},
                              {mesh_filter(), QStringLiteral("ply")}};
    const auto& [filter, suffix] = formats[std::size_t(format)];
    QFileDialog dialog(window, title, settings::last_folder(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(name.replace(QChar('/'), QChar('-')) + QChar('.') + suffix);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
    return dialog.selectedFiles().front();
}

} // namespace

static void keep_program_files(const OpenedProgram* program, const std::filesystem::path& output) {
    if (!program) return;
    for (const std::filesystem::path& file : program->files)
        refuse_to_overwrite(file, output);
}

void keep_files(const Project& project, const OpenedProgram* program, const std::filesystem::path& output) {
    keep_inputs(project, output);
    keep_program_files(program, output);
}

void keep_files(const Document& document, const std::filesystem::path& output) {
    keep_files(document.project(), document.program().get(), output);
}

void keep_program(const Document& document, const std::filesystem::path& output) {
    keep_program_files(document.program().get(), output);
}

void export_file(QWidget* window, const QString& title, ExportFormat format, const QString& name,
                 const std::function<void(const QString& path)>& write) {
    const QString path = ask(window, title, format, name);
    if (!path.isEmpty()) write(path);
}

} // namespace facetmill::ui
