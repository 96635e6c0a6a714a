#include "core/job/program_files.h"

#include "core/base/file.h"
#include "core/base/latin.h"
#include "core/job/new_folder.h"
#include "core/job/posting.h"
#include "core/job/report.h"
#include "core/output/apt.h"
#include "core/output/program_writer.h"

#include <set>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_name = 60;
constexpr const char* report_file_name = "report.json";

std::size_t place_in_setup(const Project& project, const PlanResult& result, std::size_t program) {
    const std::string& owner = result.operations[result.owner(program)]->name;
    std::size_t place = 0;
    while (place < project.operations.size() && project.operations[place]->common().name != owner)
        ++place;
    return place;
}

/// Counted through all setups, so that no two files of a project have one name.
std::size_t place_in_project(const Project& project, const PlanResult& result, std::size_t program) {
    return operations_before(project) + place_in_setup(project, result, program);
}

/// "01-Finish": program_file_name without the extension.
std::string file_stem(std::size_t place, const std::string& operation_name) {
    const std::string number = std::to_string(place);
    return (number.size() < 2 ? "0" + number : number) + "-" + program_stem(operation_name);
}

/// The program of one operation, sharing its motions.
ClProgram program_of(const Project& project, const std::shared_ptr<const OperationResult>& result) {
    ClProgram program;
    program.part_name = printable(fs::path(project.part.file).stem().string(), 200);
    program.unit = project.unit;
    program.sections.emplace_back(result, &result->program);
    return program;
}

} // namespace

std::string program_stem(const std::string& text) {
    std::string name;
    for (const char ch : without_marks(text)) {
        const auto c = static_cast<unsigned char>(ch);
        if ((c & 0xC0) == 0x80) continue; // one '-' per UTF-8 character
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')
                           || c == '_' || c == '.';
        if (plain)
            name += ch;
        else if (!name.empty() && name.back() != '-')
            name += '-';
        if (name.size() == longest_name) break;
    }
    while (!name.empty() && (name.back() == '-' || name.back() == '.'))
        name.pop_back();
    return name.empty() ? "operation" : name;
}

const Operation& operation_of(const Project& project, const PlanResult& result, std::size_t program) {
    return *project.operations.at(place_in_setup(project, result, program));
}

std::string program_file_name(std::size_t place, const std::string& operation_name) {
    return file_stem(place, operation_name) + apt_writer().extension;
}

std::string program_file_name(const Project& project, const PlanResult& result, std::size_t program) {
    return program_file_name(place_in_project(project, result, program) + 1,
                             result.operations[program]->name);
}

std::string posted_file_name(const Project& project, const PlanResult& result, std::size_t program,
                             const std::string& extension) {
    return file_stem(place_in_project(project, result, program) + 1, result.operations[program]->name)
           + extension;
}

std::vector<std::string> plan_file_names(const Project& project, const PlanResult& result) {
    std::vector<std::string> names;
    const std::size_t n = result.operations.size();
    if (!project.programs.post.empty()) {
        const std::string extension = project_post(project, project.programs.post).extension;
        if (project.programs.files == ProgramSpec::Files::one)
            names.push_back(joined_program_name(project, extension));
        else
            for (std::size_t i = 0; i < n; ++i)
                names.push_back(posted_file_name(project, result, i, extension));
    }
    for (std::size_t i = 0; i < n; ++i)
        names.push_back(program_file_name(project, result, i));
    names.emplace_back(report_file_name);
    return names;
}

std::string joined_program_name(const Project& project, const std::string& extension) {
    std::string stem = program_stem(fs::path(project.part.file).stem().string());
    if (setup_count(project) > 1)
        stem += "-" + std::to_string(chosen_setup(project) + 1) + "-" + program_stem(project.name);
    return stem + extension;
}

