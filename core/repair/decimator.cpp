#include "core/repair/decimator.h"

#include "core/mesh/exact_area.h"
#include "core/mesh/triangle_distance.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace facetmill::detail {

namespace {

constexpr std::size_t collapses_per_check = 2048;
/// Cosine of the largest turn of a facet in one collapse, and its least height as a share of its longest
/// side, unless it was lower before.
constexpr double min_cosine = 0.2, min_height = 0.02;
/// Weight of what keeps a border where it is, and of staying in the middle where nothing else decides.
constexpr double border_weight = 10, middle_weight = 1e-3;

double height_share(const std::array<Vec3, 3>& t, const Vec3& cross) {
    const double longest =
        std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
    return cross.norm() / std::max(longest, 1e-300);
}
bool keeps_shape(const std::array<Vec3, 3>& before, const std::array<Vec3, 3>& after) {
    const Vec3 old = (before[1] - before[0]).cross(before[2] - before[0]);
    const Vec3 now = (after[1] - after[0]).cross(after[2] - after[0]);
    if (now.dot(old) <= min_cosine * now.norm() * old.norm()) return false;
    const double height = height_share(after, now);
    if (height < min_height && height < height_share(before, old)) return false;
    return !exactly_collinear(after[0], after[1], after[2]);
}

} // namespace

Decimator::Decimator(const Mesh& mesh, const DeviationIndex& surface, const std::vector<char>& held,
                     const Progress& progress)
    : mesh_(mesh), surface_(surface), sheets_(mesh, progress.part(0, 0.6)), half_(sheets_.half()),
      origin_(mesh.box().center()), left_(half_.n_faces()) {
    for (std::size_t v = 0; v < held.size(); ++v)
        if (held[v]) sheets_.hold(Index(v));
    first_.assign(half_.n_faces(), no_index);
    next_.assign(half_.n_vertices(), no_index);
    stamps_.assign(half_.n_vertices(), 0);
    log_.refused.assign(half_.n_edges(), 0);
    measure(progress.part(0.6, 1));
}

std::uint32_t Decimator::stamp_of(Edge e) const {
    const Halfedge h = half_.halfedge_handle(e, 0);
    return stamps_[id(half_.from_vertex_handle(h))] + stamps_[id(half_.to_vertex_handle(h))];
}

void Decimator::repeat(const DecimationLog& log, const std::vector<char>& held_now,
                       const Progress& progress) {
    bound2_ = infinity; // all of this was looked at
    changed_.assign(half_.n_vertices(), 0);
    std::copy(held_now.begin(), held_now.end(), changed_.begin());
    log_.refused = log.refused;
    std::size_t done = 0;
    for (const DecimationLog::Collapse& c : log.collapses) {
        if (++done % collapses_per_check == 0) progress.set(double(done) / double(log.collapses.size()));
        const Vertex u{int(c.from)}, v{int(c.into)};
        if (half_.status(u).deleted() || half_.status(v).deleted()) continue;
        // Where all around is as it was, the edge is there, and may go.
        const bool as_before = !is_changed(u) && !is_changed(v);
        const Halfedge h = as_before ? half_.find_halfedge(u, v) : Halfedge();
        if (h.is_valid() && collect(u, v, c.to) && place_points(u, v))
            collapse(h, c.to);
        else
            changed_[id(u)] = changed_[id(v)] = 1;
    }
}

/// It, or a vertex beside it, is not as in the run that was repeated.
bool Decimator::is_changed(Vertex v) const {
    if (changed_[id(v)]) return true;
    for (const Vertex w : half_.vv_range(v))
        if (changed_[id(w)]) return true;
    return false;
}

