#include "core/job/opened_program.h"

#include "core/job/posting.h"
#include "core/job/verification.h"

#include <algorithm>
#include <iterator>

namespace facetmill {

namespace {

/// The project's tool of the section's number where it has its cutter; else the cutter alone.
Tool shown_tool(const Project& project, const ClSection& section) {
    for (const Tool& t : project.tools)
        if (t.number == section.tool_number && same_shape(t.cutter(), section.cutter)) return t;
    Tool tool;
    tool.number = section.tool_number;
    tool.name = section.tool_name.empty() ? "T" + std::to_string(tool.number) : section.tool_name;
    tool.diameter = tool.shank_diameter = section.cutter.d;
    tool.corner_radius = section.cutter.r;
    tool.bottom_angle = section.cutter.alpha;
    tool.taper_angle = section.cutter.beta;
    tool.flute_length = section.cutter.h;
    tool.shank_length = 0;
    return tool;
}

/// Operations and tools of programs that were read, behind those there are.
void add_programs(OpenedProgram& opened, const Project& project, std::vector<VerifyProgram> programs,
                  const std::vector<std::shared_ptr<const ClSection>>& sections, const Progress& progress) {
    const Machine machine = project_machine(project);
    for (std::size_t k = 0; k < sections.size(); ++k) {
        auto operation = std::make_shared<OperationResult>();
        operation->name = programs[k].name;
        operation->program = *sections[k];
        operation->cl_points = sections[k]->motions.motions.size();
        opened.tools.push_back(shown_tool(project, *sections[k]));
        // Without a holder the length up to the spindle is not known.
        if (!opened.tools.back().holder.empty())
            operation->program.gauge_length = gauge_length(opened.tools.back());
        operation->totals = motion_totals(operation->program, machine, {}, progress);
        opened.operations.push_back(std::move(operation));
    }
    std::move(programs.begin(), programs.end(), std::back_inserter(opened.programs));
}

std::string name_of(const std::vector<std::filesystem::path>& files) {
    if (files.empty()) return {};
    const std::string first = files.front().filename().string();
    if (files.size() == 1) return first;
    return first + " and " + std::to_string(files.size() - 1) + " more";
}

} // namespace

OpenedProgram open_program(const Project& project, const std::vector<std::filesystem::path>& files,
                           const Progress& progress) {
    OpenedProgram opened;
    const double n = double(files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string file = files[i].filename().string();
        const Progress part = progress.part(double(i) / n, double(i + 1) / n, "Reading " + printable(file));
        ClFilePrograms cl = read_verify_programs(project, files[i], part.part(0, 0.7));
        add_programs(opened, project, std::move(cl.programs), cl.sections, part.part(0.7, 1.0));
        for (const std::string& line : cl.ignored)
            opened.ignored.push_back(printable(file, 400) + ": " + line);
        std::move(cl.remarks.begin(), cl.remarks.end(), std::back_inserter(opened.remarks));
    }
    opened.name = name_of(files);
    opened.files = files;
    progress.set(1.0);
    return opened;
}

OpenedProgram open_posted(const Project& project, const PreparedPart& part, const Post& post,
                          const std::vector<std::filesystem::path>& files, const Progress& progress) {
    OpenedProgram opened;
    NcFilePrograms read = read_posted(project, part, post, files, progress.part(0, 0.7));
    opened.remarks.push_back(posted_remark(post, read.blocks, read.seconds));
    add_programs(opened, project, std::move(read.programs), read.sections, progress.part(0.7, 1));
    opened.name = name_of(files);
    opened.files = files;
    progress.set(1.0);
    return opened;
}

} // namespace facetmill
