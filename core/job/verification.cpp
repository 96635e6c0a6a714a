#include "core/job/verification.h"

#include "core/base/figures.h"
#include "core/base/strict_json.h"
#include "core/base/tolerances.h"
#include "core/job/verify_object.h"
#include "core/output/apt.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/surface/boundary_region.h"

#include <array>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

constexpr double min_gouge_limit = 1e-4; // mm
/// What is called a gouge, in chord tolerances: paths use up one of them, and the numbers of a machine's
/// program, scales and thermal growth as much again.
constexpr double gouge_chords = 2;
/// Distance of the rays that are asked whether a motion cuts, in step-overs, between these in radii of the
/// cutter, and their number at most.
constexpr double air_share_of_step = 0.4, air_shares_of_radius[] = {0.08, 0.25}, max_air_rays = 1e7;

const char* kind_name(Collision::Kind kind) {
    switch (kind) {
    case Collision::Kind::shank:
        return "shank";
    case Collision::Kind::holder:
        return "holder";
    case Collision::Kind::rapid:
        return "rapid";
    case Collision::Kind::cutter:
        return "cutter";
    }
    return "";
}

const char* uncut_word(UncutReason::Why why) {
    switch (why) {
    case UncutReason::Why::not_cut:
        return "not_cut";
    case UncutReason::Why::passes_apart:
        return "passes_apart";
    case UncutReason::Why::no_operation:
        return "no_operation";
    case UncutReason::Why::no_tool:
        return "no_tool_reaches";
    case UncutReason::Why::held:
        return "holder_touches";
    case UncutReason::Why::stock:
        return "stock_touches";
    case UncutReason::Why::below_bottom:
        return "below_bottom";
    case UncutReason::Why::fixture:
        return "fixture";
    case UncutReason::Why::tab:
        return "tab";
    case UncutReason::Why::boundary:
        return "boundary";
    case UncutReason::Why::outside_stock:
        return "outside_stock";
    case UncutReason::Why::not_seen:
        return "no_axis_sees";
    case UncutReason::Why::upright:
        return "upright_wall";
    }
    return "";
}

/// Values of a verification in the project's units.
class Numbers {
public:
    explicit Numbers(const Project& project) : per_(mm_per(project.unit)) {}
    Json plain(double v) const { return json_number(v, "verify.json"); }
    Json length(double mm) const { return plain(mm / per_); }
    Json area(double mm2) const { return plain(mm2 / (per_ * per_)); }
    Json volume(double mm3) const { return plain(mm3 / (per_ * per_ * per_)); }
    Json point(const Vec3& p) const { return Json::array({length(p.x()), length(p.y()), length(p.z())}); }
    static Json direction(const Vec3& n) {
        Json list = Json::array();
        for (int k = 0; k < 3; ++k)
            list.push_back(json_number(n[k], "verify.json"));
        return list;
    }

    void put(Json& to, const DeviationFigures& f) const {
        to["gouge_max"] = length(f.gouge_max);
        to["excess_p50"] = length(f.excess_p50);
        to["excess_p95"] = length(f.excess_p95);
        to["excess_p99"] = length(f.excess_p99);
        to["excess_p999"] = length(f.excess_p999);
        to["excess_max"] = length(f.excess_max);
        to["over_fraction"] = plain(f.over_fraction);
        to["uncut_fraction"] = plain(f.uncut_fraction);
        to["area"] = area(f.area);
        to["samples"] = f.samples;
    }

private:
    double per_;
};

/// Null for a great circle, which needs no word.
const char* course_name(AxisCourse course) {
    switch (course) {
    case AxisCourse::great_circle:
        return nullptr;
    case AxisCourse::normalized_linear:
        return "normalized linear";
    case AxisCourse::joint_linear:
        return "joint linear";
    }
    return nullptr;
}

