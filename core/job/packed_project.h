// Packed projects: a project and all files that it names in one archive, to be sent to someone. In the
// archive lie the project, "NAME.facetmill", which names its files relative to itself, and those, as they
// are, in the folder "files".
#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/job/project.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// A file of a packed project.
struct PackedFile {
    std::string name;           ///< in the archive
    std::filesystem::path path; ///< where it was packed from or unpacked to
    std::uint64_t bytes = 0;
};

/// Called once all is written and before anything appears; when it throws, nothing does.
using BeforePacked = std::function<void(const std::vector<PackedFile>&)>;

/// Packs a project with the meshes, machines and posts of all its setups; `name` is what the project in it is
/// called, without ending. Files of equal names get numbers, a file that is named twice is packed once. The
/// same project gives the same bytes. Throws Error(not_found ...) that names what is missing,
/// Error(unwritable), also where `output` is one of the files, Error(limit_exceeded).
std::vector<PackedFile> pack_project(const Project& project, const std::string& name,
                                     const std::filesystem::path& output, const Progress& progress = {},
                                     const BeforePacked& before = {});

/// Whether a file that can be read begins as an archive does.
bool is_packed(const std::filesystem::path& path);

/// Unpacks into a folder, which is made where there is none; all files appear or none. The project comes
/// first. What is there already with the same bytes stays as it is. Throws what `load_project` throws,
/// Error(unwritable), also where another file is in the place of one.
std::vector<PackedFile> unpack_project(const std::filesystem::path& packed,
                                       const std::filesystem::path& folder, const Progress& progress = {},
                                       const BeforePacked& before = {});

/// The project in the bytes of a packed file that is called `name`, with everything about it checked, without
/// its files. Throws what `load_packed` throws.
Project packed_project(std::string_view bytes, const std::string& name);

/// The project in a packed file, its files in a temporary folder. All that it names has to be in the archive:
/// throws Error(missing_reference) where something is not, Error(missing_key) where there is no project,
/// Error(out_of_range) where there are several, and what ArchiveReader and `parse_project` throw. The place
/// is "packed: entry".
Project load_packed(const InputFile& packed);

} // namespace facetmill
