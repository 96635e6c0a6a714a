#include "ui/document_keys.h"

#include "core/job/asked_operations.h"
#include "core/job/bounds.h"
#include "core/job/cache_key.h"
#include "core/job/fixtures.h"
#include "core/job/planner.h"
#include "core/job/project_inputs.h"
#include "core/job/repaired_mesh.h"
#include "core/output/post/post.h"

#include <algorithm>

namespace facetmill::ui {

namespace {

/// The project without tools and operations, with what its files are in place of their names.
Project part_and_machine(const Project& project, const FileText& file_text) {
    const auto text = [&](const std::filesystem::path& path) {
        return path.empty() ? std::string() : file_text(path);
    };
    Project alone;
    alone.path = project.path;
    alone.part = project.placed_part();
    alone.part.file = text(project.part_path());
    alone.stock = project.stock;
    alone.stock.file = text(project.stock_path());
    alone.fixtures = project.fixtures;
    for (Fixture& fixture : alone.fixtures)
        fixture.file = text(project.fixture_path(fixture));
    alone.machine = is_machine_file(project.machine) ? text(project.machine_path()) : project.machine;
    return alone;
}

} // namespace

std::string part_key(const Project& project) {
    const auto placed = [](const std::filesystem::path& file, const auto& spec) {
        std::string key = file_stamp(file) + "|" + std::string(unit_name(spec.unit)) + "|"
                          + std::to_string(int(spec.mirror)) + "|" + format_number(spec.scale, 17);
        for (const auto& three : {spec.rotate, spec.translate})
            for (const double v : three)
                key += "|" + format_number(v, 17);
        return key;
    };
    std::string key = placed(project.part_path(), project.placed_part());
    key += "|" + reading_key(project.part_reading());
    if (project.part.flip) key += "|flip";
    key += recipe_key(project.part_recipe());
    if (const std::filesystem::path stock = project.stock_path(); !stock.empty())
        key += "|" + placed(stock, project.stock);
    if (const std::string fixtures = fixtures_key(project); !fixtures.empty()) key += "|held|" + fixtures;
    if (const std::string source = stock_source(project); !source.empty()) key += "|rest|" + source;
    return key;
}

std::string posting_key(const Project& project, const FileText& file_text) {
    const ProgramSpec& programs = project.programs;
    if (programs.post.empty()) return {};
    std::string key = std::string(unit_name(project.unit)) + "|" + project.machine + "|" + programs.post + "|"
                      + programs.wcs + "|" + std::to_string(programs.number) + "|"
                      + std::to_string(int(programs.files)) + (programs.arcs ? "|arcs" : "");
    key += "|" + std::to_string(int(programs.zero_from));
    for (const auto& three : {programs.zero_place, programs.zero})
        for (const double v : three)
            key += "|" + format_number(v, 17);
    if (is_machine_file(project.machine)) key += "|" + file_text(project.machine_path());
    if (is_post_file(programs.post)) key += "|" + file_text(project.post_path());
    return key;
}

std::string fingerprint(const Project& project, std::size_t i, const FileText& file_text) {
    Project alone = part_and_machine(project, file_text);
    std::string bounds; // boundaries that are named, and what they say
    const auto add = [&](const Operation& operation) {
        try {
            bounds += bounds_key(project, operation);
        } catch (const Error&) {
            bounds += "missing"; // planning says what
        }
        const std::vector<long> numbers = tools_of(operation);
        for (const Tool& t : project.tools)
            if (std::find(numbers.begin(), numbers.end(), t.number) != numbers.end()
                && std::find_if(alone.tools.begin(), alone.tools.end(), [&](const Tool& known) {
                       return known.number == t.number;
                   }) == alone.tools.end())
                alone.tools.push_back(t);
        alone.operations.push_back(operation.clone());
    };
    // What the operations before come to is part of what it is planned from, where it asks for that.
    for (const AskedOperation& asked : asked_operations(project, [&](std::size_t k) { return k == i; }))
        add(*asked.operation);
    // The unit is left out: it is one of the display and of the files, not of the path.
    std::string text = project_to_json(alone) + bounds;
    for (const ProjectInput& input : project_inputs(project))
        if (input.kind != ProjectInput::Kind::post) text += file_text(input.path) + "\n";
    return text + stock_source(project, file_text);
}

std::string verdict_source(const Project& project, std::size_t operations, const FileText& file_text) {
    Key key;
    for (std::size_t i = 0; i < operations; ++i)
        key.add(std::string_view(fingerprint(project, i, file_text)));
    key.add(std::string_view(posting_key(project, file_text))).add(unit_name(project.unit));
    return key.add_up_to(Stage::output, project.limits, verify_limit_parameters()).text();
}

} // namespace facetmill::ui
