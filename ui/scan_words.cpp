#include "ui/scan_words.h"

#include "ui/text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

using StepKind = RepairStep::Kind;

QString in_words(const char* words) {
    return QCoreApplication::translate("ScanRoom", words);
}

/// What takes less is not worth a word.
constexpr double min_told_seconds = 0.1;

struct KindWords {
    StepKind kind;
    const char *name, *help;
};

constexpr KindWords kind_words[] = {
    {StepKind::pieces, "Small pieces", "Takes loose pieces away that are smaller than a limit."},
    {StepKind::turn, "Turn facets",
     "Turns facets to agree with their neighbours and shells outward; doubles go."},
    {StepKind::needles, "Needles", "Takes facets without height away; nothing moves farther than the bound."},
    {StepKind::holes, "Fill holes", "Closes holes up to a diameter; nothing else changes."},
    {StepKind::smooth, "Smooth noise",
     "Takes short waves away; nothing moves farther than the bound, sharp edges stay."},
    {StepKind::decimate, "Decimate", "Takes facets away that say nothing, within the bound."},
    {StepKind::cut, "Cut by a plane", "Takes away what lies beyond a plane and closes the section."},
    {StepKind::thicken, "Thicken a sheet", "Gives a sheet a back and walls, so that it becomes a solid."},
    {StepKind::crossings, "Crossings", "Makes the surface anew where it runs through itself."},
    {StepKind::join, "Join a scan", "Goes on with another scan where this one ends; the two overlap."},
    {StepKind::fins, "Fins", "Takes sheets away that hang on the surface and end in the open."},
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
    {"back_facets", "facet of the back", "facets of the back"},
    {"crossings_found", "crossing found", "crossings found"},
    {"crossings_left", "crossing left", "crossings left"},
    {"doubles_removed", "doubled facet gone", "doubled facets gone"},
    {"edges_collapsed", "edge gone", "edges gone"},
    {"edges_left_against", "edge still against its neighbour", "edges still against their neighbours"},
    {"edges_turned", "edge turned", "edges turned"},
    {"facets_added", "facet added", "facets added"},
    {"facets_divided", "facet divided", "facets divided"},
    {"facets_in_no_sheet", "facet left out: more than two on an edge",
     "facets left out: more than two on an edge"},
    {"facets_joined", "facet joined on", "facets joined on"},
    {"facets_of_seam", "facet of the seam", "facets of the seam"},
    {"facets_overlapping", "facet gone where both lie", "facets gone where both lie"},
    {"facets_remade", "facet made anew", "facets made anew"},
    {"facets_removed", "facet gone", "facets gone"},
    {"filled", "hole filled", "holes filled"},
    {"left_larger", "larger hole left", "larger holes left"},
    {"left_without_fit", "hole left that no patch fits", "holes left that no patch fits"},
    {"needles_left", "needle left", "needles left"},
    {"pieces_left", "", ""}, // the list says how many
    {"pieces_removed", "piece gone", "pieces gone"},
    {"places_left_larger", "larger place left", "larger places left"},
    {"seams_left_open", "seam left open", "seams left open"},
    {"section_facets", "facet in the section", "facets in the section"},
    {"sections_left_open", "section left open", "sections left open"},
    {"sheet_ends", "end of a sheet", "ends of sheets"},
    {"turned", "facet turned", "facets turned"},
    {"vertices_held_against_folds", "vertex held against folds", "vertices held against folds"},
    {"vertices_moved", "vertex moved", "vertices moved"},
    {"vertices_without_normal", "vertex without a direction", "vertices without a direction"},
    {"wall_facets", "facet of walls", "facets of walls"},
};

QString counted_words(const RepairCount& c) {
    for (const CountWords& words : count_words)
        if (c.what == words.key)
            return *words.one
                       ? count_text(c.count) + QChar(' ') + in_words(c.count == 1 ? words.one : words.several)
                       : QString();
    return count_text(c.count) + QChar(' ') + text(c.what).replace(QChar('_'), QChar(' '));
}

} // namespace

QString step_name(StepKind kind) {
    const KindWords* words = words_of(kind);
    return words ? in_words(words->name) : sentence(text(repair_kind_name(kind)));
}

QString step_help(StepKind kind) {
    const KindWords* words = words_of(kind);
    return words ? in_words(words->help) : QString();
}

QString step_result(const StepReport& report, double seconds, LengthUnit unit) {
    QStringList did, parts;
    for (const RepairCount& c : report.counts)
        if (const QString words = counted_words(c); c.count > 0 && !words.isEmpty()) did << words;
    parts << (did.isEmpty() ? in_words("nothing to do") : did.join(QStringLiteral(", ")));
    parts << (report.displacement > 0
                  ? in_words("moved at most %1").arg(shown_length(report.displacement, unit, 3))
                  : in_words("nothing moved"));
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
        return step.size > 0 ? in_words("below %1").arg(length(step.size)) : QString();
    case StepKind::holes:
        return step.size > 0 ? in_words("up to Ø %1").arg(length(step.size)) : in_words("all");
    case StepKind::crossings:
        return in_words("up to Ø %1").arg(length(step.size));
    case StepKind::needles:
    case StepKind::smooth:
    case StepKind::decimate:
        return in_words("within %1").arg(length(step.bound));
    case StepKind::thicken:
        return length(step.thickness);
    default:
        return {};
    }
}

std::vector<SurveyLine> survey_lines(const ScannedMesh& scan) {
    const Survey& s = scan.survey;
    return {
        {in_words("Facets"), in_words("Triangles of the mesh"), scan.mesh->facet_count(), false},
        {in_words("Pieces"), in_words("Shells: facets that are joined by edges. A click goes to one."),
         s.shells.all.size(), false},
        {in_words("Holes"),
         in_words(
             "Closed curves of open edges; the rim of an open sheet is one of them. A click goes to one."),
         s.holes.holes.size()},
        {in_words("Open edges"), in_words("Edges of one facet"), scan.report.open_edges},
        {in_words("Against neighbours"), in_words("Edges along which two facets face opposite sides"),
         s.against},
        {in_words("Doubled facets"), in_words("Facets with the corners of another one"), s.doubles},
        {in_words("Needles"), in_words("Facets so low that their direction is noise"), s.needles},
        {in_words("Crossings"), in_words("Pairs of facets that run through each other"), s.crossings},
        {in_words("Overfull edges"), in_words("Edges of three facets and more"), s.non_manifold},
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
        if (step.kind == StepKind::pieces) flaws << in_words("loose pieces");
        if (step.kind == StepKind::turn) flaws << in_words("facets that face the wrong side");
        if (step.kind == StepKind::holes) flaws << in_words("holes");
    }
    if (flaws.isEmpty()) return {};
    return in_words("The mesh has %1. It is machined as it is; the scan room makes it worth machining.")
        .arg(some_of(flaws));
}

} // namespace facetmill::ui
