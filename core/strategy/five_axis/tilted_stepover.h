// Step-over for tilted cutters (Lu 3.22-3.33, made exact): how far apart two drive planes may lie.
//
// Lu estimates the posture by CM2, takes the height of the cutter's rim over the surface at a quarter of the
// diameter, and scales by a safety factor, for one side of the gap at a time. Here a contact point's width on
// a side is the largest distance at which its estimated posture (contact_widths.h), lifted clear of the part,
// still holds a point of the surface's line raised by what may stay (CSpaceBuilder::top). The next plane is
// the farthest at which everywhere along the travel the widths of the two passes, one to each side, add up to
// the gap; where they meet is the border of their strips.
#pragma once

#include "core/strategy/five_axis/estimated_pass.h"

#include <vector>

namespace facetmill {

class TiltedStepOver {
public:
    /// Strips narrower than `leave`, mm on the surface, do not ask for passes closer together: what stays
    /// between is left to others.
    explicit TiltedStepOver(const FiveAxisField& field, double leave = 0);

    EstimatedPass estimate(long plane, int travel, const Progress& progress) const {
        return passes_.estimate(plane, travel, 0, bins().all(), progress);
    }
    /// With the postures that clear the widest strips, whatever the neighbours need.
    EstimatedPass widest(long plane, int travel, const Progress& progress) const {
        return passes_.estimate(plane, travel, passes_.largest_step(), bins().all(), progress);
    }

    struct Step {
        EstimatedPass pass;
        bool satisfied = true; ///< false: even the smallest step leaves too much somewhere
    };
    /// The farthest plane after `last` (nullptr: after the border of the part) that leaves nothing above the
    /// tolerance between; `usual` is where the search starts, mm.
    Step next(const EstimatedPass* last, int travel, double usual, const Progress& progress) const {
        return next(last, travel, usual, nullptr, bins().all(), progress);
    }
    /// The same within some bins, and before the pass `limit` (nullptr: the part's border).
    Step next(const EstimatedPass* last, int travel, double usual, const EstimatedPass* limit,
              const BinRange& within, const Progress& progress) const;

    /// Whether nothing above the tolerance stays between two neighbouring passes; nullptr: the part's border.
    bool fits(const EstimatedPass* a, const EstimatedPass* b, const BinRange& within) const;
    bool fits(const EstimatedPass* a, const EstimatedPass* b, std::size_t bin) const;
    bool reaches_border(const EstimatedPass& last) const { return fits(&last, nullptr, bins().all()); }

    /// Border of the strips of two neighbouring passes, per bin of u.
    std::vector<double> borders(const EstimatedPass& a, const EstimatedPass& b) const;
    double border(const EstimatedPass& a, const EstimatedPass& b, std::size_t bin) const;

    const FiveAxisField& field() const { return field_; }
    const PassEstimator& passes() const { return passes_; }
    const TravelBins& bins() const { return passes_.bins(); }

private:
    /// By how much, mm, the strips of `last` and of a contact of a pass in the plane v miss each other, where
    /// they do so most; -inf where nothing asks them to meet.
    double missing(const EstimatedPass& last, double v, int travel, const EstimatedContact& contact,
                   const BinRange& within) const;
    bool surface_between(double v0, double v1, std::size_t bin) const;

    const FiveAxisField& field_;
    PassEstimator passes_;
    long look_; ///< planes between two looks for the surface
};

} // namespace facetmill
