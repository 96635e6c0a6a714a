#include "core/base/file_lock.h"

#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace facetmill::detail {

namespace fs = std::filesystem;

bool is_same_file(int fd, const fs::path& path) {
    struct ::stat open {
    }, named{};
    return ::fstat(fd, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev
           && open.st_ino == named.st_ino;
}

FileLock::FileLock(const fs::path& path, Open open) {
    constexpr int always = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
    constexpr mode_t own = 0600;
    fd_ = open == Open::existing ? ::open(path.c_str(), O_RDONLY | always)
                                 : ::open(path.c_str(), O_RDWR | O_CREAT | always, own);
    struct ::stat info {};
    // Another run may have removed it, or put another one there, before it was locked.
    const bool ours = fd_ >= 0 && ::fstat(fd_, &info) == 0 && S_ISREG(info.st_mode)
                      && info.st_uid == ::geteuid() && ::flock(fd_, LOCK_EX | LOCK_NB) == 0
                      && is_same_file(fd_, path);
    if (!ours) unlock();
}

FileLock::FileLock(FileLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
}

std::string FileLock::bytes() const {
    std::string all;
    char block[4096];
    for (ssize_t n = 0; (n = ::read(fd_, block, sizeof block)) > 0;)
        all.append(block, std::size_t(n));
    return all;
}

void FileLock::unlock() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
}

} // namespace facetmill::detail
