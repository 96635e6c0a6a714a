// The side feed: how far the tool may advance in a turn (or turn between lengthwise lines), from the cusps
// that it leaves on the part as it is there. Millimetres, radians.
//
// At many angles the tip's path along the axis is followed once, with its contacts. Two cutters that stand a
// side feed apart at such an angle leave, over each contact of the tips between them, the distance along the
// normal to the nearer of the two: the cusp at that place, slope and local radius included. Jasra has a
// constant side feed from the user. The sides of the cutters' sweeps are not counted, so that the cusp is
// rather over- than underestimated. What no tip between them would touch does not count.
//
// On a shoulder that faces along the axis the allowed feed is only as long as the cusp: feeds change slowly
// (lipschitz), so that a helix grows finer towards it and coarser behind it, and never stands still.
#pragma once

#include "core/strategy/lathe/lathe_line.h"

#include <array>
#include <span>

namespace facetmill {

/// An advance over the place `at` (along the axis, or an angle) may not be longer.
struct FeedLimit {
    double at = 0, advance = 0;
};

class SideFeed {
public:
    /// `across_turns`: the feed along the axis; else that between lengthwise lines, radians. Places between
    /// `from` and `to` along the axis. `cusp`: allowed; `chord`: of the path's motions.
    SideFeed(const LatheField& field, bool across_turns, double from, double to, double cusp,
             const Progress& progress);

    /// The largest advances that leave no more than the cusp, anywhere between two lines that start at `a`
    /// or up to one advance behind it; changes by at most half of the distance. Call measure() first.
    double allowed(double a) const;
    /// Fills what allowed() says.
    void measure(const Progress& progress);
    /// Shortens what allowed() says, after measure(): no advance that passes over a limit's place is longer.
    void limit(std::span<const FeedLimit> limits);
    /// Largest cusp left by a constant advance, mm; infinity where it leaves places uncut.
    double cusp_of(double advance, const Progress& progress) const;

    /// Where even the smallest advance leaves more than the cusp: share of the places looked at.
    double unsatisfied() const { return unsatisfied_; }
    double smallest() const { return smallest_; }
    double largest() const { return largest_; }

private:
    struct Line {
        std::vector<double> at; ///< places along the line, rising
        std::vector<LathePoint> points;
    };
    LathePlace place(const Line& line, double at) const;
    /// A cutter where it stands, and its frame.
    struct Stand {
        Vec3 tip, x, y, axis;
        Vec3 in_frame(const Vec3& v) const { return {v.dot(x), v.dot(y), v.dot(axis)}; }
    };
    Stand stand(const Line& line, double at) const;
    /// Height that two cutters leave over a contact, along its normal; `low` where that is no more than it.
    double left_over(const std::array<Stand, 2>& tools, const CutterContact& cc, double low) const;
    /// Largest cusp between cutters at a and b of one line.
    double cusp(const Line& line, double a, double b, double enough) const;
    double advance_at(double a, const Progress& progress);
    void slow();

    const LatheField& field_;
    bool across_turns_;
    double from_, to_, cusp_, largest_ = 0, smallest_ = 0, per_length_ = 1, unsatisfied_ = 0;
    double last_ = 0;
    std::vector<Line> lines_;
    std::vector<double> at_, advance_; ///< what measure() found, made slow
};

} // namespace facetmill
