#include "core/strategy/curves/morph.h"

#include "core/strategy/curves/along_curve.h"
#include "core/strategy/curves/asked_surface.h"
#include "core/strategy/curves/line_family.h"
#include "core/strategy/surface/boundary_region.h"
#include "core/strategy/surface/travel_direction.h"

#include <cmath>

namespace facetmill {

namespace {

const OperationRegistration morph_registration("morph", "Morph", [] { return std::make_unique<Morph>(); });

/// Passes that go all the way, at least, and lines reach so far beside what they cut, in steps.
constexpr int first_passes = 4;
constexpr double blend_reach = 0.55;
/// The tip goes a little farther than a radius beyond what it touches.
constexpr double ends_radii = 1.02;
constexpr double max_blends = 20'000;

/// Blends of two curves. They go on beyond either one, straight, for tips that touch its border.
class Blend : public LineFamily {
public:
    Blend(const PlanCurve& first, const PlanCurve& second, double beyond, const Progress& progress)
        : first_(first), second_(second), beyond_(beyond) {
        std::vector<Box3> boxes;
        for (int i = 0; i < cells_along; ++i)
            for (int k = 0; k < cells_across; ++k) {
                Box3 box;
                for (const auto& [t, w] : corners(i, k)) {
                    const Vec2 p = at(t, w);
                    box.add(Vec3(p.x(), p.y(), 0));
                }
                boxes.push_back(box);
            }
        tree_ = BoxTree(boxes, progress);
    }

    /// w from 0 at the first curve to 1 at the second, below and above beyond them.
    Vec2 at(double t, double w) const override {
        const Vec2 a = first_.at(t * first_.length() * (1 - end_share)),
                   b = second_.at(t * second_.length() * (1 - end_share));
        const double inside = std::clamp(w, 0.0, 1.0);
        const Vec2 d = b - a, p = a + inside * d;
        const double length = d.norm();
        if (inside == w || !(length > 0)) return p;
        // One more of w is the length that lines go on by.
        return p + (w - inside) * beyond_ / length * d;
    }
    std::optional<Place> where(const Vec2& p) const override {
        std::optional<Place> found;
        const Vec3 at_p(p.x(), p.y(), 0);
        tree_.each([&](const Box3& box) { return !found && squared_distance(box, at_p) == 0; },
                   [&](std::size_t cell) {
                       if (!found) found = in_cell(cell, p);
                   });
        return found;
    }
    /// The first place at which it folds over; none where it does not.
    std::optional<Vec2> fold() const {
        int turn = 0;
        for (int i = 0; i < cells_along; ++i)
            for (int k = 0; k < cells_across; ++k) {
                const auto c = corners(i, k);
                if (c[0].w < 0 || c[2].w > 1) continue;
                const Vec2 p = at(c[0].t, c[0].w), u = at(c[1].t, c[1].w) - p, v = at(c[2].t, c[2].w) - p;
                const double area = plane_cross(u, v);
                if (std::abs(area) <= 1e-9 * u.norm() * v.norm() || u.norm() * v.norm() == 0) continue;
                const int own = area > 0 ? 1 : -1;
                if (turn == 0) turn = own;
                if (own != turn) return p;
            }
        return std::nullopt;
    }
    double widest() const {
        double most = 0;
        for (int i = 0; i <= cells_along; ++i) {
            const double t = double(i) / cells_along;
            most = std::max(most, (at(t, 1) - at(t, 0)).norm());
        }
        return most;
    }

private:
    static constexpr int cells_along = 240, cells_across = 40;
    static constexpr double end_share = 1e-12; ///< of a closed curve, so that its end is not its beginning
    std::array<Place, 4> corners(int i, int k) const {
        const double t0 = double(i) / cells_along, t1 = double(i + 1) / cells_along;
        // From -1 to 2: what goes on beyond the curves, too.
        const double w0 = -1 + 3.0 * k / cells_across, w1 = -1 + 3.0 * (k + 1) / cells_across;
        return {Place{t0, w0}, Place{t1, w0}, Place{t0, w1}, Place{t1, w1}};
    }
    std::optional<Place> in_cell(std::size_t cell, const Vec2& p) const {
        const auto c = corners(int(cell) / cells_across, int(cell) % cells_across);
        for (const auto& three : {std::array<int, 3>{0, 1, 2}, std::array<int, 3>{3, 2, 1}}) {
            const Place &o = c[std::size_t(three[0])], &a = c[std::size_t(three[1])],
                        &b = c[std::size_t(three[2])];
            const Vec2 q = at(o.t, o.w), u = at(a.t, a.w) - q, v = at(b.t, b.w) - q;
            const double area = plane_cross(u, v);
            if (area == 0) continue;
            const double x = plane_cross(p - q, v) / area, y = plane_cross(u, p - q) / area;
            if (x < 0 || y < 0 || x + y > 1) continue;
            return Place{o.t + x * (a.t - o.t) + y * (b.t - o.t), o.w + x * (a.w - o.w) + y * (b.w - o.w)};
        }
        return std::nullopt;
    }

