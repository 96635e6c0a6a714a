// A pass while the step-over is sought: its contacts with their postures and widths, and what these come to
// bin by bin along the travel.
#pragma once

#include "core/strategy/five_axis/contact_widths.h"

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

struct EstimatedPass {
    long plane = 0;
    double v = 0;
    int travel = 1;
    std::vector<SurfaceLine> lines;
    std::vector<std::array<bool, 2>> cut_short; ///< per line: its first, last end is not the surface's
    std::vector<std::vector<EstimatedContact>> contacts; ///< per line, in the order of growing s
    /// Per bin of u: the smallest widths; +inf where nothing is asked, 0 where the pass does not come.
    std::vector<double> width_lo, width_hi;
    std::vector<double> end_lo, end_hi; ///< per bin, where the width is +inf: as far as is answered for
    std::vector<bool> comes;
    std::vector<bool> unfree; ///< per bin: some contact has no posture
    /// Where along the travel a larger step asked for most in vain, while this one was sought.
    double hardest_u = std::numeric_limits<double>::quiet_NaN();
};

/// Neighbouring bins of u; `beyond`: how far a partial pass goes on beyond them, mm.
struct BinRange {
    std::size_t first = 0, last = 0;
    double beyond = 0;
};

/// The whole part along the travel, divided into bins of u of equal width.
class TravelBins {
public:
    explicit TravelBins(const FiveAxisField& field);

    std::size_t count() const { return count_; }
    double width() const { return width_; }
    double begin(std::size_t bin) const { return lo_ + double(bin) * width_; }
    /// The bin of u; before and beyond the part the first and the last one.
    std::size_t at(double u) const;
    BinRange all() const { return {0, count_ - 1, 0}; }

private:
    double lo_ = 0, width_ = 0;
    std::size_t count_ = 0;
};

class PassEstimator {
public:
    /// Strips narrower than `leave`, mm on the surface, are left to others.
    PassEstimator(const FiveAxisField& field, double leave);

    /// A pass over the surface within some bins, when the pass before is `gap` (mm) away.
    EstimatedPass estimate(long plane, int travel, double gap, const BinRange& within,
                           const Progress& progress) const;

    /// What tells of a pass, before all of it is known, that it is not wanted. It never changes a pass.
    struct Refusal {
        std::function<bool(const EstimatedPass&)> lines; ///< by its lines, before its contacts
        /// By contacts of the pass that are known, each given once; those first that lie in bins where
        /// `likely` is larger. Called by one thread.
        std::function<bool(const EstimatedPass&, std::span<const EstimatedContact>)> contacts;
        std::vector<double> likely; ///< per bin of u
    };
    /// The same pass; nothing where it is refused.
    std::optional<EstimatedPass> estimate(long plane, int travel, double gap, const BinRange& within,
                                          const Refusal& refusal, const Progress& progress) const;

    const TravelBins& bins() const { return bins_; }
    /// From and to which u a pose that touches at `u` reaches the borders of its strip: there its widths
    /// count.
    std::array<double, 2> cleared(double u, int travel) const;
    double behind() const { return behind_; } ///< how far behind its contact it does so at most, mm
    double min_width() const { return 0.5 * smallest_; } ///< that a contact is taken to have to one side
    double smallest_step() const { return smallest_; }
    double largest_step() const { return largest_; }

private:
    /// Lines of the pass's plane within some bins.
    void cut_lines(EstimatedPass& pass, const BinRange& within) const;
    void place_contacts(EstimatedPass& pass) const;
    /// Finds contacts of all lines, block by block, until they refuse the pass. True where they do.
    bool is_refused(EstimatedPass& pass, double gap, const Refusal& refusal, const Progress& progress) const;
    /// Finds the contacts of all lines. Returns those half-way between contacts that are far apart: there the
    /// strip has to be as wide.
    std::vector<EstimatedContact> find_contacts(EstimatedPass& pass, double gap,
                                                const Progress& progress) const;
    /// Takes down the widths at the ends of a pass to those it has where it goes on beyond them.
    void answer_beyond_ends(EstimatedPass& pass, double gap) const;
    void spread_over_bins(EstimatedPass& pass, const std::vector<EstimatedContact>& between) const;

    const FiveAxisField& field_;
    ContactWidths widths_;
    TravelBins bins_;
    double smallest_ = 0, largest_ = 0, behind_ = 0, ahead_ = 0;
};

} // namespace facetmill
