// STEP and IGES files of solids whose volumes are known, as OpenCASCADE writes them; empty where the tests
// were built without it.
#pragma once

#include <string>
#include <vector>

namespace facetmill::test {

/// Says why tests with such files are skipped; null where they are not.
const char* no_surface_files();

/// A corner at the origin; mm whatever the unit of the file: "MM", "INCH", "M".
std::string step_box(double x, double y, double z, const char* unit = "MM");
/// On the origin, along Z.
std::string step_cylinder(double radius, double height);
std::string step_sphere(double radius);
std::string step_torus(double large, double small);
/// 100 x 100 x 20 with a hole of this radius through its middle.
std::string step_block_with_hole(double radius);
/// Boxes of 1 x 2 x 3, each with a place of its own on a grid of 10, `along` of them in a row.
std::string step_assembly(int boxes, int along);
/// Solids by name, each of a volume known in closed form: "box", "cylinder", "cone" (cut off), "wedge",
/// "torus", "sphere", "hole" (a block with one), "rounded" (a box whose upright edges are), "slope" (a box
/// with a chamfered edge), "bottle" (turned, of B-splines). `schema`: of OpenCASCADE's writer: 1 AP214 as
/// drafted, 2 AP214, 3 AP203, 4 AP214 of 1998, 5 AP242.
struct StepSolid {
    std::string bytes;
    double volume = 0; ///< mm^3
};
const std::vector<std::string>& step_solids();
StepSolid step_solid(const std::string& name, const char* unit = "MM", int schema = 1);
/// The lower half of a sphere's surface: no solid.
std::string step_bowl(double radius);
std::string step_wire();
/// `solid`: as a solid, else as surfaces that only lie beside each other.
std::string iges_cylinder(double radius, double height, bool solid);

} // namespace facetmill::test
