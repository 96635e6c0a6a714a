// A program of ours that is run for what it makes: work that could crash, or that cannot be cancelled, is
// done in a process of its own.
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// A file in memory that another process can be given, by the path `path_for_child`.
class MemoryFile {
public:
    /// `name` is only for who looks at the system. Throws Error(unwritable).
    explicit MemoryFile(const char* name);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    /// Throws Error(unwritable).
    void write(std::string_view bytes);
    /// All that is in it, as long as it lives. Throws Error(unreadable).
    std::string_view bytes();
    int descriptor() const { return descriptor_; }

private:
    int descriptor_ = -1;
    void* map_ = nullptr;
    std::size_t map_size_ = 0;
};

/// Where a program of ours may be: beside the running one, in the folder `libexec/facetmill` beside its
/// folder, and in that of an installed core which a program of somebody else's runs with.
std::vector<std::filesystem::path> program_places(const std::string& name);

/// A running child. It ends with its object, and with this process.
class ChildProcess {
public:
    /// Descriptor 3 of the child is `input`, 4 is `output`, and what it writes to its standard output is read
    /// here; it has nothing else. Throws Error(not_found) where there is no such program, Error(internal)
    /// where it cannot be started.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const MemoryFile& input, const MemoryFile& output);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Adds what it has written, after waiting for at most so long; false once it will write no more.
    bool read(std::string& text, int milliseconds);
    /// Waits for its end: 0 or more is its exit status, below 0 a signal that ended it.
    int wait();
    void kill();

    static constexpr std::string_view input_path = "/proc/self/fd/3", output_path = "/proc/self/fd/4";

private:
    int process_ = -1, pipe_ = -1;
};

} // namespace facetmill
