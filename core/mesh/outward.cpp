#include "core/mesh/outward.h"

#include "core/base/parallel.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/facet_groups.h"
#include "core/mesh/sight.h"

#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t steps_per_check = 8192;
/// Rays from each side of a patch: so many that the vote of a patch whose sides differ is clear; for many
/// patches fewer, so that all together take a second or two.
constexpr std::size_t max_rays = 256, min_rays = 4;
/// As many first: where they leave no doubt there are no more.
constexpr std::size_t fewest_rays = 32;
constexpr std::size_t rays_altogether = 1'000'000;
/// One side is out where the other has at most this share of its rays that reach the open. A sheet is seen
/// from both: from above a deep valley less than from below.
constexpr double clear_vote = 0.2;
/// A sheet whose area seen from above and that seen from below differ by less than this share stands upright.
constexpr double upright_share = 0.1;
/// A cup that faces up has at least such a share of its area more from above.
constexpr double cup_share = 0.01;

struct Patch {
    std::vector<Index> facets;
    std::vector<double> areas; ///< sums of the facets' areas, ascending
    bool closed = true;
    double volume = 0, up = 0; ///< up: area seen from above less that seen from below
};

std::vector<Patch> patches_of(const Mesh& mesh, const Progress& progress) {
    const std::size_t n = mesh.facet_count();
    FacetGroups groups(n);
    std::vector<char> rim(n, 0);
    const EdgeTable table(mesh, progress);
    for (std::size_t low = 0; low < table.vertex_count(); ++low) {
        if (low % steps_per_check == 0) progress.check();
        table.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
            const bool agree =
                sides.size() == 2 && side_start(mesh, sides[0].side) != side_start(mesh, sides[1].side);
            if (agree) groups.join(sides[0].facet(), sides[1].facet());
            if (agree) return;
            for (const EdgeSide& side : sides)
                rim[side.facet()] = 1;
        });
    }
    std::vector<Patch> patches;
    std::vector<Index> place(n, no_index);
    const Vec3 middle = mesh.box().center();
    for (std::size_t f = 0; f < n; ++f) {
        if (f % steps_per_check == 0) progress.check();
        Index& at = place[groups.of(Index(f))];
        if (at == no_index) {
            at = Index(patches.size());
            patches.emplace_back();
        }
        Patch& patch = patches[at];
        const Vec3 cross = mesh.facet_cross(f);
        patch.facets.push_back(Index(f));
        patch.areas.push_back((patch.areas.empty() ? 0.0 : patch.areas.back()) + 0.5 * cross.norm());
        patch.closed = patch.closed && !rim[f];
        patch.volume += cross.dot(mesh.corner(f, 0) - middle) / 6;
        patch.up += 0.5 * cross.z();
    }
    return patches;
}

/// Numbers from 0 to 1 that look random and are the same for the same seed (splitmix64).
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : state_(seed) {}
    double next() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

/// How many rays from each side of a patch reach the open.
struct Votes {
    std::size_t front = 0, back = 0;
    /// Few are enough where one side sees the open and the other hardly ever; where it is asked no more than
    /// that, also where both do.
    bool are_clear(bool which_more) const {
        const std::size_t less = std::min(front, back), more = std::max(front, back);
        if (front + back < fewest_rays / 2) return false;
        return less * fewest_rays <= more || (!which_more && 2 * less >= more);
    }
};

