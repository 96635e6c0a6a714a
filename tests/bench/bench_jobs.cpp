// Whole jobs, as a user plans and verifies them, and the contact kernel where it is slowest: processor time
// on one thread, the clock with one thread and with all of them, the largest memory, and how the time grows
// with facets. A table in Markdown; where OpenCAMLib was found when this was built, a finish of the same
// lines by its AdaptivePathDropCutter as well.
//
//     bench_jobs [RELIEF.stl|- [ROW/... [TURNS]]]
//
// RELIEF: a dirty height relief, scaled to 150 mm (-: one of 15 600 facets is made up); ROW: the names of
// the first column, or the beginnings of some, or "all"; TURNS: how often each is run, by turns with one
// thread and with all (default 3, medians are told). Every run is a process of its own.
#include "core/base/parallel.h"
#include "core/gouge/axial_lift.h"
#include "core/job/planner.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/five_axis/finish5.h"
#include "core/strategy/rough/rough.h"
#include "core/strategy/waterline/waterline.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/median.h"
#include "tests/bench/opencamlib.h"
#include "tests/support/part_meshes.h"
#include "tests/support/random_meshes.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>

using namespace facetmill;
namespace fs = std::filesystem;

namespace {

constexpr double relief_size = 150, field_size = 100, needles_size = 100, floor_size = 300;
/// As deep as any of the parts, so that no shank is asked for but where a row says so.
constexpr double deep_flutes = 80;

struct Measured {
    double processor = 0, clock = 0; ///< seconds
    double megabytes = 0;            ///< largest memory of the process
    double amount = 0;               ///< facets, points or lifts, as the row says
};

double clock_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Of what `work` does and nothing else.
Measured timed(const std::function<double()>& work) {
    Measured m;
    const double processor = bench::cpu_now(), clock = clock_now();
    m.amount = work();
    m.processor = bench::cpu_now() - processor;
    m.clock = clock_now() - clock;
    return m;
}

// --- Parts ------------------------------------------------------------------------------------------------

/// Hills of 10 mm with ripples.
double hills(double x, double y) {
    return 10 * std::sin(0.11 * x) * std::cos(0.07 * y) + 2 * std::sin(0.5 * x + 0.3 * y);
}

MeshPtr field_of(std::size_t facets) {
    return test::field(int(std::lround(std::sqrt(double(facets) / 2))), field_size, hills, 0.3);
}

/// Round heads on a plate as a scan gives them: steep sides, a part of the facets flipped, some missing.
Mesh made_up_relief() {
    test::Random rng(7);
    Mesh mesh = *test::field(
        89, relief_size,
        [](double x, double y) {
            double z = 0.5 * std::sin(0.9 * x) * std::sin(0.7 * y);
            for (const double cx : {35.0, 75.0, 115.0})
                for (const double cy : {40.0, 110.0}) {
                    const double d = std::hypot((x - cx) / 18, (y - cy) / 24);
                    z = std::max(z, 26 * std::sqrt(std::max(1 - d * d, 0.0)));
                }
            return z;
        },
        0.3, 7);
    std::vector<std::array<Index, 3>> kept;
    for (std::array<Index, 3> f : mesh.facets) {
        if (test::uniform(rng, 0, 1) < 0.01) continue;
        if (test::uniform(rng, 0, 1) < 0.03) std::swap(f[1], f[2]);
        kept.push_back(f);
    }
    mesh.facets = kept;
    return mesh;
}

/// Level in the middle, round towards the borders, as the bottom of a hull.
MeshPtr level_floor() {
    return test::field(
        241, floor_size,
        [](double x, double y) {
            const double out = std::max({std::abs(x - 0.5 * floor_size), std::abs(y - 0.5 * floor_size)});
            return -0.002 * std::pow(std::max(out - 0.4 * floor_size, 0.0), 2);
        },
        0.3);
}

// --- Jobs -------------------------------------------------------------------------------------------------

Tool numbered(long number, Tool tool, double flutes) {
    tool.number = number;
    tool.flute_length = flutes;
    tool.holder = {{2.5 * tool.diameter + 10, 40}};
    return tool;
}

template <class O, class Settings>
void add(Project& project, const char* name, long tool, double tolerance, Settings s) {
    s.name = name;
    s.tool = tool;
    s.tolerance = tolerance;
    project.operations.push_back(std::make_unique<O>(s));
}

/// A job on a mesh that is written for it, in millimetres, with a margin of 1 mm round the part.
class Job {
public:
    explicit Job(const Mesh& mesh) {
        file_ = fs::temp_directory_path() / ("bench_jobs_" + std::to_string(getpid()) + ".stl");
        save_stl(mesh, file_.string(), LengthUnit::mm, {});
        project.part.file = file_.string();
        project.machine = "generic-3-axis";
        project.stock.margin = {1, 1, 1};
    }
    ~Job() {
        std::error_code ignored;
        fs::remove(file_, ignored);
    }
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    /// Facets of the part; with `before` operations that are planned before the clock starts.
    Measured planned(std::size_t before = 0) {
        std::vector<std::unique_ptr<Operation>> later;
        while (before > 0 && project.operations.size() > before) {
            later.insert(later.begin(), std::move(project.operations.back()));
            project.operations.pop_back();
        }
        if (before > 0) planner_.plan(project, "", Progress());
        for (auto& operation : later)
            project.operations.push_back(std::move(operation));
        return timed([&] {
            plan_ = planner_.plan(project, "", Progress());
            return double(plan_->part->mesh->facet_count());
        });
    }
    /// Motions, at a resolution of the stock and of the places compared.
    Measured verified(double resolution) {
        planned();
        VerifySettings s = verify_settings(project, plan_.get());
        s.resolution = s.sample_spacing = resolution;
        const auto programs = verify_programs(project, plan_);
        return timed([&] {
            verify(*plan_->part->mesh, plan_->stock, programs, s, Progress());
            double motions = 0;
            for (const auto& o : plan_->operations)
                motions += double(o->program.motions.motions.size());
            return motions;
        });
    }