void put_place(Json& to, const MotionPlace& at, std::span<const VerifyProgram> programs) {
    if (!at.known()) return;
    to["operation"] = printable(programs[at.program].name, 200);
    to["goto"] = at.motion + 1;
    if (const auto& lines = programs[at.program].lines; !lines.empty()) to["line"] = lines[at.motion];
    if (const char* name = course_name(at.course)) to["interpolation"] = name;
}

Json extremes(const Numbers& n, const std::vector<DeviationExtreme>& list,
              std::span<const VerifyProgram> programs) {
    Json all = Json::array();
    for (const DeviationExtreme& e : list) {
        Json one;
        one["deviation"] = n.length(e.deviation);
        put_place(one, e.by, programs);
        one["place"] = n.point(e.point);
        one["normal"] = Numbers::direction(e.normal);
        all.push_back(std::move(one));
    }
    return all;
}

std::string place_text(const MotionPlace& at, std::span<const VerifyProgram> programs) {
    if (!at.known()) return "nowhere";
    const VerifyProgram& program = programs[at.program];
    const char* course = course_name(at.course);
    return "'" + printable(program.name) + "', "
           + (program.lines.empty() ? "GOTO " + std::to_string(at.motion + 1)
                                    : "line " + std::to_string(program.lines[at.motion]))
           + (course ? std::string(", where the axis turns ") + course : std::string());
}

/// "12 % of what is to be cut is left uncut, up to 3.1 mm (no tool fits: 11 %; ...), limit 2 %".
std::string uncut_text(const Verification& v, LengthUnit unit) {
    double area = 0, highest = 0;
    for (const UncutReason& r : v.uncut)
        if (r.counts()) {
            area += r.area;
            highest = std::max(highest, r.excess_max);
        }
    std::string reasons;
    for (const UncutReason& r : v.uncut)
        if (r.counts())
            reasons += (reasons.empty() ? "" : ", ") + uncut_reason_text(r) + ": "
                       + percent_text(area > 0 ? v.uncut_share * r.area / area : 0);
    return percent_text(v.uncut_share) + " of what is to be cut is left uncut, up to "
           + length_text(highest, unit) + " (" + reasons + "), limit " + percent_text(v.used.uncut_limit);
}

} // namespace

bool same_shape(const AptCutter& a, const AptCutter& b) {
    const double least = tolerance::same_shape * std::max(a.d, b.d);
    const auto near = [](double x, double y, double by) { return std::abs(x - y) <= by; };
    return near(a.d, b.d, least) && near(a.r, b.r, least) && near(a.e, b.e, least) && near(a.f, b.f, least)
           && near(a.alpha, b.alpha, tolerance::same_shape) && near(a.beta, b.beta, tolerance::same_shape);
}

std::string verdict_name(Verdict verdict) {
    switch (verdict) {
    case Verdict::verified:
        return "verified";
    case Verdict::failed:
        return "failed";
    case Verdict::not_judged:
        return "not_judged";
    }
    return "";
}

std::string touched_text(const Collision& collision) {
    if (!collision.fixture.empty()) return " in the fixture '" + printable(collision.fixture) + "'";
    return collision.with_part ? " in the part" : " in the stock";
}

/// "the shank in the part".
std::string collider_text(const Collision& collision) {
    const std::string touched = touched_text(collision);
    if (collision.kind == Collision::Kind::rapid) return "a rapid" + touched;
    return std::string("the ") + kind_name(collision.kind) + touched;
}

