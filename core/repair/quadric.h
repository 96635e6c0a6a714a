// Quadric error metrics (Garland, Heckbert, "Surface simplification using quadric error metrics", 1997).
// Internal to the room.
#pragma once

#include "core/base/vec.h"

#include <algorithm>

namespace facetmill::detail {

/// Sum of squared distances from planes, weighed by area: p A p + 2 b p + c.
struct Quadric {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    Vec3 b = Vec3::Zero();
    double c = 0;

    void add_plane(const Vec3& n, double d, double weight) {
        xx += weight * n.x() * n.x();
        xy += weight * n.x() * n.y();
        xz += weight * n.x() * n.z();
        yy += weight * n.y() * n.y();
        yz += weight * n.y() * n.z();
        zz += weight * n.z() * n.z();
        b += weight * d * n;
        c += weight * d * d;
    }
    void add(const Quadric& q) {
        xx += q.xx;
        xy += q.xy;
        xz += q.xz;
        yy += q.yy;
        yz += q.yz;
        zz += q.zz;
        b += q.b;
        c += q.c;
    }
    Mat3 matrix() const {
        Mat3 m;
        m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
        return m;
    }
    double at(const Vec3& p) const { return std::max(0.0, p.dot(matrix() * p) + 2 * b.dot(p) + c); }
};

} // namespace facetmill::detail
