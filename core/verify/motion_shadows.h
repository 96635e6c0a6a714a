// Over which places across a fixed tool axis the motions of a program come, and how low.
//
// Lines that run far through stock that was left meet no motion for most of their length. Seen along the axis
// such a line runs over some cells of a grid; of each cell the motions are known that may be lowest over it,
// in the order of their lowest places, and those that are higher than the line there are not asked. A motion
// that is higher over a cell than another one at its highest place is not kept there: whatever comes into it
// over the cell is in the other one as well.
#pragma once

#include "core/base/progress.h"
#include "core/verify/probes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace facetmill {

class MotionShadows {
public:
    /// Takes the motions of `probes`. Knows no line where axes turn.
    MotionShadows(const MotionProbes& probes, const Progress& progress);
    /// Whether it knows all motions that may come lowest on p + t n, t in [0, length]: n is a unit vector,
    /// lengths in mm.
    bool know(const Vec3& p, const Vec3& n, double length) const;
    /// Does what MotionProbes::lower does, for a line that it knows up to the probe's value. `probes` are
    /// those that this was made of.
    bool lower(const MotionProbes& probes, const Vec3& p, const Vec3& n, LineProbe& probe,
               RecentSweeps& recent) const;

private:
    class Builder;
    struct Shadow {
        double low; ///< no place of the motion over the cell is lower, along the axis
        Index motion;
    };
    /// The part of a line over one cell.
    struct Passage {
        std::span<const Shadow> shadows;
        double from, to; ///< t
        double top;      ///< along the axis, nothing of it is higher
    };
    /// Calls visit(passage) for the cells that the line runs over between two t, one after the other, and
    /// goes on up to what it returns.
    template <class Visit>
    void walk(const Vec3& p, const Vec3& n, double from, double to, const Visit& visit) const;

    Mat3 frame_ = Mat3::Identity();  ///< to the tool's
    Vec2 lo_ = Vec2::Zero();         ///< of the grid, across the axis
    double cell_ = 1;                ///< mm
    int columns_ = 0, rows_ = 0;     ///< 0: nothing is known
    double ceiling_ = 0;             ///< up to here, along the axis, a place over a motion is in it
    std::vector<std::size_t> first_; ///< of cell (i, j) at i + columns_ j, in `shadows_`; one more than cells
    std::vector<Shadow> shadows_;    ///< of each cell the lowest first
};

} // namespace facetmill
