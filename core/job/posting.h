// The programs that a project's post makes of a plan, and the way back from such a program to the judge.
#pragma once

#include "core/base/progress.h"
#include "core/job/planner.h"
#include "core/job/verification.h"
#include "core/output/post/post_writer.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

/// A post by its name, or from its file: relative to the project file, or absolute. Throws Error(
/// missing_reference, files, load_post) that names `post` or the file.
Post project_post(const Project& project, const std::string& name);

/// What can be told before anything is planned: a post that is not there, work coordinates, program and tool
/// numbers that the control does not have, tools that lean where it has three axes, feeds above the
/// machine's, one program with several tools for a control that cannot change them. Throws
/// Error(out_of_range) and what project_post does.
void check_posting(const Project& project);

/// The same for all setups; of several within "setup 'Bottom'". Besides, programs of two setups must not have
/// one number on one control, which would write one over the other. Throws Error(out_of_range) likewise.
void check_all_posting(const Project& project);

/// What a project's programs are posted for, but for the tolerance, which is each program's own. The work
/// zero stands for the part's origin: sections are moved by minus work_zero.
PostSetup post_setup(const Project& project, const PlanResult& result);

/// A program for the control.
struct PostedFile {
    std::string name;                  ///< "01-Finish.ngc"
    std::vector<std::size_t> programs; ///< of the plan, in the order of machining
    PostedProgram program;
};

/// What the project's post makes of a plan: a program for each, or one for all; none without a post. Throws
/// what post_program does, within the name of the file.
std::vector<PostedFile> post_plan(const Project& project, const PlanResult& result, const Progress& progress);

/// Posted programs as programs to verify, one for each tool in each file.
struct NcFilePrograms {
    std::vector<VerifyProgram> programs;
    std::vector<std::shared_ptr<const ClSection>> sections; ///< one for each program
    std::size_t blocks = 0;
    double seconds = 0; ///< see NcProgram
};
/// Tools, work coordinates, machine and the part's place are the project's. Throws what read_nc does, and
/// files.
NcFilePrograms read_posted(const Project& project, const PreparedPart& part, const Post& post,
                           const std::filesystem::path& path, const Progress& progress);
/// Files that run one after the other.
NcFilePrograms read_posted(const Project& project, const PreparedPart& part, const Post& post,
                           const std::vector<std::filesystem::path>& paths, const Progress& progress);
/// The same from memory.
NcFilePrograms parse_posted(const Project& project, const PreparedPart& part, const Post& post,
                            std::string_view text, const std::string& name, const Progress& progress);

/// A sentence of the verdict: "The posted program, 59414 blocks, 1 h 2 min, was read back for 'LinuxCNC'."
std::string posted_remark(const Post& post, std::size_t blocks, double seconds);

/// What the project's post makes of a plan, read back: a program for each of the plan's.
struct PostedPrograms {
    std::vector<VerifyProgram> programs;
    /// For each motion of each the planned motion that it belongs to.
    std::vector<std::vector<std::uint32_t>> planned;
    std::size_t blocks = 0;
    std::string remark;
};
/// What a verdict on a plan is about: what its control will run, or without a control the plan itself, with
/// no remark and no names for motions. Throws what post_plan and read_nc do.
PostedPrograms programs_to_judge(const Project& project, const std::shared_ptr<const PlanResult>& plan,
                                 const Progress& progress);
/// For a project with a control. Throws as that does.
PostedPrograms posted_programs(const Project& project, const std::shared_ptr<const PlanResult>& plan,
                               const Progress& progress);
/// Says in the verdict that it is about posted programs; nothing where it is not.
void tell_posted(Verification& verification, const PostedPrograms& posted);
/// Findings name motions of the plan instead of those of the programs that were posted.
void name_planned_motions(Verification& verification, const PostedPrograms& posted);

} // namespace facetmill
