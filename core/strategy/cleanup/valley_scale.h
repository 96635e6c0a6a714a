// Lengths by which valleys are followed: shares of the cutter's radius. Millimetres.
#pragma once

#include "core/strategy/cleanup/valley.h"

namespace facetmill {

struct ValleyScale {
    explicit ValleyScale(const ValleyInput& input)
        : radius(input.cover->radius()), reach(input.mesh->box().diagonal()), step(step_share * radius),
          fit(fit_share * radius) {}

    /// Steps along a curve and the stretch over which fitted vectors are averaged, in radii.
    static constexpr double step_share = 0.08, fit_share = 0.25;
    /// Points of a curve nearer to each other than this share of a step are one.
    static constexpr double min_step = 0.4;
    /// Ends of curves are found to this share of a step.
    static constexpr double end_share = 1.0 / 32;

    double radius;
    double reach; ///< length of rays: across the whole part
    double step;  ///< between points of a curve
    double fit;   ///< the fitted vector is an average over this length to either side
};

} // namespace facetmill