std::string uncut_reason_text(const UncutReason& reason) {
    const std::string of = reason.program.empty() ? "" : " of '" + printable(reason.program) + "'";
    switch (reason.why) {
    case UncutReason::Why::not_cut:
        return (of.empty() ? "a tool" : "the tool" + of) + " fits but does not go there";
    case UncutReason::Why::passes_apart:
        return "the passes" + of + " lie too far apart there";
    case UncutReason::Why::no_operation:
        return "no operation finishes there: only the tool" + of + " fits, and that operation leaves stock";
    case UncutReason::Why::no_tool:
        return "no tool fits";
    case UncutReason::Why::held:
        return "the cutter" + of + " fits, but its shank or holder would touch the part";
    case UncutReason::Why::stock:
        return "the tool" + of + " fits, but its shank or holder would touch stock that stands";
    case UncutReason::Why::below_bottom:
        return "the tool" + of + " fits, but would go below the bottom of the stock";
    case UncutReason::Why::fixture:
        return "the tool" + of + " fits, but would come too near to a fixture";
    case UncutReason::Why::tab:
        return "the tool" + of + " fits, but a tab is to stay there";
    case UncutReason::Why::boundary:
        return "the tool" + of + " fits, but its boundary leaves the place out";
    case UncutReason::Why::outside_stock:
        return "the stock does not reach there";
    case UncutReason::Why::not_seen:
        return "no tool axis sees it";
    case UncutReason::Why::upright:
        return "it is an upright wall, which asks for no pass of its own";
    }
    return {};
}

/// What the operation of this name is not there for: how much it may leave on the part, where another tool is
/// to cut, and what it does not look at.
static void set_task(VerifyProgram& program, const Project& project, const std::string& name) {
    for (const auto& o : project.operations) {
        if (o->common().name != name) continue;
        program.leaves = o->left_on_purpose() + o->common().tolerance;
        if (o->has("tilt_limit") && !o->keeps_axis()) program.seen_along = Vec3::UnitZ();
        // A clean-up that is not asked for what stands cuts what the tool before it cannot enter.
        const Operation::ReadsLeft left = o->reads_left();
        if (o->purpose() != Purpose::cleaning || left.any()) return;
        for (const Tool& t : project.further_tools_of(*o))
            program.beyond = t.cutter();
        return;
    }
}

std::vector<VerifyProgram> verify_programs(const Project& project,
                                           const std::shared_ptr<const PlanResult>& plan) {
    std::vector<VerifyProgram> programs;
    const auto machine = std::make_shared<const Machine>(project_machine(project));
    for (const auto& o : plan->operations) {
        const auto tool = std::find_if(project.tools.begin(), project.tools.end(),
                                       [&](const Tool& t) { return t.number == o->program.tool_number; });
        VerifyTool used = tool != project.tools.end() ? VerifyTool(*tool) : VerifyTool(o->program.cutter);
        programs.push_back({o->name,
                            std::move(used),
                            {o, &o->program.motions},
                            o->program.motions.turning,
                            {},
                            machine,
                            o->joints});
        set_task(programs.back(), project, o->name);
        set_feeds(programs.back(), o->program);
        if (o->within)
            programs.back().asked = [region = o->within->region, view = o->view](const Vec3& p) {
                Index hint = no_index;
                return region->holds(view * p, hint);
            };
    }
    stand_fixtures(programs, *plan->part);
    return programs;
}

void set_feeds(VerifyProgram& program, const ClSection& section) {
    program.feed = section.feed_mm_per_min;
    program.feeds = section.motion_feeds;
}

void stand_fixtures(std::vector<VerifyProgram>& programs, const PreparedPart& part) {
    for (VerifyProgram& program : programs)
        program.fixtures = part.fixtures;
}

std::vector<double> feed_in_air(const Project& project, const std::shared_ptr<const PlanResult>& plan,
                                const Progress& progress) {
    if (!(plan->stock.box.size().minCoeff() > 0)) return {};
    const std::vector<VerifyProgram> programs = verify_programs(project, plan);
    double resolution = infinity;
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const double radius = programs[i].tool.cutter.max_radius(),
                     step = plan->operations[i]->path.stepover_min;
        // So that no pass falls between two rays.
        resolution =
            std::min(resolution, std::clamp(air_share_of_step * step, air_shares_of_radius[0] * radius,
                                            air_shares_of_radius[1] * radius));
    }
    if (const double rays = StockLattice::rays_over(plan->stock.box, resolution); rays > max_air_rays)
        resolution *= std::sqrt(rays / max_air_rays);
    StockModel stock(plan->stock, StockLattice::over(plan->stock.box, resolution), progress.part(0, 0.1));
    MaterialRemoval removal(programs, resolution, 0);
    removal.cut_only_along(2);
    std::vector<double> air;
    const double n = double(programs.size());
    for (std::size_t i = 0; i < programs.size(); ++i) {
        removal.cut(stock, i, 0, programs[i].motions->motions.size(), 1, false,
                    progress.part(0.1 + 0.9 * double(i) / n, 0.1 + 0.9 * double(i + 1) / n));
        air.push_back(removal.air_length(i));
    }
    progress.set(1.0);
    return air;
}

