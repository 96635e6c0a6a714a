#include "core/strategy/lathe/lathe_samples.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/surface/facet_rows.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Facets that a thread takes at a time; samples between two looks at the cancel flag.
constexpr std::size_t sampled_facets_per_block = 256, samples_per_check = 64;
/// Samples are as far apart as hollows of the allowed depth are wide, within these shares of the cutter's
/// radius. A hollow narrower than they are is not missed by that: what keeps the cutter from it keeps it from
/// the edges too, which are looked at one by one (lathe_creases.h).
constexpr double finest_share = 0.1, coarsest_share = 0.3;
/// More samples than that are not taken, one for every block of facets aside.
constexpr double max_samples = 1e5;
/// Facets smaller than this share of the samples' spacing squared share a sample.
constexpr double min_piece = 0.25;

ReachSampler::Found joined_samples(ReachSampler::Found a, const ReachSampler::Found& b) {
    a.area += b.area;
    a.doubtful.insert(a.doubtful.end(), b.doubtful.begin(), b.doubtful.end());
    return a;
}

} // namespace

ReachSampler::ReachSampler(const LatheCommon& settings, const LatheProbe& probe, const Mesh& mesh)
    : probe_(probe), mesh_(mesh), named_from_(settings.start.is_number()),
      named_to_(settings.stop.is_number()) {
    const double radius = probe.radius();
    double area = 0;
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
        area += 0.5 * mesh_.facet_cross(f).norm();
        for (int k = 0; k < 3; ++k) {
            from_ = std::min(from_, probe.frame().along(mesh_.corner(f, k)));
            to_ = std::max(to_, probe.frame().along(mesh_.corner(f, k)));
        }
    }
    spacing_ =
        std::clamp(std::sqrt(2 * radius * probe.allowed()), finest_share * radius, coarsest_share * radius);
    spacing_ = std::max({spacing_, std::sqrt(area / max_samples), tolerance::smallest_extent});
}

ReachSampler::Found ReachSampler::facets(const Progress& progress) const {
    return parallel_reduce(
        mesh_.facet_count(), sampled_facets_per_block, Found(), progress,
        [&](std::size_t begin, std::size_t end) {
            Found found;
            LatheField::Hint hint;
            std::size_t looked = 0;
            double carried = 0; // area of facets too small for a sample each
            for (std::size_t f = begin; f < end; ++f) {
                const Vec3 n = mesh_.facet_normal(f);
                if (n == Vec3::Zero() || is_end(f, n)) continue;
                const FacetRows rows(mesh_, f, spacing_);
                found.area += rows.area();
                const double whole = carried + rows.area();
                carried = 0;
                if (whole < min_piece * spacing_ * spacing_ && f + 1 < end) {
                    carried = whole;
                    continue;
                }
                const double scale = rows.area() > 0 ? whole / rows.area() : 0;
                for (std::size_t row = 0; row < rows.rows(); ++row)
                    for (std::size_t column = 0; column < rows.columns(row); ++column) {
                        if (++looked % samples_per_check == 0) progress.check();
                        sample(rows.point(row, column), n, scale * rows.weight(row), false, hint,
                               found.doubtful);
                    }
            }
            return found;
        },
        joined_samples);
}

void ReachSampler::sample(const Vec3& p, const Vec3& facet_normal, double area, bool alone,
                          LatheField::Hint& hint, std::vector<ReachSample>& doubtful) const {
    const double along = probe_.frame().along(p);
    if (is_beyond(along)) return;
    // Either side of a facet may be out, as the winding of a scan says nothing.
    const Vec3 n =
        facet_normal.dot(probe_.frame().radial(probe_.angle_of(p))) < 0 ? Vec3(-facet_normal) : facet_normal;
    const LathePlace place = probe_.place_over(p, n);
    if (is_beyond(place.y)) return;
    const LatheProbe::Stand tool = probe_.stand(place, hint);
    const LatheProbe::Rest here = probe_.rest(tool, p, n);
    if (here.height <= probe_.allowed()) return;
    ReachSample s;
    s.p = p;
    s.n = n;
    s.angle = probe_.angle_of(p);
    if (s.angle < 0) s.angle += 2 * pi;
    s.y = along;
    s.area = area;
    s.half = std::max(std::min({0.5 * std::sqrt(area), along - from_, to_ - along}), 0.0);
    s.alone = alone;
    s.distance = here.distance;
    s.at = tool.at;
    doubtful.push_back(s);
}

bool ReachSampler::is_end(std::size_t f, const Vec3& n) const {
    if (std::abs(n.dot(probe_.frame().axis().direction)) < 1 - tolerance::level_angle) return false;
    const double slack = tolerance::same_shape * (to_ - from_);
    const double y = probe_.frame().along(mesh_.corner(f, 0));
    return y < from_ + slack || y > to_ - slack;
}

} // namespace facetmill
