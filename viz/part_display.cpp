#include "viz/part_display.h"

#include "core/base/parallel.h"
#include "core/base/plane_geometry.h"
#include "core/mesh/edge_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill {

namespace {

constexpr std::size_t items_per_block = 8192; // vertices or facets: well below 20 ms

/// Corners by vertex: corner c = 3 * facet + k stands at corners[start[v]] .. corners[start[v + 1] - 1],
/// ascending.
struct CornersByVertex {
    std::vector<std::uint32_t> start, corners;
};

CornersByVertex corners_by_vertex(const Mesh& mesh, const Progress& progress) {
    CornersByVertex by;
    by.start.assign(mesh.vertices.size() + 1, 0);
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        if (f % (16 * items_per_block) == 0) progress.check();
        for (const Index v : mesh.facets[f])
            ++by.start[v + 1];
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        by.start[v + 1] += by.start[v];
    progress.check();
    by.corners.resize(3 * mesh.facets.size());
    std::vector<std::uint32_t> next(by.start.begin(), by.start.end() - 1);
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        if (f % (16 * items_per_block) == 0) progress.check();
        for (std::size_t k = 0; k < 3; ++k)
            by.corners[next[mesh.facets[f][k]]++] = std::uint32_t(3 * f + k);
    }
    return by;
}

/// What a corner's facet counts in the normal there: its angle, so that how a surface is divided does not
/// matter, times its area, so that a wide level face stays level beside the narrow facets of its rounded rim.
double corner_weight(const Mesh& mesh, std::size_t corner) {
    const std::size_t f = corner / 3;
    const int k = int(corner % 3);
    const Vec3 a = mesh.corner(f, (k + 1) % 3) - mesh.corner(f, k),
               b = mesh.corner(f, (k + 2) % 3) - mesh.corner(f, k);
    return angle_between(a, b) * a.cross(b).norm();
}

/// The display vertices of a run of mesh vertices.
struct VertexBlock {
    std::vector<float> points, normals;
};

class Splitter {
public:
    Splitter(const Mesh& mesh, const CornersByVertex& by, const std::vector<Vec3>& facet_normals,
             const Vec3& center, std::vector<std::int32_t>& triangles)
        : mesh_(mesh), by_(by), facet_normals_(facet_normals), center_(center), triangles_(triangles) {}

    /// Writes the triangles' corners at `v` as numbers within the block.
    void split(std::size_t v, VertexBlock& out) {
        const std::uint32_t* first = by_.corners.data() + by_.start[v];
        const std::size_t n = by_.start[v + 1] - by_.start[v];
        if (n == 0) return;
        weights_.resize(n);
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < n; ++i) {
            weights_[i] = corner_weight(mesh_, first[i]);
            sum += weights_[i] * facet_normals_[first[i] / 3];
        }
        const double length = sum.norm();
        bool smooth = length > 0.0;
        for (std::size_t i = 0; smooth && i < n; ++i)
            smooth = facet_normals_[first[i] / 3].dot(sum) >= cos_crease_ * length;
        if (smooth) {
            const std::int32_t index = add(v, sum / length, out);
            for (std::size_t i = 0; i < n; ++i)
                triangles_[first[i]] = index;
            return;
        }
        // At a crease every facet joins the facets of the fan that it is smooth with. Long fans, the tips of
        // cones and the centres of caps, keep their facet normals: the search is quadratic.
        constexpr std::size_t longest_fan = 64;
        made_.clear();
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3& own = facet_normals_[first[i] / 3];
            Vec3 normal = own;
            if (n <= longest_fan) {
                normal.setZero();
                for (std::size_t j = 0; j < n; ++j)
                    if (const Vec3& other = facet_normals_[first[j] / 3]; own.dot(other) >= cos_crease_)
                        normal += weights_[j] * other;
                const double norm = normal.norm();
                normal = norm > 0.0 ? Vec3(normal / norm) : own;
            }
            const auto same =
                std::find_if(made_.begin(), made_.end(), [&](const Made& m) { return m.normal == normal; });
            if (n <= longest_fan && same != made_.end()) {
                triangles_[first[i]] = same->index;
            } else {
                made_.push_back({normal, add(v, normal, out)});
                triangles_[first[i]] = made_.back().index;
            }
        }
    }

private:
    struct Made {
        Vec3 normal;
        std::int32_t index;
    };

    std::int32_t add(std::size_t v, const Vec3& normal, VertexBlock& out) const {
        const Vec3 p = mesh_.vertices[v] - center_;
        for (int k = 0; k < 3; ++k) {
            out.points.push_back(float(p[k]));
            out.normals.push_back(float(normal[k]));
        }
        return std::int32_t(out.points.size() / 3 - 1);
    }

    const Mesh& mesh_;
    const CornersByVertex& by_;
    const std::vector<Vec3>& facet_normals_;
    const Vec3 center_;
    std::vector<std::int32_t>& triangles_;
    const double cos_crease_ = std::cos(crease_angle);
    std::vector<double> weights_;
    std::vector<Made> made_;
};

struct EdgeBlock {
    std::vector<std::array<Index, 2>> all, sharp, border;
};

