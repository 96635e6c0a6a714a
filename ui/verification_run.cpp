#include "ui/verification_run.h"

#include "core/job/chain_verification.h"
#include "core/job/posting.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "ui/text.h"

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr std::size_t max_samples = 400'000; ///< points of the deviation: what a processor can still draw

/// Leaves a verification before it cuts.
struct NotBegun {
    std::string why;
};

void add_judged_programs(VerificationOutcome& outcome, std::size_t setup, int id,
                         const std::shared_ptr<const OperationResult>& result) {
    std::size_t index = 0;
    for (const JudgedProgram& p : outcome.programs)
        if (p.setup == setup) ++index;
    for (const auto& program : programs_of(result))
        outcome.programs.push_back({program->name, setup, id, index++});
}

/// How many operations there are up to one.
std::size_t operations_to(const Document& document, std::optional<std::size_t> up_to) {
    return up_to ? std::min(*up_to + 1, document.operation_count()) : document.operation_count();
}

JudgedSetup judged_setup(const Project& view, const std::vector<int>& ids) {
    JudgedSetup setup;
    setup.place = chosen_setup(view);
    setup.ids = ids;
    for (std::size_t i = 0; i < ids.size(); ++i)
        setup.fingerprints.push_back(Document::fingerprint(view, i));
    setup.part_key = Document::part_key(view);
    setup.posting_key = Document::posting_key(view);
    return setup;
}

} // namespace

bool can_judge(const Document& document, std::optional<std::size_t> up_to) {
    if (!document.part_is_current() || !document.has_stock()) return false;
    return document.program() ? !up_to : document.all_planned(up_to);
}

std::shared_ptr<const PlanResult> plan_as_it_stands(const Document& document,
                                                    std::optional<std::size_t> up_to) {
    auto plan = std::make_shared<PlanResult>();
    plan->part = document.part();
    plan->stock = stock_solid(document.project().stock, *document.part());
    if (document.program()) {
        plan->operations = document.program()->operations;
        return plan;
    }
    for (std::size_t i = 0; i < operations_to(document, up_to); ++i)
        if (const auto result = document.result(i))
            for (const auto& program : programs_of(result))
                plan->operations.push_back(program);
    return plan;
}

std::vector<VerifyProgram> programs_as_they_stand(const Document& document,
                                                  const std::shared_ptr<const PlanResult>& plan) {
    return document.program() ? document.program()->programs : verify_programs(document.project(), plan);
}

std::shared_ptr<VerificationOutcome> outcome_to_be(const Document& document, const PlanResult& plan,
                                                   std::optional<std::size_t> up_to) {
    if (!document.program()) {
        std::vector<int> ids;
        std::vector<std::shared_ptr<const OperationResult>> results;
        for (std::size_t i = 0; i < document.operation_count(); ++i) {
            ids.push_back(document.operation_id(i));
            results.push_back(document.result(i));
        }
        return outcome_to_be(document.project(), ids, results, operations_to(document, up_to));
    }
    auto outcome = std::make_shared<VerificationOutcome>();
    outcome->limits = document.project().limits;
    outcome->program = document.program();
    for (const auto& program : plan.operations)
        outcome->programs.push_back({program->name, 0, 0, outcome->programs.size()});
    outcome->setups.push_back(judged_setup(document.project(), {}));
    return outcome;
}

std::shared_ptr<VerificationOutcome>
outcome_to_be(const Project& view, const std::vector<int>& ids,
              const std::vector<std::shared_ptr<const OperationResult>>& results, std::size_t operations) {
    auto outcome = std::make_shared<VerificationOutcome>();
    outcome->limits = view.limits;
    for (std::size_t i = 0; i < operations; ++i)
        if (results[i]) add_judged_programs(*outcome, 0, ids[i], results[i]);
    if (operations > 0 && operations < ids.size())
        outcome->last = text(view.operations[operations - 1]->common().name);
    outcome->setups.push_back(
        judged_setup(view, std::vector<int>(ids.begin(), ids.begin() + std::ptrdiff_t(operations))));
    return outcome;
}

std::shared_ptr<VerificationOutcome> outcome_to_be(std::span<const SetupPlan> chain,
                                                   const std::vector<std::vector<int>>& ids) {
    auto outcome = std::make_shared<VerificationOutcome>();
    outcome->chain.assign(chain.begin(), chain.end());
    outcome->limits = chain.front().project.limits;
    outcome->across = chain.front().plan->part->box.diagonal();
    for (const SetupPlan& setup : chain) {
        const std::vector<int>& own = ids[chosen_setup(setup.project)];
        outcome->setups.push_back(judged_setup(setup.project, own));
        outcome->setups.back().frame = frame_between(chain.front().project, setup.project);
        for (std::size_t i = 0; i < own.size(); ++i) {
            const std::string& name = setup.project.operations[i]->common().name;
            for (const auto& result : setup.plan->operations)
                if (result->name == name)
                    add_judged_programs(*outcome, outcome->setups.size() - 1, own[i], result);
        }
    }
    return outcome;
}

void show_judged(VerificationOutcome& outcome, const KeptVerdict& judged, LengthUnit unit,
                 const Progress& progress) {
    outcome.posted_blocks = judged.posted_blocks;
    outcome.verification = judged.verification;
    const DeviationDisplayPtr display =
        prepare_deviation_display(judged.verification->surface, default_scale(*judged.verification, unit),
                                  progress.part(0, 1, "Preparing the view"));
    for (JudgedSetup& setup : outcome.setups)
        setup.display =
            setup.frame.is_identity() ? display : moved_display(*display, setup.frame.turn, setup.frame.move);
}

void judge(VerificationOutcome& outcome, const Project& project,
           const std::shared_ptr<const PlanResult>& plan, const std::vector<VerifyProgram>& programs,
           bool anyway, const Progress& progress) try {
    // A program from a file stands for itself.
    PostedPrograms posted = outcome.program ? PostedPrograms{.programs = programs}
                                            : programs_to_judge(project, plan, progress.part(0, 0.1));
    outcome.across = plan->part->box.diagonal();
    stand_fixtures(posted.programs, *plan->part);
    VerifySettings settings = verify_settings(project, outcome.program ? nullptr : plan.get());
    settings.max_samples = max_samples;
    if (!anyway) settings.cannot_verify = [](const std::string& why) { throw NotBegun{why}; };
    auto result = std::make_shared<Verification>(facetmill::verify(
        *plan->part->mesh, plan->stock, posted.programs, settings, progress.part(0.1, 0.97, "Verifying")));
    name_planned_motions(*result, posted);
    tell_posted(*result, posted);
    show_judged(outcome, {posted.blocks, std::move(result)}, project.unit, progress.part(0.97, 1));
} catch (const NotBegun& hopeless) {
    outcome.not_begun = hopeless.why;
}

std::shared_ptr<const VerificationOutcome> judge_setups(std::span<const SetupPlan> chain,
                                                        const std::vector<std::vector<int>>& ids,
                                                        const Progress& progress) {
    const std::shared_ptr<VerificationOutcome> outcome = outcome_to_be(chain, ids);
    VerifySettings settings = chain_settings(outcome->chain);
    settings.max_samples = max_samples;
    const JudgedChain judged =
        judge_posted_chain(outcome->chain, settings, progress.part(0, 0.95, "Verifying"));
    show_judged(*outcome, {judged.posted_blocks, judged.result}, chain.front().project.unit,
                progress.part(0.95, 1));
    return outcome;
}

} // namespace facetmill::ui
