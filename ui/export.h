// Files that the workbench writes beside projects and programs. Whole or not at all.
#pragma once

#include <QImage>
#include <QString>

#include <string_view>

class QWidget;

namespace facetmill::ui {

enum class ExportFormat { picture, table, web_page };

/// Asks for the file to be written, beginning with a name without folder and extension; empty: none.
QString ask_export_file(QWidget* window, const QString& title, ExportFormat format, QString name);

/// What went wrong, for the user; empty: the file is written.
[[nodiscard]] QString write_picture(const QString& path, const QImage& picture);
[[nodiscard]] QString write_table(const QString& path, std::string_view lines);

} // namespace facetmill::ui