    CurveCourse first_, second_;
    double beyond_ = 0;
    BoxTree tree_;
};

class MorphPlanner {
public:
    MorphPlanner(const MorphSettings& settings, const PlanContext& context)
        : settings_(settings), context_(context), text_{context.unit, context.to_setup} {}

    StrategyResult run(const Progress& progress) const {
        const double radius = CutterProfile(context_.tool.cutter()).max_radius();
        auto [first, second] = curves(radius, progress.part(0, 0.03));
        const PlanContext own = between(first, second, radius, progress.part(0.03, 0.06));
        if (!first.closed && !settings_.first_curve.empty()) go_on(first, second, ends_radii * radius);
        const Blend blend(first, second, 2 * radius, progress.part(0.06, 0.06));
        if (const auto at = blend.fold())
            throw Error(ErrorCode::out_of_range, settings_.name,
                        "what lies between the curves folds over, as at " + text_(on_level(*at)),
                        "draw curves that run side by side");
        const CurveJob job(settings_, own, progress.part(0.06, 0.08));
        return planned(job, blend, progress.part(0.08, 1));
    }

private:
    Vec3 on_level(const Vec2& p) const { return {p.x(), p.y(), context_.part_box.hi.z()}; }

    /// Both curves straight on at either end, side by side, for tips that touch the borders there.
    static void go_on(PlanCurve& a, PlanCurve& b, double by) {
        const auto direction = [](const Vec2& from, const Vec2& to) {
            return Vec2((to - from).normalized());
        };
        const auto last = [](const PlanCurve& c, std::size_t k) { return c.points[c.points.size() - k]; };
        const Vec2 back = (direction(a.points[1], a.points[0]) + direction(b.points[1], b.points[0]))
                              .normalized(),
                   on = (direction(last(a, 2), last(a, 1)) + direction(last(b, 2), last(b, 1))).normalized();
        for (PlanCurve* c : {&a, &b}) {
            c->points.insert(c->points.begin(), c->points.front() + by * back);
            c->points.emplace_back(c->points.back() + by * on);
        }
    }

    std::array<PlanCurve, 2> curves(double radius, const Progress& progress) const {
        const bool one = settings_.first_curve.empty() != settings_.second_curve.empty();
        if (one)
            throw Error(ErrorCode::missing_reference, settings_.name, "only one of its two curves is named",
                        "name the other one too, or none to take the outline");
        if (settings_.first_curve.empty()) {
            const double angle = travel_direction(settings_.direction, context_, progress.part(0, 0.5));
            const PlanCurve outline =
                longest_of(followed_curves(context_, context_.curves.size(), false, progress));
            // As far about it as the tip goes where it touches the border.
            const auto around = curves_beside(outline, -ends_radii * radius, 0.01 * radius, progress);
            const bool whole = !around.empty() && longest_of(around).closed;
            return halves_of(whole ? longest_of(around) : outline, Vec2(std::cos(angle), std::sin(angle)));
        }
        PlanCurve a = longest_of(followed_curves(context_, 0, settings_.open, progress)),
                  b = longest_of(followed_curves(context_, 1, settings_.open, progress));
        if (a.closed != b.closed) a.closed = b.closed = false;
        if (a.closed) {
            b = begun_near(b, a.points.front());
        } else {
            const double same = (a.points.front() - b.points.front()).norm()
                                + (a.points.back() - b.points.back()).norm(),
                         other = (a.points.front() - b.points.back()).norm()
                                 + (a.points.back() - b.points.front()).norm();
            if (other < same) b = reversed(std::move(b));
        }
        if (const auto at = crossing_of(CurveCourse(a).line(), CurveCourse(b).line(), progress))
            throw Error(ErrorCode::out_of_range, settings_.name,
                        "its two curves cross or touch at " + text_(on_level(*at)), "draw them apart");
        return {a, b};
    }

