// Step-over for tilted cutters (Lu 3.22-3.33, made exact): how far apart two drive planes may lie.
//
// Lu estimates the posture by CM2, takes the height of the cutter's rim over the surface at a quarter of the
// diameter, and scales by a safety factor, for one side of the gap at a time. Here a contact point's width on
// a side is the largest distance at which its estimated posture, lifted clear of the part, still holds a
// point of the surface's line raised by what may stay (CSpaceBuilder::top). The estimated posture is the
// least inclined one, at yaw 0, that need hardly be lifted: CM2 as the part itself allows it. The next plane
// is the farthest at which everywhere along the travel the widths of the two passes, one to each side, add up
// to the gap; where they meet is the border of their strips.
//
// A piece of a part is cut otherwise: full passes as far apart as makes least travel, and where the widths do
// not add up to the gap partial passes between them, over the bins of u where they are wanted.
#pragma once

#include "core/strategy/five_axis/five_axis_field.h"

#include <deque>
#include <optional>

namespace facetmill {

/// A pass while the step-over is sought: its contacts, each with an estimated posture and two widths.
struct EstimatedPass {
    struct Contact {
        ContactPlace place;
        PostureValue posture;
        bool usable = false;               ///< some posture stays within the tolerance
        bool left = false;                 ///< its strip is too narrow to be worth it (`leave`)
        double width_lo = 0, width_hi = 0; ///< towards smaller and larger v; +inf: the surface ends before
        double end_lo = 0, end_hi = 0;     ///< where it ends, if it does
    };
    long plane = 0;
    double v = 0;
    int travel = 1;
    std::vector<SurfaceLine> lines;
    std::vector<std::array<bool, 2>> cut_short; ///< per line: its first, last end is not the surface's
    std::vector<std::vector<Contact>> contacts; ///< per line, in the order of growing s
    /// Per bin of u: the smallest widths; +inf where nothing is asked, 0 where the pass does not come.
    std::vector<double> width_lo, width_hi;
    std::vector<double> end_lo, end_hi; ///< per bin, where the width is +inf: as far as is answered for
    std::vector<bool> comes;
};

class TiltedStepOver {
public:
    /// Strips narrower than `leave`, mm on the surface, do not ask for passes closer together: what stays
    /// between is left to others.
    explicit TiltedStepOver(const FiveAxisField& field, double leave = 0);

    /// Neighbouring bins of u; `beyond`: how far a partial pass goes on beyond them, mm.
    struct Bins {
        std::size_t first = 0, last = 0;
        double beyond = 0;
    };

    EstimatedPass estimate(long plane, int travel, const Progress& progress) const {
        return estimate(plane, travel, 0, all(), progress);
    }
    /// With the postures that clear the widest strips, whatever the neighbours need.
    EstimatedPass widest(long plane, int travel, const Progress& progress) const {
        return estimate(plane, travel, largest_, all(), progress);
    }

    struct Step {
        EstimatedPass pass;
        bool satisfied = true; ///< false: even the smallest step leaves too much somewhere
    };
    /// The farthest plane after `last` (nullptr: after the border of the part) that leaves nothing above the
    /// tolerance between; `usual` is where the search starts, mm.
    Step next(const EstimatedPass* last, int travel, double usual, const Progress& progress) const {
        return next(last, travel, usual, nullptr, all(), progress);
    }
    /// The next plane after `last` where passes need not go all along the part, and the partial passes
    /// between the two, in order: so far away that as little as possible is travelled per width. Where a
    /// strip is narrow, partial passes make it up instead of all passes being close together there.
    struct PartialPass {
        EstimatedPass pass;
        Bins bins; ///< where it is wanted
    };
    struct Gap {
        std::optional<EstimatedPass> next; ///< none: what is left up to the part's border
        std::deque<PartialPass> partial;
        bool satisfied = true;
    };
    /// `turns`: every pass travels against the one before.
    Gap next_with_partial(const EstimatedPass& last, bool turns, double usual,
                          const Progress& progress) const;
    /// True when nothing above the tolerance stays between `last` and the part's border.
    bool reaches_border(const EstimatedPass& last) const;

    /// Border of the strips of two neighbouring passes, per bin of u.
    std::vector<double> borders(const EstimatedPass& a, const EstimatedPass& b) const;
    double border(const EstimatedPass& a, const EstimatedPass& b, std::size_t bin) const;
    std::size_t bin(double u) const;

    /// From and to which u a pose that touches at `u` reaches the borders of its strip: there its widths
    /// count.
    std::array<double, 2> cleared(double u, int travel) const;
    double smallest_step() const { return smallest_; }
    double largest_step() const { return largest_; }

private:
    Bins all() const { return {0, bins_ - 1, 0}; }
    /// Of the surface within some bins, where the pass before is `gap` (mm) away.
    EstimatedPass estimate(long plane, int travel, double gap, const Bins& within,
                           const Progress& progress) const;
    /// Before `limit` (nullptr: the part's border).
    Step next(const EstimatedPass* last, int travel, double usual, const EstimatedPass* limit,
              const Bins& within, const Progress& progress) const;
    /// Where two passes leave too much between them, as ranges for partial passes.
    std::vector<Bins> narrow_ranges(const EstimatedPass& a, const EstimatedPass* b, const Bins& within) const;
    /// That two passes ask for between them; mm.
    double partial_travel(const EstimatedPass& a, const EstimatedPass* b, const Bins& within) const;
    /// What of the way two passes ask for partial ones on, these as far as they go beyond it.
    double partial_share(const EstimatedPass& a, const EstimatedPass& b, const Bins& within) const;
    /// The pass after `last` that makes least travel per width, itself and the partial ones; none: these
    /// alone up to `limit` are less.
    std::optional<EstimatedPass> cheapest(const EstimatedPass& last, const EstimatedPass* limit,
                                          const Bins& within, bool turns, double usual,
                                          const Progress& progress) const;
    void fill(const EstimatedPass& a, const EstimatedPass* b, bool turns, const Bins& within, int depth,
              Gap& gap, const Progress& progress) const;
    void estimate(EstimatedPass::Contact& contact, double& lead, ToolLift::Hint& hint) const;
    /// Widths of its posture; where they are not enough for a gap (mm), of the one that comes nearest to
    /// that.
    void find_widths(EstimatedPass::Contact& contact, double gap, ToolLift::Hint& hint) const;
    /// Of neighbours on a line; postures and all.
    void find_widths(std::vector<EstimatedPass::Contact>& contacts, double gap,
                     const Progress& progress) const;
    /// Takes down the widths at the ends of a pass to those it has where it goes on beyond them.
    void answer_beyond_ends(EstimatedPass& pass, double gap) const;
    /// `a` or `b` may be nullptr: the part's border.
    bool fits(const EstimatedPass* a, const EstimatedPass* b, const Bins& within) const;
    bool fits(const EstimatedPass* a, const EstimatedPass* b, std::size_t bin) const;
    bool surface_between(double v0, double v1, std::size_t bin) const;

    const FiveAxisField& field_;
    double leave_, u_lo_, bin_, smallest_, largest_;
    double behind_, ahead_; ///< of a contact, along the travel, a pose clears its strip; mm
    std::size_t bins_;
    std::vector<double> yaws_; ///< that are tried where strips are narrow; none where postures have none
    long look_;                ///< planes between two looks at a width
};

} // namespace facetmill
