#include "core/base/child_process.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

/// Actions and attributes that a child is started with.
struct SpawnSettings {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;

    SpawnSettings() {
        posix_spawn_file_actions_init(&actions);
        posix_spawnattr_init(&attributes);
    }
    ~SpawnSettings() {
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    /// Signals as a new program has them, and a process group of its own: a Ctrl-C is for us, who end it.
    void set_signals() {
        sigset_t none, all;
        sigemptyset(&none);
        sigfillset(&all);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setsigdefault(&attributes, &all);
        posix_spawnattr_setpgroup(&attributes, 0);
        posix_spawnattr_setflags(&attributes,
                                 POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
};

[[noreturn]] void memory_failed(ErrorCode code) {
    throw Error(code, "memory", std::string("a file in memory cannot be used: ") + std::strerror(errno),
                "free some memory");
}

} // namespace

MemoryFile::MemoryFile(const char* name) : descriptor_(::memfd_create(name, MFD_CLOEXEC)) {
    if (descriptor_ < 0) memory_failed(ErrorCode::unwritable);
}

MemoryFile::~MemoryFile() {
    if (map_) ::munmap(map_, map_size_);
    ::close(descriptor_);
}

void MemoryFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) memory_failed(ErrorCode::unwritable);
        bytes.remove_prefix(std::size_t(n));
    }
}

std::string_view MemoryFile::bytes() {
    struct stat found {};
    if (::fstat(descriptor_, &found) != 0) memory_failed(ErrorCode::unreadable);
    if (map_) ::munmap(std::exchange(map_, nullptr), map_size_);
    map_size_ = std::size_t(found.st_size);
    if (map_size_ == 0) return {};
    void* map = ::mmap(nullptr, map_size_, PROT_READ, MAP_SHARED, descriptor_, 0);
    if (map == MAP_FAILED) memory_failed(ErrorCode::unreadable);
    map_ = map;
    return {static_cast<const char*>(map_), map_size_};
}

std::vector<fs::path> program_places(const std::string& name) {
    std::vector<fs::path> places;
    std::error_code ec;
    const fs::path running = fs::read_symlink("/proc/self/exe", ec).parent_path();
    if (!ec) {
        places.push_back(running / name);
        places.push_back((running / "../libexec/facetmill" / name).lexically_normal());
    }
    // The library's folder is lib, or lib/x86_64-linux-gnu and the like.
    Dl_info library{};
    static const char inside = 0;
    if (::dladdr(&inside, &library) != 0 && library.dli_fname) {
        const fs::path folder = fs::weakly_canonical(library.dli_fname, ec).parent_path();
        if (!ec && folder != running)
            for (const char* up : {"..", "../.."})
                places.push_back((folder / up / "libexec/facetmill" / name).lexically_normal());
    }
    return places;
}

ChildProcess::ChildProcess(const fs::path& program, const std::vector<std::string>& arguments,
                           const MemoryFile& input, const MemoryFile& output) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);

    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw Error(ErrorCode::internal, printable(program.filename().string()),
                    std::string("it cannot be started: ") + std::strerror(errno), "close other programs");
    // Copies beyond those that the child gets: none of them is in the place of another.
    const int given[] = {::fcntl(input.descriptor(), F_DUPFD_CLOEXEC, 10),
                         ::fcntl(output.descriptor(), F_DUPFD_CLOEXEC, 10),
                         ::fcntl(ends[1], F_DUPFD_CLOEXEC, 10)};
    ::close(ends[1]);
    SpawnSettings settings;
    settings.set_signals();
    posix_spawn_file_actions_addopen(&settings.actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&settings.actions, given[2], 1);
    posix_spawn_file_actions_addopen(&settings.actions, 2, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&settings.actions, given[0], 3);
    posix_spawn_file_actions_adddup2(&settings.actions, given[1], 4);
    posix_spawn_file_actions_addclosefrom_np(&settings.actions, 5);
    pid_t process = -1;
    const int error = ::posix_spawn(&process, words[0].c_str(), &settings.actions, &settings.attributes,
                                    pointers.data(), environ);
    for (const int descriptor : given)
        if (descriptor >= 0) ::close(descriptor);
    if (error != 0) {
        ::close(ends[0]);
        const bool none = error == ENOENT || error == ENOTDIR;
        throw Error(none ? ErrorCode::not_found : ErrorCode::internal, printable(program.string(), 400),
                    std::string(none ? "there is no such program" : "it cannot be started: ")
                        + (none ? "" : std::strerror(error)),
                    none ? "install all of Facetmill" : "install Facetmill again");
    }
    process_ = process;
    pipe_ = ends[0];
}

ChildProcess::~ChildProcess() {
    if (process_ > 0) {
        kill();
        wait();
    }
    if (pipe_ >= 0) ::close(pipe_);
}

bool ChildProcess::read(std::string& text, int milliseconds) {
    pollfd wanted{pipe_, POLLIN, 0};
    const int ready = ::poll(&wanted, 1, milliseconds);
    if (ready <= 0) return ready == 0 || errno == EINTR;
    char buffer[4096];
    const ssize_t n = ::read(pipe_, buffer, sizeof buffer);
    if (n < 0) return errno == EINTR;
    text.append(buffer, std::size_t(n));
    return n > 0;
}

int ChildProcess::wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0)
        if (errno != EINTR) {
            process_ = -1;
            return -SIGKILL; // somebody else has waited for it
        }
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

void ChildProcess::kill() {
    if (process_ > 0) ::kill(process_, SIGKILL);
}

} // namespace facetmill
