#include "core/strategy/preview/preview_curves.h"

#include "core/strategy/preview/preview_levels.h"
#include "core/strategy/surface/boundary_region.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Spokes that go all the way to the centre, at least, as Radial has them; more lines than this no plan has.
constexpr int whole_spokes = 8;
constexpr double max_curves = 20'000;

/// The ring that an operation cuts.
struct PreviewRing {
    Vec2 center;
    double from, to;
};

PreviewRing ring_of(const RadialCommon& settings, const PreviewRequest& request, const PreviewField& field) {
    Interval x{infinity, -infinity}, y = x;
    const CoarseGrid& ground = field.tips().ground().grid();
    for (std::size_t i = 0; i < field.grid().size(); ++i) {
        if (!field.kept(i)) continue;
        const Vec2 p = ground.middle(std::size_t(field.tips().holder(i)));
        x = {std::min(x.lo, p.x()), std::max(x.hi, p.x())};
        y = {std::min(y.lo, p.y()), std::max(y.hi, p.y())};
    }
    PreviewRing ring{Vec2(0.5 * (x.lo + x.hi), 0.5 * (y.lo + y.hi)), settings.from_radius, 0};
    if (!settings.center_of_part)
        ring.center =
            (request.turn * Vec3(settings.center[0], settings.center[1], settings.center[2])).head<2>();
    for (const double cx : {x.lo, x.hi})
        for (const double cy : {y.lo, y.hi})
            ring.to = std::max(ring.to, (Vec2(cx, cy) - ring.center).norm());
    if (settings.to_radius.is_number()) ring.to = std::min(ring.to, settings.to_radius.number);
    if (!(ring.to > ring.from))
        throw Error(ErrorCode::out_of_range, settings.name, "between its radii there is nothing",
                    "let it end farther out than it begins");
    return ring;
}

Vec2 on_circle(const PreviewRing& ring, double radius, double angle) {
    return ring.center + radius * Vec2(std::cos(angle), std::sin(angle));
}

/// The curves of a boundary or, where none is named, the outline of what is cut.
std::vector<PlanCurve> asked_curves(const PreviewRequest& request, std::size_t i, bool open) {
    std::vector<PlanCurve> curves;
    if (i < request.context.curves.size() && !request.context.curves[i].all.empty()) {
        curves = request.context.curves[i].all;
    } else {
        const CoarseGround& ground = *request.ground;
        std::vector<char> cells(ground.grid().size());
        for (std::size_t k = 0; k < cells.size(); ++k)
            cells[k] = ground.on_part(k) && (request.asked.empty() || request.asked[k]);
        curves = cell_outlines(cells, ground.grid());
    }
    return ready_to_follow(std::move(curves), open);
}

void check_lines(double wanted) {
    if (wanted > max_curves)
        throw Error(ErrorCode::limit_exceeded, "stepover",
                    "it asks for more than " + format_number(max_curves) + " passes",
                    "allow a larger tolerance or set a step-over");
}

std::array<PlanCurve, 2> two_curves(const MorphSettings& settings, const PreviewRequest& request,
                                    double radius, const Progress& progress) {
    if (settings.first_curve.empty() != settings.second_curve.empty())
        throw Error(ErrorCode::missing_reference, settings.name, "only one of its two curves is named",
                    "name the other one too, or none to take the outline");
    if (settings.first_curve.empty()) {
        const std::vector<PlanCurve> outlines = asked_curves(request, request.context.curves.size(), false);
        if (outlines.empty())
            throw Error(ErrorCode::empty_result, settings.name, "nothing of the part is to be cut",
                        "check the boundary");
        const PlanCurve outline = longest_of(outlines);
        const auto around = curves_beside(outline, -radius, 0.1 * radius, progress);
        const bool whole = !around.empty() && longest_of(around).closed;
        return halves_of(whole ? longest_of(around) : outline,
                         Vec2(std::cos(request.travel), std::sin(request.travel)));
    }
    PlanCurve a = longest_of(asked_curves(request, 0, settings.open)),
              b = longest_of(asked_curves(request, 1, settings.open));
    if (a.closed != b.closed) a.closed = b.closed = false;
    if (a.closed) {
        b = begun_near(std::move(b), a.points.front());
    } else {
        const double same =
            (a.points.front() - b.points.front()).norm() + (a.points.back() - b.points.back()).norm();
        const double other =
            (a.points.front() - b.points.back()).norm() + (a.points.back() - b.points.front()).norm();
        if (other < same) b = reversed(std::move(b));
    }
    if (crossing_of(CurveCourse(a).line(), CurveCourse(b).line(), progress))
        throw Error(ErrorCode::out_of_range, settings.name, "its two curves cross or touch",
                    "draw them apart");
    return {a, b};
}

} // namespace

