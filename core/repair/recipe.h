// The recipe that makes a scan worth machining: steps in the order in which they run, each opt-in. Plain
// data, described as operations are, so that project, command line and forms read it alike. Millimetres,
// square millimetres, radians, in the coordinates of the mesh file.
#pragma once

#include "core/base/parameter.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace facetmill {

struct RepairStep {
    enum class Kind {
        pieces,    ///< small shells are taken away
        turn,      ///< facets face one way, shells outward
        needles,   ///< doubles and facets without height are taken away
        holes,     ///< holes are filled
        smooth,    ///< noise is taken away
        decimate,  ///< facets that say nothing are taken away
        cut,       ///< what lies above a plane is taken away
        thicken,   ///< a sheet becomes a solid
        crossings, ///< where the surface runs through itself it is made anew
        join,      ///< another scan goes on where this one ends
        fins,      ///< sheets that hang on the surface and end in the open are taken away
        hole,      ///< one hole is filled, or left by the steps that follow
    };
    enum class Fill { smooth, flat, left };
    Kind kind = Kind::turn;
    double size = 0; ///< pieces: diagonal of the box; holes, crossings: diameter; fins: as pieces; join:
                     ///< scans lie no farther apart
    long facets = 0; ///< pieces: with fewer; decimate: as many stay
    double area = 0; ///< pieces: with less
    long keep = 0;   ///< pieces: so many with the largest areas stay
    Fill fill = Fill::smooth; ///< holes, hole, crossings; left: hole alone
    double bound = 0; ///< needles, smooth, decimate: nothing moves farther; join: the scan laid on this one
    double angle = radians(60);            ///< smooth: edges with a sharper bend are features
    double share = 0;                      ///< decimate: of the facets that stays
    std::array<double, 3> normal{0, 0, 1}; ///< cut: what lies on its side goes
    double offset = 0;                     ///< cut: the plane's distance from the origin along the normal
    bool close = true;                     ///< cut: the section is closed
    double thickness = 0;                  ///< thicken: to the back of the sheet, to its front below 0
    bool off = false;                      ///< in the recipe, and left out
    std::string file;                      ///< join: the other scan
    std::array<double, 3> at{0, 0, 0};     ///< hole: its middle, or near it

    bool operator==(const RepairStep&) const = default;
};

const ParameterTable<RepairStep>& repair_step_parameters();
inline constexpr RecordList<RepairStep> repair_list{"repair", repair_step_parameters};

/// "pieces", "turn", "needles" ...
const std::string& repair_kind_name(RepairStep::Kind kind);
/// Keys of the parameters that a kind reads beside `off`; the others say nothing of it.
const std::vector<std::string>& repair_keys(RepairStep::Kind kind);

/// Throws Error(missing_key, out_of_range) for a step that lacks what its kind needs, or that says what its
/// kind does not read. `place` is the way to the list.
void check_recipe(const std::vector<RepairStep>& recipe, const std::string& place);

/// With the files of its steps looked for from a folder, where they are not absolute.
std::vector<RepairStep> located_recipe(std::vector<RepairStep> recipe, const std::filesystem::path& folder);

/// A recipe as a file: {"units": "mm", "repair": [{"kind": "holes", "size": 5}]}. Throws Error(files) and
/// what read_parameters and check_recipe throw. Files of steps are looked for from its folder.
std::vector<RepairStep> load_recipe(const std::filesystem::path& path);

} // namespace facetmill
