#include "core/output/motion_time.h"

namespace facetmill {

MotionTotals motion_totals(const ClProgram& program, const Machine& machine) {
    MotionTotals totals;
    double rapid_seconds = 0;
    const auto& motions = program.motions.motions;
    // The first motion comes from nobody knows where: it has no length.
    for (std::size_t i = 1; i < motions.size(); ++i) {
        const Vec3 step = motions[i].to.tip - motions[i - 1].to.tip;
        if (motions[i].kind == MotionKind::rapid) {
            totals.rapid_length += step.norm();
            rapid_seconds += step.cwiseAbs().cwiseQuotient(machine.rapid_mm_per_s).maxCoeff();
        } else {
            totals.cut_length += step.norm();
        }
    }
    totals.time_seconds = rapid_seconds + totals.cut_length / program.feed_mm_per_min * 60.0;
    return totals;
}

} // namespace facetmill
