#include "core/job/posting.h"

#include "core/base/file.h"
#include "core/job/asked_operations.h"
#include "core/job/program_files.h"
#include "core/job/work_zero.h"
#include "core/output/motion_time.h"
#include "core/output/post/nc_reader.h"
#include "core/strategy/lathe/lathe.h"

#include <algorithm>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

/// Of an operation's chord tolerance, what the way between two blocks may use up, and what a control may
/// round off; and how far an arc may be from the motions that it stands for.
constexpr double post_chord_share = 0.25, arc_chord_share = 0.5;

/// The line that the project's part turns about; none where nothing turns it.
std::optional<TurningAxis> project_turning(const Project& project, const PreparedPart& part) {
    for (std::size_t i = 0; i < project.operations.size(); ++i)
        if (const LatheCommon* lathe = project.operations[i]->turning();
            lathe && !project.operations[i]->common().off)
            return LatheFrame(*lathe, preview_context(project, i, part, {})).axis();
    return std::nullopt;
}

/// One place for all programs of a project.
Vec3 setup_origin(const Project& project, const PreparedPart& part, const Machine& machine) {
    ClSection section;
    section.part_box = part.box;
    section.motions.turning = project_turning(project, part);
    return program_part_origin(section, machine);
}

constexpr std::size_t file_end = std::size_t(-1);
/// Lines [first, end) of a file.
struct LineRange {
    std::size_t first = 1, end = file_end;
};

/// The motions of some lines of a file, whatever tools it was read as.
void take_lines(const std::vector<VerifyProgram>& read, const LineRange& range, VerifyProgram& into) {
    auto motions = std::make_shared<ToolMotions>();
    into.lines.clear();
    into.feeds.clear();
    auto joints = std::make_shared<std::vector<Joints>>();
    bool told = true; // how the joints stand
    for (const VerifyProgram& p : read) {
        const auto& all = p.motions->motions;
        const auto take = [&](std::size_t m, MotionKind kind, std::uint32_t line) {
            motions->motions.push_back({kind, all[m].to});
            into.lines.push_back(line);
            into.feeds.push_back(p.feed_of(m));
            if (told) joints->push_back((*p.joints)[m]);
        };
        for (std::size_t m = 0; m < all.size(); ++m) {
            if (p.lines[m] < range.first || p.lines[m] >= range.end) continue;
            told = told && p.joints;
            if (motions->motions.empty()) {
                *motions = *p.motions;
                motions->motions.clear();
                // From where the operation before ended with the same tool.
                if (m > 0) take(m - 1, MotionKind::rapid, p.lines[m]);
            }
            take(m, all[m].kind, p.lines[m]);
        }
    }
    into.joints = told ? std::move(joints) : nullptr;
    into.motions = std::move(motions);
}

double distance_to_motion(const Vec3& p, const ToolMotions& motions, std::size_t i) {
    const Vec3 &to = motions.motions[i].to.tip, &from = i > 0 ? motions.motions[i - 1].to.tip : to;
    const Vec3 step = to - from, off = p - from;
    const double square = step.squaredNorm();
    const double t = square > 0 ? std::clamp(off.dot(step) / square, 0.0, 1.0) : 0;
    return (off - t * step).norm();
}

/// For each posted motion the planned one that it is a piece of: those that print nothing, or are told as an
/// arc together, are passed over. Where the tool goes another way, the one before.
std::vector<std::uint32_t> planned_motions(const ToolMotions& posted, const ToolMotions& planned,
                                           double chord) {
    const double near = 0.01 + arc_chord_share * chord; // mm; what digits, divisions and arcs may do
    constexpr double digits = 0.002;
    constexpr std::size_t looked_ahead = 64;
    std::vector<std::uint32_t> all;
    all.reserve(posted.motions.size());
    std::size_t at = 0;
    for (const Motion& m : posted.motions) {
        const std::size_t end = std::min(at + looked_ahead, planned.motions.size());
        std::size_t first = at;
        while (first < end && !(distance_to_motion(m.to.tip, planned, first) < near))
            ++first;
        double least = near;
        for (std::size_t k = first; k < end; ++k) {
            const double off = distance_to_motion(m.to.tip, planned, k);
            if (!(off < near)) break;
            least = std::min(least, off);
        }
        // A place between two motions ends the first of them.
        while (first < end && distance_to_motion(m.to.tip, planned, first) > least + digits)
            ++first;
        if (first < end) at = first;
        all.push_back(std::uint32_t(at));
    }
    return all;
}

