// Step-over: how far apart two neighbouring drive planes may be, from the cusps that the cutter really
// leaves.
//
// Lu (3.21-3.33, 3.53-3.58) cuts the surface by a plane across the drive plane at every contact point, takes
// the height of the cutter's section over it at a quarter of the diameter, and scales: an estimate with a
// safety factor of 0.9, for one side of the gap at a time. Here the gap is judged as a whole: for tips
// between the two planes the axial lift gives the contact point that such a tip would cut; from there, along
// the normal, the distance to the nearer of the two *swept* cutters is the cusp left at that point
// (CutterCover::ray_entry). The largest over the gap is its cusp, for any cutter and any surface, both
// neighbours included. The step is then as large as the tolerance allows, within a hundredth. Points that no
// tip between the planes could cut (narrow valleys) are no fault of the step and do not count; but where the
// contact jumps from one flank of a hollow to the other, both flanks are looked at a little way into it, as
// far as the cutter that touches both would leave a quarter of what is allowed.
//
// A wall, upright or nearly so, is met by a jump of the lift between neighbouring tips; a point halfway down
// the jump stands for it. So a wall along the passes gets one pass within the tolerance of it, and a round
// wall passes as close together as its cusps need.
#pragma once

#include "core/mesh/geometry.h"
#include "core/strategy/surface/contact_domain.h"
#include "core/strategy/surface/lift_line.h"

#include <memory>
#include <vector>

namespace facetmill {

/// The tip's way in one drive plane.
struct DriveLine {
    double v = 0;
    /// How far before and behind the plane places are that it is to cut: its ends lie where the domain ends
    /// in this strip (a slanted border is met by each plane at another u).
    double back = 0, ahead = 0;
    std::vector<std::vector<LinePoint>> runs; ///< s is u; one per piece of the domain, in order
};

struct StepOverInput {
    const Mesh* mesh = nullptr;
    ContactIndexPtr contact;
    const AxialLift* lift = nullptr;
    const CutterCover* cover = nullptr;
    const ContactDomain* domain = nullptr;
    DriveFrame frame;
    double allowance = 0; ///< all that is left along the normal, as in `lift`
    double floor = 0;     ///< of tip heights
    double cusp = 0.05;   ///< largest allowed
    double merge = 0;     ///< gaps of the domain up to this are passed over
};

class StepOver {
public:
    explicit StepOver(const StepOverInput& input);

    /// Share of a step that a line on either side of it reaches into it: half, and a little more, so that the
    /// two overlap where a slanted border lies half-way between them.
    static constexpr double reach_share = 0.55;

    /// The tip's way at v, roughly (to an eighth of the cusp), over all of the domain from `back` before v to
    /// `ahead` behind it.
    DriveLine line(double v, double back, double ahead, const Progress& progress) const;
    /// Ranges of u of a line.
    std::vector<Interval> ranges(double v, double back, double ahead) const;

    /// Largest cusp between two neighbouring lines; without `a` (or `b`), between the border v = edge and `b`
    /// (`a`).
    double worst_cusp(const DriveLine* a, const DriveLine* b, double edge, const Progress& progress) const;

    struct Step {
        DriveLine line;
        double cusp = 0;
        bool satisfied = true; ///< false: even the smallest step leaves more than allowed
    };
    /// The farthest line after `a` (nullptr: after the border at domain.lo()) that leaves at most the allowed
    /// cusp.
    Step next(const DriveLine* a, const Progress& progress);

    double allowed_cusp() const { return in_.cusp; }
    double smallest_step() const { return smallest_; }
    double largest_step() const { return largest_; }

private:
    struct Sample {
        Vec3 point, normal;
        double tip_z = 0;
        bool valid = false;
    };
    Sample sample(double u, double v) const;
    double entry(const DriveLine* line, double u, const Vec3& p, const Vec3& n) const;
    double height_on(const DriveLine& line, double u) const;
    double left_at(const DriveLine* a, const DriveLine* b, double u, const Sample& s) const;
    /// Largest cusp at contacts of tips between two tips at u whose contacts are far apart, or 0.
    double between(const DriveLine* a, const DriveLine* b, double u, double v0, const Sample& s0, double v1,
                   const Sample& s1, double gap, int depth) const;
    /// What stays on both flanks of a hollow, at u and v, beside the contacts of the cutter that touches
    /// both: no tip touches there, but it would leave less.
    double hollow(const DriveLine* a, const DriveLine* b, const Sample& s0, const Sample& s1, double u,
                  double v) const;
    double wall(const DriveLine* a, const DriveLine* b, Vec2 from, Vec2 to, double z_from, double z_to) const;

    StepOverInput in_;
    LiftField field_;
    std::unique_ptr<AxialLift> surface_; ///< of a needle: the part seen from above
    bool sharp_ = false;                 ///< the corner of the profile is sharp, or nearly so
    double grid_ = 1, level_ = 1, smallest_ = 0, largest_ = 0, guess_ = 0;
};

} // namespace facetmill
