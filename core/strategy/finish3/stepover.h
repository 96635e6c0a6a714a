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
// (cusp_field.h: what lines leave over a place; gap_cusp.h: the largest in a gap.)
//
// A wall, upright or nearly so, is met by a jump of the lift between neighbouring tips; a point halfway down
// the jump stands for it. So a wall along the passes gets one pass within the tolerance of it, and a round
// wall passes as close together as its cusps need.
//
// One steep spot would so bring two whole lines together. Where it pays, a line lies as far away as most of
// it allows, and what the two leave too high is told by ranges of u, for partial lines between
// (partial_lines.h).
#pragma once

#include "core/strategy/finish3/cusp_field.h"
#include "core/strategy/finish3/gap_cusp.h"

namespace facetmill {

class StepOver {
public:
    explicit StepOver(const StepOverInput& input);

    /// Share of a step that a line on either side of it reaches into it: half, and a little more, so that the
    /// two overlap where a slanted border lies half-way between them.
    static constexpr double reach_share = 0.55;

    /// The tip's path at v, roughly (to an eighth of the cusp), over all of the domain from `back` before v
    /// to `ahead` behind it, or what of that a partial line over `within` covers.
    DriveLine line(double v, double back, double ahead, const Interval* within,
                   const Progress& progress) const;
    /// Ranges of u of a line.
    std::vector<Interval> ranges(double v, double back, double ahead, const Interval* within) const;

    /// Largest cusp between two neighbouring lines; without `a` (or `b`), between the border v = edge and `b`
    /// (`a`).
    double worst_cusp(const DriveLine* a, const DriveLine* b, double edge, const Progress& progress) const;
    /// Ranges of u over which two lines leave more than allowed, of those in `within`.
    std::vector<Interval> left_between(const DriveLine& a, const DriveLine& b, const Interval& within,
                                       const Progress& progress) const;

    /// Whether there are any.
    bool leaves_any_between(const DriveLine& a, const DriveLine& b, const Interval& within,
                            const Progress& progress) const;

    /// Where the next line is looked for.
    struct Search {
        const DriveLine* a = nullptr;     ///< the line before; null: the border at domain.lo()
        double limit = 0;                 ///< v of the line or border that ends the search
        const Interval* within = nullptr; ///< only over this range of u
        double guess = 0;                 ///< step to begin with
        bool may_leave = false;           ///< some of it may be left to partial lines
    };
    struct Step {
        DriveLine line;
        double cusp = 0;            ///< the largest, where nothing is left to partial lines
        bool satisfied = true;      ///< false: even the smallest step leaves more than allowed
        std::vector<Interval> left; ///< ranges of u that ask for partial lines
    };
    /// The farthest line that leaves at most the allowed cusp or, where that may be left to partial lines,
    /// the one that makes least travel, with these, per width.
    Step next(const Search& search, const Progress& progress) const;
    double first_guess() const { return guess_; }
    /// How far a partial line goes beyond the range that asks for it, mm.
    double beyond() const { return beyond_share * in_.cover->radius(); }

    /// The part, with what must not be cut beside it.
    const Mesh& mesh() const { return in_.contact->mesh(); }
    double allowed_cusp() const { return in_.cusp; }
    double smallest_step() const { return smallest_; }
    double largest_step() const { return largest_; }

private:
    static constexpr double beyond_share = 0.25;
    struct Choice {
        double step = 0;
        bool leaves = false; ///< something to partial lines
    };

    Step attempt(const Search& search, const DriveLine*& a, DriveLine& longer, double d,
                 std::vector<CuspAt>& found, const Progress& progress) const;
    Step farthest(const Search& search, const Progress& progress) const;
    Choice cheapest_step(const std::vector<CuspAt>& found, double step, double cap) const;
    std::vector<Interval> left_of(const std::vector<CuspAt>& found, const Interval* within) const;
    double cap_of(const Search& search) const;
    double join() const { return (2 * beyond_share + 1) * in_.cover->radius(); }

    StepOverInput in_;
    CuspField field_;
    double smallest_ = 0, largest_ = 0, guess_ = 0;
};

} // namespace facetmill
