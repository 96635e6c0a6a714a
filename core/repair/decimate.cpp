// Decimated within a bound: edges go in the order of the error that they leave (Garland, Heckbert, "Surface
// simplification using quadric error metrics", 1997). Every vertex that went is kept with the facet that it
// lies nearest to, and must stay within the bound of it; at the end the distance of the two surfaces is
// measured both ways, and where it is larger than the bound it is done again with the vertices there held.
#include "core/base/parallel.h"
#include "core/mesh/exact_area.h"
#include "core/mesh/triangle_distance.h"
#include "core/repair/deviation.h"
#include "core/repair/repair_step.h"
#include "core/repair/sheet_edit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace facetmill::detail {

namespace {

constexpr std::size_t collapses_per_check = 2048;
constexpr int max_attempts = 8;
/// Share of the bound that the vertices that went may use at the first attempt, and of that at each further
/// one: places between them are somewhat farther away.
constexpr double first_share = 0.8, further_share = 0.8;
/// To this share of the bound the deviation is measured.
constexpr double measured_share = 0.02;
/// Cosine of the largest turn of a facet in one collapse, and its least height as a share of its longest
/// side, unless it was lower before.
constexpr double min_cosine = 0.2, min_height = 0.02;
/// Weight of what keeps a border where it is, and of staying in the middle where nothing else decides.
constexpr double border_weight = 10, middle_weight = 1e-3;

/// Sum of squared distances from planes, weighed by area: p A p + 2 b p + c.
struct Quadric {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    Vec3 b = Vec3::Zero();
    double c = 0;

    void add_plane(const Vec3& n, double d, double weight) {
        xx += weight * n.x() * n.x();
        xy += weight * n.x() * n.y();
        xz += weight * n.x() * n.z();
        yy += weight * n.y() * n.y();
        yz += weight * n.y() * n.z();
        zz += weight * n.z() * n.z();
        b += weight * d * n;
        c += weight * d * d;
    }
    void add(const Quadric& q) {
        xx += q.xx;
        xy += q.xy;
        xz += q.xz;
        yy += q.yy;
        yz += q.yz;
        zz += q.zz;
        b += q.b;
        c += q.c;
    }
    Mat3 matrix() const {
        Mat3 m;
        m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
        return m;
    }
    double at(const Vec3& p) const { return std::max(0.0, p.dot(matrix() * p) + 2 * b.dot(p) + c); }
};

class Decimator {
    using Vertex = SheetEdit::Vertex;
    using Edge = SheetEdit::Edge;
    using Halfedge = SheetEdit::Halfedge;
    using Face = SheetEdit::Face;

public:
    Decimator(const Mesh& mesh, const DeviationIndex& surface, const std::vector<char>& held,
              const Progress& progress)
        : mesh_(mesh), surface_(surface), sheets_(mesh, progress.part(0, 0.6)), half_(sheets_.half()),
          origin_(mesh.box().center()) {
        for (std::size_t v = 0; v < held.size(); ++v)
            if (held[v]) sheets_.hold(Index(v));
        first_.assign(half_.n_faces(), no_index);
        stamps_.assign(half_.n_vertices(), 0);
        measure(progress.part(0.6, 1));
    }

    /// Until `least` facets are left, or no edge can go within the bound.
    void run(double bound, std::size_t least, const Progress& progress) {
        bound2_ = bound * bound;
        for (const Edge e : half_.edges())
            offer(e);
        const std::size_t before = half_.n_faces();
        std::size_t left = before, done = 0;
        while (left > least && !queue_.empty()) {
            const Candidate c = queue_.top();
            queue_.pop();
            if (++done % collapses_per_check == 0)
                progress.set(double(before - left) / double(before - std::min(least, before - 1)));
            const Edge e{int(c.edge)};
            if (half_.status(e).deleted() || stamp_of(e) != c.stamp) continue;
            left -= collapse(half_.halfedge_handle(e, 0));
        }
    }

