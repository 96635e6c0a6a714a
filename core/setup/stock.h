// The raw material before the first operation.
#pragma once

#include "core/base/parameter.h"
#include "core/base/vec.h"
#include "core/setup/placement.h"

#include <array>
#include <string>
#include <vector>

namespace facetmill {

struct StockSpec {
    /// rest: what the setup before left, as it was verified; the first setup of a project has none.
    enum class Kind { box, cylinder, mesh, rest };
    enum class Axis { x, y, z };
    Kind kind = Kind::box;
    /// Box and cylinder. mm added to the part's box on both sides in x and y, on top in z.
    std::array<double, 3> margin{0, 0, 0};
    Axis axis = Axis::z;                ///< cylinder
    NumberOrWord diameter{0.0, "auto"}; ///< cylinder; mm
    std::string file;                   ///< mesh; relative to the project file, or absolute
    LengthUnit unit = LengthUnit::mm;   ///< mesh: of the file's numbers
    double scale = 1;                   ///< mesh; this and what follows as those of the part
    Mirror mirror = Mirror::none;
    std::array<double, 3> rotate{0, 0, 0}, translate{0, 0, 0};
};

const ParameterTable<StockSpec>& stock_parameters();
/// "box", "cylinder", "mesh", "rest".
const std::string& stock_kind_name(StockSpec::Kind kind);
/// Keys of the parameters that a kind has; the others say nothing of it.
const std::vector<std::string>& stock_keys(StockSpec::Kind kind);

/// The stock's box around the part's; the bottom of the stock is the part's bottom.
Box3 stock_box(const StockSpec& stock, const Box3& part);

/// Round a part: about the middle of its box, along a coordinate axis, and along it as long as the box with
/// its margins.
struct StockCylinder {
    Box3 box; ///< around the cylinder
    int axis = 2;
    double radius = 0;
    double needed = 0; ///< radius that holds the part, without a margin
};
/// `reach`: the largest distances of the part's points from the lines through the middle of its box along x,
/// y, z. Of diameter `auto` the margin is the larger one of those across the axis.
StockCylinder stock_cylinder(const StockSpec& stock, const Box3& part, const std::array<double, 3>& reach);

} // namespace facetmill
