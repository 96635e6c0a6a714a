#include "core/strategy/curves/curve_job.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/finish3/finish_warnings.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/waterline/level_sweep.h"

#include <cmath>

namespace facetmill {

namespace {

/// How often it is asked along a line whether something is to be cut, in radii of the cutter.
constexpr double domain_look = 0.05;

/// What two places of the cutter so far apart leave on a level plane.
double left_on_level(const CutterCover& cover, double apart) {
    const Vec3 up = Vec3::UnitZ();
    return cover.ray_entry(Vec3(0.5 * apart, 0, 0), up, Vec3::Zero(), 4 * cover.radius());
}

} // namespace

double level_step_of(const CutterCover& cover, double cusp) {
    double lo = 0, hi = 2 * cover.radius();
    constexpr int halvings = 40;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (lo + hi);
        (left_on_level(cover, middle) <= cusp ? lo : hi) = middle;
    }
    return lo;
}

ParameterInfo curve_stepover_parameter() {
    ParameterInfo info = stepover_parameter();
    info.help = "Distance between neighbouring passes, looked at from above: adaptive is everywhere the "
                "largest that the tolerance allows; a length is kept whatever cusps it leaves.";
    return info;
}

CurveJob::CurveJob(const CurveCommon& asked, const PlanContext& given, const Progress& progress)
    : settings(asked), context(given), text{given.unit, given.to_setup},
      cusp_allowed(cusp_budget(asked, given)), allowance(asked.allowance + given.tessellation_tolerance[1]),
      chord(chord_budget(asked.chord_tolerance, cusp_allowed)), profile(given.tool.cutter()),
      cover(profile, cusp_detail(cusp_allowed)), lift(given.contact, profile, allowance),
      domain(*given.part, DriveFrame(), cover, allowance, progress),
      level_step_(level_step_of(cover, gap_cusp())) {
    fine.below = fine.above = 0.5 * chord;
    fine.spacing = safe_spacing(profile, fine.below);
    check_tilt(context, settings.tilt_limit);
    if (domain.empty())
        throw Error(ErrorCode::empty_result, settings.name,
                    std::string("no facet of the part can be cut ") + context.seen_from() + ": all "
                        + std::to_string(context.part->facet_count()) + " stand upright or have no area",
                    "rotate the part");
}

CutterContact CurveJob::contact(const Vec3& tip, LiftHint& hint) const {
    return contact_of(lift.contact(tip.x(), tip.y(), hint), tip);
}

CutterContact CurveJob::contact_of(const AxialContact& touched, const Vec3& tip) const {
    if (touched.facet == no_index) return {tip, Vec3::UnitZ()}; // nothing below
    const Vec3 lifted(tip.x(), tip.y(), touched.tip_z);
    const auto open = cover.contact_normal(touched.point - lifted);
    Vec3 normal = open ? *open : context.contact->mesh().facet_normal(touched.facet);
    if (normal.z() < 0) normal = -normal;
    return {touched.point, normal};
}

bool CurveJob::in_domain(const Vec2& p, double beside) const {
    const Interval within{p.x() - beside, p.x() + beside};
    for (const Interval& u : domain.strip(p.y() - beside, p.y() + beside, 0, &within))
        if (u.lo <= within.hi && u.hi >= within.lo) return true;
    return false;
}

std::vector<PlanLine> CurveJob::cut_to_domain(const PlanLine& line, double beside,
                                              const Progress& progress) const {
    const CurveCourse course({line, false});
    const auto is_in = [&](double s) { return in_domain(course.at(s), beside); };
    const auto border = [&](double in, double out) {
        constexpr int halvings = 24;
        for (int k = 0; k < halvings; ++k) {
            const double middle = 0.5 * (in + out);
            (is_in(middle) ? in : out) = middle;
        }
        return in;
    };
    const double look = std::min(domain_look * radius(), std::max(beside, fine.spacing));
    const double steps = std::max(1.0, std::ceil(course.length() / look));
    std::vector<PlanLine> pieces;
    double begin = -1, last = 0;
    for (double k = 0; k <= steps; ++k) {
        progress.check();
        const double s = course.length() * k / steps;
        const bool in = is_in(s);
        if (in && begin < 0) begin = k == 0 ? 0 : border(s, last);
        if (begin >= 0 && (!in || k == steps)) {
            const double end = in ? s : border(last, s);
            if (end > begin) pieces.push_back(course.stretch(begin, end));
            begin = -1;
        }
        last = s;
    }
    return pieces;
}

