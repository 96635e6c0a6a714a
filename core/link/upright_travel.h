// How an upright tool travels between passes: out of one and in to the next as far as it has to at feed, the
// rest in rapids, which run as low as part and stock allow. Millimetres, part coordinates, the tool's axis
// +Z.
#pragma once

#include "core/link/later_cuts.h"
#include "core/link/link.h"
#include "core/link/straight_up.h"
#include "core/strategy/rough/rough_entry.h"
#include "core/strategy/surface/holder_reach.h"
#include "core/strategy/surface/lift_line.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

namespace facetmill {

/// What stands at each moment, where the operation knows its stock, and the part. Cutter, shank and holder
/// keep off both.
class UprightTravel {
public:
    /// `allowance`: all that is to stay on the part; `lowest`: of the tips that are fed; `top`: the height at
    /// which nothing is in the way anywhere.
    UprightTravel(const PlanContext& context, double allowance, const LinkOptions& options, double lowest,
                  double top, const Progress& progress);

    /// What a rapid straight down keeps from what stands, mm.
    double clearance() const { return clearance_; }
    /// What is fed, mm, from the end of a rapid on to where the tool is out of the cut or has been already.
    double touch() const;
    /// Tips that do not gouge, for cuts and links.
    const LiftField& part() const { return part_; }
    double spacing() const { return spacing_; } ///< of places on a line that are to be looked at
    const AxialLift& lift() const { return lift_; }
    const HolderReach& bodies() const { return bodies_; }

    /// Where a rapid straight down to a tip ends: at `top` where nothing is known of the stock.
    double down_to(const Vec3& tip, double top);
    /// Where a rapid straight up from a tip begins. What stands higher than the cutter beside a slimmer
    /// shank, or beside the neck of an undercut cutter, is cut on the way up: at feed.
    double up_from(const Vec3& tip, double top);
    /// Where a rapid straight down ends from `from`, over a lower tip at the same place, because the tool has
    /// been as low there before. None where that saves no more than the clearance.
    std::optional<double> fall_to(const Vec3& from, const Vec3& tip);
    /// Where a rapid down that does not end over a tip ends beside it: cells that a wall crosses are as high
    /// as the wall for ever, so that along a wall nothing is known to be gone. None where that is no shorter
    /// than `slow`, the way down at feed.
    std::optional<Vec3> beside(const Vec3& tip, double slow);
    /// Whether neither shank nor holder meets what stands on a level way at z.
    bool is_level_free(const Vec2& a, const Vec2& b, double z);

    /// From a tip to another: at feed to `out`, in rapids up to `z`, level, and down to `in`, on at feed.
    struct Route {
        Vec3 out, in;
        double z = 0;
        /// Where each of the rapids ends.
        std::array<Vec3, 3> rapids() const {
            return {Vec3(out.x(), out.y(), z), Vec3(in.x(), in.y(), z), in};
        }
    };
    /// Where a rapid down to a tip from `top` ends, over it or beside it.
    Vec3 over(const Vec3& tip);
    Route route(const Vec3& from, const Vec3& to, const Progress& progress);

    /// The tool has cut from one tip to the other.
    void feed(const Vec3& from, const Vec3& to) {
        if (!stock_) return;
        stock_->feed(from, to);
        if (up_.frees_column() && from.head<2>() == to.head<2>()) {
            double& low = been_.try_emplace({to.x(), to.y()}, infinity).first->second;
            low = std::min({low, from.z(), to.z()});
        }
    }

private:
    double been_at(const Vec2& p) const {
        const auto at = been_.find({p.x(), p.y()});
        return at == been_.end() ? infinity : at->second;
    }
    bool is_off(const Vec3& tip, double stands) const;
    bool is_clear(const Vec3& place, const Vec3& tip);
    std::vector<Vec3> places_beside(const Vec3& tip, double no_farther);
    double clear_height(const Vec2& a, const Vec2& b, double known);
    double level(const Vec2& a, const Vec2& b, const Progress& progress);
    std::optional<Vec3> lowest_beside(const Vec3& tip, const Progress& progress);
    double cost(const Route& route, const Vec3& from, const Vec3& to) const;

    CutterProfile profile_;
    StockCutter cutter_;
    UprightBodies stock_bodies_;
    AxialLift lift_;
    HolderReach bodies_;
    LiftField part_;
    double spacing_;
    AxialLift wide_lift_; ///< for rapids, of which fewer places are looked at
    HolderReach wide_bodies_;
    double wide_spacing_;
    StraightUp up_;
    double clearance_, level_clearance_, top_;
    /// How far from a tip is asked: half a radius beside it, and there the widest body.
    double reach_;
    std::optional<LaterCuts> stock_;
    /// The lowest tips between which and others over them the tool was fed straight up or down.
    std::map<std::array<double, 2>, double> been_;
};

} // namespace facetmill
