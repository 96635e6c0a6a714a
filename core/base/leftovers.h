// Files beside their place: how outputs look until they are committed, and what the next run does with those
// of a run that was killed.
//
// Such a file is called ".facetmill.XXXXXX" and is locked (flock) while its run lives: one that nobody has
// locked is what a killed run left. A set that is being committed has a record of what it replaces,
// ".facetmill.XXXXXX.set", and the replaced files keep second names, ".facetmill.XXXXXX.before": while the
// record stands, the set counts as not written, and whoever finds it without a lock puts back what was there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace facetmill::detail {

/// A new file ".facetmill.XXXXXX" + `ending` in `folder`, open for writing and locked; -1 where none can be
/// made (errno says why).
int make_beside(const std::filesystem::path& folder, const std::string& ending, mode_t mode,
                std::filesystem::path& made);

/// One file of a set that replaces what stood there. All in one folder, by name.
struct Replaced {
    std::string target;
    std::string before; ///< second name of what stood there; empty: nothing did
    ino_t inode = 0;    ///< the new file's: what else stands at `target` is somebody else's
};

/// The record as bytes, and back; empty where the bytes are not a whole record.
std::string set_record(const std::vector<Replaced>& set);
std::vector<Replaced> read_set_record(const std::string& bytes);

/// Puts back what the set replaced, from the last to the first, and drops the second names.
void put_back(const std::filesystem::path& folder, const std::vector<Replaced>& set);

/// Undoes sets and removes files that killed runs of this user left in the folder. What cannot be removed
/// stays: nothing is thrown.
void clear_leftovers(const std::filesystem::path& folder) noexcept;

/// Waits until the entries of the folder are on disk, as far as the file system can.
void sync_folder(const std::filesystem::path& folder) noexcept;

} // namespace facetmill::detail
