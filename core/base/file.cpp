#include "core/base/file.h"

#include "core/base/leftovers.h"
#include "core/base/text.h"

#include <algorithm>
#include <cerrno>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

/// What the system says of an error number; strerror may not be called by two threads at once.
std::string system_text(int number) {
    return std::generic_category().message(number);
}

/// Temporary files that exist now. The mutex is held while one is made, removed or renamed, so that
/// abandon_outputs finds either all of it or nothing.
struct Temporaries {
    std::recursive_mutex mutex; ///< recursive: a set commits files
    std::vector<fs::path> paths, folders;
    std::size_t committed = 0; ///< outputs that stand in their places
};

Temporaries& temporaries() {
    static auto* all = new Temporaries; // outlives every thread
    return *all;
}

using TemporariesLock = std::unique_lock<std::recursive_mutex>;

/// The files that were read since the first InputsKept began.
struct Inputs {
    std::mutex mutex;
    int keepers = 0;
    std::vector<std::pair<dev_t, ino_t>> files;
};

Inputs& inputs() {
    static auto* all = new Inputs;
    return *all;
}

void remember_input(const struct ::stat& info) {
    Inputs& all = inputs();
    const std::lock_guard lock(all.mutex);
    if (all.keepers > 0) all.files.emplace_back(info.st_dev, info.st_ino);
}

[[noreturn]] void refuse_input(const fs::path& output) {
    throw Error(ErrorCode::unwritable, printable(output.string(), 400), "is a file that the job reads",
                "write to another file or folder");
}

void refuse_inputs(const fs::path& output) {
    struct ::stat info {};
    if (::stat(output.c_str(), &info) != 0) return;
    Inputs& all = inputs();
    const std::lock_guard lock(all.mutex);
    const std::pair<dev_t, ino_t> file(info.st_dev, info.st_ino);
    if (std::find(all.files.begin(), all.files.end(), file) != all.files.end()) refuse_input(output);
}

/// Where a chain of links ends, whether or not something stands there; the path itself where it is too long.
fs::path end_of_links(const fs::path& path) {
    constexpr int longest_chain = 40;
    fs::path end = path;
    std::error_code ec;
    for (int i = 0; i < longest_chain; ++i) {
        if (!fs::is_symlink(fs::symlink_status(end, ec))) return end;
        const fs::path to = fs::read_symlink(end, ec);
        if (ec) break;
        end = to.is_absolute() ? to : end.parent_path() / to;
    }
    return path;
}

/// The new file gets the permissions of the one it is to replace; those of its group only if it gets the
/// group.
void hand_on_permissions(int fd, const struct ::stat& old) {
    constexpr mode_t everything = 0777, of_group = 0070;
    mode_t mode = old.st_mode & everything;
    struct ::stat made {};
    if (::fstat(fd, &made) != 0) return;
    if (made.st_uid != old.st_uid && ::fchown(fd, old.st_uid, gid_t(-1)) != 0) errno = 0;
    if (made.st_gid != old.st_gid && ::fchown(fd, uid_t(-1), old.st_gid) != 0) mode &= ~of_group;
    ::fchmod(fd, mode);
}

} // namespace

std::size_t committed_outputs() {
    TemporariesLock lock(temporaries().mutex);
    return temporaries().committed;
}

bool abandon_outputs(std::size_t before) {
    TemporariesLock lock(temporaries().mutex);
    if (temporaries().committed > before) return false;
    std::error_code ec;
    for (const fs::path& p : temporaries().paths)
        fs::remove(p, ec);
    for (const fs::path& p : temporaries().folders)
        fs::remove_all(p, ec);
    lock.release(); // stays locked
    return true;
}