    std::shared_ptr<Mesh> result(const Progress& progress) const { return sheets_.mesh(progress); }
    std::size_t left_out() const { return sheets_.left_out(); }

private:
    struct Candidate {
        double cost;
        std::uint32_t edge, stamp;
        bool operator<(const Candidate& other) const {
            return cost > other.cost || (cost == other.cost && edge > other.edge);
        }
    };
    struct Point {
        Index point;      ///< vertex of the source
        std::size_t face; ///< of `fresh_`
    };

    static std::size_t id(OpenMesh::BaseHandle h) { return std::size_t(h.idx()); }
    std::uint32_t stamp_of(Edge e) const {
        const Halfedge h = half_.halfedge_handle(e, 0);
        return stamps_[id(half_.from_vertex_handle(h))] + stamps_[id(half_.to_vertex_handle(h))];
    }

    void measure(const Progress& progress) {
        quadrics_.assign(half_.n_vertices(), Quadric{});
        for (const Face f : half_.faces()) {
            if (f.idx() % 65536 == 0) progress.check();
            const auto c = sheets_.corners(f);
            const Vec3 p = sheets_.place(c[0]) - origin_;
            const Vec3 cross = (sheets_.place(c[1]) - origin_ - p).cross(sheets_.place(c[2]) - origin_ - p);
            const double length = cross.norm();
            if (!(length > 0)) continue;
            const Vec3 n = cross / length;
            for (const Vertex v : c)
                quadrics_[id(v)].add_plane(n, -n.dot(p), length / 6);
            Halfedge h = half_.halfedge_handle(f);
            for (int k = 0; k < 3; ++k, h = half_.next_halfedge_handle(h)) {
                if (!half_.is_boundary(half_.opposite_halfedge_handle(h))) continue;
                // A plane through the border, upright on the facet.
                const Vertex from = half_.from_vertex_handle(h), to = half_.to_vertex_handle(h);
                const Vec3 a = sheets_.place(from) - origin_, side = sheets_.place(to) - origin_ - a;
                const Vec3 across = side.cross(n).normalized();
                for (const Vertex v : {from, to})
                    quadrics_[id(v)].add_plane(across, -across.dot(a), border_weight * side.squaredNorm());
            }
        }
    }

    /// Where the vertex goes that takes the place of both; none where both are held.
    bool target(Vertex u, Vertex v, Vec3& to, double& cost) const {
        Quadric q = quadrics_[id(u)];
        q.add(quadrics_[id(v)]);
        const Vec3 a = sheets_.place(u) - origin_, b = sheets_.place(v) - origin_;
        if (sheets_.is_held(u) && sheets_.is_held(v)) return false;
        if (sheets_.is_held(u) || sheets_.is_held(v)) {
            to = sheets_.is_held(u) ? sheets_.place(u) : sheets_.place(v);
        } else {
            const Vec3 middle = 0.5 * (a + b);
            Mat3 m = q.matrix();
            const double weight = middle_weight * m.trace() + 1e-300;
            m.diagonal().array() += weight;
            const Vec3 p = m.ldlt().solve(weight * middle - q.b);
            // Not far from the edge: there the planes say little.
            const bool near = p.allFinite() && (p - middle).squaredNorm() <= (b - a).squaredNorm();
            to = rounded_to_float((near ? p : middle) + origin_);
        }
        cost = q.at(to - origin_) + 1e-9 * (b - a).squaredNorm() * (b - a).squaredNorm();
        return true;
    }

    void offer(Edge e) {
        const Halfedge h = half_.halfedge_handle(e, 0);
        Vec3 to;
        double cost = 0;
        if (target(half_.from_vertex_handle(h), half_.to_vertex_handle(h), to, cost))
            queue_.push({cost, std::uint32_t(e.idx()), stamp_of(e)});
    }

