#include "core/job/unroughed_stock.h"

#include "core/base/tolerances.h"
#include "core/job/project_setup.h"
#include "core/job/stock_solid.h"

#include <algorithm>

namespace facetmill {

namespace {

/// What is as upright as a wall has no room for a cutter above it: sine of the angle from upright.
constexpr double min_facing_up = 1e-3;

/// A shank as wide as the cutter follows it as deep as the flutes go; a slimmer one goes on down.
double reach_of(const Tool& tool) {
    const bool slim = tool.shank_diameter < (1 - tolerance::figure_rounding) * tool.diameter;
    return tool.flute_length + (slim ? tool.shank_length : 0);
}

bool is_asked(const Project& project, const Operation& finishing) {
    const bool known =
        project.stock.kind == StockSpec::Kind::box || project.stock.kind == StockSpec::Kind::cylinder;
    return known && finishing.purpose() == Purpose::finishing && !finishing.turning()
           && !finishing.is_indexed() && std::ranges::none_of(operations_on(project), [](const Operation* o) {
                  return o->purpose() == Purpose::roughing;
              });
}

UnroughedStock measured(const Mesh& mesh, double top, double reach) {
    UnroughedStock found;
    found.reach = reach;
    double deep = 0, all = 0;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        const Vec3 cross = mesh.facet_cross(f);
        const double area = cross.norm();
        if (!(cross.z() > min_facing_up * area)) continue;
        const double middle = (mesh.corner(f, 0).z() + mesh.corner(f, 1).z() + mesh.corner(f, 2).z()) / 3;
        all += area;
        if (middle < top - reach) deep += area;
        found.highest = std::max(found.highest, top - middle);
    }
    found.share = all > 0 ? deep / all : 0;
    return found;
}

} // namespace

std::optional<UnroughedStock> UnroughedLook::of(const Project& project, const PreparedPart& part,
                                                const Operation& finishing) {
    const Tool* tool = find_tool(project.tools, finishing.common().tool);
    if (!tool || !is_asked(project, finishing)) return std::nullopt;
    const double reach = reach_of(*tool), top = stock_solid(project.stock, part).box.hi.z();
    if (!(part.box.lo.z() < top - reach)) return std::nullopt;
    if (mesh_.lock() != part.mesh || top != top_ || reach != reach_) {
        kept_ = measured(*part.mesh, top, reach);
        mesh_ = part.mesh;
        top_ = top;
        reach_ = reach;
    }
    if (kept_.share <= project.limits.uncut_limit) return std::nullopt;
    return kept_;
}

std::optional<UnroughedStock> unroughed_stock(const Project& project, const PreparedPart& part,
                                              const Operation& finishing) {
    return UnroughedLook().of(project, part, finishing);
}

} // namespace facetmill