InputFile::InputFile(const fs::path& path) : path_(path) {
    const std::string name = printable(path.string(), 400);
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) {
        if (errno == ENOENT || errno == ENOTDIR)
            throw Error(ErrorCode::not_found, name, "no such file", "check the path");
        throw Error(ErrorCode::unreadable, name, "cannot open the file: " + system_text(errno),
                    "check its permissions");
    }
    struct ::stat info {};
    if (::fstat(fd, &info) != 0) info.st_mode = 0;
    if (!S_ISREG(info.st_mode)) {
        ::close(fd);
        if (S_ISDIR(info.st_mode))
            throw Error(ErrorCode::is_directory, name, "is a folder, not a file", "name a file in it");
        throw Error(ErrorCode::unreadable, name, "is not a regular file", "name a file on disk");
    }
    if (info.st_size == 0) {
        ::close(fd);
        throw Error(ErrorCode::empty_file, name, "the file is empty", "export or copy it again");
    }
    remember_input(info);
    map_size_ = std::size_t(info.st_size);
    map_ = ::mmap(nullptr, map_size_, PROT_READ, MAP_PRIVATE, fd, 0);
    if (map_ != MAP_FAILED) {
        ::madvise(map_, map_size_, MADV_SEQUENTIAL);
        ::close(fd);
        bytes_ = {static_cast<const char*>(map_), map_size_};
        return;
    }
    map_ = nullptr;
    buffer_.resize(map_size_);
    std::size_t got = 0;
    while (got < buffer_.size()) {
        const ssize_t n = ::read(fd, buffer_.data() + got, buffer_.size() - got);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) break;
        got += std::size_t(n);
    }
    ::close(fd);
    if (got != buffer_.size())
        throw Error(ErrorCode::unreadable, name, "reading stopped before the end of the file",
                    "check the disk");
    bytes_ = {buffer_.data(), buffer_.size()};
}

InputFile::~InputFile() {
    if (map_) ::munmap(map_, map_size_);
}

OutputFile::OutputFile(fs::path target) : OutputFile(std::move(target), true) {}

OutputFile::OutputFile(fs::path target, bool clear_folder) : target_(std::move(target)) {
    std::error_code ec;
    const std::string name = printable(target_.string(), 400);
    const fs::file_status status = fs::status(target_, ec);
    if (fs::is_directory(status) || !target_.has_filename())
        throw Error(ErrorCode::unwritable, name, "is a folder", "name a file");
    // A rename would replace a device or a pipe by a plain file.
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error(ErrorCode::unwritable, name, "is not a regular file", "name a file on disk");
    target_ = end_of_links(target_);
    if (fs::is_symlink(fs::symlink_status(target_, ec))) fail(system_text(ELOOP));
    refuse_inputs(target_);
    struct ::stat old {};
    const bool replaces = ::stat(target_.c_str(), &old) == 0;
    if (replaces && ::access(target_.c_str(), W_OK) != 0) fail(system_text(errno));
    TemporariesLock lock(temporaries().mutex);
    if (clear_folder) detail::clear_leftovers(target_.parent_path());
    constexpr mode_t mine = 0600, everyones = 0666; // less what the process's umask takes away
    // The name does not repeat the target's, which may be as long as the file system allows.
    const int fd = detail::make_beside(target_.parent_path(), "", replaces ? mine : everyones, temporary_);
    if (fd < 0) fail(system_text(errno));
    temporaries().paths.push_back(temporary_);
    if (replaces) hand_on_permissions(fd, old);
    lock_ = ::fcntl(fd, F_DUPFD_CLOEXEC, 0);
    file_ = lock_ < 0 ? nullptr : ::fdopen(fd, "wb");
    if (!file_) {
        ::close(fd);
        if (lock_ >= 0) ::close(lock_);
        forget();
        fs::remove(temporary_, ec);
        fail("no stream");
    }
}

OutputFile::~OutputFile() {
    if (file_) std::fclose(file_);
    if (!committed_) {
        TemporariesLock lock(temporaries().mutex);
        std::error_code ec;
        fs::remove(temporary_, ec);
        forget();
    }
    ::close(lock_);
}

void OutputFile::forget() {
    std::erase(temporaries().paths, temporary_);
}

void OutputFile::fail(const std::string& what) const {
    throw Error(ErrorCode::unwritable, printable(target_.string(), 400), "cannot write the file: " + what,
                "check the folder, its permissions and the free space");
}

void OutputFile::write(std::string_view bytes) {
    if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
        fail(system_text(errno));
}

void OutputFile::overwrite(std::size_t at, std::string_view bytes) {
    if (::fseeko(file_, off_t(at), SEEK_SET) != 0) fail(system_text(errno));
    write(bytes);
    if (::fseeko(file_, 0, SEEK_END) != 0) fail(system_text(errno));
}

