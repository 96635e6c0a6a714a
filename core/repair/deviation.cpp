#include "core/repair/deviation.h"

#include "core/base/parallel.h"
#include "core/mesh/facet_boxes.h"
#include "core/mesh/triangle_distance.h"
#include "core/mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace facetmill {

namespace {

constexpr std::size_t facets_per_block = 4096;
/// Halvings of a triangle: from its size down to a millionth of it.
constexpr int max_halvings = 30;

/// The same for facets with the same corners.
struct CornerKey {
    std::uint64_t hash;
    Index facet;
    bool operator<(const CornerKey& other) const {
        return hash < other.hash || (hash == other.hash && facet < other.facet);
    }
};

std::uint64_t corner_hash(const Mesh& mesh, std::size_t f) {
    std::uint64_t sum = 0;
    for (int k = 0; k < 3; ++k)
        sum += detail::position_hash(mesh.corner(f, k) + Vec3(0, 0, 0));
    return sum;
}

bool same_corners(const Mesh& a, std::size_t f, const Mesh& b, std::size_t g) {
    for (int k = 0; k < 3; ++k) {
        bool found = false;
        for (int l = 0; l < 3; ++l)
            found = found || a.corner(f, k) == b.corner(g, l);
        if (!found) return false;
    }
    return true;
}

} // namespace

DeviationIndex::DeviationIndex(const Mesh& mesh, const Progress& progress, double reach)
    : mesh_(mesh), reach2_(reach * reach), tree_(facet_boxes(mesh), progress) {
    double sum = 0;
    normals_.reserve(mesh.facet_count());
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        sum += (mesh.corner(f, 1) - mesh.corner(f, 0)).norm();
        normals_.push_back(mesh.facet_normal(f));
    }
    grain_ = sum / double(std::max<std::size_t>(mesh.facet_count(), 1));
}

double DeviationIndex::squared(const Vec3& p, Index f) const {
    return squared_distance(p, mesh_.corner(f, 0), mesh_.corner(f, 1), mesh_.corner(f, 2));
}

DeviationIndex::Place DeviationIndex::place(const Vec3& p, Index hint) const {
    Place found;
    found.at = p;
    const double from_hint = hint == no_index ? infinity : squared(p, hint);
    for (const double start : {reach2_, infinity}) {
        double d2 = start;
        if (from_hint <= start) {
            d2 = from_hint;
            found.facet = hint;
        }
        tree_.nearest(p, d2, [&](std::size_t f) {
            const double at = squared(p, Index(f));
            if (at < d2) {
                d2 = at;
                found.facet = Index(f);
            }
        });
        if (found.facet != no_index) break;
    }
    if (found.facet == no_index) return found;
    found.nearest = nearest_in_triangle(p, mesh_.corner(found.facet, 0), mesh_.corner(found.facet, 1),
                                        mesh_.corner(found.facet, 2));
    found.distance = (found.nearest - p).norm();
    return found;
}

bool DeviationIndex::is_within(const Vec3& p, double bound2) const {
    bool found = false;
    double near2 = std::nextafter(bound2, infinity);
    tree_.nearest(p, near2, [&](std::size_t f) {
        if (squared(p, Index(f)) > bound2) return;
        found = true;
        near2 = 0; // enough
    });
    return found;
}

double DeviationIndex::bend(const std::array<Place, 3>& corners, double longest) const {
    if (corners[0].facet == corners[1].facet && corners[1].facet == corners[2].facet) return 0;
    const Vec3 cross =
        (corners[1].nearest - corners[0].nearest).cross(corners[2].nearest - corners[0].nearest);
    const double length = cross.norm();
    if (!(length > 0)) return longest;
    double sine2 = 0;
    for (const Place& corner : corners) {
        const Vec3& n = normals_[corner.facet];
        if (n.dot(cross) <= 0.5 * length) return longest;
        sine2 = std::max(sine2, n.cross(cross).squaredNorm() / (length * length));
    }
    // No place of a triangle is farther than this share of its longest side from its nearest corner.
    constexpr double reach = 0.58;
    return reach * longest * std::sqrt(sine2 / (1 - sine2));
}

