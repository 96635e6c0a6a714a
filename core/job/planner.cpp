#include "core/job/planner.h"

#include "core/base/keyed_hash.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/job/asked_operations.h"
#include "core/job/axis_view.h"
#include "core/job/bounds.h"
#include "core/job/cache_key.h"
#include "core/job/fixtures.h"
#include "core/job/placed_mesh.h"
#include "core/job/plan_remarks.h"
#include "core/job/project_inputs.h"
#include "core/job/repaired_mesh.h"
#include "core/job/stock_so_far.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/link/kept_within.h"
#include "core/link/link.h"
#include "core/mesh/geometry.h"
#include "core/mesh/outward.h"
#include "core/output/turning_table.h"
#include "core/strategy/five_axis/low_passes.h"
#include "core/strategy/five_axis/manual_posture.h"
#include "core/strategy/global_local/rework_plan.h"
#include "core/strategy/lathe/lathe.h"
#include "core/strategy/surface/region_edit.h"

#include <chrono>
#include <optional>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

/// A warning names this many of a machine's findings.
constexpr std::size_t max_findings_told = 3;
/// Rest material is looked for at samples, and with rays, so many radii of the tool apart that is to cut it;
/// an axis that turns is followed to this share of the tolerance.
constexpr double rest_sample_share = 0.25, rest_ray_share = 0.5, rest_motion_share = 0.2;

MachineRun machine_run(const MachineMotion& motion, const Machine& machine, LengthUnit unit) {
    MachineRun run;
    for (int j = 0; j < machine.joints(); ++j) {
        run.joints.push_back(machine.axis_name(j));
        run.reversals.push_back(motion.reversals[std::size_t(j)]);
    }
    run.largest_angular_rate = motion.largest_angular_rate;
    run.motions = motion.motions.size();
    run.findings = motion.findings.size();
    if (run.findings == 0) return run;
    std::string first;
    for (std::size_t i = 0; i < std::min(run.findings, max_findings_told); ++i)
        first += (i > 0 ? "; " : "") + finding_text(motion.findings[i], machine, unit);
    if (run.findings > max_findings_told) {
        const std::string rest = "and " + std::to_string(run.findings - max_findings_told) + " more";
        first += "; " + rest;
    }
    run.warnings.push_back(printable(machine.label) + " does not hold " + std::to_string(run.findings)
                           + " of " + std::to_string(run.motions) + " motions as planned: " + first);
    return run;
}

/// See OperationResult::out_of_reach. Of lengths the largest, else of angles the largest, else any axis that
/// the machine does not have.
std::string out_of_reach(const MachineMotion& motion, const ClSection& program, const Machine& machine,
                         LengthUnit unit) {
    using Kind = MotionFinding::Kind;
    const MotionFinding* worst = nullptr;
    std::size_t count = 0;
    const auto rank = [](const MotionFinding& f) {
        return f.kind == Kind::linear_travel ? 2 : f.kind == Kind::rotary_travel ? 1 : 0;
    };
    for (const MotionFinding& f : motion.findings) {
        if (f.kind == Kind::swing) continue; // within reach of the axes
        ++count;
        if (!worst || rank(f) > rank(*worst) || (rank(f) == rank(*worst) && f.amount > worst->amount))
            worst = &f;
    }
    if (!worst) return {};
    const Vec3 tip = program.motions.motions[worst->motion].to.tip / mm_per(unit);
    return finding_text(*worst, machine, unit) + ", with the tip at (" + format_number(tip.x(), 5) + ", "
           + format_number(tip.y(), 5) + ", " + format_number(tip.z(), 5) + ") "
           + std::string(unit_name(unit)) + "; " + printable(machine.label) + " cannot make "
           + std::to_string(count) + " of " + std::to_string(motion.motions.size()) + " motions";
}

bool has_limits(const Machine& machine) {
    return std::any_of(machine.travel.begin(), machine.travel.end(),
                       [](const Travel& t) { return t.limited(); });
}

