// Zip archives of a few files, as they are sent: written whole, read with every name and size looked at
// first.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

struct ArchiveFile {
    std::string name; ///< relative, '/' between folders, UTF-8
    std::string bytes;
};

/// What an archive may hold at most: files, and bytes of all of them unpacked.
struct ArchiveLimits {
    std::size_t files = 1000;
    std::uint64_t bytes = std::uint64_t(4) << 30;
};

/// Whether a file begins as a zip archive does.
bool is_archive(std::string_view bytes);

/// The same files give the same bytes: no time and no owner is written. Throws Error(out_of_range) for a name
/// that `read_archive` refuses.
std::string archive_bytes(const std::vector<ArchiveFile>& files);

/// All files of an archive that is called `name` in errors. Refused are names that lead out of the folder
/// (absolute, "..", drives, backslashes), names that occur twice, also in other capitals or as a file and a
/// folder, links and whatever else is no plain file, encrypted files, and more than `limits`. Throws
/// Error(syntax, limit_exceeded, unsupported_format).
std::vector<ArchiveFile> read_archive(std::string_view bytes, const std::string& name,
                                      const ArchiveLimits& limits = {});

} // namespace facetmill
