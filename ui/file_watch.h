// Watches files, and says when they have changed: once a while has passed without another change, since a
// file that is being written changes many times.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <filesystem>
#include <vector>

namespace facetmill::ui {

class FileWatch : public QObject {
    Q_OBJECT
public:
    explicit FileWatch(QObject* parent = nullptr);

    /// These and their folders from now on, no others. A file that was replaced is only watched again once
    /// this is called.
    void watch(const std::vector<std::filesystem::path>& files);
    /// Says `settled` again after the same while.
    void wait_again() { quiet_.start(); }

signals:
    void settled();

private:
    QFileSystemWatcher watcher_;
    QTimer quiet_;
};

} // namespace facetmill::ui