/// Edges from `v` to vertices of higher number, by what their facets look like.
void classify_edges(const Mesh& mesh, const EdgeTable& table, const std::vector<Vec3>& facet_normals,
                    std::size_t v, EdgeBlock& out) {
    const double cos_crease = std::cos(crease_angle);
    table.for_edges(v, [&](Index high, std::span<const EdgeSide> sides) {
        if (high == v) return; // a facet that names the vertex twice
        const std::array<Index, 2> edge{Index(v), high};
        out.all.push_back(edge);
        if (sides.size() != 2) {
            out.border.push_back(edge);
            return;
        }
        const auto [a, b] = std::pair(sides[0], sides[1]);
        const bool turned = side_start(mesh, a.side) == side_start(mesh, b.side); // facing opposite sides
        if (turned || facet_normals[a.facet()].dot(facet_normals[b.facet()]) < cos_crease)
            out.sharp.push_back(edge);
    });
}

} // namespace

PartDisplayPtr prepare_part_display(MeshPtr mesh_ptr, const Progress& progress) {
    auto display = std::make_shared<PartDisplay>();
    display->mesh = std::move(mesh_ptr);
    const Mesh& mesh = *display->mesh;
    // Display vertices are counted in 32 bits; there are at most as many as corners.
    if (mesh.facets.size() > std::size_t(std::numeric_limits<std::int32_t>::max()) / 3)
        throw Error(ErrorCode::too_large, "part", "has more facets than can be drawn", "reduce the mesh");

    display->box = parallel_reduce(
        mesh.facets.size(), items_per_block, Box3{}, progress.part(0.0, 0.1),
        [&](std::size_t begin, std::size_t end) {
            Box3 b;
            for (std::size_t f = begin; f < end; ++f)
                for (const Index v : mesh.facets[f])
                    b.add(mesh.vertices[v]);
            return b;
        },
        [](Box3 a, const Box3& b) {
            a.add(b);
            return a;
        });
    if (display->box.empty()) return display;
    display->center = display->box.center();

    std::vector<Vec3> facet_normals(mesh.facets.size());
    parallel_for(mesh.facets.size(), items_per_block, progress.part(0.1, 0.2),
                 [&](std::size_t f) { facet_normals[f] = mesh.facet_normal(f); });
    display->sights = SightTree(mesh, progress.part(0.2, 0.3));
    const CornersByVertex by = corners_by_vertex(mesh, progress);
    const EdgeTable table(mesh, progress.part(0.3, 0.3));

    const std::size_t blocks = (mesh.vertices.size() + items_per_block - 1) / items_per_block;
    display->triangles.resize(3 * mesh.facets.size());
    std::vector<VertexBlock> vertex_blocks(blocks);
    std::vector<EdgeBlock> edge_blocks(blocks);
    std::vector<std::int32_t> display_of(mesh.vertices.size(),
                                         0); // one display vertex of each mesh vertex, for lines
    parallel_blocks(mesh.vertices.size(), items_per_block, progress.part(0.3, 0.8),
                    [&](std::size_t begin, std::size_t end) {
                        VertexBlock& out = vertex_blocks[begin / items_per_block];
                        out.points.reserve(3 * (end - begin));
                        out.normals.reserve(3 * (end - begin));
                        Splitter splitter(mesh, by, facet_normals, display->center, display->triangles);
                        for (std::size_t v = begin; v < end; ++v) {
                            display_of[v] = std::int32_t(out.points.size() / 3);
                            splitter.split(v, out);
                            classify_edges(mesh, table, facet_normals, v,
                                           edge_blocks[begin / items_per_block]);
                        }
                    });

    std::vector<std::int32_t> base(blocks + 1, 0);
    for (std::size_t b = 0; b < blocks; ++b)
        base[b + 1] = base[b] + std::int32_t(vertex_blocks[b].points.size() / 3);
    display->points.resize(3 * std::size_t(base[blocks]));
    display->normals.resize(3 * std::size_t(base[blocks]));
    parallel_blocks(mesh.vertices.size(), items_per_block, progress.part(0.8, 1.0),
                    [&](std::size_t begin, std::size_t end) {
                        const std::size_t b = begin / items_per_block;
                        std::copy(vertex_blocks[b].points.begin(), vertex_blocks[b].points.end(),
                                  display->points.begin() + 3 * std::ptrdiff_t(base[b]));
                        std::copy(vertex_blocks[b].normals.begin(), vertex_blocks[b].normals.end(),
                                  display->normals.begin() + 3 * std::ptrdiff_t(base[b]));
                        for (std::size_t i = by.start[begin]; i < by.start[end]; ++i)
                            display->triangles[by.corners[i]] += base[b];
                        for (std::size_t v = begin; v < end; ++v)
                            display_of[v] += base[b];
                    });

    std::size_t sharp = 0;
    for (const EdgeBlock& b : edge_blocks) {
        sharp += b.sharp.size();
        display->has_border = display->has_border || !b.border.empty();
    }
    // A noisy scan is sharp nearly everywhere; lines would only blacken it.
    const bool noise = mesh.facets.size() > 10'000 && sharp > mesh.facets.size() / 4;
    for (EdgeBlock& b : edge_blocks) {
        progress.check();
        const auto add = [&](std::vector<std::int32_t>& to, const std::vector<std::array<Index, 2>>& edges) {
            for (const auto& e : edges)
                to.insert(to.end(), {display_of[e[0]], display_of[e[1]]});
        };
        if (!noise) add(display->lines, b.sharp);
        add(display->lines, b.border);
        add(display->edges, b.all);
        b = {};
    }
    if (mesh.facets.size() > largest_part_without_preview)
        display->preview = make_preview(*display, progress);
    return display;
}

} // namespace facetmill
