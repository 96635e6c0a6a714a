// Parts from elsewhere: each is planned, judged by the verifier, and looked at by the naive check, which
// shares nothing with it. Prints one markdown table.
//
//     bench_real FOLDER [--list FILE] [--plans FOLDER] [--coarse K] [--places FOLDER] [--verifier] [NAME ...]
//
// FOLDER has NAME.facetmill for every part; FILE a line "NAME ORIGIN ..." each, which also says which parts
// and in which order. With --plans the programs are those of PLANS/NAME/*.apt where there are any. K: places
// looked at are K times farther apart than by default (tried quickly: 4). --places: the places that each
// judge looked at, with what it found there, as NAME.verifier.txt and NAME.naive.txt: where judges differ.
// --verifier: without the naive check, which takes most of the time on parts of many facets.
#include "core/base/parallel.h"
#include "core/job/planner.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/output/apt.h"
#include "core/setup/kinematics.h"
#include "core/strategy/surface/stock_field.h"
#include "tests/support/naive_check.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <sstream>

using namespace facetmill;
namespace fs = std::filesystem;

namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Asked {
    fs::path folder, plans, places;
    std::vector<std::pair<std::string, std::string>> parts; ///< name, origin
    double coarse = 1;
    bool verifier_alone = false;
};

Asked asked(int argc, char** argv) {
    Asked a;
    std::vector<std::string> names;
    std::vector<std::pair<std::string, std::string>> list;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool more = i + 1 < argc;
        if (word == "--list" && more) {
            std::ifstream file(argv[++i]);
            for (std::string line, name, origin; std::getline(file, line);)
                if (std::istringstream(line) >> name >> origin) list.emplace_back(name, origin);
        } else if (word == "--plans" && more) {
            a.plans = argv[++i];
        } else if (word == "--coarse" && more) {
            a.coarse = std::atof(argv[++i]);
        } else if (word == "--places" && more) {
            a.places = argv[++i];
        } else if (word == "--verifier") {
            a.verifier_alone = true;
        } else if (a.folder.empty()) {
            a.folder = word;
        } else {
            names.push_back(word);
        }
    }
    if (list.empty() && !a.folder.empty()) {
        for (const auto& entry : fs::directory_iterator(a.folder))
            if (entry.path().extension() == ".facetmill") list.emplace_back(entry.path().stem().string(), "");
        std::sort(list.begin(), list.end());
    }
    for (const auto& part : list)
        if (names.empty() || std::find(names.begin(), names.end(), part.first) != names.end())
            a.parts.push_back(part);
    return a;
}

/// What is judged: programs with the sections that they come from.
struct Job {
    std::shared_ptr<const PreparedPart> part;
    StockSolid stock;
    std::vector<VerifyProgram> programs;
    std::vector<std::shared_ptr<const ClSection>> sections;
    VerifySettings settings;
    std::string operations;
    double seconds_planning = 0;
};

Job job_of(const Project& project, const fs::path& plans) {
    Job job;
    Planner planner;
    std::vector<fs::path> files;
    if (!plans.empty() && fs::is_directory(plans))
        for (const auto& entry : fs::directory_iterator(plans))
            if (entry.path().extension() == ".apt") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    if (files.empty()) {
        const double start = now();
        const auto plan = planner.plan(project, "", Progress());
        job.seconds_planning = now() - start;
        job.part = plan->part;
        job.programs = verify_programs(project, plan);
        for (const auto& o : plan->operations)
            job.sections.emplace_back(o, &o->program);
        job.settings = verify_settings(project, plan.get());
    } else {
        job.part = planner.prepare(project, Progress());
        for (const fs::path& file : files) {
            ClFilePrograms cl = read_verify_programs(project, file, Progress());
            std::move(cl.programs.begin(), cl.programs.end(), std::back_inserter(job.programs));
            job.sections.insert(job.sections.end(), cl.sections.begin(), cl.sections.end());
        }
        job.settings = verify_settings(project, nullptr);
    }
    job.stock = stock_solid(project.stock, *job.part);
    for (const auto& o : project.operations)
        job.operations += (job.operations.empty() ? "" : ", ") + std::string(o->kind());
    return job;
}

/// Lengths by the kind of motion, mm.
using ByKind = std::array<double, 5>;

