#include "ui/study_adoption.h"

#include "ui/document.h"
#include "ui/text.h"

#include <QObject>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace facetmill::ui {

QString why_not_adopted(const StudyLook& look, std::size_t candidate) {
    const StudyOutcome& outcome = look.outcome;
    if (candidate == 0 || candidate >= outcome.candidates.size() || !outcome.candidates[candidate].usable())
        return QObject::tr("There is nothing to adopt.");
    const auto& fine = state_of(outcome, candidate).at(Rung::fine);
    if (!fine || !fine->passed) return QObject::tr("This candidate has not been verified finely.");
    return {};
}

Adoption adopt_candidate_into(Document& document, const StudyLook& look, std::size_t candidate) {
    if (const QString why = why_not_adopted(look, candidate); !why.isEmpty()) return {why, {}};
    Project adopted = *look.outcome.candidates[candidate].project;
    std::error_code ec;
    if (!std::filesystem::equivalent(adopted.part_path(), document.project().part_path(), ec))
        return {QObject::tr("The study is of another part, %1: open its project first.")
                    .arg(path_text(adopted.part_path().filename())),
                {}};
    Project base = look.folder->project();
    const std::filesystem::path path = document.project().path;
    move_project(adopted, path);
    move_project(base, path);
    const bool changed = project_to_json(base) != project_to_json(document.project());
    document.change(QObject::tr("Adopt candidate %1").arg(candidate), [&](Project& p) {
        p = view_of_setup(adopted, std::min(chosen_setup(p), setup_count(adopted) - 1));
    });
    const QString words =
        changed
            ? QObject::tr("Candidate %1 is the project now; what was changed since the study began is as it "
                          "was then. Undo takes it back.")
            : QObject::tr("Candidate %1 is the project now. Undo takes it back.");
    return {{}, words.arg(candidate)};
}

} // namespace facetmill::ui
