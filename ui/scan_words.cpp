#include "ui/scan_words.h"

#include "ui/text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

using StepKind = RepairStep::Kind;

/// The room's words (what `tr` is asked for, and what the tables below mark, is found by
/// packaging/translations).
struct ScanRoom {
    Q_DECLARE_TR_FUNCTIONS(ScanRoom)
};

/// What takes less is not worth a word.
constexpr double min_told_seconds = 0.1;

struct KindWords {
    StepKind kind;
    const char *name, *help;
};

constexpr KindWords kind_words[] = {
    {StepKind::pieces, QT_TRANSLATE_NOOP("ScanRoom", "Small pieces"),
     QT_TRANSLATE_NOOP("ScanRoom", "Takes loose pieces away that are smaller than a limit.")},
    {StepKind::turn, QT_TRANSLATE_NOOP("ScanRoom", "Turn facets"),
     QT_TRANSLATE_NOOP("ScanRoom",
                       "Turns facets to agree with their neighbours and shells outward; doubles go.")},
    {StepKind::needles, QT_TRANSLATE_NOOP("ScanRoom", "Needles"),
     QT_TRANSLATE_NOOP("ScanRoom",
                       "Takes facets without height away; nothing moves farther than the bound.")},
    {StepKind::holes, QT_TRANSLATE_NOOP("ScanRoom", "Fill holes"),
     QT_TRANSLATE_NOOP("ScanRoom", "Closes holes up to a diameter; nothing else changes.")},
    {StepKind::smooth, QT_TRANSLATE_NOOP("ScanRoom", "Smooth noise"),
     QT_TRANSLATE_NOOP("ScanRoom",
                       "Takes short waves away; nothing moves farther than the bound, sharp edges stay.")},
    {StepKind::decimate, QT_TRANSLATE_NOOP("ScanRoom", "Decimate"),
     QT_TRANSLATE_NOOP("ScanRoom", "Takes facets away that say nothing, within the bound.")},
    {StepKind::cut, QT_TRANSLATE_NOOP("ScanRoom", "Cut by a plane"),
     QT_TRANSLATE_NOOP("ScanRoom", "Takes away what lies beyond a plane and closes the section.")},
    {StepKind::thicken, QT_TRANSLATE_NOOP("ScanRoom", "Thicken a sheet"),
     QT_TRANSLATE_NOOP("ScanRoom", "Gives a sheet a back and walls, so that it becomes a solid.")},
    {StepKind::crossings, QT_TRANSLATE_NOOP("ScanRoom", "Crossings"),
     QT_TRANSLATE_NOOP("ScanRoom", "Makes the surface anew where it runs through itself.")},
    {StepKind::join, QT_TRANSLATE_NOOP("ScanRoom", "Join a scan"),
     QT_TRANSLATE_NOOP("ScanRoom", "Goes on with another scan where this one ends; the two overlap.")},
    {StepKind::hole, QT_TRANSLATE_NOOP("ScanRoom", "One hole"),
     QT_TRANSLATE_NOOP("ScanRoom",
                       "Fills one hole as you choose, or leaves it open; other steps fill the rest.")},
    {StepKind::fins, QT_TRANSLATE_NOOP("ScanRoom", "Fins"),
     QT_TRANSLATE_NOOP("ScanRoom", "Takes sheets away that hang on the surface and end in the open.")},
};

const KindWords* words_of(StepKind kind) {
    for (const KindWords& words : kind_words)
        if (words.kind == kind) return &words;
    return nullptr;
}

/// A count of a report by its word; without words it is not told.
struct CountWords {
    const char *key, *one, *several;
};

