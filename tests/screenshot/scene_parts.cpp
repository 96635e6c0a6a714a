#include "tests/screenshot/scene_parts.h"

#include <cmath>

namespace facetmill::test {

MeshPtr box_part(const Vec3& lo, const Vec3& hi) {
    auto mesh = std::make_shared<Mesh>();
    for (int c = 0; c < 8; ++c)
        mesh->vertices.emplace_back(c & 1 ? hi.x() : lo.x(), c & 2 ? hi.y() : lo.y(),
                                    c & 4 ? hi.z() : lo.z());
    mesh->facets = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

MeshPtr sheet_part(const Vec2& lo, const Vec2& hi, int n,
                   const std::function<double(double, double)>& height) {
    auto mesh = std::make_shared<Mesh>();
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = lo.x() + (hi.x() - lo.x()) * i / n, y = lo.y() + (hi.y() - lo.y()) * j / n;
            mesh->vertices.emplace_back(x, y, height(x, y));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Index a = Index(j * (n + 1) + i), b = a + 1, c = a + Index(n) + 1, d = c + 1;
            mesh->facets.push_back({a, b, d});
            mesh->facets.push_back({a, d, c});
        }
    return mesh;
}

MeshPtr moved(const MeshPtr& mesh, const Vec3& by) {
    auto copy = std::make_shared<Mesh>(*mesh);
    for (Vec3& v : copy->vertices)
        v += by;
    return copy;
}

double hill(double x, double y) {
    return 18 * std::exp(-((x - 55) * (x - 55) + (y - 38) * (y - 38)) / 900);
}

MeshPtr hill_part() {
    return sheet_part({0, 0}, {hill_length, hill_width}, 40, hill);
}

PathSource hill_path(int passes, int points, double ball_radius) {
    auto path = std::make_shared<StrategyResult>();
    auto tool = std::make_shared<ToolMotions>();
    tool->clearance_z = 30;
    const Vec3 axis(0, 0, 1);
    for (int i = 0; i < passes; ++i) {
        Pass pass;
        pass.drive = i;
        pass.offset = hill_width * i / (passes - 1);
        for (int j = 0; j < points; ++j) {
            const double x = hill_length * (i % 2 ? points - 1 - j : j) / (points - 1), y = pass.offset;
            const double z = hill(x, y), dx = -z * (x - 55) / 450, dy = -z * (y - 38) / 450;
            const Vec3 p(x, y, z), n = Vec3(-dx, -dy, 1).normalized();
            pass.cc.push_back({p, n});
            pass.cl.push_back({p + ball_radius * n - ball_radius * axis, axis});
        }
        path->passes.push_back(pass);
    }
    auto& motions = tool->motions;
    const auto high = [&](const CutterLocation& l) {
        return CutterLocation{Vec3(l.tip.x(), l.tip.y(), tool->clearance_z), axis};
    };
    const auto near = [&](const CutterLocation& l) { return CutterLocation{l.tip + 6 * axis, axis}; };
    for (int i = 0; i < passes; ++i) {
        const auto& cl = path->passes[std::size_t(i)].cl;
        if (i == 0 || i == passes / 2) {
            if (i > 0) {
                const CutterLocation from = motions.back().to;
                motions.push_back({MotionKind::retract, near(from)});
                motions.push_back({MotionKind::rapid, high(from)});
            }
            motions.push_back({MotionKind::rapid, high(cl.front())});
            motions.push_back({MotionKind::rapid, near(cl.front())});
            motions.push_back({MotionKind::approach, cl.front(), Index(i), 0});
        } else {
            motions.push_back({MotionKind::link, cl.front(), Index(i), 0});
        }
        for (std::size_t j = 1; j < cl.size(); ++j)
            motions.push_back({MotionKind::cut, cl[j], Index(i), Index(j)});
    }
    const CutterLocation last = motions.back().to;
    motions.push_back({MotionKind::retract, near(last)});
    motions.push_back({MotionKind::rapid, high(last)});
    return {path, tool};
}

} // namespace facetmill::test
