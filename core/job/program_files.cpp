#include "core/job/program_files.h"

#include "core/base/file.h"
#include "core/job/new_folder.h"
#include "core/job/report.h"
#include "core/output/apt.h"
#include "core/output/turning_table.h"
#include "core/strategy/lathe/lathe.h"

namespace facetmill {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_name = 60;

std::size_t place_in_project(const Project& project, const PlanResult& result, std::size_t program) {
    const std::string& owner = result.operations[result.owner(program)]->name;
    std::size_t place = 0;
    while (place < project.operations.size() && project.operations[place]->common().name != owner)
        ++place;
    return place;
}

} // namespace

std::string program_file_name(std::size_t place, const std::string& operation_name) {
    std::string name;
    for (char ch : operation_name) {
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
    if (name.empty()) name = "operation";
    const std::string number = std::to_string(place);
    return (number.size() < 2 ? "0" + number : number) + "-" + name + ".apt";
}

const Operation& operation_of(const Project& project, const PlanResult& result, std::size_t program) {
    return *project.operations.at(place_in_project(project, result, program));
}

std::string program_file_name(const Project& project, const PlanResult& result, std::size_t program) {
    return program_file_name(place_in_project(project, result, program) + 1,
                             result.operations[program]->name);
}

std::string turning_table_name(std::size_t place, const std::string& operation_name, int pass) {
    std::string name = program_file_name(place, operation_name);
    name.resize(name.size() - 4);
    if (pass >= 0) name += (pass < 9 ? "-pass-0" : "-pass-") + std::to_string(pass + 1);
    return name + ".txt";
}

std::vector<fs::path> write_plan(const Project& project, const PlanResult& result, const fs::path& folder,
                                 const Progress& progress) {
    if (result.operations.empty())
        throw Error(ErrorCode::empty_result, "plan", "no operation was planned", "plan at least one");
    const NewFolder made(folder);
    OutputSet files;
    std::vector<fs::path> paths;
    const double n = double(result.operations.size());
    for (std::size_t i = 0; i < result.operations.size(); ++i) {
        const OperationResult& o = *result.operations[i];
        const std::size_t place = place_in_project(project, result, i);
        paths.push_back(folder / program_file_name(project, result, i));
        const Progress part = progress.part(double(i) / n, double(i + 1) / n, "Writing");
        write_apt(o.program, files.add(paths.back()), part);
        if (const auto* turned = o.path.as<TurnedPath>()) {
            const LatheCommon* turning =
                place < project.operations.size() ? project.operations[place]->turning() : nullptr;
            const bool modulo = turning && turning->winding == LatheCommon::Winding::modulo;
            for (const TurningTableRange& range : turning_table_ranges(o.program, o.path)) {
                paths.push_back(folder / turning_table_name(place + 1, o.name, range.pass));
                write_turning_table(o.program, *turned, range,
                                    modulo ? AngleWinding::modulo : AngleWinding::unwound,
                                    files.add(paths.back()), part);
            }
        }
    }
    paths.push_back(folder / "report.json");
    files.add(paths.back()).write(report_json(project, result));
    progress.check();
    files.commit();
    return paths;
}

} // namespace facetmill
