// Finishing that was planned for an upright ball, with the tool inclined where shank or holder would come
// into the part: short tools in deep moulds and beside high walls. Millimetres, radians, part coordinates.
//
// A ball cuts the same however its axis leans, as long as its middle goes the same way and it touches with
// the ball. So passes, step-overs and what stays of the stock are those of the upright tool, whatever course
// the passes take; only the axis is chosen anew (axis_tilt.h), from the postures at each place that keep
// cutter, shank and holder clear, are inclined no farther than the limit, and are within the machine's reach.
// What operations with an upright tool before it left standing is kept out of as well, as far as the passes
// before have not cut it.
//
// The contact points and what was chosen there are kept as those of finish5 are, so that the configuration
// space of each can be looked at.
#pragma once

#include "core/strategy/plan/budget.h"
#include "core/strategy/tilt/axis_tilt.h"

#include <utility>

namespace facetmill {

struct TiltOptions {
    double limit = 0;            ///< largest angle between axis and +Z; 0: upright only
    double allowance = 0;        ///< stock left on the part, what its tessellation lacks included
    double holder_clearance = 0; ///< kept between shank or holder and the part
    double chord = 0;            ///< how far motions may run beside the exact path
};

class PassTilter {
public:
    /// What is given has to live as long as this.
    PassTilter(const PlanContext& context, const TiltOptions& options);
    PassTilter(const PassTilter&) = delete;
    PassTilter& operator=(const PassTilter&) = delete;

    /// What of an upright pass can be cut, inclined where shank or holder would touch the part or, where it
    /// is given, what stands of the stock. Any thread may ask.
    TiltedPass run(const Pass& pass, const Progress& progress, const TiltedStock* stock = nullptr) const;

private:
    ToolLift whole_;
    Kinematics machine_;
    TiltInput input_;
};

/// Throws Error(out_of_range) for a tilt limit with a cutter that has no ball end.
void check_tilt(const PlanContext& context, double limit);

/// The passes of a plan, inclined where they have to be. `path` is that of an upright ball, without what no
/// axis within the limit reaches. What is left out here nevertheless is told in its warnings. Throws
/// Error(empty_result) where nothing stays.
void tilt_passes(StrategyResult& path, const OperationCommon& settings, const PlanContext& context,
                 const TiltOptions& options, const Progress& progress);

/// What an operation plans for an upright tool by `upright`, inclined where its settings S allow it: they
/// have a tilt limit, a clearance of the holder and a chord tolerance.
template <class S, class Upright>
StrategyResult with_tilt(const S& settings, const PlanContext& context, const Progress& progress,
                         const Upright& upright) {
    if (settings.tilt_limit == 0) return upright(progress);
    check_tilt(context, settings.tilt_limit);
    StrategyResult path = upright(progress.part(0, 0.8));
    const double allowance = settings.allowance + context.tessellation_tolerance[1];
    const double chord = chord_budget(settings.chord_tolerance, cusp_budget(settings, context));
    tilt_passes(path, settings, context, {settings.tilt_limit, allowance, settings.holder_clearance, chord},
                progress.part(0.8, 1, "Choosing axes"));
    return path;
}

} // namespace facetmill