    /// How many facets go; 0 where the edge has to stay.
    std::size_t collapse(Halfedge h) {
        // The one that stays is the held one.
        if (sheets_.is_held(half_.from_vertex_handle(h))) h = half_.opposite_halfedge_handle(h);
        const Vertex u = half_.from_vertex_handle(h), v = half_.to_vertex_handle(h);
        Vec3 to;
        double cost = 0;
        if (!target(u, v, to, cost) || !half_.is_collapse_ok(h)) return 0;
        if (!collect(u, v, to) || !place_points(u, v) || !stays_near(to)) return 0;
        const std::size_t gone = gone_.size();
        half_.collapse(h);
        sheets_.set_place(v, to);
        quadrics_[id(v)].add(quadrics_[id(u)]);
        for (const Face f : fresh_)
            first_[id(f)] = no_index;
        for (const Point& p : points_) {
            next_[p.point] = first_[id(fresh_[p.face])];
            first_[id(fresh_[p.face])] = p.point;
        }
        stamps_[id(v)] = std::max(stamps_[id(u)], stamps_[id(v)]) + 1;
        for (const auto out : half_.voh_range(v))
            offer(half_.edge_handle(out));
        return gone;
    }

    /// The facets that stay around the edge, with their corners afterwards, and those that go. False where
    /// one of them would turn over or lose its height.
    bool collect(Vertex u, Vertex v, const Vec3& to) {
        fresh_.clear();
        gone_.clear();
        corners_.clear();
        for (const Vertex w : {u, v})
            for (const auto f : half_.vf_range(w)) {
                const auto c = sheets_.corners(f);
                const bool both =
                    (c[0] == u || c[1] == u || c[2] == u) && (c[0] == v || c[1] == v || c[2] == v);
                if (both) {
                    if (w == u) gone_.push_back(f);
                    continue;
                }
                std::array<Vec3, 3> before, after;
                for (std::size_t k = 0; k < 3; ++k) {
                    before[k] = sheets_.place(c[k]);
                    after[k] = c[k] == w ? to : before[k];
                }
                if (!keeps_shape(before, after)) return false;
                fresh_.push_back(f);
                corners_.push_back(after);
            }
        return !fresh_.empty();
    }

    static double height_share(const std::array<Vec3, 3>& t, const Vec3& cross) {
        const double longest =
            std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
        return cross.norm() / std::max(longest, 1e-300);
    }
    static bool keeps_shape(const std::array<Vec3, 3>& before, const std::array<Vec3, 3>& after) {
        const Vec3 old = (before[1] - before[0]).cross(before[2] - before[0]);
        const Vec3 now = (after[1] - after[0]).cross(after[2] - after[0]);
        if (now.dot(old) <= min_cosine * now.norm() * old.norm()) return false;
        const double height = height_share(after, now);
        if (height < min_height && height < height_share(before, old)) return false;
        return !exactly_collinear(after[0], after[1], after[2]);
    }

    /// Finds the nearest facet for each vertex that went, those of the edge among them; false where one is
    /// farther than the bound.
    bool place_points(Vertex u, Vertex v) {
        points_.clear();
        if (next_.empty()) next_.assign(half_.n_vertices(), no_index);
        const auto place = [&](Index point) {
            const auto& p = half_point(point);
            double nearest = infinity;
            std::size_t face = 0;
            for (std::size_t i = 0; i < corners_.size(); ++i) {
                const double d2 = squared_distance(p, corners_[i][0], corners_[i][1], corners_[i][2]);
                if (d2 < nearest) {
                    nearest = d2;
                    face = i;
                }
            }
            points_.push_back({point, face});
            return nearest <= bound2_;
        };
        for (const Vertex w : {u, v}) // one that has moved stands among the points already
            if (stamps_[id(w)] == 0 && !place(Index(w.idx()))) return false;
        for (const auto* faces : {&fresh_, &gone_})
            for (const Face f : *faces)
                for (Index p = first_[id(f)]; p != no_index; p = next_[p])
                    if (!place(p)) return false;
        return true;
    }
    /// The new vertex, and the middles of the edges that it gets, lie within the bound of the source.
    bool stays_near(const Vec3& to) const {
        const auto first = surface_.place(to);
        if (first.distance * first.distance > bound2_) return false;
        for (const auto& c : corners_)
            for (const Vec3& p : c) {
                if (p == to) continue;
                const double d = surface_.place(0.5 * (p + to), first.facet).distance;
                if (d * d > bound2_) return false;
            }
        return true;
    }
    /// Where a vertex of the source was.
    Vec3 half_point(Index v) const {
        return v < mesh_.vertices.size() ? mesh_.vertices[v] : sheets_.place(Vertex(int(v)));
    }