PostedFile post_programs(const Project& project, const PlanResult& result, const Post& post, PostSetup setup,
                         const std::string& name, std::vector<std::size_t> which, const Progress& progress) {
    const Vec3 zero = work_zero(project.programs, result.part->box, result.stock.box);
    ClProgram program;
    program.part_name = fs::path(project.part.file).stem().string();
    program.unit = project.unit;
    double chord = infinity;
    for (const std::size_t i : which) {
        program.sections.emplace_back(result.operations[i], &result.operations[i]->program);
        if (zero != Vec3::Zero())
            program.sections.back() =
                std::make_shared<const ClSection>(moved_section(*program.sections.back(), -zero));
        if (const double c = result.operations[i]->path.chord_tolerance; c > 0) chord = std::min(chord, c);
    }
    if (chord < infinity) {
        setup.tip_tolerance = post_chord_share * chord;
        setup.arc_bulge = arc_chord_share * chord;
    }
    try {
        return {name, std::move(which), post_program(program, post, setup, progress)};
    } catch (const Error& e) {
        throw e.within(name);
    }
}

/// The first and the last number of a setup's programs; a rework tool has one of its own.
std::pair<long, long> program_numbers(const Setup& setup) {
    long count = 1;
    if (setup.programs.files == ProgramSpec::Files::each) {
        count = 0;
        for (const Operation* o : operations_on(setup))
            count += o->rework() ? 2 : 1;
    }
    return {setup.programs.number, setup.programs.number + count - 1};
}

} // namespace

PostSetup post_setup(const Project& project, const PlanResult& result) {
    PostSetup setup;
    setup.machine = project_machine(project);
    const Vec3 zero = work_zero(project.programs, result.part->box, result.stock.box);
    setup.part_origin = setup_origin(project, *result.part, setup.machine) + zero;
    setup.keep_clear = result.part->box;
    if (!result.stock.box.empty()) setup.keep_clear.add(result.stock.box);
    setup.keep_clear.lo -= zero;
    setup.keep_clear.hi -= zero;
    setup.wcs = project.programs.wcs;
    setup.program_number = project.programs.number;
    setup.arcs = project.programs.arcs;
    return setup;
}

Post project_post(const Project& project, const std::string& name) {
    if (!is_post_file(name)) return find_post(name);
    const fs::path file(name);
    return load_post(file.is_absolute() ? file : project.path.parent_path() / file);
}

void check_posting(const Project& project) {
    const ProgramSpec& spec = project.programs;
    if (spec.post.empty()) return;
    const Post post = project_post(project, spec.post);
    check_wcs(post, spec.wcs);
    const bool one = spec.files == ProgramSpec::Files::one;
    check_program_number(post, program_numbers(project).second);
    const Machine machine = project_machine(project);
    std::optional<long> only;
    for (const Operation* operation : operations_on(project)) {
        const OperationCommon& common = operation->common();
        if (!operation->three_axis()) check_inclined(post, common.name);
        if (operation->turning()) check_turning(post, common.name);
        check_feed(post, machine, common.feed, common.name);
        const std::vector<long> numbers = tools_of(*operation);
        for (const long number : numbers)
            check_tool_number(post, number, common.name);
        if (one && !post.changes_tools && only && *only != numbers.front())
            throw Error(ErrorCode::out_of_range, "programs",
                        "'" + printable(post.label)
                            + "' cannot change tools, and the operations have several",
                        "write one program for each operation: \"programs\": \"each\"");
        only = numbers.front();
    }
}

