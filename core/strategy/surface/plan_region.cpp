#include "core/strategy/surface/plan_region.h"

#include "core/base/parallel.h"
#include "core/mesh/edge_table.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Places nearer to one another than this share of the region's size are the same, and sides of an edge are
/// asked so many times farther from it.
constexpr double same_share = 1e-9, beside_same = 8;

Box3 flat_box(const PlanEdge& e) {
    Box3 box;
    box.add(Vec3(e[0].x(), e[0].y(), 0));
    box.add(Vec3(e[1].x(), e[1].y(), 0));
    return box;
}

BoxTree tree_of(const std::vector<PlanEdge>& edges, const Progress& progress) {
    std::vector<Box3> boxes;
    boxes.reserve(edges.size());
    for (const PlanEdge& e : edges)
        boxes.push_back(flat_box(e));
    return BoxTree(boxes, progress);
}

/// Where along `own`, from 0 to 1, `other` crosses it, ends on it, or begins to run over it.
void add_crossings(const PlanEdge& own, const PlanEdge& other, double same, std::vector<double>& at) {
    const Vec2 d = own[1] - own[0], e = other[1] - other[0], to = other[0] - own[0];
    const double length = d.norm(), cross = plane_cross(d, e);
    for (const Vec2& end : other)
        if (std::abs(plane_cross(d, end - own[0])) <= same * length)
            at.push_back(d.dot(end - own[0]) / (length * length));
    if (cross == 0) return;
    const double u = plane_cross(to, d) / cross;
    if (u >= 0 && u <= 1) at.push_back(plane_cross(to, e) / cross);
}

} // namespace

std::vector<PlanEdge> outline_edges(const Mesh& mesh, std::span<const char> facets,
                                    const Progress& progress) {
    std::vector<PlanEdge> edges;
    const EdgeTable table(mesh, progress);
    for (std::size_t low = 0; low < table.vertex_count(); ++low)
        table.for_edges(low, [&](Index high, std::span<const EdgeSide> sides) {
            // Every facet counts once, counter-clockwise: what the sum goes round is covered.
            int upward = 0;
            for (const EdgeSide& s : sides) {
                const std::size_t f = s.facet();
                if (!facets[f]) continue;
                const double z = mesh.facet_cross(f).z();
                const int turn = z > 0 ? 1 : z < 0 ? -1 : 0;
                upward += side_start(mesh, s.side) == low ? turn : -turn;
            }
            const Vec2 a = mesh.vertices[low].head<2>(), b = mesh.vertices[high].head<2>();
            if (a == b) return;
            for (; upward > 0; --upward)
                edges.push_back({a, b});
            for (; upward < 0; ++upward)
                edges.push_back({b, a});
        });
    return edges;
}

PlanRegion::PlanRegion(std::vector<PlanEdge> edges, const Progress& progress) : edges_(std::move(edges)) {
    std::erase_if(edges_, [](const PlanEdge& e) { return e[0] == e[1]; });
    edge_tree_ = tree_of(edges_, progress);
    Box3 all;
    for (const PlanEdge& e : edges_)
        all.add(flat_box(e));
    const double same = same_ = same_share * all.diagonal();
    struct Piece {
        PlanEdge edge;
        bool left_covered;
    };
    std::vector<std::vector<Piece>> borders(edges_.size());
    parallel_for(edges_.size(), 16, progress, [&](std::size_t i) {
        const PlanEdge& own = edges_[i];
        const double length = (own[1] - own[0]).norm();
        Box3 box = flat_box(own);
        box.lo -= Vec3::Constant(same);
        box.hi += Vec3::Constant(same);
        std::vector<double> at{0, 1};
        edge_tree_.each(
            [&](const Box3& b) {
                return (b.lo.array() <= box.hi.array()).all() && (b.hi.array() >= box.lo.array()).all();
            },
            [&](std::size_t other) {
                if (other != i) add_crossings(own, edges_[other], same, at);
            });
        std::erase_if(at, [](double t) { return !(t >= 0 && t <= 1); });
        std::sort(at.begin(), at.end());
        const Vec2 d = own[1] - own[0], across = Vec2(-d.y(), d.x()) / length;
        for (std::size_t k = 1; k < at.size(); ++k) {
            if ((at[k] - at[k - 1]) * length <= same) continue;
            const Vec2 middle = own[0] + 0.5 * (at[k] + at[k - 1]) * d;
            const Vec2 aside = beside_same * same * across;
            const bool left = covers(middle + aside);
            if (left == covers(middle - aside)) continue;
            borders[i].push_back({{own[0] + at[k - 1] * d, own[0] + at[k] * d}, left});
        }
    });
    for (const auto& pieces : borders)
        for (const Piece& piece : pieces) {
            border_.push_back(piece.edge);
            left_covered_.push_back(piece.left_covered);
        }
    border_tree_ = tree_of(border_, progress);
}

bool PlanRegion::covers(const Vec2& p) const {
    int winding = 0;
    edge_tree_.each(
        [&](const Box3& b) { return b.hi.x() >= p.x() && b.lo.y() <= p.y() && b.hi.y() >= p.y(); },
        [&](std::size_t i) {
            const PlanEdge& e = edges_[i];
            const double left = plane_cross(e[1] - e[0], p - e[0]);
            if (e[0].y() <= p.y() && e[1].y() > p.y() && left > 0) ++winding;
            if (e[0].y() > p.y() && e[1].y() <= p.y() && left < 0) --winding;
        });
    return winding != 0;
}

double PlanRegion::depth(const Vec2& p) const {
    double nearest2 = infinity;
    std::size_t nearest = 0;
    bool beside = false; // the nearest place is no end of its edge
    border_tree_.nearest(Vec3(p.x(), p.y(), 0), nearest2, [&](std::size_t i) {
        const PlanEdge& e = border_[i];
        const Vec2 d = e[1] - e[0];
        const double t = (p - e[0]).dot(d) / d.squaredNorm();
        const double here2 = (p - e[0] - std::clamp(t, 0.0, 1.0) * d).squaredNorm();
        if (!(here2 < nearest2)) return;
        nearest2 = here2;
        nearest = i;
        beside = t > 0 && t < 1;
    });
    // Nothing lies between p and the nearest place: p is on the side of that edge that it is seen from.
    const double distance = std::sqrt(nearest2);
    const bool covered =
        beside && distance > same_
            ? (plane_cross(border_[nearest][1] - border_[nearest][0], p - border_[nearest][0]) > 0)
                  == bool(left_covered_[nearest])
            : covers(p);
    return covered ? distance : -distance;
}

} // namespace facetmill
