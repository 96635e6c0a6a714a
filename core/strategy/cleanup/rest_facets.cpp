#include "core/strategy/cleanup/rest_facets.h"

#include "core/base/tolerances.h"
#include "core/mesh/index_pair.h"
#include "core/strategy/cleanup/mark_grid.h"
#include "core/strategy/surface/cell_set.h"
#include "core/strategy/surface/point_grid.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace facetmill {

namespace {

constexpr std::size_t divided_per_check = 2048;
/// Edges of facets in a band are not longer than this many radii of the cutter, or than this share of the
/// half width of what a ball of that radius touches within the tolerance.
constexpr double edge_share = 0.07, touched_share = 0.7;
/// Cells that say where a band may be, in radii; larger where there would be more than so many.
constexpr double mark_share = 0.12, max_cells = 4e6;
/// Samples are not farther apart than this many radii.
constexpr double sample_share = 0.25;
/// One sample in so many radii stands for those about it; they are looked for in cells of so many.
constexpr double thin_share = 0.1, place_cell_share = 0.5;
constexpr int max_facet_divisions = 24;
/// Pieces of facets, about: where they would be more they are larger.
constexpr double max_pieces = 1e6, piece_share = 0.25;

class FacetDivider {
public:
    explicit FacetDivider(const ValleyInput& input)
        : in_(input), radius_(input.cover->radius()),
          longest_(std::max(edge_share * radius_, touched_share * std::sqrt(2 * radius_ * input.tolerance))),
          marks_(input.mesh->box(), mark_cell(), radius_), places_(place_cell_share * radius_) {}

    RestFacets run(const std::vector<RestSample>& samples, const Progress& progress) {
        mark(samples, progress.part(0, 0.2));
        const Mesh& mesh = *in_.mesh;
        out_.points = mesh.vertices;
        if (samples.empty()) return std::move(out_);
        // A piece has this share of the square of the longest edge, or more.
        longest_ = std::max(longest_, std::sqrt(marked_area() / (piece_share * max_pieces)));
        const Progress dividing = progress.part(0.2, 1);
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            if (f % divided_per_check == 0) dividing.set(double(f) / double(mesh.facet_count()));
            const Vec3 n = in_.side->towards_tool(mesh.facet_normal(f));
            if (n == Vec3::Zero() || n.z() < -tolerance::vertical_normal_z) continue;
            divide(mesh.facets[f], Index(f), 0);
        }
        // There are many, and they are kept until bands are cut out of them.
        middles_ = {};
        out_.points.shrink_to_fit();
        out_.facets.shrink_to_fit();
        return std::move(out_);
    }

private:
    using Corners = std::array<Index, 3>;

    double mark_cell() const {
        const Vec3 size = in_.mesh->box().size();
        return std::max(mark_share * radius_, std::sqrt(size.x() * size.y() / max_cells));
    }