/// All of a program but its motions, and what they take.
void finish_program(OperationResult& result, const Project& project, const Operation& operation,
                    const PlanContext& context, const Progress& progress) {
    ClSection& program = result.program;
    program.operation_name = result.name;
    program.tool_number = context.tool.number;
    program.tool_name = context.tool.name;
    program.cutter = context.tool.cutter();
    const OperationCommon& common = operation.common();
    program.feed_mm_per_min = common.feed;
    for (const Motion& m : program.motions.motions)
        program.motion_feeds.push_back(common.feed_of(m.kind));
    if (std::all_of(program.motion_feeds.begin(), program.motion_feeds.end(),
                    [&](double feed) { return feed == common.feed; }))
        program.motion_feeds.clear();
    program.spindle_rpm = operation.common().spindle;
    program.gauge_length = gauge_length(context.tool);
    program.part_box = context.part_box;
    if (const auto* turned = result.path.as<TurnedPath>()) {
        const LatheCommon* lathe = operation.turning();
        const bool modulo = lathe && lathe->winding == LatheCommon::Winding::modulo;
        program.turning = {turned->zero, modulo ? AngleWinding::modulo : AngleWinding::unwound,
                           turning_ranges(program.motions, result.path)};
    }
    MachineMotion followed;
    result.totals = motion_totals(program, context.machine, {.accelerations = operation.accelerations()},
                                  progress, &followed);
    if (program.multi_axis) {
        result.machine_run = machine_run(followed, context.machine, project.unit);
        auto joints = std::make_shared<std::vector<Joints>>();
        for (const MotionJoints& m : followed.motions)
            joints->push_back(m.at);
        result.joints = std::move(joints);
    }
    tell_what_stands(result, project, operation, context, progress);
    if (followed.motions.empty() && has_limits(context.machine))
        followed = machine_motion(program, context.machine, {}, progress);
    result.out_of_reach = out_of_reach(followed, program, context.machine, project.unit);
}

