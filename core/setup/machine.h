// Machines: axes, limits, speeds and how they carry each other, as files describe them
// (resources/machines/README.md).
//
// Frame of the machine: X, Y, Z as the linear axes run, +Z from the table to the spindle, right-handed; where
// the origin lies is the file's choice. Every movement is that of the tool relative to the bed, whatever
// slides in the machine. At zero rotary angles the part's axes are parallel to the machine's, the tool stands
// along +Z and the spindle nose is at (X, Y, Z). Millimetres and radians.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// Where an axis can stand; without limits unless the file gives them.
struct Travel {
    double lo = -infinity, hi = infinity;
    bool contains(double value, double slack = 0) const { return lo - slack <= value && value <= hi + slack; }
    bool limited() const { return lo != -infinity || hi != infinity; }
};

struct RotaryAxis {
    enum class Carries { tool, table };
    std::string name; ///< "A", "B" or "C"
    Carries carries = Carries::tool;
    Vec3 direction = Vec3::UnitX(); ///< unit vector, at zero angles
    Vec3 point = Vec3::Zero(); ///< on the axis at zero angles: of a head relative to the spindle nose, of a
                               ///< table in the frame
    double sign = 1;           ///< +1: a positive angle turns what the axis carries by the right hand about
                               ///< `direction`; -1: the other way
    Travel travel;             ///< radians
    double speed = 0.5;        ///< largest, rad/s
    double acceleration = infinity; ///< largest, rad/s^2; infinite where the file says nothing
};

struct Machine {
    std::string name;                          ///< as the project file says: "tarus-tpi-2000"
    std::string label;                         ///< as forms say: "Tarus TPI 2000 (5-axis, head-head)"
    std::string description;                   ///< where the figures come from
    Vec3 rapid_mm_per_s = Vec3(170, 180, 240); ///< largest speed of X, Y, Z
    Vec3 acceleration_mm_per_s2 =
        Vec3::Constant(infinity); ///< largest of X, Y, Z; infinite where the file says nothing
    std::array<Travel, 3> travel; ///< of X, Y, Z
    /// At most two. Of those that carry the same, the outer one first, the one that carries the other: for a
    /// head the one at the ram, for a table the one at the bed.
    std::vector<RotaryAxis> rotary;
    /// Where the middle of the part's bottom stands unless someone says otherwise, at zero angles.
    Vec3 table = Vec3::Zero();
    std::string source; ///< text of the file: two machines are the same when it is

    /// Joints are numbered X, Y, Z, then the rotary axes in their order.
    int joints() const { return 3 + int(rotary.size()); }
    std::string axis_name(int joint) const;
    double speed(int joint) const;
    double acceleration(int joint) const;
    const Travel& joint_travel(int joint) const;
};

/// "3-axis", "4-axis, table", "5-axis, head-head", "5-axis, table-table", "5-axis, head-table" ...
std::string machine_kind(const Machine& machine);

/// The machines that are part of the program.
const std::vector<Machine>& machines();
/// Throws Error(missing_reference) that lists the known names.
const Machine& find_machine(std::string_view name);

/// A machine of one's own: a `machine` of a project that ends with ".json" names a file, not a machine of the
/// program.
bool is_machine_file(std::string_view name);
/// Strict: every key is known, has its type and its range, and the axes make a machine. Throws Error(syntax,
/// truncated, encoding, limit_exceeded, unknown_key, wrong_type, missing_key, out_of_range, newer_version)
/// whose place is "file: axes[3].travel".
Machine parse_machine(std::string_view json, const std::string& file);
/// The same from a file; the name is the file's. Throws also what InputFile throws.
Machine load_machine(const std::filesystem::path& path);

} // namespace facetmill
