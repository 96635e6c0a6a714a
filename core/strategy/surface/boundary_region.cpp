#include "core/strategy/surface/boundary_region.h"

#include "core/base/parallel.h"
#include "core/mesh/refine.h"
#include "core/mesh/triangle_distance.h"
#include "core/strategy/surface/tool_rest.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

std::string boundary_place(const std::string& name) {
    return "boundary '" + printable(name, 60) + "'";
}

bool is_looked_at_along_z(Boundary::Kind kind) {
    return kind == Boundary::Kind::curve || kind == Boundary::Kind::silhouette
           || kind == Boundary::Kind::rest;
}

namespace {

/// Of angles, and of lengths as a share of the part's size: what differs by less is the same.
constexpr double same_angle = 1e-9, same_length = 1e-9;
/// How often a facet is divided to see whether some of it lies in a plane region: pieces are an eighth of it.
constexpr int facet_divisions = 3;

std::vector<char> painted_facets(const Boundary& boundary, const Mesh& part) {
    const std::size_t count = part.facet_count();
    if (boundary.of_facets != 0 && std::size_t(boundary.of_facets) != count)
        throw Error(ErrorCode::out_of_range, boundary_place(boundary.name),
                    "it was painted on a part of " + std::to_string(boundary.of_facets)
                        + " facets, and this one has " + std::to_string(count),
                    "paint it anew");
    std::vector<char> in(count, 0);
    try {
        for (const Index f : facet_ranges(boundary.facets, count))
            in[f] = 1;
    } catch (const Error& e) {
        throw e.within(boundary_place(boundary.name));
    }
    return in;
}

std::vector<char> facets_of_slope(const Boundary& boundary, const Mesh& part) {
    std::vector<char> in(part.facet_count(), 0);
    for (std::size_t f = 0; f < in.size(); ++f) {
        const Vec3 cross = part.facet_cross(f);
        if (cross.isZero()) continue;
        const double angle = std::atan2(cross.head<2>().norm(), cross.z());
        in[f] = angle >= boundary.slope[0] - same_angle && angle <= boundary.slope[1] + same_angle;
    }
    return in;
}

std::vector<PlanEdge> loop_of(const std::vector<CurveCorner>& curve) {
    std::vector<PlanEdge> edges;
    const auto at = [&](std::size_t i) { return Vec2(curve[i].at[0], curve[i].at[1]); };
    for (std::size_t i = 0; i < curve.size(); ++i)
        edges.push_back({at(i), at((i + 1) % curve.size())});
    return edges;
}

std::vector<PlanEdge> edges_of_rest(const Boundary& boundary, const MeshPtr& part,
                                    const std::optional<AptCutter>& cutter, const Progress& progress) {
    if (!cutter)
        throw Error(ErrorCode::missing_reference, boundary_place(boundary.name),
                    "nobody has said which tool leaves it", "name a tool of the project");
    try {
        const auto index = std::make_shared<ContactIndex>(part, progress.part(0, 0.1));
        std::vector<PlanEdge> edges =
            ToolRest(index, CutterProfile(*cutter), boundary.more_than, progress.part(0.1, 0.4))
                .outline(progress.part(0.4, 1));
        if (edges.empty() && !boundary.invert)
            throw Error(ErrorCode::empty_result, boundary_place(boundary.name),
                        "the tool leaves nothing that is thicker than that",
                        "name a larger tool or a smaller thickness");
        return edges;
    } catch (const Error& e) {
        if (e.where().empty()) throw e.within(boundary_place(boundary.name));
        throw;
    }
}

PlanRegion region_of(const Boundary& boundary, const MeshPtr& part, const std::optional<AptCutter>& cutter,
                     const Progress& progress) {
    std::vector<PlanEdge> edges;
    if (boundary.kind == Boundary::Kind::curve)
        edges = loop_of(boundary.curve);
    else if (boundary.kind == Boundary::Kind::silhouette)
        edges = outline_edges(*part, std::vector<char>(part->facet_count(), 1), progress.part(0, 0.5));
    else
        edges = edges_of_rest(boundary, part, cutter, progress.part(0, 0.9));
    return PlanRegion(std::move(edges), progress.part(0.9, 1));
}

/// Whether some of a triangle may lie where `depth` is not below 0; the depth of places changes by no more
/// than their distance.
template <class Depth>
bool some_within(const std::array<Vec2, 3>& t, const Depth& depth, int divisions = facet_divisions) {
    const Vec2 middle = (t[0] + t[1] + t[2]) / 3;
    const double d = depth(middle);
    if (d >= 0) return true;
    const double reach = std::max({(t[0] - middle).norm(), (t[1] - middle).norm(), (t[2] - middle).norm()});
    if (d < -reach) return false;
    if (divisions == 0) return true;
    const Vec2 a = 0.5 * (t[0] + t[1]), b = 0.5 * (t[1] + t[2]), c = 0.5 * (t[2] + t[0]);
    const auto within = [&](const Vec2& p, const Vec2& q, const Vec2& r) {
        return some_within(std::array<Vec2, 3>{p, q, r}, depth, divisions - 1);
    };
    return within(a, b, c) || within(t[0], a, c) || within(t[1], b, a) || within(t[2], c, b);
}

template <class Depth>
std::vector<char> facets_within(const Mesh& part, const Depth& depth, const Progress& progress) {
    std::vector<char> in(part.facet_count(), 0);
    for (std::size_t f = 0; f < in.size(); ++f) {
        if (f % 4096 == 0) progress.check();
        std::array<Vec2, 3> corners;
        for (int k = 0; k < 3; ++k)
            corners[std::size_t(k)] = part.corner(f, k).template head<2>();
        in[f] = some_within(corners, depth);
    }
    return in;
}

double plan_depth(const PlanRegion& plan, const Vec2& p, double offset, bool inverted) {
    const double depth = plan.depth(p) + offset;
    return inverted ? -depth : depth;
}

std::vector<char> facets_over(const Boundary& boundary, const PlanRegion& plan, const Mesh& part,
                              const Progress& progress) {
    return facets_within(
        part, [&](const Vec2& p) { return plan_depth(plan, p, boundary.offset, boundary.invert); }, progress);
}

} // namespace