constexpr CountWords count_words[] = {
    {"attempts", "", ""},
    {"back_facets", QT_TRANSLATE_NOOP("ScanRoom", "facet of the back"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets of the back")},
    {"crossings_found", QT_TRANSLATE_NOOP("ScanRoom", "crossing found"),
     QT_TRANSLATE_NOOP("ScanRoom", "crossings found")},
    {"crossings_left", QT_TRANSLATE_NOOP("ScanRoom", "crossing left"),
     QT_TRANSLATE_NOOP("ScanRoom", "crossings left")},
    {"doubles_removed", QT_TRANSLATE_NOOP("ScanRoom", "doubled facet gone"),
     QT_TRANSLATE_NOOP("ScanRoom", "doubled facets gone")},
    {"edges_collapsed", QT_TRANSLATE_NOOP("ScanRoom", "edge gone"),
     QT_TRANSLATE_NOOP("ScanRoom", "edges gone")},
    {"edges_left_against", QT_TRANSLATE_NOOP("ScanRoom", "edge still against its neighbour"),
     QT_TRANSLATE_NOOP("ScanRoom", "edges still against their neighbours")},
    {"edges_turned", QT_TRANSLATE_NOOP("ScanRoom", "edge turned"),
     QT_TRANSLATE_NOOP("ScanRoom", "edges turned")},
    {"facets_added", QT_TRANSLATE_NOOP("ScanRoom", "facet added"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets added")},
    {"facets_divided", QT_TRANSLATE_NOOP("ScanRoom", "facet divided"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets divided")},
    {"facets_in_no_sheet", QT_TRANSLATE_NOOP("ScanRoom", "facet left out: more than two on an edge"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets left out: more than two on an edge")},
    {"facets_joined", QT_TRANSLATE_NOOP("ScanRoom", "facet joined on"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets joined on")},
    {"facets_of_seam", QT_TRANSLATE_NOOP("ScanRoom", "facet of the seam"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets of the seam")},
    {"facets_overlapping", QT_TRANSLATE_NOOP("ScanRoom", "facet gone where both lie"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets gone where both lie")},
    {"facets_remade", QT_TRANSLATE_NOOP("ScanRoom", "facet made anew"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets made anew")},
    {"facets_removed", QT_TRANSLATE_NOOP("ScanRoom", "facet gone"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets gone")},
    {"filled", QT_TRANSLATE_NOOP("ScanRoom", "hole filled"), QT_TRANSLATE_NOOP("ScanRoom", "holes filled")},
    {"left_as_asked", QT_TRANSLATE_NOOP("ScanRoom", "hole left as asked"),
     QT_TRANSLATE_NOOP("ScanRoom", "holes left as asked")},
    {"left_larger", QT_TRANSLATE_NOOP("ScanRoom", "larger hole left"),
     QT_TRANSLATE_NOOP("ScanRoom", "larger holes left")},
    {"left_without_fit", QT_TRANSLATE_NOOP("ScanRoom", "hole left that no patch fits"),
     QT_TRANSLATE_NOOP("ScanRoom", "holes left that no patch fits")},
    {"not_found", QT_TRANSLATE_NOOP("ScanRoom", "hole that is not there"),
     QT_TRANSLATE_NOOP("ScanRoom", "holes that are not there")},
    {"needles_left", QT_TRANSLATE_NOOP("ScanRoom", "needle left"),
     QT_TRANSLATE_NOOP("ScanRoom", "needles left")},
    {"pieces_left", "", ""}, // the list says how many
    {"pieces_removed", QT_TRANSLATE_NOOP("ScanRoom", "piece gone"),
     QT_TRANSLATE_NOOP("ScanRoom", "pieces gone")},
    {"places_left_larger", QT_TRANSLATE_NOOP("ScanRoom", "larger place left"),
     QT_TRANSLATE_NOOP("ScanRoom", "larger places left")},
    {"seams_left_open", QT_TRANSLATE_NOOP("ScanRoom", "seam left open"),
     QT_TRANSLATE_NOOP("ScanRoom", "seams left open")},
    {"section_facets", QT_TRANSLATE_NOOP("ScanRoom", "facet in the section"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets in the section")},
    {"sections_left_open", QT_TRANSLATE_NOOP("ScanRoom", "section left open"),
     QT_TRANSLATE_NOOP("ScanRoom", "sections left open")},
    {"sheet_ends", QT_TRANSLATE_NOOP("ScanRoom", "end of a sheet"),
     QT_TRANSLATE_NOOP("ScanRoom", "ends of sheets")},
    {"turned", QT_TRANSLATE_NOOP("ScanRoom", "facet turned"), QT_TRANSLATE_NOOP("ScanRoom", "facets turned")},
    {"vertices_held_against_folds", QT_TRANSLATE_NOOP("ScanRoom", "vertex held against folds"),
     QT_TRANSLATE_NOOP("ScanRoom", "vertices held against folds")},
    {"vertices_moved", QT_TRANSLATE_NOOP("ScanRoom", "vertex moved"),
     QT_TRANSLATE_NOOP("ScanRoom", "vertices moved")},
    {"vertices_without_normal", QT_TRANSLATE_NOOP("ScanRoom", "vertex without a direction"),
     QT_TRANSLATE_NOOP("ScanRoom", "vertices without a direction")},
    {"wall_facets", QT_TRANSLATE_NOOP("ScanRoom", "facet of walls"),
     QT_TRANSLATE_NOOP("ScanRoom", "facets of walls")},
};

QString counted_words(const RepairCount& c) {
    for (const CountWords& words : count_words)
        if (c.what == words.key)
            return *words.one ? count_text(c.count) + QChar(' ')
                                    + ScanRoom::tr(c.count == 1 ? words.one : words.several)
                              : QString();
    return count_text(c.count) + QChar(' ') + text(c.what).replace(QChar('_'), QChar(' '));
}

} // namespace

QString step_name(StepKind kind) {
    const KindWords* words = words_of(kind);
    return words ? ScanRoom::tr(words->name) : sentence(text(repair_kind_name(kind)));
}

QString step_help(StepKind kind) {
    const KindWords* words = words_of(kind);
    return words ? ScanRoom::tr(words->help) : QString();
}

QString step_result(const StepReport& report, double seconds, LengthUnit unit) {
    QStringList did, parts;
    for (const RepairCount& c : report.counts)
        if (const QString words = counted_words(c); c.count > 0 && !words.isEmpty()) did << words;
    parts << (did.isEmpty() ? ScanRoom::tr("nothing to do") : did.join(QStringLiteral(", ")));
    parts << (report.displacement > 0
                  ? ScanRoom::tr("moved at most %1").arg(shown_length(report.displacement, unit, 3))
                  : ScanRoom::tr("nothing moved"));
    if (seconds >= min_told_seconds) parts << duration_text(seconds);
    return parts.join(QStringLiteral(" · "));
}

QString step_problem(const RepairStep& step) {
    try {
        check_recipe({step}, repair_list.key);
        return {};
    } catch (const Error& e) {
        return failure_text(e) + QChar('.');
    }
}

QString step_amount(const RepairStep& step, LengthUnit unit) {
    const auto length = [&](double mm) { return shown_length(mm, unit, 4); };
    switch (step.kind) {
    case StepKind::join:
        return elided(path_text(path_of(text(step.file)).filename()), 24);
    case StepKind::fins:
    case StepKind::pieces:
        return step.size > 0 ? ScanRoom::tr("below %1").arg(length(step.size)) : QString();
    case StepKind::holes:
        return step.size > 0 ? ScanRoom::tr("up to Ø %1").arg(length(step.size)) : ScanRoom::tr("all");
    case StepKind::hole:
        return step.fill == RepairStep::Fill::left   ? ScanRoom::tr("left open")
               : step.fill == RepairStep::Fill::flat ? ScanRoom::tr("flat")
                                                     : ScanRoom::tr("smooth");
    case StepKind::crossings:
        return ScanRoom::tr("up to Ø %1").arg(length(step.size));
    case StepKind::needles:
    case StepKind::smooth:
    case StepKind::decimate:
        return ScanRoom::tr("within %1").arg(length(step.bound));
    case StepKind::thicken:
        return length(step.thickness);
    default:
        return {};
    }
}

std::vector<SurveyLine> survey_lines(const ScannedMesh& scan) {
    const Survey& s = scan.survey;
    return {
        {ScanRoom::tr("Facets"), ScanRoom::tr("Triangles of the mesh"), scan.mesh->facet_count(), false},
        {ScanRoom::tr("Pieces"),
         ScanRoom::tr("Shells: facets that are joined by edges. A click goes to one."), s.shells.all.size(),
         false},
        {ScanRoom::tr("Holes"),
         ScanRoom::tr(
             "Closed curves of open edges; the rim of an open sheet is one of them. A click goes to one."),
         s.holes.holes.size()},
        {ScanRoom::tr("Open edges"), ScanRoom::tr("Edges of one facet"), scan.report.open_edges},
        {ScanRoom::tr("Against neighbours"), ScanRoom::tr("Edges along which two facets face opposite sides"),
         s.against},
        {ScanRoom::tr("Doubled facets"), ScanRoom::tr("Facets with the corners of another one"), s.doubles},
        {ScanRoom::tr("Needles"), ScanRoom::tr("Facets so low that their direction is noise"), s.needles},
        {ScanRoom::tr("Crossings"), ScanRoom::tr("Pairs of facets that run through each other"), s.crossings},
        {ScanRoom::tr("Overfull edges"), ScanRoom::tr("Edges of three facets and more"), s.non_manifold},
    };
}

QString scan_remark(const Mesh& mesh, const MeshReport& report, const Progress& progress) {
    if (report.is_relief || report.surfaces) return {};
    const bool turned =
        std::find(report.warnings.begin(), report.warnings.end(), "inside_out") != report.warnings.end();
    if (report.watertight && report.shells < 2 && report.duplicate == 0 && !turned) return {};
    Survey survey;
    survey.shells = shells_of(mesh, progress.part(0, 0.4, "Looking for pieces"));
    survey.holes = holes_of(mesh, progress.part(0.4, 1, "Looking for holes"));
    survey.doubles = report.duplicate;
    survey.against = report.inconsistent_edges;
    QStringList flaws;
    for (const RepairStep& step : suggested_recipe(mesh, survey, turned, LengthUnit::mm)) {
        if (step.kind == StepKind::pieces) flaws << ScanRoom::tr("loose pieces");
        if (step.kind == StepKind::turn) flaws << ScanRoom::tr("facets that face the wrong side");
        if (step.kind == StepKind::holes) flaws << ScanRoom::tr("holes");
    }
    if (flaws.isEmpty()) return {};
    return ScanRoom::tr("The mesh has %1. It is machined as it is; the scan room makes it worth machining.")
        .arg(some_of(flaws, 80));
}

} // namespace facetmill::ui
