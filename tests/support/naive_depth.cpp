#include "tests/support/naive_depth.h"

#include "tests/support/brute_lift.h"

#include <algorithm>
#include <cmath>

namespace facetmill::test {

double deepest(const ClSection& program, const Tool& tool, const std::vector<Vec3>& points) {
    const BruteCutter cutter(program.cutter);
    const double radius = double(cutter.radius()), flutes = program.cutter.h;
    const double widest = std::max({radius, 0.5 * tool.shank_diameter, 0.5 * tool.holder[0].diameter}),
                 length = flutes + tool.shank_length + 20;
    Box3 box;
    for (const Vec3& p : points)
        box.add(p);
    double most = 0;
    const auto look = [&](const CutterLocation& at) {
        const Vec3 middle = at.tip + 0.5 * length * at.axis;
        const double far = 0.5 * length + widest;
        if (((middle - box.lo).array() < -far).any() || ((middle - box.hi).array() > far).any()) return;
        for (const Vec3& p : points) {
            const Vec3 d = p - at.tip;
            const double z = d.dot(at.axis), square = d.squaredNorm() - z * z;
            if (z <= 0 || z >= length || square >= widest * widest) continue;
            const double rho = std::sqrt(std::max(square, 0.0));
            const auto barrel = [&](double r, double from, double to) {
                if (rho < r && z > from && z < to)
                    most = std::max(most, std::min({r - rho, z - from, to - z}));
            };
            if (z > 0 && z < flutes && rho < radius && z > double(cutter.height(rho)))
                most = std::max(most, std::min(z - double(cutter.height(rho)), radius - rho));
            barrel(0.5 * tool.shank_diameter, flutes, flutes + tool.shank_length);
            barrel(0.5 * tool.holder[0].diameter, flutes + tool.shank_length, length);
        }
    };
    const auto& motions = program.motions.motions;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        look(motions[i].to);
        if (i == 0 || program.motions.turning) continue;
        const CutterLocation &a = motions[i - 1].to, &b = motions[i].to;
        const int steps = std::min(int((b.tip - a.tip).norm() / 0.3), 400);
        for (int k = 1; k < steps; ++k) {
            const double t = double(k) / steps;
            look({a.tip + t * (b.tip - a.tip), (a.axis + t * (b.axis - a.axis)).normalized()});
        }
    }
    return most;
}

} // namespace facetmill::test
