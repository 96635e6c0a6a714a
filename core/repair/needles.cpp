// Needles: facets that are low for their length. Their direction is noise, and they hold up everything that
// goes by facets. Short edges go, long ones are turned, each as far as the bound allows: a facet carries how
// far it may lie from where the surface was, and every change adds the most that it can move.
#include "core/repair/needles.h"
#include "core/mesh/exact_area.h"
#include "core/repair/doubles.h"
#include "core/repair/repair_step.h"
#include "core/repair/sheet_edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

constexpr int max_needle_rounds = 30;

/// Its least height as a share of its longest side.
double flatness(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double longest2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return longest2 > 0 ? (b - a).cross(c - a).norm() / longest2 : 0.0;
}

} // namespace

bool is_needle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return flatness(a, b, c) < needle_height_share;
}

std::size_t count_needles(const Mesh& mesh) {
    std::size_t n = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        n += is_needle(mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2));
    return n;
}

namespace detail {

namespace {

class NeedleRemover {
    using Vertex = SheetEdit::Vertex;
    using Edge = SheetEdit::Edge;
    using Halfedge = SheetEdit::Halfedge;
    using Face = SheetEdit::Face;

public:
    NeedleRemover(const Mesh& mesh, double bound, const Progress& progress)
        : sheets_(mesh, progress), half_(sheets_.half()), bound_(bound), moved_(half_.n_faces(), 0.0) {}

    void run(const Progress& progress) {
        for (int round = 0; round < max_needle_rounds; ++round) {
            bool any = false;
            for (std::size_t i = 0; i < moved_.size(); ++i) {
                if (i % 16384 == 0) progress.check();
                const Face f{int(i)};
                if (half_.status(f).deleted() || !is_needle_now(f)) continue;
                any = collapse_shortest(f) || turn_longest(f) || any;
            }
            progress.set(double(round + 1) / max_needle_rounds);
            if (!any) break;
        }
        for (std::size_t i = 0; i < moved_.size(); ++i)
            left += !half_.status(Face(int(i))).deleted() && is_needle_now(Face(int(i)));
    }

    std::shared_ptr<Mesh> result(const Progress& progress) const { return sheets_.mesh(progress); }
    std::size_t left_out() const { return sheets_.left_out(); }

    std::size_t collapsed = 0, turned = 0, left = 0;
    double displacement = 0;

private:
    std::array<Vec3, 3> places(Face f) const {
        const auto c = sheets_.corners(f);
        return {sheets_.place(c[0]), sheets_.place(c[1]), sheets_.place(c[2])};
    }
    bool is_needle_now(Face f) const {
        const auto p = places(f);
        return is_needle(p[0], p[1], p[2]);
    }
    double moved(Face f) const { return moved_[std::size_t(f.idx())]; }
    double length(Halfedge h) const {
        return (sheets_.place(half_.to_vertex_handle(h)) - sheets_.place(half_.from_vertex_handle(h))).norm();
    }

    bool collapse_shortest(Face f) {
        const Halfedge first = half_.halfedge_handle(f);
        const std::array<Halfedge, 3> sides{first, half_.next_halfedge_handle(first),
                                            half_.prev_halfedge_handle(first)};
        const Halfedge shortest = *std::min_element(
            sides.begin(), sides.end(), [&](Halfedge a, Halfedge b) { return length(a) < length(b); });
        return collapse(shortest) || collapse(half_.opposite_halfedge_handle(shortest));
    }

    /// The vertex that it starts at goes to the one that it ends at.
    bool collapse(Halfedge h) {
        const Vertex u = half_.from_vertex_handle(h), v = half_.to_vertex_handle(h);
        if (sheets_.is_held(u) || !half_.is_collapse_ok(h)) return false;
        // A border keeps its course: it goes along itself only.
        if (half_.is_boundary(u) && !half_.is_boundary(half_.edge_handle(h))) return false;
        const double step = length(h);
        double before = 0;
        for (const auto g : half_.vf_range(u)) {
            before = std::max(before, moved(g));
            auto c = sheets_.corners(g);
            if (std::find(c.begin(), c.end(), v) != c.end()) continue;
            auto p = places(g), q = p;
            for (std::size_t k = 0; k < 3; ++k)
                if (c[k] == u) q[k] = sheets_.place(v);
            if (!fits(p, q)) return false;
        }
        if (before + step > bound_) return false;
        for (const auto g : half_.vf_range(u))
            moved_[std::size_t(g.idx())] = before + step;
        half_.collapse(h);
        displacement = std::max(displacement, before + step);
        ++collapsed;
        return true;
    }