void check_all_posting(const Project& project) {
    const std::size_t n = setup_count(project);
    if (n == 1) return check_posting(project);
    for (std::size_t i = 0; i < n; ++i) {
        const Project view = view_of_setup(project, i);
        const std::string place = "setup '" + printable(view.name) + "'";
        try {
            check_posting(view);
        } catch (const Error& e) {
            throw e.within(place);
        }
        if (view.programs.post.empty() || !project_post(view, view.programs.post).tells("program")) continue;
        const auto [first, last] = program_numbers(view);
        for (const Setup& earlier : view.before) {
            const auto [from, to] = program_numbers(earlier);
            if (earlier.programs.post != view.programs.post || first > to || from > last) continue;
            throw Error(ErrorCode::out_of_range, place + ": program_number",
                        "its programs have the numbers " + std::to_string(first) + " to "
                            + std::to_string(last) + ", and those of setup '" + printable(earlier.name) + "' "
                            + std::to_string(from) + " to " + std::to_string(to),
                        "give numbers that no other setup has, from " + std::to_string(to + 1));
        }
    }
}

std::vector<PostedFile> post_plan(const Project& project, const PlanResult& result,
                                  const Progress& progress) {
    if (project.programs.post.empty()) return {};
    const Post post = project_post(project, project.programs.post);
    PostSetup setup = post_setup(project, result);
    std::vector<PostedFile> files;
    const std::size_t n = result.operations.size();
    if (project.programs.files == ProgramSpec::Files::one) {
        std::vector<std::size_t> all(n);
        for (std::size_t i = 0; i < n; ++i)
            all[i] = i;
        const std::string name = joined_program_name(project, post.extension);
        files.push_back(post_programs(project, result, post, setup, name, all, progress));
        return files;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const std::string name = posted_file_name(project, result, i, post.extension);
        files.push_back(post_programs(project, result, post, setup, name, {i},
                                      progress.part(double(i) / double(n), double(i + 1) / double(n))));
        ++setup.program_number;
    }
    return files;
}

NcFilePrograms parse_posted(const Project& project, const PreparedPart& part, const Post& post,
                            std::string_view text, const std::string& name, const Progress& progress) {
    NcSetup setup;
    setup.machine = project_machine(project);
    const std::optional<TurningAxis> turning = project_turning(project, part);
    const Vec3 zero = work_zero(project, part);
    setup.turning = turning;
    if (setup.turning) setup.turning->point -= zero;
    setup.part_origin = setup_origin(project, part, setup.machine) + zero;
    setup.wcs = project.programs.wcs;
    for (const Tool& t : project.tools)
        setup.tools[t.number] = {t.name, t.cutter(), gauge_length(t)};
    NcProgram read = read_nc(text, name, post, setup, progress);
    NcFilePrograms result;
    result.blocks = read.blocks;
    result.seconds = read.seconds;
    const std::string file = fs::path(name).filename().string();
    const auto machine = std::make_shared<const Machine>(setup.machine);
    for (std::size_t i = 0; i < read.sections.size(); ++i) {
        const auto section = zero == Vec3::Zero()
                                 ? read.sections[i]
                                 : std::make_shared<const ClSection>(moved_section(*read.sections[i], zero));
        const auto tool = std::find_if(project.tools.begin(), project.tools.end(),
                                       [&](const Tool& t) { return t.number == section->tool_number; });
        std::string called =
            read.sections.size() == 1 ? file : file + ", tool " + std::to_string(section->tool_number);
        VerifyProgram program{
            std::move(called), VerifyTool(*tool), {section, &section->motions}, turning, {}, machine};
        program.lines = std::move(read.lines[i]);
        set_feeds(program, *section);
        if (!read.joints[i].empty())
            program.joints = std::make_shared<const std::vector<Joints>>(std::move(read.joints[i]));
        result.programs.push_back(std::move(program));
        result.sections.push_back(section);
    }
    stand_fixtures(result.programs, part);
    return result;
}

