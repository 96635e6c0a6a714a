#include "core/strategy/five_axis/unfree_points.h"

#include <algorithm>

namespace facetmill {

namespace {

/// What keeps the postures of a point that come nearest to being free: free but for the machine, then low
/// enough but for what the tool hits. Nearly every point has postures that leave too much.
PostureBlock decisive_block(const CSpace& space) {
    std::array<std::size_t, 8> count{};
    for (const PostureBlock b : space.block)
        ++count[std::size_t(b)];
    const auto any = [&](PostureBlock b) { return count[std::size_t(b)] > 0; };
    if (any(PostureBlock::free)) return PostureBlock::free;
    if (any(PostureBlock::machine)) return PostureBlock::machine;
    PostureBlock decisive = PostureBlock::lift;
    std::size_t most = 0;
    for (const PostureBlock b :
         {PostureBlock::local, PostureBlock::global, PostureBlock::shank, PostureBlock::holder})
        if (count[std::size_t(b)] > most) {
            most = count[std::size_t(b)];
            decisive = b;
        }
    return decisive;
}

} // namespace

void UnfreePoints::add(const CSpace& space) {
    ++count_;
    ++blocked_[std::size_t(decisive_block(space))];
}

void UnfreePoints::add(const UnfreePoints& others) {
    count_ += others.count_;
    narrowed_ += others.narrowed_;
    for (std::size_t b = 0; b < blocked_.size(); ++b)
        blocked_[b] += others.blocked_[b];
}

std::string UnfreePoints::main_cause(Finish5Settings::PostureChoice method) const {
    const auto worst = std::max_element(blocked_.begin(), blocked_.end()) - blocked_.begin();
    switch (PostureBlock(worst)) {
    case PostureBlock::free:
        return method == Finish5Settings::PostureChoice::global
                   ? "the free postures are too far from those of the neighbours: allow a larger turn limit"
                   : "other postures would be free than this way of choosing tries: choose them by global";
    case PostureBlock::local:
        return "the part close to the contact point stands in the cutter's way: use a smaller tool there";
    case PostureBlock::global:
        return "the part elsewhere stands in the cutter's way: use a smaller or longer tool there, or wider "
               "limits";
    case PostureBlock::shank:
        return "the shank would hit the part: use a longer or thinner tool";
    case PostureBlock::holder:
        return "the holder would hit the part: use a longer tool or a smaller holder";
    case PostureBlock::machine:
        return "the machine's axes do not reach: turn the part or take another machine";
    default:
        return "the cutter leaves more than the tolerance: use a smaller step-over or tool";
    }
}

} // namespace facetmill