/// Adds so many rays of each side; none after the first that is free where only that is asked.
void cast(const Mesh& mesh, const Patch& patch, const OpenSight& sight, std::size_t rays, bool any,
          Numbers& numbers, Votes& votes) {
    for (std::size_t i = 0; i < rays && !(any && votes.front + votes.back > 0); ++i) {
        // By area: a point of the patch, and a direction off it with the cosine's weight.
        const double area = (double(i) + numbers.next()) / double(rays) * patch.areas.back();
        const auto at = std::upper_bound(patch.areas.begin(), patch.areas.end() - 1, area);
        const Index f = patch.facets[std::size_t(at - patch.areas.begin())];
        const double root = std::sqrt(numbers.next()), share = numbers.next();
        const Vec3 p = (1 - root) * mesh.corner(f, 0) + root * (1 - share) * mesh.corner(f, 1)
                       + root * share * mesh.corner(f, 2);
        const double turn = 2 * pi * numbers.next(), off = std::sqrt(numbers.next());
        const Vec3 n = mesh.facet_normal(f);
        if (n.isZero(0)) continue;
        const Vec3 x = n.unitOrthogonal(), y = n.cross(x);
        const Vec3 aside = off * (std::cos(turn) * x + std::sin(turn) * y);
        const Vec3 out = std::sqrt(std::max(0.0, 1 - off * off)) * n;
        votes.front += sight.is_free(p, aside + out);
        votes.back += sight.is_free(p, aside - out);
    }
}

OutwardSides::Side side_of(const Mesh& mesh, const Patch& patch, const OpenSight& sight, std::size_t rays,
                           double whole_area) {
    Numbers numbers(patch.facets.front());
    Votes votes;
    const std::size_t few = std::min(rays, fewest_rays);
    cast(mesh, patch, sight, few, patch.closed, numbers, votes);
    const double area = patch.areas.back();
    const bool leans = std::abs(patch.up) > upright_share * area;
    if (!votes.are_clear(!leans)) cast(mesh, patch, sight, rays - few, patch.closed, numbers, votes);
    const auto [front, back] = votes;
    if (front + back == 0) return OutwardSides::buried;
    if (patch.closed) return patch.volume < 0 ? OutwardSides::reversed : OutwardSides::as_wound;
    // A cup that is most of the mesh may be a deep pocket or a vase: there only its winding can tell.
    const bool cup = area > 0.5 * whole_area && patch.up > cup_share * area;
    if (double(front) <= clear_vote * double(back))
        return cup ? OutwardSides::as_wound : OutwardSides::reversed;
    if (double(back) <= clear_vote * double(front)) return OutwardSides::as_wound;
    const bool down = leans ? patch.up < 0 : front < back;
    return down ? OutwardSides::reversed : OutwardSides::as_wound;
}

} // namespace

OutwardSides outward_sides(const Mesh& mesh, const Progress& progress, OpenSide open) {
    OutwardSides result;
    result.sides.assign(mesh.facet_count(), OutwardSides::as_wound);
    const std::vector<Patch> patches = patches_of(mesh, progress.part(0, 0.3));
    result.patches = patches.size();
    if (patches.empty() || (patches.size() == 1 && patches[0].closed && patches[0].volume > 0)) return result;
    const std::size_t rays = std::clamp(rays_altogether / patches.size(), min_rays, max_rays);
    const OpenSight sight(mesh, 2 * rays * patches.size(), progress.part(0.3, 0.5));
    std::vector<OutwardSides::Side> sides(patches.size());
    double area = 0;
    for (const Patch& patch : patches)
        area += patch.areas.back();
    parallel_for(patches.size(), 64, progress.part(0.5, 1.0),
                 [&](std::size_t i) { sides[i] = side_of(mesh, patches[i], sight, rays, area); });
    for (std::size_t i = 0; i < patches.size(); ++i) {
        if (open == OpenSide::other && !patches[i].closed && sides[i] != OutwardSides::buried)
            sides[i] = sides[i] == OutwardSides::reversed ? OutwardSides::as_wound : OutwardSides::reversed;
        for (const Index f : patches[i].facets)
            result.sides[f] = sides[i];
        if (sides[i] == OutwardSides::reversed) result.turned_facets += patches[i].facets.size();
        if (sides[i] == OutwardSides::buried) result.buried_facets += patches[i].facets.size();
    }
    return result;
}

MeshPtr wound_outward(const MeshPtr& mesh, const OutwardSides& sides) {
    if (sides.turned_facets == 0) return mesh;
    auto turned = std::make_shared<Mesh>(*mesh);
    for (std::size_t f = 0; f < turned->facet_count(); ++f)
        if (sides.sides[f] == OutwardSides::reversed) std::swap(turned->facets[f][1], turned->facets[f][2]);
    return turned;
}

} // namespace facetmill
