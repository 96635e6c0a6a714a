// Plans a part with the operation that suits its size, and writes the program and the report into a folder.
//
//     plan_and_write [PART.stl]
#include "core/job/planner.h"
#include "core/job/program_files.h"
#include "core/mesh/sample.h"

#include <cstdio>

using namespace facetmill;
namespace fs = std::filesystem;

namespace {

void run(const fs::path& part_file) {
    const Progress progress;
    const Box3 box = load_mesh(part_file, LengthUnit::mm, progress).mesh->box();
    Project project = default_project(part_file, LengthUnit::mm, box);
    project.operations.front()->set("tolerance", 0.2); // mm; keys and ranges: resources/reference.md

    Planner planner;
    const auto plan = planner.plan(project, "", progress);
    for (const fs::path& file : write_plan(project, *plan, "program", progress)) {
        std::printf("%s, %ju bytes\n", file.c_str(), std::uintmax_t(fs::file_size(file)));
        if (fs::file_size(file) == 0) throw Error(ErrorCode::empty_result, file, "the file is empty", "");
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        fs::path part = argc > 1 ? argv[1] : "plan_and_write_sample.stl";
        if (argc < 2) save_stl(*make_sample("concave", 0.05, Progress()), part, LengthUnit::mm, Progress());
        run(part);
        return 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