void Decimator::run(double bound, std::size_t least, const Progress& progress) {
    bound2_ = bound * bound;
    for (const Edge e : half_.edges())
        if (!half_.status(e).deleted()) offer(e);
    const std::size_t before = left_;
    const auto to_go = double(before - std::min(least, before - 1));
    std::size_t done = 0;
    while (left_ > least && !queue_.empty()) {
        const Candidate c = queue_.top();
        queue_.pop();
        if (++done % collapses_per_check == 0) progress.set(double(before - left_) / to_go);
        const Edge e{int(c.edge)};
        if (half_.status(e).deleted() || stamp_of(e) != c.stamp) continue;
        const Halfedge h = half_.halfedge_handle(e, 0);
        const bool refused_before = log_.refused[c.edge] == c.stamp + 1 && !changed_.empty()
                                    && !is_changed(half_.from_vertex_handle(h))
                                    && !is_changed(half_.to_vertex_handle(h));
        if (!refused_before && !try_collapse(h)) log_.refused[c.edge] = c.stamp + 1;
    }
}

void Decimator::measure(const Progress& progress) {
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
bool Decimator::target(Vertex u, Vertex v, Vec3& to, double& cost) const {
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

void Decimator::offer(Edge e) {
    const Halfedge h = half_.halfedge_handle(e, 0);
    Vec3 to;
    double cost = 0;
    if (target(half_.from_vertex_handle(h), half_.to_vertex_handle(h), to, cost))
        queue_.push({cost, std::uint32_t(e.idx()), stamp_of(e)});
}

/// False where the edge has to stay.
bool Decimator::try_collapse(Halfedge h) {
    // The one that stays is the held one.
    if (sheets_.is_held(half_.from_vertex_handle(h))) h = half_.opposite_halfedge_handle(h);
    const Vertex u = half_.from_vertex_handle(h), v = half_.to_vertex_handle(h);
    Vec3 to;
    double cost = 0;
    if (!target(u, v, to, cost) || !half_.is_collapse_ok(h)) return false;
    if (!collect(u, v, to) || !place_points(u, v) || !stays_near(to)) return false;
    collapse(h, to);
    if (!changed_.empty()) changed_[id(v)] = 1;
    for (const auto out : half_.voh_range(v))
        offer(half_.edge_handle(out));
    return true;
}

/// Of an edge for which `collect` and `place_points` were true.
void Decimator::collapse(Halfedge h, const Vec3& to) {
    const Vertex u = half_.from_vertex_handle(h), v = half_.to_vertex_handle(h);
    left_ -= gone_.size();
    log_.collapses.push_back({to, Index(u.idx()), Index(v.idx())});
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
}

/// The facets that stay around the edge, with their corners afterwards, and those that go. False where
/// one of them would turn over or lose its height.
bool Decimator::collect(Vertex u, Vertex v, const Vec3& to) {
    fresh_.clear();
    gone_.clear();
    corners_.clear();
    for (const Vertex w : {u, v})
        for (const auto f : half_.vf_range(w)) {
            const auto c = sheets_.corners(f);
            const bool both = (c[0] == u || c[1] == u || c[2] == u) && (c[0] == v || c[1] == v || c[2] == v);
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

/// Finds the nearest facet for each vertex that went, those of the edge among them; false where one is
/// farther than the bound.
bool Decimator::place_points(Vertex u, Vertex v) {
    points_.clear();
    const auto place = [&](Index point) {
        const auto& p = source_place(point);
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
bool Decimator::stays_near(const Vec3& to) const {
    if (!surface_.is_within(to, bound2_)) return false;
    // Most vertices around stand in two facets: behind the new one in one, before it in the other.
    const auto stands_behind = [&](const Vec3& p) {
        return std::any_of(corners_.begin(), corners_.end(), [&](const auto& c) {
            return (c[0] == to && c[1] == p) || (c[1] == to && c[2] == p) || (c[2] == to && c[0] == p);
        });
    };
    for (const auto& c : corners_)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = c[k];
            const bool behind = c[(k + 2) % 3] == to;
            if (p == to || (!behind && stands_behind(p))) continue;
            if (!surface_.is_within(0.5 * (p + to), bound2_)) return false;
        }
    return true;
}

/// Where a vertex of the source was.
Vec3 Decimator::source_place(Index v) const {
    return v < mesh_.vertices.size() ? mesh_.vertices[v] : sheets_.place(Vertex(int(v)));
}

} // namespace facetmill::detail
