#include "core/base/file.h"

#include <cerrno>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace facetmill {

namespace fs = std::filesystem;

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
        throw Error(ErrorCode::unreadable, name, "reading stopped before the end of the file", "check the disk");
    bytes_ = {buffer_.data(), buffer_.size()};
}

InputFile::~InputFile() {
    if (map_) ::munmap(map_, map_size_);
}

OutputFile::OutputFile(fs::path target) : target_(std::move(target)) {
    std::error_code ec;
    if (fs::is_directory(target_, ec))
        throw Error(ErrorCode::unwritable, printable(target_.string(), 400), "is a folder", "name a file");
    std::string pattern = (target_.parent_path() / ("." + target_.filename().string() + ".XXXXXX")).string();
    const int fd = ::mkstemp(pattern.data());
    if (fd < 0) fail(std::strerror(errno));
    temporary_ = pattern;
    ::fchmod(fd, 0644);
    file_ = ::fdopen(fd, "wb");
    if (!file_) {
        ::close(fd);
        fs::remove(temporary_, ec);
        fail("no stream");
    }
}

OutputFile::~OutputFile() {
    if (file_) std::fclose(file_);
    if (!committed_) {
        std::error_code ec;
        fs::remove(temporary_, ec);
    }
}

void OutputFile::fail(const std::string& what) const {
    throw Error(ErrorCode::unwritable, printable(target_.string(), 400), "cannot write the file: " + what,
                "check the folder, its permissions and the free space");
}

void OutputFile::write(std::string_view bytes) {
    if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
        fail(std::strerror(errno));
}

void OutputFile::close_stream() {
    if (!file_) return;
    std::FILE* f = file_;
    file_ = nullptr;
    if (std::fclose(f) != 0) fail(std::strerror(errno));
}

void OutputFile::commit() {
    close_stream();
    std::error_code ec;
    fs::rename(temporary_, target_, ec);
    if (ec) fail(ec.message());
    committed_ = true;
}

OutputFile& OutputSet::add(const fs::path& target) {
    files_.push_back(std::make_unique<OutputFile>(target));
    return *files_.back();
}

void OutputSet::commit() {
    for (auto& f : files_)
        f->close_stream();
    for (auto& f : files_)
        f->commit();
}

} // namespace facetmill
