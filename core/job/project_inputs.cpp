#include "core/job/project_inputs.h"

#include "core/output/post/post.h"
#include "core/setup/machine.h"

#include <algorithm>
#include <system_error>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

std::string& input_file(Project& project, const ProjectInput& input) {
    switch (input.kind) {
    case ProjectInput::Kind::stock:
        return project.stock.file;
    case ProjectInput::Kind::fixture:
        return project.fixtures.at(input.place).file;
    case ProjectInput::Kind::machine:
        return project.machine;
    case ProjectInput::Kind::post:
        return project.programs.post;
    case ProjectInput::Kind::scan:
        return project.part.repair.at(input.place).file;
    case ProjectInput::Kind::part:
        break;
    }
    return project.part.file;
}

} // namespace

std::string_view input_name(ProjectInput::Kind kind) {
    switch (kind) {
    case ProjectInput::Kind::stock:
        return "stock";
    case ProjectInput::Kind::fixture:
        return "fixture";
    case ProjectInput::Kind::machine:
        return "machine";
    case ProjectInput::Kind::post:
        return "post";
    case ProjectInput::Kind::scan:
        return "scan";
    case ProjectInput::Kind::part:
        break;
    }
    return "part";
}

bool is_missing(const fs::path& path) {
    std::error_code ec;
    return fs::status(path, ec).type() == fs::file_type::not_found;
}

std::vector<ProjectInput> project_inputs(const Project& project) {
    using Kind = ProjectInput::Kind;
    std::vector<ProjectInput> inputs;
    if (!project.part.file.empty()) inputs.push_back({Kind::part, project.part_path()});
    const std::vector<RepairStep> recipe = project.part_recipe();
    for (std::size_t i = 0; i < recipe.size(); ++i)
        if (!recipe[i].file.empty()) inputs.push_back({Kind::scan, recipe[i].file, i});
    if (const fs::path stock = project.stock_path(); !stock.empty()) inputs.push_back({Kind::stock, stock});
    for (std::size_t i = 0; i < project.fixtures.size(); ++i)
        if (const fs::path file = project.fixture_path(project.fixtures[i]); !file.empty())
            inputs.push_back({Kind::fixture, file, i});
    if (is_machine_file(project.machine)) inputs.push_back({Kind::machine, project.machine_path()});
    if (is_post_file(project.programs.post)) inputs.push_back({Kind::post, project.post_path()});
    return inputs;
}

std::vector<ProjectInput> missing_inputs(const Project& project) {
    std::vector<ProjectInput> inputs = project_inputs(project);
    std::erase_if(inputs, [](const ProjectInput& input) { return !is_missing(input.path); });
    return inputs;
}

void check_inputs(const Project& project) {
    std::string keys, places;
    for (const ProjectInput& input : missing_inputs(project)) {
        if (input.kind == ProjectInput::Kind::post) continue;
        keys += (keys.empty() ? "" : ", ") + input_key(input);
        places += (places.empty() ? "" : ", ") + printable(input.path.string(), 400);
    }
    if (!keys.empty())
        throw Error(ErrorCode::not_found, keys, "there is no file " + places,
                    "put it there, or name another one in the project");
}

const std::string& written_name(const Project& project, const ProjectInput& input) {
    return input_file(const_cast<Project&>(project), input); // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

std::string input_key(const ProjectInput& input) {
    using Kind = ProjectInput::Kind;
    if (input.kind == Kind::fixture) return "fixtures[" + std::to_string(input.place) + "].file";
    if (input.kind == Kind::scan) return "part.repair[" + std::to_string(input.place) + "].file";
    const bool named_itself = input.kind == Kind::machine || input.kind == Kind::post;
    return std::string(input_name(input.kind)) + (named_itself ? "" : ".file");
}

void write_name(Project& project, const ProjectInput& input, const std::string& name) {
    input_file(project, input) = name;
}

void set_input(Project& project, const ProjectInput& input, const fs::path& file) {
    std::error_code ec;
    const fs::path absolute = fs::absolute(file, ec).lexically_normal();
    fs::path named = absolute;
    if (!project.path.empty()) {
        const fs::path folder = fs::absolute(project.path, ec).lexically_normal().parent_path();
        const fs::path relative = absolute.lexically_relative(folder);
        // A folder on the way that is a link has another folder above it than its name says.
        if (!relative.empty() && fs::equivalent(folder / relative, absolute, ec) && !ec) named = relative;
    }
    write_name(project, input, named.generic_string());
}

void take_inputs(Project& to, const Project& from) {
    to.part.file = from.part.file;
    for (std::size_t i = 0; i < to.part.repair.size(); ++i)
        to.part.repair[i].file = from.part.repair.at(i).file;
    for (std::size_t i = 0; i < setup_count(to); ++i) {
        Setup& setup = setup_at(to, i);
        const Setup& named = setup_at(from, i);
        setup.stock.file = named.stock.file;
        for (std::size_t k = 0; k < setup.fixtures.size(); ++k)
            setup.fixtures[k].file = named.fixtures.at(k).file;
        setup.machine = named.machine;
        setup.programs.post = named.programs.post;
    }
}

std::vector<ProjectInput> locate_input(Project& project, const ProjectInput& missing, const fs::path& file) {
    const std::vector<ProjectInput> others = missing_inputs(project);
    std::error_code ec;
    const fs::path folder = fs::absolute(file, ec).parent_path();
    set_input(project, missing, file);
    std::vector<ProjectInput> found;
    for (const ProjectInput& other : others) {
        if (other == missing) continue;
        const fs::path beside =
            other.path.lexically_normal().lexically_relative(missing.path.lexically_normal().parent_path());
        for (const fs::path& place : {folder / beside, folder / other.path.filename()}) {
            if (!fs::is_regular_file(place, ec)) continue;
            set_input(project, other, place);
            found.push_back({other.kind, place.lexically_normal(), other.place});
            break;
        }
    }
    return found;
}

} // namespace facetmill
