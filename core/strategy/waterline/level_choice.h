// The heights of a waterline path: as far apart as the cusps on the slopes between them allow, level by
// level; where a few places ask for less, pieces of levels between lie there alone. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/surface/contact_domain.h"
#include "core/strategy/waterline/level_field.h"
#include "core/strategy/waterline/slope_steps.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

struct Level {
    double z = 0;
    /// The cells of the field in which a partial one is asked for, in order; none: it is a whole one.
    std::vector<std::uint32_t> cells;
};

class LevelChoice {
public:
    /// `slopes`: those that are cut, radians from level.
    LevelChoice(const SlopeSteps& steps, const Interval& slopes, double spacing)
        : steps_(steps), slopes_(slopes), spacing_(spacing) {}

    /// Looks at the cells of a band of rows of the field (LevelField::UseRows), `columns` places each.
    void look(int first, int columns, std::span<const TipTouch> touches, const Progress& progress);
    /// Whether a cell, or one no farther than three cells from it, is touched with these slopes, on a surface
    /// or on an edge that the cutter rolls over, or lies across a wall.
    bool is_steep(std::uint32_t cell) const { return steep_[cell]; }
    /// Nothing of the part has these slopes.
    bool empty() const { return asks_.empty(); }

    struct Limits {
        double lowest = 0;          ///< no level is lower
        double above_floor = 0.01;  ///< how far above a floor the level runs that clears the foot of a wall
        std::optional<double> step; ///< the same everywhere; none: as the cusps allow
    };
    /// From the top. Whole levels first, then partial ones: in the order of their heights.
    std::vector<Level> levels(const Limits& limits, const Progress& progress) const;
    /// The highest cusp that levels so far apart leave.
    double cusp_at(double step) const;
    double highest() const { return highest_; }

private:
    /// What one cell of the field asks for.
    struct Ask {
        float lo, hi; ///< tip heights
        float step;
        float slope, ratio;
        std::uint32_t cell;
    };
    struct Foot {
        float z; ///< tip height on the floor
        std::uint32_t cell;
    };
    struct Found {
        std::vector<Ask> asks;
        std::vector<Foot> feet;
        std::vector<std::uint32_t> steep; ///< cells
    };
    class Bins;
    void mark_steep(std::span<const Found> found, std::size_t width, std::size_t cells);

    bool wanted(const TipTouch& t) const {
        return t.any && t.surface && t.slope() >= slopes_.lo && t.slope() <= slopes_.hi;
    }
    bool is_jump(const TipTouch& a, const TipTouch& b) const;
    bool is_foot(const TipTouch& high, const TipTouch& low, bool jump) const;
    void look_at(const TipTouch* const (&corner)[4], std::uint32_t cell, Found& found) const;
    void surface_ask(const TipTouch* const (&corner)[4], std::uint32_t cell, Found& found) const;
    std::vector<double> whole_levels(const Limits& limits, double bottom, const Progress& progress) const;
    void add_partial(std::vector<Level>& levels, const Progress& progress) const;
    void add_feet(std::vector<Level>& levels, const Limits& limits) const;

    const SlopeSteps& steps_;
    Interval slopes_;
    double spacing_;
    std::vector<Ask> asks_;
    std::vector<Foot> feet_;
    std::vector<char> steep_;
    double highest_ = -infinity;
};

} // namespace facetmill