void OutputFile::close_stream() {
    if (!file_) return;
    std::FILE* f = file_;
    file_ = nullptr;
    if (std::fclose(f) != 0) fail(system_text(errno));
}

void OutputFile::sync() {
    if (::fsync(lock_) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT)) fail(system_text(errno));
}

void OutputFile::take_place() {
    refuse_inputs(target_);
    std::error_code ec;
    fs::rename(temporary_, target_, ec);
    if (ec) fail(ec.message());
    committed_ = true;
    ++temporaries().committed;
    forget();
}

void OutputFile::commit() {
    close_stream();
    sync();
    TemporariesLock lock(temporaries().mutex);
    take_place();
    detail::sync_folder(target_.parent_path());
}

OutputFile& OutputSet::add(const fs::path& target) {
    const fs::path folder = end_of_links(target).parent_path();
    const bool known = std::any_of(files_.begin(), files_.end(),
                                   [&](const auto& f) { return f->target().parent_path() == folder; });
    auto file = std::unique_ptr<OutputFile>(new OutputFile(target, !known));
    for (const auto& f : files_)
        if (f->target() == file->target()) file->fail("the job writes it twice");
    files_.push_back(std::move(file));
    return *files_.back();
}

/// What stood at the targets, until all of them are replaced.
class OutputSet::Replacement {
public:
    explicit Replacement(std::vector<std::unique_ptr<OutputFile>>& files) {
        for (auto& f : files)
            folders_[f->target_.parent_path()].files.push_back(f.get());
    }
    ~Replacement() {
        // Inner folders first: a run killed here leaves in the outermost, where the next one looks, all or
        // none.
        for (auto it = folders_.rbegin(); it != folders_.rend(); ++it) {
            auto& [path, folder] = *it;
            std::error_code ec;
            if (!done_) detail::put_back(path, folder.set);
            fs::remove(folder.record, ec);
            if (folder.lock >= 0) ::close(folder.lock);
        }
        if (!done_) return;
        for (auto& [path, folder] : folders_) {
            std::error_code ec;
            for (const detail::Replaced& r : folder.set)
                if (!r.before.empty()) fs::remove(path / r.before, ec);
            detail::sync_folder(path);
        }
    }
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    void run() {
        for (auto& [path, folder] : folders_)
            write_record(path, folder);
        for (auto& [path, folder] : folders_)
            for (std::size_t i = 0; i < folder.files.size(); ++i)
                replace(*folder.files[i], path / folder.set[i].before, !folder.set[i].before.empty());
        for (auto& [path, folder] : folders_)
            detail::sync_folder(path);
        done_ = true;
    }

private:
    struct Folder {
        std::vector<OutputFile*> files;
        std::vector<detail::Replaced> set;
        fs::path record;
        int lock = -1; ///< of the record
    };

    static void write_record(const fs::path& path, Folder& folder) {
        for (const OutputFile* f : folder.files) {
            struct ::stat info {};
            std::error_code ec;
            if (::stat(f->temporary_.c_str(), &info) != 0) f->fail(system_text(errno));
            if (fs::is_directory(f->target_, ec)) f->fail("a folder appeared in its place");
            std::string before;
            if (fs::exists(f->target_, ec)) before = f->temporary_.filename().string() + ".before";
            folder.set.push_back({f->target_.filename().string(), before, info.st_ino});
        }
        const std::string bytes = detail::set_record(folder.set);
        folder.lock = detail::make_beside(path, ".set", 0600, folder.record);
        const bool written = folder.lock >= 0
                             && ::write(folder.lock, bytes.data(), bytes.size()) == ssize_t(bytes.size())
                             && ::fsync(folder.lock) == 0;
        if (!written) folder.files.front()->fail(system_text(errno));
        detail::sync_folder(path);
    }

    static void replace(OutputFile& file, const fs::path& before, bool replaces) {
        std::error_code ec;
        if (replaces) {
            fs::create_hard_link(file.target_, before, ec);
            // File systems without hard links: the target is gone for a moment instead.
            if (ec) fs::rename(file.target_, before, ec);
            if (ec) file.fail(ec.message());
        }
        file.take_place();
    }

    std::map<fs::path, Folder> folders_;
    bool done_ = false;
};

