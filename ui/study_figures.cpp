#include "ui/study_figures.h"

#include "ui/text.h"
#include "ui/worded.h"

#include <QObject>

namespace facetmill::ui {

namespace {

StudyRow study_row(const StudyLook& look, std::size_t i) {
    const StudyOutcome& outcome = look.outcome;
    const Candidate& candidate = outcome.candidates[i];
    StudyRow row;
    row.standing = standing_of(outcome, i);
    row.chosen = candidate.chosen;
    row.same = outcome.same[i] != i;
    row.choice = candidate.chosen.empty() ? QObject::tr("as it stands")
                                          : text(candidate_text(look.folder->study(), candidate));
    row.why = worded(why_no_winner(outcome, i));
    const CandidateState& state = state_of(outcome, i);
    if (const RungResult* last = state.last()) row.measures = last->measures;
    for (const Rung rung : all_rungs)
        if (const auto& result = state.at(rung)) row.looks[std::size_t(rung)] = result->passed;
    return row;
}

} // namespace

std::optional<double> StudyFigures::limit(Measure measure) const {
    for (const SetLimit& l : limits)
        if (l.measure == measure) return l.most;
    return std::nullopt;
}

StudyFiguresPtr study_figures(const StudyLook& look) {
    auto figures = std::make_shared<StudyFigures>();
    const Study& study = look.folder->study();
    figures->unit = look.folder->project().unit;
    for (const StudyVariation& v : study.vary) {
        figures->variations << text(v.name);
        QStringList labels;
        for (const StudyChoice& c : v.choices)
            labels << text(c.label);
        figures->choices.push_back(labels);
    }
    figures->want = study.want;
    figures->limits = look.outcome.decision.limits;
    figures->winner = look.outcome.decision.winner;
    figures->nearest = look.outcome.decision.nearest;
    figures->missing = look.outcome.decision.missing.size();
    for (std::size_t i = 0; i < look.outcome.candidates.size(); ++i)
        figures->rows.push_back(study_row(look, i));
    for (const StudyTask& task : look.outcome.decision.missing)
        figures->rows[task.candidate].waiting = true;
    return figures;
}

} // namespace facetmill::ui
