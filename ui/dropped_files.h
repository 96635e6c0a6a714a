// Files that were dropped on the window: which of them to open, or why none. No widgets.
#pragma once

#include <QString>
#include <QStringList>

class QMimeData;

namespace facetmill::ui {

/// One of the three says something.
struct DroppedFiles {
    QString open;         ///< a project or a mesh, or what only reading it tells
    QStringList programs; ///< CL files, to be shown in place of the plan
    QString refusal;      ///< a sentence for the user
};

/// `has_part`: whether there is a part over which programs can be shown. One project with meshes beside it is
/// the project, which names its meshes itself.
DroppedFiles sort_dropped(const QStringList& paths, bool has_part);

/// What is dragged, if it is files on this machine and nothing else.
QStringList local_files(const QMimeData& data);

/// Whether a file is a project by its name.
bool is_project_file(const QString& path);
/// Endings of CL files, with the dot, the usual one first.
QStringList program_endings();

} // namespace facetmill::ui