    Project project;

private:
    fs::path file_;
    Planner planner_;
    std::shared_ptr<const PlanResult> plan_;
};

Measured finish(const Mesh& mesh, double stepover, double flutes = deep_flutes) {
    Job job(mesh);
    job.project.tools = {numbered(1, test::ball_tool(6), flutes)};
    Finish3Settings s;
    s.direction = {0, "x"};
    if (stepover > 0) s.stepover = {stepover, ""};
    add<Finish3>(job.project, "Finish", 1, 0.05, s);
    return job.planned();
}

Measured clean_up(const Mesh& mesh, double ball) {
    Job job(mesh);
    job.project.tools = {numbered(1, test::ball_tool(3 * ball), deep_flutes),
                         numbered(2, test::ball_tool(ball), deep_flutes)};
    Finish3Settings s;
    s.direction = {0, "x"};
    add<Finish3>(job.project, "Finish", 1, 0.05, s);
    add<Cleanup>(job.project, "Clean-up", 2, 0.05, CleanupSettings());
    return job.planned(1);
}

Measured rough(const Mesh& mesh) {
    Job job(mesh);
    job.project.tools = {numbered(1, test::flat_tool(8), deep_flutes)};
    RoughSettings s;
    s.allowance = 0.3;
    add<Rough>(job.project, "Rough", 1, 0.6, s);
    return job.planned();
}

/// So many levels, evenly apart.
Measured waterline(const Mesh& mesh, int levels) {
    Job job(mesh);
    job.project.tools = {numbered(1, test::ball_tool(6), deep_flutes)};
    WaterlineSettings s;
    s.stepdown = {mesh.box().size().z() / levels, ""};
    add<Waterline>(job.project, "Levels", 1, 0.05, s);
    return job.planned();
}

Measured five_axis(double tolerance_inch) {
    Job job(*make_sample("complex", 0.0005 * mm_per_inch, Progress()));
    job.project.machine = "trunnion-ac";
    job.project.tools = {numbered(1, test::flat_tool(0.5 * mm_per_inch), 2.5 * mm_per_inch)};
    add<Finish5>(job.project, "Finish", 1, tolerance_inch * mm_per_inch, Finish5Settings());
    return job.planned();
}

Measured simulated(const Mesh& mesh, double resolution) {
    Job job(mesh);
    job.project.tools = {numbered(1, test::ball_tool(6), deep_flutes)};
    Finish3Settings s;
    s.direction = {0, "x"};
    add<Finish3>(job.project, "Finish", 1, 0.05, s);
    return job.verified(resolution);
}

// --- The kernel where it is slowest -----------------------------------------------------------------------

/// Lifts one after the other at places without an order, or as one grid.
Measured lifts(MeshPtr mesh, const Tool& tool, std::size_t count, bool isolated) {
    const Box3 box = mesh->box();
    const AxialLift lift(std::make_shared<ContactIndex>(mesh, Progress()), CutterProfile(tool.cutter()));
    test::Random rng(3);
    std::vector<Vec2> places;
    const auto side = std::size_t(std::lround(std::sqrt(double(count))));
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) {
            const double a = isolated ? test::uniform(rng, 0, 1) : double(i) / double(side - 1),
                         b = isolated ? test::uniform(rng, 0, 1) : double(j) / double(side - 1);
            const Vec3 p = box.lo + Vec3(a, b, 0).cwiseProduct(box.hi - box.lo);
            places.emplace_back(p.x(), p.y());
        }
    std::vector<double> heights(places.size());
    return timed([&] {
        if (isolated)
            for (std::size_t i = 0; i < places.size(); ++i)
                heights[i] = lift.tip_z(places[i].x(), places[i].y());
        else
            lift.tip_z(places, heights, Progress());
        return double(places.size());
    });
}

