#include "core/gouge/curve_lift.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/axis_frame.h"
#include "core/gouge/lower_surface.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

static_assert(sizeof(Vec3) == 3 * sizeof(double)); // curves are read as plain coordinates

namespace {

CutterProfile cutting_part(const CutterProfile& cutter, double flutes) {
    if (!(flutes >= 0))
        throw Error(ErrorCode::out_of_range, "flute_length", "is negative", "give the height that cuts");
    if (flutes == 0 || flutes >= cutter.height()) return cutter;
    AptCutter lower = cutter.cutter();
    lower.h = flutes;
    return CutterProfile(lower);
}

/// g(rho) for 0 <= rho <= max_radius.
double surface_height(const SurfaceTable& surface, double rho) {
    int i = 0;
    while (i + 1 < surface.count && rho > surface.piece[i].rho1)
        ++i;
    const SurfacePiece& p = surface.piece[i];
    if (p.r == 0) return p.z0 + p.slope0 * (std::min(rho, p.rho1) - p.rho0);
    const double out = rho - p.e;
    return p.f - std::sqrt(std::max((p.r - out) * (p.r + out), 0.0));
}

/// The lift over one point or less, by no more than rounding; -inf where rounding could see it outside.
double sure_lift(const SurfaceTable& surface, const ToolPose& pose, const Vec3& point) {
    const Vec3 from_tip = point - pose.tip;
    const double z = from_tip.dot(pose.axis);
    const double slack = tolerance::bound_slack * (from_tip.cwiseAbs().sum() + surface.max_radius);
    const double rho = (from_tip - z * pose.axis).norm() + slack;
    return rho <= surface.max_radius ? z - slack - surface_height(surface, rho) : -infinity;
}

} // namespace

CurveLift::CurveLift(const CutterProfile& cutter, double flutes)
    : surface_(std::make_shared<const SurfaceTable>(lower_surface(cutting_part(cutter, flutes)))) {}

double CurveLift::lift(const ToolPose& pose, std::span<const Vec3> curve, Hint& hint, double enough,
                       double least) const {
    // Mostly the ends of what was touched last tell that it is enough.
    if (enough < infinity)
        for (std::size_t i = hint.segment; i < curve.size() && i <= std::size_t(hint.segment) + 1; ++i)
            if (const double sure = sure_lift(*surface_, pose, curve[i]); sure > enough) return sure;
    AxialQuery query;
    for (int k = 0; k < 3; ++k)
        query.place[k] = pose.tip[k];
    set_frame(pose.axis, query.frame);
    query.enough = enough;
    query.least = least;
    query.hint = hint.segment;
    AxialAnswer answer;
    axial_kernels().curve(*surface_, query, reinterpret_cast<const double*>(curve.data()),
                          std::uint32_t(curve.size()), answer);
    hint.segment = answer.slot;
    return answer.tip;
}

bool CurveLift::reaches(const ToolPose& pose, std::span<const Vec3> curve, Hint& hint, double level) const {
    return lift(pose, curve, hint, level, std::nextafter(level, -infinity)) >= level;
}

double CurveLift::lift(const ToolPose& pose, std::span<const Vec3> curve) const {
    Hint none;
    return lift(pose, curve, none);
}

} // namespace facetmill
