#include "core/strategy/curves/along_curve.h"

#include "core/base/parallel.h"
#include "core/strategy/surface/boundary_region.h"

#include <cmath>

namespace facetmill {

namespace {

const OperationRegistration along_curve_registration("along_curve", "Along a curve",
                                                     [] { return std::make_unique<AlongCurve>(); });

/// A place is over the part where a disc of this radius about it, in radii of the cutter, meets the part;
/// so often it is looked at along a curve.
constexpr double over_part = 0.01, part_look = 0.1;

class AlongPlanner {
public:
    AlongPlanner(const AlongCurveSettings& settings, const CurveJob& job)
        : settings_(settings), job_(job),
          part_(job.context.contact,
                CutterProfile(AptCutter::flat(2 * over_part * job.radius(), 2 * job.radius()))) {}

    StrategyResult run(const Progress& progress) {
        const std::vector<PlanCurve> curves =
            followed_curves(job_.context, 0, settings_.open, progress.part(0, 0.1));
        std::vector<PlanCurve> over;
        for (const PlanCurve& curve : curves)
            for (PlanCurve& piece : over_the_part(curve, progress))
                over.push_back(std::move(piece));
        if (over.empty())
            throw Error(ErrorCode::out_of_range, place(),
                        "all of it lies off the part, as at " + job_.text(on_level(off_)),
                        "move it onto the part");
        std::vector<std::vector<Pass>> made(over.size());
        parallel_for(over.size(), 1, progress.part(0.1, 0.6, "Following curves"),
                     [&](std::size_t i) { made[i] = passes_of(over[i], progress.part(0.1, 0.1)); });
        StrategyResult result;
        for (std::vector<Pass>& all : made)
            for (Pass& pass : all) {
                pass.drive = result.drive_planes++;
                result.passes.push_back(std::move(pass));
            }
        if (result.passes.empty())
            throw Error(ErrorCode::empty_result, place(),
                        "nothing runs " + job_.text(beside()) + " to that side of it",
                        "choose a smaller offset or the other side");
        result.cusp_max = job_.chord;
        if (off_length_ > 0)
            result.warnings.push_back(share_text(off_length_, off_length_ + on_length_)
                                      + " of the curve lies off the part, as at " + job_.text(on_level(off_))
                                      + ", and is not followed");
        if (settings_.depth > 0)
            result.warnings.push_back(
                "it cuts " + job_.text(settings_.depth)
                + " into the part on purpose: the verification calls that a gouge, unless its limit is "
                  "more");
        CurveFinish(job_).run(result, {nullptr, 0, true}, progress.part(0.6, 1));
        return result;
    }

private:
    std::string place() const {
        const std::string& name = job_.context.curves.empty() ? settings_.curve : job_.context.curves[0].name;
        return name.empty() ? settings_.name : boundary_place(name);
    }
    Vec3 on_level(const Vec2& p) const { return {p.x(), p.y(), job_.context.part_box.hi.z()}; }
    double beside() const {
        if (settings_.side == AlongCurveSettings::Side::on) return 0;
        return settings_.offset.is_number() ? settings_.offset.number : job_.radius() + job_.allowance;
    }

    std::vector<PlanCurve> over_the_part(const PlanCurve& curve, const Progress& progress) {
        const CurveCourse course(curve);
        const auto is_over = [&](double s) {
            const Vec2 p = course.at(s);
            return part_.tip_z(p.x(), p.y()) > -infinity;
        };
        const double steps = std::max(1.0, std::ceil(course.length() / (part_look * job_.radius())));
        std::vector<Interval> ranges;
        bool was = false;
        double last = 0;
        const auto border = [&](double in, double out) {
            constexpr int halvings = 30;
            for (int k = 0; k < halvings; ++k) {
                const double middle = 0.5 * (in + out);
                (is_over(middle) ? in : out) = middle;
            }
            return in;
        };
        for (double k = 0; k <= steps; ++k) {
            progress.check();
            const double s = course.length() * k / steps;
            const bool in = is_over(s);
            if (in && !was) ranges.push_back({k == 0 ? 0 : border(s, last), s});
            if (in) ranges.back().hi = s;
            if (!in && was) ranges.back().hi = border(last, s);
            if (!in && !found_off_) {
                off_ = course.at(s);
                found_off_ = true;
            }
            was = in;
            last = s;
        }
        double on = 0;
        for (const Interval& r : ranges)
            on += r.length();
        on_length_ += on;
        off_length_ += course.length() - on > 1e-6 * course.length() ? course.length() - on : 0;
        if (ranges.size() == 1 && ranges[0].lo <= 0 && ranges[0].hi >= course.length()) return {curve};
        // A closed one that leaves the part goes on over its first place.
        if (curve.closed && ranges.size() > 1 && ranges.front().lo <= 0
            && ranges.back().hi >= course.length()) {
            ranges.back().hi = course.length() + ranges.front().hi;
            ranges.erase(ranges.begin());
        }
        std::vector<PlanCurve> pieces;
        for (const Interval& r : ranges)
            if (r.length() > 0) pieces.push_back({course.stretch(r.lo, r.hi), false});
        return pieces;
    }

