// What a study found becomes the project. No widgets.
#pragma once

#include "ui/study_figures.h"

#include <QString>

namespace facetmill::ui {

class Document;

/// Why a candidate cannot be adopted; empty: it can.
QString why_not_adopted(const StudyLook& look, std::size_t candidate);

struct Adoption {
    QString problem; ///< why nothing has changed; empty: it has
    QString words;   ///< what has
};
/// Makes a candidate the project, as one step of the history.
Adoption adopt_candidate_into(Document& document, const StudyLook& look, std::size_t candidate);

} // namespace facetmill::ui
