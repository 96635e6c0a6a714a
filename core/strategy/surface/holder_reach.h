// Shank and holder of a tool with the axis +Z over the part: how far the tip has to be lifted for them. Each
// is an upright cylinder, endless upward, so that where a tool may stand it may also go straight up.
#pragma once

#include "core/gouge/axial_lift.h"
#include "core/setup/tool.h"

#include <vector>

namespace facetmill {

class HolderReach {
public:
    /// Shank and holder keep `clearance`, and `margin` beyond it for what lies between two places that are
    /// looked at (`spacing`). A shank no wider than the cutter never stops the tool unless it is to keep more
    /// distance than the cutter.
    HolderReach(ContactIndexPtr index, const Tool& tool, double clearance, double margin);

    bool empty() const { return bodies_.empty(); }
    /// Along a straight line looked at as often as this, nothing comes nearer than the clearance.
    double spacing() const { return spacing_; }

    using Hints = std::vector<LiftHint>;
    /// The tip at z, or as much higher as shank and holder ask for.
    double raised(const Vec2& p, double z, Hints& hints) const;
    bool is_free(const Vec3& tip, Hints& hints) const;
    /// What shank and holder, each by itself, ask for above a tip, mm; 0: nothing.
    struct Lack {
        double shank = 0, holder = 0;
    };
    Lack lack(const Vec3& tip) const;

private:
    struct Body {
        AxialLift lift;
        double base; ///< of its lower face over the tip
        bool is_shank;
    };
    std::vector<Body> bodies_;
    double spacing_ = infinity;
};

} // namespace facetmill
