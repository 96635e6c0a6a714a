// A block with a hollow in each of its six sides as a job of three setups.
#pragma once

#include "core/job/project.h"
#include "core/mesh/mesh_io.h"
#include "tests/support/part_meshes.h"

#include <QTemporaryDir>

#include <filesystem>
#include <string>

namespace facetmill::test {

/// Top, bottom and the side at high X, each with one finishing operation on what was left before.
struct BlockJob {
    explicit BlockJob(double tolerance = 0.05) {
        const auto operation = [&](const char* name) {
            return std::string("{ \"kind\": \"finish3\", \"name\": \"") + name
                   + "\", \"tool\": 1, \"tolerance\": " + std::to_string(tolerance)
                   + ", \"feed\": 1000, \"clearance\": 3 }";
        };
        const std::filesystem::path root(dir.path().toStdString());
        save_stl(HollowedBlock::mesh(), root / "block.stl", LengthUnit::mm, {});
        project = parse_project(
            R"({ "facetmill": 2, "units": "mm", "part": { "file": "block.stl" },)"
            R"("tools": [ { "number": 1, "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_length": 30 } ],)"
            R"("setups": [ { "name": "Top", "stock": { "kind": "box", "margin": [0, 0, 1] }, "operations": [ )"
                + operation("Finish")
                + R"( ] }, { "name": "Bottom", "place": { "rotate": [180, 0, 0], "translate": [0, 30, 24] }, "operations": [ )"
                + operation("Finish below")
                + R"( ] }, { "name": "Side", "place": { "rotate": [0, -90, 0], "translate": [24, 0, 0] }, "operations": [ )"
                + operation("Finish aside") + " ] } ] }",
            "block");
        project.path = root / "block.facetmill";
    }
    QTemporaryDir dir;
    Project project;
};

} // namespace facetmill::test