std::vector<PlanLine> spoke_lines(const RadialCommon& settings, const PreviewRequest& request,
                                  const PreviewField& field, const PreviewStep& allowed) {
    const PreviewRing ring = ring_of(settings, request, field);
    const double step = field.step_everywhere(allowed);
    const double inner = std::max(0.0, ring.from - field.tips().radius()),
                 outer = ring.to + field.tips().radius(), wanted = 2 * pi * outer / step;
    check_lines(wanted);
    const int halvings =
        allowed.fixed ? 0 : std::max(0, int(std::floor(std::log2(std::max(wanted / whole_spokes, 1.0)))));
    const int whole = std::max(1, int(std::ceil(wanted / double(1 << halvings))));
    const int all = whole << halvings;
    std::vector<PlanLine> lines;
    for (int i = 0; i < all; ++i) {
        double begin = inner;
        int level = 0;
        while (level < halvings && i % (1 << (halvings - level)) != 0)
            ++level;
        // Between the spokes of the level before it is needed only where these are farther apart.
        if (level > 0) begin = std::max(inner, step * double(whole << (level - 1)) / (2 * pi));
        const double angle = 2 * pi * i / all;
        if (begin < outer) lines.push_back({on_circle(ring, begin, angle), on_circle(ring, outer, angle)});
    }
    return lines;
}

std::vector<PlanLine> turn_lines(const RadialCommon& settings, const PreviewRequest& request,
                                 const PreviewField& field, const PreviewStep& allowed,
                                 const Progress& progress) {
    const PreviewRing ring = ring_of(settings, request, field);
    const double outer = ring.to + field.tips().radius();
    check_lines((outer - ring.from) / allowed.level);
    const auto turn = [&](double from, double to) {
        const int pieces = std::max(24, int(std::ceil(2 * pi * to / field.grid().cell)));
        PlanLine line;
        for (int k = 0; k <= pieces; ++k)
            line.push_back(
                on_circle(ring, from + (to - from) * k / pieces, k == pieces ? 0 : 2 * pi * k / pieces));
        return line;
    };
    std::vector<PlanLine> lines;
    for (double r = std::max(0.0, ring.from - field.tips().radius()); r < outer;) {
        progress.check();
        double advance = allowed.level;
        // Slopes towards the centre and away from it, all round.
        std::vector<double> steps;
        constexpr int looks = 16;
        for (int k = 0; k < looks; ++k) {
            const double a0 = 2 * pi * k / looks, a1 = 2 * pi * (k + 1) / looks;
            const Vec2 out = on_circle({Vec2::Zero(), 0, 0}, 1, 0.5 * (a0 + a1));
            if (const auto s =
                    field.step_over({on_circle(ring, r, a0), on_circle(ring, r, a1)}, out, allowed))
                steps.push_back(*s);
        }
        if (!steps.empty()) {
            const auto at = steps.begin() + std::ptrdiff_t(steps.size() / 4);
            std::nth_element(steps.begin(), at, steps.end());
            advance = *at;
        }
        lines.push_back(turn(r, r + advance));
        r += advance;
        check_lines(double(lines.size()));
    }
    return lines;
}

