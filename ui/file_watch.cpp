#include "ui/file_watch.h"

#include "ui/text.h"

#include <QFileInfo>

namespace facetmill::ui {

namespace {

constexpr int quiet_ms = 300;

} // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
    quiet_.setSingleShot(true);
    quiet_.setInterval(quiet_ms);
    for (const auto signal : {&QFileSystemWatcher::fileChanged, &QFileSystemWatcher::directoryChanged})
        connect(&watcher_, signal, &quiet_, qOverload<>(&QTimer::start));
    connect(&quiet_, &QTimer::timeout, this, &FileWatch::settled);
}

void FileWatch::watch(const std::vector<std::filesystem::path>& files) {
    QStringList wanted;
    for (const std::filesystem::path& file : files) {
        wanted << path_text(file);
        wanted << path_text(file.parent_path()); // a file that is replaced, or comes back
    }
    const QStringList watched = watcher_.files() + watcher_.directories();
    for (const QString& path : watched)
        if (!wanted.contains(path)) watcher_.removePath(path);
    for (const QString& path : wanted)
        if (!watched.contains(path) && QFileInfo::exists(path)) watcher_.addPath(path);
}

} // namespace facetmill::ui
