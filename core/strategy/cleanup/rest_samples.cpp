#include "core/strategy/cleanup/rest_samples.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/cleanup/standing.h"
#include "core/strategy/surface/cell_set.h"
#include "core/strategy/surface/facet_rows.h"

namespace facetmill {

namespace {

constexpr std::size_t block_facets = 256;
constexpr std::size_t sampled_per_check = 8192;
constexpr double max_samples = 4e6;
/// Facets with edges shorter than this share of the samples' spacing are small.
constexpr double small_share = 0.6;
/// Samples are no less and no more than this apart, in radii.
constexpr double min_spacing = 0.05, max_spacing = 0.25;

double spacing_of(const ValleyInput& in) {
    const double radius = in.cover->radius();
    const double spacing = std::clamp(in.sample_share * std::sqrt(2 * radius * in.tolerance),
                                      min_spacing * radius, max_spacing * radius);
    double area = 0;
    for (std::size_t f = 0; f < in.mesh->facet_count(); ++f)
        area += 0.5 * in.mesh->facet_cross(f).norm();
    return std::max(spacing, std::sqrt(area / max_samples));
}

/// Which of five directions a facet faces: up, or the sides along X and Y.
int facing_of(const Vec3& n) {
    const Vec3 size = n.cwiseAbs();
    if (size.z() >= size.x() && size.z() >= size.y()) return 0;
    if (size.x() >= size.y()) return n.x() > 0 ? 1 : 2;
    return n.y() > 0 ? 3 : 4;
}

/// The facets that a tool can come to. Where they are small against the spacing, one a cell is enough for
/// each direction that they face.
std::vector<Index> asked_facets(const ValleyInput& in, double spacing, const Progress& progress) {
    const Mesh& mesh = *in.mesh;
    // What is done with each: left out, asked, or (from `small` on) asked where it is the first in its cell
    // that faces its direction.
    enum : std::uint8_t { out, asked_for, small };
    std::vector<std::uint8_t> what(mesh.facet_count(), out);
    parallel_for(mesh.facet_count(), sampled_per_check, progress.part(0, 0), [&](std::size_t f) {
        const Vec3 n = in.side->towards_tool(mesh.facet_normal(f));
        if (n == Vec3::Zero() || n.z() < -tolerance::vertical_normal_z) return;
        const Vec3 &a = mesh.corner(f, 0), &b = mesh.corner(f, 1), &c = mesh.corner(f, 2);
        const double longest2 =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        const bool is_small = longest2 < small_share * small_share * spacing * spacing;
        what[f] = is_small ? std::uint8_t(small + facing_of(n)) : std::uint8_t(asked_for);
    });
    std::array<CellSet, 5> seen{CellSet(spacing), CellSet(spacing), CellSet(spacing), CellSet(spacing),
                                CellSet(spacing)};
    std::vector<Index> asked;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % sampled_per_check == 0) progress.check();
        if (what[f] == out) continue;
        if (what[f] >= small
            && !seen[std::size_t(what[f] - small)].add_first(
                (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3))
            continue;
        asked.push_back(Index(f));
    }
    return asked;
}

} // namespace

std::vector<RestSample> rest_samples(const ValleyInput& input, const Progress& progress) {
    const Mesh& mesh = *input.mesh;
    const double spacing = spacing_of(input);
    const std::vector<Index> asked = asked_facets(input, spacing, progress);
    using Samples = std::vector<RestSample>;
    return parallel_reduce(
        asked.size(), block_facets, Samples(), progress,
        [&](std::size_t begin, std::size_t end) {
            Samples found;
            LiftHint hint;
            Standing::Hint near;
            for (std::size_t i = begin; i < end; ++i) {
                const Index f = asked[i];
                const Vec3 n = input.side->towards_tool(mesh.facet_normal(f));
                const FacetRows rows(mesh, f, spacing);
                for (std::size_t r = 0; r < rows.rows(); ++r)
                    for (std::size_t c = 0; c < rows.columns(r); ++c) {
                        if (c % 512 == 0) progress.check();
                        const RestSample s = nearest_touch(input, rows.point(r, c), n, hint);
                        if (!(s.gap > input.tolerance)) continue;
                        // In the raw material, where nothing else was before it?
                        if (!input.standing
                            || input.standing->stands(s.point, input.standing->raw_over(s.point, s.normal),
                                                      input.tolerance, near))
                            found.push_back(s);
                    }
            }
            return found;
        },
        [](Samples a, const Samples& b) {
            a.insert(a.end(), b.begin(), b.end());
            return a;
        });
}

} // namespace facetmill
