#include "core/mesh/sample_tessellate.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace facetmill {

namespace {

/// Edge k runs from corner k to corner k + 1; across it lies triangle neighbour[k].
struct Triangle {
    std::array<Index, 3> corner{};
    std::array<Vec2, 3>
        at; ///< parameters of the corners; of the corner and not the vertex, since a seam has two
    std::array<Index, 3> neighbor{no_index, no_index, no_index};
    bool judged = false;
};

class Refinement {
public:
    Refinement(const PatchFunction& patch, const PatchGrid& grid, double allowed, const std::string& what)
        : patch_(patch), allowed_(allowed), what_(what) {
        start(grid);
    }

    void run(const Progress& progress) {
        std::vector<double> error;
        for (int round = 0;; ++round) {
            // Facets a round leaves alone are judged once; each round roughly halves the largest error.
            std::vector<Index> open;
            for (Index t = 0; t < triangles_.size(); ++t)
                if (!triangles_[t].judged) open.push_back(t);
            if (open.empty()) return;
            error.assign(open.size(), 0.0);
            const double from = 1.0 - 1.0 / (1.0 + 0.25 * round), to = 1.0 - 1.0 / (1.0 + 0.25 * (round + 1));
            parallel_for(open.size(), 256, progress.part(from, to),
                         [&](std::size_t i) { error[i] = deviation(triangles_[open[i]]); });
            if (round == 0) {
                // Halving a facet halves its error: tell at once, and not after minutes, that it is too much.
                double facets = 0.0;
                for (double e : error)
                    facets += std::max(1.0, e / allowed_);
                if (!(facets < double(sample_facet_limit))) throw_too_many_facets(what_);
            }
            for (std::size_t i = 0; i < open.size(); ++i) {
                if (i % 256 == 0) progress.check();
                Triangle& t = triangles_[open[i]];
                t.judged = t.judged || error[i] <= allowed_;
            }
            std::size_t splits = 0;
            for (std::size_t i = 0; i < open.size(); ++i) {
                // An earlier cut of this round may have changed the facet; its halves are judged in the next
                // one.
                if (error[i] <= allowed_ || changed_[open[i]]) continue;
                cut(open[i]);
                if (++splits % 256 == 0) progress.check();
                if (triangles_.size() > sample_facet_limit) throw_too_many_facets(what_);
            }
            changed_.assign(triangles_.size(), false);
        }
    }

    Mesh mesh() && {
        Mesh m;
        m.vertices = std::move(vertices_);
        m.facets.reserve(triangles_.size());
        for (const Triangle& t : triangles_)
            m.facets.push_back(t.corner);
        return m;
    }

private:
    void start(const PatchGrid& grid) {
        const std::size_t na = grid.a.size(), nb = grid.b.size();
        const std::size_t columns = grid.closed_a ? na - 1 : na;
        for (std::size_t j = 0; j < nb; ++j)
            for (std::size_t i = 0; i < columns; ++i)
                vertices_.push_back(patch_(grid.a[i], grid.b[j]));
        const auto id = [&](std::size_t i, std::size_t j) { return Index(j * columns + i % columns); };
        for (std::size_t j = 0; j + 1 < nb; ++j)
            for (std::size_t i = 0; i + 1 < na; ++i) {
                const std::array<Index, 4> v{id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)};
                const std::array<Vec2, 4> at{Vec2(grid.a[i], grid.b[j]), Vec2(grid.a[i + 1], grid.b[j]),
                                             Vec2(grid.a[i + 1], grid.b[j + 1]),
                                             Vec2(grid.a[i], grid.b[j + 1])};
                // The diagonal nearer to the surface at the cell's middle bends with it.
                const Vec3 middle = patch_(0.5 * (at[0].x() + at[2].x()), 0.5 * (at[0].y() + at[2].y()));
                const auto off = [&](std::size_t k) {
                    return (0.5 * (vertices_[v[k]] + vertices_[v[k + 2]]) - middle).squaredNorm();
                };
                const double off0 = off(0), off1 = off(1);
                const bool first = off0 < off1 || (off0 == off1 && (i + j) % 2 == 0);
                const auto add = [&](std::size_t p, std::size_t q, std::size_t r) {
                    Triangle t;
                    t.corner = {v[p], v[q], v[r]};
                    t.at = {at[p], at[q], at[r]};
                    triangles_.push_back(t);
                };
                if (first) {
                    add(0, 1, 2);
                    add(0, 2, 3);
                } else {
                    add(0, 1, 3);
                    add(1, 2, 3);
                }
            }
        join_neighbors();
        changed_.assign(triangles_.size(), false);
    }