void OutputSet::commit(const std::function<void()>& before) {
    for (auto& f : files_)
        f->close_stream();
    for (auto& f : files_)
        f->sync();
    if (before) before();
    if (files_.size() == 1) return files_.front()->commit();
    TemporariesLock lock(temporaries().mutex);
    const std::size_t committed_before = temporaries().committed;
    try {
        Replacement(files_).run();
    } catch (...) {
        temporaries().committed = committed_before;
        throw;
    }
}

InputsKept::InputsKept() {
    Inputs& all = inputs();
    const std::lock_guard lock(all.mutex);
    ++all.keepers;
}

InputsKept::~InputsKept() {
    Inputs& all = inputs();
    const std::lock_guard lock(all.mutex);
    if (--all.keepers == 0) all.files.clear();
}

namespace {

constexpr std::string_view folder_prefix = "facetmill-packed.";

/// The folder, locked; -1 where somebody else has it or it is gone.
int lock_folder(const fs::path& path) {
    const int fd = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (fd < 0) return -1;
    struct ::stat opened {
    }, named{};
    if (::flock(fd, LOCK_EX | LOCK_NB) == 0 && ::fstat(fd, &opened) == 0 && ::lstat(path.c_str(), &named) == 0
        && opened.st_ino == named.st_ino && opened.st_dev == named.st_dev && opened.st_uid == ::geteuid())
        return fd;
    ::close(fd);
    return -1;
}

/// Removes folders that killed runs of this user left.
void clear_folders(const fs::path& place) {
    std::error_code ec;
    for (fs::directory_iterator it(place, ec), end; !ec && it != end; it.increment(ec)) {
        if (!it->path().filename().string().starts_with(folder_prefix)) continue;
        const int fd = lock_folder(it->path());
        if (fd < 0) continue;
        std::error_code none;
        fs::remove_all(it->path(), none);
        ::close(fd);
    }
}

} // namespace

TemporaryFolder::TemporaryFolder(std::string stands_for) {
    std::error_code ec;
    const fs::path place = fs::temp_directory_path(ec);
    const auto fail = [&](const std::string& why) {
        throw Error(ErrorCode::unwritable, printable(ec ? "TMPDIR" : place.string(), 400),
                    "no temporary folder can be made: " + why,
                    "check the folder, its permissions and the free space, or name another one in TMPDIR");
    };
    if (ec) fail(ec.message());
    const TemporariesLock lock(temporaries().mutex);
    clear_folders(place);
    constexpr int attempts = 8; // another run may take one for left over before it is locked
    for (int i = 0; i < attempts && lock_ < 0; ++i) {
        std::string made = (place / (std::string(folder_prefix) + "XXXXXX")).string();
        if (!::mkdtemp(made.data())) fail(system_text(errno));
        path_ = made;
        lock_ = lock_folder(path_);
    }
    if (lock_ < 0) fail("it cannot be locked");
    temporaries().folders.push_back(path_);
    detail::show_as(path_.string(), std::move(stands_for));
}

TemporaryFolder::~TemporaryFolder() {
    const TemporariesLock lock(temporaries().mutex);
    std::error_code ec;
    fs::remove_all(path_, ec);
    std::erase(temporaries().folders, path_);
    detail::show_as(path_.string(), {});
    ::close(lock_);
}

std::unique_ptr<std::FILE, int (*)(std::FILE*)> TemporaryFolder::create(const fs::path& relative) const {
    // None appears once `abandon_outputs` has removed the folder.
    const TemporariesLock lock(temporaries().mutex);
    const fs::path file = path_ / relative;
    std::error_code ec;
    fs::create_directories(file.parent_path(), ec);
    constexpr mode_t mine = 0600;
    const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mine);
    std::FILE* const stream = fd < 0 ? nullptr : ::fdopen(fd, "wb");
    if (!stream)
        throw Error(ErrorCode::unwritable, printable(file.string(), 400),
                    "cannot be unpacked: " + system_text(errno), "check the free space of temporary files");
    return {stream, &std::fclose};
}

void refuse_to_overwrite(const std::filesystem::path& input, const std::filesystem::path& output) {
    std::error_code none; // a file that does not exist is no other's equal
    if (std::filesystem::equivalent(input, output, none)) refuse_input(output);
}

} // namespace facetmill
