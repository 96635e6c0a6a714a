// Files that the workbench writes beside projects and programs: whole or not at all, and never over what the
// document was read from.
#pragma once

#include <QImage>
#include <QString>

#include <filesystem>
#include <functional>
#include <string_view>

class QWidget;

namespace facetmill::ui {

class Document;

/// Throws Error(unwritable) where `output` is the project's file, one that the project names or one of the
/// program that is shown, by whatever name.
void keep_files(const Document& document, const std::filesystem::path& output);
/// The same for the program alone: a project may be saved over itself.
void keep_program(const Document& document, const std::filesystem::path& output);

/// mesh, deviation: of any format of mesh_file_kinds; without an ending STL, and PLY, which holds figures.
enum class ExportFormat { picture, table, web_page, mesh, deviation };

/// Asks for a file, beginning with a name without folder and extension, and has it written; nothing when the
/// user gives up.
void export_file(QWidget* window, const QString& title, ExportFormat format, const QString& name,
                 const std::function<void(const QString& path)>& write);

/// What went wrong, for the user; empty: the file is written.
[[nodiscard]] QString write_picture(const Document& document, const QString& path, const QImage& picture);
[[nodiscard]] QString write_table(const Document& document, const QString& path, std::string_view lines);

} // namespace facetmill::ui
