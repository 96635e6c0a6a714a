// Work that is not saved, in files that outlive a program that was killed: the project as it stood, beside
// its own file ("job.autosave-1a2b3c4d.facetmill") or, where that is none or its folder may not be written
// to, in the user's data folder; there as well a record of what it is the state of, and a file that is locked
// as long as its window lives. No widgets.
#pragma once

#include "core/base/file_lock.h"
#include "core/job/project.h"

#include <QDateTime>
#include <QString>

#include <filesystem>
#include <memory>
#include <vector>

namespace facetmill::ui {

class KeptWork {
public:
    ~KeptWork();
    KeptWork(const KeptWork&) = delete;
    KeptWork& operator=(const KeptWork&) = delete;

    /// A place that no window has. Throws Error(unwritable).
    static std::unique_ptr<KeptWork> make();
    /// What windows left that did not end in order, newest first. Each is this caller's, and nobody else's,
    /// as long as it lives; what holds nothing any more is removed.
    static std::vector<std::unique_ptr<KeptWork>> abandoned();

    /// Keeps the project, which `name` calls where it has no path, in place of what was kept before. Throws
    /// Error(unwritable), and what was kept before is still there then.
    void write(const Project& project, const QString& name);
    /// The project as it was kept, with the path of its own file. Throws Error.
    Project read() const;
    /// There is nothing to keep any more.
    void remove() noexcept;

    /// Where it is kept; empty: nowhere.
    std::filesystem::path file() const;
    QDateTime when() const;
    /// The project's own file, which need not be there; empty: it never had one.
    const std::filesystem::path& project() const { return project_; }
    const QString& name() const { return name_; }

private:
    KeptWork(QString id, detail::FileLock lock) : id_(std::move(id)), lock_(std::move(lock)) {}

    std::filesystem::path in_data_folder(const char* ending) const;
    std::filesystem::path beside_project() const;
    bool read_record();
    void write_record() const;

    QString id_, name_;
    std::filesystem::path project_;
    detail::FileLock lock_;
    bool recorded_ = false;
};

} // namespace facetmill::ui
