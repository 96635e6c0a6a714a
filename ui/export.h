// Files that the workbench writes beside projects and programs. Whole or not at all.
#pragma once

#include <QImage>
#include <QString>

#include <string_view>

namespace facetmill::ui {

/// What went wrong, for the user; empty: the file is written.
[[nodiscard]] QString write_picture(const QString& path, const QImage& picture);
[[nodiscard]] QString write_table(const QString& path, std::string_view lines);

} // namespace facetmill::ui
