#include "core/job/work_estimate.h"

#include "core/mesh/mesh_area.h"
#include "core/strategy/global_local/find_regions.h"
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
constexpr double seconds_upright = 2e-5, seconds_turning = 1e-5;
/// A point of a roughing path cuts the stock as well; one of clean-up is looked for beside valleys first.
constexpr double seconds_roughing = 4e-4, seconds_cleaning_up = 3e-4, seconds_of_levels = 2e-4;
/// A node of a point's grid of postures, and a place at which strips are measured for an adaptive step-over:
/// as many radii apart, and looked at for about as many planes before one is taken.
constexpr double seconds_a_posture = 2e-6, seconds_a_strip = 3e-4, strip_radii = 0.25, planes_tried = 8;
/// From one pass to the next the cheapest path looks at every posture before every other.
constexpr double seconds_a_pair = 1e-8;
/// Global-local CM2 plans a main path, once more where that leaves too much, and a path of rework, each about
/// as long as a finishing path or longer, and looks for regions before and after the main path: on facets of
/// a share of the squared distance of trajectories.
constexpr double paths_a_round = 4, searches_a_round = 2, region_facet_share = 0.05,
                 seconds_a_region_facet = 5e-6, max_region_facets = 4e6;
/// Points of a layer of roughing for each radius of its lines: ends of lines, and borders.
constexpr double points_a_radius = 0.3;
/// Of the part's surface, what clean-up comes by.
constexpr double cleanup_share = 0.3;
/// The same for waterlines: what is steep.
constexpr double steep_share = 0.5;

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

/// Nodes of the grid of postures that is asked at every point.
double postures_of(const Operation& operation) {
    const double step = std::max(number_or(operation, "grid_degrees", radians(3)), 1e-9);
    const auto nodes = [&](const char* key, double otherwise) {
        if (!operation.has(key)) return otherwise / step + 1;
        const ParameterValue value = operation.get(key);
        const auto* limits = std::get_if<std::array<double, 2>>(&value);
        return (limits ? (*limits)[1] - (*limits)[0] : otherwise) / step + 1;
    };
    return nodes("lead_limits", radians(45)) * nodes("yaw_limits", radians(90));
}

/// What global-local CM2 takes where a finishing path of the same settings takes `finishing` seconds.
double seconds_with_rework(const GlobalLocalSettings& settings, double finishing, const PreparedPart& part,
                           double area, double radius) {
    const double spacing = trajectory_spacing(part.box, radius);
    const double facets = std::min(area / (region_facet_share * spacing * spacing), max_region_facets);
    const double rounds = may_raise_lead_limit(settings) ? 2 : 1;
    return rounds * (paths_a_round * finishing + searches_a_round * facets * seconds_a_region_facet);
}

/// Layers and lines as Lu's tolerance asks for them (rough_setup.h); the part's box stands for the stock.
double points_of_layers(const Operation& operation, const Project& project, const PreparedPart& part,
                        const CutterProfile& cutter) {
    const Vec3 size = part.box.size();
    const double radius = cutter.max_radius(), tolerance = operation.common().tolerance;
    const double step = std::max(number_or(operation, "stepover", 1.9 * radius), 1e-300);
    const double height = size.z() + project.stock.margin[2];
    double layers = height / std::max(number_or(operation, "depth", infinity), 1e-300);
    if (!(layers > 0)) { // from the tolerance: what lines between others cost layers save
        constexpr int most = 64;
        double least = infinity;
        for (int m = 1; m <= most; ++m) {
            const double depth =
                std::min(tolerance - cutter.height_at(std::min(0.5 * step / m, radius)), 2 * radius);
            if (depth > 0) least = std::min(least, height / depth + (m > 1 ? m : 0));
        }
        layers = std::isfinite(least) ? std::max(least, 1.0) : 1;
    }
    return layers * size.x() * size.y() / step * points_a_radius / radius;
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
    for (const Operation* operation : operations_on(project)) {
        const OperationCommon& common = operation->common();
        if (!only_operation.empty() && common.name != only_operation) continue;
        if (!(common.tolerance > 0)) continue;
        const CutterProfile cutter(project.tool_of(*operation).cutter());
        const double radius = cutter.max_radius();
        const double asked = number_or(*operation, "chord_tolerance", 0);
        const double chord = chord_budget({asked, asked > 0 ? "" : "auto"}, common.tolerance);
        const double along = std::sqrt(8 * chord * radius), usual_step = level_step(cutter, common.tolerance);
        const double step = std::max(number_or(*operation, "stepover", usual_step), 1e-300);
        WorkEstimate e;
        e.what = "operation '" + printable(common.name) + "'";
        if (const LatheCommon* lathe = operation->turning()) {
            e.points = points_about_axis(*lathe, *operation, part, cutter, chord);
            e.seconds = e.points * seconds_turning;
        } else if (operation->linking() == Linking::over_stock) {
            e.points = points_of_layers(*operation, project, part, cutter);
            e.seconds = e.points * seconds_roughing;
        } else if (operation->has(
                       "stepdown")) { // levels over what is steep, on planes as far apart as passes
            const double down = std::max(number_or(*operation, "stepdown", step), 1e-300);
            e.points = steep_share * mesh_area(*part.mesh) / (down * along);
            e.seconds = e.points * seconds_of_levels;
            if (operation->has("stepover")) { // and passes over what is not
                const Vec3 size = part.box.size();
                const double points = size.x() * size.y() / (step * along);
                e.points += points;
                e.seconds += points * seconds_upright;
            }
        } else if (!operation->has("stepover")) { // clean-up: passes beside valleys
            e.points = cleanup_share * mesh_area(*part.mesh) / (step * along);
            e.seconds = e.points * seconds_cleaning_up;
        } else if (operation->three_axis() || operation->has("tilt_limit")) {
            const Vec3 size = part.box.size();
            e.points = size.x() * size.y() / (step * along);
            e.seconds = e.points * seconds_upright;
        } else {
            const double area = mesh_area(*part.mesh);
            e.points = area / (step * along);
            const double postures = postures_of(*operation), passes = std::sqrt(area) / step;
            e.seconds = e.points * postures * seconds_a_posture;
            if (operation->has("posture")
                && operation->get("posture") == ParameterValue(std::string("global")))
                e.seconds += passes * postures * postures * seconds_a_pair;
            if (number_or(*operation, "stepover", 0) == 0)
                e.seconds += area / (step * strip_radii * radius) * planes_tried * seconds_a_strip;
            if (const GlobalLocalSettings* rework = operation->rework())
                e.seconds = seconds_with_rework(*rework, e.seconds, part, area, radius);
        }
        e.bytes = e.points * bytes_per_point;
        all.push_back(std::move(e));
    }
    return all;
}

WorkEstimate estimate_of(const VerifyWork& work) {
    return {"the verification", work.places, work.bytes, work.seconds};
}

double estimate_places(const PreparedPart& part, double spacing) {
    return 2 * mesh_area(*part.mesh) / (spacing * spacing);
}

} // namespace facetmill
