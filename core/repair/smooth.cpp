// Noise smoothed within a bound: vertices go to and fro along their normals so that short waves go and long
// ones, the shape, stay (Taubin, "A signal processing approach to fair surface design", 1995). Where the
// facets' normals, once noise is averaged out of them (bilateral filter: Zheng, Fu, Au, Tai, "Bilateral
// normal filtering for mesh denoising", 2011), differ by more than the feature angle, an edge is a feature:
// its vertices are smoothed along it alone, and stay where several meet.
#include "core/base/parallel.h"
#include "core/mesh/exact_area.h"
#include "core/mesh/geometry_incidence.h"
#include "core/repair/repair_step.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill::detail {

namespace {

constexpr int normal_rounds = 4, vertex_rounds = 12;
/// Shares of the way to the middle of the neighbors: to it, and back past where the vertex was.
constexpr double forth = 0.5, back = -0.505;
constexpr std::size_t items_per_block = 4096;
/// A vertex that would move by less than this share of the bound stays: it lies where it should.
constexpr double still_share = 1e-4;

class Smoother {
public:
    Smoother(const Mesh& mesh, const RepairStep& step, const Progress& progress)
        : mesh_(mesh), step_(step), around_(facets_around_vertices(mesh, progress)),
          centers_(mesh.facet_count()), normals_(mesh.facet_count()), areas_(mesh.facet_count()) {
        parallel_for(mesh.facet_count(), items_per_block, progress, [&](std::size_t f) {
            centers_[f] = center(mesh.vertices, f);
            normals_[f] = mesh.facet_normal(f);
            areas_[f] = 0.5 * mesh.facet_cross(f).norm();
        });
        mark_borders();
    }

    void filter_normals(const Progress& progress) {
        const double nearness = 0.5 / std::max(mean_square_spacing(), 1e-300);
        const double feature = 2 * std::sin(0.5 * step_.angle); // distance of unit normals
        const double likeness = 2 / (feature * feature);
        std::vector<Vec3> next(normals_.size());
        for (int round = 0; round < normal_rounds; ++round) {
            const Progress part =
                progress.part(double(round) / normal_rounds, double(round + 1) / normal_rounds);
            parallel_for(normals_.size(), items_per_block, part, [&](std::size_t f) {
                Vec3 sum = Vec3::Zero();
                for (const Index v : mesh_.facets[f])
                    for (const Index g : around_.around(v)) {
                        const double off = (normals_[g] - normals_[f]).squaredNorm();
                        if (off > feature * feature) continue;
                        const double apart = (centers_[g] - centers_[f]).squaredNorm();
                        sum += areas_[g] * std::exp(-nearness * apart - likeness * off) * normals_[g];
                    }
                const double length = sum.norm();
                next[f] = length > 0 ? Vec3(sum / length) : normals_[f];
            });
            normals_.swap(next);
        }
    }

    /// Finds the features by the filtered normals.
    void mark_features(const Progress& progress) {
        sharp_.assign(around_.facets.size(), 0);
        directions_.resize(mesh_.vertices.size());
        const double cosine = std::cos(step_.angle);
        parallel_for(mesh_.vertices.size(), items_per_block, progress, [&](std::size_t v) {
            Vec3 sum = Vec3::Zero();
            for (Index i = around_.start[v]; i < around_.start[v + 1]; ++i) {
                const Index f = around_.facets[i];
                sum += normals_[f];
                for (const Index g : around_.around(v))
                    if (corner_before(g, v) == corner_after(f, v))
                        sharp_[i] = normals_[f].dot(normals_[g]) < cosine;
            }
            directions_[v] = sum.normalized();
        });
    }

    /// Where the vertices go, each within the bound round where it was.
    std::vector<Vec3> smoothed(const Progress& progress) const {
        std::vector<Vec3> at = mesh_.vertices, next(at.size());
        for (int pass = 0; pass < 2 * vertex_rounds; ++pass) {
            const Progress part = progress.part(0.5 * pass / vertex_rounds, 0.5 * (pass + 1) / vertex_rounds);
            const double share = pass % 2 ? back : forth;
            parallel_for(at.size(), items_per_block, part,
                         [&](std::size_t v) { next[v] = at[v] + share * pull(at, v); });
            at.swap(next);
        }
        parallel_for(at.size(), items_per_block, progress, [&](std::size_t v) {
            const Vec3 off = at[v] - mesh_.vertices[v];
            const double length = off.norm();
            at[v] = written(v, length > step_.bound ? Vec3(mesh_.vertices[v] + off * (step_.bound / length))
                                                    : at[v]);
        });
        return at;
    }

    /// Vertices of facets that would turn over or lose their area go back to where they were, until there are
    /// none. How many went back.
    std::size_t put_back_folded(std::vector<Vec3>& at, const Progress& progress) const {
        std::size_t put_back = 0;
        std::vector<char> folds(mesh_.facet_count());
        for (bool any = true; any;) {
            any = false;
            parallel_for(folds.size(), items_per_block, progress,
                         [&](std::size_t f) { folds[f] = is_folded(at, f); });
            for (std::size_t f = 0; f < folds.size(); ++f)
                for (const Index v : mesh_.facets[f])
                    if (folds[f] && at[v] != mesh_.vertices[v]) {
                        at[v] = mesh_.vertices[v];
                        ++put_back;
                        any = true;
                    }
        }
        return put_back;
    }

private:
    Index corner_after(Index f, std::size_t v) const {
        const Facet& c = mesh_.facets[f];
        return c[0] == v ? c[1] : c[1] == v ? c[2] : c[0];
    }
    Index corner_before(Index f, std::size_t v) const {
        const Facet& c = mesh_.facets[f];
        return c[0] == v ? c[2] : c[1] == v ? c[0] : c[1];
    }

