#include "viz/path_figures.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/job/planner.h"
#include "core/output/motion_time.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "core/strategy/five_axis/posture_path.h"

#include <cmath>
#include <limits>
#include <map>

namespace facetmill {

namespace {

constexpr std::size_t motions_per_check = 1u << 14, points_per_block = 16;
constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

/// As core/output/motion_time.cpp counts them: within runs between rapids, by more than rounding.
std::vector<std::size_t> turning_points(const std::vector<Motion>& motions, const MachineMotion& run,
                                        int joint) {
    std::vector<std::size_t> turns;
    int route = 0;
    std::size_t last = 0;
    for (std::size_t i = 1; i < motions.size(); ++i) {
        if (motions[i].kind == MotionKind::rapid) {
            route = 0;
            continue;
        }
        const double step = run.motions[i].at[joint] - run.motions[i - 1].at[joint];
        if (std::abs(step) <= tolerance::level_angle) continue;
        const int now = step > 0 ? 1 : -1;
        if (route == -now) turns.push_back(last);
        route = now;
        last = i;
    }
    return turns;
}

} // namespace

PathFiguresPtr path_figures(const std::shared_ptr<const OperationResult>& operation, const Machine& machine,
                            const Progress& progress) {
    auto figures = std::make_shared<PathFigures>();
    figures->operation = operation;
    figures->machine = machine;
    const auto& motions = operation->program.motions.motions;
    const MachineMotion run = machine_motion(operation->program, machine, {}, progress);
    const std::size_t n = motions.size(), axes = std::min<std::size_t>(machine.rotary.size(), 2);
    for (auto* values :
         {&figures->length, &figures->elapsed, &figures->seconds, &figures->feed, &figures->joint_rate})
        values->reserve(n);
    double length = 0, elapsed = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (i % motions_per_check == 0) progress.check();
        const MotionJoints& m = run.motions[i];
        const double route = i > 0 ? (motions[i].to.tip - motions[i - 1].to.tip).norm() : 0.0;
        figures->length.push_back(length += route);
        figures->elapsed.push_back(elapsed += m.seconds);
        figures->seconds.push_back(m.seconds);
        figures->feed.push_back(m.seconds > 0 && route > 0 ? route / m.seconds * 60 : no_figure);
        double rate = 0;
        for (int k = 0; k < machine.joints(); ++k)
            rate = std::max(rate, std::abs(m.rates[std::size_t(k)]) / machine.speed(k));
        figures->joint_rate.push_back(m.seconds > 0 ? rate : no_figure);
        for (std::size_t r = 0; r < axes; ++r)
            figures->rotary[r].push_back(m.held ? m.at.rotary[r] : no_figure);
    }
    for (std::size_t r = 0; r < axes; ++r)
        figures->reversals[r] = turning_points(motions, run, 3 + int(r));
    return figures;
}

std::vector<double> motion_cusps(const OperationResult& operation, const Progress& progress) {
    const auto record = operation.path.five_axis();
    if (!record || !record->has_strips) return {};
    const FiveAxisStudy study(record, progress.part(0, 0.4));
    const auto& points = record->points;
    std::vector<double> at_points(points.size(), no_figure);
    parallel_for(points.size(), points_per_block, progress.part(0.4, 1), [&](std::size_t i) {
        if (points[i].choice.free)
            at_points[i] = posture_cusp(study.field(), points[i].place, points[i].choice.posture);
    });
    std::map<std::array<double, 3>, double> known;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points[i].place.surface;
        known[{p.x(), p.y(), p.z()}] = at_points[i];
    }
    std::vector<std::vector<double>> of_pass;
    for (const Pass& pass : operation.path.passes) {
        progress.check();
        std::vector<double>& cusps = of_pass.emplace_back(pass.cc.size(), no_figure);
        std::size_t before = 0; // one past the last contact point that was planned
        for (std::size_t i = 0; i < cusps.size(); ++i) {
            const Vec3& p = pass.cc[i].point;
            const auto it = known.find({p.x(), p.y(), p.z()});
            if (it == known.end()) continue;
            cusps[i] = it->second;
            // What was put in between the two.
            if (before > 0)
                for (std::size_t k = before; k < i; ++k) {
                    const double from = (pass.cc[k].point - pass.cc[before - 1].point).norm(),
                                 to = (pass.cc[k].point - p).norm();
                    const double share = from + to > 0 ? from / (from + to) : 0.5;
                    cusps[k] = cusps[before - 1] + share * (cusps[i] - cusps[before - 1]);
                }
            before = i + 1;
        }
    }
    const auto& motions = operation.program.motions.motions;
    std::vector<double> cusps(motions.size(), no_figure);
    for (std::size_t m = 0; m < motions.size(); ++m)
        if (motions[m].pass < of_pass.size() && motions[m].point < of_pass[motions[m].pass].size())
            cusps[m] = of_pass[motions[m].pass][motions[m].point];
    return cusps;
}

} // namespace facetmill
