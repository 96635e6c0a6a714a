// What the scan room says: kinds of steps, what they did, what a survey found.
#pragma once

#include "ui/scan_study.h"

#include <QString>

#include <vector>

namespace facetmill::ui {

/// "Fill holes".
QString step_name(RepairStep::Kind kind);
/// One sentence: what a step of this kind does.
QString step_help(RepairStep::Kind kind);
/// "200 holes filled · nothing moved"; what took no time to speak of, or below 0, is not told.
QString step_result(const StepReport& report, double seconds, LengthUnit unit);
/// Why a step cannot be carried out as it stands; empty where it can.
QString step_problem(const RepairStep& step);
/// The amount that says most of a step: "up to 5 mm"; empty where there is none.
QString step_amount(const RepairStep& step, LengthUnit unit);

/// A line about a mesh: what was found and how many of it.
struct SurveyLine {
    QString what, help;
    std::size_t count = 0;
    bool flaw = true; ///< else it is no flaw to have some
};
/// Always as many, in the same order.
std::vector<SurveyLine> survey_lines(const ScannedMesh& scan);
/// Which of the lines is about pieces, and which about holes.
inline constexpr std::size_t pieces_line = 1, holes_line = 2;

/// What should be said of a mesh that was just opened, as a sentence: holes within its surface, loose pieces,
/// facets that do not agree. Empty where it has none of that, and for reliefs and files of surfaces.
QString scan_remark(const Mesh& mesh, const MeshReport& report, const Progress& progress);

} // namespace facetmill::ui