/// The lines of the parallel finish, by OpenCAMLib.
Measured finish_by_opencamlib(const Mesh& mesh) {
    return timed([&] { return parallel_finish_by_opencamlib(mesh, 6, 1); });
}

// --- Rows -------------------------------------------------------------------------------------------------

struct Row {
    std::string name;
    std::function<Measured()> run;
    enum class Amount { facets, motions, lifts, points } amount = Amount::facets;
    std::string grows_from; ///< the row whose growth it shows; empty: none
    bool once = false;      ///< on one thread only
};

std::vector<Row> rows_for(const std::function<Mesh()>& relief) {
    using A = Row::Amount;
    const auto field = [](std::size_t n) { return [n] { return field_of(n); }; };
    std::vector<Row> rows = {
        {"parallel finish, step 1", [=] { return finish(relief(), 1); }},
        {"parallel finish, shank in the stock", [=] { return finish(relief(), 1, 12); }},
        {"finish3, relief", [=] { return finish(relief(), 0); }},
        {"finish3, field 100 k", [=] { return finish(*field(100'000)(), 0); }},
        {"finish3, field 1 M", [=] { return finish(*field(1'000'000)(), 0); }, A::facets,
         "finish3, field 100 k"},
        {"finish3 step 1, field 10 M", [=] { return finish(*field(10'000'000)(), 1); }},
        {"cleanup, relief", [=] { return clean_up(relief(), 2); }},
        {"cleanup, field 100 k", [=] { return clean_up(*field(100'000)(), 2); }},
        {"cleanup, field 1 M", [=] { return clean_up(*field(1'000'000)(), 2); }, A::facets,
         "cleanup, field 100 k"},
        {"rough, relief", [=] { return rough(relief()); }},
        {"rough, field 20 k", [=] { return rough(*field(20'000)()); }},
        {"rough, field 1 M", [=] { return rough(*field(1'000'000)()); }, A::facets, "rough, field 20 k"},
        {"waterline, 50 levels, field 100 k", [=] { return waterline(*field(100'000)(), 50); }},
        {"waterline, 50 levels, field 1 M", [=] { return waterline(*field(1'000'000)(), 50); }, A::facets,
         "waterline, 50 levels, field 100 k"},
        {"finish5, complex .004 in", [] { return five_axis(0.004); }},
        {"finish5, complex .001 in", [] { return five_axis(0.001); }},
        {"simulate, relief .15 mm", [=] { return simulated(relief(), 0.15); }, A::motions},
        {"simulate, relief .075 mm", [=] { return simulated(relief(), 0.075); }, A::motions},
    };
    const Tool ball = test::ball_tool(6), flat = test::flat_tool(60);
    const auto kernel = [&](const char* name, std::function<MeshPtr()> mesh, Tool tool, std::size_t count,
                            bool isolated) {
        rows.push_back({name, [=] { return lifts(mesh(), tool, count, isolated); }, A::lifts, "", true});
    };
    kernel(
        "diagonal needles 20 k", [] { return test::needles_askew(10'000, needles_size); }, ball, 40'000,
        false);
    kernel(
        "diagonal needles 200 k", [] { return test::needles_askew(100'000, needles_size); }, ball, 10'000,
        false);
    kernel("flat D60, level floor", level_floor, flat, 40'000, false);
    kernel("ball D6, level floor", level_floor, ball, 250'000, false);
    kernel("grid, field 20 k", field(20'000), ball, 250'000, false);
    kernel("isolated, field 20 k", field(20'000), ball, 100'000, true);
    kernel("grid, field 1 M", field(1'000'000), ball, 250'000, false);
    kernel("isolated, field 1 M", field(1'000'000), ball, 100'000, true);
    const auto shared = [relief] { return std::make_shared<Mesh>(relief()); };
    kernel("grid, relief", shared, ball, 250'000, false);
    kernel("isolated, relief", shared, ball, 100'000, true);
    if (opencamlib_is_here())
        rows.push_back({"OpenCAMLib, parallel finish, step 1", [=] { return finish_by_opencamlib(relief()); },
                        A::points, "", true});
    return rows;
}

/// In a process of its own, so that its memory is its own.
Measured run_alone(const Row& row, int threads) {
    int ends[2];
    if (pipe(ends) != 0) throw Error(ErrorCode::internal, "pipe", "cannot be made", "");
    const pid_t child = fork();
    if (child == 0) {
        set_thread_count(threads);
        Measured m;
        try {
            m = row.run();
        } catch (const Error& e) {
            std::fprintf(stderr, "%s: %s\n", row.name.c_str(), e.what());
            _exit(1);
        }
        rusage used{};
        getrusage(RUSAGE_SELF, &used);
        m.megabytes = double(used.ru_maxrss) / 1024;
        _exit(write(ends[1], &m, sizeof m) == ssize_t(sizeof m) ? 0 : 1);
    }
    close(ends[1]);
    Measured m;
    const bool got = read(ends[0], &m, sizeof m) == ssize_t(sizeof m);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!got || status != 0) m.amount = 0;
    return m;
}

struct Medians {
    double one = 0, clock_one = 0, clock_all = 0, megabytes = 0, amount = 0;
};

Medians medians_of(const Row& row, int turns) {
    std::vector<double> one, clock_one, clock_all, memory;
    Medians all;
    for (int turn = 0; turn < turns; ++turn)
        for (const int threads : {1, 0}) {
            if (row.once && threads == 0) continue;
            const Measured m = run_alone(row, threads);
            if (m.amount == 0) return all;
            if (threads == 1) one.push_back(m.processor);
            (threads == 1 ? clock_one : clock_all).push_back(m.clock);
            memory.push_back(m.megabytes);
            all.amount = m.amount;
        }
    all.one = bench::median(one);
    all.clock_one = bench::median(clock_one);
    all.clock_all = clock_all.empty() ? 0 : bench::median(clock_all);
    all.megabytes = bench::median(memory);
    return all;
}

void print_row(const Row& row, const Medians& m, const std::vector<std::pair<std::string, Medians>>& known) {
    static const char* const names[] = {"facets", "motions", "lifts", "points"};
    if (m.amount == 0) {
        std::printf("| %s | failed | | | | | |\n", row.name.c_str());
        return;
    }
    std::string rate = "", parallel = "", growth = "";
    char text[64];
    if (row.once) {
        std::snprintf(text, sizeof text, "%.0f/s", m.amount / m.one);
        rate = text;
    } else if (thread_count() > 1) { // Amdahl's law
        const double n = thread_count();
        std::snprintf(text, sizeof text, "%.0f %%", 100 * (1 - m.clock_all / m.clock_one) / (1 - 1 / n));
        parallel = text;
    }
    for (const auto& [name, smaller] : known)
        if (name == row.grows_from && smaller.amount > 0) {
            std::snprintf(text, sizeof text, "%.2f",
                          std::log(m.one / smaller.one) / std::log(m.amount / smaller.amount));
            growth = text;
        }
    std::printf("| %s | %.0f %s | %.2f | %s | %s | %.0f | %s |\n", row.name.c_str(), m.amount,
                names[int(row.amount)], m.one, rate.c_str(), parallel.c_str(), m.megabytes, growth.c_str());
    std::fflush(stdout);
}

bool asked(const std::string& name, const std::string& which) {
    if (which == "all") return true;
    for (std::size_t from = 0; from <= which.size();) {
        const std::size_t to = std::min(which.find('/', from), which.size());
        if (to > from && name.starts_with(which.substr(from, to - from))) return true;
        from = to + 1;
    }
    return false;
}

} // namespace

int main(int argc, char** argv) {
    const std::string file = argc > 1 ? argv[1] : "-", which = argc > 2 ? argv[2] : "all";
    const int turns = argc > 3 ? std::max(std::atoi(argv[3]), 1) : 3;
    const auto relief = [file] {
        if (file == "-") return made_up_relief();
        Mesh mesh = *load_mesh(file, LengthUnit::mm, Progress()).mesh;
        const double scale = relief_size / mesh.box().size().maxCoeff();
        for (Vec3& v : mesh.vertices)
            v *= scale;
        return mesh;
    };
    std::printf("| job | size | s, one thread | rate | parallel part | MB | growth with facets |\n"
                "|---|---|---|---|---|---|---|\n");
    std::vector<std::pair<std::string, Medians>> known;
    for (const Row& row : rows_for(relief)) {
        if (!asked(row.name, which)) continue;
        known.emplace_back(row.name, medians_of(row, turns));
        print_row(row, known.back().second, known);
    }
}
