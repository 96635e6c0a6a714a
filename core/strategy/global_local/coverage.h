// What a path with any tool axes clears of the part, judged by its tool alone: places of the surface, raised
// by what may stay there, that some pose of the tool holds. Poses alone do not tell: an inclined flat end
// holds a place that is raised by a hundredth of a millimetre only for a few hundredths of a motion. So the
// path of each place as the tool sees it is followed, in straight pieces. What these miss, less than a
// thousandth of the cutter's radius, counts as not cleared: coverage errs on the safe side. Millimetres.
#pragma once

#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"
#include "core/strategy/plan/path.h"
#include "core/strategy/surface/up_side.h"

#include "core/base/progress.h"

#include <span>
#include <vector>

namespace facetmill {

struct SurfaceSample {
    Vec3 point, normal; ///< the normal is unit, towards the tool
    double area = 0;    ///< the piece of the surface that it stands for, mm^2
};

/// Samples at most `spacing` apart, on all facets that face the tool; `normals` are the vertices'.
std::vector<SurfaceSample> surface_samples(const Mesh& mesh, std::span<const Vec3> normals, const UpSide& up,
                                           double spacing);

class Coverage {
public:
    /// `raise`: what is to stay and what may stay, along the normals.
    Coverage(std::vector<SurfaceSample> samples, double raise);

    /// Adds what the passes clear.
    void add(std::span<const Pass> passes, const CutterProfile& cutter, const Progress& progress);

    const std::vector<SurfaceSample>& samples() const { return samples_; }
    bool cleared(std::size_t sample) const { return cleared_[sample] != 0; }
    double cleared_area() const;
    double area() const;

private:
    std::vector<SurfaceSample> samples_;
    std::vector<Vec3> raised_;
    std::vector<unsigned char> cleared_;
};

} // namespace facetmill