/// Of every program what it feeds, and on what of it nothing is taken away: not more than a fifth of the
/// tolerance is cut anywhere, as far as cells of the stock's height tell. Of tools that stand upright alone.
std::vector<std::array<ByKind, 2>> idle_feed(const Job& job) {
    double radius = infinity;
    for (const VerifyProgram& p : job.programs)
        radius = std::min(radius, p.tool.cutter.max_radius());
    StockField field(job.stock, 0.03 * radius, Progress());
    const double least = 0.2 * job.settings.tolerance;
    std::vector<std::array<ByKind, 2>> all;
    for (const VerifyProgram& p : job.programs) {
        const StockCutter cutter(p.tool.cutter);
        std::array<ByKind, 2>& sums = all.emplace_back();
        const auto& motions = p.motions->motions;
        if (std::ranges::any_of(motions, [](const Motion& m) { return m.to.axis != Vec3::UnitZ(); }))
            continue;
        for (std::size_t i = 1; i < motions.size(); ++i) {
            if (motions[i].kind == MotionKind::rapid) continue;
            const Vec3 from = motions[i - 1].to.tip, way = motions[i].to.tip - from;
            const auto kind = std::size_t(motions[i].kind);
            const double pieces = std::floor(way.norm() / (0.25 * cutter.radius())) + 1;
            for (double k = 0; k < pieces; ++k) {
                const Vec3 a = from + k / pieces * way, b = from + (k + 1) / pieces * way;
                sums[0][kind] += way.norm() / pieces;
                if (!field.has_work(cutter, a, b, least)) sums[1][kind] += way.norm() / pieces;
                field.cut(cutter, a, b);
            }
        }
    }
    return all;
}

/// Seconds that programs take: in rapids, the slowest linear axis at its largest speed, and at feed.
std::vector<std::array<double, 2>> seconds_of(const Job& job, const Machine& machine) {
    std::vector<std::array<double, 2>> all;
    for (const auto& section : job.sections) {
        auto& [rapid, feed] = all.emplace_back();
        for (std::size_t i = 1; i < section->motions.motions.size(); ++i) {
            const Motion& m = section->motions.motions[i];
            const Vec3 way = m.to.tip - section->motions.motions[i - 1].to.tip;
            if (m.kind == MotionKind::rapid)
                rapid += (way.array().abs() / machine.rapid_mm_per_s.array()).maxCoeff();
            else
                feed += way.norm() / (section->feed(i) / 60);
        }
    }
    return all;
}

double rapid_share(const std::vector<std::array<double, 2>>& seconds) {
    double rapid = 0, whole = 0;
    for (const auto& [fast, feed] : seconds) {
        rapid += fast;
        whole += fast + feed;
    }
    return whole > 0 ? rapid / whole : 0;
}

/// Motions that end where the machine cannot be.
std::size_t outside_travel(const Project& project, const Job& job, const Machine& machine) {
    std::size_t outside = 0;
    const Vec3 origin = default_part_origin(machine, job.part->box);
    for (const auto& section : job.sections) {
        const auto tool = std::find_if(project.tools.begin(), project.tools.end(),
                                       [&](const Tool& t) { return t.number == section->tool_number; });
        if (tool == project.tools.end()) continue;
        const Kinematics kinematics(machine, gauge_length(*tool), origin);
        for (const Motion& m : section->motions.motions)
            outside += !kinematics.reaches({m.to.tip, m.to.axis});
    }
    return outside;
}

test::NaiveResult naive(const Job& job, const VerifySettings& used, double coarse) {
    std::vector<test::NaiveProgram> programs;
    double radius = infinity;
    for (std::size_t i = 0; i < job.programs.size(); ++i) {
        const AptCutter& cutter = job.programs[i].tool.cutter.cutter();
        programs.push_back({cutter, job.programs[i].motions->motions, {}, job.programs[i].turning});
        for (const ToolSection& section : job.programs[i].tool.sections)
            programs.back().barrels.push_back({section.radius, section.from, section.to});
        radius = std::min(radius, 0.5 * cutter.d);
    }
    test::NaiveOptions options;
    // A few hundred thousand samples; closer than the bands are wide that the smallest ball leaves at the
    // feet of walls, or facets that have one sample each are uncut as a whole.
    options.spacing =
        std::min(coarse * std::max(0.1 * radius, job.part->box.size().norm() / 500), 0.6 * radius);
    options.pose_share = std::min(0.1, 0.025 * coarse);
    options.tolerance = used.tolerance;
    options.stock = job.stock.box;
    if (job.stock.kind == StockSolid::Kind::cylinder) {
        options.round_axis = job.stock.axis;
        options.stock_radius = job.stock.radius;
    }
    return test::naive_check(*job.part->mesh, programs, options);
}

