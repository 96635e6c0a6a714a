#include "core/strategy/cleanup/foot_places.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/stock_bottom.h"
#include "core/strategy/surface/cell_set.h"
#include "core/strategy/surface/facet_rows.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Samples are so far apart, in radii of the smaller cutter; farther where there would be more than so many.
constexpr double foot_sample_share = 0.15, max_foot_samples = 1e6;

/// An upright cutter whose tip is kept at or above a level.
class KeptCutter {
public:
    KeptCutter(const AxialLift& lift, const CutterCover& cover, double lowest)
        : lift_(lift), cover_(cover), lowest_(lowest) {}

    /// How far from a place of the part it stays; n is its normal, n.z above 0.
    double gap(const Vec3& p, const Vec3& n, LiftHint& hint) const {
        const Vec3 touching = p + cover_.tip_offset(n);
        // In a hollow the flanks hold it up where it would touch: straight above it may come nearer.
        const double least = std::min(left_at(p, touching, hint), left_at(p, p, hint));
        const double below = lowest_ - touching.z();
        if (!(below > 0) || n.z() > tolerance::level_normal_z) return least;
        // Up the slope to the level it comes nearer than straight up.
        const Vec3 up_slope = (Vec3::UnitZ() - n.z() * n).normalized();
        return std::min(least, left_at(p, touching + below / up_slope.z() * up_slope, hint));
    }

    /// Does its tip have to be below the level to touch the place?
    bool is_held_up(const Vec3& p, const Vec3& n) const { return p.z() + cover_.tip_offset(n).z() < lowest_; }

private:
    double left_at(const Vec3& p, Vec3 tip, LiftHint& hint) const {
        tip.z() = std::max({tip.z(), lowest_, lift_.tip_z(tip.x(), tip.y(), hint)});
        return cover_.distance(p - tip);
    }

    const AxialLift& lift_;
    const CutterCover& cover_;
    double lowest_;
};

class FootSearch {
public:
    explicit FootSearch(const CleanupJob& job)
        : job_(job), lowest_(lowest_allowed(job.context, job.settings)),
          before_profile_(job.context.further_tools.front().cutter()),
          before_cover_(before_profile_, cusp_detail(job.cusp)),
          before_lift_(job.context.contact, before_profile_, job.allowance),
          before_(before_lift_, before_cover_, lowest_), own_(job.lift, job.cover, lowest_) {}

    FootPlaces run(const Progress& progress) {
        const std::vector<Index> facets = low_facets();
        if (facets.empty()) return {};
        // Of all operations: the previous cutter may have been somewhere else than it is asked about.
        AptCutter none;
        none.d = 0;
        const Standing standing(job_.context, none, job_.cusp, job_.allowance, progress.part(0, 0));
        FootPlaces found;
        found.spacing = std::max(foot_sample_share * job_.radius, std::sqrt(area_ / max_foot_samples));
        using Places = std::vector<LeftPlace>;
        found.places = parallel_reduce(
            facets.size(), 64, Places(), progress,
            [&](std::size_t begin, std::size_t end) {
                Places places;
                Near near;
                for (std::size_t i = begin; i < end; ++i)
                    ask_facet(standing, facets[i], found.spacing, near, places);
                return places;
            },
            [](Places a, const Places& b) {
                a.insert(a.end(), b.begin(), b.end());
                return a;
            });
        return found;
    }

private:
    /// What helps to find it for the next place.
    struct Near {
        LiftHint before, own;
        Standing::Hint cut;
    };

    /// Facets that face up and reach down to where the previous cutter is held up; small ones, one a cell.
    std::vector<Index> low_facets() {
        const Mesh& mesh = *job_.context.part;
        CellSet seen(0.5 * foot_sample_share * job_.radius);
        const double highest = lowest_ + std::max(before_cover_.shoulder(), before_cover_.radius());
        std::vector<Index> low;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            const Vec3 &a = mesh.corner(f, 0), &b = mesh.corner(f, 1), &c = mesh.corner(f, 2);
            if (std::min({a.z(), b.z(), c.z()}) > highest || std::max({a.z(), b.z(), c.z()}) < lowest_)
                continue;
            if (!(facing_up(f).z() > tolerance::vertical_normal_z)) continue;
            const double longest2 =
                std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
            const double cell = foot_sample_share * job_.radius;
            if (longest2 < 0.25 * cell * cell && !seen.add_first((a + b + c) / 3)) continue;
            area_ += 0.5 * mesh.facet_cross(f).norm();
            low.push_back(Index(f));
        }
        return low;
    }

    Vec3 facing_up(std::size_t f) const { return job_.side.towards_tool(job_.context.part->facet_normal(f)); }

    void ask_facet(const Standing& standing, Index f, double spacing, Near& near,
                   std::vector<LeftPlace>& places) const {
        const Vec3 n = facing_up(f);
        const FacetRows rows(*job_.context.part, f, spacing);
        for (std::size_t r = 0; r < rows.rows(); ++r)
            for (std::size_t c = 0; c < rows.columns(r); ++c) {
                const Vec3 p = rows.point(r, c);
                if (p.z() < lowest_ || !before_.is_held_up(p, n)) continue;
                const double cusp = job_.cusp, left = before_.gap(p, n, near.before);
                if (!(left > cusp) || own_.gap(p, n, near.own) > cusp) continue;
                const double raw = standing.raw_over(p, n);
                if (standing.stands(p, raw, cusp, near.cut)) places.push_back({p, n, std::min(left, raw)});
            }
    }

    const CleanupJob& job_;
    double lowest_, area_ = 0;
    CutterProfile before_profile_;
    CutterCover before_cover_;
    AxialLift before_lift_;
    KeptCutter before_, own_;
};

} // namespace

FootPlaces foot_places(const CleanupJob& job, const Progress& progress) {
    return FootSearch(job).run(progress);
}

} // namespace facetmill
