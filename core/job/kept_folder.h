// What was planned and judged, kept beside a project: the folder "job.facetmill-cache" of "job.facetmill". It
// may be deleted at any time.
//
// A file is called after what its content was made from, by a hash under a key that only this user's programs
// have, and sealed under the same key: what anybody else wrote, what is torn, and what was kept for other
// values is not read. So bytes that are read are those that were written.
#pragma once

#include "core/base/keyed_hash.h"
#include "core/base/progress.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace facetmill {

class KeptFolder {
public:
    /// What is kept of one project takes no more.
    static constexpr std::uint64_t largest_total = 1'000'000'000;

    /// `program`: of the program and its version; what another one kept is not read.
    KeptFolder(const std::filesystem::path& project, const HashKey& key, std::string program);

    const std::filesystem::path& path() const { return path_; }
    /// The name of what a content of a kind was made from.
    std::string name_of(std::string_view kind, std::string_view source) const;
    bool has(const std::string& name) const;
    /// Nothing where there is no such file, or it is not as it was written.
    std::optional<std::string> read(const std::string& name, const Progress& progress) const;
    /// False where it would be too much. Throws Error(unwritable).
    bool write(const std::string& name, std::string_view bytes, const Progress& progress) const;
    /// Removes what has another name.
    void keep_only(const std::set<std::string>& names) const;
    /// Bytes of all files.
    std::uint64_t size() const;
    bool empty() const { return size() == 0; }

private:
    std::filesystem::path file_of(const std::string& name) const;
    KeyedHash seal(const std::string& head, std::string_view bytes, const Progress& progress) const;

    std::filesystem::path path_;
    HashKey key_;
    std::string program_;
};

/// What is kept of one project, kept of another beside it as well: a copy, whose names and contents are the
/// same. No more than one project keeps; what cannot be copied is left out, as it can be made again.
void copy_kept(const std::filesystem::path& from_project, const std::filesystem::path& to_project,
               const Progress& progress);

/// The content of a file under a key, as text for FileText. Throws what InputFile does.
std::string content_text(const std::filesystem::path& path, const HashKey& key, const Progress& progress);

} // namespace facetmill
