// How fast a part could be finished at best with two tools: bounds that measured times are judged by. Every
// place of the surface takes its share of area over the feed and the width of the widest strip there: of the
// curvature-matched cutter at the least lead at which it touches without cutting the part, or of the ball. No
// path has such strips everywhere: passes are as close together as the narrowest place between them asks for,
// and the bounds know no turning round, no travel between passes and no rapid.
#pragma once

#include "core/strategy/five_axis/finish5.h"

namespace facetmill {

struct LeastTime {
    double area = 0;               ///< surface that a tool comes to, mm^2
    double seconds = 0;            ///< with the best travel at every place by itself
    double ball_area = 0;          ///< mm^2: where the ball is faster then, or alone fits
    double ball_seconds = 0;       ///< the ball's part of `seconds`
    double straight_seconds = 0;   ///< with one travel for the whole part, as of parallel planes
    double direction = 0;          ///< that travel's, from X, radians
    double ball_alone_seconds = 0; ///< the ball everywhere
};

/// Bounds for the context's tool and a ball. Tolerance, chord tolerance, feed and lead limits are those of
/// `settings`; twelve directions are tried. What lies between the places that are looked at is taken to be as
/// good as the best of them within a quarter of the cutter's radius. Throws what FiveAxisField throws.
LeastTime least_time(const PlanContext& context, const Finish5Settings& settings, double ball_diameter,
                     const Progress& progress);

} // namespace facetmill
