// Joins the passes of an operation to the complete motion of its tool: cuts, links and clearance moves.
// Millimetres, part coordinates.
#pragma once

#include "core/base/progress.h"
#include "core/gouge/tool_lift.h"
#include "core/setup/motion.h"
#include "core/strategy/plan/operation.h"

namespace facetmill {

struct LatheCommon; // core/strategy/lathe/lathe.h

/// What decides how passes are joined. Lengths in mm.
struct LinkOptions {
    double clearance = 5;          ///< height of level rapids above part and stock
    double link_distance = 0;      ///< passes whose ends are nearer than this are linked on the surface
    double holder_clearance = 0;   ///< what shank and holder keep from the part; three axes
    double chord_tolerance = 0.01; ///< how far a link may run beside the route that was found free
    // No parameters: what links keep safe by, which tests halve and double.
    /// The share of the chord tolerance by which a tool with five axes may be in the part at the places
    /// looked at; the rest is for what lies between them.
    double motion_share = 0.6;
    /// The share of the clearance by which the chord of a rapid about a turning axis may lie nearer to it
    /// than its ends: three quarters stay, whether the tip runs on the arc or on its chord.
    double rapid_chord_share = 0.25;
};

/// The options that suit an operation: links as far as four step-overs or the cutter's radius, the chord
/// tolerance of the passes (where they have none, a twentieth of the tolerance).
LinkOptions default_link_options(const StrategyResult& path, const PlanContext& context,
                                 const OperationCommon& common);

/// Joins the passes of a 3-axis path: on the surface (by the lift of the whole tool along the straight line,
/// so never into the part) where the next pass is near, and up to the pass's entry, level over the part and
/// down again where it has one; else by retract, rapids, approach. Level rapids to the first pass, and all
/// those of an operation that does not know its stock, run at clearance_z, above part, stock and every tip;
/// the tool goes down and up at feed, over tips that do not gouge. An operation that knows its stock goes
/// straight down in a rapid to the clearance, or half the cutter's radius where that is less, over what
/// stands at that moment, over the pass's beginning or, where that is much less to go at feed, beside it; and
/// as far above the pass it goes up in one, unless something stands there higher than the cutter beside a
/// slimmer shank: then as far above that. Where a pass goes straight up it does the same. Between passes it
/// rises no higher than cutter, shank and holder have to be on the way to keep the clearance above part and
/// stock; from a wall beside a pass, which would be on the way for all of its height, it goes sideways at
/// feed where that is less.
/// `allowance` is the operation's; the part's inner tessellation tolerance is added as the strategy does.
/// Throws Error(out_of_range).
ToolMotions link_three_axis(const StrategyResult& path, const PlanContext& context, double allowance,
                            const LinkOptions& options, const Progress& progress);

/// Joins the passes of a 5-axis path: over the surface, tip moving straight and the axis turning in one
/// plane, lifted along the tool axis wherever cutter, shank or holder would touch, where the next pass is
/// near and that way is free, or is shorter than what rapids leave at feed while the axis turns by 45 degrees
/// at most (what stands there of the stock a link cuts as a pass does); else out along the tool axis, in
/// rapids above or round part and stock (envelope.h), and in along the next axis. In and out a rapid goes to
/// the clearance, or half the cutter's radius where that is less, from the location where nothing stands on
/// that way (raw material less what operations with the axis +Z cut before, and what the flutes have cut in
/// this one). Where something does, the tool goes to or from a location near it at which it has cut and
/// behind which nothing stands, over the part at feed, or along its axis through the stock at feed, whichever
/// is shorter. In no motion of a link does the axis turn by more than 5 degrees, nor do interpolations of the
/// axis differ (even_motion.h). `clearance` is what cutter, shank and holder keep from the part, mm. Throws
/// Error(out_of_range).
ToolMotions link_five_axis(const StrategyResult& path, const PlanContext& context,
                           const ToolClearance& clearance, const LinkOptions& options,
                           const Progress& progress);

/// Joins the passes of roughing over the stock as it stands at each moment: straight at feed where the way is
/// cut already and short, else up to what stands on the way plus clearance (and never nearer to the part),
/// over it in a rapid, down in a rapid to the clearance over what stands there, or half the cutter's radius
/// where that is less, and in by the pass's entry at feed. `allowance` as above. Throws Error(out_of_range).
ToolMotions link_rough(const StrategyResult& path, const PlanContext& context, double allowance,
                       const LinkOptions& options, const Progress& progress);

/// Joins the passes of an operation on a turning part: on along the path where a pass begins where the one
/// before ended, else out along the tool axis, at feed until it is clear and then in a rapid, to a radius
/// beyond stock, chuck and tailstock; there round and along the part in rapids; in to the clearance over the
/// raw material in a rapid, and by the pass's entry at feed. Rapids that turn the part are divided, so that
/// they stay out there whether the tip runs on the arc or on its chords. Throws Error(out_of_range).
ToolMotions link_lathe(const StrategyResult& path, const PlanContext& context, const LatheCommon& settings,
                       const LinkOptions& options, const Progress& progress);

/// Joins the passes of an operation's path as the operation says.
ToolMotions link_operation(const Operation& operation, const StrategyResult& path, const PlanContext& context,
                           const Progress& progress);
/// The same for a further path of the operation that is linked in its own manner.
ToolMotions link_operation(const Operation& operation, Linking linking, const StrategyResult& path,
                           const PlanContext& context, const Progress& progress);

/// Throws Error(out_of_range) unless clearance and chord tolerance are above 0 and the link distance at least
/// 0.
void check_link_options(const LinkOptions& options);

} // namespace facetmill
