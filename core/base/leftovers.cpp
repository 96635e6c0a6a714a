#include "core/base/leftovers.h"

#include "core/base/file_lock.h"

#include <cerrno>
#include <charconv>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace facetmill::detail {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view beside = ".facetmill.", set_ending = ".set", before_ending = ".before";
constexpr std::size_t random_letters = 6;
constexpr std::string_view record_head = "facetmill set 1", record_end = "end";

std::string random_name() {
    static constexpr char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    unsigned char bytes[random_letters] = {};
    if (::getrandom(bytes, sizeof bytes, 0) != ssize_t(sizeof bytes)) return "000000";
    std::string name;
    for (const unsigned char b : bytes)
        name += letters[b % (sizeof letters - 1)];
    return name;
}

/// What stands after the letters of such a file's name: "", ".set", ".before"; none for any other file.
std::optional<std::string> ending_of(const std::string& name) {
    if (!name.starts_with(beside) || name.size() < beside.size() + random_letters) return std::nullopt;
    std::string ending = name.substr(beside.size() + random_letters);
    if (!ending.empty() && ending != set_ending && ending != before_ending) return std::nullopt;
    return ending;
}

std::vector<std::string> leftovers_in(const fs::path& folder, std::string_view ending) {
    std::vector<std::string> names;
    std::error_code ec;
    for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
        const std::string name = it->path().filename().string();
        if (ending_of(name) == ending) names.push_back(name);
    }
    return names;
}

void clear(const fs::path& folder) {
    std::error_code ec;
    // Seen before the records are: a second name whose record is not there any more belongs to nobody.
    const std::vector<std::string> second_names = leftovers_in(folder, before_ending);
    bool committing = false;
    for (const std::string& name : leftovers_in(folder, set_ending)) {
        const FileLock record(folder / name);
        if (!record) {
            committing = true;
            continue;
        }
        put_back(folder, read_set_record(record.bytes()));
        fs::remove(folder / name, ec);
    }
    for (const std::string& name : leftovers_in(folder, {}))
        if (const FileLock file(folder / name); file) fs::remove(folder / name, ec);
    if (committing) return;
    for (const std::string& name : second_names) {
        struct ::stat info {};
        if (::lstat((folder / name).c_str(), &info) == 0 && S_ISREG(info.st_mode)
            && info.st_uid == ::geteuid())
            fs::remove(folder / name, ec);
    }
}

} // namespace

int make_beside(const fs::path& folder, const std::string& ending, mode_t mode, fs::path& made) {
    constexpr int attempts = 100;
    for (int i = 0; i < attempts; ++i) {
        made = folder / (std::string(beside) + random_name() + ending);
        const int fd = ::open(made.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, mode);
        if (fd < 0) {
            if (errno == EEXIST) continue;
            return -1;
        }
        const bool locked = ::flock(fd, LOCK_EX | LOCK_NB) == 0;
        // Another run may have taken it for a leftover before it was locked.
        if ((locked || errno != EWOULDBLOCK) && is_same_file(fd, made)) return fd;
        ::close(fd);
    }
    errno = EEXIST;
    return -1;
}

std::string set_record(const std::vector<Replaced>& set) {
    std::string bytes;
    const auto add = [&](std::string_view field) {
        bytes += field;
        bytes += '\0';
    };
    add(record_head);
    for (const Replaced& r : set) {
        add(r.target);
        add(r.before);
        add(std::to_string(r.inode));
    }
    add(record_end);
    return bytes;
}

std::vector<Replaced> read_set_record(const std::string& bytes) {
    std::vector<std::string> fields;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = bytes.find('\0', at);
        if (end == std::string::npos) return {};
        fields.push_back(bytes.substr(at, end - at));
        at = end + 1;
    }
    if (fields.size() < 2 || fields.size() % 3 != 2 || fields.front() != record_head
        || fields.back() != record_end)
        return {};
    std::vector<Replaced> set;
    for (std::size_t i = 1; i + 1 < fields.size(); i += 3) {
        Replaced r{fields[i], fields[i + 1], 0};
        std::from_chars(fields[i + 2].data(), fields[i + 2].data() + fields[i + 2].size(), r.inode);
        // Of this folder only, whatever a record says.
        const auto plain = [](const std::string& name) {
            return name.find('/') == std::string::npos && name != "." && name != "..";
        };
        const bool own = r.before.empty() || ending_of(r.before) == before_ending;
        if (r.target.empty() || !plain(r.target) || !plain(r.before) || !own) return {};
        set.push_back(std::move(r));
    }
    return set;
}

void put_back(const fs::path& folder, const std::vector<Replaced>& set) {
    std::error_code ec;
    for (auto r = set.rbegin(); r != set.rend(); ++r) {
        const fs::path target = folder / r->target;
        struct ::stat info {};
        const bool there = ::lstat(target.c_str(), &info) == 0;
        const bool replaced = there && info.st_ino == r->inode;
        if (!r->before.empty()) {
            // Where nothing stands, the file system knows no second names and the file was moved away.
            if (replaced || !there)
                fs::rename(folder / r->before, target, ec);
            else
                fs::remove(folder / r->before, ec);
        } else if (replaced) {
            fs::remove(target, ec);
        }
    }
}

void clear_leftovers(const fs::path& folder) noexcept {
    try {
        clear(folder.empty() ? fs::path(".") : folder);
    } catch (const std::exception&) {
        return; // they stay for the run after this one
    }
}

void sync_folder(const fs::path& folder) noexcept {
    const int fd = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) return;
    ::fsync(fd);
    ::close(fd);
}

} // namespace facetmill::detail
