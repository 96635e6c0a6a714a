// A lock on a file that goes with its process, however that ends: who finds the file without it knows that
// nobody lives who made it.
#pragma once

#include <filesystem>
#include <string>

namespace facetmill::detail {

/// A regular file of this user, locked (flock) as long as this lives. False: there is none, or somebody has
/// locked it, in this process or in another one.
class FileLock {
public:
    enum class Open { existing, or_make };

    explicit FileLock(const std::filesystem::path& path, Open open = Open::existing);
    ~FileLock() { unlock(); }
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;

    explicit operator bool() const { return fd_ >= 0; }
    std::string bytes() const;
    void unlock();

private:
    int fd_ = -1;
};

/// The open file is the one of that name.
bool is_same_file(int fd, const std::filesystem::path& path);

} // namespace facetmill::detail
