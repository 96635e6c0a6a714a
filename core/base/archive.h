// Zip archives of a few files, as they are sent: written in one go, read with every name and size looked at
// first. Neither holds a whole file in memory.
#pragma once

#include "core/base/progress.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

struct ArchiveFile {
    std::string name; ///< relative, '/' between folders, UTF-8
    std::string bytes;
};

/// What an archive may hold at most: files, and bytes of all of them unpacked. An archive that is much
/// smaller than what it says to hold is refused as well: meshes do not shrink to a hundredth.
struct ArchiveLimits {
    std::size_t files = 1000;
    std::uint64_t bytes = std::uint64_t(4) << 30;
    std::uint64_t times_larger = 200;                       ///< than the archive, beyond
    std::uint64_t always_allowed = std::uint64_t(64) << 20; ///< bytes that any archive may hold
};

/// Whether a file begins as a zip archive does.
bool is_archive(std::string_view bytes);

/// A file to be packed; its bytes, often a map of the file, live until the archive is written.
struct ArchiveEntry {
    std::string name; ///< relative, '/' between folders, UTF-8
    std::string_view bytes;
};

/// Puts bytes at a place of the archive, which is its end or before it.
using ArchiveWriter = std::function<void(std::uint64_t at, std::string_view bytes)>;

/// The same files give the same bytes: no time and no owner is written. Throws Error(out_of_range) for a name
/// that ArchiveReader refuses, Error(limit_exceeded) for more than the usual limits, and what `write` throws.
void write_archive(const std::vector<ArchiveEntry>& files, const ArchiveWriter& write,
                   const Progress& progress = {});
std::string archive_bytes(const std::vector<ArchiveFile>& files);

/// An archive that is called `name` in errors. Refused are names that lead out of the folder (absolute, "..",
/// drives, backslashes), names that occur twice, also in other capitals or as a file and a folder, links and
/// whatever else is no plain file, encrypted files, and more than `limits`.
class ArchiveReader {
public:
    /// The bytes must live as long as the reader. Throws Error(syntax, limit_exceeded, unsupported_format).
    ArchiveReader(std::string_view bytes, const std::string& name, const ArchiveLimits& limits = {});
    ~ArchiveReader();
    ArchiveReader(const ArchiveReader&) = delete;
    ArchiveReader& operator=(const ArchiveReader&) = delete;

    std::size_t count() const;
    const std::string& entry_name(std::size_t i) const;
    std::uint64_t size(std::size_t i) const;
    /// "archive: entry", for errors about it.
    std::string where(std::size_t i) const;
    /// Hands the bytes of a file over piece by piece. Throws Error(syntax) where it is damaged, by then after
    /// some pieces.
    void read(std::size_t i, const std::function<void(std::string_view)>& take,
              const Progress& progress = {}) const;
    std::string bytes(std::size_t i) const;

private:
    class Entries;
    std::unique_ptr<const Entries> entries_;
};

/// All files at once.
std::vector<ArchiveFile> read_archive(std::string_view bytes, const std::string& name,
                                      const ArchiveLimits& limits = {});

} // namespace facetmill
