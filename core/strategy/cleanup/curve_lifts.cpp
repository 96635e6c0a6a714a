#include "core/strategy/cleanup/curve_lifts.h"

#include "core/base/parallel.h"
#include "core/mesh/refine.h"
#include "core/strategy/cleanup/band_facets.h"

namespace facetmill {

namespace {

/// Facets that lift the cutter are looked for along this many radii of the curve at once,
constexpr double chunk_radii = 4;
/// so many radii beyond the band's reach there and at so many more points of the curve.
constexpr double lift_radii = 2.5;
constexpr std::size_t near_points = 8;
/// A stretch is the neighbourhood of its ends and of every so many of its points.
constexpr std::size_t asked_points = 4;
/// Facets lift the cutter if they face along the fitted vector by more than this cosine.
constexpr double min_facing = 0.01;
constexpr std::size_t lifts_per_check = 8192;

class CurveLifts {
public:
    CurveLifts(const StripCutting& with, const ValleyCurve& curve, const RestBand& band)
        : with_(with), curve_(curve), band_(band), radius_(with.cover->radius()),
          count_(curve.points.size()) {}

    /// Every stretch of the curve gets the facets around it. Those beside the band alone: a leaning vector
    /// would bring the cutter down on the far wall of a wide valley else.
    std::vector<std::shared_ptr<const VectorLift>> run(const Progress& progress) {
        std::vector<std::shared_ptr<const VectorLift>> lift_of(count_);
        beside_ =
            facets_beside(*with_.mesh, *with_.grid, band_, radius_ + with_.overlap, progress.part(0, 0));
        const std::vector<Stretch> all = stretches();
        parallel_for(all.size(), 1, progress, [&](std::size_t k) {
            const auto lift = lift_about(all[k], progress);
            for (std::size_t i = all[k].first; i <= all[k].last; ++i)
                lift_of[i] = lift;
        });
        return lift_of;
    }

private:
    /// Points of the curve, both ends included.
    struct Stretch {
        std::size_t first, last;
    };

    /// What lies beside the centres of a stretch: across its mean fitted vector and along it.
    struct Neighborhood {
        Vec3 up = Vec3::Zero();
        std::vector<Vec3> centers;
        double aside = 0, high = 0;

        bool holds(const Vec3& middle, double size) const {
            return std::any_of(centers.begin(), centers.end(), [&](const Vec3& p) {
                const Vec3 rel = middle - p;
                const double height = rel.dot(up);
                return height <= high + size && height >= -aside - size
                       && (rel - height * up).squaredNorm() <= (aside + size) * (aside + size);
            });
        }
    };

    const PencilPoint& at(std::size_t i) const { return curve_.points[i]; }

    std::vector<Stretch> stretches() const {
        std::vector<Stretch> all;
        for (std::size_t first = 0; first < count_;) {
            std::size_t last = first;
            for (double length = 0; last + 1 < count_ && length < chunk_radii * radius_; ++last)
                length += (at(last + 1).center - at(last).center).norm();
            all.push_back({first, last});
            first = last + 1;
        }
        return all;
    }

    Neighborhood around(const Stretch& stretch) const {
        const auto [first, last] = stretch;
        Neighborhood n;
        for (std::size_t i = first; i <= last; ++i) {
            n.up += at(i).up;
            if (i == first || i == last || (i - first) % asked_points == 0) n.centers.push_back(at(i).center);
        }
        n.up.normalize();
        // A pass goes over the band as far as points of the curve near by ask for.
        for (std::size_t i = first > near_points ? first - near_points : 0;
             i < std::min(last + near_points + 1, count_); ++i) {
            n.aside = std::max({n.aside, band_.reach[i][0], band_.reach[i][1]});
            n.high = std::max({n.high, band_.flank[i][0], band_.flank[i][1]});
        }
        n.aside += with_.overlap + lift_radii * radius_;
        n.high += with_.overlap + lift_radii * radius_;
        return n;
    }

    std::shared_ptr<const VectorLift> lift_about(const Stretch& stretch, const Progress& progress) const {
        const Neighborhood near = around(stretch);
        const Mesh& mesh = *with_.mesh;
        std::vector<Index> facets;
        for (std::size_t i = 0; i < beside_.size(); ++i) {
            if (i % lifts_per_check == 0) progress.check();
            const auto& [f, middle, size] = beside_[i];
            if (near.holds(middle, size)
                && with_.side->towards_tool(mesh.facet_normal(f)).dot(near.up) > min_facing)
                facets.push_back(f);
        }
        if (facets.empty()) return nullptr;
        return std::make_shared<VectorLift>(
            std::make_shared<ContactIndex>(std::make_shared<Mesh>(part_of(mesh, facets).mesh),
                                           progress.part(0, 0)),
            with_.cover->profile(), std::span<const BodySection>(), with_.allowance);
    }

    const StripCutting& with_;
    const ValleyCurve& curve_;
    const RestBand& band_;
    double radius_;
    std::size_t count_;
    std::vector<BandFacet> beside_;
};

} // namespace

std::vector<std::shared_ptr<const VectorLift>> lifts_along(const StripCutting& with, const ValleyCurve& curve,
                                                           const RestBand& band, const Progress& progress) {
    return CurveLifts(with, curve, band).run(progress);
}

} // namespace facetmill