    PlanContext between(const PlanCurve& a, const PlanCurve& b, double radius,
                        const Progress& progress) const {
        if (settings_.first_curve.empty()) return context_;
        if (a.closed) {
            const bool a_outside = std::abs(turned_area(a)) > std::abs(turned_area(b));
            return cut_to_curves(context_, settings_.name, a_outside ? a : b, a_outside ? b : a, radius,
                                 progress);
        }
        PlanCurve around{a.points, true};
        around.points.insert(around.points.end(), b.points.rbegin(), b.points.rend());
        return cut_to_curves(context_, settings_.name, around, std::nullopt, radius, progress);
    }

    StrategyResult planned(const CurveJob& job, const Blend& blend, const Progress& progress) const {
        const bool fixed = settings_.stepover.is_number();
        const double step = fixed ? settings_.stepover.number : job.level_step(), widest = blend.widest();
        const double wanted = widest / step;
        if (wanted > max_blends)
            throw Error(ErrorCode::limit_exceeded, "stepover",
                        "it asks for more than " + format_number(max_blends) + " passes",
                        "allow a larger tolerance or set a step-over");
        FamilyPlanner planner(job, blend, blend_reach * std::min(step, 2 * job.radius()));
        const int halvings =
            fixed ? 0 : std::max(0, int(std::floor(std::log2(std::max(wanted / first_passes, 1.0)))));
        const int count = std::max(1, int(std::ceil(wanted / double(1 << halvings))));
        std::vector<double> places;
        // Beyond either curve by the cutter's radius, for tips that touch its border: half of one in w.
        const int beyond = std::max(1, int(std::ceil(job.radius() / (step * double(1 << halvings)))));
        for (int i = beyond; i > 0; --i)
            places.push_back(-0.5 * i / beyond);
        for (int i = 0; i <= count; ++i)
            places.push_back(double(i) / count);
        for (int i = 1; i <= beyond; ++i)
            places.push_back(1 + 0.5 * i / beyond);
        const Progress making = progress.part(0, 0.6, "Passes from curve to curve");
        std::vector<FamilyLine> lines;
        for (const double w : places)
            lines.push_back(planner.whole_line(w, making.part(0, 0)));
        if (!fixed) {
            planner.fill(lines, false, making);
            planner.fill_overlooked(lines, false, *job.context.part, progress.part(0.6, 0.75));
        }
        StrategyResult result;
        take_passes(std::move(lines), result);
        result.stepover_min = result.stepover_max = step;
        return finished(job, planner, std::move(result), "check part and curves", progress.part(0.75, 1));
    }

    const MorphSettings& settings_;
    const PlanContext& context_;
    PlanText text_;
};

} // namespace

const ParameterTable<MorphSettings>& morph_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = MorphSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        t.set_help("direction", "Where no curves are named: the outline is divided where it reaches farthest "
                                "in this direction, either way. auto picks x or y by the change of normals.");
        add_tool_axis_parameter(t);
        t.add(&S::first_curve, {.key = "first_curve",
                                .label = "First curve",
                                .help = "Name of a boundary of the setup, with the curve at which the passes "
                                        "begin. Empty, both: halves of the outline of what is cut.",
                                .kind = K::text});
        t.add(&S::second_curve, {.key = "second_curve",
                                 .label = "Second curve",
                                 .help = "Name of the boundary with the curve at which the passes end.",
                                 .kind = K::text});
        t.add(&S::open, {.key = "open",
                         .label = "Open",
                         .help = "The curves end at their last corners, instead of going back to the first.",
                         .kind = K::boolean});
        add_stepover_parameter(t);
        add_curve_parameters(t);
        return t;
    }();
    return table;
}

StrategyResult Morph::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    return MorphPlanner(settings_, context).run(progress);
}

} // namespace facetmill
