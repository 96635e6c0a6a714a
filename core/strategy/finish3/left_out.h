// Parts of passes that are not cut after all: where shank or holder would come into the part, and where the
// cutter would only cut air. A pass is split there.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/plan/operation.h"
#include "core/strategy/plan/path.h"
#include "core/strategy/surface/contact_domain.h"
#include "core/strategy/surface/holder_reach.h"
#include "core/strategy/surface/stock_field.h"
#include "core/strategy/tilt/tilted_passes.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

/// The contact that belongs to a tip on a pass.
using ContactAt = std::function<CutterContact(const Vec3& tip)>;

/// Pieces of passes between places that shank and holder cannot come to are at least so long, in radii.
inline constexpr double shortest_piece = 0.25;

/// Length of a pass up to each of its locations, mm.
std::vector<double> arc_lengths(const Pass& pass);
/// The tip so far along a pass.
Vec3 place_on(const Pass& pass, std::span<const double> arc, double at);
/// Ranges of a pass's length that are free, looked at as often as `spacing`.
std::vector<Interval> free_ranges(const Pass& pass, std::span<const double> arc, double spacing,
                                  const std::function<bool(const Vec3& tip)>& is_free,
                                  const Progress& progress);
/// The pieces of a pass over ranges of its length; their ends may lie within a motion.
std::vector<Pass> pieces_of(const Pass& pass, std::span<const double> arc, std::span<const Interval> ranges,
                            const ContactAt& contact);

/// What of a pass so long lies between ranges of its length, which are in order.
std::vector<Interval> gaps_between(std::span<const Interval> ranges, double length);

/// What shank and holder keep a path from.
struct HeldOut {
    std::vector<Pass> kept, left;       ///< pieces of the passes
    double length = 0, left_length = 0; ///< of all passes, and of what is left out; mm
    HolderReach::Lack lack;             ///< the largest; lengths that would have to be added
    double tilt_limit = 0;              ///< up to which the tool was inclined; 0: upright
    bool has_ball = false;              ///< the cutter can be inclined
};

/// Keeps what shank and holder may come to. Pieces shorter than `shortest` are left out too.
HeldOut leave_out_held(const std::vector<Pass>& passes, const HolderReach& bodies, double shortest,
                       const ContactAt& contact, const Progress& progress);

/// The same of a tool that is inclined: keeps what it can cut so. `bodies`: of the upright tool.
HeldOut leave_out_untilted(const std::vector<Pass>& passes, const PassTilter& tilter,
                           const HolderReach& bodies, double shortest, const ContactAt& contact,
                           const Progress& progress);
/// What else than a longer tool would reach it: ", or a larger tilt limit".
std::string held_alternative(const HeldOut& held);

/// Throws Error(empty_result): all of the passes are held up.
[[noreturn]] void refuse_held(const std::string& operation, const HeldOut& held, const PlanContext& context);

/// Keeps what takes away more than `least` of height somewhere (below 0: what comes as near as that), and
/// `beside` before and after, so that the tool comes in where nothing stands. Gaps shorter than twice that
/// are passed at feed.
std::vector<Pass> leave_out_air(const std::vector<Pass>& passes, const StockField& field,
                                const StockCutter& cutter, double least, double beside,
                                const ContactAt& contact, const Progress& progress);

/// Throws Error(empty_result): no pass meets the raw material.
[[noreturn]] void refuse_beside_raw(const std::string& operation);
/// The same: none takes away more than the tolerance, and only that was asked for.
[[noreturn]] void refuse_without_rest(const std::string& operation);

} // namespace facetmill