    void join_neighbors() {
        struct Side {
            Index lo, hi, triangle;
            int edge;
        };
        std::vector<Side> sides;
        for (Index t = 0; t < triangles_.size(); ++t)
            for (int k = 0; k < 3; ++k) {
                const Index a = triangles_[t].corner[std::size_t(k)],
                            b = triangles_[t].corner[std::size_t((k + 1) % 3)];
                sides.push_back({std::min(a, b), std::max(a, b), t, k});
            }
        std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
            return std::tie(x.lo, x.hi, x.triangle) < std::tie(y.lo, y.hi, y.triangle);
        });
        for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
            const Side &x = sides[i], &y = sides[i + 1];
            if (x.lo != y.lo || x.hi != y.hi) continue;
            triangles_[x.triangle].neighbor[std::size_t(x.edge)] = y.triangle;
            triangles_[y.triangle].neighbor[std::size_t(y.edge)] = x.triangle;
        }
    }

    /// Largest distance between the surface and the facet over a lattice of the facet's parameters.
    double deviation(const Triangle& t) const {
        constexpr int n = 6;
        const Vec3 &a = vertices_[t.corner[0]], &b = vertices_[t.corner[1]], &c = vertices_[t.corner[2]];
        double worst = 0.0;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j) {
                if (i == n || j == n || i + j == 0) continue;
                const Vec2 at =
                    t.at[0] + double(i) / n * (t.at[1] - t.at[0]) + double(j) / n * (t.at[2] - t.at[0]);
                worst = std::max(worst, squared_distance(patch_(at.x(), at.y()), a, b, c));
            }
        return std::sqrt(worst);
    }

    /// Longest edge; ties go by vertex numbers, so that both sides of an edge agree and `cut` ends.
    int longest_edge(const Triangle& t) const {
        int best = 0;
        std::tuple<double, Index, Index> best_key{-1.0, 0, 0};
        for (int k = 0; k < 3; ++k) {
            const Index a = t.corner[std::size_t(k)], b = t.corner[std::size_t((k + 1) % 3)];
            const std::tuple<double, Index, Index> key{(vertices_[a] - vertices_[b]).squaredNorm(),
                                                       std::min(a, b), std::max(a, b)};
            if (key > best_key) {
                best_key = key;
                best = k;
            }
        }
        return best;
    }

    static int edge_to(const Triangle& t, Index other) {
        for (int k = 0; k < 3; ++k)
            if (t.neighbor[std::size_t(k)] == other) return k;
        return -1;
    }

    /// Halves facet t across its longest edge after halving, along the path of ever longer edges, the facets
    /// beyond.
    void cut(Index t) {
        std::vector<Index> path{t};
        while (!path.empty()) {
            const Index last = path.back();
            const int edge = longest_edge(triangles_[last]);
            const Index other = triangles_[last].neighbor[std::size_t(edge)];
            if (other != no_index) {
                const int across = edge_to(triangles_[other], last);
                if (longest_edge(triangles_[other]) != across) {
                    path.push_back(other);
                    continue;
                }
            }
            halve(last, edge, other);
            path.pop_back();
            // The facet before this one is whole yet and meets one of the halves; its turn is next.
        }
    }

    void halve(Index first, int edge, Index second) {
        const auto corner = [](int k) { return std::size_t(k % 3); };
        const Triangle t = triangles_[first];
        const Index a = t.corner[corner(edge)], b = t.corner[corner(edge + 1)];
        const Vec2 pa = t.at[corner(edge)], pb = t.at[corner(edge + 1)];
        const Vec2 pm = 0.5 * (pa + pb); // exactly on the border where both ends are
        const Index m = Index(vertices_.size());
        vertices_.push_back(patch_(pm.x(), pm.y()));

        const Index first_new = split_one(first, edge, m, pm);
        if (second == no_index) return;
        const int across = edge_to(triangles_[second], first);
        const Triangle& s = triangles_[second];
        const Vec2 qm = 0.5 * (s.at[corner(across)] + s.at[corner(across + 1)]);
        const Index second_new = split_one(second, across, m, qm);
        // `first` kept the half at a, its new one has b; `second` runs the other way: it kept b, its new one
        // has a.
        link(first, m, a, second_new);
        link(second_new, m, a, first);
        link(first_new, m, b, second);
        link(second, m, b, first_new);
    }

    /// Cuts `index` from vertex m on its edge to the opposite corner. Keeps the half at the edge's start and
    /// returns the new one at its end; links across the cut edge itself are left to the caller.
    Index split_one(Index index, int edge, Index m, const Vec2& pm) {
        const Triangle old = triangles_[index];
        const std::size_t i = std::size_t(edge), j = (i + 1) % 3, k = (i + 2) % 3;
        const Index fresh = Index(triangles_.size());
        Triangle keep, added;
        keep.corner = {old.corner[i], m, old.corner[k]};
        keep.at = {old.at[i], pm, old.at[k]};
        keep.neighbor = {no_index, fresh, old.neighbor[k]};
        added.corner = {m, old.corner[j], old.corner[k]};
        added.at = {pm, old.at[j], old.at[k]};
        added.neighbor = {no_index, old.neighbor[j], index};
        triangles_[index] = keep;
        triangles_.push_back(added);
        changed_[index] = true;
        changed_.push_back(true);
        if (old.neighbor[j] != no_index) {
            Triangle& n = triangles_[old.neighbor[j]];
            n.neighbor[std::size_t(edge_to(n, index))] = fresh;
        }
        return fresh;
    }

    void link(Index t, Index p, Index q, Index neighbor) {
        Triangle& tri = triangles_[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const Index x = tri.corner[k], y = tri.corner[(k + 1) % 3];
            if ((x == p && y == q) || (x == q && y == p)) tri.neighbor[k] = neighbor;
        }
    }

    const PatchFunction& patch_;
    double allowed_;
    std::string what_;
    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<char> changed_;
};

} // namespace