/// The program of an operation's rework path.
std::shared_ptr<const OperationResult> rework_program(const OperationResult& main, const Project& project,
                                                      const Operation& operation, PlanContext context,
                                                      const Progress& progress) {
    const ReworkPlan& plan = *main.path.as<GlobalLocalPath>()->rework;
    auto result = std::make_shared<OperationResult>();
    result->name = main.name + " rework";
    result->kind = main.kind;
    result->within = main.within;
    result->path = plan.path;
    context.tool = plan.tool;
    context.further_tools.clear();
    keep_passes_up(result->path, context, operation);
    for (const Pass& pass : result->path.passes) {
        result->cc_points += pass.cc.size();
        result->cl_points += pass.cl.size();
    }
    result->program.multi_axis = !plan.three_axis;
    result->program.motions = link_operation(operation, plan.three_axis ? Linking::upright : Linking::tilted,
                                             result->path, context, progress);
    finish_program(*result, project, operation, context, progress);
    return result;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

std::vector<std::string> OperationResult::warnings() const {
    std::vector<std::string> all = path.warnings;
    all.insert(all.end(), motion_warnings.begin(), motion_warnings.end());
    if (machine_run) all.insert(all.end(), machine_run->warnings.begin(), machine_run->warnings.end());
    return all;
}

std::vector<std::shared_ptr<const OperationResult>>
programs_of(const std::shared_ptr<const OperationResult>& operation) {
    if (!operation->nothing_to_do.empty()) return {};
    std::vector<std::shared_ptr<const OperationResult>> programs{operation};
    programs.insert(programs.end(), operation->further.begin(), operation->further.end());
    return programs;
}

std::size_t PlanResult::owner(std::size_t program) const {
    for (std::size_t i = program; i-- > 0;)
        for (const auto& further : operations[i]->further)
            if (further == operations[program]) return i;
    return program;
}

void PlanResult::check_reach() const {
    for (const auto& o : operations)
        if (!o->out_of_reach.empty())
            throw Error(
                ErrorCode::limit_exceeded, "operation '" + printable(o->name) + "'", o->out_of_reach,
                "choose another machine or tool, turn the part, or place it elsewhere on the machine");
}

void PlanResult::check_programs() const {
    if (!operations.empty()) return;
    if (idle.empty())
        throw Error(ErrorCode::empty_result, "plan", "no operation was planned", "plan at least one");
    throw Error(ErrorCode::empty_result, "operation '" + printable(idle.front()->name) + "'",
                idle.front()->nothing_to_do, "leave the operation out");
}

struct Planner::Cache {
    struct Planned {
        std::string path_key, motion_key, program_key;
        std::shared_ptr<const OperationResult> result;
        std::shared_ptr<const StrategyResult>
            in_view; ///< the path of an indexed one as it was planned, else null
        bool used = false;

        /// Names its motions: the same ones, the same name, in every run.
        std::string motions() const { return keyed_hash({}, motion_key).hex(); }
        std::shared_ptr<const PlanKeys> keys() const {
            return std::make_shared<const PlanKeys>(PlanKeys{path_key, motion_key, program_key, in_view});
        }
    };

    std::shared_ptr<KnownMeshes> meshes;
    std::string load_key, part_key, stock_key, held_key; ///< stock_key: empty where its mesh is none
    std::optional<RepairedMesh> loaded;
    std::shared_ptr<const PreparedPart> part;
    AxisView upright;
    std::vector<std::unique_ptr<AxisView>> indexed;
    RestMeshes rests;
    std::vector<Planned> planned;
    PlannerWork work;
    std::shared_ptr<const CarriedStock> carried;
    std::string left_key; ///< of `rest`
    std::shared_ptr<const EarlierLeft> rest;

    /// Part and fixtures as they stand, indexed.
    void index_part(const std::shared_ptr<const PreparedPart>& prepared, const Progress& progress) {
        if (!upright.index || upright.index->mesh_ptr() != prepared->mesh) ++work.indexes;
        upright.part = prepared;
        upright.index_part(progress);
    }
    AxisView& view_of(const Project& project, const Operation& operation, const PlanResult& setup,
                      const Progress& progress);
    Planned* find(std::string Planned::*key, const std::string& value) {
        for (Planned& p : planned)
            if (p.*key == value) return &p;
        return nullptr;
    }
    /// What the operations of `before` leave, as far as this one asks; `motions` names theirs. Material is
    /// kept until something of it changes.
    std::shared_ptr<const EarlierLeft> left(const Project& project,
                                            const std::shared_ptr<const PlanResult>& before,
                                            const Operation& operation, std::string_view motions,
                                            const Progress& progress);
    /// What names the motions of the operations before, where an operation asks for them.
    struct Asked {
        std::string by_strategy, by_links;
    };
    const Planned& operation(const Project& project, const Operation& operation, PlanContext context,
                             AxisView& view, const Asked& earlier, const Progress& progress);
    void plan_path(const Project& project, const Operation& operation, PlanContext& context, AxisView& view,
                   Planned& made, OperationResult& result, const Progress& progress);
    void link_path(const Operation& operation, const PlanContext& context, const AxisView& view,
                   Planned& made, OperationResult& result, const Progress& progress);
};

/// The view of an indexed operation, or the upright one.
AxisView& Planner::Cache::view_of(const Project& project, const Operation& operation, const PlanResult& setup,
                                  const Progress& progress) {
    if (!operation.is_indexed()) return upright;
    const std::string key = Key()
                                .add(std::string_view(part_key))
                                .add(std::string_view(held_key))
                                .add(std::string_view(axis_view_key(project, operation, setup.stock.box)))
                                .text();
    for (const auto& view : indexed)
        if (view->key == key) {
            view->used = true;
            return *view;
        }
    auto view =
        std::make_unique<AxisView>(*setup.part, project, operation, setup.stock.box, progress.part(0, 0.3));
    view->index_part(progress.part(0.3, 1));
    view->key = key;
    view->used = true;
    indexed.push_back(std::move(view));
    return *indexed.back();
}

/// All but tool, contact index and earlier cuts.
PlanContext context_of(const Project& project, const PreparedPart& part, const StockSolid& stock) {
    PlanContext context;
    context.part = part.mesh;
    context.geometry = part.geometry;
    context.part_box = part.box;
    context.stock_box = stock.box;
    context.stock = stock;
    context.machine = project_machine(project);
    for (std::size_t k = 0; k < 2; ++k)
        context.tessellation_tolerance[k] =
            std::max(project.part.tessellation_tolerance[k], part.surface_deviation[k]);
    context.unit = project.unit;
    return context;
}

/// What stands before an operation; still in the setup, but for the cuts.
void set_stock(PlanContext& context, StockSoFar::Before before) {
    // What holds the stock stays where it was.
    const double bottom = context.stock_box.lo.z();
    context.stock = std::move(before.stock);
    context.earlier = std::move(before.earlier);
    context.stock_box = context.stock.box;
    if (!context.stock_box.empty()) context.stock_box.lo.z() = std::min(context.stock_box.lo.z(), bottom);
}

/// Turns the context of an operation into its view.
void set_view(PlanContext& context, const AxisView& view) {
    context.contact = view.kept_off;
    if (view.fixtures) context.fixtures_box = view.fixtures->mesh().box();
    if (view.is_upright()) return;
    context.to_setup = view.turn.transpose();
    context.part = view.part->mesh;
    context.geometry = view.part->geometry;
    context.part_box = view.part->box;
    context.stock = turned_stock(context.stock, view.turn);
    context.stock_box = context.stock.box;
    if (!context.left) return;
    auto left = std::make_shared<EarlierLeft>(*context.left);
    for (auto* places : {&left->points, &left->rest})
        for (LeftPlace& place : *places) {
            place.point = view.turn * place.point;
            place.normal = view.turn * place.normal;
        }
    context.left = std::move(left);
}

Planner::Planner(std::shared_ptr<KnownMeshes> meshes) : cache_(std::make_unique<Cache>()) {
    cache_->meshes = meshes ? std::move(meshes) : std::make_shared<KnownMeshes>();
}
Planner::~Planner() = default;

const std::shared_ptr<KnownMeshes>& Planner::meshes() const {
    return cache_->meshes;
}

const PlannerWork& Planner::work() const {
    return cache_->work;
}

void Planner::carry(std::shared_ptr<const CarriedStock> stock) {
    cache_->carried = std::move(stock);
}

const std::shared_ptr<const CarriedStock>& Planner::carried() const {
    return cache_->carried;
}

std::shared_ptr<const PreparedPart> Planner::prepared() const {
    return cache_->part;
}

void Planner::adopt(const std::shared_ptr<const OperationResult>& result) {
    if (!result->keys || cache_->find(&Cache::Planned::program_key, result->keys->program)) return;
    const PlanKeys& keys = *result->keys;
    cache_->planned.push_back({keys.path, keys.motions, keys.program, result, keys.in_view});
}

namespace {

std::string rest_key(const std::shared_ptr<const CarriedStock>& carried, const Project& project) {
    if (!carried || carried->source != stock_source(project))
        throw Error(ErrorCode::missing_reference, "stock", "what the setup before leaves is not known yet",
                    "plan the setups before this one");
    return "rest" + carried->key;
}

} // namespace

std::shared_ptr<const PreparedPart> Planner::prepare(const Project& project, const Progress& progress) {
    Cache& c = *cache_;
    const fs::path path = project.part_path();
    const PartSpec spec = project.placed_part();
    const MeshReading how = project.part_reading();
    const std::string load_key = repaired_key(path, how, project.part_recipe());
    const std::string part_key = mesh_key(path, MeshPlace::of(spec)) + load_key + (spec.flip ? "flip" : "");
    const bool has_stock = project.stock.kind == StockSpec::Kind::mesh;
    const bool rests = project.stock.kind == StockSpec::Kind::rest;
    const std::string stock_key = has_stock ? mesh_key(project.stock_path(), MeshPlace::of(project.stock))
                                  : rests   ? rest_key(c.carried, project)
                                            : std::string();
    const Progress reading = progress.part(0.0, has_stock ? 0.7 : 1.0);
    if (!c.part || c.part_key != part_key) {
        if (!c.loaded || c.load_key != load_key) {
            RepairedMesh loaded =
                load_repaired(path, how, project.part_recipe(), reading.part(0.0, 0.6), c.meshes.get());
            ++c.work.loads;
            c.loaded = std::move(loaded);
            c.load_key = load_key;
        }
        auto part = std::make_shared<PreparedPart>();
        part->mesh = placed(c.loaded->mesh, MeshPlace::of(spec), reading.part(0.6, 0.62));
        // What the part is has one answer, for planners and verifier alike.
        const OutwardSides sides = outward_sides(*part->mesh, reading.part(0.62, 0.68),
                                                 project.part.flip ? OpenSide::other : OpenSide::found);
        part->mesh = wound_outward(part->mesh, sides);
        part->turned_facets = sides.turned_facets;
        part->report = c.loaded->report;
        part->faces = c.loaded->faces;
        if (const auto& surfaces = part->report.surfaces)
            part->surface_deviation = {surfaces->out * project.part.scale, surfaces->in * project.part.scale};
        part->repairs = c.loaded->repairs;
        part->box = part->mesh->box();
        if (project.part.scale != 1) add_scale_warnings(part->report, part->box);
        check_coordinates(part->box, "part");
        part->reach = reach_about_middle(*part->mesh, part->box);
        ++c.work.placements;
        c.part = std::move(part);
        c.part_key = part_key;
        c.stock_key.clear();
        c.held_key.clear();
        c.upright.index = c.upright.kept_off = nullptr;
    }
    c.part = with_normals(c.part, project, reading.part(0.68, 1.0, "Measuring the part"));
    if (c.stock_key != stock_key) {
        auto part = std::make_shared<PreparedPart>(*c.part);
        part->stock_mesh = has_stock ? load_solid(project.stock_path(), MeshPlace::of(project.stock), "stock",
                                                  progress.part(0.7, 1.0))
                           : rests   ? c.carried->mesh
                                     : nullptr;
        part->stock_box = part->stock_mesh ? part->stock_mesh->box() : Box3();
        part->stock_edge_loss = rests ? c.carried->edge_loss : 0;
        c.part = std::move(part);
        c.stock_key = stock_key;
    }
    const std::string held_key = fixtures_key(project);
    if (!c.part->kept_off || c.held_key != held_key) {
        auto part = std::make_shared<PreparedPart>(*c.part);
        auto fixtures = load_fixtures(project, progress.part(1.0, 1.0));
        part->kept_off = fixtures.empty() ? part->mesh : with_fixtures(*part->mesh, fixtures);
        part->fixtures = fixtures.empty()
                             ? nullptr
                             : std::make_shared<const std::vector<FixtureSolid>>(std::move(fixtures));
        c.part = std::move(part);
        c.held_key = held_key;
        c.upright.kept_off = c.upright.fixtures = nullptr;
    }
    progress.set(1.0);
    return c.part;
}

namespace {

/// Does something to the rework path of a plan that has one, whose tool is its own; where nothing is left of
/// it that is a warning.
template <class Change>
void for_rework(StrategyResult& path, PlanContext context, const Change& change) {
    auto* global_local = std::get_if<GlobalLocalPath>(&path.detail);
    if (!global_local || global_local->rework->path.passes.empty()) return;
    auto rework = std::make_shared<ReworkPlan>(*global_local->rework);
    context.tool = rework->tool;
    try {
        change(rework->path, context);
    } catch (const Error& e) {
        if (e.code() != ErrorCode::empty_result) throw;
        rework->path.passes.clear();
        path.warnings.push_back("rework: " + e.message());
    }
    global_local->rework = std::move(rework);
}

/// Plans with part and fixtures as what must not be touched; where passes just end beside fixtures, with the
/// part alone.
StrategyResult plan_beside_fixtures(const Operation& operation, PlanContext context, const AxisView& view,
                                    const KeptFixtures& kept, const Progress& progress) {
    if (!kept.grown) return operation.plan(context, progress);
    const bool ends_beside =
        operation.linking() == Linking::upright || operation.purpose() == Purpose::cleaning;
    if (ends_beside) context.contact = view.index;
    StrategyResult path = operation.plan(context, progress.part(0, 0.95));
    const bool of_part = std::any_of(path.warnings.begin(), path.warnings.end(), [](const std::string& w) {
        return w.find("the part") != std::string::npos;
    });
    if (!ends_beside && of_part)
        path.warnings.push_back("where the part is said to be in the way it may be " + kept.names
                                + ", kept off like the part");
    // Layers and turns are planned clear of them, and what follows depends on what each of them cuts.
    if (operation.linking() == Linking::over_stock || operation.turning()) return path;
    keep_off_fixtures(path, context, operation.common(), kept, progress.part(0.95, 1));
    for_rework(path, context, [&](StrategyResult& rework, const PlanContext& own) {
        keep_off_fixtures(rework, own, operation.common(), kept, progress.part(1, 1));
    });
    return path;
}

/// The same within the operation's boundary. Finishing is planned on what of the surface lies in it, so that
/// its passes reach the border on all sides; layers keep to it as they are planned.
StrategyResult plan_bounded(const Operation& operation, PlanContext context, const AxisView& view,
                            const OperationBounds& bounds, const Progress& progress) {
    context.contact = bounds.contact;
    if (!bounds.within) return plan_beside_fixtures(operation, context, view, bounds.off, progress);
    context.within = bounds.within;
    if (operation.purpose() == Purpose::finishing) {
        // Edges that cross the border, in radii of the cutter.
        constexpr double border_edge = 0.05;
        const KeptWithin& within = *bounds.within;
        context.part =
            within.region->surface(within.min_depth(), border_edge * within.radius, progress.part(0, 0.01));
        context.is_piece = true;
        context.geometry = compute_geometry(*context.part, progress.part(0.01, 0.02));
    }
    StrategyResult path =
        plan_beside_fixtures(operation, context, view, bounds.off, progress.part(0.02, 0.95));
    if (operation.linking() == Linking::over_stock) return path;
    keep_within(path, context, operation.common(), *bounds.within, progress.part(0.95, 1));
    for_rework(path, context, [&](StrategyResult& rework, const PlanContext& own) {
        KeptWithin within = *bounds.within;
        within.radius = CutterProfile(own.tool.cutter()).max_radius();
        keep_within(rework, own, operation.common(), within, progress.part(1, 1));
    });
    return path;
}

} // namespace

/// The path of an operation: one that is known, or a new one.
void Planner::Cache::plan_path(const Project& project, const Operation& operation, PlanContext& context,
                               AxisView& view, Planned& made, OperationResult& result,
                               const Progress& progress) {
    const OperationCommon& common = operation.common();
    const OperationBounds bound =
        view.bounds.of(project, operation, *view.part, {view.kept_off, view.fixtures}, progress.part(0, 0));
    context.contact = bound.contact;
    context.curves = bound.curves;
    result.within = bound.within;
    result.view = view.turn;
    if (bound.off.grown) context.fixtures_box = bound.off.grown->mesh().box();
    if (const Planned* same = find(&Planned::path_key, made.path_key)) {
        result.path = same->result->path;
        made.in_view = same->in_view;
        result.nothing_to_do = same->result->nothing_to_do;
        result.seconds_strategy = same->result->seconds_strategy;
        return;
    }
    const auto start = std::chrono::steady_clock::now();
    try {
        result.path = plan_bounded(operation, context, view, bound, progress.part(0, 1, common.name));
        // The table stands below a turned part as a fixture.
        if (!operation.turning() && view.is_upright()) keep_passes_up(result.path, context, operation);
        if (!view.is_upright()) {
            made.in_view = std::make_shared<const StrategyResult>(std::move(result.path));
            result.path = turned_path(*made.in_view, view.turn.transpose());
        }
    } catch (const NothingToDo& nothing) {
        result.nothing_to_do = nothing.message();
    }
    result.seconds_strategy = seconds_since(start);
    ++work.strategies;
}

void Planner::Cache::link_path(const Operation& operation, const PlanContext& context, const AxisView& view,
                               Planned& made, OperationResult& result, const Progress& progress) {
    ToolMotions& motions = result.program.motions;
    if (const Planned* same = find(&Planned::motion_key, made.motion_key)) {
        motions = same->result->program.motions;
        result.seconds_link = same->result->seconds_link;
        return;
    }
    const auto start = std::chrono::steady_clock::now();
    motions = link_operation(operation, made.in_view ? *made.in_view : result.path, context, progress);
    if (!view.is_upright()) motions = turned_motions(std::move(motions), view.turn.transpose());
    result.seconds_link = seconds_since(start);
    ++work.links;
}

/// `context`: in the view.
const Planner::Cache::Planned& Planner::Cache::operation(const Project& project, const Operation& operation,
                                                         PlanContext context, AxisView& view,
                                                         const Asked& earlier, const Progress& progress) {
    const OperationCommon& common = operation.common();
    // Each key holds what its stage and all before it read.
    Key key;
    key.add(std::string_view(part_key))
        .add(std::string_view(stock_key))
        .add(operation.kind())
        .add(std::string_view(held_key))
        .add(std::string_view(context.machine.source));
    key.add_up_to(Stage::strategy, project.stock, stock_parameters());
    key.add(project.part.tessellation_tolerance);
    key.add_up_to(Stage::strategy, context.tool, tool_parameters());
    key.add_up_to(Stage::strategy, operation);
    for (const Tool& t : context.further_tools)
        key.add_up_to(Stage::output, t, tool_parameters());
    key.add(unit_name(project.unit)); // in which the strategy's warnings speak
    key.add(earlier.by_strategy);
    key.add(std::string_view(bounds_key(project, operation)));
    key.add(std::string_view(view.key));
    Planned made;
    made.used = true;
    made.path_key = key.text();
    key.add(earlier.by_links);
    made.motion_key = key.add_up_to(Stage::link, operation).text();
    key.add_up_to(Stage::output, operation).add_up_to(Stage::output, context.tool, tool_parameters());
    key.add(std::string_view(project.part.file));
    made.program_key = key.text();

    if (Planned* same = find(&Planned::program_key, made.program_key)) {
        same->used = true;
        progress.set(1.0);
        return *same;
    }
    auto result = std::make_shared<OperationResult>();
    made.result = result;
    result->name = common.name;
    result->kind = operation.kind();
    plan_path(project, operation, context, view, made, *result, progress.part(0.0, 0.85));
    if (!result->nothing_to_do.empty()) {
        result->seconds_planning = result->seconds_strategy;
        progress.set(1.0);
        result->keys = made.keys();
        planned.push_back(std::move(made));
        return planned.back();
    }
    for (const Pass& pass : result->path.passes) {
        result->cc_points += pass.cc.size();
        result->cl_points += pass.cl.size();
    }
    if (result->cl_points == 0)
        throw Error(ErrorCode::empty_result, "operation '" + printable(common.name) + "'", "nothing is cut",
                    "check part, tool and direction");

    result->program.multi_axis = !operation.three_axis();
    link_path(operation, context, view, made, *result, progress.part(0.85, 0.98, common.name + ": linking"));
    // What follows is told in the setup, as the program is.
    context.part_box = part->box;
    context.to_setup = Mat3::Identity();
    finish_program(*result, project, operation, context, progress);
    const auto* global_local = result->path.as<GlobalLocalPath>();
    if (global_local && !global_local->rework->path.passes.empty())
        result->further.push_back(
            rework_program(*result, project, operation, context, progress.part(0.98, 1)));
    result->seconds_planning = result->seconds_strategy + result->seconds_link;
    ++work.programs;
    progress.set(1.0);
    result->keys = made.keys();
    planned.push_back(std::move(made));
    return planned.back();
}

std::shared_ptr<const EarlierLeft> Planner::Cache::left(const Project& project,
                                                        const std::shared_ptr<const PlanResult>& before,
                                                        const Operation& operation, std::string_view motions,
                                                        const Progress& progress) {
    auto found = std::make_shared<EarlierLeft>();
    const Operation::ReadsLeft reads = operation.reads_left();
    if (reads.points)
        for (const auto& program : before->operations)
            for (const CutterContact& c : program->path.cleanup)
                found->points.push_back({c.point, c.normal, 0});
    if (!reads.rest || before->operations.empty()) return found;
    const OperationCommon& common = operation.common();
    const double radius = 0.5 * project.tool_of(operation).diameter;
    Key key;
    key.add(std::string_view(part_key)).add(std::string_view(stock_key));
    key.add_up_to(Stage::strategy, project.stock, stock_parameters());
    key.add(motions).add(common.tolerance).add(common.allowance).add(radius);
    if (!rest || left_key != key.text()) {
        VerifySettings settings;
        if (project.part.flip) settings.open_side = OpenSide::other;
        settings.tolerance = common.tolerance;
        settings.allowance = common.allowance;
        settings.sample_spacing = rest_sample_share * radius;
        settings.motion_bound = rest_motion_share * common.tolerance;
        // The stock itself is not asked: what is left is found by lines through the samples.
        settings.resolution = rest_ray_share * radius;
        std::vector<VerifyProgram> programs = verify_programs(project, before);
        for (VerifyProgram& program : programs)
            program.fixtures = nullptr; // what is left of the stock knows nothing of them
        const Verification verified =
            verify(*before->part->mesh, before->stock, programs, settings, progress);
        auto all = std::make_shared<EarlierLeft>();
        all->rest_spacing = 2 * verified.used.sample_spacing;
        const DeviationSurface& surface = *verified.surface;
        for (std::size_t i = 0; i < surface.points.size(); ++i) {
            if (surface.flags[i] != DeviationSurface::counted) continue;
            const double height = double(surface.deviation[i]);
            if (!(height > (1 + tolerance::uncut_margin) * common.tolerance)) continue;
            const auto vec = [](const std::array<float, 3>& v) {
                return Vec3(double(v[0]), double(v[1]), double(v[2]));
            };
            all->rest.push_back({vec(surface.points[i]), vec(surface.normals[i]).normalized(), height});
        }
        rest = std::move(all);
        left_key = key.text();
    }
    found->rest = rest->rest;
    found->rest_spacing = rest->rest_spacing;
    return found;
}

std::shared_ptr<const PlanResult> Planner::plan(const Project& project, const std::string& only_operation,
                                                const Progress& progress) {
    check_project(project);
    std::vector<std::string> names;
    for (const auto& o : project.operations)
        names.push_back(o->common().name);
    const std::vector<AskedOperation> asked = asked_operations(
        project, [&](std::size_t i) { return only_operation.empty() || names[i] == only_operation; });
    if (asked.empty()) refuse_to_plan(project, only_operation);

    Cache& c = *cache_;
    auto result = std::make_shared<PlanResult>();
    result->part = prepare(project, progress.part(0.0, 0.15));
    result->stock = stock_solid(project.stock, *result->part);
    result->stock_warnings = stock_warnings(project.stock, *result->part, project.unit);
    for (std::string& warning : fixture_warnings(project, *result->part, progress))
        result->stock_warnings.push_back(std::move(warning));
    c.index_part(result->part, progress.part(0.15, 0.2, "Indexing the part"));

    const PlanContext setup_context = context_of(project, *result->part, result->stock);
    Key before, stock_text;
    stock_text.add(std::string_view(c.part_key)).add(std::string_view(c.stock_key));
    stock_text.add_up_to(Stage::strategy, project.stock, stock_parameters());
    StockSoFar stock(project, *result, stock_text.text(), c.rests);
    c.rests.begin_plan();
    for (const auto& view : c.indexed)
        view->used = false;
    auto done = std::make_shared<PlanResult>(*result); // with all operations until now
    for (auto& p : c.planned)
        p.used = false;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const double n = double(asked.size());
        const Operation& operation = *asked[i].operation;
        if (only_operation.empty()) progress.task(task_text(operation.common().name, i, asked.size()));
        PlanContext context = setup_context;
        context.tool = project.tool_of(operation);
        context.further_tools = project.further_tools_of(operation);
        Progress part = progress.part(0.2 + 0.8 * double(i) / n, 0.2 + 0.8 * double(i + 1) / n);
        try {
            Key asked_before, asked_by_links;
            if (operation.reads_stock()) asked_before.add("stock").add(std::string_view(stock.key()));
            if (operation.links_read_stock()) {
                asked_by_links.add(std::string_view(stock.key()));
                set_stock(context, stock.before(operation, part.part(0, 0.1)));
                part = part.part(0.1, 1);
            }
            if (operation.reads_left().any()) {
                asked_before.add("left").add(std::string_view(before.text()));
                context.left = c.left(project, done, operation, before.text(), part.part(0, 0.3));
                part = part.part(0.3, 1);
            }
            AxisView& view = c.view_of(project, operation, *result, part.part(0, 0.05));
            set_view(context, view);
            const Cache::Planned& planned =
                c.operation(project, operation, std::move(context), view,
                            {asked_before.text(), asked_by_links.text()}, part.part(0.05, 1));
            if (asked[i].result && !planned.result->nothing_to_do.empty())
                result->idle.push_back(planned.result);
            if (asked[i].result)
                for (const auto& program : programs_of(planned.result))
                    result->operations.push_back(program);
            if (asked[i].read) {
                before.add(std::string_view(planned.motions()));
                for (const auto& program : programs_of(planned.result))
                    done->operations.push_back(program);
            }
            if (asked[i].leaves) stock.add(operation, planned.result, planned.motions());
        } catch (const Error& e) {
            // A strategy knows what is wrong, not which of the project's operations it is.
            const std::string& name = operation.common().name;
            const std::string place = "operation '" + printable(name) + "'";
            if (e.where().starts_with("operation '")) throw;
            if (e.where() == name || e.where() == printable(name))
                throw Error(e.code(), place, e.message(), e.remedy());
            throw e.within(place);
        }
    }
    if (only_operation.empty()) {
        progress.task({});
        c.rests.end_plan();
        std::erase_if(c.indexed, [](const auto& view) { return !view->used; });
    }
    std::erase_if(c.planned, [&](const Cache::Planned& p) {
        if (p.used) return false;
        if (only_operation.empty()) return true;
        // Planning one operation keeps the others' results, and drops what this one had before.
        return p.result->name == only_operation
               || std::find(names.begin(), names.end(), p.result->name) == names.end();
    });
    progress.set(1.0);
    return result;
}

PlanContext preview_context(const Project& project, std::size_t i, const PreparedPart& part,
                            const std::vector<std::shared_ptr<const OperationResult>>& before) {
    PlanContext context = context_of(project, part, stock_solid(project.stock, part));
    context.tool = project.tool_of(*project.operations.at(i));
    if (project.operations[i]->reads_stock() && project.operations[i]->three_axis())
        for (const auto& result : before)
            if (!result->program.multi_axis && result->nothing_to_do.empty())
                context.earlier.push_back(cuts_of(*result));
    return context;
}

} // namespace facetmill
