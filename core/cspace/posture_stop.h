// What a path through configuration spaces goes over. Internal to this room.
#pragma once

#include "core/cspace/choose.h"
#include "core/cspace/joint_path.h"

#include <vector>

namespace facetmill {

/// A posture at a point, held in one of the manners that the machine has for it.
struct PostureStop {
    PostureValue posture;
    Stand stand;
    double own_cost = 0; ///< s
};

/// Makes them, and says what they cost. What the input refers to has to live as long.
class PostureStops {
public:
    explicit PostureStops(const ChooseInput& input);

    const ChooseInput& input() const { return input_; }
    const MoveClock& clock() const { return clock_; }

    /// Appends a posture in every manner in which it is held. `top`: of its space.
    void add(const PassPoint& point, const PostureValue& posture, double top,
             std::vector<PostureStop>& stops) const;
    /// Appends those of a lead and a yaw, lifted as little as cuts nothing; none where that is not free.
    void add_free(const PassPoint& point, double lead, double yaw, CSpaceBuilder::Hints& hints,
                  std::vector<PostureStop>& stops) const;

private:
    double own_cost(const PostureValue& p, double top) const;

    const ChooseInput& input_;
    MoveClock clock_;
};

/// Where moves take the same time, the one that lifts less is taken: seconds for a lift as high as the space.
constexpr double lift_seconds = 1e-4;

} // namespace facetmill
