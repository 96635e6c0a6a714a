// What the bounds of bench programs look at: a part's surface as samples, found by where they are.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/global_local/coverage.h"
#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/point_grid.h"

#include <utility>
#include <vector>

namespace facetmill {

struct SampledSurface {
    /// In radii of the context's cutter: how far the samples are apart, and how far they are looked for.
    SampledSurface(PlanContext of, double apart, double reach, const Progress& progress)
        : context(with_geometry(std::move(of), progress)),
          radius(CutterProfile(context.tool.cutter()).max_radius()),
          samples(surface_samples(*context.part, context.geometry->vertex_normals,
                                  UpSide(*context.part, progress), apart * radius)),
          grid(places_of(samples), reach * radius) {}

    PlanContext context; ///< with geometry
    double radius;       ///< of the cutter, mm
    std::vector<SurfaceSample> samples;
    PointGrid grid; ///< of the samples, by their places in the list

private:
    static PlanContext with_geometry(PlanContext context, const Progress& progress) {
        if (!context.geometry) context.geometry = compute_geometry(*context.part, progress);
        return context;
    }
    static std::vector<Vec3> places_of(const std::vector<SurfaceSample>& samples) {
        std::vector<Vec3> places;
        for (const SurfaceSample& s : samples)
            places.push_back(s.point);
        return places;
    }
};

} // namespace facetmill
