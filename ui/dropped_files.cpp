#include "ui/dropped_files.h"

#include "core/mesh/mesh_format.h"
#include "core/output/apt.h"
#include "ui/text.h"

#include <QFileInfo>
#include <QImageReader>
#include <QMimeData>
#include <QUrl>

namespace facetmill::ui {

namespace {

QString ending(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    return suffix.isEmpty() ? suffix : QLatin1Char('.') + suffix;
}

bool is_mesh(const QString& path) {
    return mesh_format_of(ending(path).toStdString()) != nullptr;
}

bool is_program(const QString& path) {
    return program_endings().contains(ending(path));
}

/// Why a single file cannot be opened; empty where it may be one that can.
QString wrong_with(const QString& path) {
    const QFileInfo info(path);
    const QString name = elided(info.fileName(), 40);
    if (info.isDir())
        return QObject::tr("“%1” is a folder: drop a project, or a mesh (%2).")
            .arg(name, text(mesh_format_names(", ")));
    if (is_mesh(path) || is_project_file(path)) return {};
    if (!QImageReader::imageFormat(path).isEmpty())
        return QObject::tr(
                   "“%1” is a picture of a kind that is not read as a relief: save it as PNG or TIFF, "
                   "8 or 16 bits of grey.")
            .arg(name);
    return {};
}

} // namespace

QStringList local_files(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (!url.isLocalFile()) return {};
        paths << url.toLocalFile();
    }
    return paths;
}

bool is_project_file(const QString& path) {
    return ending(path) == QLatin1String(".facetmill");
}

QStringList program_endings() {
    return {text(apt_writer().extension), QStringLiteral(".cl"), QStringLiteral(".cls"),
            QStringLiteral(".ncl")};
}

DroppedFiles sort_dropped(const QStringList& paths, bool has_part) {
    DroppedFiles dropped;
    if (paths.isEmpty()) return dropped;
    if (std::all_of(paths.begin(), paths.end(), is_program)) {
        if (has_part)
            dropped.programs = paths;
        else
            dropped.refusal = QObject::tr("A program is shown over its part: open the project or the mesh "
                                          "first, then drop the program.");
        return dropped;
    }
    if (paths.size() == 1) {
        dropped.refusal = wrong_with(paths.front());
        if (dropped.refusal.isEmpty()) dropped.open = paths.front();
        return dropped;
    }
    QStringList projects;
    bool others_are_meshes = true;
    for (const QString& path : paths) {
        if (is_project_file(path))
            projects << path;
        else
            others_are_meshes = others_are_meshes && is_mesh(path);
    }
    QStringList names;
    for (const QString& path : paths)
        names << QStringLiteral("“%1”").arg(elided(QFileInfo(path).fileName(), 30));
    if (projects.size() == 1 && others_are_meshes)
        dropped.open = projects.front();
    else
        dropped.refusal = QObject::tr("Dropped were %1; there is one part at a time. Drop the part alone: "
                                      "stock and fixtures are chosen in the project.")
                              .arg(some_of(names));
    return dropped;
}

} // namespace facetmill::ui
