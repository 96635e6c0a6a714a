// What a plan leaves on disk: APT programs and report.json.
#include "core/base/file.h"
#include "core/base/strict_json.h"
#include "core/job/new_folder.h"
#include "core/job/planner.h"
#include "core/output/apt.h"
#include "core/output/turning_table.h"
#include "core/strategy/global_local/rework_plan.h"
#include "core/strategy/lathe/lathe.h"

#include <cmath>
#include <system_error>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_name = 60;

Json numbers(const Vec3& v, double per) {
    Json list = Json::array();
    for (int k = 0; k < 3; ++k)
        list.push_back(json_number(v[k] / per, "report"));
    return list;
}

Json box_json(const Box3& box, double per) {
    return Json{{"low", numbers(box.lo, per)}, {"high", numbers(box.hi, per)}};
}

/// What only programs of several axes have.
void add_machine_run(Json& entry, const OperationResult& o) {
    const auto number = [&](double v) {
        return json_number(v, "report: operation '" + printable(o.name) + "'");
    };
    const MachineRun& run = *o.machine_run;
    const auto& seconds = o.path.stage_seconds;
    if (!o.path.turned)
        entry["seconds_by_stage"] = Json{{"cc", number(seconds[0])},
                                         {"bottom", number(seconds[1])},
                                         {"top", number(seconds[2])},
                                         {"choose", number(seconds[3])}};
    if (o.path.lead_min <= o.path.lead_max)
        entry["lead_degrees"] =
            Json::array({number(degrees(o.path.lead_min)), number(degrees(o.path.lead_max))});
    Json reversals;
    for (std::size_t j = 0; j < run.joints.size(); ++j)
        reversals[run.joints[j]] = run.reversals[j];
    entry["joint_reversals"] = std::move(reversals);
    entry["largest_angular_rate_degrees_per_second"] = number(degrees(run.largest_angular_rate));
    entry["machine_findings"] = run.findings;
}

/// Of global-local CM2: its regions, and what each of its two programs takes. The operation's own lengths and
/// time are those of both.
void add_rework(Json& entry, const OperationResult& o, double per) {
    const auto number = [&](double v) {
        return json_number(v, "report: operation '" + printable(o.name) + "'");
    };
    const ReworkPlan& plan = *o.path.rework;
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

} // namespace

NewFolder::NewFolder(const fs::path& path) {
    std::error_code ec;
    fs::path top = path;
    while (!top.empty() && !fs::exists(top, ec)) {
        made_.push_back(top);
        top = top.has_relative_path() ? top.parent_path() : fs::path();
    }
    fs::create_directories(path, ec);
    if (std::error_code none; !fs::is_directory(path, none)) {
        remove();
        throw Error(ErrorCode::unwritable, printable(path.string(), 400),
                    "cannot make the folder" + (ec ? ": " + ec.message() : std::string()),
                    "name a folder that exists or can be made");
    }
}

void NewFolder::remove() {
    std::error_code ec;
    for (const fs::path& p : made_)
        fs::remove(p, ec); // only when empty
}

std::string report_json(const Project& project, const PlanResult& result) {
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
        entry["passes"] = o->path.drive_planes;
        entry["stepover_min"] = number(o->path.stepover_min / per);
        entry["stepover_max"] = number(o->path.stepover_max / per);
        entry["cc_points"] = o->cc_points;
        entry["cl_points"] = o->cl_points;
        entry["cleanup_points"] = o->path.cleanup_points;
        entry["rework_regions"] = o->path.rework_regions;
        entry["cut_length"] = number(o->totals.cut_length / per);
        entry["rapid_length"] = number(o->totals.rapid_length / per);
        entry["time_seconds"] = number(o->totals.time_seconds);
        entry["cusp_max"] = number(o->path.cusp_max / per);
        entry["warnings"] = std::move(warnings);
        entry["seconds_planning"] = number(o->seconds_planning);
        entry["direction_degrees"] = number(degrees(o->path.direction));
        if (o->path.stock_cell > 0) {
            entry["layers"] = o->path.layers.size();
            entry["remaining_height"] = number(o->path.cusp_max / per);
            entry["air_length"] = number(o->program.motions.air_length / per);
        }
        if (o->path.turned) {
            const TurnedPath& t = *o->path.turned;
            if (!o->path.layers.empty()) entry["layers"] = o->path.layers.size();
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
        if (o->machine_run) add_machine_run(entry, *o);
        if (o->path.rework) add_rework(entry, *o, per);
        operations.push_back(std::move(entry));
    }
    const MeshReport& mesh = result.part->report;
    Json report;
    report["units"] = std::string(unit_name(project.unit));
    report["part"] = Json{{"file", printable(project.part.file, 400)},
                          {"facets", mesh.facets},
                          {"watertight", mesh.watertight},
                          {"box", box_json(result.part->box, per)},
                          {"warnings", mesh.warnings}};
    report["stock"] = Json{{"kind", stock_kind_name(project.stock.kind)},
                           {"box", box_json(result.stock.box, per)},
                           {"warnings", result.stock_warnings}};
    report["machine"] = project.machine;
    report["operations"] = std::move(operations);
    return pretty_json(report);
}

