// What the page of studies says in sentences: what is asked, how much work it is, what came of it.
#pragma once

#include "ui/study_draft.h"
#include "ui/study_runner.h"

#include <QString>

namespace facetmill::ui {

class Document;
class VerificationModel;

/// What may vary, what is wanted and the limits, of a study that was read.
QString study_question_html(const StudyFolder& folder);
/// How many candidates there would be, and how long they take where that is known from the project itself.
QString study_estimate_words(const StudyDraft& draft, const Document& document,
                             const VerificationModel& verification);
/// Who wins; where nobody does who comes nearest, and what it misses; what is missing, and what was lost.
QString study_outcome_words(const StudyLook& look);
/// How far a run is, in a sentence, and as a share of its work.
QString study_stand_words(const StudyStand& stand);
double study_share_done(const StudyStand& stand);

} // namespace facetmill::ui
