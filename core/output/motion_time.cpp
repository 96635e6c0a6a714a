#include "core/output/motion_time.h"

namespace facetmill {

namespace {

double rapid_time(const Vec3& step, const Machine& machine) {
    return step.cwiseAbs().cwiseQuotient(machine.rapid_mm_per_s).maxCoeff();
}

} // namespace

std::vector<double> motion_seconds(const ClProgram& program, const Machine& machine) {
    const auto& motions = program.motions.motions;
    std::vector<double> seconds(motions.size(), 0);
    for (std::size_t i = 1; i < motions.size(); ++i) {
        const Vec3 step = motions[i].to.tip - motions[i - 1].to.tip;
        seconds[i] = motions[i].kind == MotionKind::rapid ? rapid_time(step, machine)
                                                          : step.norm() / program.feed_mm_per_min * 60.0;
    }
    return seconds;
}

MotionTotals motion_totals(const ClProgram& program, const Machine& machine) {
    MotionTotals totals;
    double rapid_seconds = 0;
    const auto& motions = program.motions.motions;
    // The first motion comes from nobody knows where: it has no length.
    for (std::size_t i = 1; i < motions.size(); ++i) {
        const Vec3 step = motions[i].to.tip - motions[i - 1].to.tip;
        if (motions[i].kind == MotionKind::rapid) {
            totals.rapid_length += step.norm();
            rapid_seconds += rapid_time(step, machine);
        } else {
            totals.cut_length += step.norm();
        }
    }
    totals.time_seconds = rapid_seconds + totals.cut_length / program.feed_mm_per_min * 60.0;
    return totals;
}

} // namespace facetmill
