// Jobs and parts that the tests of the verdict share.
#pragma once

#include "core/verify/verify.h"
#include "tests/support/part_meshes.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace facetmill::test {

inline StockSolid stock_of(const Box3& box) {
    StockSolid stock;
    stock.box = box;
    return stock;
}

/// Lines along X over a rectangle, at one height, `step` apart, with an end 2 mm beyond it.
inline VerifyProgram lines(const Tool& tool, const Vec2& lo, const Vec2& hi, double z, double step) {
    auto motions = std::make_shared<ToolMotions>();
    const auto to = [&](MotionKind kind, const Vec3& tip) {
        motions->motions.push_back({kind, {tip, Vec3::UnitZ()}, no_index, no_index});
    };
    to(MotionKind::rapid, Vec3(lo.x() - 20, lo.y(), z + 40));
    bool back = false;
    for (double y = lo.y(); y <= hi.y() + 1e-9; y += step, back = !back) {
        const double from = back ? hi.x() + 2 : lo.x() - 2, end = back ? lo.x() - 2 : hi.x() + 2;
        to(MotionKind::cut, Vec3(from, y, z));
        to(MotionKind::cut, Vec3(end, y, z));
    }
    return {"Lines", VerifyTool(tool), motions, std::nullopt};
}

inline VerifySettings asked(double tolerance = 0.05) {
    VerifySettings s;
    s.resolution = s.sample_spacing = 0.5;
    s.tolerance = tolerance;
    s.gouge_limit = 0.005;
    return s;
}

inline Verification judged(const Mesh& part, const StockSolid& stock, const VerifyProgram& program,
                           const VerifySettings& settings = asked()) {
    return verify(part, stock, {&program, 1}, settings, Progress());
}

inline const UncutReason* reason(const Verification& v, UncutReason::Why why) {
    for (const UncutReason& r : v.uncut)
        if (r.why == why) return &r;
    return nullptr;
}

/// What has this outline (y, z) over 60 mm along X, closed; its ends as these quads.
inline Mesh prism(const std::vector<Vec2>& outline, const std::vector<std::array<Index, 4>>& ends) {
    Mesh mesh;
    const auto n = Index(outline.size());
    for (double x : {-30.0, 30.0})
        for (const Vec2& p : outline)
            mesh.vertices.push_back(Vec3(x, p.x(), p.y()));
    for (Index i = 0; i < n; ++i) {
        const Index j = (i + 1) % n;
        mesh.facets.push_back({i, i + n, j});
        mesh.facets.push_back({j, i + n, j + n});
    }
    for (const auto& quad : ends) {
        mesh.facets.push_back({quad[0], quad[1], quad[2]});
        mesh.facets.push_back({quad[0], quad[2], quad[3]});
        mesh.facets.push_back({quad[0] + n, quad[2] + n, quad[1] + n});
        mesh.facets.push_back({quad[0] + n, quad[3] + n, quad[2] + n});
    }
    return mesh;
}

/// A block with a groove along X of width `wide` and depth `deep` in its top.
inline Mesh grooved(double wide, double deep) {
    const double w = 0.5 * wide;
    return prism({{-20, -10}, {20, -10}, {20, 0}, {w, 0}, {w, -deep}, {-w, -deep}, {-w, 0}, {-20, 0}},
                 {{0, 5, 6, 7}, {0, 1, 4, 5}, {1, 2, 3, 4}});
}

} // namespace facetmill::test