/// The tool of a section of a CL file; appends to `remarks` what is not known of it.
static VerifyTool tool_of(const Project& project, const ClSection& section, const AptReadResult::Tool& said,
                          const std::string& file, const std::string& name,
                          std::vector<std::string>& remarks) {
    // A cutter that is assumed would make the verdict worth nothing.
    if (!said.cutter)
        throw Error(ErrorCode::missing_key, file, "there is no CUTTER statement",
                    "add CUTTER/d,r,e,f,alpha,beta,h before the first GOTO");
    const auto cutter = [&]() -> VerifyTool {
        try {
            return VerifyTool(section.cutter);
        } catch (const Error& e) {
            throw Error(e.code(), file + ": CUTTER", e.message(), e.remedy());
        }
    };
    const std::string number = std::to_string(section.tool_number);
    auto tool = std::find_if(project.tools.begin(), project.tools.end(),
                             [&](const Tool& t) { return t.number == section.tool_number; });
    if (tool == project.tools.end()) {
        remarks.push_back("'" + name + "': the project has no tool " + number
                          + ", so shank and holder are not known and were not judged.");
    } else if (!said.number && same_shape(tool->cutter(), section.cutter)) {
        remarks.push_back("'" + name + "' names no tool (LOADTL): its cutter is that of tool " + number
                          + ", so shank and holder of that were judged.");
    } else if (!said.number) {
        tool = project.tools.end();
        remarks.push_back("'" + name + "' names no tool (LOADTL), and its cutter is not that of tool "
                          + number + ": shank and holder are not known and were not judged.");
    }
    if (tool == project.tools.end()) return cutter();
    // Shank and holder stand on the cutter that the file has.
    VerifyTool used(*tool), own = cutter();
    const double longer = own.cutter.height() - used.cutter.height();
    for (ToolSection& s : used.sections) {
        s.from += longer;
        s.to += longer;
    }
    used.cutter = std::move(own.cutter);
    return used;
}

ClFilePrograms read_verify_programs(const Project& project, const fs::path& path, const Progress& progress) {
    const std::string file = printable(path.string(), 400);
    AptReadResult read = read_apt(path, project.unit, progress);
    ClFilePrograms result;
    const auto machine = std::make_shared<const Machine>(project_machine(project));
    result.ignored = std::move(read.ignored);
    for (std::size_t i = 0; i < read.program.sections.size(); ++i) {
        const auto& section = read.program.sections[i];
        const std::string own = path.filename().string();
        std::string name =
            read.program.sections.size() == 1 ? own : own + ", operation " + std::to_string(i + 1);
        VerifyTool tool = tool_of(project, *section, read.tools[i], file, printable(name), result.remarks);
        result.programs.push_back(
            {std::move(name), std::move(tool), {section, &section->motions}, std::nullopt, {}, machine});
        set_task(result.programs.back(), project, section->operation_name);
        set_feeds(result.programs.back(), *section);
        result.sections.push_back(section);
    }
    return result;
}

/// True where an operation of the project is meant to leave more than `allowance`.
static bool operation_leaves_more(const Project& project, const std::string& name, double allowance) {
    return std::any_of(project.operations.begin(), project.operations.end(), [&](const auto& o) {
        return o->common().name == name && o->left_on_purpose() > allowance;
    });
}