std::string program_file_name(std::size_t place, const std::string& operation_name) {
    std::string name;
    for (char ch : operation_name) {
        const auto c = static_cast<unsigned char>(ch);
        if ((c & 0xC0) == 0x80) continue; // one '-' per UTF-8 character
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')
                           || c == '_' || c == '.';
        if (plain)
            name += ch;
        else if (!name.empty() && name.back() != '-')
            name += '-';
        if (name.size() == longest_name) break;
    }
    while (!name.empty() && (name.back() == '-' || name.back() == '.'))
        name.pop_back();
    if (name.empty()) name = "operation";
    const std::string number = std::to_string(place);
    return (number.size() < 2 ? "0" + number : number) + "-" + name + ".apt";
}

static std::size_t place_in_project(const Project& project, const PlanResult& result, std::size_t program) {
    const std::string& owner = result.operations[result.owner(program)]->name;
    std::size_t place = 0;
    while (place < project.operations.size() && project.operations[place]->common().name != owner)
        ++place;
    return place;
}

const Operation& operation_of(const Project& project, const PlanResult& result, std::size_t program) {
    return *project.operations.at(place_in_project(project, result, program));
}

std::string program_file_name(const Project& project, const PlanResult& result, std::size_t program) {
    return program_file_name(place_in_project(project, result, program) + 1,
                             result.operations[program]->name);
}

std::string turning_table_name(std::size_t place, const std::string& operation_name, int pass) {
    std::string name = program_file_name(place, operation_name);
    name.resize(name.size() - 4);
    if (pass >= 0) name += (pass < 9 ? "-pass-0" : "-pass-") + std::to_string(pass + 1);
    return name + ".txt";
}

std::vector<fs::path> write_plan(const Project& project, const PlanResult& result, const fs::path& folder,
                                 const Progress& progress) {
    if (result.operations.empty())
        throw Error(ErrorCode::empty_result, "plan", "no operation was planned", "plan at least one");
    const NewFolder made(folder);
    OutputSet files;
    std::vector<fs::path> paths;
    const double n = double(result.operations.size());
    for (std::size_t i = 0; i < result.operations.size(); ++i) {
        const OperationResult& o = *result.operations[i];
        const std::size_t place = place_in_project(project, result, i);
        paths.push_back(folder / program_file_name(project, result, i));
        const Progress part = progress.part(double(i) / n, double(i + 1) / n, "Writing");
        write_apt(o.program, files.add(paths.back()), part);
        if (o.path.turned) {
            const auto* turns = place < project.operations.size()
                                    ? dynamic_cast<const TurnsPart*>(project.operations[place].get())
                                    : nullptr;
            const bool modulo = turns && turns->lathe().winding == LatheCommon::Winding::modulo;
            for (const TurningTableRange& range : turning_table_ranges(o.program, o.path)) {
                paths.push_back(folder / turning_table_name(place + 1, o.name, range.pass));
                write_turning_table(o.program, *o.path.turned, range,
                                    modulo ? AngleWinding::modulo : AngleWinding::unwound,
                                    files.add(paths.back()), part);
            }
        }
    }
    paths.push_back(folder / "report.json");
    files.add(paths.back()).write(report_json(project, result));
    progress.check();
    files.commit();
    return paths;
}

} // namespace facetmill
