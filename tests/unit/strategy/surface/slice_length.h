// The length of a slice, facet by facet.
#pragma once

#include "core/mesh/mesh.h"
#include "core/strategy/surface/drive_frame.h"

#include <vector>

namespace facetmill::test {

/// Length of the cut of each facet by itself, summed.
inline double length_by_facet(const Mesh& mesh, double offset, const DriveFrame& frame) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        std::vector<Vec3> cut;
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = mesh.corner(f, k), q = mesh.corner(f, (k + 1) % 3);
            const double a = frame.v(p) - offset, b = frame.v(q) - offset;
            if ((a >= 0) != (b >= 0)) cut.push_back(p + (q - p) * (a / (a - b)));
        }
        if (cut.size() == 2) sum += (cut[1] - cut[0]).norm();
    }
    return sum;
}

} // namespace facetmill::test
