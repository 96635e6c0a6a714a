// Where the tool of a roughing operation may stand on a layer: the places whose axial lift over the part plus
// allowance is not above the layer. Exact against the mesh (axial_lift.h); undersides and what lies below
// them are out of the axis' reach. Shank and holder count where they could meet the part.
//
// Ends of cut and contours come from roots of the lift itself, on its free side. Between two places that were
// looked at, a cutter dips by no more than safe_spacing (lift_line.h) tells; by that much and what thinning
// takes, `margin`, the cutter is grown from the start. So no line that runs between free places, `spacing`
// apart, comes nearer to the part than the allowance.
#pragma once

#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/boundary_region.h"
#include "core/strategy/surface/contact_domain.h"
#include "core/strategy/surface/drive_frame.h"

#include "core/gouge/axial_lift.h"

#include <span>
#include <vector>

namespace facetmill {

class RoughReach {
public:
    /// `allowance` is all that is to stay, tessellation tolerance included; `index` of the part, or of the
    /// part already offset. Bodies whose lower face is never below `lowest_tip` plus the height of the part
    /// are left out.
    RoughReach(ContactIndexPtr index, const PlanContext& context, double allowance, double margin,
               double lowest_tip);

    /// Distance of places that are looked at along a line.
    double spacing() const { return spacing_; }
    double margin() const { return margin_; }

    struct Hints {
        LiftHint cutter;
        std::vector<LiftHint> bodies;
    };
    /// The lowest free tip height over a place; +infinity outside the operation's boundary.
    double tip_z(const Vec2& p, Hints& hints) const;
    void tip_z(std::span<const Vec2> points, std::span<double> heights, const Progress& progress) const;
    /// The same for the cutter alone.
    const AxialLift& cutter() const { return cutter_; }
    bool has_bodies() const { return !bodies_.empty(); }
    /// The highest of them on the line from a to b, or `least` if that is higher.
    double highest(const Vec2& a, const Vec2& b, Hints& hints, double least = -infinity) const;
    /// True when the whole line is free for tips at z.
    bool is_free(const Vec2& a, const Vec2& b, double z, Hints& hints) const;
    bool is_free(const Vec2& p, double z, Hints& hints) const;
    /// The farthest place from `free` towards `blocked` that is free at z, as a share of the line and to a
    /// quarter of the margin; the lifts at both are known.
    double last_free(const Vec2& free, double lift_free, const Vec2& blocked, double lift_blocked, double z,
                     Hints& hints) const;

private:
    struct Body {
        AxialLift lift;
        double base;
    };
    /// The tip at z or as much higher as shank and holder ask for.
    double raised(const Vec2& p, double z, Hints& hints) const;

    /// Where the boundary forbids the tip, with what may lie between places that are looked at.
    bool is_outside(const Vec2& p) const {
        return within_ && within_->region->depth(p) < within_->min_depth() + 0.5 * spacing_;
    }

    double margin_, spacing_;
    std::shared_ptr<const KeptWithin> within_; ///< null: everywhere
    AxialLift cutter_;
    std::vector<Body> bodies_;
};

/// Closed, or from one border of the grid to another; the free side is on the left.
struct FreeContour {
    std::vector<Vec2> points; ///< a closed one ends with its first
    bool closed = false;
    double length() const;
};

/// Lifts on a level grid that is turned with the drive lines, for contours.
class ReachGrid {
public:
    /// Over [lo, hi] in (u, v). Throws Error(limit_exceeded) beyond 20 million places.
    ReachGrid(const RoughReach& reach, const DriveFrame& frame, const Vec2& lo, const Vec2& hi,
              const Progress& progress);

    /// The borders of what is free at z, every point free; points within `thinned` of the margin beside what
    /// stays are left out.
    std::vector<FreeContour> contours(double z, const Progress& progress, double thinned = max_thinned) const;
    static constexpr double max_thinned = 0.5; ///< the other half is for what lies between places
    double lowest() const { return lowest_; }

    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }
    Vec2 place(std::size_t column, std::size_t row) const {
        return frame_.xy(lo_.x() + double(column) * step_.x(), lo_.y() + double(row) * step_.y());
    }
    double height(std::size_t column, std::size_t row) const { return heights_[at(column, row)]; }
    /// A place where shank or holder hold the tip up above where the cutter alone could be.
    struct HeldUp {
        Vec2 place;
        double cutter, tool; ///< lowest tips
    };
    const std::vector<HeldUp>& held_up() const { return held_up_; }

private:
    std::size_t at(std::size_t column, std::size_t row) const { return row * columns_ + column; }

    const RoughReach& reach_;
    DriveFrame frame_;
    Vec2 lo_, step_;
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<double> heights_;
    std::vector<HeldUp> held_up_;
    double lowest_ = infinity;
};

/// Lifts along one drive line, and what of it is free on a layer.
class ReachLine {
public:
    ReachLine(const RoughReach& reach, const DriveFrame& frame, double v, double u0, double u1);

    double v() const { return v_; }
    /// Ranges of u that are free at z, in order; their ends are roots of the lift, or the line's own.
    std::vector<Interval> free(double z, RoughReach::Hints& hints) const;
    double lowest() const { return lowest_; }

private:
    const RoughReach& reach_;
    DriveFrame frame_;
    double v_, u0_, step_;
    std::vector<double> heights_;
    double lowest_ = infinity;
};

/// The polyline without the points that it passes within `beside` when they are left out. Ends stay.
std::vector<Vec2> thinned_route(const std::vector<Vec2>& route, double beside);
std::vector<Vec3> thinned_route(const std::vector<Vec3>& route, double beside);

} // namespace facetmill