std::vector<char> boundary_facets(const Boundary& boundary, const Mesh& part) {
    std::vector<char> in = boundary.kind == Boundary::Kind::slope ? facets_of_slope(boundary, part)
                                                                  : painted_facets(boundary, part);
    if (boundary.invert)
        for (char& f : in)
            f = !f;
    return in;
}

BoundaryRegion::BoundaryRegion(const Boundary& boundary, MeshPtr part, const Progress& progress,
                               const std::optional<AptCutter>& cutter)
    : name_(boundary.name), part_(std::move(part)), by_plan_(is_looked_at_along_z(boundary.kind)),
      same_(same_length * part_->box().diagonal()) {
    if (by_plan_) {
        plan_ = region_of(boundary, part_, cutter, progress.part(0, 0.7));
        inverted_ = boundary.invert;
        offset_ = boundary.offset;
        facets_ = facets_over(boundary, plan_, *part_, progress.part(0.7, 1));
    } else {
        facets_ = boundary_facets(boundary, *part_);
    }
    std::vector<Index> own;
    for (std::size_t f = 0; f < facets_.size(); ++f)
        if (facets_[f]) own.push_back(Index(f));
    if (own.empty())
        throw Error(ErrorCode::empty_result, boundary_place(boundary.name), "nothing of the part lies in it",
                    "paint facets, widen it, or move it onto the part");
    piece_ = std::make_shared<Mesh>(part_of(*part_, own).mesh);
    if (by_plan_) return;
    plan_ = PlanRegion(outline_edges(*part_, facets_, progress.part(0.3, 0.5)), progress.part(0.5, 0.8));
    std::vector<Box3> boxes(facets_.size());
    for (std::size_t f = 0; f < boxes.size(); ++f)
        for (int k = 0; k < 3; ++k)
            boxes[f].add(part_->corner(f, k));
    tree_ = BoxTree(boxes, progress.part(0.8, 1));
}

MeshPtr BoundaryRegion::surface(double least, double longest, const Progress& progress) const {
    if (!by_plan_ && !(least > 0)) return piece_;
    constexpr std::size_t max_facets = 8'000'000;
    const auto inside = [&](const Vec3& p) { return depth(p.head<2>()) - least; };
    const auto crosses = [&](const std::array<Vec3, 3>& t) {
        const Vec3 middle = (t[0] + t[1] + t[2]) / 3;
        double reach = 0;
        for (const Vec3& corner : t)
            reach = std::max(reach, (corner - middle).head<2>().norm());
        return std::abs(inside(middle)) < reach;
    };
    const DerivedMesh fine = refined(*piece_, crosses, longest, std::max(max_facets, piece_->facet_count()),
                                     progress.part(0, 0.6));
    std::vector<double> beyond(fine.mesh.vertices.size());
    parallel_for(beyond.size(), 256, progress.part(0.6, 1), [&](std::size_t v) {
        const double within = inside(fine.mesh.vertices[v]);
        beyond[v] = within != 0 ? -within : -same_;
    });
    const DividedMesh all = divided(fine.mesh, beyond);
    std::vector<Index> facets;
    for (std::size_t f = 0; f < all.inside.size(); ++f)
        if (all.inside[f]) facets.push_back(Index(f));
    if (facets.empty())
        throw Error(ErrorCode::empty_result, boundary_place(name_),
                    "nothing of the part lies so far within it that the cutter has room",
                    "widen it, take a smaller tool, or keep only the contact within");
    return std::make_shared<Mesh>(part_of(all.derived.mesh, facets).mesh);
}

double BoundaryRegion::distance2(const Vec3& p, std::size_t facet) const {
    return squared_distance(p, part_->corner(facet, 0), part_->corner(facet, 1), part_->corner(facet, 2));
}

bool BoundaryRegion::holds(const Vec3& p, Index& hint) const {
    if (by_plan_) return depth(p.head<2>()) >= -same_;
    double nearest2 = hint == no_index ? infinity : distance2(p, hint);
    const auto search = [&](bool own) {
        bool found = false;
        tree_.each([&](const Box3& box) { return !found && squared_distance(box, p) <= nearest2; },
                   [&](std::size_t f) {
                       if (own && !facets_[f]) return;
                       const double d2 = distance2(p, f);
                       if (d2 > nearest2) return;
                       found = own;
                       if (d2 < nearest2 || hint == no_index) hint = Index(f);
                       nearest2 = d2;
                   });
        return found;
    };
    search(false);
    if (hint != no_index && facets_[hint]) return true;
    // As near as that, to rounding, one of its own: a place on the border belongs to it.
    const double nearest = std::sqrt(nearest2) + same_;
    const Index at = hint;
    nearest2 = nearest * nearest;
    const bool within = search(true);
    hint = at;
    return within;
}

double BoundaryRegion::depth(const Vec2& p) const {
    return plan_depth(plan_, p, offset_, inverted_);
}

} // namespace facetmill
