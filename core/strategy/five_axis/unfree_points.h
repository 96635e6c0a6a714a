// Contact points that have no posture, and what mostly keeps them from having one: the advice that a plan
// gives.
#pragma once

#include "core/cspace/cspace.h"
#include "core/strategy/five_axis/finish5.h"

#include <array>
#include <string>

namespace facetmill {

class UnfreePoints {
public:
    void add(const CSpace& space);
    void add(const UnfreePoints& others);

    /// A point that is cut, and not all of its strip.
    void add_narrowed() { ++narrowed_; }

    std::size_t count() const { return count_; }
    std::size_t narrowed() const { return narrowed_; }
    /// What is decisive at most of them, and what to do about it. `method`: how postures were chosen.
    std::string main_cause(Finish5Settings::PostureChoice method) const;

private:
    std::size_t count_ = 0, narrowed_ = 0;
    std::array<std::size_t, 8> blocked_{}; ///< points by PostureBlock
};

} // namespace facetmill