double DeviationIndex::farthest(const Place& a, const Place& b, const Place& c, double floor,
                                double accuracy) const {
    struct Part {
        std::array<Place, 3> corners;
        int halvings = 0;
    };
    double result = 0;
    std::vector<Part> waiting{{{a, b, c}, 0}};
    while (!waiting.empty()) {
        const Part part = waiting.back();
        waiting.pop_back();
        const auto& q = part.corners;
        std::size_t k = 0;
        double longest2 = 0;
        for (std::size_t i = 0; i < 3; ++i)
            if (const double l = (q[(i + 1) % 3].at - q[i].at).squaredNorm(); l > longest2) {
                longest2 = l;
                k = i;
            }
        const double longest = std::sqrt(longest2);
        const double low = std::max({q[0].distance, q[1].distance, q[2].distance});
        const double high = low + bend(q, longest);
        const bool fine = longest <= grain_ || high == low;
        if ((fine && high <= std::max({floor, result, low + accuracy})) || part.halvings >= max_halvings) {
            result = std::max(result, high);
            continue;
        }
        const Place middle = place(0.5 * (q[k].at + q[(k + 1) % 3].at), q[k].facet);
        waiting.push_back({{q[k], middle, q[(k + 2) % 3]}, part.halvings + 1});
        waiting.push_back({{middle, q[(k + 1) % 3], q[(k + 2) % 3]}, part.halvings + 1});
    }
    return result;
}

std::vector<Index> facets_beyond(const Mesh& mesh, const DeviationIndex& surface, double bound,
                                 double accuracy, const std::vector<char>& same, double& deviation,
                                 const Progress& progress) {
    std::vector<char> asked(mesh.vertices.size(), 0);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        if (same.empty() || !same[f])
            for (const Index v : mesh.facets[f])
                asked[v] = 1;
    std::vector<DeviationIndex::Place> places(mesh.vertices.size());
    parallel_for(places.size(), 1024, progress.part(0, 0.5), [&](std::size_t v) {
        if (asked[v]) places[v] = surface.place(mesh.vertices[v]);
    });
    struct Found {
        std::vector<Index> facets;
        double farthest = 0;
    };
    Found all = parallel_reduce(
        mesh.facet_count(), facets_per_block, Found{}, progress.part(0.5, 1),
        [&](std::size_t begin, std::size_t end) {
            Found found;
            for (std::size_t f = begin; f < end; ++f) {
                if (f % 256 == 0) progress.check();
                if (!same.empty() && same[f]) continue;
                const Facet& c = mesh.facets[f];
                const double d = surface.farthest(places[c[0]], places[c[1]], places[c[2]],
                                                  std::min(found.farthest, bound), accuracy);
                found.farthest = std::max(found.farthest, d);
                if (d > bound) found.facets.push_back(Index(f));
            }
            return found;
        },
        [](Found total, const Found& part) {
            total.facets.insert(total.facets.end(), part.facets.begin(), part.facets.end());
            total.farthest = std::max(total.farthest, part.farthest);
            return total;
        });
    deviation = all.farthest;
    return std::move(all.facets);
}

std::vector<char> facets_in_both(const Mesh& mesh, const Mesh& other, const Progress& progress) {
    std::vector<CornerKey> keys(other.facet_count());
    parallel_for(keys.size(), facets_per_block, progress.part(0, 0.3), [&](std::size_t f) {
        keys[f] = {corner_hash(other, f), Index(f)};
    });
    std::sort(keys.begin(), keys.end());
    std::vector<char> both(mesh.facet_count(), 0);
    parallel_for(both.size(), facets_per_block, progress.part(0.3, 1), [&](std::size_t f) {
        const std::uint64_t hash = corner_hash(mesh, f);
        for (auto it = std::lower_bound(keys.begin(), keys.end(), CornerKey{hash, 0});
             it != keys.end() && it->hash == hash && !both[f]; ++it)
            both[f] = same_corners(mesh, f, other, it->facet);
    });
    return both;
}

SurfaceDeviation surface_deviation(const Mesh& first, const Mesh& second, double accuracy,
                                   const Progress& progress) {
    const auto farthest = [&](const Mesh& from, const Mesh& to, const Progress& part) {
        const DeviationIndex index(to, part.part(0, 0.3));
        double deviation = 0;
        facets_beyond(from, index, infinity, accuracy, facets_in_both(from, to, part.part(0.3, 0.4)),
                      deviation, part.part(0.4, 1));
        return deviation;
    };
    SurfaceDeviation result;
    result.forward = farthest(first, second, progress.part(0, 0.5));
    result.backward = farthest(second, first, progress.part(0.5, 1));
    return result;
}

} // namespace facetmill
