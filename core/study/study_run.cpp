#include "core/study/study_run.h"

#include "core/base/text.h"

#include <algorithm>

namespace facetmill {

namespace {

/// What was lost counts as a look that came to nothing, in this run alone.
RungResult lost_result(const std::string& why) {
    RungResult result;
    result.why = "lost: " + why;
    return result;
}

void read_states(const StudyFolder& folder, StudyOutcome& outcome) {
    outcome.states.assign(outcome.candidates.size(), {});
    for (std::size_t i = 0; i < outcome.candidates.size(); ++i) {
        CandidateState& state = outcome.states[i];
        state.usable = outcome.candidates[i].usable() && outcome.same[i] == i;
        if (!state.usable) continue;
        for (const Rung rung : all_rungs)
            state.rungs[std::size_t(rung)] = folder.result(outcome.keys[i], rung);
    }
}

/// Decides again and again, while what is missing is lost.
void decide_without_lost(const StudyFolder& folder, StudyOutcome& outcome) {
    for (;;) {
        outcome.decision = decide(folder.study(), outcome.states);
        bool any = false;
        for (const StudyTask& task : outcome.decision.missing) {
            const auto lost = outcome.lost.find(outcome.keys[task.candidate]);
            if (lost == outcome.lost.end()) continue;
            outcome.states[task.candidate].rungs[std::size_t(task.rung)] = lost_result(lost->second);
            any = true;
        }
        if (!any) break;
    }
    outcome.states = outcome.decision.seen;
}

} // namespace

detail::FileLock lock_study(const StudyFolder& folder) {
    detail::FileLock lock(folder.path() / "lock", detail::FileLock::Open::or_make);
    if (!lock)
        throw Error(ErrorCode::unwritable, printable(folder.path().string(), 400),
                    "another run works on this study", "wait for it, or end it");
    return lock;
}

StudyOutcome look_at_study(const StudyFolder& folder, const std::map<std::string, std::string>& lost,
                           const Progress& progress) {
    StudyOutcome outcome;
    outcome.lost = lost;
    outcome.candidates = study_candidates(folder.study(), folder.project(), progress.part(0, 0.5));
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < outcome.candidates.size(); ++i) {
        progress.set(0.5 + 0.5 * double(i) / double(outcome.candidates.size()));
        const Candidate& c = outcome.candidates[i];
        outcome.keys.push_back(c.usable() ? folder.key_of(*c.project, folder.candidate_file(*c.project))
                                          : "");
        outcome.same.push_back(c.usable() ? first.emplace(outcome.keys[i], i).first->second : i);
    }
    read_states(folder, outcome);
    decide_without_lost(folder, outcome);
    return outcome;
}

std::vector<StudyWork> missing_work(const StudyFolder& folder, const StudyOutcome& outcome) {
    std::vector<StudyWork> work;
    for (const StudyTask& task : outcome.decision.missing) {
        const std::string& key = outcome.keys[task.candidate];
        folder.write_candidate(key, folder.candidate_file(*outcome.candidates[task.candidate].project));
        work.push_back({key, task.rung});
    }
    return work;
}

StudyOutcome run_study(const StudyFolder& folder, const StudyEngine& engine, const Progress& progress) {
    const detail::FileLock lock = lock_study(folder);
    StudyOutcome outcome = look_at_study(folder, {}, progress.part(0, 0.02));
    double done = 0.02;
    while (!outcome.decision.missing.empty()) {
        const std::vector<StudyWork> work = missing_work(folder, outcome);
        const double to = done + 0.5 * (1 - done); // how many rounds there will be is not known
        const auto lost = engine(folder, work, progress.part(done, to));
        done = to;
        for (const auto& [key, why] : lost)
            outcome.lost[key] = why;
        read_states(folder, outcome);
        // Whoever was to work on it said neither what it came to nor why not.
        for (const StudyWork& w : work)
            if (!folder.result(w.key, w.rung)) outcome.lost.emplace(w.key, "there is no result");
        decide_without_lost(folder, outcome);
    }
    return outcome;
}

StudyEngine work_here() {
    return [](const StudyFolder& folder, const std::vector<StudyWork>& work, const Progress& progress) {
        for (std::size_t i = 0; i < work.size(); ++i)
            work_on(folder, work[i].key, work[i].rung,
                    progress.part(double(i) / double(work.size()), double(i + 1) / double(work.size())));
        return std::map<std::string, std::string>();
    };
}

} // namespace facetmill
