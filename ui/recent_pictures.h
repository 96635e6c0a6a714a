// Small pictures of what was worked on, for the list of recent files: in the user's cache, safe to delete.
#pragma once

#include "ui/document.h"

#include <QImage>
#include <QPixmap>
#include <QString>

#include <filesystem>
#include <utility>

namespace facetmill::ui {

/// Points; what a list shows them at.
inline constexpr int recent_picture_width = 144, recent_picture_height = 96;

/// Keeps the middle of a view as the picture of a file; those of files that are not recent any more go.
/// Written aside; where it cannot be written there is none.
void keep_recent_picture(const QString& path, const QImage& view);
/// Null where there is none.
QPixmap recent_picture(const QString& path);

class MainWindow;
class Viewport;

/// Keeps a picture whenever the window has come to rest with a part that was opened, or with paths that were
/// planned.
class RecentPictures : public QObject {
    Q_OBJECT
public:
    RecentPictures(const Document& document, Viewport& viewport, MainWindow& window);

private:
    void keep();

    const Document& document_;
    Viewport& viewport_;
    bool due_ = false;                            ///< part or plan have changed since it was looked
    std::pair<std::filesystem::path, bool> last_; ///< what it was of, and whether that was planned
};

} // namespace facetmill::ui
