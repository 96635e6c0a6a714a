// The files that a project names beside itself: where they are looked for, which are missing, and other files
// in their place.
#pragma once

#include "core/job/project.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace facetmill {

/// A file that a project names.
struct ProjectInput {
    enum class Kind { part, stock, fixture, machine, post, scan };
    Kind kind = Kind::part;
    std::filesystem::path path; ///< where it is looked for
    std::size_t place = 0;      ///< fixture: in the setup's list; scan: of its step in the part's recipe
    bool operator==(const ProjectInput&) const = default;
};

/// "part", "stock", "fixture", "machine", "post", "scan".
std::string_view input_name(ProjectInput::Kind kind);

/// There is nothing at this place, neither a file nor anything else.
bool is_missing(const std::filesystem::path& path);
/// Those of the part, which come first, and of the setup that the project is the view on. Stock and
/// fixtures that are no mesh, machines and posts of the program have no file.
std::vector<ProjectInput> project_inputs(const Project& project);
/// Those that are missing. A folder in the place of a file, or a file that may not be read, is another error.
std::vector<ProjectInput> missing_inputs(const Project& project);
/// Throws Error(not_found) that names all files that planning reads and that are missing.
void check_inputs(const Project& project);

/// What the project says of one, as it is written.
const std::string& written_name(const Project& project, const ProjectInput& input);
/// "part.file", "fixtures[2].file", "machine", "post", "part.repair[0].file".
std::string input_key(const ProjectInput& input);
/// Writes a name in the place of one; `set_input` finds it for a file.
void write_name(Project& project, const ProjectInput& input, const std::string& name);
/// Names another file in the place of one, relative to the project's where that has a place on disk and links
/// on the way do not lead elsewhere.
void set_input(Project& project, const ProjectInput& input, const std::filesystem::path& file);
/// Takes over which files another project of the same setups names, and nothing else.
void take_inputs(Project& to, const Project& from);
/// Names `file` in place of a missing one. Other missing files that lie as they did beside it, or under their
/// old names in its folder, are named as well: those are returned.
std::vector<ProjectInput> locate_input(Project& project, const ProjectInput& missing,
                                       const std::filesystem::path& file);

} // namespace facetmill
