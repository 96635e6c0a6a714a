// Partial passes. Full passes lie as far apart as makes least travel, and where the widths of two of them do
// not add up to the gap (tilted_stepover.h) partial passes between them, over the bins of u where they are
// wanted. Partial passes may have partial passes between them.
#pragma once

#include "core/strategy/five_axis/tilted_stepover.h"

#include <deque>
#include <optional>
#include <vector>

namespace facetmill {

struct PartialPass {
    EstimatedPass pass;
    BinRange bins; ///< where it is wanted
    /// Where its strip begins and ends, per bin; its own plane where it is not wanted.
    std::vector<double> border_lo, border_hi;
};

/// What lies between a full pass and the next one.
struct PassGap {
    std::optional<EstimatedPass> next; ///< none: what is left up to the part's border
    std::deque<PartialPass> partial;   ///< in the order of their planes
    bool satisfied = true;             ///< false: something above the tolerance stays
    /// Per bin: where the strip of the pass before the gap ends, and that of the next one begins.
    std::vector<double> border_lo, border_hi;
};

class PartialPasses {
public:
    /// `turns`: every pass travels against the one before. `min_gain`: the share of the travel that partial
    /// passes have to save; where they do not, the next full pass is as far away as needs none. Where they
    /// do, they come as near to contacts without a posture as the full passes would have.
    PartialPasses(const TiltedStepOver& stepover, bool turns, double min_gain = 0)
        : stepover_(stepover), field_(stepover.field()), bins_(stepover.bins()), turns_(turns),
          min_gain_(min_gain), smallest_(stepover.passes().smallest_step()),
          largest_(stepover.passes().largest_step()) {}

    /// The next full pass after `last`, so far away that as little as possible is travelled per width, and
    /// the partial passes between the two; `usual` is where the search starts, mm.
    PassGap next(const EstimatedPass& last, double usual, const Progress& progress);

private:
    using Step = TiltedStepOver::Step;

    /// The same without partial passes.
    Step whole_step(const EstimatedPass& last, const EstimatedPass* limit, const BinRange& within,
                    double usual, const Progress& progress) const;
    /// Whether partial passes could save the least gain beside a pass after `last` that needs none.
    bool may_gain(const EstimatedPass& last, const EstimatedPass& whole) const;
    /// Whether nothing is asked for between two passes (nullptr: the part's border).
    bool fits(const EstimatedPass& a, const EstimatedPass* b, std::size_t bin) const;
    bool fits(const EstimatedPass& a, const EstimatedPass* b, const BinRange& within) const;
    /// Where two passes leave too much between them, as ranges for partial passes.
    std::vector<BinRange> narrow_ranges(const EstimatedPass& a, const EstimatedPass* b,
                                        const BinRange& within) const;
    /// How many partial passes a bin between two passes asks for, about.
    double partial_count(const EstimatedPass& a, const EstimatedPass* b, std::size_t bin) const;
    /// What the partial passes between two passes travel, mm.
    double partial_travel(const EstimatedPass& a, const EstimatedPass* b, const BinRange& within) const;
    /// How many of them leave nothing in a gap where the strips beside it are so wide, mm.
    double passes_in(double gap, double width) const {
        return std::max(std::ceil(gap / std::max(width, smallest_)) - 1, 0.0);
    }
    /// What is known of a pass in the plane v after `last` while contacts of it are found.
    struct Found {
        double v = 0, own_travel = 0;
        std::vector<double> width_lo; ///< per bin: no more than this; +inf: nothing is known
    };
    /// The least that its partial passes can travel, mm, and the least share of the travel that they can be
    /// asked for on. Sets `likely` where they are.
    std::array<double, 2> min_partial(const EstimatedPass& last, const Found& found, const BinRange& within,
                                      std::vector<double>& likely) const;
    /// What a pass travels itself, mm.
    double own_travel(const EstimatedPass& pass) const;
    /// What a pass after `last` travels with the partial ones before it, mm for each mm of width.
    double travel_per_width(const EstimatedPass& last, const EstimatedPass& next,
                            const BinRange& within) const;
    /// What share of the travel two passes ask for partial ones on, these as far as they go beyond it.
    double partial_share(const EstimatedPass& a, const EstimatedPass& b, const BinRange& within) const;
    /// The pass after `last` that makes least travel per width, itself and the partial ones; none: these
    /// alone up to `limit` are less. `whole`: the pass that asks for none.
    std::optional<EstimatedPass> cheapest(const EstimatedPass& last, const EstimatedPass* limit,
                                          const BinRange& within, Step whole, double usual,
                                          const Progress& progress) const;
    /// Adds partial passes between `a` and `b` to the gap; `depth`: how many partial passes it is within.
    void fill(const EstimatedPass& a, const EstimatedPass* b, const BinRange& within, int depth, PassGap& gap,
              const Progress& progress) const;
    void find_borders(const EstimatedPass& last, PassGap& gap) const;

    const TiltedStepOver& stepover_;
    const FiveAxisField& field_;
    const TravelBins& bins_;
    bool turns_;
    double min_gain_;
    double smallest_, largest_;    ///< steps, mm
    double unfree_gap_ = infinity; ///< between passes beside contacts without a posture, at most, mm
};

} // namespace facetmill
