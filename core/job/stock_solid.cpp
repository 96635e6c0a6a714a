#include "core/job/stock_solid.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/job/planner.h"

#include <cmath>

namespace facetmill {

std::array<double, 3> reach_about_middle(const Mesh& mesh, const Box3& box) {
    std::array<double, 3> squares{};
    for (const Vec3& p : mesh.vertices) {
        const Vec3 s = (p - box.center()).cwiseAbs2();
        squares = {std::max(squares[0], s.y() + s.z()), std::max(squares[1], s.z() + s.x()),
                   std::max(squares[2], s.x() + s.y())};
    }
    return {std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2])};
}

StockSolid stock_solid(const StockSpec& stock, const PreparedPart& part) {
    StockSolid solid;
    switch (stock.kind) {
    case StockSpec::Kind::box:
        solid.box = stock_box(stock, part.box);
        break;
    case StockSpec::Kind::cylinder: {
        const StockCylinder c = stock_cylinder(stock, part.box, part.reach);
        solid.kind = StockSolid::Kind::cylinder;
        solid.box = c.box;
        solid.axis = c.axis;
        solid.radius = c.radius;
        break;
    }
    case StockSpec::Kind::mesh:
    case StockSpec::Kind::rest:
        solid.kind = StockSolid::Kind::mesh;
        solid.mesh = part.stock_mesh;
        solid.edge_loss = part.stock_edge_loss;
        solid.box = part.stock_box;
        break;
    }
    return solid;
}

std::vector<std::string> stock_warnings(const StockSpec& stock, const PreparedPart& part, LengthUnit unit) {
    std::vector<std::string> warnings;
    if (part.box.empty()) return warnings;
    if (stock.kind == StockSpec::Kind::cylinder) {
        const StockCylinder c = stock_cylinder(stock, part.box, part.reach);
        if (c.radius < c.needed * (1 - tolerance::same_shape))
            warnings.push_back("The stock does not hold the part: its diameter is "
                               + length_text(2 * c.radius, unit) + ", the part needs "
                               + length_text(2 * c.needed, unit, 4) + ".");
    } else if (stock.kind == StockSpec::Kind::mesh && part.stock_mesh) {
        const Box3& box = part.stock_box;
        const double beyond = std::max((box.lo - part.box.lo).maxCoeff(), (part.box.hi - box.hi).maxCoeff());
        if (beyond > tolerance::coordinate_rounding * part.box.diagonal())
            warnings.push_back("The stock does not hold the part, which reaches up to "
                               + length_text(beyond, unit, 4) + " beyond the box of the stock's mesh.");
    }
    return warnings;
}

} // namespace facetmill
