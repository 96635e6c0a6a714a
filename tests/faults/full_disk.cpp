// A disk without room, as attack_files sets it before a program (LD_PRELOAD): of all that needs room in the
// folder FACETMILL_FULL_FOLDER, what a program writes, makes, links, renames or has taken to the disk, the
// FACETMILL_FULL_AT-th fails with ENOSPC, and with FACETMILL_FULL_STAYS everything after it. That one did is
// told by a file FACETMILL_FULL_TOLD.
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

struct Asked {
    const char* folder = std::getenv("FACETMILL_FULL_FOLDER");
    const char* told = std::getenv("FACETMILL_FULL_TOLD");
    const char* at_text = std::getenv("FACETMILL_FULL_AT");
    long at = at_text ? std::atol(at_text) : 0;
    bool stays = std::getenv("FACETMILL_FULL_STAYS") != nullptr;
};

const Asked& asked() {
    static const Asked a;
    return a;
}

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool inside(const char* path) {
    if (!asked().folder || !path) return false;
    char whole[PATH_MAX + 1];
    if (path[0] != '/') {
        if (!::getcwd(whole, sizeof whole)) return false;
        if (std::strlen(whole) + std::strlen(path) + 2 > sizeof whole) return false;
        std::strcat(std::strcat(whole, "/"), path);
        path = whole;
    }
    const std::size_t n = std::strlen(asked().folder);
    return std::strncmp(path, asked().folder, n) == 0 && (path[n] == '/' || path[n] == '\0');
}

bool inside(int fd) {
    char link[64], path[PATH_MAX + 1];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    const ssize_t n = ::readlink(link, path, PATH_MAX);
    if (n < 0) return false;
    path[n] = '\0';
    return inside(path);
}

/// Whether there is no room for this one, which has then been told; sets errno.
template <class Where>
bool full(Where where) {
    static std::atomic<long> count = 0;
    if (asked().at <= 0 || !inside(where)) return false;
    const long n = ++count;
    if (n < asked().at || (n > asked().at && !asked().stays)) return false;
    if (n == asked().at && asked().told) {
        static auto* const open_next = next<int(const char*, int, ...)>("open");
        const int fd = open_next(asked().told, O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
        if (fd >= 0) ::close(fd);
    }
    errno = ENOSPC;
    return true;
}

mode_t mode_of(int flags, va_list rest) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? mode_t(va_arg(rest, int)) : 0;
}

} // namespace

#define FACETMILL_NEXT(name) static auto* const real = next<decltype(name)>(#name)

extern "C" {

int open(const char* path, int flags, ...) {
    FACETMILL_NEXT(open);
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return (flags & O_CREAT) != 0 && full(path) ? -1 : real(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    FACETMILL_NEXT(open64);
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return (flags & O_CREAT) != 0 && full(path) ? -1 : real(path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
    FACETMILL_NEXT(fopen);
    return mode[0] != 'r' && full(path) ? nullptr : real(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
    FACETMILL_NEXT(fopen64);
    return mode[0] != 'r' && full(path) ? nullptr : real(path, mode);
}

int mkdir(const char* path, mode_t mode) {
    FACETMILL_NEXT(mkdir);
    return full(path) ? -1 : real(path, mode);
}

int link(const char* from, const char* to) {
    FACETMILL_NEXT(link);
    return full(to) ? -1 : real(from, to);
}

int rename(const char* from, const char* to) {
    FACETMILL_NEXT(rename);
    return full(to) ? -1 : real(from, to);
}

ssize_t write(int fd, const void* data, size_t size) {
    FACETMILL_NEXT(write);
    return full(fd) ? -1 : real(fd, data, size);
}

ssize_t writev(int fd, const iovec* parts, int count) {
    FACETMILL_NEXT(writev);
    return full(fd) ? -1 : real(fd, parts, count);
}

size_t fwrite(const void* data, size_t size, size_t count, FILE* stream) {
    FACETMILL_NEXT(fwrite);
    return full(::fileno(stream)) ? 0 : real(data, size, count, stream);
}

int fflush(FILE* stream) {
    FACETMILL_NEXT(fflush);
    return stream && full(::fileno(stream)) ? EOF : real(stream);
}

/// What a stream had kept to itself finds no room: the stream is gone all the same.
int fclose(FILE* stream) {
    FACETMILL_NEXT(fclose);
    const bool lost = (::fcntl(::fileno(stream), F_GETFL) & O_ACCMODE) != O_RDONLY && full(::fileno(stream));
    const int result = real(stream);
    if (lost) errno = ENOSPC;
    return lost ? EOF : result;
}

int fsync(int fd) {
    FACETMILL_NEXT(fsync);
    return full(fd) ? -1 : real(fd);
}
}
