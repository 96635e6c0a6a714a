// What holds the part on the machine: vices, clamps, plates, chucks. Tools keep away from it; it is never
// cut. And tabs: pieces of the stock that stay, so that a part which is cut out of it does not come loose.
// Millimetres, coordinates of the setup.
#pragma once

#include "core/base/parameter.h"
#include "core/mesh/mesh.h"
#include "core/setup/placement.h"

#include <array>
#include <string>
#include <vector>

namespace facetmill {

/// As the project says it: a body with the middle of its bottom at the origin, turned, and moved to its
/// place. A mesh is placed as its file has it.
struct Fixture {
    enum class Kind { box, cylinder, mesh, tab };
    enum class TabShape { rectangular, triangular };
    std::string name = "Fixture";
    Kind kind = Kind::box;
    std::array<double, 3> size{40, 20, 20}; ///< box: along x, y, z; tab: length across the gap, width, height
    TabShape shape = TabShape::rectangular; ///< tab: as it is seen along its length
    double diameter = 20, height = 20;      ///< cylinder: along z
    std::string file;                       ///< mesh; relative to the project file, or absolute
    LengthUnit unit = LengthUnit::mm;       ///< mesh: of the file's numbers
    double scale = 1;                       ///< mesh
    Mirror mirror = Mirror::none;           ///< mesh
    std::array<double, 3> rotate{0, 0, 0}, translate{0, 0, 0};
    double clearance = 2; ///< what tools keep from it; from a tab nothing
};

const ParameterTable<Fixture>& fixture_parameters();
/// "box", "cylinder", "mesh", "tab".
const std::string& fixture_kind_name(Fixture::Kind kind);
/// Keys of the parameters that a kind has; the others say nothing of it.
const std::vector<std::string>& fixture_keys(Fixture::Kind kind);

/// A box, cylinder or tab in its place, grown by `by` on all sides; closed, wound outward. A cylinder has
/// many sides, round about it. Of a mesh the file would have to be read: Error(internal).
Mesh fixture_mesh(const Fixture& fixture, double by = 0);

/// A fixture as a body in its place, for planners and the verifier.
struct FixtureSolid {
    std::string name;
    MeshPtr mesh;  ///< closed
    MeshPtr grown; ///< holds all that is nearer to it than the clearance
    double clearance = 0;
    bool tab = false;   ///< of the stock: it is not cut, and to touch it is no collision
    bool table = false; ///< what holds the stock below a tilted tool: the project has no name for it
};

} // namespace facetmill
