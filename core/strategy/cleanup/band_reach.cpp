#include "core/strategy/cleanup/band_reach.h"

#include "core/strategy/surface/point_grid.h"

namespace facetmill {

namespace {

constexpr std::size_t samples_per_check = 2048;
/// The nearest centre is looked for up to so many radii away.
constexpr double farthest_center = 64;

double length_of(const ValleyCurve& curve) {
    const auto& p = curve.points;
    double length = 0;
    for (std::size_t k = 1; k < p.size() + (curve.closed ? 1 : 0); ++k)
        length += (p[k % p.size()].center - p[k - 1].center).norm();
    return length;
}

/// The points of one band against the centres of its curve.
class CurveReach {
public:
    CurveReach(const ValleyCurve& curve, double radius)
        : points_(curve.points), along_(tangents(curve)), radius_(radius), centers_(radius) {
        for (const PencilPoint& p : points_)
            centers_.add(p.center);
    }

    void add(const Vec3& p, RestBand& band) const {
        const std::size_t nearest = nearest_center(p);
        if (nearest == points_.size()) return;
        const PencilPoint& q = points_[nearest];
        const Vec3& along = along_[nearest];
        const Vec3 rel = p - q.center;
        const double across = rel.dot(left_of(along, q.up));
        const std::size_t side = across >= 0 ? 0 : 1;
        band.reach[nearest][side] = std::max(band.reach[nearest][side], std::abs(across));
        const double flank = (rel - rel.dot(along) * along).norm();
        band.flank[nearest][side] = std::max(band.flank[nearest][side], flank);
    }

private:
    std::size_t nearest_center(const Vec3& p) const {
        std::size_t nearest = points_.size();
        double least = infinity;
        for (double r = radius_; nearest == points_.size() && r < farthest_center * radius_; r *= 2)
            centers_.near(p, r, [&](std::size_t k) {
                const double d = (points_[k].center - p).squaredNorm();
                if (d < least || (d == least && k < nearest)) {
                    least = d;
                    nearest = k;
                }
            });
        return nearest;
    }

    const std::vector<PencilPoint>& points_;
    std::vector<Vec3> along_;
    double radius_;
    PointGrid centers_;
};

} // namespace

void measure_reach(OutlinedBands& outlined, const Valleys& valleys, double radius, const Progress& progress) {
    const auto& at = outlined.band_points;
    std::size_t i = 0;
    for (std::size_t c = 0; c < valleys.curves.size(); ++c) {
        const ValleyCurve& curve = valleys.curves[c];
        RestBand& band = outlined.bands[c];
        band.reach.assign(curve.points.size(), {0, 0});
        band.flank.assign(curve.points.size(), {0, 0});
        band.length += length_of(curve);
        const CurveReach reach(curve, radius);
        for (; i < at.size() && at[i].owner <= c; ++i) {
            if (i % samples_per_check == 0) progress.check();
            if (at[i].owner == c) reach.add(outlined.points[at[i].point], band);
        }
        for (const auto& f : band.flank)
            band.width = std::max(band.width, f[0] + f[1]);
    }
}

} // namespace facetmill
