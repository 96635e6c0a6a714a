#include "core/job/work_estimate.h"

#include "core/strategy/lathe/lathe.h"
#include "core/strategy/plan/budget.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr double max_points = 2e7, max_bytes = 4e9, max_seconds = 4 * 3600, notable_seconds = 60;
/// What a point of a path takes from the first look to the last file, measured on the samples: 20 million
/// points of a lathe path take 6.5 GB.
constexpr double bytes_per_point = 320;
constexpr double seconds_upright = 2e-5, seconds_turning = 1e-5, seconds_tilted = 3e-4;

/// The step on a level plane that leaves this cusp.
double level_step(const CutterProfile& cutter, double cusp) {
    double lo = 0, hi = cutter.max_radius();
    if (cutter.height_at(hi) <= cusp) return 2 * hi;
    for (int k = 0; k < 100; ++k) {
        const double mid = 0.5 * (lo + hi);
        (cutter.height_at(mid) <= cusp ? lo : hi) = mid;
    }
    return 2 * lo;
}

double number_or(const Operation& operation, const char* key, double otherwise) {
    if (!operation.has(key)) return otherwise;
    const ParameterValue value = operation.get(key);
    const auto* number = std::get_if<double>(&value);
    return number ? *number : otherwise;
}

double area_of(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        sum += 0.5 * mesh.facet_cross(f).norm();
    return sum;
}

double points_about_axis(const LatheCommon& lathe, const Operation& operation, const PreparedPart& part,
                         const CutterProfile& cutter, double chord) {
    const Vec3 size = part.box.size();
    const int axis = lathe.axis == LatheCommon::Axis::y ? 1 : lathe.axis == LatheCommon::Axis::z ? 2 : 0;
    const double length = lathe.axis == LatheCommon::Axis::points ? size.norm() : size[axis];
    const double radius = 0.5 * std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
    const double step = number_or(operation, "side_feed", level_step(cutter, lathe.tolerance));
    const double fewest = pi / std::acos(std::clamp(1 - chord / std::max(radius, chord), 0.0, 1.0));
    const double per_turn = std::max(fewest, number_or(operation, "points_per_turn", 0));
    return length / step * per_turn;
}

} // namespace

bool WorkEstimate::large() const {
    return points > max_points || bytes > max_bytes || seconds > max_seconds;
}

bool WorkEstimate::notable() const {
    return large() || seconds > notable_seconds;
}

std::string WorkEstimate::text() const {
    constexpr double hour = 3600, day = 24 * hour;
    const std::string time = seconds < 60     ? "a minute"
                             : seconds < hour ? format_number(seconds / 60, 2) + " min"
                             : seconds < day  ? format_number(seconds / hour, 2) + " h"
                                              : format_number(seconds / day, 2) + " days";
    return "about " + format_number(points / 1e6, 2) + " million points, " + format_number(bytes / 1e9, 2)
           + " GB, " + time;
}

std::vector<WorkEstimate> estimate_plan(const Project& project, const PreparedPart& part,
                                        const std::string& only_operation) {
    std::vector<WorkEstimate> all;
    for (const auto& operation : project.operations) {
        const OperationCommon& common = operation->common();
        if (!only_operation.empty() && common.name != only_operation) continue;
        // Roughing knows its own bounds; the others follow a surface.
        if (operation->linking() == Linking::over_stock || !(common.tolerance > 0)) continue;
        const CutterProfile cutter(project.tool_of(*operation).cutter());
        const double asked = number_or(*operation, "chord_tolerance", 0);
        const double chord = chord_budget({asked, asked > 0 ? "" : "auto"}, common.tolerance);
        WorkEstimate e;
        e.what = "operation '" + printable(common.name) + "'";
        if (const LatheCommon* lathe = operation->turning()) {
            e.points = points_about_axis(*lathe, *operation, part, cutter, chord);
            e.seconds = e.points * seconds_turning;
        } else if (operation->has("stepover")) {
            const Vec3 size = part.box.size();
            const bool upright = operation->three_axis();
            const double area = upright ? size.x() * size.y() : area_of(*part.mesh);
            const double step = number_or(*operation, "stepover", level_step(cutter, common.tolerance));
            const double along = std::sqrt(8 * chord * cutter.max_radius());
            e.points = area / (std::max(step, 1e-300) * along);
            e.seconds = e.points * (upright ? seconds_upright : seconds_tilted);
        } else {
            continue;
        }
        e.bytes = e.points * bytes_per_point;
        all.push_back(std::move(e));
    }
    return all;
}

double estimate_places(const PreparedPart& part, double spacing) {
    return 2 * area_of(*part.mesh) / (spacing * spacing);
}

} // namespace facetmill
