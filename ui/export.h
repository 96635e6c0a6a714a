// Files that the workbench writes beside projects and programs. Whole or not at all.
#pragma once

#include <QImage>
#include <QString>

#include <functional>
#include <string_view>

class QWidget;

namespace facetmill::ui {

enum class ExportFormat { picture, table, web_page };

/// Asks for a file, beginning with a name without folder and extension, and has it written; nothing when the
/// user gives up.
void export_file(QWidget* window, const QString& title, ExportFormat format, const QString& name,
                 const std::function<void(const QString& path)>& write);

/// What went wrong, for the user; empty: the file is written.
[[nodiscard]] QString write_picture(const QString& path, const QImage& picture);
[[nodiscard]] QString write_table(const QString& path, std::string_view lines);

} // namespace facetmill::ui
