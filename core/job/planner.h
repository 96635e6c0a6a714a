// The pipeline: part -> geometry -> contact index -> strategy -> link -> CL program -> report. A Planner
// keeps what did not change between calls, so that editing a feed does not slice the part again.
#pragma once

#include "core/base/progress.h"
#include "core/job/project.h"
#include "core/mesh/mesh_io.h"
#include "core/output/cl_program.h"
#include "core/output/motion_time.h"
#include "core/repair/repair.h"
#include "core/setup/motion.h"
#include "core/verify/program.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

struct KeptWithin; // boundary_region.h
class KnownMeshes; // repaired_mesh.h

/// The part in place: read, transformed, measured. Published whole.
struct PreparedPart {
    MeshPtr mesh; ///< wound outward (core/mesh/outward.h)
    MeshReport report;
    /// Number of the face of the file that each facet lies on; null for files without faces and where a
    /// recipe has changed the mesh.
    std::shared_ptr<const std::vector<Index>> faces;
    /// How far the surfaces of the file lie outside and inside the mesh, at most; mm.
    std::array<double, 2> surface_deviation{0, 0};
    std::size_t turned_facets = 0;                ///< that were wound inward in the file
    std::vector<StepReport> repairs;              ///< what the project's recipe did to the file's mesh
    std::shared_ptr<const MeshGeometry> geometry; ///< null where all operations keep their axis
    Box3 box;
    std::array<double, 3> reach{}; ///< see stock_cylinder
    MeshPtr stock_mesh;            ///< in place; null where the stock is neither one nor a rest
    Box3 stock_box;                ///< of stock_mesh
    double stock_edge_loss = 0;    ///< see StockSolid
    std::shared_ptr<const std::vector<FixtureSolid>> fixtures; ///< null: none
    MeshPtr kept_off; ///< the part, and the fixtures grown by their clearance: what no tool may touch
};

/// How a program of several axes runs on its machine (motion_time.h).
struct MachineRun {
    std::vector<std::string> joints;    ///< names: "X", "Y", "Z", "C", "A"
    std::vector<std::size_t> reversals; ///< how often each joint turns back
    double largest_angular_rate = 0;    ///< rad/s
    std::size_t motions = 0, findings = 0;
    std::vector<std::string> warnings; ///< what the machine cannot do, in the project's unit
};

/// What a Planner made a result from, as text: where it is asked for the same again, it has it.
struct PlanKeys {
    std::string path, motions, program;
    /// The path of an indexed operation as it was planned, else null.
    std::shared_ptr<const StrategyResult> in_view;
};

struct OperationResult {
    std::string name, kind;
    StrategyResult path;
    ClSection program; ///< what it puts into a program file
    MotionTotals totals;
    std::optional<MachineRun> machine_run; ///< of a program of several axes
    /// How the machine stands at the end of each motion, in a program of several axes.
    std::shared_ptr<const std::vector<Joints>> joints;
    std::vector<std::string> motion_warnings; ///< about the motions as they are linked
    /// Where the machine's axes do not go: the farthest place, the axis and by how much, in the project's
    /// unit; empty where they reach everything.
    std::string out_of_reach;
    /// Why it has no motions: what it is for has been done before it (NothingToDo). Empty for all others.
    std::string nothing_to_do;
    std::shared_ptr<const KeptWithin> within; ///< its boundary, in the view; null: everywhere
    Mat3 view = Mat3::Identity(); ///< from the setup to how the operation saw it (axis_view.h); path and
                                  ///< program are the setup's
    double seconds_strategy = 0, seconds_link = 0; ///< when they ran; what was reused keeps its time
    double seconds_planning = 0;                   ///< their sum
    std::size_t cc_points = 0, cl_points = 0;
    /// Programs of further tools that belong to it and run after it, as those of a rework path; named after
    /// it.
    std::vector<std::shared_ptr<const OperationResult>> further;
    std::shared_ptr<const PlanKeys> keys; ///< null: not a Planner's own

    /// The path's and the machine's.
    std::vector<std::string> warnings() const;
};

