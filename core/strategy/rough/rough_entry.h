// How the tool of a roughing operation comes into the material, and where its shank and holder would meet
// what stands. Millimetres, radians.
#pragma once

#include "core/setup/tool.h"
#include "core/strategy/rough/rough.h"
#include "core/strategy/rough/rough_routes.h"

#include <vector>

namespace facetmill {

/// Shank and holder as upright cylinders over the tip.
class UprightBodies {
public:
    /// `deepest`: how far apart the layers are, at most, that the tool cuts one below the other.
    UprightBodies(const Tool& tool, const CutterProfile& profile, double deepest);

    /// Highest place over the tip's level that is allowed to stand where nothing is asked further.
    double lowest_base() const { return lowest_; }
    /// Height over the tip of the lowest of those that slide along what the cutter left; infinite if none.
    double sliding_base() const { return sliding_; }
    /// What the tip must be above on a level line from a to b so that none of them touches what may stand.
    /// Those no wider than the cutter need nothing of their own where the cutter itself is clear.
    /// Where that is no more than `known` any height that is not.
    double clear_height(const StockField& field, const Vec2& a, const Vec2& b,
                        double known = -infinity) const;
    double widest() const; ///< radius
    /// True when none of them meets the stock on a level motion of the tip from a to b.
    bool clear(const StockField& field, const Vec2& a, const Vec2& b, double z) const;

private:
    struct Body {
        double radius, base;
        bool inside; ///< the cutter's own radius or less: it stands where the cutter came down
        bool slides; ///< no wider than what the layer above has cut as high as the shank begins
    };
    std::vector<Body> bodies_;
    double lowest_ = infinity, sliding_ = infinity;
};

class RoughEntry {
public:
    /// All of it must outlive this; the field is asked as it stands at the call.
    RoughEntry(const RoughSettings& settings, const RoughReach& reach, const StockField& field,
               const StockCutter& cutter, const UprightBodies& bodies, double least)
        : settings_(settings), reach_(reach), field_(field), cutter_(cutter), bodies_(bodies), min_(least) {}

    /// Decides where the route begins (it may be made longer, turned round or, a closed one, begun elsewhere)
    /// and the descent to its first point at z: nothing where that stands free, or where plunging is
    /// allowed. False where there is no room for a ramp or a helix.
    bool enter(RoughRoute& route, double z, std::vector<Vec3>& down) const;
    /// True where the route begins, or made a little longer would begin, where nothing stands; it is made so.
    bool begin_free(RoughRoute& route, double z) const;
    /// The descent to the first of tips that are not level: nothing where that stands free, or where
    /// plunging is allowed; else a ramp forth and back over their beginning, no deeper than they are. False
    /// where that is too short.
    bool descend(const std::vector<Vec3>& tips, std::vector<Vec3>& down) const;

private:
    bool stands_free(const Vec2& p, double z) const;
    bool ramp(const RoughRoute& route, double z, double shortest, std::vector<Vec3>& down) const;
    bool helix(const RoughRoute& route, double z, std::vector<Vec3>& down) const;
    bool helix_at(const Vec2& end, double z, std::vector<Vec3>& down) const;

    const RoughSettings& settings_;
    const RoughReach& reach_;
    const StockField& field_;
    const StockCutter& cutter_;
    const UprightBodies& bodies_;
    double min_;
};

} // namespace facetmill
