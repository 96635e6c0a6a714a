// Files that the workbench writes beside projects and programs: whole or not at all, and never over what the
// document was read from.
#pragma once

#include <QString>

#include <filesystem>
#include <functional>

class QWidget;

namespace facetmill {
struct OpenedProgram;
struct Project;
} // namespace facetmill

namespace facetmill::ui {

class Document;

/// Throws Error(unwritable) where `output` is the project's file, one that the project names or one of the
/// program that is shown, by whatever name. `program` may be null.
void keep_files(const Project& project, const OpenedProgram* program, const std::filesystem::path& output);
void keep_files(const Document& document, const std::filesystem::path& output);
/// The same for the program alone: a project may be saved over itself.
void keep_program(const Document& document, const std::filesystem::path& output);

/// mesh, deviation: of any format of mesh_file_kinds; without an ending STL, and PLY, which holds figures.
enum class ExportFormat { picture, table, web_page, mesh, deviation };

/// Asks for a file, beginning with a name without folder and extension, and has it written; nothing when the
/// user gives up.
void export_file(QWidget* window, const QString& title, ExportFormat format, const QString& name,
                 const std::function<void(const QString& path)>& write);

} // namespace facetmill::ui
