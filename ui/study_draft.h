// A study as the form asks for it, and the file that comes of it. No widgets.
#pragma once

#include "core/base/strict_json.h"
#include "core/job/project.h"
#include "core/study/measure.h"

#include <QString>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace facetmill::ui {

/// Something of the project that may vary.
struct DraftVariation {
    enum class Kind {
        choices, ///< some of a list
        numbers, ///< values that are typed, or words of the parameter
        orders,  ///< the operations in every order
    };
    struct Choice {
        QString label;
        Json value;
        Json tool; ///< of a library, as files have it; null: the project's own
        bool on = false;
    };
    Kind kind = Kind::choices;
    QString operation; ///< its name, with its setup where there are several, or what else it is of; or empty
    QString what;      ///< "Tool"
    std::string path;
    std::vector<Choice> choices;
    const ParameterInfo* info = nullptr; ///< numbers: what is typed is read by it
    /// numbers: values with semicolons between them; those of several numbers have blanks between these
    QString typed;
    bool on = false; ///< orders

    /// How many values it has; 0 where what is typed is none. `wrong` says why.
    std::size_t count(LengthUnit unit, QString* wrong = nullptr) const;
};

struct DraftMeasure {
    Measure measure = Measure::machining_time;
    bool wanted = false;
    QString most; ///< limit as it is typed (measure_typed); empty: none; "×1.1": times the project's
};

struct StudyDraft {
    LengthUnit unit = LengthUnit::mm;
    std::vector<DraftVariation> vary;
    std::vector<DraftMeasure> measures;
    Measure first = Measure::machining_time; ///< what chooses the winner
    std::size_t samples = 0;                 ///< 0: all

    /// How many there are of all that varies; at most 10^15.
    double combinations() const;
    /// Candidates that would be planned, beside the project itself.
    double candidates() const;
    /// Why it is no study yet, for the user; empty: it is one.
    QString problem() const;
    /// The study's file, with the project named as it is written there. Throws Error(wrong_type,
    /// out_of_range) for what is typed.
    std::string json(const std::string& project_file) const;
};

/// What may vary of a project: for each operation tools, of the project and of the user's libraries, kinds
/// that do the same, direction, tolerance, step-over and the like; of each setup machine and stock. Only what
/// is in the project is chosen.
StudyDraft draft_for(const Project& project);

} // namespace facetmill::ui
