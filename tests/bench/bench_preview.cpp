// Previews of passes, of every kind of operation: how long one takes that is the first over a part, and after
// a change; with --plan also what the plan is, which is what the preview is to foretell. A table in Markdown.
//
//     bench_preview [--plan] [FILE ...]
//
// FILE: a mesh, for which operations of all kinds are made as a user gets them, or a project, whose own are
// shown; without any, hills of 100 000 and of a million facets. Times are medians of five, in milliseconds.
#include "core/job/new_operation.h"
#include "core/job/preview_job.h"
#include "core/mesh/mesh_io.h"
#include "tests/bench/median.h"
#include "tests/support/random_meshes.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

using namespace facetmill;
namespace fs = std::filesystem;

namespace {

constexpr int turns = 5;

double milliseconds(const std::function<void()>& work) {
    const auto from = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count();
}

double hills(double x, double y) {
    return 10 * std::sin(0.11 * x) * std::cos(0.07 * y) + 2 * std::sin(0.5 * x + 0.3 * y);
}

/// A project with an operation of every kind over a mesh.
Project project_of(const fs::path& file) {
    Project project = default_project(file, LengthUnit::mm, load_mesh(file, {}, Progress()).mesh->box());
    project.operations.clear();
    for (const OperationKind& kind : operation_kinds()) {
        NewOperation made = new_operation(kind.kind, project);
        if (made.tool) project.tools.push_back(*made.tool);
        project.operations.push_back(std::move(made.operation));
    }
    return project;
}

double cut_length(const OperationResult& result) {
    double sum = 0;
    for (const Pass& pass : result.path.passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            sum += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
    return sum;
}

void show(const fs::path& file, bool plan) {
    const Project project = file.extension() == ".facetmill" ? load_project(file) : project_of(file);
    Planner planner;
    const auto part = planner.prepare(project, Progress());
    for (std::size_t i = 0; i < project.operations.size(); ++i) {
        const Operation& operation = *project.operations[i];
        std::printf("| %s | %zu | %s | ", file.stem().string().c_str(), part->mesh->facet_count(),
                    std::string(operation.kind()).c_str());
        try {
            PassPreview preview;
            std::vector<double> first, again;
            for (int k = 0; k < turns; ++k) {
                PassPreviewer previewer;
                const auto look = [&] { preview = previewer.preview(project, i, *part, Progress()); };
                first.push_back(milliseconds(look));
                again.push_back(milliseconds(look));
            }
            std::printf("%.0f | %.0f | %zu | %.0f |", bench::median(first), bench::median(again),
                        preview.passes, preview.estimated_length());
        } catch (const Error& e) {
            std::printf("%s | | | |", e.what());
        }
        if (plan) try {
                const auto result = planner.plan(project, operation.common().name, Progress());
                const OperationResult& own = *result->operations.front();
                std::printf(" %d | %.0f | %.1f |", own.path.drive_planes, cut_length(own),
                            own.seconds_strategy);
            } catch (const Error& e) {
                std::printf(" %s | | |", e.what());
            }
        std::printf("\n");
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    bool plan = false;
    std::vector<fs::path> files;
    for (int k = 1; k < argc; ++k)
        if (std::string(argv[k]) == "--plan")
            plan = true;
        else
            files.emplace_back(argv[k]);
    std::printf(
        "| part | facets | kind | first | again | passes | length |%s\n|---|---|---|---|---|---|---|%s\n",
        plan ? " planned passes | length | s |" : "", plan ? "---|---|---|" : "");
    try {
        if (files.empty())
            for (const std::size_t facets : {100'000, 1'000'000}) {
                const fs::path file = fs::temp_directory_path() / ("hills" + std::to_string(facets) + ".stl");
                const int n = int(std::lround(std::sqrt(double(facets) / 2)));
                save_stl(*test::field(n, 100, hills, 0.3), file, LengthUnit::mm, Progress());
                show(file, plan);
                fs::remove(file);
            }
        for (const fs::path& file : files)
            show(file, plan);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
    return 0;
}
