// Partial lines: where two lines of a plan leave too much between them over ranges of u only, lines over just
// these ranges lie between (Wang 2005 has the like for five axes). Within a range they are placed as the
// lines themselves are, and leave what they may to partial lines of their own; so every gap between
// neighbours, wherever it is, has been found to keep the tolerance or is counted.
#pragma once

#include "core/strategy/finish3/stepover.h"

#include <optional>
#include <vector>

namespace facetmill {

struct PlannedLine {
    double v = 0, back = 0, ahead = 0; ///< as DriveLine has them
    std::optional<Interval> within;    ///< of a partial line: the range of u that asks for it
};

class PartialLines {
public:
    explicit PartialLines(const StepOver& stepover) : stepover_(stepover) {}

    /// Adds what lies between `a` and `b` over ranges that these leave too high.
    void fill(const DriveLine& a, const DriveLine& b, const std::vector<Interval>& ranges,
              const Progress& progress);

    /// Lines since they were last taken, in the order of their planes.
    std::vector<PlannedLine> take();
    std::size_t lines() const { return lines_.size(); } ///< since they were last taken
    /// The largest cusp that is left, of places that no step serves; lines beside such places.
    double cusp_max() const { return cusp_max_; }
    int unsatisfied() const { return unsatisfied_; }

private:
    void fill(const DriveLine& a, const DriveLine& b, const Interval& range, int depth,
              const Progress& progress);

    const StepOver& stepover_;
    std::vector<PlannedLine> lines_;
    double cusp_max_ = 0;
    int unsatisfied_ = 0;
};

} // namespace facetmill