VerifySettings verify_settings(const Project& project, const PlanResult* plan) {
    VerifySettings settings;
    settings.unit = project.unit;
    const Operation* last = nullptr;
    for (const Operation* o : operations_on(project)) {
        const bool planned = !plan
                             || std::any_of(plan->operations.begin(), plan->operations.end(),
                                            [&](const auto& r) { return r->name == o->common().name; });
        // What cuts after it and leaves more puts nothing back.
        if (planned && (!last || o->left_on_purpose() <= last->left_on_purpose())) last = o;
    }
    if (last) {
        const OperationCommon& common = last->common();
        settings.tolerance = common.tolerance;
        settings.allowance = last->left_on_purpose();
        // Nobody says what chord tolerance was kept.
        settings.gouge_limit = chord_budget({0, "auto"}, common.tolerance);
    }
    if (plan && !plan->operations.empty()) {
        settings.gouge_limit = 0;
        for (const auto& o : plan->operations) {
            // What leaves more on purpose is coarser, and has no claim to be so on the part itself.
            const bool roughs = operation_leaves_more(project, o->name, settings.allowance);
            if (!roughs) settings.gouge_limit = std::max(settings.gouge_limit, o->path.chord_tolerance);
        }
    }
    settings.gouge_limit = std::max(gouge_chords * settings.gouge_limit, min_gouge_limit);
    if (project.limits.gouge_limit.is_number()) settings.gouge_limit = project.limits.gouge_limit.number;
    settings.uncut_limit = project.limits.uncut_limit;
    if (project.part.flip) settings.open_side = OpenSide::other;
    settings.cut_before = project.stock.kind == StockSpec::Kind::rest;
    settings.look_for_pieces = true;
    return settings;
}

