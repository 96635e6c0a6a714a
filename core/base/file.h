// Files in and out. Outputs are written beside their place and renamed, so that a cancelled or failed job
// leaves nothing.
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// A whole file, read-only, memory-mapped where the system allows. Throws Error(not_found, is_directory,
/// unreadable, empty_file). Devices, pipes and sockets are refused as unreadable.
class InputFile {
public:
    explicit InputFile(const std::filesystem::path& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    std::string_view bytes() const { return bytes_; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    std::string_view bytes_;
    void* map_ = nullptr;
    std::size_t map_size_ = 0;
    std::vector<char> buffer_;
};

/// Writes to a temporary file in the target's folder; `commit` flushes it to the disk and renames it over the
/// target. Without commit the destructor removes the temporary file; what a killed run left in the folder
/// goes when the next output is made there. A file that is replaced hands on its permissions; a new one has
/// those of the process (umask). A target that is a link stands for the file it leads to, even where none is
/// there yet; one that is a folder, device, pipe or socket, or that may not be written to, is refused. Throws
/// Error(unwritable).
class OutputFile {
public:
    explicit OutputFile(std::filesystem::path target);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view bytes);
    /// Puts bytes in place of some that were written, and goes on behind all of them.
    void overwrite(std::size_t at, std::string_view bytes);
    void commit();
    const std::filesystem::path& target() const { return target_; }
    /// Where the bytes go until `commit`, for libraries that only write to a named file; call `close_stream`
    /// first.
    const std::filesystem::path& temporary() const { return temporary_; }
    void close_stream();

private:
    friend class OutputSet;
    OutputFile(std::filesystem::path target, bool clear_folder);
    [[noreturn]] void fail(const std::string& what) const;
    void forget();
    void sync();
    void take_place();
    std::filesystem::path target_, temporary_;
    std::FILE* file_ = nullptr;
    int lock_ = -1; ///< the file stays locked until it is committed or removed
    bool committed_ = false;
};

/// Throws Error(unwritable) when `output` is the file `input`, by whatever name: a job that reads its input
/// and writes its output over it would destroy what it was given.
void refuse_to_overwrite(const std::filesystem::path& input, const std::filesystem::path& output);

/// While one lives, no output takes the place of a file that an InputFile was opened for since: the process
/// is one job. Workbenches, which save what they have opened, have none.
class InputsKept {
public:
    InputsKept();
    ~InputsKept();
    InputsKept(const InputsKept&) = delete;
    InputsKept& operator=(const InputsKept&) = delete;
};

/// Several outputs of one job that appear together or not at all: `commit` renames all after every one is
/// complete, and puts back what stood there before when one of them cannot be renamed. Where the process is
/// killed meanwhile, the next output that is made in the folder puts it back.
class OutputSet {
public:
    /// Throws Error(unwritable), also for a target that is in the set already.
    OutputFile& add(const std::filesystem::path& target);
    /// `before` runs when all files are complete and none has appeared; when it throws, none does.
    void commit(const std::function<void()>& before = {});

private:
    class Replacement;
    std::vector<std::unique_ptr<OutputFile>> files_;
};

/// A folder of its own in the system's place for temporary files, for this user alone; it goes with its
/// object, and with `abandon_outputs`. What killed runs left goes when the next one is made. Texts for users
/// (`printable`) call what lies in it by the name it stands for: "sent.facetmill: part.stl".
class TemporaryFolder {
public:
    /// Throws Error(unwritable).
    explicit TemporaryFolder(std::string stands_for);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Makes a file, and folders on the way, that are not there yet. Throws Error(unwritable).
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> create(const std::filesystem::path& relative) const;

private:
    std::filesystem::path path_;
    int lock_ = -1; ///< locked as long as it lives
};

/// How many outputs this process has committed.
std::size_t committed_outputs();

/// Removes temporary folders and the temporary files of all outputs that are not committed, waiting for a
/// commit that is under way, and lets none be made or committed from then on: for a process that ends at
/// once. Does not return control over outputs to anyone: threads that use one wait for ever. Where more have
/// been committed than `before`, it is too late to undo the job: does nothing and returns false.
bool abandon_outputs(std::size_t before);

} // namespace facetmill
