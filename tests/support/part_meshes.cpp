#include "tests/support/part_meshes.h"

#include "core/base/units.h"

#include <array>
#include <cmath>
#include <map>

namespace facetmill::test {

Mesh height_field(const std::function<double(double, double)>& f, const Vec2& lo, const Vec2& hi, int nx,
                  int ny) {
    Mesh m;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) {
            const double x = lo.x() + (hi.x() - lo.x()) * i / nx, y = lo.y() + (hi.y() - lo.y()) * j / ny;
            m.vertices.emplace_back(x, y, f(x, y));
        }
    const auto at = [&](int i, int j) { return Index(j * (nx + 1) + i); };
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            m.facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            m.facets.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return m;
}

Mesh only(const Mesh& mesh, const std::function<bool(const Vec3&)>& keep) {
    Mesh m;
    m.vertices = mesh.vertices;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        if (keep((mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3))
            m.facets.push_back(mesh.facets[f]);
    return m;
}

Mesh turned(const Mesh& mesh, double angle_about_z) {
    Mesh m = mesh;
    const Eigen::AngleAxisd turn(angle_about_z, Vec3::UnitZ());
    for (Vec3& v : m.vertices)
        v = turn * v;
    return m;
}

Mesh box(const Vec3& lo, const Vec3& hi) {
    Mesh m;
    for (int k = 0; k < 8; ++k)
        m.vertices.emplace_back(k & 1 ? hi.x() : lo.x(), k & 2 ? hi.y() : lo.y(), k & 4 ? hi.z() : lo.z());
    m.facets = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return m;
}

Mesh step(double low, double high) {
    Mesh m;
    const double y[4] = {-15, 0, 0, 15}, z[4] = {high, high, low, low};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i <= 4; ++i)
            m.vertices.emplace_back(-20 + 10 * i, y[j], z[j]);
    for (Index j = 0; j < 3; ++j)
        for (Index i = 0; i < 4; ++i) {
            const Index a = j * 5 + i;
            m.facets.push_back({a, a + 1, a + 6});
            m.facets.push_back({a, a + 6, a + 5});
        }
    return m;
}

Mesh dome(double radius, int rings) {
    Mesh m;
    const int around = 4 * rings;
    m.vertices.emplace_back(0, 0, radius);
    for (int r = 1; r <= rings; ++r)
        for (int k = 0; k < around; ++k) {
            const double theta = 0.5 * pi * r / rings, phi = 2 * pi * k / around;
            m.vertices.emplace_back(radius * std::sin(theta) * std::cos(phi),
                                    radius * std::sin(theta) * std::sin(phi),
                                    r == rings ? 0 : radius * std::cos(theta));
        }
    m.vertices.emplace_back(0, 0, 0);
    const auto at = [&](int r, int k) { return Index(1 + (r - 1) * around + k % around); };
    const Index middle = Index(m.vertices.size() - 1);
    for (int k = 0; k < around; ++k) {
        m.facets.push_back({0, at(1, k), at(1, k + 1)});
        for (int r = 1; r < rings; ++r) {
            m.facets.push_back({at(r, k), at(r + 1, k), at(r + 1, k + 1)});
            m.facets.push_back({at(r, k), at(r + 1, k + 1), at(r, k + 1)});
        }
        m.facets.push_back({middle, at(rings, k + 1), at(rings, k)});
    }
    return m;
}

Tool ball_tool(double diameter) {
    return bull_tool(diameter, 0.5 * diameter);
}
Tool flat_tool(double diameter) {
    return bull_tool(diameter, 0);
}

Tool bull_tool(double diameter, double corner) {
    Tool t;
    t.diameter = t.shank_diameter = diameter;
    t.corner_radius = corner;
    t.flute_length = 60;
    return t;
}

std::vector<ShapedTool> tools_of_every_shape() {
    Tool cone;
    cone.diameter = cone.shank_diameter = 6;
    cone.corner_radius = 0.5;
    cone.taper_angle = radians(20);
    cone.flute_length = 12;
    return {{"ball", ball_tool(6)}, {"flat", flat_tool(6)}, {"bull", bull_tool(6, 1.5)}, {"cone", cone}};
}

Mesh mixed() {
    const auto f = [](double x, double y) {
        return 2 * std::sin(0.2 * x) * std::cos(0.15 * y) + (x > 8 ? 3 : 0);
    };
    return only(height_field(f, Vec2(-20, -15), Vec2(20, 15), 80, 60),
                [](const Vec3& p) { return std::hypot(p.x() + 8, p.y()) > 4; });
}

double HollowedBlock::hollow_volume() {
    return pi * radius * radius * depth / 3; // the integral of `deep` below over its circle
}

Mesh HollowedBlock::mesh() {
    constexpr int n = 48;
    const Vec3 all = size();
    // Level at its middle and at its rim.
    const auto deep = [](double r) {
        const double s = r / radius;
        return s < 1 ? depth * (1 - s * s) * (1 - s * s) : 0;
    };
    Mesh mesh;
    std::map<std::array<double, 3>, Index> known;
    const auto vertex = [&](const Vec3& p) {
        const auto [at, is_new] = known.try_emplace({p.x(), p.y(), p.z()}, Index(mesh.vertices.size()));
        if (is_new) mesh.vertices.push_back(p);
        return at->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto point = [&](int i, int j) {
                Vec3 p;
                p[u] = all[u] * i / n;
                p[v] = all[v] * j / n;
                const double down = deep(std::hypot(p[u] - all[u] / 2, p[v] - all[v] / 2));
                p[axis] = high ? all[axis] - down : down;
                return vertex(p);
            };
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const Index a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1),
                                d = point(i, j + 1);
                    for (Facet f : {Facet{a, b, c}, Facet{a, c, d}}) {
                        if (!high) std::swap(f[1], f[2]);
                        mesh.facets.push_back(f);
                    }
                }
        }
    return mesh;
}

} // namespace facetmill::test