std::vector<PlanLine> blend_lines(const MorphSettings& settings, const PreviewRequest& request,
                                  const PreviewField& field, const PreviewStep& allowed,
                                  const Progress& progress) {
    const auto [a, b] = two_curves(settings, request, field.tips().radius(), progress.part(0, 0.5));
    const CurveCourse first(a), second(b);
    constexpr int places = 240;
    double widest = 0;
    const auto at = [&](double t, double w) {
        // A closed curve's end is not its beginning.
        const double s = t * (1 - 1e-12);
        return Vec2((1 - w) * first.at(s * first.length()) + w * second.at(s * second.length()));
    };
    for (int i = 0; i <= places; ++i) {
        const double t = double(i) / places;
        widest = std::max(widest, (at(t, 1) - at(t, 0)).norm());
    }
    const double step = field.step_everywhere(allowed);
    check_lines(widest / step);
    const int count = std::max(1, int(std::ceil(widest / step)));
    std::vector<PlanLine> lines;
    for (int k = 0; k <= count; ++k) {
        PlanLine line;
        for (int i = 0; i <= places; ++i)
            line.push_back(at(double(i) / places, double(k) / count));
        lines.push_back(std::move(line));
    }
    return lines;
}

std::vector<PlanLine> beside_lines(const AlongCurveSettings& settings, const PreviewRequest& request,
                                   const CoarseTips& tips, const Progress& progress) {
    const CoarseGround& ground = *request.ground;
    const CoarseGrid& grid = ground.grid();
    const auto over = [&](const Vec2& p) {
        // A cell about it counts: the outline itself runs over their middles.
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int x = grid.column(p.x()) + dx, y = grid.row(p.y()) + dy;
                if (grid.has(x, y) && ground.on_part(grid.index(x, y))) return true;
            }
        return false;
    };
    const bool on = settings.side == AlongCurveSettings::Side::on;
    const double far = settings.offset.is_number() ? settings.offset.number : tips.radius();
    const double left = on ? 0 : settings.side == AlongCurveSettings::Side::right ? -far : far;
    std::vector<PlanLine> lines;
    bool any_over = false;
    for (const PlanCurve& curve : asked_curves(request, 0, settings.open)) {
        const CurveCourse course(curve);
        const int looks = std::max(1, int(std::ceil(course.length() / grid.cell)));
        std::vector<PlanCurve> pieces;
        bool was = false, all = true;
        for (int k = 0; k <= looks; ++k) {
            if (k % 1024 == 0) progress.check();
            const Vec2 p = course.at(course.length() * k / looks);
            const bool is = over(p);
            if (is && !was) pieces.push_back({{}, false});
            if (is) pieces.back().points.push_back(p);
            all = all && is;
            was = is;
        }
        if (all) pieces.assign(1, curve);
        std::erase_if(pieces, [](const PlanCurve& c) { return c.points.size() < 2; });
        any_over = any_over || !pieces.empty();
        for (const PlanCurve& piece : pieces)
            for (PlanCurve& line : curves_beside(piece, left, 0.5 * grid.cell, progress)) {
                if (line.closed) line.points.push_back(line.points.front());
                lines.push_back(std::move(line.points));
            }
    }
    if (!any_over)
        throw Error(ErrorCode::out_of_range,
                    settings.curve.empty() ? settings.name : boundary_place(settings.curve),
                    "all of it lies off the part", "move it onto the part");
    if (lines.empty())
        throw Error(ErrorCode::empty_result, settings.name, "nothing runs so far to that side of it",
                    "choose a smaller offset or the other side");
    return lines;
}

void lay_everywhere(const CoarseTips& tips, const PlanLine& line, double rise,
                    std::vector<std::vector<Vec3>>& lines) {
    std::vector<Vec3> run;
    along_line(line, tips.spacing(), [&](const Vec2& p) {
        run.emplace_back(p.x(), p.y(), tips.height(p).value_or(tips.ground().bottom()) + rise);
    });
    if (run.size() > 1) lines.push_back(std::move(run));
}

} // namespace facetmill
