// Routes of the tool on one layer of roughing: drive lines joined where the tool can stay down, and the
// borders of what is free. All level; millimetres.
#pragma once

#include "core/strategy/rough/rough_reach.h"
#include "core/strategy/surface/stock_field.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace facetmill {

/// One go of the tool.
struct RoughRoute {
    std::vector<Vec2> points;
    Vec2 before = Vec2::Zero(),
         after = Vec2::Zero(); ///< how far it may begin earlier and end later, straight
    bool closed = false;
    bool reversible = true;
    int line = -1;     ///< the first drive line; -1: along a border
    double offset = 0; ///< its v

    void turn() {
        std::reverse(points.begin(), points.end());
        std::swap(before, after);
    }
};

/// A part of a drive line that is to be cut.
struct LinePiece {
    int line = 0; ///< in the order of v
    double v = 0;
    Interval cut;  ///< in u
    Interval free; ///< how far the line is free round it
};

class LayerRoutes {
public:
    /// All of it must outlive this. `least`: height below which there is nothing to take away.
    LayerRoutes(const RoughReach& reach, const StockField& field, const StockCutter& cutter,
                const DriveFrame& frame, double least)
        : reach_(reach), field_(field), cutter_(cutter), frame_(frame), min_(least) {}

    /// Where on the free ranges of a line at z there is something to cut; gaps shorter than `merge` are cut
    /// through. `but_ends`: without pieces shorter than the cutter's radius at the ends of a range, most of
    /// which a contour takes.
    void add_pieces(int line, double v, std::span<const Interval> free, double z, double merge, bool but_ends,
                    std::vector<LinePiece>& pieces) const;
    /// The pieces in machining order. Neighbouring lines are joined where the line between their ends is
    /// free, straight or along a contour, and no longer than `longest`; never with `oneway`.
    std::vector<RoughRoute> joined_lines(std::vector<LinePiece> pieces, std::span<const FreeContour> contours,
                                         double z, double longest, bool oneway, Vec2& at,
                                         const Progress& progress) const;
    /// Where on the contours there is something to cut at z, or the line between two places is `wanted`.
    std::vector<RoughRoute>
    along_contours(std::span<const FreeContour> contours, double z, Vec2& at, const Progress& progress,
                   const std::function<bool(const Vec2&, const Vec2&)>& wanted = {}) const;

    /// Points between two free places for a level route at z that is free all along, straight or along a
    /// contour, and no longer than `longest`; false where there is none.
    bool connect(const Vec2& from, const Vec2& to, std::span<const FreeContour> contours, double z,
                 double longest, std::vector<Vec2>& route) const;

private:
    void begin_earlier(const std::vector<Vec2>& points, bool closed, double z, std::vector<char>& cut) const;

    const RoughReach& reach_;
    const StockField& field_;
    const StockCutter& cutter_;
    DriveFrame frame_;
    double min_;
};

} // namespace facetmill
