// The passes of a roughing plan, cut one after the other: what shank or holder forbid is left out, an entry
// is found, a route that begins near the last one's end is joined to it where something is to be cut on the
// way or the way is short, and the stock is cut. Millimetres.
#pragma once

#include "core/strategy/plan/path.h"
#include "core/strategy/rough/rough_entry.h"
#include "core/strategy/rough/rough_setup.h"

namespace facetmill {

class RoughPasses {
public:
    /// Everything passed must outlive this; `field` is cut.
    RoughPasses(const RoughSettings& settings, const RoughMeasures& measures, const RoughReach& reach,
                const UprightBodies& bodies, const StockCutter& cutter, StockField& field,
                const Progress& progress);

    /// What follows is cut on this layer.
    void begin_layer(int layer, double z);
    /// Cuts a route on the layer, or keeps it for `add_late` where the tool has no room to enter.
    void add(RoughRoute route, const LayerRoutes& routes, std::span<const FreeContour> contours);
    /// What had no room for an entry may have one when all round it is cut, or nothing left to cut; the rest
    /// is left out.
    void add_late();
    /// Cuts along a floor between layers, in whichever direction the tool can enter; leaves it out where what
    /// stands over it is not for one cut.
    void add_floor(std::vector<Vec3> tips, const Layers& layers);

    /// Where the last route ended.
    Vec2& at() { return at_; }
    std::vector<Pass>& passes() { return passes_; }

    /// Cuts that were left out.
    struct LeftOut {
        std::size_t routes = 0;
        double length = 0;
        Vec3 at = Vec3::Zero(); ///< the first
    };
    const LeftOut& blocked() const { return blocked_; } ///< by shank or holder
    const LeftOut& closed() const { return closed_; }   ///< for want of room to enter

private:
    std::vector<RoughRoute> clear_parts(RoughRoute route);
    bool join(RoughRoute& route, const LayerRoutes& routes, std::span<const FreeContour> contours);
    bool go_over(const std::vector<Vec2>& link, RoughRoute& route) const;
    bool is_quicker_over(double length, double straight) const;
    void take(const RoughRoute& route, const std::vector<Vec3>& down);
    void take(const std::vector<Vec3>& tips, const std::vector<Vec3>& down, int layer);

    const RoughSettings& settings_;
    const RoughMeasures& measures_;
    const UprightBodies& bodies_;
    const StockCutter& cutter_;
    StockField& field_;
    const Progress& progress_;
    RoughEntry entry_;
    int layer_ = 0;
    double z_ = 0;
    double highest_ = 0; ///< place of the stock when the layer began
    Vec2 at_ = Vec2::Zero();
    std::vector<Pass> passes_;
    std::vector<RoughRoute> late_; ///< routes of the layer that have no entry so far
    LeftOut blocked_, closed_;
};

} // namespace facetmill
