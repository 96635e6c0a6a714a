#include "core/strategy/curves/radial.h"

#include "core/strategy/curves/asked_surface.h"
#include "core/strategy/curves/line_family.h"

#include <cmath>

namespace facetmill {

namespace {

const OperationRegistration radial_registration("radial", "Radial",
                                                [] { return std::make_unique<Radial>(); });
const OperationRegistration spiral_registration("spiral", "Spiral",
                                                [] { return std::make_unique<Spiral>(); });

/// Spokes that go all the way to the centre, at least.
constexpr int first_spokes = 8;
/// Turns of a spiral keep the tolerance but for this share of their length, over which arcs lie between.
constexpr double share_left = 0.1;
/// The next turn is tried farther by this factor, and no nearer than this share of the step on a level plane.
constexpr double try_farther = 1.2, nearest_turn = 0.01;
constexpr int turn_halvings = 4;
/// Lines reach so far beside what they cut, in steps (StepOver::reach_share).
constexpr double reach_share = 0.55;
constexpr double max_turns = 20'000;

/// Where an operation cuts: a ring about a centre, and the context of what lies in it.
struct Ring {
    Vec2 center = Vec2::Zero();
    double from = 0, to = 0; ///< of the surface
    PlanContext context;
};

double farthest_corner(const Box3& box, const Vec2& center) {
    double far = 0;
    for (const double x : {box.lo.x(), box.hi.x()})
        for (const double y : {box.lo.y(), box.hi.y()})
            far = std::max(far, (Vec2(x, y) - center).norm());
    return far;
}

Ring ring_of(const RadialCommon& settings, const PlanContext& context, const Progress& progress) {
    check_plannable(context, settings);
    Ring ring;
    const Box3 box = context.part->box();
    ring.center = box.center().head<2>();
    if (!settings.center_of_part) {
        // Planned turned about, places of the setup are turned as well.
        const Vec3 c(settings.center[0], settings.center[1], settings.center[2]);
        ring.center = (context.to_setup.transpose() * c).head<2>();
    }
    ring.from = settings.from_radius;
    ring.to = settings.to_radius.is_number() ? settings.to_radius.number : farthest_corner(box, ring.center);
    const PlanText text{context.unit, context.to_setup};
    if (settings.to_radius.is_number() && !(ring.to > ring.from))
        throw Error(ErrorCode::out_of_range, settings.name,
                    "from " + text(ring.from) + " to " + text(ring.to) + " of the centre there is nothing",
                    "let it end farther out than it begins");
    std::optional<PlanCurve> within, outside;
    if (settings.to_radius.is_number()) within = circle_about(ring.center, ring.to);
    if (ring.from > 0) outside = circle_about(ring.center, ring.from);
    ring.context = cut_to_curves(context, settings.name, within, outside,
                                 CutterProfile(context.tool.cutter()).max_radius(), progress);
    return ring;
}

class Spokes : public LineFamily {
public:
    Spokes(const Vec2& center, double from, double to) : center_(center), from_(from), to_(to) {}
    Vec2 at(double t, double w) const override {
        const double a = 2 * pi * w;
        return center_ + (from_ + t * (to_ - from_)) * Vec2(std::cos(a), std::sin(a));
    }
    std::optional<Place> where(const Vec2& p) const override {
        const Vec2 d = p - center_;
        const double w = std::atan2(d.y(), d.x()) / (2 * pi), t = (d.norm() - from_) / (to_ - from_);
        if (t < 0 || t > 1) return std::nullopt;
        return Place{t, w < 0 ? w + 1 : w};
    }

private:
    Vec2 center_;
    double from_, to_;
};

/// Turn w of a spiral whose turns begin at given radii, from and to the next.
class Turns : public LineFamily {
public:
    Turns(const Vec2& center, std::vector<double> radii) : center_(center), radii_(std::move(radii)) {}
    double radius(double turn) const {
        const double at = std::clamp(turn, 0.0, double(radii_.size() - 1));
        const std::size_t i = std::min(std::size_t(at), radii_.size() - 2);
        return radii_[i] + (at - double(i)) * (radii_[i + 1] - radii_[i]);
    }
    Vec2 at(double t, double w) const override {
        const double a = t < 1 ? 2 * pi * t : 0; // to the digit where the next turn begins
        return center_ + radius(w + t) * Vec2(std::cos(a), std::sin(a));
    }
    std::optional<Place> where(const Vec2& p) const override {
        const Vec2 d = p - center_;
        double t = std::atan2(d.y(), d.x()) / (2 * pi);
        if (t < 0) t += 1;
        const double r = d.norm();
        if (r < radii_.front() || r > radii_.back()) return std::nullopt;
        const auto after = std::upper_bound(radii_.begin(), radii_.end(), r);
        const auto i = std::min(std::size_t(after - radii_.begin()), radii_.size() - 1) - 1;
        const double turn = double(i) + (r - radii_[i]) / (radii_[i + 1] - radii_[i]);
        return Place{t, turn - t};
    }

private:
    Vec2 center_;
    std::vector<double> radii_;
};

/// Circles about a centre; w is their radius.
class Circles : public LineFamily {
public:
    explicit Circles(const Vec2& center) : center_(center) {}
    Vec2 at(double t, double w) const override {
        const double a = t < 1 ? 2 * pi * t : 0;
        return center_ + w * Vec2(std::cos(a), std::sin(a));
    }
    std::optional<Place> where(const Vec2&) const override { return std::nullopt; }

private:
    Vec2 center_;
};

/// Passes that lie end to end, as turns of a spiral do, are one.
void join_ends(std::vector<Pass>& passes) {
    std::vector<Pass> all;
    for (Pass& p : passes) {
        if (!all.empty() && all.back().cl.back().tip == p.cl.front().tip) {
            all.back().cl.insert(all.back().cl.end(), p.cl.begin() + 1, p.cl.end());
            all.back().cc.insert(all.back().cc.end(), p.cc.begin() + 1, p.cc.end());
        } else {
            all.push_back(std::move(p));
        }
    }
    passes = std::move(all);
}

constexpr const char* what_to_check = "check part, centre and radii";

/// Spokes so many that at their outer ends they are a length apart, or thinned out towards the centre.
std::vector<double> spoke_places(int count) {
    std::vector<double> w;
    w.reserve(std::size_t(std::max(count, 0)));
    for (int i = 0; i < count; ++i)
        w.push_back(double(i) / count);
    return w;
}

template <class S>
ParameterTable<S> radial_table() {
    using K = ParameterKind;
    ParameterTable<S> t;
    const auto member = []<class T>(T RadialCommon::*m) -> T S::* { return m; };
    add_common_parameters(t);
    add_tool_axis_parameter(t);
    t.add(member(&RadialCommon::center_of_part),
          {.key = "center_of_part",
           .label = "About the middle",
           .help = "The centre is the middle of what is cut, seen from above, whatever the centre says.",
           .kind = K::boolean});
    t.add(member(&RadialCommon::center),
          place_parameter({.key = "center",
                           .label = "Centre",
                           .help = "Place of the centre, seen from above, where it is not the middle."}));
    t.add(member(&RadialCommon::from_radius), {.key = "from_radius",
                                               .label = "From radius",
                                               .help = "What is nearer to the centre is not cut.",
                                               .kind = K::number,
                                               .quantity = Quantity::length,
                                               .minimum = 0,
                                               .maximum = 1e5});
    t.add(member(&RadialCommon::to_radius),
          length_or_word_parameter({.key = "to_radius",
                                    .label = "To radius",
                                    .help = "What is farther from the centre is not cut. auto goes as far as "
                                            "the part.",
                                    .words = {"auto"}},
                                   1e5));
    add_stepover_parameter(t);
    add_curve_parameters(t);
    return t;
}

} // namespace

const ParameterTable<RadialSettings>& radial_parameters() {
    static const auto table = radial_table<RadialSettings>();
    return table;
}

const ParameterTable<SpiralSettings>& spiral_parameters() {
    static const auto table = radial_table<SpiralSettings>();
    return table;
}

StrategyResult Radial::plan(const PlanContext& context, const Progress& progress) const {
    const Ring ring = ring_of(settings_, context, progress.part(0, 0.02));
    const CurveJob job(settings_, ring.context, progress.part(0.02, 0.05));
    // The tip goes beyond the ring as far as touching its border takes.
    const double inner = std::max(0.0, ring.from - job.radius()), outer = ring.to + job.radius();
    const Spokes spokes(ring.center, inner, outer);
    const double around = 2 * pi * outer;
    const bool fixed = settings_.stepover.is_number();
    const double step = fixed ? settings_.stepover.number : job.level_step();
    FamilyPlanner planner(job, spokes, reach_share * std::min(step, 2 * job.radius()));
    const double wanted = around / step;
    if (wanted > max_turns)
        throw Error(ErrorCode::limit_exceeded, "stepover",
                    "it asks for more than " + format_number(max_turns) + " passes",
                    "allow a larger tolerance or set a step-over");
    // Halved so often, the first spokes are as close as a level part asks.
    const int halvings = std::max(0, int(std::floor(std::log2(wanted / first_spokes))));
    const int count = int(std::ceil(wanted / double(1 << halvings)));
    std::vector<FamilyLine> lines;
    const Progress making = progress.part(0.05, 0.5, "Passes from the centre outward");
    if (!fixed) {
        for (const double w : spoke_places(count))
            lines.push_back(planner.whole_line(w, making.part(0, 0)));
        planner.fill(lines, true, making);
        planner.fill_overlooked(lines, true, *job.context.part, progress.part(0.5, 0.7));
    } else {
        const int all = count << halvings;
        for (int i = 0; i < all; ++i) {
            making.set(double(i) / all);
            int twos = 0;
            while (twos < halvings && i % (2 << twos) == 0)
                ++twos;
            // Without this one the others of its round are a step apart where it begins.
            const double begins = twos == halvings ? 0 : step * double(all >> (twos + 1)) / (2 * pi);
            const Interval range{std::clamp((begins - inner) / (outer - inner), 0.0, 1.0), 1};
            if (range.length() > 0)
                lines.push_back(planner.line(double(i) / all, {&range, 1}, making.part(0, 0)));
        }
    }
    StrategyResult result;
    take_passes(std::move(lines), result);
    result.stepover_min = result.stepover_max = step;
    return finished(job, planner, std::move(result), what_to_check, progress.part(0.7, 1));
}

namespace {

/// The radii at which the turns of a spiral begin.
std::vector<double> turn_radii(const SpiralSettings& settings, const CurveJob& job, const Vec2& center,
                               double inner, double outer, const Progress& progress) {
    std::vector<double> radii{inner};
    const auto check = [&] {
        if (double(radii.size()) > max_turns)
            throw Error(ErrorCode::limit_exceeded, "stepover",
                        "it asks for more than " + format_number(max_turns) + " turns",
                        "allow a larger tolerance or set a step-over");
    };
    if (settings.stepover.is_number()) {
        for (double r = inner; r < outer; check())
            radii.push_back(r += settings.stepover.number);
        return radii;
    }
    const Circles circles(center);
    const double level = job.level_step();
    const FamilyPlanner planner(job, circles, reach_share * level);
    const Interval all{0, 1};
    FamilyLine last = planner.whole_line(std::max(inner, 1e-3 * level), progress.part(0, 0));
    double step = level;
    while (radii.back() < outer) {
        check();
        progress.set((radii.back() - inner) / (outer - inner));
        const auto attempt = [&](double d, FamilyLine& next) {
            next = planner.whole_line(radii.back() + d, progress.part(0, 0));
            double left = 0;
            for (const Interval& r : planner.left_between(last, next, {&all, 1}, progress.part(0, 0)))
                left += r.length();
            return left <= share_left;
        };
        double hi = std::min(level, try_farther * step), lo = hi;
        FamilyLine best, next;
        while (!attempt(lo, best) && lo > nearest_turn * level) {
            hi = lo;
            lo *= 0.5;
        }
        if (lo < hi) {
            for (int k = 0; k < turn_halvings; ++k) {
                const double middle = 0.5 * (lo + hi);
                if (attempt(middle, next)) {
                    lo = middle;
                    best = std::move(next);
                } else {
                    hi = middle;
                }
            }
        }
        step = lo;
        radii.push_back(radii.back() + lo);
        last = std::move(best);
    }
    return radii;
}

} // namespace

StrategyResult Spiral::plan(const PlanContext& context, const Progress& progress) const {
    const Ring ring = ring_of(settings_, context, progress.part(0, 0.02));
    const CurveJob job(settings_, ring.context, progress.part(0.02, 0.05));
    const double inner = std::max(0.0, ring.from - job.radius()), outer = ring.to + job.radius();
    std::vector<double> radii =
        turn_radii(settings_, job, ring.center, inner, outer, progress.part(0.05, 0.4, "Placing turns"));
    StrategyResult result;
    result.stepover_min = infinity;
    for (std::size_t i = 1; i < radii.size(); ++i) {
        result.stepover_min = std::min(result.stepover_min, radii[i] - radii[i - 1]);
        result.stepover_max = std::max(result.stepover_max, radii[i] - radii[i - 1]);
    }
    // The last turn ends where the turns before it began, all around.
    radii.push_back(radii.back() + (radii.back() - radii[radii.size() - 2]));
    const std::size_t turns = radii.size() - 1;
    const Turns family(ring.center, std::move(radii));
    const bool fixed = settings_.stepover.is_number();
    FamilyPlanner planner(job, family, reach_share * std::min(result.stepover_max, 2 * job.radius()));
    std::vector<FamilyLine> lines;
    const Progress making = progress.part(0.4, 0.6, "Passes about the centre");
    for (std::size_t i = 0; i < turns; ++i)
        lines.push_back(planner.whole_line(double(i), making.part(0, 0)));
    if (!fixed) {
        planner.fill(lines, false, making);
        planner.fill_overlooked(lines, false, *job.context.part, progress.part(0.6, 0.75));
    }
    // The spiral first, then what lies between its turns.
    std::vector<FamilyLine> spiral, between;
    for (FamilyLine& l : lines)
        (l.whole ? spiral : between).push_back(std::move(l));
    take_passes(std::move(spiral), result);
    join_ends(result.passes);
    take_passes(std::move(between), result);
    return finished(job, planner, std::move(result), what_to_check, progress.part(0.75, 1));
}

} // namespace facetmill