    void mark(const std::vector<RestSample>& samples, const Progress& progress) {
        CellSet thin(thin_share * radius_);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (i % divided_per_check == 0) progress.check();
            marks_.mark(samples[i].point.head<2>(), sample_share * radius_);
            if (thin.add_first(samples[i].point)) places_.add(samples[i].point);
        }
        marks_.finish();
    }

    /// Is a sample near a box? Of a box wider than the cutter's radius heights are not asked.
    bool is_near(const Vec3& lo, const Vec3& hi) const {
        if (!marks_.any(lo.head<2>(), hi.head<2>())) return false;
        const double size = (hi - lo).maxCoeff(), beside = (sample_share + thin_share) * radius_;
        if (size > radius_) return true;
        return places_.near_until(0.5 * (lo + hi), 0.5 * size + beside, [&](std::size_t i) {
            const Vec3& p = places_.points()[i];
            return ((p - lo).array() >= -beside).all() && ((hi - p).array() >= -beside).all();
        });
    }

    /// Area of all facets that are to be divided, if only somewhere.
    double marked_area() const {
        const Mesh& mesh = *in_.mesh;
        double area = 0;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            const Vec3 &a = mesh.corner(f, 0), &b = mesh.corner(f, 1), &c = mesh.corner(f, 2);
            if (is_near(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)))
                area += 0.5 * mesh.facet_cross(f).norm();
        }
        return area;
    }

    Index middle(Index a, Index b) {
        const auto [found, is_new] = middles_.try_emplace(pair_of(a, b), Index(out_.points.size()));
        if (is_new) out_.points.push_back(0.5 * (out_.points[a] + out_.points[b]));
        return found->second;
    }

    bool splits(Index a, Index b) const {
        const Vec3 &p = out_.points[a], &q = out_.points[b];
        return (p - q).norm() > longest_ && is_near(p.cwiseMin(q), p.cwiseMax(q));
    }

    double longest_edge(const Corners& c) const {
        double longest = 0;
        for (std::size_t k = 0; k < 3; ++k)
            longest = std::max(longest, (out_.points[c[k]] - out_.points[c[(k + 1) % 3]]).norm());
        return longest;
    }

    /// Whether an edge is halved depends on the edge alone, so that neighbours agree.
    void divide(const Corners& c, Index facet, int depth) {
        const auto& points = out_.points;
        const Vec3 lo = points[c[0]].cwiseMin(points[c[1]]).cwiseMin(points[c[2]]);
        const Vec3 hi = points[c[0]].cwiseMax(points[c[1]]).cwiseMax(points[c[2]]);
        if (!is_near(lo, hi)) return;
        int split = -1, count = 0, whole = -1;
        for (int k = 0; k < 3; ++k) {
            if (splits(c[std::size_t(k)], c[std::size_t((k + 1) % 3)])) {
                ++count;
                split = k;
            } else {
                whole = k;
            }
        }
        // A large facet of which no edge is near to a band may still hold one.
        const bool inside = count == 0 && longest_edge(c) > longest_;
        if (depth == max_facet_divisions || (count == 0 && !inside)) {
            out_.facets.push_back({c, facet});
            return;
        }
        if (count == 0)
            divide_about_middle(c, facet, depth + 1);
        else if (count == 1)
            divide_in_two(c, split, facet, depth + 1);
        else if (count == 2)
            divide_in_three(c, whole, facet, depth + 1);
        else
            divide_in_four(c, facet, depth + 1);
    }

    static Index at(const Corners& c, int k) { return c[std::size_t(k % 3)]; }

    void divide_about_middle(const Corners& c, Index facet, int depth) {
        const auto center = Index(out_.points.size());
        out_.points.push_back((out_.points[c[0]] + out_.points[c[1]] + out_.points[c[2]]) / 3);
        for (int k = 0; k < 3; ++k)
            divide({at(c, k), at(c, k + 1), center}, facet, depth);
    }
    void divide_in_two(const Corners& c, int split, Index facet, int depth) {
        const Index m = middle(at(c, split), at(c, split + 1));
        divide({at(c, split), m, at(c, split + 2)}, facet, depth);
        divide({m, at(c, split + 1), at(c, split + 2)}, facet, depth);
    }
    /// The edge from `whole` stays; both others are halved.
    void divide_in_three(const Corners& c, int whole, Index facet, int depth) {
        const Index m1 = middle(at(c, whole + 1), at(c, whole + 2)),
                    m2 = middle(at(c, whole + 2), at(c, whole));
        divide({m2, m1, at(c, whole + 2)}, facet, depth);
        divide({at(c, whole), at(c, whole + 1), m1}, facet, depth);
        divide({at(c, whole), m1, m2}, facet, depth);
    }
    void divide_in_four(const Corners& c, Index facet, int depth) {
        const Index m[3] = {middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0])};
        divide({c[0], m[0], m[2]}, facet, depth);
        divide({m[0], c[1], m[1]}, facet, depth);
        divide({m[2], m[1], c[2]}, facet, depth);
        divide({m[0], m[1], m[2]}, facet, depth);
    }

    const ValleyInput& in_;
    double radius_, longest_;
    MarkGrid marks_;   ///< beside samples, seen from above
    PointGrid places_; ///< samples
    RestFacets out_;
    std::unordered_map<std::uint64_t, Index> middles_;
};

} // namespace

RestFacets divided_near_rest(const ValleyInput& input, const std::vector<RestSample>& samples,
                             const Progress& progress) {
    return FacetDivider(input).run(samples, progress);
}

} // namespace facetmill
