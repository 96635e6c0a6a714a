#include "core/strategy/preview/preview_rings.h"

#include "core/mesh/edge_table.h"
#include "core/mesh/refine.h"
#include "core/strategy/five_axis/ring_map.h"
#include "core/strategy/surface/slice.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace facetmill {

namespace {

/// Parts of more facets are made coarser, with about so many vertices along their longest side.
constexpr std::size_t max_ring_facets = 24'000;
constexpr double coarse_cells = 70;
/// What faces down as much as this the part stands on.
const double foot_z = -std::cos(radians(10));
/// No piece goes on over an edge that is sharper; smaller ones have no rings, in squares of the radius.
const double ring_sharp_cos = std::cos(radians(50));
constexpr double min_ring_piece = 16;
constexpr std::size_t max_rings = 400;

/// The part with its vertices drawn together, and where each of them is.
struct CoarseMesh {
    Mesh mesh;
    std::vector<Index> vertex_of;
    double cell = 0;
};

CoarseMesh drawn_together(const Mesh& part) {
    CoarseMesh made;
    const Box3 box = part.box();
    made.cell = box.size().maxCoeff() / coarse_cells;
    std::unordered_map<std::uint64_t, Index> cells;
    std::vector<Index>& of = made.vertex_of;
    of.resize(part.vertices.size());
    std::vector<double> count;
    for (std::size_t i = 0; i < of.size(); ++i) {
        const Vec3 at = (part.vertices[i] - box.lo) / made.cell;
        const auto key =
            (std::uint64_t(at.x()) << 42) | (std::uint64_t(at.y()) << 21) | std::uint64_t(at.z());
        const auto [known, fresh] = cells.try_emplace(key, Index(made.mesh.vertices.size()));
        of[i] = known->second;
        if (fresh) {
            made.mesh.vertices.emplace_back(Vec3::Zero());
            count.push_back(0);
        }
        made.mesh.vertices[of[i]] += part.vertices[i];
        ++count[of[i]];
    }
    for (std::size_t i = 0; i < count.size(); ++i)
        made.mesh.vertices[i] /= count[i];
    for (const Facet& c : part.facets) {
        const Facet facet{of[c[0]], of[c[1]], of[c[2]]};
        if (facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0]) continue;
        made.mesh.facets.push_back(facet);
    }
    return made;
}

/// Facets joined by edges that are not sharp.
std::vector<std::vector<Index>> smooth_pieces(const Mesh& mesh, const std::vector<char>& wanted,
                                              const Progress& progress) {
    const EdgeTable edges(mesh, progress);
    std::vector<Index> beside(3 * mesh.facet_count(), no_index);
    for (std::size_t low = 0; low < edges.vertex_count(); ++low)
        edges.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
            if (sides.size() != 2) return;
            const Index a = sides[0].facet(), b = sides[1].facet();
            if (!wanted[a] || !wanted[b] || mesh.facet_normal(a).dot(mesh.facet_normal(b)) < ring_sharp_cos)
                return;
            beside[sides[0].side] = b;
            beside[sides[1].side] = a;
        });
    std::vector<std::vector<Index>> pieces;
    std::vector<char> seen(mesh.facet_count(), 0);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (seen[f] || !wanted[f]) continue;
        std::vector<Index> piece{Index(f)};
        seen[f] = 1;
        for (std::size_t i = 0; i < piece.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                if (const Index to = beside[3 * std::size_t(piece[i]) + k]; to != no_index && !seen[to]) {
                    seen[to] = 1;
                    piece.push_back(to);
                }
        std::sort(piece.begin(), piece.end());
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

void add_rings(const Mesh& mesh, double apart, PreviewRings& rings, const Progress& progress) {
    DerivedMesh piece;
    piece.mesh = mesh;
    piece.kept = mesh.vertices.size();
    piece.facet_of.resize(mesh.facet_count());
    const PassMap map = ring_map(piece, progress);
    const auto geometry = compute_geometry(piece.mesh, progress);
    const MeshSlicer slicer(piece.mesh, *geometry, DriveFrame(0), progress, &map);
    const double every = apart * map.flattest_v, size = slicer.hi() - slicer.lo();
    const auto count = std::max<std::size_t>(1, std::size_t(std::lround(size / every)));
    const std::size_t drawn = (count + max_rings - 1) / max_rings;
    rings.drawn_every = std::max(rings.drawn_every, drawn);
    rings.passes += count;
    for (std::size_t i = 0; i < count; i += drawn) {
        progress.check();
        for (const SliceChain& chain : slicer.slice(slicer.lo() + (double(i) + 0.5) * size / double(count))) {
            auto& line = rings.lines.emplace_back();
            for (const SlicePoint& p : chain.points)
                line.push_back(p.point);
            if (chain.closed) line.push_back(line.front());
        }
    }
}

} // namespace

PreviewRings preview_rings(const PreviewRequest& request, double apart, double radius,
                           const Progress& progress) {
    const Mesh& part = *request.context.part;
    PreviewRings rings;
    rings.facets.assign(part.facet_count(), 0);
    CoarseMesh coarse;
    const bool is_coarse = part.facet_count() > max_ring_facets;
    if (is_coarse) coarse = drawn_together(part);
    const Mesh& mesh = is_coarse ? coarse.mesh : part;
    rings.spacing = coarse.cell;
    const CoarseGrid& grid = request.ground->grid();
    const auto is_asked = [&](const Vec3& p) {
        const int x = grid.column(p.x()), y = grid.row(p.y());
        if (!grid.has(x, y)) return request.asked.empty();
        const std::size_t cell = grid.index(x, y);
        return (request.asked.empty() || request.asked[cell])
               && (request.avoided.empty() || !request.avoided[cell]);
    };
    std::vector<char> wanted(mesh.facet_count());
    for (std::size_t f = 0; f < wanted.size(); ++f)
        wanted[f] = mesh.facet_normal(f).z() > foot_z
                    && is_asked((mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3);
    std::vector<char> has_ring(mesh.vertices.size(), 0);
    for (const std::vector<Index>& facets : smooth_pieces(mesh, wanted, progress.part(0, 0.2))) {
        double area = 0;
        for (const Index f : facets)
            area += 0.5 * mesh.facet_cross(f).norm();
        if (area < min_ring_piece * radius * radius) continue;
        const Mesh piece = part_of(mesh, facets).mesh;
        if (!goes_round(piece, progress.part(0.2, 0.5))) continue;
        add_rings(piece, apart, rings, progress.part(0.5, 1));
        for (const Index f : facets)
            for (const Index i : mesh.facets[f])
                has_ring[i] = 1;
    }
    for (std::size_t f = 0; f < part.facet_count(); ++f)
        rings.facets[f] = std::all_of(part.facets[f].begin(), part.facets[f].end(), [&](Index i) {
            return has_ring[is_coarse ? coarse.vertex_of[i] : i] != 0;
        });
    return rings;
}

} // namespace facetmill