    std::vector<Pass> passes_of(const PlanCurve& curve, const Progress& progress) const {
        const double left = settings_.side == AlongCurveSettings::Side::right ? -beside() : beside();
        std::vector<Pass> passes;
        for (const PlanCurve& line : curves_beside(curve, left, 0.5 * job_.chord, progress)) {
            PlanLine points = line.points;
            if (line.closed) points.push_back(points.front());
            const Pass on = job_.pass(points, progress);
            if (on.cl.size() < 2) continue;
            for (long k = settings_.cuts - 1; k >= 0; --k) {
                Pass cut = on;
                const double rise = double(k) * settings_.cut_depth - settings_.depth;
                for (std::size_t i = 0; i < cut.cl.size(); ++i) {
                    cut.cl[i].tip.z() += rise;
                    // What stays below touches nothing of the part yet.
                    if (rise > 0) cut.cc[i] = {cut.cl[i].tip, Vec3::UnitZ()};
                }
                const bool back = settings_.pattern == CurveCommon::Pattern::zigzag && !line.closed
                                  && (settings_.cuts - 1 - k) % 2 == 1;
                if (back) {
                    std::reverse(cut.cl.begin(), cut.cl.end());
                    std::reverse(cut.cc.begin(), cut.cc.end());
                }
                passes.push_back(std::move(cut));
            }
        }
        return passes;
    }

    const AlongCurveSettings& settings_;
    const CurveJob& job_;
    AxialLift part_; ///< of a thin disc: is there anything of the part?
    Vec2 off_ = Vec2::Zero();
    bool found_off_ = false;
    double on_length_ = 0, off_length_ = 0;
};

} // namespace

std::vector<PlanCurve> followed_curves(const PlanContext& context, std::size_t i, bool open,
                                       const Progress& progress) {
    std::vector<PlanCurve> curves;
    if (i < context.curves.size() && !context.curves[i].all.empty()) {
        curves = context.curves[i].all;
    } else {
        const Mesh& part = *context.part;
        const PlanRegion region(
            outline_edges(part, std::vector<char>(part.facet_count(), 1), progress.part(0, 0.5)),
            progress.part(0.5, 1));
        curves = joined_loops(region.border());
    }
    return ready_to_follow(std::move(curves), open);
}

const ParameterTable<AlongCurveSettings>& along_curve_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = AlongCurveSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        add_tool_axis_parameter(t);
        t.add(&S::curve,
              {.key = "curve",
               .label = "Curve",
               .help = "Name of a boundary of the setup, the curve or border of which is followed, "
                       "seen from above. A drawn curve is taken without its offset. Empty: the "
                       "outline of what is cut.",
               .kind = K::text});
        t.add(&S::open, {.key = "open",
                         .label = "Open",
                         .help = "The curve ends at its last corner, instead of going back to the first.",
                         .kind = K::boolean});
        t.add_choice(&S::side, {.key = "side",
                                .label = "Side",
                                .help = "Where the tip runs: on the curve, to its left or to its right. "
                                        "Closed curves run counter-clockwise, so what is left lies within.",
                                .words = {"on", "leftward", "rightward"}});
        t.add(&S::offset,
              length_or_word_parameter({.key = "offset",
                                        .label = "Offset",
                                        .help = "How far beside the curve, on the side that is chosen. auto "
                                                "is the cutter's radius and the allowance, so that the "
                                                "cutter touches the curve.",
                                        .words = {"auto"}}));
        t.add(&S::depth, {.key = "depth",
                          .label = "Depth",
                          .help = "How far below the surface the cutter goes, along its axis. 0 stays on it.",
                          .kind = K::number,
                          .quantity = Quantity::length,
                          .minimum = 0,
                          .maximum = 1000});
        t.add(&S::cuts, {.key = "cuts",
                         .label = "Cuts",
                         .help = "How often the curve is gone along, each time deeper; the last one is the "
                                 "depth.",
                         .kind = K::integer,
                         .quantity = Quantity::count,
                         .minimum = 1,
                         .maximum = 1000});
        t.add(&S::cut_depth, {.key = "cut_depth",
                              .label = "Depth of a cut",
                              .help = "How far one of several cuts goes below the one before.",
                              .kind = K::number,
                              .quantity = Quantity::length,
                              .minimum = 0,
                              .maximum = 1000,
                              .open_minimum = true});
        add_curve_parameters(t);
        return t;
    }();
    return table;
}

StrategyResult AlongCurve::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    if (settings_.tilt_limit > 0 && settings_.depth > 0)
        throw Error(ErrorCode::out_of_range, "tilt_limit", "a tool that cuts into the part is not inclined",
                    "set the tilt limit or the depth to 0");
    const CurveJob job(settings_, context, progress.part(0, 0.05));
    return AlongPlanner(settings_, job).run(progress.part(0.05, 1));
}

} // namespace facetmill
