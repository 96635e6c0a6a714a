// The passes of an operation as they will about run, before it is planned: a picture to choose by, within a
// fraction of a second, of any kind of operation. Millimetres.
//
// The part is taken as heights on a coarse grid (coarse_ground.h), the cutter let down on it cell by cell
// (coarse_tips.h), and the course of the operation's passes laid over that: lines as far apart as the
// tolerance allows on the slopes that most of each has, levels by slices, valleys where the cutter's contact
// jumps. Nothing is checked, and what makes plans long is not in it: partial passes, links, entries, stock
// that operations before left, regions of rework. No program comes from a preview.
#pragma once

#include "core/strategy/plan/operation.h"
#include "core/strategy/preview/coarse_ground.h"

#include <memory>
#include <string>
#include <vector>

namespace facetmill {

struct TurnedGround; // preview_turning.h

struct PassPreview {
    /// The tip's course; contacts on the part of operations that tilt the tool as the surface asks. In the
    /// setup's coordinates.
    std::vector<std::vector<Vec3>> lines;
    std::size_t passes = 0; ///< drive planes, levels, spokes, turns, valleys: what the course is counted by
    std::size_t drawn_every = 1; ///< more are not drawn than could be told apart: every so many-th is
    double spacing = 0;          ///< of the grid, mm: what the lines are true to, about
    double step = 0;             ///< between passes on a level plane, mm; 0: there is none
    /// What of the operation it does not show: "regions of rework".
    std::vector<std::string> without;

    double length() const;
    /// With what is not drawn.
    double estimated_length() const { return double(drawn_every) * length(); }
};

struct PreviewRequest {
    /// What the operation would be planned with, in its view; neither contact index nor geometry is asked.
    PlanContext context;
    Mat3 turn = Mat3::Identity();               ///< from the setup to the view (axis_view.h)
    std::shared_ptr<const CoarseGround> ground; ///< of the view; null for operations that turn the part
    std::shared_ptr<const TurnedGround> turned; ///< of those, about their axis; else null
    std::vector<char> asked;   ///< cells of the ground that the operation's boundary holds; empty: all
    std::vector<char> avoided; ///< cells that it keeps off; empty: none
    double travel = 0;         ///< direction of travel from X, in the view, where the operation has one
};

/// Passes as the operation would about make them. The same lines for any number of threads. Throws
/// Error(empty_result) where nothing would be cut, Error(out_of_range, missing_reference) for settings that
/// can make no passes.
PassPreview preview_passes(const Operation& operation, const PreviewRequest& request,
                           const Progress& progress);

/// Parts of more facets are not previewed: making the grid takes too long to wait for.
inline constexpr std::size_t max_previewed_facets = 4'000'000;
/// Cells along the longer side of a part.
inline constexpr int preview_cells = 240;

} // namespace facetmill