    /// Does not turn over, and is no worse a needle unless it is none.
    static bool fits(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& q) {
        const Vec3 was = (p[1] - p[0]).cross(p[2] - p[0]), is = (q[1] - q[0]).cross(q[2] - q[0]);
        if (exactly_collinear(q[0], q[1], q[2])) return false;
        const bool needle = is_needle(p[0], p[1], p[2]); // whose direction says nothing
        if (!needle && is.dot(was) <= 0.5 * is.norm() * was.norm()) return false;
        return !is_needle(q[0], q[1], q[2]) || flatness(q[0], q[1], q[2]) >= flatness(p[0], p[1], p[2]);
    }

    bool turn_longest(Face f) {
        Halfedge h = half_.halfedge_handle(f), longest = h;
        for (int k = 0; k < 3; ++k, h = half_.next_halfedge_handle(h))
            if (length(h) > length(longest)) longest = h;
        const Edge e = half_.edge_handle(longest);
        if (half_.is_boundary(e) || !half_.is_flip_ok(e)) return false;
        const Halfedge across = half_.opposite_halfedge_handle(longest);
        const Face g = half_.face_handle(across);
        const Vec3 a = sheets_.place(half_.from_vertex_handle(longest)),
                   b = sheets_.place(half_.to_vertex_handle(longest)),
                   c = sheets_.place(half_.to_vertex_handle(half_.next_halfedge_handle(longest))),
                   d = sheets_.place(half_.to_vertex_handle(half_.next_halfedge_handle(across)));
        // The corner over the edge comes onto the other facet: nothing moves farther than it lies off.
        const double height = (b - a).cross(c - a).norm() / (b - a).norm();
        const double all = std::max(moved(f), moved(g)) + height;
        if (all > bound_) return false;
        const Vec3 normal = (a - b).cross(d - b);
        const Vec3 first = (d - c).cross(b - c), second = (a - c).cross(d - c);
        if (first.dot(normal) <= 0.5 * first.norm() * normal.norm()
            || second.dot(normal) <= 0.5 * second.norm() * normal.norm())
            return false;
        if (std::min(flatness(c, d, b), flatness(c, a, d)) <= std::min(flatness(a, b, c), flatness(b, a, d)))
            return false;
        if (exactly_collinear(c, d, b) || exactly_collinear(c, a, d)) return false;
        half_.flip(e);
        moved_[std::size_t(f.idx())] = moved_[std::size_t(g.idx())] = all;
        displacement = std::max(displacement, all);
        ++turned;
        return true;
    }

    SheetEdit sheets_;
    HalfedgeMesh& half_;
    double bound_;
    std::vector<double> moved_; ///< per face: how far it lies at most from where the surface was
};

} // namespace

StepResult remove_needles(const Mesh& source, const RepairStep& step, const Progress& progress) {
    StepResult result;
    const std::vector<char> doubled = doubled_facets(source, progress.part(0, 0.1));
    const auto doubles = std::size_t(std::count(doubled.begin(), doubled.end(), 1));
    MeshPtr single;
    if (doubles > 0) {
        std::vector<char> stays(doubled.size());
        for (std::size_t f = 0; f < stays.size(); ++f)
            stays[f] = !doubled[f];
        single = with_facets(source, stays, progress);
    }
    const Mesh& mesh = single ? *single : source;
    NeedleRemover remover(mesh, step.bound, progress.part(0.1, 0.5));
    remover.run(progress.part(0.5, 1));
    result.displacement = remover.displacement;
    result.tell("edges_collapsed", remover.collapsed);
    result.tell("edges_turned", remover.turned);
    result.tell_any("doubles_removed", doubles);
    result.tell_any("needles_left", remover.left);
    result.tell_any("facets_in_no_sheet", remover.left_out());
    if (remover.collapsed + remover.turned > 0)
        result.mesh = remover.result(progress);
    else
        result.mesh = single;
    return result;
}

} // namespace detail

} // namespace facetmill
