#include "ui/scan_rows.h"

#include "ui/scan_words.h"
#include "ui/text.h"

#include <algorithm>

namespace facetmill::ui {

namespace {

QString fate_text(HoleFate fate) {
    return fate == HoleFate::filled ? ScanPanel::tr("filled")
           : fate == HoleFate::goes ? ScanPanel::tr("goes")
                                    : ScanPanel::tr("left");
}

ScanPanel::Line part_row(const QString& what, const QString& now, const QString& after) {
    return {what, now, after, ScanPanel::tr("Click: shown in the view"), false, {}};
}

ScanPanel::Line hole_row(const QString& what, const QString& after) {
    return {what,  {}, after, ScanPanel::tr("Click: shown in the view. Right click: how it is filled"),
            false, {}};
}

ScanPanel::Line rest_row(std::size_t left_out) {
    return {ScanPanel::tr("%1 smaller ones", nullptr, int(left_out)).arg(count_text(left_out)),
            {},
            {},
            {},
            false,
            {}};
}

std::vector<char> all_that_go(const Shells& shells, const std::vector<RepairStep>& recipe) {
    std::vector<char> goes(shells.all.size(), 0);
    for (const RepairStep& step : recipe) {
        if (step.off || step.kind != RepairStep::Kind::pieces) continue;
        const auto more = pieces_that_go(shells, step);
        for (std::size_t s = 0; s < goes.size(); ++s)
            goes[s] = char(goes[s] || more[s]);
    }
    return goes;
}

} // namespace

std::vector<ScanPanel::Line> survey_rows(const ScannedMesh& scan, const ScannedMesh* after,
                                         const std::vector<RepairStep>& recipe, LengthUnit unit) {
    const auto now = survey_lines(scan);
    const auto then = after ? survey_lines(*after) : std::vector<SurveyLine>();
    std::vector<ScanPanel::Line> rows;
    for (std::size_t i = 0; i < now.size(); ++i)
        rows.push_back({now[i].what,
                        count_text(now[i].count),
                        after ? count_text(then[i].count) : QString(),
                        now[i].help,
                        now[i].flaw && now[i].count > 0,
                        {}});
    const auto fates = hole_fates(*scan.mesh, scan.survey, recipe);
    auto& holes = rows[holes_line].parts;
    for (std::size_t h = 0; h < std::min(fates.size(), listed_parts); ++h)
        holes.push_back(
            hole_row(ScanPanel::tr("Ø %1").arg(shown_length(scan.survey.holes.holes[h].diameter, unit, 3)),
                     fate_text(fates[h])));
    if (fates.size() > listed_parts) holes.push_back(rest_row(fates.size() - listed_parts));
    auto& pieces = rows[pieces_line].parts;
    if (scan.pieces.size() < 2) return rows;
    const std::vector<char> goes = all_that_go(scan.survey.shells, recipe);
    for (std::size_t k = 0; k < std::min(scan.pieces.size(), listed_parts); ++k) {
        const std::size_t s = scan.pieces[k];
        const Shell& shell = scan.survey.shells.all[s];
        pieces.push_back(part_row(ScanPanel::tr("%1 across").arg(shown_length(shell.box.diagonal(), unit, 3)),
                                  count_text(shell.facets),
                                  goes[s] ? ScanPanel::tr("goes") : ScanPanel::tr("stays")));
    }
    if (scan.pieces.size() > listed_parts) pieces.push_back(rest_row(scan.pieces.size() - listed_parts));
    return rows;
}

QString scan_size(const ScannedMesh& scan, bool scaled, LengthUnit unit) {
    const Vec3 size = scan.box.size();
    const double mm[3] = {size.x(), size.y(), size.z()};
    QStringList words{size_text(mm, unit, 4),
                      scan.report.watertight ? ScanPanel::tr("watertight") : ScanPanel::tr("not watertight")};
    if (scaled) words << ScanPanel::tr("lengths as in the file");
    return words.join(QStringLiteral(" · "));
}

ScanPanel::Step step_row(const RepairStep& step, const QString& failure, const TriedStepPtr& tried,
                         const StepReport* read, LengthUnit unit) {
    ScanPanel::Step row;
    row.name = step_name(step.kind);
    const QString wrong = step_problem(step);
    if (const QString amount = step_amount(step, unit); wrong.isEmpty() && !amount.isEmpty())
        row.name += QStringLiteral(", ") + amount;
    row.off = step.off;
    row.help = step_help(step.kind);
    if (!wrong.isEmpty() || !failure.isEmpty()) {
        row.failed = true;
        row.result = wrong.isEmpty() ? sentence(failure) : wrong;
    } else if (step.off) {
        row.result = ScanPanel::tr("off");
    } else if (tried) {
        row.result = step_result(tried->report, tried->seconds, unit);
    } else if (read) {
        row.result = step_result(*read, -1, unit);
    }
    if (!row.result.isEmpty()) row.help += QChar('\n') + row.result;
    return row;
}

QString step_remark(const ScannedMesh& scan, const std::vector<RepairStep>& recipe, std::size_t i) {
    const RepairStep& step = recipe[i];
    QStringList words{step_help(step.kind)};
    if (step.kind == RepairStep::Kind::holes) {
        const auto fates = hole_fates(*scan.mesh, scan.survey, recipe);
        const auto filled = std::ranges::count(fates, HoleFate::filled);
        words << ScanPanel::tr("As the file is, %1 of %2 holes are filled.", nullptr, int(filled))
                     .arg(count_text(std::size_t(filled)), count_text(fates.size()));
    }
    if (step.kind == RepairStep::Kind::pieces) {
        const auto goes = pieces_that_go(scan.survey.shells, step);
        const auto gone = std::ranges::count(goes, char(1));
        words << ScanPanel::tr("As the file is, %1 of %2 pieces go.", nullptr, int(gone))
                     .arg(count_text(std::size_t(gone)), count_text(goes.size()));
    }
    return words.join(QChar(' '));
}

QString trial_summary(const ScanTrial& trial, LengthUnit unit) {
    double moved = 0;
    for (const TriedStepPtr& step : trial.steps)
        moved += step->report.displacement;
    return ScanPanel::tr("%1; %2 facets, %3.")
        .arg(moved > 0 ? ScanPanel::tr("Moved at most %1").arg(shown_length(moved, unit, 3))
                       : ScanPanel::tr("Nothing moved"),
             count_text(trial.after->mesh->facet_count()),
             trial.after->report.watertight ? ScanPanel::tr("watertight") : ScanPanel::tr("not watertight"));
}

} // namespace facetmill::ui