Json verify_object(const Project& project, std::span<const VerifyProgram> programs, const Verification& v) {
    const Numbers n(project);
    Json out;
    out["units"] = std::string(unit_name(project.unit));
    out["verdict"] = verdict_name(v.verdict());
    DeviationFigures all = v.figures;
    all.gouge_max = std::max(all.gouge_max, v.border.gouge_max);
    n.put(out, all);
    out["samples"] = v.surface->points.size();
    out["samples_judged"] = v.figures.samples;
    Json reasons = Json::array();
    for (const UncutReason& r : v.uncut) {
        Json one;
        one["why"] = uncut_word(r.why);
        if (!r.program.empty()) one["operation"] = r.program;
        one["area"] = n.area(r.area);
        one["excess_max"] = n.length(r.excess_max);
        one["place"] = n.point(r.place);
        reasons.push_back(std::move(one));
    }
    out["uncut_reasons"] = std::move(reasons);
    out["uncut_share"] = n.plain(v.uncut_share);
    out["not_judged_fraction"] = n.plain(v.not_judged_share);
    if (!v.not_judged.empty()) out["not_judged"] = v.not_judged;

    Json collisions = Json::array();
    for (const Collision& c : v.collisions) {
        Json one;
        one["kind"] = kind_name(c.kind);
        one["with"] = !c.fixture.empty() ? "fixture" : c.with_part ? "part" : "stock";
        if (!c.fixture.empty()) one["fixture"] = printable(c.fixture, 200);
        put_place(one, c.at, programs);
        one["depth"] = n.length(c.depth);
        one["place"] = n.point(c.place);
        collisions.push_back(std::move(one));
    }
    out["collisions"] = std::move(collisions);
    if (v.loose) {
        Json loose;
        loose["part_is_free"] = v.loose->part_is_free;
        loose["pieces"] = v.loose->count;
        loose["largest_volume"] = n.volume(v.loose->largest.volume);
        put_place(loose, v.loose->at, programs);
        out["loose_pieces"] = std::move(loose);
    }
    out["gouges"] = extremes(n, v.gouges, programs);
    out["excess"] = extremes(n, v.excess, programs);

    Json operations = Json::array();
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const auto count = std::count_if(v.collisions.begin(), v.collisions.end(),
                                         [&](const Collision& c) { return c.at.program == i; });
        Json one;
        one["name"] = printable(programs[i].name, 200);
        one["motions"] = programs[i].motions->motions.size();
        one["gouge_max"] = n.length(v.program_gouges[i]);
        one["collisions"] = count;
        one["feed_in_air_length"] = n.length(v.program_air[i]);
        const CuttingLoad& load = v.program_loads[i];
        one["volume_removed"] = n.volume(load.volume);
        one["peak_removal_rate"] = n.volume(load.peak_rate);
        if (load.peak_rate > 0) one["peak_removal_goto"] = load.peak_motion + 1;
        one["verdict"] = verdict_name(v.verdict_where(count > 0 || v.program_gouges[i] > v.used.gouge_limit));
        operations.push_back(std::move(one));
    }
    out["operations"] = std::move(operations);

    Json bands = Json::array();
    for (const SlopeBand& b : v.bands) {
        Json one;
        one["slope_degrees"] = Json::array({n.plain(degrees(b.from)), n.plain(degrees(b.to))});
        n.put(one, b.figures);
        bands.push_back(std::move(one));
    }
    out["slope_bands"] = std::move(bands);
    Json border;
    n.put(border, v.border);
    out["border"] = std::move(border);

    Json used;
    used["tolerance"] = n.length(v.used.tolerance);
    used["gouge_limit"] = n.length(v.used.gouge_limit);
    used["uncut_limit"] = n.plain(v.used.uncut_limit);
    used["allowance"] = n.length(v.used.allowance);
    used["resolution"] = n.length(v.used.resolution);
    used["sample_spacing"] = n.length(v.used.sample_spacing);
    used["motion_bound"] = n.length(v.used.motion_bound);
    out["settings"] = std::move(used);
    out["stock_volume"] = n.volume(v.stock->volume());
    out["seconds"] = Json{{"cutting", n.plain(v.seconds_cutting)}, {"probing", n.plain(v.seconds_probing)}};
    Json remarks = Json::array();
    for (const std::string& r : v.remarks)
        remarks.push_back(r);
    out["remarks"] = std::move(remarks);
    return out;
}

std::string verify_json(const Project& project, std::span<const VerifyProgram> programs,
                        const Verification& result) {
    return pretty_json(verify_object(project, programs, result));
}

std::string findings_line(const Project& project, std::span<const VerifyProgram> programs,
                          const Verification& v) {
    std::string line;
    const auto join = [&](const std::string& more) { line += (line.empty() ? "" : "; ") + more; };
    if (v.gouged()) {
        const std::string deep = length_text(std::max(v.figures.gouge_max, v.border.gouge_max), project.unit);
        const std::string limit = length_text(v.used.gouge_limit, project.unit);
        join(v.gouges.empty() ? "gouge of " + deep + ", limit " + limit
                              : "gouge of " + deep + " (" + place_text(v.gouges.front().by, programs)
                                    + "), limit " + limit);
    }
    if (!v.collisions.empty()) {
        const auto worst =
            std::max_element(v.collisions.begin(), v.collisions.end(),
                             [](const Collision& a, const Collision& b) { return a.depth < b.depth; });
        const std::string deep = length_text(worst->depth, project.unit) + " by " + collider_text(*worst)
                                 + " (" + place_text(worst->at, programs) + ")";
        join(v.collisions.size() == 1
                 ? "1 collision, the deepest " + deep
                 : std::to_string(v.collisions.size()) + " collisions, the deepest " + deep);
    }
    if (v.left_uncut())
        join(uncut_text(v, project.unit));
    else if (!line.empty())
        join("excess " + length_text(v.figures.excess_max, project.unit));
    if (!v.not_judged.empty()) join("it cannot be judged: " + v.not_judged);
    return line;
}

} // namespace facetmill
