// Partial passes. A piece of a part is cut otherwise than a whole one: full passes as far apart as makes
// least travel, and where the widths of two of them do not add up to the gap (tilted_stepover.h) partial
// passes between them, over the bins of u where they are wanted. Partial passes may have partial passes
// between them.
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
    /// `turns`: every pass travels against the one before.
    PartialPasses(const TiltedStepOver& stepover, bool turns)
        : stepover_(stepover), field_(stepover.field()), bins_(stepover.bins()), turns_(turns),
          smallest_(stepover.passes().smallest_step()), largest_(stepover.passes().largest_step()) {}

    /// The next full pass after `last`, so far away that as little as possible is travelled per width, and
    /// the partial passes between the two; `usual` is where the search starts, mm.
    PassGap next(const EstimatedPass& last, double usual, const Progress& progress) const;

private:
    /// Where two passes leave too much between them, as ranges for partial passes.
    std::vector<BinRange> narrow_ranges(const EstimatedPass& a, const EstimatedPass* b,
                                        const BinRange& within) const;
    /// What the partial passes between two passes travel, mm.
    double partial_travel(const EstimatedPass& a, const EstimatedPass* b, const BinRange& within) const;
    /// What share of the travel two passes ask for partial ones on, these as far as they go beyond it.
    double partial_share(const EstimatedPass& a, const EstimatedPass& b, const BinRange& within) const;
    /// The pass after `last` that makes least travel per width, itself and the partial ones; none: these
    /// alone up to `limit` are less.
    std::optional<EstimatedPass> cheapest(const EstimatedPass& last, const EstimatedPass* limit,
                                          const BinRange& within, double usual,
                                          const Progress& progress) const;
    /// Adds partial passes between `a` and `b` to the gap; `depth`: how many partial passes it is within.
    void fill(const EstimatedPass& a, const EstimatedPass* b, const BinRange& within, int depth, PassGap& gap,
              const Progress& progress) const;
    void find_borders(const EstimatedPass& last, PassGap& gap) const;

    const TiltedStepOver& stepover_;
    const FiveAxisField& field_;
    const TravelBins& bins_;
    bool turns_;
    double smallest_, largest_; ///< steps, mm
};

} // namespace facetmill
