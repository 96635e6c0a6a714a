#include "core/verify/winding_number.h"

#include <cmath>

namespace facetmill {

double winding_number(const Mesh& mesh, const Vec3& p, const Progress& progress) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % 65536 == 0) progress.check();
        const Vec3 a = mesh.corner(f, 0) - p, b = mesh.corner(f, 1) - p, c = mesh.corner(f, 2) - p;
        const double x = a.norm(), y = b.norm(), z = c.norm();
        sum += std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
    }
    return sum / (2 * pi);
}

} // namespace facetmill
