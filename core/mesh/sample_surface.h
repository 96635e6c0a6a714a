// The exact surfaces behind the samples of Lu's Appendix A, so that paths can be measured against the surface
// itself and not only against its mesh. Millimetres.
#pragma once

#include "core/mesh/bspline.h"

#include <optional>
#include <string_view>
#include <vector>

namespace facetmill {

/// Point and derivatives by (u, v).
struct SurfacePoint {
    Vec3 point, du, dv, duu, duv, dvv;
    Vec3 normal; ///< unit, du x dv: +Z side
};

/// Surface through cubic sections C_i(v) = (y, z) in planes X = const at equal distances. u in [0, 1] runs
/// across the sections (+X), v in [0, 1] along them (+Y).
///
/// Through-curve scheme: S(u, v) = sum L_i(u) C_i(v), where all sections have the same parameter v and L_i
/// are the Lagrange polynomials of the sections' places u_i = i / (n - 1). Two sections give the ruled
/// surface; four give the one cubic through them, which is what a cubic through-curve surface with one span
/// is. X is linear in u. Lu names only "a through-curve method"; sections with different numbers of poles are
/// joined at equal v.
class LoftedSurface {
public:
    struct Section {
        double x;
        CubicBSpline curve; ///< (y, z)
    };
    /// Throws Error(internal) unless there are two to four sections at increasing, equally spaced X.
    explicit LoftedSurface(std::vector<Section> sections);

    Vec3 point(double u, double v) const;
    SurfacePoint evaluate(double u, double v) const;
    Vec3 normal(double u, double v) const { return evaluate(u, v).normal; }

    /// (u, v) of the point over (x, y); empty outside the surface's shadow. Needs y to grow with v, as it
    /// does on the three benchmark surfaces.
    std::optional<Vec2> parameters_over(double x, double y) const;
    /// Height z over (x, y); empty outside the surface's shadow.
    std::optional<double> height(double x, double y) const;
    /// (u, v) of the foot point of `p` (nearest point of the surface, borders included).
    Vec2 nearest_parameters(const Vec3& p) const;

    const std::vector<Section>& sections() const { return sections_; }

private:
    std::vector<Section> sections_;
};

/// "concave", "convex" or "complex" (Lu, Appendix A), in mm; throws Error(out_of_range) for other names.
const LoftedSurface& lu_surface(std::string_view name);

} // namespace facetmill
