// A small job of every kind of operation, with tools that have shank and holder, and how deep points come to
// lie in them: for what tools have to keep off.
#pragma once

#include "core/job/planner.h"
#include "core/mesh/mesh_io.h"
#include "tests/property/shapes.h"
#include "tests/support/naive_depth.h"
#include "tests/support/random_meshes.h"

#include <QTemporaryDir>

#include <cmath>
#include <filesystem>
#include <vector>

namespace facetmill::test {

struct HeldCase {
    const char* kind;
    const char* machine;
    bool turns;
};
inline const HeldCase held_cases[] = {
    {"rough", "generic-3-axis", false},         {"finish3", "generic-3-axis", false},
    {"cleanup", "generic-3-axis", false},       {"finish5", "trunnion-ac", false},
    {"global_local", "trunnion-ac", false},     {"waterline", "generic-3-axis", false},
    {"steep_shallow", "generic-3-axis", false}, {"radial", "generic-3-axis", false},
    {"pencil", "generic-3-axis", false},        {"scallop", "generic-3-axis", false},
    {"lathe_rough", "lathe-mill", true},        {"lathe_finish", "lathe-mill", true}};

inline Mesh rod() {
    Mesh mesh;
    const int around = 24;
    for (int i = 0; i <= 8; ++i)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * pi * k / around, radius = 8 + std::cos(2 * angle);
            mesh.vertices.emplace_back(3.0 * i, radius * std::cos(angle), radius * std::sin(angle));
        }
    const auto at = [&](int i, int k) { return Index(i * around + k % around); };
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < around; ++k) {
            mesh.facets.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.facets.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    for (int k = 1; k + 1 < around; ++k) {
        mesh.facets.push_back({at(0, 0), at(0, k), at(0, k + 1)});
        mesh.facets.push_back({at(8, 0), at(8, k + 1), at(8, k)});
    }
    return mesh;
}

inline Tool holding(Tool tool, long number) {
    tool.number = number;
    tool.name = "Tool " + std::to_string(number);
    tool.flute_length = 12;
    tool.shank_diameter = tool.diameter;
    tool.shank_length = 6;
    tool.holder = {{14, 20}};
    return tool;
}

class HeldJob {
    QTemporaryDir dir_;

public:
    Project project;

    explicit HeldJob(const HeldCase& c) {
        const std::filesystem::path folder(dir_.path().toStdString());
        const auto waves = [](double x, double y) {
            return 1.5 * std::sin(0.3 * x) * std::cos(0.25 * y) - 4 * std::exp(-y * y / 6);
        };
        save_stl(c.turns ? rod() : height_field(waves, Vec2(-14, -10), Vec2(14, 10), 28, 20),
                 folder / "part.stl", LengthUnit::mm, {});
        project.path = folder / "p.facetmill";
        project.part.file = "part.stl";
        project.machine = c.machine;
        project.stock.margin = {1, 1, 1};
        if (c.turns) {
            project.stock.kind = StockSpec::Kind::cylinder;
            project.stock.axis = StockSpec::Axis::x;
        }
        project.tools = {holding(ball_tool(6), 1), holding(ball_tool(10), 2), holding(ball_tool(3), 3)};
        auto op = make_operation(c.kind);
        op->common().name = "Op";
        op->common().tolerance = 0.3;
        for (const char* key : {"previous_tool", "rework_tool"})
            for (const ParameterInfo* p : op->parameters())
                if (p->key == key) op->set(key, p->key == "rework_tool" ? 3L : 2L);
        project.operations.push_back(std::move(op));
    }
    std::shared_ptr<const PlanResult> plan() const { return Planner().plan(project, {}, {}); }
};

} // namespace facetmill::test
