#include "core/job/report.h"

#include "core/base/parameter_json.h"
#include "core/base/strict_json.h"
#include "core/job/repaired_mesh.h"
#include "core/strategy/global_local/rework_plan.h"

#include <cmath>

namespace facetmill {

namespace {

Json numbers(const Vec3& v, double per) {
    Json list = Json::array();
    for (int k = 0; k < 3; ++k)
        list.push_back(json_number(v[k] / per, "report"));
    return list;
}

Json box_json(const Box3& box, double per) {
    return Json{{"low", numbers(box.lo, per)}, {"high", numbers(box.hi, per)}};
}

/// The turning axis, the diameters and what the cutter cannot reach; only programs of a turning part have it.
void add_turning(Json& entry, const TurnedPath& t, const std::string& name, double per) {
    const auto number = [&](double v) {
        return json_number(v, "report: operation '" + printable(name) + "'");
    };
    if (!t.layers.empty()) entry["layers"] = t.layers.size();
    entry["turning"] = Json{{"axis_point", numbers(t.axis.point, per)},
                            {"axis_direction", numbers(t.axis.direction, 1)},
                            {"part_diameter", number(2 * t.part_radius / per)},
                            {"stock_diameter", number(2 * t.stock_radius / per)},
                            {"from", number(t.from / per)},
                            {"to", number(t.to / per)}};
    if (t.surface_area > 0) {
        Json regions = Json::array();
        for (const UnreachedRegion& r : t.unreached)
            regions.push_back(Json{{"why", unreached_name(r.why)},
                                   {"area", number(r.area / (per * per))},
                                   {"angle_from", number(degrees(r.angle_from))},
                                   {"angle_to", number(degrees(r.angle_to))},
                                   {"from", number(r.from / per)},
                                   {"to", number(r.to / per)},
                                   {"distance", number(r.distance / per)}});
        entry["turning"]["surface_area"] = number(t.surface_area / (per * per));
        entry["turning"]["unreached"] = std::move(regions);
    }
}

/// What only programs of several axes have.
void add_machine_run(Json& entry, const OperationResult& o) {
    const auto number = [&](double v) {
        return json_number(v, "report: operation '" + printable(o.name) + "'");
    };
    const MachineRun& run = *o.machine_run;
    if (!o.path.as<TurnedPath>()) {
        const auto* tilted = o.path.as<TiltedPath>();
        const auto seconds = tilted ? tilted->stage_seconds : std::array<double, 4>{};
        entry["seconds_by_stage"] = Json{{"cc", number(seconds[0])},
                                         {"bottom", number(seconds[1])},
                                         {"top", number(seconds[2])},
                                         {"choose", number(seconds[3])}};
    }
    if (const auto* leads = o.path.as<LeadRange>(); leads && leads->any())
        entry["lead_degrees"] =
            Json::array({number(degrees(leads->lead_min)), number(degrees(leads->lead_max))});
    Json reversals;
    for (std::size_t j = 0; j < run.joints.size(); ++j)
        reversals[run.joints[j]] = run.reversals[j];
    entry["joint_reversals"] = std::move(reversals);
    entry["largest_angular_rate_degrees_per_second"] = number(degrees(run.largest_angular_rate));
    entry["machine_findings"] = run.findings;
}

/// Regions of global-local CM2, and what each of its two programs takes. The operation's own lengths and time
/// are those of both.
void add_rework(Json& entry, const OperationResult& o, double per) {
    const auto number = [&](double v) {
        return json_number(v, "report: operation '" + printable(o.name) + "'");
    };
    const ReworkPlan& plan = *o.path.as<GlobalLocalPath>()->rework;
    const auto program = [&](const OperationResult& one) {
        return Json{{"tool", one.program.tool_number},
                    {"passes", one.path.drive_planes},
                    {"cl_points", one.cl_points},
                    {"cut_length", number(one.totals.cut_length / per)},
                    {"rapid_length", number(one.totals.rapid_length / per)},
                    {"time_seconds", number(one.totals.time_seconds)}};
    };
    double cut = o.totals.cut_length, rapid = o.totals.rapid_length, time = o.totals.time_seconds;
    entry["main"] = program(o);
    for (const auto& further : o.further) {
        entry["rework"] = program(*further);
        cut += further->totals.cut_length;
        rapid += further->totals.rapid_length;
        time += further->totals.time_seconds;
    }
    entry["cut_length"] = number(cut / per);
    entry["rapid_length"] = number(rapid / per);
    entry["time_seconds"] = number(time);
    Json regions = Json::array();
    for (const ReworkRegion& r : plan.regions.regions) {
        Json region{{"name", r.strip.name},
                    {"reason", r.strip.reason},
                    {"tool", r.strip.tool},
                    {"enabled", r.strip.enabled},
                    {"area", number(r.strip.area / (per * per))},
                    {"boundaries", r.strip.boundaries.size()},
                    {"place", numbers(r.place, per)}};
        if (std::isfinite(r.lead_largest)) region["lead_largest_degrees"] = number(degrees(r.lead_largest));
        regions.push_back(std::move(region));
    }
    entry["regions"] = std::move(regions);
    entry["boundary_pairs"] = plan.pairs.size();
    entry["part_area"] = number(plan.part_area / (per * per));
    entry["rework_area"] = number(plan.regions.area / (per * per));
    entry["remaining_fraction"] = number(plan.part_area > 0 ? plan.remaining_area / plan.part_area : 0);
}

/// All that is said of one setup.
Json report_of(const Project& project, const PlanResult& result, const std::vector<double>& air) {
    const double per = mm_per(project.unit);
    Json operations = Json::array();
    for (std::size_t i = 0; i < result.operations.size(); ++i) {
        if (result.owner(i) != i) continue; // stands with its operation
        const auto& o = result.operations[i];
        const auto number = [&](double v) {
            return json_number(v, "report: operation '" + printable(o->name) + "'");
        };
        Json warnings = Json::array();
        for (const auto& w : o->warnings())
            warnings.push_back(w);
        Json entry;
        entry["name"] = o->name;
        entry["kind"] = o->kind;
        if (o->view != Mat3::Identity()) {
            Json axis = Json::array();
            for (int k = 0; k < 3; ++k)
                axis.push_back(number(o->view(2, k)));
            entry["tool_axis"] = std::move(axis);
        }
        entry["passes"] = o->path.drive_planes;
        entry["stepover_min"] = number(o->path.stepover_min / per);
        entry["stepover_max"] = number(o->path.stepover_max / per);
        entry["cc_points"] = o->cc_points;
        entry["cl_points"] = o->cl_points;
        entry["cleanup_points"] = o->path.cleanup_points;
        const auto* global_local = o->path.as<GlobalLocalPath>();
        entry["rework_regions"] = global_local ? global_local->rework->regions.regions.size() : 0;
        entry["cut_length"] = number(o->totals.cut_length / per);
        entry["rapid_length"] = number(o->totals.rapid_length / per);
        entry["time_seconds"] = number(o->totals.time_seconds);
        double in_air = 0, turn = 0;
        for (std::size_t k = i; k < result.operations.size() && result.owner(k) == i; ++k) {
            in_air += air.empty() ? 0 : air.at(k);
            turn = std::max(turn, result.operations[k]->totals.turn_max);
        }
        if (!air.empty()) entry["feed_in_air_length"] = number(in_air / per);
        entry["turn_max_degrees"] = number(degrees(turn));
        entry["cusp_max"] = number(o->path.cusp_max / per);
        entry["warnings"] = std::move(warnings);
        entry["seconds_planning"] = number(o->seconds_planning);
        entry["direction_degrees"] = number(degrees(o->path.direction));
        if (!o->path.direction_reason.empty()) entry["direction_reason"] = o->path.direction_reason;
        if (const auto* rough = o->path.as<RoughPath>()) {
            entry["layers"] = rough->layers.size();
            entry["remaining_height"] = number(o->path.cusp_max / per);
            entry["air_length"] = number(o->program.motions.air_length / per);
        }
        if (const auto* turned = o->path.as<TurnedPath>()) add_turning(entry, *turned, o->name, per);
        if (o->machine_run) add_machine_run(entry, *o);
        if (global_local) add_rework(entry, *o, per);
        operations.push_back(std::move(entry));
    }
    Json idle = Json::array();
    for (const auto& o : result.idle)
        idle.push_back(Json{{"name", o->name}, {"kind", o->kind}, {"nothing_to_do", o->nothing_to_do}});
    const MeshReport& mesh = result.part->report;
    Json report;
    report["units"] = std::string(unit_name(project.unit));
    report["part"] = Json{{"file", printable(project.part.file, 400)},
                          {"facets", mesh.facets},
                          {"watertight", mesh.watertight},
                          {"box", box_json(result.part->box, per)},
                          {"warnings", mesh.warnings}};
    if (const auto& surfaces = mesh.surfaces)
        report["part"]["surfaces"] = Json{{"chord_tolerance", surfaces->chord / per},
                                          {"deviation_out", result.part->surface_deviation[0] / per},
                                          {"deviation_in", result.part->surface_deviation[1] / per},
                                          {"faces", surfaces->faces},
                                          {"solids", surfaces->solids}};
    if (!result.part->repairs.empty())
        report["part"]["repair"] = repairs_json(result.part->repairs, project.unit);
    report["stock"] = Json{{"kind", stock_kind_name(project.stock.kind)},
                           {"box", box_json(result.stock.box, per)},
                           {"warnings", result.stock_warnings}};
    report["machine"] = project.machine;
    report["operations"] = std::move(operations);
    if (!result.idle.empty()) report["idle_operations"] = std::move(idle);
    return report;
}

} // namespace

std::string report_json(const Project& project, const PlanResult& result, const std::vector<double>& air) {
    return pretty_json(report_of(project, result, air));
}

std::string setups_report_json(std::span<const SetupPlan> setups,
                               const std::vector<std::vector<double>>& air) {
    const Project& project = setups.front().project;
    if (setup_count(project) == 1) return report_json(project, *setups.front().plan, air.front());
    Json report;
    report["units"] = std::string(unit_name(project.unit));
    Json all = Json::array();
    for (std::size_t i = 0; i < setups.size(); ++i) {
        if (!setups[i].asked) continue;
        const Project& view = setups[i].project;
        Json entry;
        entry["name"] = printable(view.name, 200);
        Json place = Json::object();
        SetupPlace held = view.place;
        write_parameters(place, "place", ParameterView<SetupPlace>(held, place_parameters()), view.unit);
        entry["place"] = std::move(place);
        const Json own = report_of(view, *setups[i].plan, air.at(i));
        for (auto member = own.begin(); member != own.end(); ++member)
            entry[member.key()] = *member;
        all.push_back(std::move(entry));
    }
    report["setups"] = std::move(all);
    return pretty_json(report);
}

} // namespace facetmill
