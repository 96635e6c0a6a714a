// The side feed: how far the tool may advance in a turn (or turn between lengthwise lines), from the cusps
// that it leaves on the part as it is there. Millimetres, radians.
//
// At many angles the tip's way along the axis is followed once, with its contacts. Two cutters that stand a
// side feed apart at such an angle leave, over each contact of the tips between them, the distance along the
// normal to the nearer of the two: the cusp at that place, slope and local radius included. Jasra has a
// constant side feed from the user. The sides of the cutters' sweeps are not counted, so that the cusp is
// rather over- than underestimated. What no tip between them would touch does not count.
//
// On a shoulder that faces along the axis the allowed feed is only as long as the cusp: feeds change slowly
// (lipschitz), so that a helix grows finer towards it and coarser behind it, and never stands still.
#pragma once

#include "core/strategy/lathe_line.h"

namespace facetmill {

class SideFeed {
public:
    /// `across_turns`: the feed along the axis; else that between lengthwise lines, radians. Places between
    /// `from` and `to` along the axis. `cusp`: allowed; `chord`: of the path's motions.
    SideFeed(const LatheField& field, bool across_turns, double from, double to, double cusp,
             const Progress& progress);

    /// The largest advances that leave no more than the cusp, anywhere between two lines that start at `a`
    /// or up to one advance behind it; changes by at most half of the way. Call measure() first.
    double allowed(double a) const;
    /// Fills what allowed() says. Cancelled within 20 ms.
    void measure(const Progress& progress);
    /// Largest cusp left by a constant advance, mm; infinity where it leaves places uncut.
    double cusp_of(double advance, const Progress& progress) const;

    /// Where even the smallest advance leaves more than the cusp: share of the places looked at.
    double unsatisfied() const { return unsatisfied_; }
    double smallest() const { return smallest_; }
    double largest() const { return largest_; }

private:
    struct Line {
        std::vector<double> at; ///< along the way across, rising
        std::vector<LathePoint> points;
    };
    LathePlace place(const Line& line, double at) const;
    CutterLocation tip(const Line& line, double at) const;
    double left_over(const CutterLocation& tool, const CutterContact& cc, double limit) const;
    /// Largest cusp between cutters at a and b of one line.
    double cusp(const Line& line, double a, double b, double enough) const;
    double advance_at(double a, const Progress& progress);

    const LatheField& field_;
    bool across_turns_;
    double from_, to_, cusp_, largest_ = 0, smallest_ = 0, per_length_ = 1, unsatisfied_ = 0;
    double last_ = 0;
    std::vector<Line> lines_;
    std::vector<double> at_, advance_; ///< what measure() found, made slow
};

} // namespace facetmill
