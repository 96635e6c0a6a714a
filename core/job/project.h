// The project: part, tools, and setups with stock, machine and operations, as the project file has them.
#pragma once

#include "core/base/parameter.h"
#include "core/job/project_setup.h"
#include "core/job/verify_limits.h"
#include "core/mesh/mesh_reading.h"
#include "core/repair/recipe.h"
#include "core/setup/tool.h"
#include "core/strategy/plan/operation.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

class TemporaryFolder; // core/base/file.h

struct PartSpec {
    std::string file; ///< as written: relative to the project file, or absolute
    LengthUnit unit = LengthUnit::mm;
    double scale = 1;                                   ///< of the file's numbers, about the file's origin
    Mirror mirror = Mirror::none;                       ///< before the rotation
    bool flip = false;                                  ///< the other side of open surfaces is outside
    std::array<double, 3> rotate{0, 0, 0};              ///< radians about X, then Y, then Z (fixed axes)
    std::array<double, 3> translate{0, 0, 0};           ///< mm, after the rotation
    std::array<double, 2> tessellation_tolerance{0, 0}; ///< out, in; mm
    std::string objects;                                ///< as MeshReading::objects
    // Pictures, mm; "auto" as Relief has it.
    NumberOrWord picture_width{0.0, "auto"}, picture_length{0.0, "auto"}, relief_height{0.0, "auto"};
    double smoothing = 0;
    bool invert = false;
    NumberOrWord chord_tolerance{0.0, "auto"};  ///< of surfaces; mm, auto: see part_reading
    double angle_tolerance = usual_chord_angle; ///< of surfaces; radians

    MeshReading reading() const;
    std::vector<RepairStep>
        repair; ///< carried out on the file's mesh before it is placed, each time it is read
};

const ParameterTable<PartSpec>& part_parameters();
/// Keys of the parameters that say something of pictures alone.
const std::vector<std::string>& relief_keys();

/// Newest version of the project file that is read: key "facetmill".
inline constexpr long project_version = 2;
/// The version that is written where a project has one setup, which holds the part where it is.
inline constexpr long single_setup_version = 1;

/// The view on one of its setups: all that is said of stock, machine, programs and operations is that one's.
struct Project : Setup {
    std::filesystem::path path; ///< where it was read from or last saved; empty when new
    LengthUnit unit = LengthUnit::mm;
    PartSpec part;
    VerifyLimits limits; ///< key "verification"
    std::vector<Tool> tools;
    std::vector<Setup> before, after; ///< the other setups, in machining order
    /// Folder of a packed project, with its files: it lives as long as one of the project's copies.
    std::shared_ptr<const TemporaryFolder> unpacked;

    std::filesystem::path part_path() const;
    /// How the part's file is read. Facets follow the surfaces of a file that has such to a tenth of the
    /// finest tolerance of all operations, where the part does not say itself how closely; other files are
    /// read alike whatever operations say.
    MeshReading part_reading() const;
    /// The part's recipe with its files where they are looked for.
    std::vector<RepairStep> part_recipe() const;
    std::filesystem::path stock_path() const; ///< of the stock's file; empty where it has none
    /// File of a fixture that is a mesh; empty for others.
    std::filesystem::path fixture_path(const Fixture& fixture) const;
    /// The part as the chosen setup holds it: its own placement, then that of the setup.
    PartSpec placed_part() const;
    /// The machine's file; the project's `machine` may also be the name of a machine of the program.
    std::filesystem::path machine_path() const;
    std::filesystem::path post_path() const;
    /// Throws Error(missing_reference) that names the operation.
    const Tool& tool_of(const Operation& operation) const;
    /// That of the chosen setup with this name. Throws Error(missing_reference) that names those there are.
    const Boundary& boundary_of(const std::string& wanted) const;
    /// What leaves a boundary that is the rest of a tool; nothing for others. Throws Error(missing_reference)
    /// that names the boundary.
    std::optional<AptCutter> cutter_of(const Boundary& boundary) const;
    /// Those of Operation::further_tools. Throws likewise.
    std::vector<Tool> further_tools_of(const Operation& operation) const;
};

/// Strict: every key is known, no key occurs twice, every value has its type and range, references lead
/// somewhere; stock, fixtures and boundaries have the keys of their kind. Required are `facetmill`, `units`,
/// `part.file`, of a mesh as stock or fixture `file`, per tool `number` and `diameter`, per operation `kind`
/// and `tool`; anything else has its described default (`part.units`, `stock.units`: the project's;
/// `shank_diameter`: the tool's diameter). Throws Error(syntax, truncated, encoding, limit_exceeded,
/// unknown_key, wrong_type, out_of_range, missing_key, missing_reference, newer_version, files ...) whose
/// place is "file: operations[0].tolerance". Older versions are migrated. In a file of version 2 the place is
/// "file: setups[0].operations[0].tolerance"; the view is on its first setup. A packed project
/// (core/job/packed_project.h) is read as well: its files are in a temporary folder while it or a copy lives.
Project load_project(const std::filesystem::path& path);
Project parse_project(std::string_view json, const std::string& name);
/// Parsing and writing again gives the same text; which setup the view is on makes no difference. Throws
/// Error(out_of_range) for a value that is not finite.
std::string project_to_json(const Project& project);
/// The machine by its name or from its file. Throws Error(missing_reference, files, load_machine) that names
/// `machine` or the file.
Machine project_machine(const Project& project);
/// Place, size and time of writing of a file as text: another one once the file was written anew or is gone.
std::string file_stamp(const std::filesystem::path& path);
/// What a file is, as text, in texts that say what results depend on: file_stamp, or its content.
using FileText = std::function<std::string(const std::filesystem::path&)>;
/// Throws Error(unwritable) where `output` is the project's file or that of its part, stock or machine, by
/// whatever name.
void keep_inputs(const Project& project, const std::filesystem::path& output);
/// The same but for the project's own file: a project may be saved over itself.
void keep_referenced(const Project& project, const std::filesystem::path& output);
/// Gives the project a new place and rewrites relative files of part, stock and machine so that they still
/// name the same files.
void move_project(Project& project, const std::filesystem::path& path);
/// Writes beside and renames; relative files are written relative to `path`. Throws Error(unwritable,
/// also for the file of its part, stock or machine; what check_text throws).
void save_project(const Project& project, const std::filesystem::path& path);

/// Checks everything that needs no mesh, of all setups: values, references, tools, machine, names that occur
/// twice. A machine file is read only once the project has a path. The place in the error is
/// "operations[0].tolerance", without the file; of several setups "setups[1].operations[0].tolerance".
void check_project(const Project& project);

/// "NAME.key=value" as on the command line; NAME is an operation's name or its place in the project, from 1.
/// "part.key=value" sets what is said of the part, unless an operation is called "part".
/// Keys of programs ("post=grbl", "wcs=G55") have a setup's name before them, or none: all setups' then.
/// Only the one value is checked: `check_project` follows. Throws Error(usage, missing_reference,
/// unknown_key, wrong_type, out_of_range); nothing changes then.
void apply_setting(Project& project, std::string_view setting);

/// Feed of the operations of a new project, mm/min: a round number of its unit.
double starting_feed(LengthUnit unit);
/// A new project around a part with one sensible tool and one finish3 operation for its size; `unit` is that
/// of the part's file.
Project default_project(const std::filesystem::path& part_file, LengthUnit unit, const Box3& part_box);
/// The same for a part that turns about X: a lathe-mill, round stock, roughing and finishing.
Project default_turned_project(const std::filesystem::path& part_file, LengthUnit unit, const Box3& part_box);

} // namespace facetmill
