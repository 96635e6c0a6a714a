// The contours of a level: where an upright cutter, its tip at that height, touches and may not go farther.
// Millimetres, part coordinates.
//
// A place is free at a height where the axial lift is not above it: the cutter may stand there, and go
// straight up. The contour is the border of what is free. Where it crosses the lines of the field's grid it
// is found by halving between a free place and one that is not, asked of the contact kernel; what lies
// between two such places is divided until a free place is known at least as often as `spacing` asks
// (safe_spacing: the round cutter passes what is between two free places by no more than the tolerance), with
// the border no farther beside the straight line than may be.
#pragma once

#include "core/strategy/surface/lift_line.h"
#include "core/strategy/waterline/level_choice.h"

namespace facetmill {

struct ContourPlace {
    Vec2 at;            ///< free
    bool joined = true; ///< the tool may go straight to it from the place before
};

/// What is too high lies to the left of its course.
struct Contour {
    std::vector<ContourPlace> places;
    bool closed = false; ///< goes on from the last place to the first
};

class ContourFinder {
public:
    /// `tolerance`: spacing as safe_spacing says; `above`: how far beside the straight line the border may
    /// be.
    ContourFinder(const AxialLift& lift, const LevelField& field, const LevelChoice& choice,
                  const LineTolerance& tolerance)
        : lift_(lift), field_(field), choice_(choice), tolerance_(tolerance) {}

    /// What lies in or beside steep cells; of a partial level only what lies in or beside its own. Any thread
    /// may ask.
    std::vector<Contour> contours(const Level& level, const Progress& progress) const;

private:
    struct Chain {
        std::vector<std::uint32_t> edges;
        bool closed = false;
    };
    /// A height, and what is remembered from place to place.
    struct At {
        double z;
        LiftHint hint;
        const Progress& progress;
        double slope = 0; ///< of the lift across the border, where one was found last; 0: not known
    };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> steps(double z, const Progress& progress) const;
    std::vector<Chain> chains(double z, const Progress& progress) const;
    static std::vector<Chain> cut_to(std::vector<Chain> chains, const std::function<bool(std::uint32_t)>& in);
    Vec2 crossing(std::uint32_t edge, At& at) const;
    Vec2 border(Vec2 free, double free_z, Vec2 blocked, double blocked_z, At& at) const;
    void divide(const Vec2& a, const Vec2& b, int depth, At& at, std::vector<ContourPlace>& out) const;
    std::optional<Vec2> beside(const Vec2& a, const Vec2& b, bool middle_free, double middle_z, At& at) const;
    double tip_z(const Vec2& p, At& at) const { return lift_.tip_z(p.x(), p.y(), at.hint); }

    const AxialLift& lift_;
    const LevelField& field_;
    const LevelChoice& choice_;
    LineTolerance tolerance_;
};

} // namespace facetmill
