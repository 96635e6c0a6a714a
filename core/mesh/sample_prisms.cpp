// Jasra's lathe-mill parts. The square prism has the 50 mm side of his validation and the 40 mm length of the
// block he cut; the cylinder is his Ø40 x 25. He gives no size for the twisted prism: side 45 mm as his cut
// prism, 60 mm long, a quarter turn. The patterns on a cylinder (his figure 4.14, 1 mm high) are stand-ins.
#include "core/base/error.h"
#include "core/mesh/sample_parts.h"
#include "core/mesh/sample_tessellate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>

namespace facetmill::sample {

namespace {

/// Closes every plane border loop with facets from the middle of its corners; ends are star-shaped from
/// there.
void close_ends(Mesh& mesh, const std::vector<double>& ends) {
    std::set<std::pair<Index, Index>> border;
    for (const Facet& f : mesh.facets)
        for (std::size_t k = 0; k < 3; ++k)
            if (border.erase({f[(k + 1) % 3], f[k]}) == 0) border.insert({f[k], f[(k + 1) % 3]});
    for (const double x : ends) {
        const Index middle = Index(mesh.vertices.size());
        mesh.vertices.push_back({x, 0.0, 0.0});
        for (const auto& [from, to] : border)
            if (mesh.vertices[from].x() == x && mesh.vertices[to].x() == x)
                mesh.facets.push_back({to, from, middle});
    }
}

} // namespace

Mesh square_prism() {
    constexpr double half = 25.0, length = 40.0;
    Mesh mesh;
    for (const double x : {0.0, length})
        mesh.vertices.insert(mesh.vertices.end(),
                             {{x, -half, -half}, {x, half, -half}, {x, half, half}, {x, -half, half}});
    mesh.facets = {{0, 3, 2}, {0, 2, 1}, {4, 5, 6}, {4, 6, 7}};
    for (Index k = 0; k < 4; ++k) {
        const Index next = (k + 1) % 4;
        mesh.facets.push_back({k, next, next + 4});
        mesh.facets.push_back({k, next + 4, k + 4});
    }
    return mesh;
}

Mesh cylinder(double tolerance) {
    constexpr double radius = 20.0, length = 25.0;
    // Sagitta of a chord over the angle 2 pi / n: r (1 - cos(pi / n)) = 2 r sin^2(pi / 2n). Strips from end
    // to end, as CAD systems write them; a multiple of four keeps the outermost points.
    const double half_angle = std::asin(std::min(1.0, std::sqrt(tolerance / (2.0 * radius))));
    const double wanted = pi / (2.0 * half_angle);
    if (!(4.0 * wanted < double(sample_facet_limit))) throw_too_many_facets("cylinder");
    const Index n = std::max(Index(12), 4 * Index(std::ceil(wanted / 4.0)));
    Mesh mesh;
    for (const double x : {0.0, length})
        for (Index i = 0; i < n; ++i) {
            // By quarters, so that the points on the axes are exact.
            const double angle = 2.0 * pi * (i % (n / 4)) / n, c = radius * std::cos(angle),
                         s = radius * std::sin(angle);
            const std::array<Vec3, 4> quarter{Vec3(x, c, s), Vec3(x, -s, c), Vec3(x, -c, -s), Vec3(x, s, -c)};
            mesh.vertices.push_back(quarter[i / (n / 4)]);
        }
    for (Index i = 0; i < n; ++i) {
        const Index next = (i + 1) % n;
        mesh.facets.push_back({i, next, next + n});
        mesh.facets.push_back({i, next + n, i + n});
    }
    close_ends(mesh, {0.0, length});
    return mesh;
}

Mesh twisted_prism(double tolerance, const Progress& progress) {
    constexpr double half = 22.5, length = 60.0, twist = pi / 2.0;
    constexpr int cells = 2;
    // a runs round the section, one unit a side; b is x.
    const PatchFunction side = [](double a, double b) {
        const int k = int(a) % 4;
        const double along = half * (2.0 * (a - std::floor(a)) - 1.0),
                     angle = k * pi / 2.0 + twist * b / length;
        const double c = std::cos(angle), s = std::sin(angle);
        return Vec3(b, half * c - along * s, half * s + along * c);
    };
    PatchGrid grid;
    grid.closed_a = true;
    for (int i = 0; i <= 4 * cells; ++i)
        grid.a.push_back(double(i) / cells);
    for (int i = 0; i <= 3; ++i)
        grid.b.push_back(length * i / 3);
    Mesh mesh = tessellate_patch(side, grid, tolerance, "twisted-prism", progress);
    close_ends(mesh, {0.0, length});
    return mesh;
}

namespace {

/// A cylinder about X whose radius is radius(angle, x), of the given cells around and along.
Mesh turned(const std::function<double(double, double)>& radius, double length, int around, int along,
            double tolerance, const std::string& what, const Progress& progress) {
    const PatchFunction side = [&](double a, double b) {
        const double angle = 2.0 * pi * a / around;
        const double r = radius(angle, b);
        return Vec3(b, r * std::cos(angle), r * std::sin(angle));
    };
    PatchGrid grid;
    grid.closed_a = true;
    for (int i = 0; i <= around; ++i)
        grid.a.push_back(i);
    for (int i = 0; i <= along; ++i)
        grid.b.push_back(length * i / along);
    Mesh mesh = tessellate_patch(side, grid, tolerance, what, progress);
    close_ends(mesh, {0.0, length});
    return mesh;
}

/// From 0 to 1 over 0 <= t <= 1, level at both ends.
double eased(double t) {
    return 0.5 - 0.5 * std::cos(pi * std::clamp(t, 0.0, 1.0));
}

} // namespace

Mesh extruded_pattern(double tolerance, const Progress& progress) {
    // Six pads around and three along, raised by 1 mm; flanks 4 mm wide, so that a ball of radius 1.5875 mm
    // reaches their feet.
    constexpr double base = 20.0, length = 54.0, raised = 1.0, flank = 4.0;
    constexpr int around = 6, along = 3;
    const auto pad = [](double at, double cell) { // across one cell, 0 at its borders
        const double inside = std::min(at, cell - at) - 1.0;
        return eased(inside / flank);
    };
    const auto radius = [&](double angle, double x) {
        const double cell_a = 2.0 * pi * base / around, cell_x = length / along;
        const double a = base * angle, in_a = a - cell_a * std::floor(a / cell_a),
                     in_x = x - cell_x * std::min(std::floor(x / cell_x), along - 1.0);
        return base + raised * pad(in_a, cell_a) * pad(in_x, cell_x);
    };
    return turned(radius, length, 4 * around, 4 * along, tolerance, "extruded-pattern", progress);
}

Mesh swept_pattern(double tolerance, const Progress& progress) {
    // Three round ribs that wind around the cylinder once in 54 mm.
    constexpr double base = 20.0, length = 54.0, raised = 1.5, strands = 3.0;
    const auto radius = [&](double angle, double x) {
        const double rib = 0.5 + 0.5 * std::cos(strands * (angle - 2.0 * pi * x / length));
        return base + raised * rib * rib;
    };
    return turned(radius, length, 24, 12, tolerance, "swept-pattern", progress);
}

} // namespace facetmill::sample
