#include "core/strategy/surface/region_field.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/index_pair.h"
#include "core/mesh/mesh_area.h"
#include "core/mesh/triangle_distance.h"
#include "core/strategy/surface/point_grid.h"
#include "core/strategy/surface/up_side.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

namespace facetmill {

namespace {

constexpr std::size_t max_facets = 4'000'000;
constexpr std::size_t vertices_per_block = 2000, places_per_block = 64;
/// Edges of the fine mesh, as a share of the spacing; nearer to a vertex than a share of an edge nothing is
/// cut.
constexpr double edge_share = 0.5, inset_share = 0.03;
/// Rounds of smoothing: over about one spacing.
constexpr int smoothing_rounds = 6;
/// How far around a drag the boundary goes along, in lengths of the drag, and at least, in spacings.
constexpr double drag_reach = 4, min_drag_reach = 3;

Vec3 vec(const std::array<double, 3>& p) {
    return {p[0], p[1], p[2]};
}

/// (1 - t^2)^2 inside of 1.
double bump(double t) {
    const double inner = 1 - t * t;
    return inner > 0 ? inner * inner : 0;
}

/// A mesh with what is known of its vertices, to be carried from piece to piece.
struct Known {
    Mesh mesh;
    std::vector<Vec3> normals;
    std::vector<VertexCurvature> curvatures;

    Known derived(DerivedMesh&& d) const {
        Known k;
        k.normals = carried_normals(d, normals);
        k.curvatures = carried_curvatures(d, curvatures, k.normals);
        k.mesh = std::move(d.mesh);
        return k;
    }
    PartPiece piece(std::span<const Index> facets) const {
        PartOfMesh part = part_of(mesh, facets);
        auto geometry = std::make_shared<MeshGeometry>();
        auto carried = std::make_shared<std::vector<VertexCurvature>>();
        for (const Index v : part.vertex_of) {
            geometry->vertex_normals.push_back(normals[v]);
            carried->push_back(curvatures[v]);
        }
        for (std::size_t f = 0; f < part.mesh.facets.size(); ++f)
            geometry->facet_normals.push_back(part.mesh.facet_normal(f));
        PartPiece made;
        made.mesh = std::make_shared<Mesh>(std::move(part.mesh));
        made.geometry = std::move(geometry);
        made.curvatures = std::move(carried);
        return made;
    }
};

class Builder {
public:
    Builder(const RegionInput& input, std::span<const UncutPlace> uncut, const Progress& progress)
        : in_(input), uncut_(uncut), progress_(progress), up_(*input.part, progress) {}

    ReworkRegions run() {
        take_surface();
        result_.part_area = mesh_area(surface_.mesh);
        if (uncut_.empty()) {
            std::vector<Index> all(surface_.mesh.facets.size());
            for (std::size_t f = 0; f < all.size(); ++f)
                all[f] = Index(f);
            result_.outside = surface_.piece(all);
            return std::move(result_);
        }
        double max_grow = 0;
        for (const RegionEdit& e : in_.edits)
            max_grow = std::max(max_grow, e.grow);
        for (const BoundaryDrag& d : in_.drags)
            max_grow = std::max(max_grow, (vec(d.to) - vec(d.from)).norm());
        far_ = 4 * in_.spacing + in_.offset + max_grow;
        std::vector<Box3> places(uncut_.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i].add(uncut_[i].point);
        tree_ = BoxTree(places, progress_);
        refine();
        measure();
        smooth();
        find_level();
        cut_outside();
        find_edited();
        cut_regions();
        return std::move(result_);
    }

private:
    /// The facets that a tool can come to.
    void take_surface() {
        const Mesh& part = *in_.part;
        std::vector<Index> facets;
        for (std::size_t f = 0; f < part.facets.size(); ++f)
            if (up_.towards_tool(part.facet_normal(f)).z() > tolerance::vertical_normal_z)
                facets.push_back(Index(f));
        PartOfMesh taken = part_of(part, facets);
        for (const Index v : taken.vertex_of) {
            surface_.normals.push_back(in_.geometry->vertex_normals[v]);
            surface_.curvatures.push_back((*in_.curvatures)[v]);
        }
        surface_.mesh = std::move(taken.mesh);
    }

    /// Whether a facet may come nearer to uncut places than the field goes.
    bool is_near(const std::array<Vec3, 3>& p) const {
        const Vec3 middle = (p[0] + p[1] + p[2]) / 3;
        double reach = 0;
        for (const Vec3& c : p)
            reach = std::max(reach, (c - middle).norm());
        reach += far_;
        bool found = false;
        tree_.each([&](const Box3& box) { return !found && squared_distance(box, middle) <= reach * reach; },
                   [&](std::size_t) { found = true; });
        return found;
    }

