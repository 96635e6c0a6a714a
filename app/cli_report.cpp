// facetmill-cli report: the setup sheet of a project, with pictures, tools, times and verification.
#include "app/cli_commands.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/base/strict_json.h"
#include "core/job/chain_verification.h"
#include "core/job/posting.h"
#include "core/job/setup_sheet.h"

#ifdef FACETMILL_HAS_PICTURES
#include "viz/render_picture.h"
#endif

#include <cstdio>

namespace facetmill::cli {

namespace {

/// Part in its stock, every program's path, and what is left; that not without a verification.
std::vector<SheetPicture> pictures(const Project& project, const PlanResult& plan,
                                   const std::shared_ptr<const Verification>& verification,
                                   const Progress& progress) {
    std::vector<SheetPicture> all;
#ifdef FACETMILL_HAS_PICTURES
    const double n = double(plan.operations.size() + 2);
    const auto add = [&](RenderRequest request, const std::string& caption) {
        request.width = 800;
        request.height = 560;
        const double done = double(all.size());
        const Progress part = progress.part(done / n, (done + 1) / n, "Drawing");
        all.push_back({caption, encode_png(render_picture(request, part))});
        part.check();
    };
    const auto request = [&](const PlanResult& of, std::vector<Layer> layers) {
        RenderRequest r;
        take_plan(r, project, of);
        r.layers = std::move(layers);
        return r;
    };
    add(request(plan, {Layer::part, Layer::stock}), "Part in its stock");
    for (const auto& operation : plan.operations) {
        PlanResult one = plan;
        one.operations = {operation};
        add(request(one, {Layer::part, Layer::strips, Layer::cl}),
            operation->name + ", tool " + std::to_string(operation->program.tool_number));
    }
    if (verification && verification->surface) {
        RenderRequest r = request(plan, {Layer::deviation, Layer::findings});
        r.verification = verification;
        add(std::move(r), "What is left on the part, by removal of material");
    }
#else
    (void)project, (void)plan, (void)verification, (void)progress;
#endif
    return all;
}

void print_report(const std::string& target, std::size_t programs, std::size_t drawn, Verdict verdict,
                  const std::string& findings, OutputFile& output, Session& session) {
    Json out;
    out["file"] = printable(target, 400);
    out["programs"] = programs;
    out["pictures"] = drawn;
    out["verdict"] = verdict_name(verdict);
    output.close_stream();
    session.print(pretty_json(out));
    output.commit();
    if (findings.empty()) return;
    session.say("not verified: " + findings);
    session.fail();
}

/// All setups: each has its own part of the sheet, and the verdict is on them all.
void report_setups(const Arguments& arguments, const Project& project, OutputFile& output, Session& session) {
    const Progress progress = session.progress();
    SetupPlanners planners;
    const std::vector<SetupPlan> setups =
        plan_all(planners, project, "", arguments, session, progress.part(0.0, 0.35));
    std::vector<JudgedChain> judged;
    const std::vector<std::span<const SetupPlan>> chains = stock_chains(setups);
    const double n = double(chains.size());
    for (const std::span<const SetupPlan> chain : chains) {
        std::vector<std::vector<VerifyProgram>> programs;
        std::vector<PostedPrograms> posted;
        for (const SetupPlan& setup : chain) {
            posted.push_back(programs_to_judge(setup.project, setup.plan, progress.part(0.35, 0.4)));
            programs.push_back(posted.back().programs);
        }
        const double from = 0.4 + 0.45 * double(judged.size()) / n;
        VerifySettings settings = chain_settings(chain);
        tell_work(settings, arguments, session);
        JudgedChain one = judge_chain(chain, programs, settings, progress.part(from, from + 0.45 / n));
        auto told = std::make_shared<Verification>(*one.result);
        for (auto p = posted.rbegin(); p != posted.rend(); ++p)
            tell_posted(*told, *p);
        one.result = std::move(told);
        judged.push_back(std::move(one));
    }
    std::vector<std::vector<SheetPicture>> drawn;
    std::size_t programs = 0, count = 0;
    for (const SetupPlan& setup : setups) {
        const double share = 0.15 / double(setups.size()), from = 0.85 + share * double(drawn.size());
        drawn.push_back(pictures(setup.project, *setup.plan, nullptr, progress.part(from, from + share)));
        programs += setup.plan->operations.size();
        count += drawn.back().size();
    }
    output.write(setup_sheet(judged, drawn));
    progress.check();
    print_report(arguments.value("-o"), programs, count, verdict_of(judged), findings_line(judged), output,
                 session);
}

void run_report(const Arguments& arguments, Session& session) {
    use_threads(arguments);
    const std::string file = arguments.operand(0);
    const Project project = asked_project(arguments);
    check_all_posting(project);
    const std::string target = arguments.value("-o");
    keep_inputs(project, target);
    OutputFile output(target); // before the work: a place that cannot be written to is said at once
    if (setup_count(project) > 1) return report_setups(arguments, project, output, session);
    const Progress progress = session.progress();
    Planner planner;
    const auto plan = plan_project(planner, project, "", arguments, session, progress.part(0.0, 0.35));
    // Where there is a control, what it will run is judged.
    const PostedPrograms posted = programs_to_judge(project, plan, progress.part(0.35, 0.4));
    const auto& programs = posted.programs;
    VerifySettings settings = verify_settings(project, plan.get());
    tell_work(settings, arguments, session);
    Verification result =
        verify(*plan->part->mesh, plan->stock, programs, settings, progress.part(0.4, 0.85));
    tell_posted(result, posted);
    const auto verification = std::make_shared<const Verification>(std::move(result));
    const auto drawn = pictures(project, *plan, verification, progress.part(0.85, 1.0));
    output.write(setup_sheet(project, *plan, programs, *verification, drawn));
    progress.check();
    print_report(target, plan->operations.size(), drawn.size(), verification->verdict(),
                 findings_line(project, programs, *verification), output, session);
}

} // namespace

Command report_command() {
    return {
        .name = "report",
        .operands = {"PROJECT"},
        .summary = "Writes the setup sheet: pictures, stock, tools, programs, times, verification (HTML).",
        .help = "Plans and verifies the project first. The file is complete in itself and prints on paper. "
                "A project\n"
                "that is not verified has its sheet too, which says so first; the exit status is 1 then. Of "
                "several\n"
                "setups each has its part of the sheet, and they are judged as one.",
        .options = {set_option(),
                    threads_option(),
                    large_option(),
                    {.name = "-o", .value = "FILE.html", .help = "the file to write", .required = true}},
        .run = run_report,
        .draws = true};
}

} // namespace facetmill::cli
