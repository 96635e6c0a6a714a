#include "core/gouge/curve_lift.h"

#include "core/base/error.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/axis_frame.h"
#include "core/gouge/lower_surface.h"

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

} // namespace

CurveLift::CurveLift(const CutterProfile& cutter, double flutes)
    : surface_(std::make_shared<const SurfaceTable>(lower_surface(cutting_part(cutter, flutes)))) {}

double CurveLift::lift(const ToolPose& pose, std::span<const Vec3> curve, Hint& hint, double enough,
                       double least) const {
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
