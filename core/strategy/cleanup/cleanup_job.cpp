#include "core/strategy/cleanup/cleanup_job.h"

#include "core/strategy/plan/budget.h"

namespace facetmill {

CleanupJob::CleanupJob(const CleanupSettings& asked, const PlanContext& given, const Progress& progress)
    : settings(asked), context(given), text{context.unit, context.to_setup},
      cusp(cusp_budget(settings, context)), chord(chord_budget({0, "auto"}, cusp)),
      allowance(settings.allowance + context.tessellation_tolerance[1]), profile(context.tool.cutter()),
      cover(profile, cusp_detail(cusp)), lift(context.contact, profile, allowance),
      grid(*context.part, progress), side(*context.part, progress),
      standing(context, context.further_tools.front().cutter(), cusp, allowance, progress),
      radius(profile.max_radius()),
      ripple(settings.smallest_strip.is_number() ? settings.smallest_strip.number : radius),
      overlap(settings.overlap.is_number() ? settings.overlap.number : 0.5 * radius) {}

StripCutting CleanupJob::cutting() const {
    StripCutting with;
    with.mesh = context.part;
    with.grid = &grid;
    with.side = &side;
    with.lift = &lift;
    with.cover = &cover;
    with.standing = &standing;
    with.allowance = allowance;
    // Moves may stay off the part by the chord tolerance, so passes leave that much less.
    with.cusp = standing_cusp(cusp, chord);
    with.chord = chord;
    with.overlap = overlap;
    with.along_z = settings.lift == CleanupSettings::Lift::z;
    with.one_way = settings.pattern == CleanupSettings::Pattern::oneway;
    return with;
}

ValleyInput CleanupJob::asking(const AxialLift& other, const CutterCover& its_cover) const {
    ValleyInput in;
    in.mesh = context.part.get();
    in.grid = &grid;
    in.side = &side;
    in.lift = &other;
    in.cover = &its_cover;
    in.standing = &standing;
    in.tolerance = cusp;
    in.ripple = ripple;
    return in;
}

} // namespace facetmill
