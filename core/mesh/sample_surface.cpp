#include "core/mesh/sample_surface.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"

#include <cmath>

namespace facetmill {

namespace {

/// Lagrange polynomials of n places i / (n - 1) at u, with first and second derivatives.
struct Blend {
    double value[4] = {}, d1[4] = {}, d2[4] = {};
};

Blend blend(std::size_t n, double u) {
    Blend b;
    for (std::size_t i = 0; i < n; ++i) {
        double value = 1.0, d1 = 0.0, d2 = 0.0;
        for (std::size_t j = 0; j < n; ++j) {
            if (j == i) continue;
            const double slope = double(n - 1) / (double(i) - double(j));
            const double factor = (u - double(j) / double(n - 1)) * slope;
            d2 = d2 * factor + 2.0 * d1 * slope;
            d1 = d1 * factor + value * slope;
            value *= factor;
        }
        b.value[i] = value;
        b.d1[i] = d1;
        b.d2[i] = d2;
    }
    return b;
}

} // namespace

LoftedSurface::LoftedSurface(std::vector<Section> sections) : sections_(std::move(sections)) {
    const std::size_t n = sections_.size();
    bool good = n >= 2 && n <= 4 && sections_.back().x > sections_.front().x;
    for (std::size_t i = 1; good && i + 1 < n; ++i) {
        const double even =
            sections_.front().x + (sections_.back().x - sections_.front().x) * double(i) / double(n - 1);
        good = std::abs(sections_[i].x - even) < tolerance::smallest_extent;
    }
    if (!good)
        throw Error(ErrorCode::internal, "lofted surface", "the sections do not stand at equal distances",
                    "give two to four sections at increasing, equally spaced X");
}

Vec3 LoftedSurface::point(double u, double v) const {
    const Blend b = blend(sections_.size(), u);
    Vec2 yz = Vec2::Zero();
    for (std::size_t i = 0; i < sections_.size(); ++i)
        yz += b.value[i] * sections_[i].curve.point(v);
    const double x0 = sections_.front().x, x1 = sections_.back().x;
    return {(1.0 - u) * x0 + u * x1, yz.x(), yz.y()};
}

SurfacePoint LoftedSurface::evaluate(double u, double v) const {
    const Blend b = blend(sections_.size(), u);
    Vec2 s = Vec2::Zero(), su = s, sv = s, suu = s, suv = s, svv = s;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        const CurvePoint2 c = sections_[i].curve.evaluate(v);
        s += b.value[i] * c.point;
        su += b.d1[i] * c.point;
        suu += b.d2[i] * c.point;
        sv += b.value[i] * c.d1;
        suv += b.d1[i] * c.d1;
        svv += b.value[i] * c.d2;
    }
    const double x0 = sections_.front().x, x1 = sections_.back().x;
    SurfacePoint r;
    r.point = {(1.0 - u) * x0 + u * x1, s.x(), s.y()};
    r.du = {x1 - x0, su.x(), su.y()};
    r.dv = {0.0, sv.x(), sv.y()};
    r.duu = {0.0, suu.x(), suu.y()};
    r.duv = {0.0, suv.x(), suv.y()};
    r.dvv = {0.0, svv.x(), svv.y()};
    r.normal = r.du.cross(r.dv).normalized();
    return r;
}

std::optional<Vec2> LoftedSurface::parameters_over(double x, double y) const {
    const double x0 = sections_.front().x, x1 = sections_.back().x;
    const double u = (x - x0) / (x1 - x0);
    if (!(u >= 0.0 && u <= 1.0)) return std::nullopt;
    double lo = 0.0, hi = 1.0;
    if (!(y >= point(u, lo).y() && y <= point(u, hi).y())) return std::nullopt;
    // Newton's method kept inside a bracket that shrinks every time: y grows with v.
    double v = 0.5;
    for (int step = 0; step < 100; ++step) {
        const SurfacePoint s = evaluate(u, v);
        const double off = s.point.y() - y;
        if (off == 0.0) break;
        (off > 0.0 ? hi : lo) = v;
        double next = v - off / s.dv.y();
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        if (next == v) break;
        v = next;
    }
    return Vec2(u, v);
}

std::optional<double> LoftedSurface::height(double x, double y) const {
    const auto uv = parameters_over(x, y);
    if (!uv) return std::nullopt;
    return point(uv->x(), uv->y()).z();
}

Vec2 LoftedSurface::nearest_parameters(const Vec3& p) const {
    // The best point of a coarse grid, then Newton's method on the squared distance inside [0, 1]^2, halving
    // steps that do not come nearer.
    constexpr int cells = 64;
    Vec2 best(0.0, 0.0);
    double best_distance = infinity;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j) {
            const Vec2 uv(double(i) / cells, double(j) / cells);
            const double d = (point(uv.x(), uv.y()) - p).squaredNorm();
            if (d < best_distance) {
                best_distance = d;
                best = uv;
            }
        }
    for (int step = 0; step < 50; ++step) {
        const SurfacePoint s = evaluate(best.x(), best.y());
        const Vec3 off = s.point - p;
        Vec2 gradient(off.dot(s.du), off.dot(s.dv));
        const double guu = s.du.squaredNorm(), gvv = s.dv.squaredNorm();
        Eigen::Matrix2d h;
        h(0, 0) = guu + off.dot(s.duu);
        h(0, 1) = h(1, 0) = s.du.dot(s.dv) + off.dot(s.duv);
        h(1, 1) = gvv + off.dot(s.dvv);
        // Not convex here: Gauss-Newton's matrix always descends.
        if (!(h(0, 0) > 0.0 && h.determinant() > 0.0)) {
            h(0, 0) = guu;
            h(0, 1) = h(1, 0) = s.du.dot(s.dv);
            h(1, 1) = gvv;
        }
        // A coordinate that sits on the border and is pushed out of it stays there; the other one moves
        // alone.
        bool held[2];
        for (int k = 0; k < 2; ++k)
            held[k] = (best[k] <= 0.0 && gradient[k] > 0.0) || (best[k] >= 1.0 && gradient[k] < 0.0);
        Vec2 move = Vec2::Zero();
        if (!held[0] && !held[1])
            move = -h.inverse() * gradient;
        else if (!held[0])
            move.x() = -gradient.x() / h(0, 0);
        else if (!held[1])
            move.y() = -gradient.y() / h(1, 1);
        bool nearer = false;
        for (int half = 0; half < 40 && !nearer; ++half, move *= 0.5) {
            const Vec2 next = (best + move).cwiseMax(0.0).cwiseMin(1.0);
            if (next == best) break;
            const double d = (point(next.x(), next.y()) - p).squaredNorm();
            if (d < best_distance) {
                best_distance = d;
                best = next;
                nearer = true;
            }
        }
        if (!nearer) break;
    }
    return best;
}

} // namespace facetmill
