// What stands of the stock, as a tool of five axes meets it coming down its axis. Millimetres, part
// coordinates.
#pragma once

#include "core/strategy/tilt/standing_columns.h"

#include <vector>

namespace facetmill {

/// The columns of a stock field against the bodies of a tool, each a cylinder that reaches up its axis
/// without end, the cutter's end in steps: what is free here stays so all the way out. A column is taken with
/// all of its cell, so that more is met than stands there, never less; and less is taken away by a cut than
/// the tool does.
class TiltedStock {
public:
    /// `gap`: what the sides of the bodies keep from the stock; axes that lie lower than `lowest_axis_z` are
    /// not asked for.
    TiltedStock(const StockField& field, const Tool& tool, double cutter_radius, double gap);

    /// The tool has cut from one location to the next, tip and axis moving evenly.
    void cut(const CutterLocation& from, const CutterLocation& to);

    /// How far up its axis the tool has to be so that it is clear of the stock by `clearance` there and
    /// farther out; -inf where it meets nothing.
    double lift(const CutterLocation& at, double clearance) const;
    /// Whether a tool that has cut at a location may go out from it, and in to it, in a rapid: nothing stands
    /// where its bodies above the flutes are, nor behind them; where its flutes are it has cut, but for what
    /// stands beside the neck of an undercut cutter.
    bool free_behind(const CutterLocation& at) const;
    /// Whether a body above the flutes surely holds stock there: the middle of a cell, with all about it.
    bool holds_shank(const CutterLocation& at) const;
    /// Whether shank or holder may hold stock there. A body no wider than the cutter goes where that has cut,
    /// and its cells have all of the wall beside it: it does where it surely does.
    bool may_hold(const CutterLocation& at) const;

private:
    struct Body {
        double radius, height; ///< height: of its lower end above the tip
    };
    double lift(const CutterLocation& at, const std::vector<Body>& bodies, double gap, double enough) const;

    StandingColumns columns_;
    double gap_ = 0, step_ = 0; ///< step_: of the places at which cuts take away what stands
    std::vector<AxisCylinder> inner_;
    std::vector<Body> whole_, above_flutes_, narrow_, wide_,
        behind_; // behind_: what has to be free on the way out
};

} // namespace facetmill
