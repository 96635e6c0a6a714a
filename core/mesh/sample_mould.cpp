// A mould cavity with sharp inner corners whose valleys are known: a block with a rectangular pocket, and a
// boss on the pocket's floor; all walls lean by the draft.
#include "core/mesh/sample_mould.h"

#include "core/mesh/sample_parts.h"
#include "core/mesh/sample_tessellate.h"

#include <array>
#include <cmath>

namespace facetmill::sample {

namespace {

/// Facets have edges of about this many chord tolerances: the part is flat, so the tolerance asks for
/// nothing.
constexpr double edge_per_tolerance = 40;
constexpr double cavity_depth = 20, boss_height = 12;

struct Level {
    Vec2 middle, half;
    double z;
    Vec3 corner(int k) const {
        const double x = k == 0 || k == 3 ? -half.x() : half.x(), y = k < 2 ? -half.y() : half.y();
        return {middle.x() + x, middle.y() + y, z};
    }
};

/// From outside in, counter-clockwise from the lower left: block, opening, floor, foot and top of the boss.
std::array<Level, 5> levels() {
    const double lean = std::tan(mould_draft);
    const Vec2 opening(40, 30), top(14, 8), boss(6, -4);
    return {{{Vec2(0, 0), Vec2(50, 40), 0},
             {Vec2(0, 0), opening, 0},
             {Vec2(0, 0), opening - Vec2::Constant(cavity_depth * lean), -cavity_depth},
             {boss, top + Vec2::Constant(boss_height * lean), -cavity_depth},
             {boss, top, boss_height - cavity_depth}}};
}

} // namespace

std::vector<std::vector<Vec3>> mould_valleys() {
    const auto level = levels();
    std::vector<std::vector<Vec3>> valleys;
    for (const std::size_t foot : {2, 3}) {
        std::vector<Vec3> loop;
        for (int k = 0; k <= 4; ++k)
            loop.push_back(level[foot].corner(k % 4));
        valleys.push_back(std::move(loop));
    }
    for (int k = 0; k < 4; ++k)
        valleys.push_back({level[1].corner(k), level[2].corner(k)});
    return valleys;
}

Mesh mould(double tolerance) {
    const auto level = levels();
    const double edge = edge_per_tolerance * tolerance;
    const auto cells = [&](double length) { return std::max(1.0, std::ceil(length / edge)); };
    const double wide = cells(2 * level[0].half.x()), high = cells(2 * level[0].half.y());
    double rows = 0;
    std::array<double, 4> row_count{};
    for (std::size_t i = 0; i < 4; ++i) {
        double width = 0;
        for (int k = 0; k < 4; ++k)
            width = std::max(width, (level[i].corner(k) - level[i + 1].corner(k)).norm());
        rows += row_count[i] = cells(width);
    }
    if (4 * (wide + high) * rows + 2 * wide * high > double(sample_facet_limit))
        throw_too_many_facets("mould");

    Mesh mesh;
    const int nx = int(wide), ny = int(high), around = 2 * (nx + ny);
    const auto add_loop = [&](const std::array<Vec3, 4>& corner) {
        for (int side = 0; side < 4; ++side) {
            const int n = side % 2 == 0 ? nx : ny;
            const Vec3 &a = corner[std::size_t(side)], &b = corner[std::size_t((side + 1) % 4)];
            for (int i = 0; i < n; ++i)
                mesh.vertices.push_back(a + (double(i) / n) * (b - a));
        }
    };
    const auto corners = [](const Level& l) {
        return std::array<Vec3, 4>{l.corner(0), l.corner(1), l.corner(2), l.corner(3)};
    };
    add_loop(corners(level[0]));
    int loop = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const int n = int(row_count[i]);
        for (int r = 1; r <= n; ++r) {
            std::array<Vec3, 4> at;
            for (int k = 0; k < 4; ++k) {
                const Vec3 a = level[i].corner(k), b = level[i + 1].corner(k);
                at[std::size_t(k)] = r == n ? b : Vec3(a + (double(r) / n) * (b - a));
            }
            add_loop(at);
            for (int k = 0; k < around; ++k) {
                const auto p = Index(loop * around + k), q = Index(loop * around + (k + 1) % around);
                const Index up = Index(around);
                mesh.facets.push_back({p, q, q + up});
                mesh.facets.push_back({p, q + up, p + up});
            }
            ++loop;
        }
    }
    // The boss's top: a grid whose border is the last loop.
    const Level& top = level[4];
    const auto on_border = [&](int i, int j) {
        const int k = j == 0 ? i : i == nx ? nx + j : j == ny ? 2 * nx + ny - i : around - j;
        return Index(loop * around + k % around);
    };
    std::vector<Index> inner(std::size_t(nx + 1) * std::size_t(ny + 1));
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) {
            Index& at = inner[std::size_t(j) * std::size_t(nx + 1) + std::size_t(i)];
            if (i == 0 || j == 0 || i == nx || j == ny) {
                at = on_border(i, j);
                continue;
            }
            at = Index(mesh.vertices.size());
            mesh.vertices.push_back(Vec3(top.middle.x() + top.half.x() * (2.0 * i / nx - 1),
                                         top.middle.y() + top.half.y() * (2.0 * j / ny - 1), top.z));
        }
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const auto at = [&](int x, int y) {
                return inner[std::size_t(y) * std::size_t(nx + 1) + std::size_t(x)];
            };
            mesh.facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.facets.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

} // namespace facetmill::sample
