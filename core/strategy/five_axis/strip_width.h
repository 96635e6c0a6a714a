// How wide a strip a posture clears at a contact point, to one side of it: the largest distance across the
// travel at which the tool, lifted clear of the part, still holds a point of the surface's line raised by
// what may stay (CSpaceBuilder::top).
#pragma once

#include "core/strategy/five_axis/five_axis_field.h"

#include <array>
#include <optional>
#include <vector>

namespace facetmill {

/// Strips of one contact point. The lines beside it are cut once for all postures that are asked about.
class StripWidth {
public:
    /// What is used of a width, because the strip is to leave room for postures other than the one it is
    /// taken from.
    static constexpr double used_width = 0.95;

    StripWidth(const FiveAxisField& field, const ContactPlace& place)
        : field_(field), place_(place), look_(planes_apart(field)) {}

    /// Widths are not looked for beyond this, mm.
    static double max_width(const FiveAxisField& field);
    /// Lines are looked at every so many planes, those that are multiples of it: passes share their slices.
    static long planes_apart(const FiveAxisField& field);

    struct Width {
        double width = 0; ///< mm across the drive planes; +inf: the surface ends before
        double end = 0;   ///< how far off it ends, where it does
    };
    /// A posture as its strips ask for it.
    struct Standing {
        ToolPose pose; ///< not lifted
        double lead = 0, delta = 0;
    };
    Standing standing(const PostureValue& posture) const;
    /// `side`: -1 towards smaller v, +1 towards larger. The posture clear of the part.
    Width operator()(const Standing& at, int side);
    Width operator()(const PostureValue& posture, int side) { return (*this)(standing(posture), side); }
    /// False: that width is surely no larger than `width`. One line tells, where all up to it are there.
    bool may_exceed(const Standing& at, int side, double width);

    /// Whether the posture comes close enough to the pass's own line to clear it.
    bool clears_own_line(const PostureValue& posture);

private:
    struct Look {
        double v = 0;
        bool ends = false, holds = true; ///< the surface ends here; there is a line
        RaisedCurve line;
        CurveLift::Hint hint; ///< where the posture before touched the line
    };
    Look& look(int side, std::size_t number);
    /// How much farther a posture may be lifted until it holds no point of the line, mm; negative: it holds
    /// none. The exact value where its lift is up to `enough` then.
    double margin(const Standing& at, Look& line, double enough) const;
    /// Whether it holds one.
    bool holds(const Standing& at, Look& line) const;

    const FiveAxisField& field_;
    const ContactPlace& place_;
    long look_;
    std::array<std::vector<Look>, 2> looks_;
    std::optional<Look> own_; ///< the place's own line, once asked for
};

} // namespace facetmill
