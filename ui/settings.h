// What the workbench remembers from one start to the next.
#pragma once

#include "core/base/units.h"
#include "ui/theme.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>

namespace facetmill::ui::settings {

/// Newest first, at most ten.
QStringList recent_files();
void add_recent_file(const QString& path);
void remove_recent_file(const QString& path);

/// The unit a mesh file is read in without asking, where the user said so.
std::optional<LengthUnit> remembered_unit(const QString& path);
void remember_unit(const QString& path, LengthUnit unit);

Theme theme();
void set_theme(Theme theme);

/// Folder of the last file dialog.
QString last_folder();
void set_last_folder(const QString& folder);

/// Names of the layers that are shown; nothing before the first time.
std::optional<QStringList> shown_layers();
void set_shown_layers(const QStringList& names);

QByteArray window_geometry();
QByteArray window_state();
void set_window(const QByteArray& geometry, const QByteArray& state);

} // namespace facetmill::ui::settings
