#include "ui/kept_reading.h"

#include "ui/document_keys.h"
#include "ui/setup_results.h"
#include "ui/text.h"
#include "ui/verification_run.h"

#include <algorithm>
#include <set>

namespace facetmill::ui {

std::shared_ptr<const OperationResult> KeptReading::read_plan(const std::string& name, const Setup& setup,
                                                              std::size_t operation,
                                                              const Progress& progress) {
    try {
        const auto bytes = folder.read(name, progress.part(0, 0.5));
        if (!bytes) throw Error(ErrorCode::syntax, name, "it is not as it was written", "plan again");
        auto result = result_from_bytes(*bytes, setup.view, operation, *setup.part, progress.part(0.5, 1));
        kept_as.emplace_back(result, name);
        return result;
    } catch (const Error&) {
        damaged << text(setup.view.operations[operation]->common().name);
        return nullptr;
    }
}

KeptReading::Setup KeptReading::read_setup(std::size_t k, Planner& planner, Planner* shown,
                                           const KeptNames& names, const Progress& progress) {
    Setup setup{view_of_setup(project, k), shown ? part : nullptr, {}, 0};
    const Project& view = setup.view;
    const std::size_t n = view.operations.size();
    setup.results.resize(n);
    if (const std::string source = stock_source(view); !source.empty())
        if (const auto bytes = folder.read(names.rest(view), progress)) {
            const auto stock = carried_from_bytes(*bytes, progress);
            stock->source = source;
            planner.carry(stock);
        }
    for (std::size_t i = 0; i < n; ++i) {
        const Progress reading = progress.part(double(i) / double(n), double(i + 1) / double(n));
        const std::string fingerprint = ui::fingerprint(view, i), name = names.plan(view, i);
        const bool current = folder.has(name);
        const auto old = current ? std::nullopt : folder.read(names.stale_plan(view, i), reading);
        if (!current && !old) {
            const auto failure = folder.read(names.failure(view, i), reading);
            if (failure) outcomes.push_back({ids[k][i], nullptr, text(*failure), fingerprint});
            continue;
        }
        if (!setup.part) {
            try {
                setup.part = planner.prepare(view, reading.part(0, 0.1));
            } catch (const Error&) {
                return setup; // what it begins with is not known: it is planned again
            }
        }
        const auto result = read_plan(current ? name : *old, setup, i, reading.part(0.1, 1));
        if (!result) continue;
        outcomes.push_back({ids[k][i], result, {}, current ? fingerprint : other_values});
        if (!current) continue;
        planner.adopt(result);
        if (shown) shown->adopt(result);
        setup.results[i] = result;
    }
    while (setup.complete < n
           && (setup.results[setup.complete] || view.operations[setup.complete]->common().off))
        ++setup.complete;
    return setup;
}

std::optional<KeptVerdict> KeptReading::read_verification(const std::string& name, const Progress& progress) {
    const auto bytes = folder.read(name, progress.part(0, 0.5));
    if (!bytes) return std::nullopt;
    KeptVerdict kept = verdict_from_bytes(*bytes, progress.part(0.5, 1));
    kept_as.emplace_back(kept.verification, name);
    return kept;
}

void KeptReading::read_verdict(const Setup& setup, const KeptNames& names, const Progress& progress) {
    const std::size_t k = chosen_setup(setup.view);
    if (!setup.part) return;
    for (std::size_t n = setup.complete; n > 0; --n) {
        const auto kept = read_verification(names.verdict(setup.view, n), progress.part(0, 0.5));
        if (!kept) continue;
        const auto outcome = outcome_to_be(setup.view, ids[k], setup.results, n);
        outcome->across = setup.part->box.diagonal();
        show_judged(*outcome, *kept, project.unit, progress.part(0.5, 1));
        verdicts.push_back(outcome);
        return;
    }
    read_stale_verdict(setup, names, progress);
}

void KeptReading::read_stale_verdict(const Setup& setup, const KeptNames& names, const Progress& progress) {
    const auto bytes = folder.read(names.stale_verdict(setup.view), progress);
    if (!bytes) return;
    const StaleVerdict stale = stale_verdict_from(*bytes);
    const auto kept = read_verification(stale.name, progress.part(0, 0.5));
    if (!kept) return;
    const std::vector<int>& own = ids[chosen_setup(setup.view)];
    const auto id = [&](std::int64_t place) {
        return place >= 0 && std::size_t(place) < own.size() ? own[std::size_t(place)] : -1;
    };
    auto outcome = std::make_shared<VerificationOutcome>();
    JudgedSetup judged;
    judged.place = chosen_setup(setup.view);
    for (const std::int64_t place : stale.operations)
        judged.ids.push_back(id(place));
    judged.fingerprints.assign(judged.ids.size(), other_values);
    judged.part_key = stale.part_key;
    outcome->setups.push_back(std::move(judged));
    for (const StaleVerdict::Program& p : stale.programs)
        outcome->programs.push_back({p.name, 0, id(p.operation), std::size_t(p.index)});
    outcome->last = text(stale.last);
    outcome->across = stale.across;
    outcome->limits = project.limits;
    show_judged(*outcome, *kept, project.unit, progress.part(0.5, 1));
    verdicts.push_back(outcome);
}

bool KeptReading::read_verdict(const std::vector<Setup>& setups, const std::vector<std::size_t>& together,
                               const KeptNames& names, const Progress& progress) {
    if (together.size() < 2) return false;
    std::vector<SetupPlan> chain;
    for (const std::size_t k : together) {
        const Setup& setup = setups[k];
        if (!setup.part || setup.complete < setup.results.size()) return false;
        chain.push_back({setup.view, plan_of(setup.view, setup.part, setup.results)});
    }
    const auto kept = read_verification(names.verdict(project, together), progress.part(0, 0.5));
    if (!kept) return false;
    const auto outcome = outcome_to_be(chain, ids);
    show_judged(*outcome, *kept, project.unit, progress.part(0.5, 1));
    verdicts.push_back(outcome);
    return true;
}

void KeptReading::run(Planner& planner, SetupPlanners& planners, FileContents& contents,
                      const Progress& progress) {
    const KeptNames names(folder, contents.texts(progress));
    const std::size_t count = setup_count(project), shown = chosen_setup(project);
    const auto n = double(count);
    std::vector<Setup> setups;
    for (std::size_t k = 0; k < count; ++k)
        setups.push_back(read_setup(k, planners.at(k), k == shown ? &planner : nullptr, names,
                                    progress.part(0.7 * double(k) / n, 0.7 * double(k + 1) / n)));
    if (outcomes.empty()) return;
    std::set<std::size_t> told;
    for (std::size_t k = 0; k < count; ++k) {
        const Progress reading = progress.part(0.7 + 0.3 * double(k) / n, 0.7 + 0.3 * double(k + 1) / n);
        if (told.contains(k)) continue;
        try {
            const std::vector<std::size_t> together = judged_together(project, k);
            if (read_verdict(setups, together, names, reading))
                told.insert(together.begin(), together.end());
            else
                read_verdict(setups[k], names, reading);
        } catch (const Error&) {
            // Whatever it is, it can be judged again.
        }
    }
}

} // namespace facetmill::ui