std::string posted_remark(const Post& post, std::size_t blocks, double seconds) {
    return "The posted program, " + std::to_string(blocks) + " blocks, " + duration_text(seconds)
           + ", was read back for '" + post.label + "'.";
}

PostedPrograms posted_programs(const Project& project, const std::shared_ptr<const PlanResult>& plan,
                               const Progress& progress) {
    const Post post = project_post(project, project.programs.post);
    const std::vector<PostedFile> files = post_plan(project, *plan, progress.part(0, 0.6, "Posting"));
    PostedPrograms result;
    result.programs = verify_programs(project, plan);
    result.planned.resize(result.programs.size());
    double seconds = 0;
    const double n = double(files.size());
    for (std::size_t f = 0; f < files.size(); ++f) {
        const PostedFile& file = files[f];
        const NcFilePrograms read =
            parse_posted(project, *plan->part, post, file.program.text, file.name,
                         progress.part(0.6 + 0.4 * double(f) / n, 0.6 + 0.4 * double(f + 1) / n, "Reading"));
        result.blocks += read.blocks;
        seconds += read.seconds;
        const auto& first = file.program.first_lines;
        for (std::size_t k = 0; k < file.programs.size(); ++k) {
            const std::size_t i = file.programs[k];
            const LineRange range{first[k], k + 1 < first.size() ? first[k + 1] : file_end};
            take_lines(read.programs, range, result.programs[i]);
            result.planned[i] =
                planned_motions(*result.programs[i].motions, plan->operations[i]->program.motions,
                                plan->operations[i]->path.chord_tolerance);
        }
    }
    result.remark = posted_remark(post, result.blocks, seconds);
    return result;
}

PostedPrograms programs_to_judge(const Project& project, const std::shared_ptr<const PlanResult>& plan,
                                 const Progress& progress) {
    if (!project.programs.post.empty()) return posted_programs(project, plan, progress);
    PostedPrograms planned;
    planned.programs = verify_programs(project, plan);
    return planned;
}

void tell_posted(Verification& verification, const PostedPrograms& posted) {
    if (!posted.remark.empty()) verification.remarks.insert(verification.remarks.begin(), posted.remark);
}

void name_planned_motions(Verification& verification, const PostedPrograms& posted) {
    for (std::size_t p = 0; p < verification.program_loads.size() && p < posted.planned.size(); ++p)
        if (std::size_t& at = verification.program_loads[p].peak_motion; at < posted.planned[p].size())
            at = posted.planned[p][at];
    const auto rename = [&](MotionPlace& at) {
        if (!at.known() || at.program >= posted.planned.size()) return;
        if (const auto& planned = posted.planned[at.program]; at.motion < planned.size())
            at.motion = planned[at.motion];
    };
    for (DeviationExtreme& e : verification.gouges)
        rename(e.by);
    for (DeviationExtreme& e : verification.excess)
        rename(e.by);
    for (Collision& c : verification.collisions)
        rename(c.at);
}

NcFilePrograms read_posted(const Project& project, const PreparedPart& part, const Post& post,
                           const fs::path& path, const Progress& progress) {
    const InputFile file(path);
    return parse_posted(project, part, post, file.bytes(), printable(path.string(), 400), progress);
}

NcFilePrograms read_posted(const Project& project, const PreparedPart& part, const Post& post,
                           const std::vector<fs::path>& paths, const Progress& progress) {
    NcFilePrograms all;
    const double n = double(paths.size());
    for (std::size_t i = 0; i < paths.size(); ++i) {
        NcFilePrograms one = read_posted(project, part, post, paths[i],
                                         progress.part(double(i) / n, double(i + 1) / n, "Reading"));
        std::move(one.programs.begin(), one.programs.end(), std::back_inserter(all.programs));
        std::move(one.sections.begin(), one.sections.end(), std::back_inserter(all.sections));
        all.blocks += one.blocks;
        all.seconds += one.seconds;
    }
    return all;
}

} // namespace facetmill
