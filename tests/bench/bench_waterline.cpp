// Contours at constant heights beside OpenCAMLib's, where it was found when this was built: a ball, the same
// levels, the same mesh. Each row: how long all cuts are together, processor time, and how the ball stands to
// the part at the ends of the pieces and half-way between them: how deep in it at worst, how far off it at
// worst. What is too deep spoils the part; what is off leaves it standing. That is asked of all facets by
// brute force, which shares nothing with either. A table in Markdown.
//
//     bench_waterline MESH.stl DIAMETER LEVELS [LONGEST]
//
// DIAMETER in mm, LONGEST: the mesh is scaled to so many mm (default: as it is, in mm).
#include "core/job/planner.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/triangle_distance.h"
#include "core/strategy/waterline/waterline.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/opencamlib.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <set>

using namespace facetmill;
namespace fs = std::filesystem;

namespace {

using Loops = std::vector<std::vector<Vec3>>;

/// Places that are held to the part: more of them tell no more, and each asks all facets.
constexpr std::size_t held_places = 4000;
/// Motions whose ends differ by less are level, mm.
constexpr double level = 1e-7;

struct Levels {
    Loops loops; ///< of tips
    double processor = 0;
};

Levels timed(const std::function<Loops()>& work) {
    const double before = bench::cpu_now();
    Levels made;
    made.loops = work();
    made.processor = bench::cpu_now() - before;
    return made;
}

/// The level cuts of a planned waterline, from the file to the program.
Loops ours(const fs::path& file, double diameter, double step) {
    Project project;
    project.part.file = file.string();
    project.machine = "generic-3-axis";
    project.stock.margin = {diameter, diameter, 1}; // room for the outermost contours
    Tool ball;
    ball.number = 1;
    ball.diameter = ball.shank_diameter = diameter;
    ball.corner_radius = 0.5 * diameter;
    ball.flute_length = ball.shank_length = 500; // neither shank nor holder has a say
    project.tools = {ball};
    WaterlineSettings s;
    s.tool = 1;
    s.tolerance = 0.05;
    s.stepdown = {step, ""};
    s.slope_limits = {0, radians(90)};
    project.operations.push_back(std::make_unique<Waterline>(s));
    Planner planner;
    const auto plan = planner.plan(project, "", Progress());
    Loops loops;
    const auto& motions = plan->operations.at(0)->program.motions.motions;
    for (std::size_t i = 1; i < motions.size(); ++i) {
        const Vec3 &from = motions[i - 1].to.tip, &to = motions[i].to.tip;
        const bool cuts = motions[i].kind == MotionKind::cut && std::abs(from.z() - to.z()) < level;
        if (!cuts) continue;
        if (loops.empty() || loops.back().back() != from) loops.push_back({from});
        loops.back().push_back(to);
    }
    return loops;
}

std::vector<double> heights_of(const Loops& loops) {
    std::set<long long> rounded;
    for (const auto& loop : loops)
        rounded.insert(std::llround(loop.front().z() / level));
    std::vector<double> heights;
    for (const long long z : rounded)
        heights.push_back(double(z) * level);
    return heights;
}

double length_of(const Loops& loops) {
    double sum = 0;
    for (const auto& loop : loops)
        for (std::size_t i = 1; i < loop.size(); ++i)
            sum += (loop[i] - loop[i - 1]).norm();
    return sum;
}

struct Stand {
    double in = 0, off = 0; ///< mm, at worst
    double off_mostly = 0;  ///< of 99 in 100 places
};

Stand stand_of(const Loops& loops, const Mesh& part, double radius) {
    std::vector<Vec3> centres;
    for (const auto& loop : loops)
        for (std::size_t i = 1; i < loop.size(); ++i)
            for (const double t : {0.5, 1.0})
                centres.push_back(loop[i - 1] + t * (loop[i] - loop[i - 1]) + Vec3(0, 0, radius));
    const std::size_t stride = centres.size() / held_places + 1;
    std::vector<double> off;
    Stand stand;
    for (std::size_t i = 0; i < centres.size(); i += stride) {
        const Vec3& c = centres[i];
        double square = infinity;
        for (std::size_t f = 0; f < part.facet_count(); ++f) {
            const Vec3 a = part.corner(f, 0), b = part.corner(f, 1), d = part.corner(f, 2);
            const Vec3 away = (a.cwiseMin(b).cwiseMin(d) - c).cwiseMax(c - a.cwiseMax(b).cwiseMax(d));
            if (away.cwiseMax(0).squaredNorm() < square)
                square = std::min(square, squared_distance(c, a, b, d));
        }
        const double distance = std::sqrt(square);
        stand.in = std::max(stand.in, radius - distance);
        off.push_back(std::max(distance - radius, 0.0));
    }
    if (off.empty()) return stand;
    std::sort(off.begin(), off.end());
    stand.off = off.back();
    stand.off_mostly = off[std::size_t(0.99 * double(off.size() - 1))];
    return stand;
}

void print(const char* name, const Levels& levels, const Mesh& part, double diameter) {
    const Stand stand = stand_of(levels.loops, part, 0.5 * diameter);
    std::printf("| %s | %zu | %.0f | %.2f | %.4f | %.4f | %.4f |\n", name, levels.loops.size(),
                length_of(levels.loops), levels.processor, stand.in, stand.off_mostly, stand.off);
    std::fflush(stdout);
}

int run(const char* name, double diameter, int count, double longest) {
    Mesh part = *load_mesh(name, LengthUnit::mm, Progress()).mesh;
    const double scale = longest > 0 ? longest / part.box().size().maxCoeff() : 1;
    for (Vec3& v : part.vertices)
        v *= scale;
    const fs::path file =
        fs::temp_directory_path() / ("bench_waterline_" + std::to_string(getpid()) + ".stl");
    save_stl(part, file, LengthUnit::mm, Progress());
    const double step = part.box().size().z() / count;
    const Levels mine = timed([&] { return ours(file, diameter, step); });
    const Mesh read = *load_mesh(file, LengthUnit::mm, Progress()).mesh; // as the file rounds it
    fs::remove(file);
    const std::vector<double> heights = heights_of(mine.loops);
    std::printf("%zu facets, ball %g mm, %zu levels, %.3f mm apart\n\n", read.facet_count(), diameter,
                heights.size(), step);
    std::printf("| | pieces | cut, mm | processor, s | in, mm | off, 99 %%, mm | off, mm |\n");
    std::printf("|---|---|---|---|---|---|---|\n");
    print("Facetmill `waterline`", mine, read, diameter);
    if (!opencamlib_is_here()) {
        std::printf("OpenCAMLib is not here\n");
        return 0;
    }
    const double even = diameter / 20;
    print("OpenCAMLib `Waterline`",
          timed([&] { return waterline_by_opencamlib(read, diameter, heights, even, 0); }), read, diameter);
    print("OpenCAMLib `AdaptiveWaterline`",
          timed([&] { return waterline_by_opencamlib(read, diameter, heights, even, even / 10); }), read,
          diameter);
    return 0;
}

} // namespace

int main(int count, char** values) {
    if (count < 4 || count > 5) {
        std::fprintf(stderr, "usage: bench_waterline MESH.stl DIAMETER LEVELS [LONGEST]\n");
        return 2;
    }
    try {
        return run(values[1], std::atof(values[2]), std::atoi(values[3]),
                   count == 5 ? std::atof(values[4]) : 0);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "bench_waterline: %s\n", e.what());
        return 1;
    }
}
