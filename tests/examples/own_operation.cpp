// Adds an operation: one pass along the diagonal of the part. It registers itself, so projects, forms, the
// command line and the planner know it by its kind, and the links between passes, the program file and the
// report come from the library.
#include "core/gouge/axial_lift.h"
#include "core/job/planner.h"
#include "core/job/program_files.h"
#include "core/mesh/sample.h"

#include <cmath>
#include <cstdio>

using namespace facetmill;
namespace fs = std::filesystem;

namespace {

struct DiagonalSettings : OperationCommon {
    double step = 0.25; ///< mm
};

const ParameterTable<DiagonalSettings>& diagonal_parameters() {
    static const auto table = [] {
        ParameterTable<DiagonalSettings> t;
        add_common_parameters(t);
        t.add(&DiagonalSettings::step, {.key = "step",
                                        .label = "Step",
                                        .help = "Distance of the points on the diagonal.",
                                        .kind = ParameterKind::number,
                                        .quantity = Quantity::length,
                                        .minimum = 0.01,
                                        .maximum = 10});
        return t;
    }();
    return table;
}

class Diagonal : public OperationWith<DiagonalSettings, diagonal_parameters> {
public:
    std::string_view kind() const override { return "diagonal"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Diagonal>(*this); }
    bool keeps_axis() const override { return true; }

    StrategyResult plan(const PlanContext& context, const Progress& progress) const override {
        check_plannable(context, settings_);
        const AxialLift lift(context.contact, CutterProfile(context.tool.cutter()), settings_.allowance);
        const Vec3 from = context.part_box.lo, run = context.part_box.hi - from;
        const int n = int(std::ceil(std::hypot(run.x(), run.y()) / settings_.step));
        Pass pass;
        for (int i = 0; i <= n; ++i) {
            if (i % 256 == 0) progress.set(double(i) / n);
            const double x = from.x() + run.x() * i / n, y = from.y() + run.y() * i / n;
            const AxialContact contact = lift.contact(x, y);
            if (contact.facet == no_index) continue;
            pass.cc.push_back({contact.point, context.part->facet_normal(contact.facet)});
            pass.cl.push_back({Vec3(x, y, contact.tip_z), Vec3::UnitZ()});
        }
        if (pass.cl.empty()) throw Error(ErrorCode::empty_result, "diagonal", "the cutter meets nothing", "");
        StrategyResult result;
        result.passes.push_back(std::move(pass));
        result.drive_planes = 1;
        return result;
    }
};

const OperationRegistration registration("diagonal", "Diagonal", [] { return std::make_unique<Diagonal>(); });

} // namespace

int main() {
    try {
        const Progress progress;
        const fs::path part_file = "own_operation_sample.stl";
        const MeshPtr part = make_sample("concave", 0.05, progress);
        save_stl(*part, part_file, LengthUnit::mm, progress);

        Project project = default_project(part_file, LengthUnit::mm, part->box());
        auto operation = make_operation("diagonal");
        operation->common().name = "Diagonal";
        operation->common().tool = project.tools.front().number;
        operation->set("step", 0.5);
        project.operations.clear();
        project.operations.push_back(std::move(operation));

        Planner planner;
        const auto plan = planner.plan(project, "", progress);
        const auto& planned = *plan->operations.front();
        std::printf("%s: %zu points, %zu motions\n", planned.name.c_str(), planned.cl_points,
                    planned.program.motions.motions.size());
        write_plan(project, *plan, "diagonal", progress);
        return planned.cl_points > 10 ? 0 : 1;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
