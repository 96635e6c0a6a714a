#include "viz/path_tint.h"

#include "core/base/plane_geometry.h"
#include "core/job/planner.h"
#include "viz/overlay.h"
#include "viz/round_ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill {

namespace {

constexpr std::size_t values_per_check = 1u << 14;
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
/// Outliers are cut off the scale where they would take this share of it at least.
constexpr double worth_cutting = 0.4;
constexpr double minute = 60, longest_in_seconds = 300; // s

/// Values at the ends of the motions of one operation; of what belongs to a whole motion the same at both.
struct Values {
    std::vector<double> at;
    bool whole_motions = false;
    double before(std::size_t m) const {
        if (whole_motions || m == 0 || !std::isfinite(at[m])) return at[m];
        return std::isfinite(at[m - 1]) ? at[m - 1] : at[m];
    }
};

Values values_of(const PathFigures& figures, PathQuantity quantity, double per, const Progress& progress) {
    const OperationResult& operation = *figures.operation;
    const auto& motions = operation.program.motions.motions;
    Values values;
    values.at.assign(motions.size(), no_value);
    if (!path_quantity_missing(quantity, operation).empty()) return values;
    const auto scaled = [&](const std::vector<double>& from) {
        for (std::size_t m = 0; m < std::min(from.size(), motions.size()); ++m)
            values.at[m] = from[m] / per;
    };
    const auto& passes = operation.path.passes;
    switch (quantity) {
    case PathQuantity::kind:
        break;
    case PathQuantity::lead:
        for (std::size_t m = 0; m < motions.size(); ++m) {
            if (m % values_per_check == 0) progress.check();
            if (motions[m].kind == MotionKind::cut && motions[m].pass < passes.size()
                && motions[m].point < passes[motions[m].pass].cc.size())
                values.at[m] = degrees(
                    angle_between(passes[motions[m].pass].cc[motions[m].point].normal, motions[m].to.axis));
        }
        break;
    case PathQuantity::tilt:
        for (std::size_t m = 0; m < motions.size(); ++m)
            values.at[m] = degrees(angle_between(Vec3::UnitZ(), motions[m].to.axis));
        break;
    case PathQuantity::cusp:
        scaled(motion_cusps(operation, progress));
        break;
    case PathQuantity::feed:
        values.whole_motions = true;
        scaled(figures.feed);
        break;
    case PathQuantity::motion_time:
        values.whole_motions = true;
        scaled(figures.seconds);
        break;
    case PathQuantity::elapsed:
        scaled(figures.elapsed);
        break;
    case PathQuantity::joint_rate:
        values.whole_motions = true;
        scaled(figures.joint_rate);
        break;
    }
    return values;
}

/// Ends of the scale.
void find_range(TintedPath& path, std::vector<float> known) {
    std::sort(known.begin(), known.end());
    const double least = double(known.front()), most = double(known.back());
    path.low = least;
    path.high = most;
    const std::size_t off = known.size() / 100;
    const double low = double(known[off]), high = double(known[known.size() - 1 - off]);
    if (path.quantity != PathQuantity::elapsed && high > low
        && high - low < (1 - worth_cutting) * (most - least)) {
        path.low = low;
        path.high = high;
        path.below = least < low;
        path.above = most > high;
    }
    // Angles that no machine tells apart are one value.
    constexpr double same_angle = 1e-3;
    if (path.unit == "°" && path.high - path.low <= same_angle)
        path.low = path.high = same_angle * std::round(path.high / same_angle);
    // One value everywhere: the scale begins at 0.
    if (path.high - path.low <= 1e-6 * std::max(std::abs(path.high), 1e-9)) {
        path.low = std::min(0.0, path.low);
        if (path.high <= path.low) path.high = path.low + 1;
    }
}

void color(TintedPath::Lines& lines, double low, double high) {
    lines.rgba.reserve(4 * lines.values.size());
    for (const float v : lines.values) {
        const Rgb c =
            std::isfinite(v) ? path_tint_color((double(v) - low) / (high - low)) : fixed_colors().no_quantity;
        for (const double channel : {c.r, c.g, c.b})
            lines.rgba.push_back(std::uint8_t(std::lround(255 * channel)));
        lines.rgba.push_back(255);
    }
}

/// Runs of n segments as one.
TintedPath::Lines thinned_lines(const TintedPath::Lines& lines) {
    TintedPath::Lines thin;
    const std::size_t count = lines.values.size() / 2;
    if (count <= largest_path_without_preview) return thin;
    const std::size_t n = count / largest_path_without_preview + 1;
    for (std::size_t i = 0; i < count;) {
        std::size_t end = i + 1;
        while (end < count && end < i + n
               && std::equal(&lines.points[6 * end], &lines.points[6 * end] + 3, &lines.points[6 * end - 3]))
            ++end;
        const auto first = std::int32_t(thin.values.size());
        thin.segments.insert(thin.segments.end(), {first, first + 1});
        thin.points.insert(thin.points.end(), &lines.points[6 * i], &lines.points[6 * i] + 3);
        thin.points.insert(thin.points.end(), &lines.points[6 * end - 3], &lines.points[6 * end - 3] + 3);
        thin.values.insert(thin.values.end(), {lines.values[2 * i], lines.values[2 * end - 1]});
        i = end;
    }
    return thin;
}

} // namespace

std::string_view path_quantity_label(PathQuantity quantity) {
    constexpr std::string_view labels[path_quantities] = {
        "Kind of motion", "Lead", "Tilt", "Cusp", "Feed", "Time of the motion", "Elapsed time", "Joint rate"};
    return labels[std::size_t(quantity)];
}

