// What the workbench remembers from one start to the next.
#pragma once

#include "core/base/units.h"
#include "ui/navigation.h"
#include "ui/theme.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <chrono>
#include <optional>
#include <string>

namespace facetmill::ui::settings {

/// Newest first, at most ten.
QStringList recent_files();
void add_recent_file(const QString& path);
void remove_recent_file(const QString& path);

/// The unit a mesh file is read in without asking, where the user said so.
std::optional<LengthUnit> remembered_unit(const QString& path);
void remember_unit(const QString& path, LengthUnit unit);

/// What new projects begin with. Empty names: what the program takes by itself; no unit: it asks.
struct UsualProject {
    std::string machine, post; ///< names, as projects have them
    std::optional<LengthUnit> unit;
    bool operator==(const UsualProject&) const = default;
};
UsualProject usual_project();
void set_usual_project(const UsualProject& usual);

Navigation navigation();
void set_navigation(const Navigation& navigation);
/// Once: the program was never started before.
bool take_first_start();
bool perspective();
void set_perspective(bool on);

/// Between the times at which unsaved work is kept; 30 s at first.
std::chrono::seconds autosave_interval();
void set_autosave_interval(std::chrono::seconds interval);
inline constexpr std::chrono::seconds shortest_autosave{5}, longest_autosave{3600};

/// That planning and verifying use; 0: as many as the machine has.
int threads();
void set_threads(int threads);
inline constexpr int max_threads = 1024;

/// Where libraries and templates are kept (own_folders.h); empty: where they usually are.
QString own_folder();
void set_own_folder(const QString& folder);

/// The code of a language (language.h); empty: as the system says.
QString language();
void set_language(const QString& code);

Theme theme();
void set_theme(Theme theme);

/// Folder of the last file dialog.
QString last_folder();
void set_last_folder(const QString& folder);

/// Names of the layers that are shown in a workspace; nothing before the first time.
std::optional<QStringList> shown_layers(const QString& workspace);
void set_shown_layers(const QString& workspace, const QStringList& names);
/// The layers that there were when they were kept; before the preview of passes these were not kept.
QStringList known_layers();
void set_known_layers(const QStringList& names);

QByteArray window_geometry();
QByteArray window_state();
void set_window(const QByteArray& geometry, const QByteArray& state);

} // namespace facetmill::ui::settings
