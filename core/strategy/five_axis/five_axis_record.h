// What finishing with five axes remembers of every contact point, so that it can be studied afterwards: its
// strip, and the posture chosen. With it and the part any configuration space can be built again
// (five_axis_study.h).
#pragma once

#include "core/cspace/choose.h"
#include "core/strategy/five_axis/five_axis_field.h"

#include <vector>

namespace facetmill {

struct FiveAxisRecord {
    struct Point {
        ContactPlace place; ///< with the posture kept by hand, if any, free or not
        double cm2_lead = 0;
        ChosenPosture choice; ///< by the method of the operation
    };
    /// One line of one pass, in the order of travel.
    struct Line {
        std::size_t begin = 0, end = 0; ///< its points, as indices of `points`
        int drive = 0;
        std::size_t piece = 0; ///< of `pieces`
    };
    /// What lines belong to: the part, or a piece of it with the view in which it was cut.
    struct Piece {
        PlanContext context;
        Mat3 view = Mat3::Identity();
        std::array<double, 2> lead_limits{0, 0};
        Finish5Settings::Passes passes = Finish5Settings::Passes::parallel;
    };
    PlanContext context;      ///< of the first piece
    Finish5Settings settings; ///< of all pieces, but for their lead limits and passes
    std::vector<Piece> pieces;
    std::vector<Point> points; ///< in machining order
    std::vector<Line> lines;
    /// False: of passes whose ball was inclined afterwards (tilted_passes.h), which asks for nothing but the
    /// contact point itself.
    bool has_strips = true;
    /// What the contact indexes of the contexts hold, of a record whose contexts have none: one that was kept
    /// in a file. All of them have the same.
    MeshPtr kept_off;

    const Line& line_of(std::size_t point) const;
    Finish5Settings settings_of(std::size_t piece) const;
    /// Appends what was cut of other pieces; the number of drive planes before them is `drives`.
    void append(const FiveAxisRecord& other, int drives);
};

} // namespace facetmill
