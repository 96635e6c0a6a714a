// How long suggestions take, and which they are: a part from a file, with the project that opening it makes.
//
//     bench_suggest FILE [UNIT [X Y Z [TOLERANCE]]]
//
// UNIT: mm by default. X Y Z: how the part is turned, degrees. TOLERANCE: of the operations, mm, where it is
// not to be the default.
#include "core/base/units.h"
#include "core/job/planner.h"
#include "core/job/project.h"
#include "core/mesh/mesh_io.h"
#include "core/study/previewed.h"
#include "core/study/suggest.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>

using namespace facetmill;

namespace {

double processor_seconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

/// Prints what a job is at, as it goes on to another task.
class TaskWatch {
public:
    TaskWatch() : thread_([this] { watch(); }) {}
    ~TaskWatch() {
        over_ = true;
        thread_.join();
    }
    Job job;

private:
    void watch() {
        std::string task;
        while (!over_) {
            const std::string label = job.label(), now = label.substr(0, label.find(':'));
            if (now != task)
                std::printf("%8.1f s  %5.3f  %s\n", processor_seconds(), job.fraction(), now.c_str());
            task = now;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }

    std::atomic<bool> over_{false};
    std::thread thread_;
};

} // namespace

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    if (argc < 2) {
        std::fputs("usage: bench_suggest FILE [UNIT [X Y Z [TOLERANCE]]]\n", stderr);
        return 2;
    }
    try {
        const LengthUnit unit = argc > 2 ? parse_mesh_unit(argv[2], "UNIT") : LengthUnit::mm;
        const LoadedMesh loaded = load_mesh(argv[1], unit, Progress());
        Project project;
        project = default_project(argv[1], unit, loaded.mesh->box());
        if (argc > 5)
            for (int k = 0; k < 3; ++k)
                project.part.rotate[k] = radians(std::atof(argv[3 + k]));
        if (argc > 6) project.operations.front()->common().tolerance = std::atof(argv[6]);
        const auto part = Planner().prepare(project, Progress());
        PassPreviewer previewer;
        for (const auto& operation : suggestable(project)) {
            Project with = project;
            with.operations.clear();
            with.operations.push_back(operation->clone());
            const double before = processor_seconds();
            try {
                const PreviewedOperation p = previewed_operation(previewer, with, 0, *part, Progress());
                std::printf("%-16s previewed: %8.0f s  uncut %.4f  planning %6.1f s; took %.2f s\n",
                            std::string(operation->kind()).c_str(), p.seconds, p.uncut_share,
                            p.planning_seconds, processor_seconds() - before);
            } catch (const std::exception& e) {
                std::printf("%-16s %s\n", std::string(operation->kind()).c_str(), e.what());
            }
        }
        const double begun = processor_seconds();
        Suggestions found;
        {
            TaskWatch watch;
            found = suggest(project, *part, Progress(watch.job));
        }
        std::printf("%zu facets, %zu candidates, %.1f s of processor time\n", part->mesh->facet_count(),
                    found.looked_at, processor_seconds() - begun);
        for (const Suggestion& s : found.best)
            std::printf("%-16s %-16s %8.0f s  uncut %.4f  p99 %.4f  %s\n",
                        std::string(s.operation->kind()).c_str(), s.tool.c_str(), s.seconds,
                        s.result.measures[Measure::uncut_share].value_or(-1),
                        s.result.measures[Measure::excess_p99].value_or(-1),
                        s.previewed       ? "previewed"
                        : s.result.passed ? "passed"
                                          : s.result.why.c_str());
        for (const auto& [name, why] : found.refused)
            std::printf("refused: %s: %s\n", name.c_str(), why.c_str());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
    return 0;
}