void throw_too_many_facets(const std::string& what) {
    throw Error(ErrorCode::out_of_range, what,
                "the chord tolerance is so small that the mesh would have more than "
                    + std::to_string(sample_facet_limit / 1'000'000) + " million facets",
                "use a larger tolerance");
}

Mesh tessellate_patch(const PatchFunction& patch, const PatchGrid& grid, double tolerance,
                      const std::string& what, const Progress& progress) {
    if (grid.a.size() < (grid.closed_a ? 4u : 2u) || grid.b.size() < 2)
        throw Error(ErrorCode::internal, what, "the coarse grid has too few lines",
                    "give at least two each way");
    Refinement refinement(patch, grid, tolerance::sample_share * tolerance, what);
    refinement.run(progress);
    return std::move(refinement).mesh();
}

std::vector<double> even_stations(const std::function<Vec3(double)>& curve, double from, double to,
                                  int cells) {
    // Lengths along a fine polyline, read backwards.
    const int fine = std::max(256, 16 * cells);
    std::vector<double> length(std::size_t(fine) + 1, 0.0);
    const auto at = [&](int i) { return from + (to - from) * double(i) / fine; };
    Vec3 before = curve(from);
    for (int i = 1; i <= fine; ++i) {
        const Vec3 p = curve(at(i));
        length[std::size_t(i)] = length[std::size_t(i - 1)] + (p - before).norm();
        before = p;
    }
    std::vector<double> stations{from};
    int i = 1;
    for (int k = 1; k < cells; ++k) {
        const double wanted = length.back() * k / cells;
        while (i < fine && length[std::size_t(i)] < wanted)
            ++i;
        const double l0 = length[std::size_t(i - 1)], l1 = length[std::size_t(i)];
        const double w = l1 > l0 ? (wanted - l0) / (l1 - l0) : 0.0;
        stations.push_back((1.0 - w) * at(i - 1) + w * at(i));
    }
    stations.push_back(to);
    return stations;
}

} // namespace facetmill
