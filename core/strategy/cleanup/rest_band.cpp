#include "core/strategy/cleanup/rest_band.h"

#include "core/base/tolerances.h"
#include "core/strategy/cleanup/band_outlines.h"
#include "core/strategy/cleanup/band_reach.h"

#include <algorithm>

namespace facetmill {

namespace {

/// A centre that moves by less than this share of the tip's movement stands still.
constexpr double standing = 0.3;
/// A hollow whose box has a diagonal of less than so many ripples is left out.
constexpr double smallest_hollow = 2;

/// Bands that are there, valleys' first in their order, then hollows by area.
std::vector<RestBand> worth_cutting(std::vector<RestBand> bands, double ripple) {
    std::vector<RestBand> result;
    for (RestBand& band : bands) {
        if (band.band.empty()) continue;
        if (band.curve < 0) {
            Box3 box;
            for (const auto& t : band.band)
                for (const Vec3& p : t)
                    box.add(p);
            if (box.diagonal() < smallest_hollow * ripple) continue;
            band.length = box.diagonal();
        }
        result.push_back(std::move(band));
    }
    std::stable_sort(result.begin(), result.end(), [](const RestBand& a, const RestBand& b) {
        if ((a.curve < 0) != (b.curve < 0)) return b.curve < 0;
        return a.curve < 0 && a.area > b.area;
    });
    return result;
}

} // namespace

std::vector<Vec3> tangents(const ValleyCurve& curve) {
    const auto& p = curve.points;
    const std::size_t n = p.size();
    std::vector<Vec3> result(n, Vec3::Zero());
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = i > 0          ? i - 1
                                   : curve.closed ? n - 1
                                                  : i,
                          after = i + 1 < n      ? i + 1
                                  : curve.closed ? 0
                                                 : i;
        const Vec3 center = p[after].center - p[before].center;
        Vec3 tip = p[after].tip - p[before].tip;
        tip -= tip.dot(p[i].up) * p[i].up;
        // Around the foot of an upright edge the centre stands still, and the tip goes on.
        const Vec3 d = center.norm() >= standing * tip.norm() ? center : tip;
        if (d.norm() > 0) result[i] = d.normalized();
    }
    return result;
}

Vec3 left_of(const Vec3& tangent, const Vec3& up) {
    const Vec3 left = up.cross(tangent);
    return left.norm() > tolerance::level_angle ? Vec3(left.normalized()) : Vec3(Vec3::Zero());
}

std::vector<RestBand> rest_bands(const ValleyInput& input, const Valleys& valleys, const Progress& progress) {
    RestFacets rest = divided_near_rest(input, valleys.samples, progress.part(0, 0.25));
    const RestGaps gaps =
        measure_gaps(input, valleys, rest, progress.part(0.25, 0.85, "Measuring what is left"));
    const RestOwners owners =
        share_out(input.tolerance, valleys.curves.size(), rest, gaps, progress.part(0.85, 0.87));
    const Progress cutting = progress.part(0.87, 1);
    OutlinedBands outlined = cut_out(input, valleys, std::move(rest), gaps, owners, cutting);
    measure_reach(outlined, valleys, input.cover->radius(), cutting);
    return worth_cutting(std::move(outlined.bands), input.ripple);
}

} // namespace facetmill
