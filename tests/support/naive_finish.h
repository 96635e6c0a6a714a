// A naive check of finishing passes of an upright tool: points of the part asked one by one whether they lie
// inside the cutter anywhere on the path, and whether it came near enough to them.
#pragma once

#include "core/mesh/box_tree.h"
#include "core/strategy/plan/path.h"
#include "tests/support/brute_lift.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace facetmill::test {

/// A closed cone on z = 0.
inline Mesh cone_of(double radius, double height, int around) {
    Mesh m;
    m.vertices.emplace_back(0, 0, height);
    m.vertices.emplace_back(0, 0, 0);
    for (int k = 0; k < around; ++k)
        m.vertices.emplace_back(radius * std::cos(2 * pi * k / around),
                                radius * std::sin(2 * pi * k / around), 0);
    for (int k = 0; k < around; ++k) {
        const auto a = Index(2 + k), b = Index(2 + (k + 1) % around);
        m.facets.push_back({0, a, b});
        m.facets.push_back({1, b, a});
    }
    return m;
}

/// Is the point deeper than `limit` inside the cutter, endless upward, with its tip there?
inline bool holds(const BruteCutter& cutter, const Vec3& tip, const Vec3& p, double limit) {
    const double z = p.z() - tip.z() - limit, rho = (p - tip).head<2>().norm() + limit;
    return z > 0 && rho < double(cutter.radius()) && z > double(cutter.height(rho));
}

/// Places of the tip along all passes, no farther apart than `spacing`.
inline std::vector<Vec3> tips_of(const StrategyResult& path, double spacing) {
    std::vector<Vec3> tips;
    for (const Pass& pass : path.passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i) {
            const Vec3 &a = pass.cl[i - 1].tip, &b = pass.cl[i].tip;
            const int n = std::max(1, int(std::ceil((b - a).norm() / spacing)));
            for (int k = 0; k <= n; ++k)
                tips.push_back(a + double(k) / n * (b - a));
        }
    return tips;
}

struct PartSample {
    Vec3 p, normal;
};
inline std::vector<PartSample> part_samples(const Mesh& mesh, double spacing) {
    std::vector<PartSample> all;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        const Vec3 a = mesh.corner(f, 0), u = mesh.corner(f, 1) - a, v = mesh.corner(f, 2) - a;
        const int n = 1 + int(std::max({u.norm(), v.norm(), (u - v).norm()}) / spacing);
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j)
                all.push_back({a + double(i) / n * u + double(j) / n * v, mesh.facet_normal(f)});
    }
    return all;
}

/// Of which tips a point may lie inside.
class TipTree {
public:
    TipTree(const std::vector<Vec3>& tips, double radius) : tips_(tips) {
        std::vector<Box3> boxes(tips.size());
        for (std::size_t i = 0; i < tips.size(); ++i) {
            boxes[i].add(tips[i] - Vec3(radius, radius, 0));
            boxes[i].add(tips[i] + Vec3(radius, radius, 1e4));
        }
        tree_ = BoxTree(boxes, Progress());
    }
    template <class Is>
    bool any(const Vec3& p, Is&& is) const {
        bool found = false;
        tree_.each([&](const Box3& box) { return !found && squared_distance(box, p) == 0; },
                   [&](std::size_t i) { found = found || is(tips_[i]); });
        return found;
    }

private:
    const std::vector<Vec3>& tips_;
    BoxTree tree_;
};

struct Naive {
    std::size_t gouged = 0, judged = 0, high = 0;
};
/// `steep`: which places are judged for what stays over them.
template <class Steep>
Naive naive_check(const Mesh& mesh, const StrategyResult& path, const Tool& tool, double tolerance,
                  Steep&& steep) {
    const BruteCutter cutter(tool.cutter());
    const std::vector<Vec3> tips = tips_of(path, 0.15);
    const TipTree tree(tips, double(cutter.radius()));
    Naive found;
    for (const PartSample& s : part_samples(mesh, 0.45)) {
        found.gouged += tree.any(
            s.p, [&](const Vec3& tip) { return holds(cutter, tip, s.p, path.chord_tolerance + 1e-7); });
        if (!steep(s)) continue;
        ++found.judged;
        const Vec3 over = s.p + (1.1 * tolerance + 1e-3) * s.normal;
        found.high += !tree.any(over, [&](const Vec3& tip) { return holds(cutter, tip, over, 0); });
    }
    return found;
}

} // namespace facetmill::test
