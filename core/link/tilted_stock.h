// What stands of the stock, as a tool of five axes meets it coming down its axis. Millimetres, part
// coordinates.
#pragma once

#include "core/setup/motion.h"
#include "core/setup/tool.h"
#include "core/strategy/surface/stock_field.h"

#include <vector>

namespace facetmill {

/// The columns of a stock field against the bodies of a tool, each a cylinder that reaches up its axis
/// without end: what is free here stays so all the way out. A column is taken with all of its cell, and the
/// cutter as if it were flat, so that more is met than stands there, never less.
class TiltedStock {
public:
    /// `gap`: what the sides of the bodies keep from the stock; axes that lie lower than `lowest_axis_z` are
    /// not asked for.
    TiltedStock(StockField field, const Tool& tool, double cutter_radius, double gap);

    /// How far up its axis the tool has to be so that it is clear of the stock by `clearance` there and
    /// farther out; -inf where it meets nothing.
    double lift(const CutterLocation& at, double clearance) const;
    /// Whether a tool that has cut at a location may go out from it, and in to it, in a rapid: nothing stands
    /// where its bodies above the flutes are, nor behind them; where its flutes are it has cut, but for what
    /// stands beside the neck of an undercut cutter.
    bool free_behind(const CutterLocation& at) const;
    /// Whether a body above the flutes surely holds stock there: the middle of a cell, with all about it.
    bool holds_shank(const CutterLocation& at) const;

private:
    struct Body {
        double radius, height; ///< height: of its lower end above the tip
    };
    double lift(const CutterLocation& at, const std::vector<Body>& bodies, double gap, double enough) const;

    StockField field_;
    double bottom_ = 0, highest_ = 0, gap_ = 0;
    std::vector<Body> whole_, above_flutes_, behind_; // behind_: what has to be free on the way out
};

} // namespace facetmill
