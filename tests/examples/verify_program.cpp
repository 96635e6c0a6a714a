// Judges a program that somebody else wrote: faces a plate with a flat cutter and dips into it once.
#include "core/output/apt.h"
#include "core/verify/verify.h"

#include <cmath>
#include <cstdio>

using namespace facetmill;

namespace {

/// A plate of 40 x 20 x 10 mm from the origin.
Mesh plate() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back(i & 1 ? 40 : 0, i & 2 ? 20 : 0, i & 4 ? 10 : 0);
    mesh.facets = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

const char* const foreign = R"(PARTNO PLATE
UNITS/MM
CUTTER/10,0,5,0,0,0,30
LOADTL/1
SPINDL/3000,CLW
RAPID
GOTO/-10,4,20
FEDRAT/500,MMPM
GOTO/-10,4,10
GOTO/50,4,10
GOTO/50,12,10
GOTO/20,12,10
GOTO/20,12,9.5
GOTO/20,12,10
GOTO/-10,12,10
GOTO/-10,18,10
GOTO/50,18,10
RAPID
GOTO/50,18,20
FINI
)";

} // namespace

int main() {
    try {
        const Progress progress;
        const AptReadResult read = parse_apt(foreign, "plate.apt", LengthUnit::mm, progress);
        const auto& section = read.program.sections.front(); // one operation, one tool
        const VerifyProgram program{
            .name = "Plate", .tool = VerifyTool(section->cutter), .motions = {section, &section->motions}};
        StockSolid stock; // the plate with 2 mm on top
        stock.box.add(Vec3(0, 0, 0));
        stock.box.add(Vec3(40, 20, 12));
        VerifySettings settings;
        settings.tolerance = 0.05;
        settings.gouge_limit = 0.01;
        const Verification result = verify(plate(), stock, {&program, 1}, settings, progress);

        std::printf("deepest gouge %.3f mm, %zu collisions, %s\n", result.figures.gouge_max,
                    result.collisions.size(), result.passed() ? "passed" : "not passed");
        for (const DeviationExtreme& gouge : result.gouges)
            std::printf("gouge of %.3f mm at %.2f, %.2f by motion %zu\n", -gouge.deviation, gouge.point.x(),
                        gouge.point.y(), gouge.by.motion + 1);
        // The program dips half a millimetre into the plate: the judge has to say so.
        return !result.passed() && std::abs(result.figures.gouge_max - 0.5) < 0.02 ? 0 : 1;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
