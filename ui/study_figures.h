// What the pictures and the table of a study show: its candidates with their figures, as plain values. No
// widgets.
#pragma once

#include "core/study/study_results.h"

#include <QString>
#include <QStringList>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace facetmill::ui {

/// A study's folder, and what it knew at a time.
struct StudyLook {
    std::shared_ptr<const StudyFolder> folder;
    StudyOutcome outcome;
};
using StudyLookPtr = std::shared_ptr<const StudyLook>;

struct StudyRow {
    CandidateStanding standing = CandidateStanding::out;
    std::vector<std::size_t> chosen; ///< of each variation; empty: the project as it stands
    QString choice;                  ///< the same in words
    Measures measures;
    /// Whether it passed each rung; none: it was not looked at so closely.
    std::array<std::optional<bool>, all_rungs.size()> looks;
    bool waiting = false; ///< a look at it is asked for
    bool same = false;    ///< the project of one before it: shown there
    QString why;          ///< it cannot win
};

struct StudyFigures {
    LengthUnit unit = LengthUnit::mm;
    QStringList variations;
    std::vector<QStringList> choices; ///< labels of each variation's
    std::vector<Measure> want;
    std::vector<SetLimit> limits;
    std::vector<StudyRow> rows; ///< by the candidates' numbers: 0 is the project as it stands
    std::optional<std::size_t> winner, nearest;
    std::size_t missing = 0; ///< looks that are asked for

    std::optional<double> value(std::size_t row, Measure measure) const {
        return rows[row].measures[measure];
    }
    /// The most that a measure may be, where there is such a limit.
    std::optional<double> limit(Measure measure) const;
};
using StudyFiguresPtr = std::shared_ptr<const StudyFigures>;

StudyFiguresPtr study_figures(const StudyLook& look);

} // namespace facetmill::ui
