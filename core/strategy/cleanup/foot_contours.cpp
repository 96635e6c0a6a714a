#include "core/strategy/cleanup/foot_contours.h"

#include "core/base/tolerances.h"
#include "core/strategy/finish3/left_out.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/stock_bottom.h"
#include "core/strategy/surface/facet_rows.h"
#include "core/strategy/surface/slope_facets.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Walls less steep than this are cut by lines over them.
const double shallowest_wall = radians(60);
/// The grid of tip heights on which contours are looked for, in radii.
constexpr double grid_share = 0.2;
/// A contour counts where it touches no farther than this, in radii, from the strip; it goes on over gaps of
/// so many, which takes less time than going out, over and in again.
constexpr double beside_share = 0.75, contour_bridged_radii = 4;
/// Samples that stand for the strip are so far apart, in radii.
constexpr double contour_sample_share = 0.5;

PointGrid samples_of(const Mesh& strip, double radius, const Progress& progress) {
    PointGrid samples(beside_share * radius);
    for (std::size_t f = 0; f < strip.facet_count(); ++f) {
        progress.check();
        const FacetRows rows(strip, f, contour_sample_share * radius);
        for (std::size_t r = 0; r < rows.rows(); ++r)
            for (std::size_t c = 0; c < rows.columns(r); ++c)
                samples.add(rows.point(r, c));
    }
    return samples;
}

ContourPasses::Options foot_options(const CleanupJob& job, const Interval& slopes) {
    ContourPasses::Options options;
    options.slopes = slopes;
    options.chord = job.chord;
    options.radius = job.radius;
    options.shoulder = job.cover.shoulder();
    options.facets = facets_of_part(job.context);
    return options;
}

} // namespace

FootContours::FootContours(const CleanupJob& job, const Progress& progress)
    : job_(job),
      lowest_(lowest_allowed(job.context, job.settings)), slopes_{shallowest_wall,
                                                                  0.5 * pi + tolerance::level_angle},
      tell_(job.context.contact, job.cover, facets_of_part(job.context), job.allowance),
      steps_(job.cover, standing_cusp(job.cusp, job.chord), 2 * job.radius),
      maker_(job.lift, tell_, job.context.contact->mesh(), foot_options(job, slopes_), progress) {}

/// Does the cutter at the lowest height, beside the wall, leave no more than the tolerance up to the upper
/// border of the strip? Above the place where it touches the wall leans away from its side.
bool FootContours::is_cut_by_one_level(const Mesh& strip) const {
    for (std::size_t f = 0; f < strip.facet_count(); ++f) {
        const Vec3 n = job_.side.towards_tool(strip.facet_normal(f));
        if (!(n.z() > tolerance::vertical_normal_z)) continue;
        if (n.z() > std::cos(shallowest_wall)) return false;
        const double touched = lowest_ - job_.cover.tip_offset(n).z();
        for (int k = 0; k < 3; ++k)
            if ((strip.corner(f, k).z() - touched) * n.z() > job_.cusp) return false;
    }
    return true;
}

/// What of a pass touches beside one of the samples.
std::vector<Pass> FootContours::beside(const Pass& pass, const PointGrid& samples) const {
    const double within = beside_share * job_.radius;
    const std::vector<double> arc = arc_lengths(pass);
    std::vector<Interval> ranges;
    const auto look = [&](const Vec3& at, double along) {
        if (samples.near_until(at, within, [&](std::size_t k) {
                return (samples.points()[k] - at).squaredNorm() < within * within;
            }))
            ranges.push_back({along - within, along + within});
    };
    look(pass.cc[0].point, 0);
    for (std::size_t i = 1; i < pass.cl.size(); ++i) {
        // Along a straight wall a pass has no places but its ends.
        const double n = std::ceil((arc[i] - arc[i - 1]) / within);
        const Vec3 &a = pass.cc[i - 1].point, &b = pass.cc[i].point;
        for (double k = 1; k <= n; ++k)
            look(a + k / n * (b - a), arc[i - 1] + k / n * (arc[i] - arc[i - 1]));
    }
    ranges = joined(std::move(ranges), contour_bridged_radii * job_.radius);
    for (Interval& r : ranges)
        r = {std::max(r.lo, 0.0), std::min(r.hi, arc.back())};
    return pieces_of(pass, arc, ranges, [&](const Vec3& tip) { return maker_.contact(tip, Vec2::Zero()); });
}

std::vector<Pass> FootContours::passes(const LeftStrip& strip, const Progress& progress) const {
    const Mesh& mesh = *strip.piece.mesh;
    if (!is_cut_by_one_level(mesh)) return {};
    const double spacing = grid_share * job_.radius;
    LevelChoice choice(steps_, slopes_, spacing);
    const Box3 box = mesh.box();
    const double beyond = job_.radius + job_.allowance + 2 * spacing;
    const int columns = int(std::ceil((box.size().x() + 2 * beyond) / spacing)) + 1;
    const LevelField field(
        job_.lift, tell_, box, beyond, spacing,
        [&](int first, std::span<const TipTouch> touches) {
            choice.look(first, columns, touches, progress.part(0, 0));
        },
        progress);
    if (choice.empty()) return {};
    LineTolerance fine;
    fine.below = fine.above = 0.5 * job_.chord;
    fine.spacing = safe_spacing(job_.profile, fine.below);
    const PointGrid samples = samples_of(mesh, job_.radius, progress);
    const ContourFinder finder(job_.lift, field, choice, fine);
    std::vector<Pass> passes;
    for (const Contour& contour : finder.contours({lowest_, {}}, progress))
        for (Pass& pass : maker_.passes(contour, lowest_, progress)) {
            // Contours have the part on their left; with it on the right the tool climbs.
            std::reverse(pass.cl.begin(), pass.cl.end());
            std::reverse(pass.cc.begin(), pass.cc.end());
            for (Pass& piece : beside(pass, samples))
                passes.push_back(std::move(piece));
        }
    return passes;
}

} // namespace facetmill