    const Mesh& mesh_;
    const DeviationIndex& surface_;
    SheetEdit sheets_;
    HalfedgeMesh& half_;
    Vec3 origin_;
    double bound2_ = 0;
    std::vector<Quadric> quadrics_;
    std::vector<std::uint32_t> stamps_; ///< per vertex: 0 until it moves, and more after each move
    std::priority_queue<Candidate> queue_;
    std::vector<Index> first_, next_; ///< the vertices that went, in lists by face
    std::vector<Face> fresh_, gone_;
    std::vector<std::array<Vec3, 3>> corners_; ///< of `fresh_`
    std::vector<Point> points_;
};

/// Holds the vertices at places of `mesh` that lie beyond the bound of `result`, and back.
std::size_t hold_beyond(const Mesh& mesh, const DeviationIndex& surface, const Mesh& result, double bound,
                        double& deviation, std::vector<char>& held, const Progress& progress) {
    std::size_t beyond = 0;
    const double accuracy = measured_share * bound;
    const auto hold = [&](Index f) {
        for (const Index v : mesh.facets[f])
            held[v] = 1;
    };
    double forward = 0, backward = 0;
    {
        const DeviationIndex index(result, progress.part(0, 0.1));
        for (const Index f :
             facets_beyond(mesh, index, bound, accuracy, facets_in_both(mesh, result, progress), forward,
                           progress.part(0.1, 0.5))) {
            hold(f);
            ++beyond;
        }
    }
    for (const Index f :
         facets_beyond(result, surface, bound, accuracy, facets_in_both(result, mesh, progress), backward,
                       progress.part(0.6, 1))) {
        const Vec3 &a = result.corner(f, 0), &b = result.corner(f, 1), &c = result.corner(f, 2);
        for (const Vec3& p :
             {a, b, c, Vec3((a + b + c) / 3), Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2)})
            hold(surface.nearest_facet(p));
        ++beyond;
    }
    deviation = std::max(forward, backward);
    return beyond;
}

} // namespace

StepResult decimate(const Mesh& mesh, const RepairStep& step, const Progress& progress) {
    StepResult result;
    const auto least = std::max(std::size_t(std::llround(step.share * double(mesh.facet_count()))),
                                std::size_t(step.facets));
    std::vector<char> held(mesh.vertices.size(), 0);
    double share = first_share;
    const DeviationIndex surface(mesh, progress.part(0, 0.05));
    for (int attempt = 0; attempt < max_attempts; ++attempt, share *= further_share) {
        const double from = 1 - std::pow(0.5, attempt), to = 1 - std::pow(0.5, attempt + 1);
        const Progress part = progress.part(from, to);
        std::shared_ptr<Mesh> after;
        std::size_t left_out = 0;
        {
            Decimator decimator(mesh, surface, held, part.part(0, 0.15));
            decimator.run(share * step.bound, least, part.part(0.15, 0.6));
            after = decimator.result(part);
            left_out = decimator.left_out();
        }
        if (after->facet_count() == mesh.facet_count()) break;
        double deviation = 0;
        const std::size_t beyond =
            hold_beyond(mesh, surface, *after, step.bound, deviation, held, part.part(0.6, 1));
        if (beyond > 0) continue;
        result.displacement = deviation;
        result.tell("facets_removed", mesh.facet_count() - after->facet_count());
        result.tell_any("attempts", std::size_t(attempt) + 1);
        result.tell_any("facets_in_no_sheet", left_out);
        result.mesh = std::move(after);
        return result;
    }
    result.tell("facets_removed", 0);
    return result;
}

} // namespace facetmill::detail