    void refine() {
        DerivedMesh d = refined(
            surface_.mesh, [this](const std::array<Vec3, 3>& p) { return is_near(p); },
            edge_share * in_.spacing, max_facets, progress_.part(0, 0.3));
        normals_ = carried_normals(d, surface_.normals);
        for (std::size_t i = 0; i < d.added.size(); ++i)
            middle_of_.emplace(pair_of(d.added[i].a, d.added[i].b), Index(d.kept + i));
        fine_ = std::move(d.mesh);
    }

    Vec3 towards(Index v) const { return up_.towards_tool(normals_[v]); }

    void measure() {
        const std::size_t n = fine_.vertices.size();
        field_.assign(n, far_);
        nearest_.assign(n, no_index);
        parallel_blocks(n, vertices_per_block, progress_.part(0.3, 0.7),
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t v = begin; v < end; ++v) {
                                const Vec3 &p = fine_.vertices[v], normal = towards(Index(v));
                                double least = far_ * far_;
                                tree_.nearest(p, least, [&](std::size_t i) {
                                    // The other side of a thin wall is another surface.
                                    if (uncut_[i].normal.dot(normal) < 0) return;
                                    const double square = (uncut_[i].point - p).squaredNorm();
                                    if (!(square < least)) return;
                                    least = square;
                                    nearest_[v] = Index(i);
                                });
                                field_[v] = std::sqrt(least);
                            }
                        });
    }

    void smooth() {
        const std::size_t n = fine_.vertices.size();
        std::vector<double> sum(n);
        std::vector<int> count(n);
        for (int round = 0; round < smoothing_rounds; ++round) {
            progress_.check();
            std::fill(sum.begin(), sum.end(), 0);
            std::fill(count.begin(), count.end(), 0);
            for (const Facet& f : fine_.facets)
                for (std::size_t k = 0; k < 3; ++k) {
                    const Index a = f[k], b = f[(k + 1) % 3];
                    sum[a] += field_[b];
                    sum[b] += field_[a];
                    ++count[a];
                    ++count[b];
                }
            for (std::size_t v = 0; v < n; ++v)
                if (field_[v] < far_ && count[v] > 0) field_[v] = 0.5 * (field_[v] + sum[v] / count[v]);
        }
    }

    /// The level that closes gaps between trajectories and has every uncut place inside.
    void find_level() {
        level_ = in_.spacing;
        const PointGrid vertices(fine_.vertices, in_.spacing);
        std::vector<double> inside(uncut_.size(), infinity);
        parallel_for(uncut_.size(), places_per_block, progress_.part(0.7, 0.8), [&](std::size_t i) {
            const UncutPlace& u = uncut_[i];
            // Deeper than the spacing it raises the level, else nobody has to know how much less it is.
            for (double reach = edge_share * in_.spacing;
                 !(inside[i] <= in_.spacing) && (inside[i] == infinity || reach <= in_.spacing)
                 && reach <= far_;
                 reach *= 2)
                vertices.near(u.point, reach, [&](std::size_t v) {
                    if (nearest_[v] == no_index || towards(Index(v)).dot(u.normal) < 0) return;
                    inside[i] = std::min(inside[i], field_[v] + (vertices.points()[v] - u.point).norm());
                });
        });
        for (const double deep : inside)
            if (deep < infinity) level_ = std::max(level_, deep);
        // Edges of the fine mesh are taken as straight.
        level_ = std::min(level_ * (1 + 1e-9), far_ - in_.spacing - in_.offset);
    }

    /// Values never so near to 0 that facets without width are cut off.
    double kept_off(double value) const {
        const double least = inset_share * edge_share * in_.spacing;
        return std::abs(value) < least ? -least : value;
    }