Pass CurveJob::pass(const PlanLine& line, const Progress& progress) const {
    Pass pass;
    LiftHint hint;
    const auto add = [&](const Vec2& at, double z) {
        const Vec3 tip(at.x(), at.y(), z);
        if (!pass.cl.empty() && pass.cl.back().tip == tip) return;
        pass.cl.push_back({tip, Vec3::UnitZ()});
        pass.cc.push_back(contact(tip, hint));
    };
    const LiftField over = field();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2 d = line[i + 1] - line[i];
        const double length = d.norm();
        if (!(length > 0)) continue;
        const Vec2 along = d / length;
        const auto points = lift_line(over, line[i], along, 0, length, fine, progress.part(0, 0));
        for (const LinePoint& p : thinned(points, fine.below, fine.above))
            add(p.s == length ? line[i + 1] : Vec2(line[i] + p.s * along), p.z);
    }
    return pass;
}

std::vector<Pass> CurveJob::passes(const PlanLine& line, double beside, const Progress& progress) const {
    std::vector<Pass> all;
    for (const PlanLine& piece : cut_to_domain(line, beside, progress))
        if (Pass p = pass(piece, progress); p.cl.size() > 1) all.push_back(std::move(p));
    return all;
}

UncutInput CurveJob::uncut_input(const Mesh& surface) const {
    UncutInput input;
    input.mesh = &surface;
    input.lift = &lift;
    input.cover = &cover;
    input.allowance = allowance;
    return input;
}

CurveFinish::CurveFinish(const CurveJob& job)
    : job_(job), filter_(job.settings, job.context, job.profile,
                         {job.cusp_allowed, job.allowance, job.chord, job.settings.holder_clearance,
                          job.settings.tilt_limit, job.settings.rest_only},
                         [&job](const Vec3& tip) { return job.contact(tip); }) {}

void CurveFinish::check_uncut(const StrategyResult& result, const Mesh& covered, const Progress& progress) {
    uncut_ = uncut_by_levels(job_.uncut_input(covered), job_.context, {result.passes, filter_.held().left},
                             job_.profile, job_.cusp_allowed, progress);
}

void CurveFinish::run(StrategyResult& result, const Options& options, const Progress& progress) {
    const int lines = int(result.passes.size());
    const Mesh* covered = options.covered;
    result.chord_tolerance = job_.chord;
    filter_.leave_out_held_up(result.passes, progress.part(0, 0.05));
    if (covered) check_uncut(result, *covered, progress.part(0.05, 0.8, "Looking for what stays uncut"));
    filter_.leave_out_air(result.passes, progress.part(0.8, 0.85));
    const PlanContext& context = job_.context;
    const double top = std::max(context.part_box.hi.z(), context.stock_box.hi.z()) + job_.settings.allowance;
    if (!options.keep_order)
        order_by_travel(result.passes, job_.settings.pattern == CurveCommon::Pattern::zigzag,
                        top + job_.settings.clearance, progress.part(0.85, 0.9));
    if (filter_.leave_out_beside_stock(result.passes, progress.part(0.9, 0.95)) && covered
        && !job_.settings.rest_only)
        check_uncut(result, *covered, progress.part(0.95, 1));
    Finish3Settings as_finishing;
    static_cast<OperationCommon&>(as_finishing) = job_.settings;
    as_finishing.stepover = job_.settings.stepover;
    const FinishWarnings warnings{
        as_finishing,        context, uncut_, filter_.held(), filter_.beside_stock(), job_.cusp_allowed,
        options.unsatisfied, lines};
    add_finish_warnings(warnings, result);
    if (job_.settings.tilt_limit > 0)
        tilt_passes(result, job_.settings, context,
                    {job_.settings.tilt_limit, job_.allowance, job_.settings.holder_clearance, job_.chord},
                    progress.part(0.95, 1, "Choosing axes"));
    progress.set(1);
}

} // namespace facetmill