/// What each judge found, a place a line, mm: of the verifier "x y z deviation area flags" (flags as in
/// DeviationSurface), of the naive check "x y z uncut area" where a tool is to cut.
void write_places(const fs::path& folder, const std::string& name, const DeviationSurface& surface,
                  const test::NaiveResult& n) {
    std::vector<Vec3> points;
    for (const auto& p : surface.points)
        points.emplace_back(p[0], p[1], p[2]);
    std::vector<double> areas(points.size(), 0);
    for (const auto& t : surface.triangles) {
        const double area = 0.5 * (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
        for (const std::uint32_t corner : t)
            areas[corner] += area / 3;
    }
    std::ofstream ours(folder / (name + ".verifier.txt")), naive(folder / (name + ".naive.txt"));
    for (std::size_t i = 0; i < points.size(); ++i)
        ours << points[i].transpose() << ' ' << surface.deviation[i] << ' ' << areas[i] << ' '
             << int(surface.flags[i]) << '\n';
    for (const test::NaiveSample& s : n.samples)
        if (s.to_cut) naive << s.point.transpose() << ' ' << s.uncut << ' ' << s.weight << '\n';
    ours.flush();
    naive.flush();
    if (!ours || !naive)
        throw Error(ErrorCode::unwritable, folder.string(), "the places cannot be written",
                    "make the folder");
}

void row(const Asked& a, const std::string& name, const std::string& origin) {
    const fs::path file = a.folder / (name + ".facetmill");
    const Project project = load_project(file.string());
    const Machine machine = project_machine(project);
    Job job = job_of(project, a.plans.empty() ? fs::path() : a.plans / name);
    double start = now();
    if (a.coarse > 1) {
        constexpr double usual = 0.05; // resolution in radii
        double radius = infinity;
        for (const VerifyProgram& p : job.programs)
            radius = std::min(radius, p.tool.cutter.max_radius());
        job.settings.resolution = a.coarse * usual * radius;
    }
    const Verification v = verify(*job.part->mesh, job.stock, job.programs, job.settings, Progress());
    const double seconds_judging = now() - start;
    start = now();
    const test::NaiveResult n = a.verifier_alone ? test::NaiveResult() : naive(job, v.used, a.coarse);
    const double seconds_naive = now() - start, per = mm_per(project.unit);
    if (!a.places.empty()) write_places(a.places, name, *v.surface, n);
    std::string collisions;
    if (!v.collisions.empty()) collisions = ", " + std::to_string(v.collisions.size()) + " collisions";
    const auto by_naive = [&](double value, int digits) {
        char text[32] = "-";
        if (!a.verifier_alone) std::snprintf(text, sizeof text, "%.*f", digits, value);
        return std::string(text);
    };
    std::printf("| %s | %s | %s | %zu | %.0f + %.0f + %s | %.5f / %s, limit %.5f | %.2f / %s | %s%s | "
                "%s | %.1f | %zu |\n",
                name.c_str(), origin.c_str(), job.operations.c_str(), job.part->mesh->facet_count(),
                job.seconds_planning, seconds_judging, by_naive(seconds_naive, 0).c_str(),
                std::max(v.figures.gouge_max, v.border.gouge_max) / per,
                by_naive(n.gouge_max / per, 5).c_str(), v.used.gouge_limit / per, 100 * v.uncut_share,
                by_naive(100 * n.uncut_share(), 2).c_str(), verdict_name(v.verdict()).c_str(),
                collisions.c_str(),
                by_naive(n.feed_length > 0 ? 100 * n.air_length / n.feed_length : 0.0, 1).c_str(),
                100 * rapid_share(seconds_of(job, machine)), outside_travel(project, job, machine));
    for (const UncutReason& r : v.uncut)
        std::fprintf(stderr, "%s: uncut, %s: %.4g mm2, up to %.4g mm at (%.4g, %.4g, %.4g)\n", name.c_str(),
                     uncut_reason_text(r).c_str(), r.area, r.excess_max, r.place.x(), r.place.y(),
                     r.place.z());
    constexpr std::size_t most_told = 20;
    for (const Collision& c : std::span(v.collisions).first(std::min(v.collisions.size(), most_told)))
        std::fprintf(
            stderr,
            "%s: collision of the %s in the %s, program %zu GOTO %zu: %.4g mm at (%.4g, %.4g, %.4g)\n",
            name.c_str(),
            c.kind == Collision::Kind::rapid   ? "rapid"
            : c.kind == Collision::Kind::shank ? "shank"
                                               : "holder",
            c.with_part ? "part" : "stock", c.at.program + 1, c.at.motion + 1, c.depth, c.place.x(),
            c.place.y(), c.place.z());
    if (n.touch_max > 0)
        std::fprintf(
            stderr,
            "%s: naive: shank or holder in stock, program %zu GOTO %zu: %.4g mm at (%.4g, %.4g, %.4g)\n",
            name.c_str(), n.touch_program + 1, n.touch_motion + 1, n.touch_max, n.touch_at.x(),
            n.touch_at.y(), n.touch_at.z());
    constexpr std::array kinds{"rapid", "approach", "cut", "link", "retract"};
    const auto idle = idle_feed(job);
    for (std::size_t i = 0; i < idle.size(); ++i) {
        double all = 0, none = 0;
        if (idle[i][0] == ByKind{}) continue;
        std::fprintf(stderr, "%s: program %zu feeds", name.c_str(), i + 1);
        for (std::size_t k = 1; k < kinds.size(); ++k) {
            std::fprintf(stderr, ", %s %.0f / %.0f", kinds[k], idle[i][1][k], idle[i][0][k]);
            all += idle[i][0][k];
            none += idle[i][1][k];
        }
        std::fprintf(stderr, " mm without cutting anything: %.1f %%\n", 100 * none / all);
    }
    const auto seconds = seconds_of(job, machine);
    for (std::size_t i = 0; i < seconds.size(); ++i)
        std::fprintf(stderr, "%s: program %zu takes %.0f s, %.1f %% of it rapids\n", name.c_str(), i + 1,
                     seconds[i][0] + seconds[i][1], 100 * rapid_share({seconds[i]}));
    if (a.verifier_alone) return;
    for (std::size_t i = 0; i < seconds.size(); ++i)
        std::fprintf(stderr, "%s: naive: program %zu in the air %.1f %% of %.0f mm\n", name.c_str(), i + 1,
                     100 * n.program_air[i] / std::max(n.program_feed[i], 1e-9), n.program_feed[i]);
    std::fprintf(stderr, "%s: naive: in the air", name.c_str());
    for (std::size_t k = 1; k < kinds.size(); ++k)
        std::fprintf(stderr, ", %s %.0f / %.0f", kinds[k], n.air_by_kind[k], n.feed_by_kind[k]);
    std::fprintf(stderr, " mm\n%s: naive: %zu samples, %zu poses, gouge at (%.4g, %.4g, %.4g)\n",
                 name.c_str(), n.samples.size(), n.poses, n.gouge_at.x(), n.gouge_at.y(), n.gouge_at.z());
}

} // namespace

int main(int argc, char** argv) {
    const Asked a = asked(argc, argv);
    if (a.parts.empty() || !(a.coarse > 0)) {
        std::fprintf(stderr,
                     "usage: bench_real FOLDER [--list FILE] [--plans FOLDER] [--coarse K] [--places FOLDER] "
                     "[--verifier] [NAME ...]\n");
        return 2;
    }
    std::printf(
        "| part | origin | operations | facets | seconds: planning + verdict + naive check | deepest gouge, "
        "ours / naive | uncut, %% , ours / naive | verdict | feed in air, %% | rapids, %% of time | outside "
        "travel |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    int failed = 0;
    for (const auto& [name, origin] : a.parts) {
        try {
            row(a, name, origin);
        } catch (const Error& e) {
            std::printf("| %s | %s | %s |\n", name.c_str(), origin.c_str(), e.what());
            ++failed;
        }
        std::fflush(stdout);
    }
    return failed > 0;
}