std::string path_quantity_missing(PathQuantity quantity, const OperationResult& operation) {
    if (quantity == PathQuantity::tilt && !operation.program.multi_axis)
        return "With three axes the tool stands upright everywhere.";
    const auto record = operation.path.five_axis();
    if (quantity == PathQuantity::cusp && !(record && record->has_strips))
        return "Cusps are known point by point for 5-axis operations only; the report has the largest one.";
    return {};
}

Rgb path_tint_color(double t) {
    const auto& stops = fixed_colors().quantity;
    const double at = std::clamp(t, 0.0, 1.0) * double(stops.size() - 1);
    const auto i = std::min(std::size_t(at), stops.size() - 2);
    const double f = at - double(i);
    const Rgb &a = stops[i], &b = stops[i + 1];
    return {a.r + f * (b.r - a.r), a.g + f * (b.g - a.g), a.b + f * (b.b - a.b)};
}

TintedPathPtr prepare_tinted_path(const std::vector<PathFiguresPtr>& operations, PathQuantity quantity,
                                  LengthUnit unit, const Progress& progress,
                                  const std::vector<PathSource>& shown) {
    if (quantity == PathQuantity::kind) return nullptr;
    auto path = std::make_shared<TintedPath>();
    path->quantity = quantity;
    Box3 box;
    double longest = 0;
    for (const auto& o : operations) {
        for (const Motion& m : o->operation->program.motions.motions)
            if (m.to.tip.allFinite()) box.add(m.to.tip);
        if (!o->elapsed.empty()) longest = std::max(longest, o->elapsed.back());
    }
    if (box.empty()) return nullptr;
    path->center = box.center();
    double per = 1;
    switch (quantity) {
    case PathQuantity::kind:
        break;
    case PathQuantity::lead:
    case PathQuantity::tilt:
        path->unit = "°";
        break;
    case PathQuantity::cusp:
        path->unit = unit_name(unit);
        per = mm_per(unit);
        break;
    case PathQuantity::feed:
        path->unit = edge_unit_name(Quantity::feed, unit);
        per = core_per_edge(Quantity::feed, unit);
        break;
    case PathQuantity::motion_time:
        path->unit = "s";
        break;
    case PathQuantity::elapsed:
        path->unit = longest > longest_in_seconds ? "min" : "s";
        per = longest > longest_in_seconds ? minute : 1;
        break;
    case PathQuantity::joint_rate:
        path->unit = "%";
        per = 0.01;
        break;
    }
    for (std::size_t o = 0; o < operations.size(); ++o) {
        const Progress here =
            progress.part(double(o) / double(operations.size()), double(o + 1) / double(operations.size()));
        const Values values = values_of(*operations[o], quantity, per, here);
        const auto& motions = operations[o]->operation->program.motions.motions;
        for (std::size_t m = 1; m < motions.size(); ++m) {
            if (m % values_per_check == 0) here.check();
            if (o < shown.size() && !shown[o].shows_motion(m)) continue;
            const Vec3 &from = motions[m - 1].to.tip, &to = motions[m].to.tip;
            if (motions[m].kind == MotionKind::rapid || !from.allFinite() || !to.allFinite()) continue;
            TintedPath::Lines& lines = path->lines[std::size_t(motions[m].kind)];
            const auto first = std::int32_t(lines.values.size());
            lines.segments.insert(lines.segments.end(), {first, first + 1});
            for (const Vec3& p : {Vec3(from - path->center), Vec3(to - path->center)})
                lines.points.insert(lines.points.end(), {float(p.x()), float(p.y()), float(p.z())});
            lines.values.insert(lines.values.end(), {float(values.before(m)), float(values.at[m])});
        }
    }
    std::vector<float> known;
    for (TintedPath::Lines& lines : path->lines) {
        const std::size_t before = known.size();
        std::copy_if(lines.values.begin(), lines.values.end(), std::back_inserter(known),
                     [](float v) { return std::isfinite(v); });
        const std::size_t found = known.size() - before;
        if (found == 0)
            lines = {};
        else
            path->unknown |= found < lines.values.size();
    }
    if (known.empty()) return nullptr;
    progress.check();
    find_range(*path, std::move(known));
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        progress.check();
        path->preview[k] = thinned_lines(path->lines[k]);
        color(path->lines[k], path->low, path->high);
        color(path->preview[k], path->low, path->high);
    }
    return path;
}

ColorBar TintedPath::bar() const {
    constexpr int steps = 120, max_marks = 5;
    constexpr double min_gap = 0.12;
    ColorBar bar;
    bar.title = std::string(path_quantity_label(quantity)) + " (" + unit + ")";
    if (quantity == PathQuantity::joint_rate) bar.note = "of the largest speed";
    for (int i = 0; i < steps; ++i)
        bar.colors.push_back(path_tint_color((i + 0.5) / steps));
    bar.below = path_tint_color(0);
    bar.above = path_tint_color(1);
    bar.has_below = below;
    bar.has_above = above;
    bar.marks.emplace_back(0.0, format_number(low, 3));
    for (const double v : round_ticks(low, high, max_marks))
        if (const double at = (v - low) / (high - low); at > min_gap && at < 1 - min_gap)
            bar.marks.emplace_back(at, format_number(v, 3));
    bar.marks.emplace_back(1.0, format_number(high, 3));
    if (unknown) bar.other = {fixed_colors().no_quantity, "no value"};
    return bar;
}

} // namespace facetmill
