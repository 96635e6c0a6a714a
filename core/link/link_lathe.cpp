#include "core/base/tolerances.h"
#include "core/link/link.h"
#include "core/strategy/lathe/lathe_field.h"

#include <cmath>

namespace facetmill {

namespace {

/// How far below the tip's distance from the axis a tilted tool reaches: its lower rims.
double reach_in(const Tool& tool, double cutter_radius, double tilt) {
    const double sine = std::abs(std::sin(tilt)), cosine = std::cos(tilt);
    double reach = std::max(cutter_radius, 0.5 * tool.diameter) * sine;
    double height = tool.flute_length;
    const auto body = [&](double diameter, double length) {
        reach = std::max(reach, 0.5 * diameter * sine - height * cosine);
        height += length;
    };
    body(tool.shank_diameter, tool.shank_length);
    for (const HolderSection& section : tool.holder)
        body(section.diameter, section.length);
    return reach;
}

class LatheLinker {
public:
    LatheLinker(const LatheCommon& settings, const PlanContext& context, const TurnedPath& turned,
                const LinkOptions& options, const Progress& progress)
        : frame_(settings, context), stock_(frame_, context, LatheStock::Of::whole_tool, progress),
          shank_(frame_, context, LatheStock::Of::above_flutes, progress), clearance_(options.clearance),
          rapid_chord_share_(options.rapid_chord_share) {
        const Mesh stock = lathe_stock_mesh(context.stock, context.stock_box);
        const double zones =
            radius_about(frame_, lathe_zone_mesh(settings, frame_, stock, options.clearance));
        const double material = std::max(
            {turned.stock_radius, turned.part_radius, zones, radius_about(frame_, context.contact->mesh())});
        const double radius = CutterProfile(context.tool.cutter()).max_radius();
        out_ = (material + options.clearance + reach_in(context.tool, radius, settings.tilt))
               / std::cos(settings.tilt);
        result_.clearance_z = out_;
        result_.turning = frame_.axis();
    }

    void add(const Pass& pass, Index index) {
        const bool ramps = !pass.entry.empty();
        const CutterLocation& start = ramps ? pass.entry.front() : pass.cl.front();
        const bool goes_on = at_ && !ramps && at_->tip == start.tip && at_->axis == start.axis;
        if (!goes_on) {
            travel_to(start);
            put(MotionKind::approach, start);
            for (std::size_t k = 1; k < pass.entry.size(); ++k)
                put(MotionKind::approach, pass.entry[k]);
            // The ramp ends where the pass begins.
            const bool there = ramps && (at_->tip - pass.cl.front().tip).norm() < tolerance::smallest_chord;
            if (ramps && !there) put(MotionKind::approach, pass.cl.front());
        }
        result_.motions.back().pass = index;
        result_.motions.back().point = 0;
        for (std::size_t k = 1; k < pass.cl.size(); ++k) {
            put(MotionKind::cut, pass.cl[k]);
            result_.motions.back().pass = index;
            result_.motions.back().point = Index(k);
        }
    }

    ToolMotions finish() {
        if (at_) retract();
        return std::move(result_);
    }

private:
    double height(const CutterLocation& c, double angle) const { return frame_.height(c.tip, angle); }

    /// Tip height at which the tool is clear of the raw material at a place.
    double clear_of_stock(const LathePlace& place, double u) {
        return std::min(out_, std::max(stock_.u(place, of_tool_), u) + clearance_);
    }

    /// Out of the cut at feed, the rest in a rapid.
    void retract() {
        const LathePlace place = frame_.place(*at_);
        const double u = height(*at_, place.angle);
        // Nothing stands above a place that the tool came down to, but sides of the cut touch it; and the
        // raw material what is wider than the flutes.
        const double free =
            shank_.u(place, of_shank_) > u ? clear_of_stock(place, u) : std::min(out_, u + clearance_);
        move_out(MotionKind::retract, u, free);
        move_out(MotionKind::rapid, free, out_);
    }
    void move_out(MotionKind kind, double from, double to) {
        if (!(to > from)) return;
        put(kind, {at_->tip + (to - from) * at_->axis, at_->axis});
    }

    void travel_to(const CutterLocation& start) {
        const LathePlace to = frame_.place(start);
        const double u = height(start, to.angle);
        const CutterLocation above{start.tip + (out_ - u) * start.axis, start.axis};
        if (at_) {
            retract();
            const LathePlace from = frame_.place(*at_);
            const double turn = std::remainder(to.angle - from.angle, 2 * pi);
            const double most = std::acos(std::max(0.0, 1 - rapid_chord_share_ * clearance_ / out_));
            const double parts = std::ceil(std::abs(turn) / std::min(2 * most, 0.25 * pi));
            for (double k = 1; k < parts; ++k)
                put(MotionKind::rapid,
                    frame_.at({from.angle + turn * k / parts, from.y + (to.y - from.y) * k / parts}, out_));
        }
        put(MotionKind::rapid, above);
        const double down = clear_of_stock(to, u);
        if (down < out_) put(MotionKind::rapid, {start.tip + (down - u) * start.axis, start.axis});
    }

    void put(MotionKind kind, const CutterLocation& to) {
        result_.motions.push_back({kind, to, no_index, no_index});
        at_ = to;
    }

    LatheFrame frame_;
    LatheStock stock_, shank_;
    LatheStock::Hint of_tool_, of_shank_;
    double clearance_, rapid_chord_share_, out_ = 0;
    std::optional<CutterLocation> at_;
    ToolMotions result_;
};

} // namespace

ToolMotions link_lathe(const StrategyResult& path, const PlanContext& context, const LatheCommon& settings,
                       const LinkOptions& options, const Progress& progress) {
    check_link_options(options);
    const auto* turned = path.as<TurnedPath>();
    if (!turned)
        throw Error(ErrorCode::internal, "link", "the path of a turning part knows no axis", "report this");
    LatheLinker linker(settings, context, *turned, options, progress.part(0, 0.1));
    for (std::size_t i = 0; i < path.passes.size(); ++i) {
        progress.part(0.1, 1).set(double(i) / double(path.passes.size()));
        if (!path.passes[i].cl.empty()) linker.add(path.passes[i], Index(i));
    }
    progress.set(1);
    return linker.finish();
}

} // namespace facetmill