/// An operation's own program and its further ones, in machining order; none where it has nothing to do.
std::vector<std::shared_ptr<const OperationResult>>
programs_of(const std::shared_ptr<const OperationResult>& operation);

/// What the setups before left of their stock, in a setup's coordinates.
struct CarriedStock {
    MeshPtr mesh;         ///< closed
    double edge_loss = 0; ///< see StockSolid
    std::string key;      ///< the same for the same mesh, and for no other
    std::string source;   ///< what it was made from: stock_source of the setup that it is for
};

/// All that the stock which the chosen setup begins with comes from, as text, where that is a rest; else
/// empty: the part, the setups before, how this one holds the part, and the files of all that as they are on
/// disk. `file_text` says what a file is (project.h).
std::string stock_source(const Project& project, const FileText& file_text = file_stamp);

/// How often a Planner ran each stage; what was reused is not counted.
struct PlannerWork {
    int loads = 0, placements = 0, indexes = 0, strategies = 0, links = 0, programs = 0;
    bool operator==(const PlannerWork&) const = default;
};

struct PlanResult {
    std::shared_ptr<const PreparedPart> part;
    StockSolid stock;
    std::vector<std::string> stock_warnings; ///< of stock and fixtures
    /// One per program, in the project's order; those asked for. What an operation has `further` stands after
    /// it, too.
    std::vector<std::shared_ptr<const OperationResult>> operations;
    /// Operations of those asked for that have nothing to do, in the project's order: they have no program.
    std::vector<std::shared_ptr<const OperationResult>> idle;
    /// The place in `operations` of the program whose operation a program belongs to.
    std::size_t owner(std::size_t program) const;
    /// Throws Error(limit_exceeded) that names the first operation that the machine cannot make, and where:
    /// its path can be looked at, and is no program.
    void check_reach() const;
    /// Throws Error(empty_result) where no operation has a program: why the first has nothing to do.
    void check_programs() const;
};

/// One job at a time: not to be called from two threads at once. Every stage is keyed by the values up to it
/// (ParameterInfo::stage), so that a result from the cache equals a fresh one. After a plan of all operations
/// only what it used is kept.
class Planner {
public:
    /// `meshes`: what others have read, and get of it; null: its own.
    explicit Planner(std::shared_ptr<KnownMeshes> meshes = nullptr);
    ~Planner();

    /// The part of a project and the mesh of its stock, from the cache when file, time stamp, size, unit and
    /// placement are the same. Throws Error(files, coordinate_range; of a stock that is not closed or holds
    /// nothing out_of_range).
    std::shared_ptr<const PreparedPart> prepare(const Project& project, const Progress& progress);
    /// The stock of projects whose stock is the rest of the setups before, from now on. Where it is none, or
    /// was made from anything else than the project says now, `prepare` throws Error(missing_reference).
    void carry(std::shared_ptr<const CarriedStock> stock);
    const std::shared_ptr<const CarriedStock>& carried() const;
    /// Takes over what another Planner made (OperationResult::keys): this one has it when it is asked for it.
    void adopt(const std::shared_ptr<const OperationResult>& result);
    /// What `prepare` made last; null before.
    std::shared_ptr<const PreparedPart> prepared() const;
    /// Plans all operations, or only the one named (empty: all). Throws Error (of check_project, of the
    /// part's file, missing_reference for an unknown name, empty_result when nothing is cut) or Cancelled;
    /// the cache stays good then.
    std::shared_ptr<const PlanResult> plan(const Project& project, const std::string& only_operation,
                                           const Progress& progress);

    /// What it has read, and others.
    const std::shared_ptr<KnownMeshes>& meshes() const;
    const PlannerWork& work() const;

private:
    struct Cache;
    std::unique_ptr<Cache> cache_;
};

/// What operation `i` of the project would be planned with, but for contact index and geometry; `before` are
/// results of operations before it, those that are known. Throws Error(missing_reference).
PlanContext preview_context(const Project& project, std::size_t i, const PreparedPart& part,
                            const std::vector<std::shared_ptr<const OperationResult>>& before);

} // namespace facetmill
