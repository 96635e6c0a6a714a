#include "ui/mesh_change.h"

#include "ui/document.h"
#include "ui/text.h"
#include "ui/value_words.h"
#include "ui/verification_model.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>

namespace facetmill::ui {

namespace {

constexpr int shown_name = 40, shown_folder = 60;

QString translated(const char* text) {
    return QCoreApplication::translate("MeshChange", text);
}

QString file_name(const std::filesystem::path& path) {
    return elided(path_text(path.filename()), shown_name);
}

QString folder_name(const std::filesystem::path& path) {
    return elided(path_text(path.lexically_normal().parent_path()), shown_folder);
}

/// "b (a before)", or "b as before".
QString with_before(const QString& before, const QString& after) {
    if (before == after) return translated("%1 as before").arg(after);
    return translated("%1 (%2 before)").arg(after, before);
}

QString unit_word(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::cm:
        return translated("centimetres");
    case LengthUnit::m:
        return translated("metres");
    case LengthUnit::inch:
        return translated("inches");
    case LengthUnit::ft:
        return translated("feet");
    case LengthUnit::mm:
        break;
    }
    return translated("millimetres");
}

QString size_of(const Box3& box, LengthUnit unit) {
    const Vec3 size = box.size();
    return size_text({size.x(), size.y(), size.z()}, unit, 4);
}

} // namespace

MeshFile mesh_file(const std::filesystem::path& path) {
    if (path.empty()) return {};
    return {path.lexically_normal(), file_stamp(path)};
}

MeshFigures part_figures(const PreparedPart& part) {
    return {part.mesh->facets.size(), part.box, part.report.unit_guess, part.report.assumed_unit};
}

MeshFigures stock_figures(const PreparedPart& part) {
    return {part.stock_mesh->facets.size(), part.stock_box, {}, {}};
}

QString mesh_change_text(const MeshFile& before, const MeshFigures& was, const MeshFile& after,
                         const MeshFigures& is, LengthUnit unit) {
    QString text;
    if (before.path == after.path)
        text = translated("“%1” has changed on disk:").arg(file_name(after.path));
    else if (before.path.filename() == after.path.filename())
        text = translated("“%1” in %2 in place of the one in %3:")
                   .arg(file_name(after.path), folder_name(after.path), folder_name(before.path));
    else
        text = translated("“%1” in place of “%2”:").arg(file_name(after.path), file_name(before.path));
    text += QChar(' ')
            + translated("%1, %2.").arg(with_before(translated("%1 facets").arg(count_text(was.facets)),
                                                    translated("%1 facets").arg(count_text(is.facets))),
                                        with_before(size_of(was.box, unit), size_of(is.box, unit)));
    if (is.guess && is.unit && was.guess && *was.guess != *is.guess)
        text += QChar(' ')
                + translated("Its size suggests %1 (%2 before); it is read in %3.")
                      .arg(unit_word(*is.guess), unit_word(*was.guess), unit_word(*is.unit));
    return text;
}

QString out_of_date_text(const Document& document, const VerificationModel& verification) {
    QStringList plans;
    for (std::size_t i = 0; i < document.operation_count(); ++i)
        if (document.state(i) == OperationState::stale)
            plans << elided(text(document.operation(i).common().name), shown_name);
    QStringList all;
    if (plans.size() == 1)
        all << translated("the plan of “%1”").arg(plans.front());
    else if (plans.size() > 1)
        all << translated("%1 plans").arg(plans.size());
    if (verification.any() && !verification.current()) all << translated("the verification");
    if (all.isEmpty()) return {};
    return translated("Out of date: %1.").arg(all.join(QStringLiteral(", ")));
}

QString kept_places_text(const Document& document) {
    QStringList all;
    for (std::size_t i = 0; i < document.operation_count(); ++i) {
        const Operation& operation = document.operation(i);
        QStringList kept;
        for (const ParameterInfo* info : operation.parameters())
            if (info->kind == ParameterKind::records)
                if (const ParameterValue value = operation.get(info->key); value != info->empty_list())
                    kept << shown_count(*info, value);
        if (!kept.isEmpty())
            all << translated("%1 of “%2”")
                       .arg(kept.join(QStringLiteral(", ")),
                            elided(text(operation.common().name), shown_name));
    }
    if (document.project().programs.zero != std::array<double, 3>{0, 0, 0})
        all << translated("the work zero");
    if (all.isEmpty()) return {};
    return translated("Still at places of the part before: %1.").arg(all.join(clause_mark()));
}

} // namespace facetmill::ui