    /// The surface divided along a level of the field. Only where the level passes need facets be as small as
    /// those of the fine mesh; elsewhere they are as large as the part's, so that a part many cutters wide
    /// does not become millions of them. Vertices are those of the fine mesh: halving edges of the same
    /// facets makes the same ones.
    struct Cut {
        Known known;
        std::vector<bool> inside;
    };
    Cut cut(std::vector<double> value) const {
        for (double& v : value)
            v = kept_off(v);
        std::vector<Box3> passed;
        for (std::size_t f = 0; f < fine_.facets.size(); ++f) {
            const Facet& at = fine_.facets[f];
            const bool in = value[at[0]] < 0;
            if (in == (value[at[1]] < 0) && in == (value[at[2]] < 0)) continue;
            passed.emplace_back();
            for (int k = 0; k < 3; ++k)
                passed.back().add(fine_.corner(f, k));
        }
        const BoxTree tree(passed, progress_);
        const auto wanted = [&](const std::array<Vec3, 3>& p) {
            Box3 own;
            for (const Vec3& c : p)
                own.add(c);
            bool found = false;
            tree.each(
                [&](const Box3& box) {
                    return !found && (box.lo.array() <= own.hi.array()).all()
                           && (own.lo.array() <= box.hi.array()).all();
                },
                [&](std::size_t) { found = true; });
            return found && is_near(p);
        };
        DerivedMesh d =
            refined(surface_.mesh, wanted, edge_share * in_.spacing, max_facets, progress_.part(0.8, 0.8));
        std::vector<Index> fine_number(d.kept + d.added.size(), no_index);
        std::vector<double> own(fine_number.size());
        for (std::size_t v = 0; v < own.size(); ++v) {
            if (v < d.kept) {
                fine_number[v] = Index(v);
                own[v] = value[v];
                continue;
            }
            const Between& added = d.added[v - d.kept];
            const Index a = fine_number[added.a], b = fine_number[added.b];
            // A large facet whose neighbours were divided earlier may have edges of its own: no level is
            // near.
            own[v] = 0.5 * (own[added.a] + own[added.b]);
            if (a == no_index || b == no_index) continue;
            const auto found = middle_of_.find(pair_of(a, b));
            if (found == middle_of_.end()) continue;
            fine_number[v] = found->second;
            own[v] = value[found->second];
        }
        const Known coarse = surface_.derived(std::move(d));
        DividedMesh parted = divided(coarse.mesh, own);
        return {coarse.derived(std::move(parted.derived)), std::move(parted.inside)};
    }

    void cut_outside() {
        std::vector<double> value(field_.size());
        for (std::size_t v = 0; v < value.size(); ++v)
            value[v] = field_[v] - level_;
        const Cut parted = cut(std::move(value));
        std::vector<Index> outside;
        for (std::size_t f = 0; f < parted.inside.size(); ++f)
            if (!parted.inside[f]) outside.push_back(Index(f));
        result_.outside = parted.known.piece(outside);
        result_.uncut_area = result_.part_area - mesh_area(*result_.outside.mesh);
    }

