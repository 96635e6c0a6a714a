#include "core/repair/suggestion.h"

#include <algorithm>

namespace facetmill {

namespace {

using Kind = RepairStep::Kind;

/// Shares of the mesh's size.
constexpr double small_piece = 0.1, rim_of_piece = 0.3;
constexpr double needle_bound = 1e-4, smooth_bound = 5e-4, decimate_bound = 2e-4, sheet_thickness = 0.02,
                 place_size = 0.05;

/// The least of 1, 2, 5 times a power of ten of `unit` that is above `mm` > 0.
double round_above(double mm, LengthUnit unit) {
    const double per = mm_per(unit);
    double v = round_down(mm / per);
    while (v * per <= mm)
        v = round_down(2.6 * v);
    return v * per;
}

double round_below(double mm, LengthUnit unit) {
    return mm > 0 ? round_down(mm / mm_per(unit)) * mm_per(unit) : 0;
}

/// A round length that is above the one and not above the other, or one between them.
double between(double low, double high, LengthUnit unit) {
    const double round = round_above(low, unit);
    return round <= high ? round : 0.5 * (low + high);
}

/// The shell of each hole.
std::vector<Index> shells_of_holes(const Mesh& mesh, const Survey& survey) {
    std::vector<Index> of_vertex(mesh.vertices.size(), 0);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        for (const Index v : mesh.facets[f])
            of_vertex[v] = survey.shells.of_facet[f];
    std::vector<Index> shells;
    for (const Hole& hole : survey.holes.holes)
        shells.push_back(of_vertex[hole.loop.front()]);
    return shells;
}

RepairStep pieces_below(const Shells& shells, LengthUnit unit) {
    double largest = 0, gone = 0, stays = infinity;
    for (const Shell& shell : shells.all)
        largest = std::max(largest, shell.box.diagonal());
    for (const Shell& shell : shells.all) {
        const double size = shell.box.diagonal();
        if (size < small_piece * largest)
            gone = std::max(gone, size);
        else
            stays = std::min(stays, size);
    }
    RepairStep step{.kind = Kind::pieces};
    if (gone > 0) step.size = between(gone, stays, unit);
    return step;
}

RepairStep holes_below(const Mesh& mesh, const Survey& survey, const std::vector<char>& goes,
                       LengthUnit unit) {
    const std::vector<Index> shells = shells_of_holes(mesh, survey);
    double filled = 0, rim = infinity;
    for (std::size_t h = 0; h < shells.size(); ++h) {
        const double diameter = survey.holes.holes[h].diameter;
        if (!goes.empty() && goes[shells[h]]) continue;
        if (diameter > rim_of_piece * survey.shells.all[shells[h]].box.diagonal())
            rim = std::min(rim, diameter);
        else
            filled = std::max(filled, diameter);
    }
    // Where a rim is smaller than a hole of another piece, only what is smaller than both is filled.
    if (rim <= filled) {
        filled = 0;
        for (const Hole& hole : survey.holes.holes)
            if (hole.diameter < rim) filled = std::max(filled, hole.diameter);
    }
    RepairStep step{.kind = Kind::holes};
    if (filled > 0) {
        step.size = between(filled, rim, unit);
        if (step.size >= rim) step.size = 0.5 * (filled + rim);
    }
    return step;
}

} // namespace

RepairStep starting_step(Kind kind, const Box3& box, LengthUnit unit) {
    RepairStep step{.kind = kind};
    const double size = box.diagonal();
    switch (kind) {
    case Kind::pieces:
    case Kind::crossings:
    case Kind::fins:
        step.size = round_below(place_size * size, unit);
        break;
    case Kind::holes:
        step.size = round_below(small_piece * size, unit);
        break;
    case Kind::needles:
        step.bound = round_below(needle_bound * size, unit);
        break;
    case Kind::smooth:
        step.bound = round_below(smooth_bound * size, unit);
        break;
    case Kind::decimate:
        step.bound = round_below(decimate_bound * size, unit);
        break;
    case Kind::cut:
        step.offset = box.center().z();
        break;
    case Kind::thicken:
        step.thickness = round_below(sheet_thickness * size, unit);
        break;
    default:
        break;
    }
    return step;
}

std::vector<RepairStep> suggested_recipe(const Mesh& mesh, const Survey& survey, bool inside_out,
                                         LengthUnit unit) {
    std::vector<RepairStep> recipe;
    std::vector<char> goes;
    if (const RepairStep pieces = pieces_below(survey.shells, unit); pieces.size > 0) {
        goes = pieces_that_go(survey.shells, pieces);
        recipe.push_back(pieces);
    }
    if (inside_out || survey.against > 0 || survey.doubles > 0) recipe.push_back({.kind = Kind::turn});
    if (survey.needles > 0) recipe.push_back(starting_step(Kind::needles, mesh.box(), unit));
    if (const RepairStep holes = holes_below(mesh, survey, goes, unit); holes.size > 0)
        recipe.push_back(holes);
    return recipe;
}

std::vector<HoleFate> hole_fates(const Mesh& mesh, const Survey& survey,
                                 const std::vector<RepairStep>& recipe) {
    const auto& holes = survey.holes.holes;
    std::vector<HoleFate> fates(holes.size(), HoleFate::left);
    const std::vector<Index> shells = shells_of_holes(mesh, survey);
    std::vector<char> stays(holes.size() + 1, 0); // as asked; the last: of places where no hole is
    for (const RepairStep& step : recipe) {
        if (step.off) continue;
        if (step.kind == Kind::hole) {
            const std::size_t h = hole_near(holes, Vec3(step.at[0], step.at[1], step.at[2]));
            if (step.fill == RepairStep::Fill::left)
                stays[h] = 1;
            else if (h < holes.size() && fates[h] == HoleFate::left)
                fates[h] = HoleFate::filled;
        }
        if (step.kind != Kind::pieces && step.kind != Kind::holes) continue;
        std::vector<char> goes;
        if (step.kind == Kind::pieces) goes = pieces_that_go(survey.shells, step);
        for (std::size_t h = 0; h < holes.size(); ++h) {
            if (fates[h] != HoleFate::left) continue;
            if (step.kind == Kind::pieces && goes[shells[h]]) fates[h] = HoleFate::goes;
            if (step.kind == Kind::holes && !stays[h] && (step.size == 0 || holes[h].diameter <= step.size))
                fates[h] = HoleFate::filled;
        }
    }
    return fates;
}

} // namespace facetmill