    /// From a vertex to the middle of its neighbors, along its normal; on a feature to the middle of the two
    /// along it, across it.
    Vec3 pull(const std::vector<Vec3>& at, std::size_t v) const {
        if (held_[v]) return Vec3::Zero();
        Vec3 sum = Vec3::Zero();
        std::array<Index, 2> along{};
        std::size_t sharp = 0;
        const Index begin = around_.start[v], end = around_.start[v + 1];
        for (Index i = begin; i < end; ++i) {
            const Index u = corner_after(around_.facets[i], v);
            sum += at[u] - at[v];
            if (!sharp_[i]) continue;
            if (sharp < 2) along[sharp] = u;
            ++sharp;
        }
        if (begin == end || (sharp != 0 && sharp != 2)) return Vec3::Zero();
        if (sharp == 0) return sum.dot(directions_[v]) / double(end - begin) * directions_[v];
        const Vec3 course = (at[along[1]] - at[along[0]]).normalized();
        const Vec3 off = 0.5 * (at[along[0]] + at[along[1]]) - at[v];
        return off - off.dot(course) * course;
    }

    Vec3 center(const std::vector<Vec3>& at, std::size_t f) const {
        const Facet& c = mesh_.facets[f];
        return (at[c[0]] + at[c[1]] + at[c[2]]) / 3;
    }

    /// Borders stay: what is beyond them is not known. So does what is no disc around its vertex.
    void mark_borders() {
        held_.assign(mesh_.vertices.size(), 0);
        parallel_for(held_.size(), items_per_block, Progress(), [&](std::size_t v) {
            // Round an inner vertex every neighbor is left once and come to once.
            std::vector<Index> to, from;
            for (const Index f : around_.around(v)) {
                const Facet& c = mesh_.facets[f];
                const std::size_t k = c[0] == v ? 0 : c[1] == v ? 1 : 2;
                to.push_back(c[(k + 1) % 3]);
                from.push_back(c[(k + 2) % 3]);
            }
            std::sort(to.begin(), to.end());
            std::sort(from.begin(), from.end());
            held_[v] = to != from || std::adjacent_find(to.begin(), to.end()) != to.end();
        });
    }

    double mean_square_spacing() const {
        struct Sum {
            double length = 0;
            std::size_t n = 0;
        };
        const Sum sum = parallel_reduce(
            mesh_.facet_count(), items_per_block, Sum{}, Progress(),
            [&](std::size_t begin, std::size_t end) {
                Sum s;
                for (std::size_t f = begin; f < end; ++f)
                    for (const Index g : around_.around(mesh_.facets[f][0]))
                        if (g != f) {
                            s.length += (centers_[g] - centers_[f]).norm();
                            ++s.n;
                        }
                return s;
            },
            [](Sum a, const Sum& b) {
                return Sum{a.length + b.length, a.n + b.n};
            });
        const double mean = sum.n > 0 ? sum.length / double(sum.n) : 0;
        return mean * mean;
    }

    /// As a file says it, and still within the bound.
    Vec3 written(std::size_t v, const Vec3& to) const {
        const Vec3& from = mesh_.vertices[v];
        if ((to - from).norm() <= still_share * step_.bound) return from;
        for (double share = 1; share > 0.2; share -= 0.25) {
            const Vec3 at = rounded_to_float(from + share * (to - from));
            if ((at - from).norm() <= step_.bound) return at;
        }
        return from;
    }

    bool is_folded(const std::vector<Vec3>& at, std::size_t f) const {
        const Facet& c = mesh_.facets[f];
        if (at[c[0]] == mesh_.vertices[c[0]] && at[c[1]] == mesh_.vertices[c[1]]
            && at[c[2]] == mesh_.vertices[c[2]])
            return false;
        const Vec3 cross = (at[c[1]] - at[c[0]]).cross(at[c[2]] - at[c[0]]);
        return cross.dot(normals_[f]) <= 0 || exactly_collinear(at[c[0]], at[c[1]], at[c[2]]);
    }

    const Mesh& mesh_;
    const RepairStep& step_;
    const VertexFacets around_;
    std::vector<Vec3> centers_, normals_;
    std::vector<double> areas_;
    std::vector<Vec3> directions_; ///< per vertex: unit, the mean of the filtered normals
    std::vector<char> sharp_;      ///< per facet around a vertex: the edge to its next corner is a feature
    std::vector<char> held_;
};

} // namespace

StepResult smooth_noise(const Mesh& mesh, const RepairStep& step, const Progress& progress) {
    Smoother smoother(mesh, step, progress.part(0, 0.1));
    smoother.filter_normals(progress.part(0.1, 0.5));
    smoother.mark_features(progress.part(0.5, 0.6));
    std::vector<Vec3> at = smoother.smoothed(progress.part(0.6, 0.9));
    const std::size_t put_back = smoother.put_back_folded(at, progress.part(0.9, 1));
    StepResult result;
    std::size_t moved = 0;
    for (std::size_t v = 0; v < at.size(); ++v) {
        const double move = (at[v] - mesh.vertices[v]).norm();
        moved += move > 0;
        result.displacement = std::max(result.displacement, move);
    }
    result.tell("vertices_moved", moved);
    result.tell_any("vertices_held_against_folds", put_back);
    if (moved == 0) return result;
    auto smoothed = std::make_shared<Mesh>();
    smoothed->facets = mesh.facets;
    smoothed->vertices = std::move(at);
    result.mesh = std::move(smoothed);
    return result;
}

} // namespace facetmill::detail
