#include "core/base/file.h"

#include <cerrno>
#include <cstring>
#include <mutex>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

/// Temporary files that exist now. The mutex is held while one is made, removed or renamed, so that
/// abandon_outputs finds either all of it or nothing.
struct Temporaries {
    std::recursive_mutex mutex; ///< recursive: a set commits files
    std::vector<fs::path> paths;
    std::size_t committed = 0; ///< outputs that stand in their places
};

Temporaries& temporaries() {
    static auto* all = new Temporaries; // outlives every thread
    return *all;
}

using TemporariesLock = std::unique_lock<std::recursive_mutex>;

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
    lock.release(); // stays locked
    return true;
}

InputFile::InputFile(const fs::path& path) : path_(path) {
    const std::string name = printable(path.string(), 400);
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) {
        if (errno == ENOENT || errno == ENOTDIR)
            throw Error(ErrorCode::not_found, name, "no such file", "check the path");
        throw Error(ErrorCode::unreadable, name, std::string("cannot open the file: ") + std::strerror(errno),
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

OutputFile::OutputFile(fs::path target) : target_(std::move(target)) {
    std::error_code ec;
    const std::string name = printable(target_.string(), 400);
    const fs::file_status status = fs::status(target_, ec);
    if (fs::is_directory(status) || !target_.has_filename())
        throw Error(ErrorCode::unwritable, name, "is a folder", "name a file");
    // A rename would replace a device or a pipe by a plain file.
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error(ErrorCode::unwritable, name, "is not a regular file", "name a file on disk");
    if (fs::is_symlink(fs::symlink_status(target_, ec))) {
        const fs::path real = fs::weakly_canonical(target_, ec);
        if (!ec) target_ = real;
    }
    // The name does not repeat the target's, which may be as long as the file system allows.
    std::string pattern = (target_.parent_path() / ".facetmill.XXXXXX").string();
    TemporariesLock lock(temporaries().mutex);
    const int fd = ::mkstemp(pattern.data());
    if (fd < 0) fail(std::strerror(errno));
    temporary_ = pattern;
    temporaries().paths.push_back(temporary_);
    ::fchmod(fd, 0644);
    file_ = ::fdopen(fd, "wb");
    if (!file_) {
        ::close(fd);
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
        fail(std::strerror(errno));
}

void OutputFile::overwrite(std::size_t at, std::string_view bytes) {
    if (::fseeko(file_, off_t(at), SEEK_SET) != 0) fail(std::strerror(errno));
    write(bytes);
    if (::fseeko(file_, 0, SEEK_END) != 0) fail(std::strerror(errno));
}

void OutputFile::close_stream() {
    if (!file_) return;
    std::FILE* f = file_;
    file_ = nullptr;
    if (std::fclose(f) != 0) fail(std::strerror(errno));
}

void OutputFile::commit() {
    close_stream();
    TemporariesLock lock(temporaries().mutex);
    std::error_code ec;
    fs::rename(temporary_, target_, ec);
    if (ec) fail(ec.message());
    committed_ = true;
    ++temporaries().committed;
    forget();
}

OutputFile& OutputSet::add(const fs::path& target) {
    auto file = std::make_unique<OutputFile>(target);
    for (const auto& f : files_)
        if (f->target() == file->target()) file->fail("the job writes it twice");
    files_.push_back(std::move(file));
    return *files_.back();
}

void OutputSet::commit() {
    for (auto& f : files_)
        f->close_stream();
    TemporariesLock lock(temporaries().mutex);
    const std::size_t committed_before = temporaries().committed;
    // What stands at a target keeps a second name until all renames are done.
    struct Kept {
        OutputFile* file;
        fs::path before; // empty: nothing stood there
    };
    std::vector<Kept> kept;
    std::error_code ec;
    const auto put_back = [&] {
        for (auto k = kept.rbegin(); k != kept.rend(); ++k) {
            if (k->before.empty()) {
                if (k->file->committed_) fs::remove(k->file->target_, ec);
            } else {
                fs::rename(k->before, k->file->target_, ec);
                fs::remove(k->before, ec); // still there when both names were the same file
            }
        }
    };
    try {
        for (auto& f : files_) {
            fs::path before;
            if (fs::is_directory(f->target_, ec)) f->fail("a folder appeared in its place");
            if (fs::exists(f->target_, ec)) {
                before = f->temporary_;
                before += ".before";
                fs::create_hard_link(f->target_, before, ec);
                // File systems without hard links: the target is gone for a moment instead.
                if (ec) fs::rename(f->target_, before, ec);
                if (ec) f->fail(ec.message());
            }
            kept.push_back({f.get(), before});
            f->commit();
        }
    } catch (...) {
        put_back();
        temporaries().committed = committed_before;
        throw;
    }
    for (const Kept& k : kept)
        if (!k.before.empty()) fs::remove(k.before, ec);
}

void refuse_to_overwrite(const std::filesystem::path& input, const std::filesystem::path& output) {
    std::error_code none; // a file that does not exist is no other's equal
    if (std::filesystem::equivalent(input, output, none))
        throw Error(ErrorCode::unwritable, printable(output.string(), 400), "is the file that is read",
                    "write to another file");
}

} // namespace facetmill
