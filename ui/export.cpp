#include "ui/export.h"

#include "core/base/file.h"
#include "core/mesh/mesh_writer.h"
#include "ui/document.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QBuffer>
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

void keep_files(const Document& document, const std::filesystem::path& output) {
    keep_inputs(document.project(), output);
    keep_program(document, output);
}

void keep_program(const Document& document, const std::filesystem::path& output) {
    if (const auto& program = document.program())
        for (const std::filesystem::path& file : program->files)
            refuse_to_overwrite(file, output);
}

void export_file(QWidget* window, const QString& title, ExportFormat format, const QString& name,
                 const std::function<void(const QString& path)>& write) {
    const QString path = ask(window, title, format, name);
    if (!path.isEmpty()) write(path);
}

QString write_picture(const Document& document, const QString& path, const QImage& picture) {
    // In memory first: Qt's writer of pictures does not say that the disk was full.
    QByteArray png;
    QBuffer buffer(&png);
    if (picture.isNull() || !buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG"))
        return QObject::tr("%1: there is no picture to write").arg(path);
    return write_table(document, path, {png.constData(), std::size_t(png.size())});
}

QString write_table(const Document& document, const QString& path, std::string_view lines) {
    try {
        keep_files(document, path_of(path));
        OutputFile file(path_of(path));
        file.write(lines);
        file.commit();
    } catch (const Error& e) {
        return worded(e);
    }
    return {};
}

} // namespace facetmill::ui