std::vector<std::string> program_file_names(const Project& project) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < setup_count(project); ++k) {
        const Project view = view_of_setup(project, k);
        const std::size_t n = view.operations.size(), first = operations_before(view) + 1;
        const auto name = [&](std::size_t i) { return view.operations[i]->common().name; };
        const auto off = [&](std::size_t i) { return view.operations[i]->common().off; };
        for (std::size_t i = 0; i < n; ++i)
            if (!off(i)) names.push_back(program_file_name(first + i, name(i)));
        if (view.programs.post.empty()) continue;
        const std::string extension = project_post(view, view.programs.post).extension;
        if (view.programs.files == ProgramSpec::Files::one)
            names.push_back(joined_program_name(view, extension));
        else
            for (std::size_t i = 0; i < n; ++i)
                if (!off(i)) names.push_back(file_stem(first + i, name(i)) + extension);
    }
    names.emplace_back(report_file_name);
    std::set<std::string> known;
    for (const std::string& name : names)
        if (!known.insert(name).second)
            throw Error(ErrorCode::out_of_range, "setups", "two programs would have the name '" + name + "'",
                        "rename an operation, a setup or the part's file");
    return names;
}

namespace {

/// Programs of a setup into the files of a set. Returns their paths.
std::vector<fs::path> add_programs(const Project& project, const PlanResult& result, const fs::path& folder,
                                   const std::vector<PostedFile>& posted_files, OutputSet& files,
                                   const Progress& progress) {
    const auto add = [&](const fs::path& path) -> OutputFile& {
        keep_inputs(project, path);
        return files.add(path);
    };
    std::vector<fs::path> paths;
    const double n = double(result.operations.size());
    for (std::size_t i = 0; i < result.operations.size(); ++i) {
        const ClProgram program = program_of(project, result.operations[i]);
        const std::string stem =
            file_stem(place_in_project(project, result, i) + 1, result.operations[i]->name);
        const Progress part = progress.part(double(i) / n, double(i + 1) / n, "Writing");
        for (const ProgramWriter& writer : program_writers()) {
            const std::vector<std::string> endings = writer.files(program);
            for (std::size_t k = 0; k < endings.size(); ++k) {
                paths.push_back(folder / (stem + endings[k] + writer.extension));
                writer.write(program, k, add(paths.back()), part);
            }
        }
    }
    for (const PostedFile& posted : posted_files) {
        paths.push_back(folder / posted.name);
        add(paths.back()).write(posted.program.text);
    }
    return paths;
}

} // namespace

std::vector<fs::path> write_plan(const Project& project, const PlanResult& result, const fs::path& folder,
                                 const Progress& progress, const std::vector<double>& air,
                                 const std::function<void()>& before) {
    result.check_programs();
    result.check_reach();
    const std::vector<PostedFile> posted_files = post_plan(project, result, progress.part(0, 0.5));
    const NewFolder made(folder);
    OutputSet files;
    std::vector<fs::path> paths =
        add_programs(project, result, folder, posted_files, files, progress.part(0.5, 1));
    paths.push_back(folder / report_file_name);
    keep_inputs(project, paths.back());
    files.add(paths.back()).write(report_json(project, result, air));
    progress.check();
    files.commit(before);
    return paths;
}

std::vector<fs::path> write_setups(std::span<const SetupPlan> setups, const fs::path& folder,
                                   const Progress& progress, const std::vector<std::vector<double>>& air,
                                   const std::function<void()>& before) {
    std::vector<std::vector<PostedFile>> posted(setups.size());
    const double n = double(setups.size());
    for (std::size_t i = 0; i < setups.size(); ++i) {
        if (!setups[i].asked) continue;
        setups[i].plan->check_programs();
        setups[i].plan->check_reach();
        posted[i] = post_plan(setups[i].project, *setups[i].plan,
                              progress.part(0.5 * double(i) / n, 0.5 * double(i + 1) / n));
    }
    const NewFolder made(folder);
    OutputSet files;
    std::vector<fs::path> paths;
    for (std::size_t i = 0; i < setups.size(); ++i) {
        if (!setups[i].asked) continue;
        const std::vector<fs::path> own =
            add_programs(setups[i].project, *setups[i].plan, folder, posted[i], files,
                         progress.part(0.5 + 0.5 * double(i) / n, 0.5 + 0.5 * double(i + 1) / n));
        paths.insert(paths.end(), own.begin(), own.end());
    }
    paths.push_back(folder / report_file_name);
    keep_inputs(setups.front().project, paths.back());
    files.add(paths.back()).write(setups_report_json(setups, air));
    progress.check();
    files.commit(before);
    return paths;
}

} // namespace facetmill