    /// What is inside the boundaries, as pieces; each uncut place's piece.
    struct Pieces {
        Known known;
        std::vector<std::vector<Index>> facets;
        std::vector<std::size_t> of_uncut;
    };
    Pieces pieces(const std::vector<double>& out) const {
        std::vector<double> value(field_.size());
        for (std::size_t v = 0; v < value.size(); ++v)
            value[v] = field_[v] - level_ - out[v];
        Cut parted = cut(std::move(value));
        std::vector<Index> inside;
        for (std::size_t f = 0; f < parted.inside.size(); ++f)
            if (parted.inside[f]) inside.push_back(Index(f));
        Pieces p;
        p.known = std::move(parted.known);
        const Mesh& mesh = p.known.mesh;
        std::size_t count = 0;
        const auto number = connected_pieces(mesh, inside, count);
        p.facets.resize(count);
        std::vector<Box3> boxes(inside.size());
        for (std::size_t i = 0; i < inside.size(); ++i) {
            p.facets[number[i]].push_back(inside[i]);
            for (int k = 0; k < 3; ++k)
                boxes[i].add(mesh.corner(inside[i], k));
        }
        // An uncut place belongs to the piece with the nearest facet.
        const BoxTree tree(boxes, progress_);
        p.of_uncut.assign(uncut_.size(), 0);
        parallel_for(uncut_.size(), places_per_block, progress_.part(0.8, 1), [&](std::size_t n) {
            const UncutPlace& u = uncut_[n];
            double near2 = infinity;
            tree.nearest(u.point, near2, [&](std::size_t i) {
                const Index f = inside[i];
                if (up_.towards_tool(mesh.facet_normal(f)).dot(u.normal) < 0) return;
                const double square =
                    squared_distance(u.point, mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2));
                if (!(square < near2)) return;
                near2 = square;
                p.of_uncut[n] = number[i];
            });
        });
        return p;
    }

    /// How far outward the boundary goes at each vertex, without the offset being less than 0.
    void find_edited() {
        out_.assign(field_.size(), in_.offset);
        grow_.assign(uncut_.size(), 0);
        enabled_.assign(uncut_.size(), true);
        if (!in_.edits.empty() || !in_.drags.empty()) {
            unedited_ = pieces(out_).of_uncut;
            for (const RegionEdit& e : in_.edits) {
                std::size_t nearest = 0;
                for (std::size_t i = 1; i < uncut_.size(); ++i)
                    if ((uncut_[i].point - vec(e.place)).squaredNorm()
                        < (uncut_[nearest].point - vec(e.place)).squaredNorm())
                        nearest = i;
                edited_.push_back(nearest);
                for (std::size_t i = 0; i < uncut_.size(); ++i)
                    if (unedited_[i] == unedited_[nearest]) {
                        grow_[i] = e.grow;
                        enabled_[i] = e.enabled;
                    }
            }
        }
        for (std::size_t v = 0; v < out_.size(); ++v) {
            if (nearest_[v] == no_index) continue;
            out_[v] += grow_[nearest_[v]];
            for (const BoundaryDrag& d : in_.drags) {
                const Vec3 from = vec(d.from), to = vec(d.to);
                const double length = (to - from).norm();
                const double reach = std::max(drag_reach * length, min_drag_reach * in_.spacing);
                const double share = bump((fine_.vertices[v] - from).norm() / reach);
                if (!(share > 0) || !(length > 0)) continue;
                // Outward where the place dragged to is farther from what is uncut.
                const auto distance = [&](const Vec3& p) {
                    double least = infinity;
                    for (const auto& u : uncut_)
                        least = std::min(least, (u.point - p).norm());
                    return least;
                };
                const auto [known, is_new] = drag_length_.try_emplace(&d, 0);
                if (is_new) known->second = (distance(to) - distance(from)) / bump(length / reach);
                out_[v] += share * known->second;
            }
            out_[v] = std::max(out_[v], 0.0);
        }
    }

    void cut_regions() {
        const Pieces p = pieces(out_);
        std::vector<ReworkRegion> regions(p.facets.size());
        std::set<std::pair<std::size_t, std::size_t>> parts;
        for (std::size_t i = 0; i < uncut_.size(); ++i) {
            ReworkRegion& r = regions[p.of_uncut[i]];
            const bool first = r.uncut++ == 0;
            if (first) r.place = uncut_[i].point;
            r.lead_largest = std::max(r.lead_largest, uncut_[i].lead);
            // What has grown together is one region, cut where one of its parts is.
            r.strip.enabled = enabled_[i] || (!first && r.strip.enabled);
            r.grow = first ? grow_[i] : std::max(r.grow, grow_[i]);
            if (parts.emplace(p.of_uncut[i], unedited_.empty() ? p.of_uncut[i] : unedited_[i]).second)
                r.places.push_back(uncut_[i].point);
        }
        for (std::size_t e = 0; e < edited_.size(); ++e)
            regions[p.of_uncut[edited_[e]]].edits.push_back(e);
        std::vector<Index> within;
        std::vector<std::pair<Vec3, std::size_t>> order;
        for (std::size_t i = 0; i < regions.size(); ++i) {
            ReworkRegion& r = regions[i];
            const PartPiece piece = p.known.piece(p.facets[i]);
            Vec3 first = Vec3::Constant(infinity);
            for (std::size_t f = 0; f < piece.mesh->facets.size(); ++f) {
                r.strip.band.push_back(
                    {piece.mesh->corner(f, 0), piece.mesh->corner(f, 1), piece.mesh->corner(f, 2)});
                for (const Vec3& c : r.strip.band.back())
                    if (std::pair(c.x(), c.y()) < std::pair(first.x(), first.y())) first = c;
            }
            r.strip.kind = StripKind::rework;
            r.strip.boundaries = border_loops(*piece.mesh);
            r.strip.area = mesh_area(*piece.mesh);
            if (r.uncut > 0) order.emplace_back(first, i);
            if (r.uncut > 0 && r.strip.enabled)
                within.insert(within.end(), p.facets[i].begin(), p.facets[i].end());
        }
        std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
            return std::tuple(a.first.x(), a.first.y(), a.second)
                   < std::tuple(b.first.x(), b.first.y(), b.second);
        });
        for (const auto& [first, i] : order) {
            result_.regions.push_back(std::move(regions[i]));
            result_.regions.back().strip.name = "Region " + std::to_string(result_.regions.size());
        }
        std::sort(within.begin(), within.end());
        result_.within = p.known.piece(within);
        result_.area = mesh_area(*result_.within.mesh);
    }

    const RegionInput& in_;
    std::span<const UncutPlace> uncut_;
    const Progress& progress_;
    UpSide up_;
    Known surface_;
    BoxTree tree_;                                       ///< of the uncut places
    Mesh fine_;                                          ///< the surface with short edges near them
    std::vector<Vec3> normals_;                          ///< at its vertices
    std::unordered_map<std::uint64_t, Index> middle_of_; ///< its vertex between two others
    double far_ = 0, level_ = 0;
    std::vector<double> field_;  ///< smoothed distance, per vertex; `far_` and more is one
    std::vector<Index> nearest_; ///< uncut place
    std::vector<double> out_, grow_;
    std::vector<bool> enabled_;
    std::vector<std::size_t>
        unedited_;                    ///< the region of each uncut place without edits; empty: there are none
    std::vector<std::size_t> edited_; ///< the uncut place nearest to each edit
    std::map<const BoundaryDrag*, double> drag_length_;
    ReworkRegions result_;
};

} // namespace

ReworkRegions rework_regions(const RegionInput& input, std::span<const UncutPlace> uncut,
                             const Progress& progress) {
    return Builder(input, uncut, progress).run();
}

} // namespace facetmill
