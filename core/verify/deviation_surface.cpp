#include "core/verify/deviation_surface.h"

#include "core/base/parallel.h"
#include "core/base/plane_geometry.h"
#include "core/base/tolerances.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/geometry.h"
#include "core/verify/sweep.h"

#include <cmath>
#include <numeric>

namespace facetmill {

namespace {

/// What a thread takes at a time, between two looks at whether the job was cancelled: about a millisecond.
constexpr std::size_t facets_per_block = 8192, samples_per_block = 2048;
/// Facets whose normal is farther than this from that of a vertex are at a crease: the mean normal there is
/// that of neither side. Beyond the angle between neighbours of a curved surface that is usual in meshes.
constexpr double crease_degrees = 15;
/// The normal turns by more than this within a facet where the surface curves: samples are twice as dense.
constexpr double curved_degrees = 5;
/// Axes nearer than this to each other are one, to keep them few. The flag `away` is exact to that angle.
constexpr double axis_degrees = 2;
/// Every sample asks all axes; where there are more, they are merged within twice the angle.
constexpr std::size_t max_axes = 512;

/// A facet in rows of points: a grid parallel to its edges, or, of a sliver, across its longest edge. A row
/// of no pieces is a point.
class Rows {
public:
    Rows(const Mesh& mesh, std::size_t facet, double spacing) : spacing_(spacing) {
        int longest = 0;
        for (int k = 0; k < 3; ++k) {
            const double edge = (mesh.corner(facet, (k + 1) % 3) - mesh.corner(facet, k)).norm();
            if (edge <= length_) continue;
            length_ = edge;
            longest = k;
        }
        a_ = mesh.corner(facet, longest);
        b_ = mesh.corner(facet, (longest + 1) % 3);
        c_ = mesh.corner(facet, (longest + 2) % 3);
        height_ = mesh.facet_cross(facet).norm() / length_;
        sliver_ = height_ < 0.5 * length_;
        if (sliver_) {
            before_ = parts((c_ - a_).norm());
            count_ = before_ + parts((c_ - b_).norm());
            foot_ = a_ + ((c_ - a_).dot(b_ - a_) / (length_ * length_)) * (b_ - a_);
        } else {
            count_ = parts(length_);
        }
    }

    std::size_t rows() const { return count_ + 1; }
    std::size_t pieces(std::size_t row) const {
        if (!sliver_) return count_ - row;
        const double up = row <= before_ ? share(row) : 1 - share(row);
        return row == 0 || row == count_ ? 0 : parts(up * height_);
    }
    /// Ends of a row. Seen from outside the next row is on the left of this one, or of a sliver on the right.
    std::pair<Vec3, Vec3> ends(std::size_t row) const {
        if (!sliver_) {
            const double up = double(row) / double(count_);
            return {a_ + up * (c_ - a_), b_ + up * (c_ - b_)};
        }
        const double t = share(row);
        if (row <= before_) return {a_ + t * (foot_ - a_), a_ + t * (c_ - a_)};
        return {foot_ + t * (b_ - foot_), c_ + t * (b_ - c_)};
    }
    bool next_on_left() const { return !sliver_; }
    std::size_t points() const {
        std::size_t n = 0;
        for (std::size_t row = 0; row < rows(); ++row)
            n += pieces(row) + 1;
        return n;
    }
    std::size_t triangles() const {
        std::size_t n = 0;
        for (std::size_t row = 0; row < count_; ++row)
            n += pieces(row) + pieces(row + 1);
        return n;
    }

private:
    std::size_t parts(double length) const {
        return std::max<std::size_t>(1, std::size_t(std::ceil(length / spacing_)));
    }
    /// Of the way up to the corner c, or from it down.
    double share(std::size_t row) const {
        return row <= before_ ? double(row) / double(before_)
                              : double(row - before_) / double(count_ - before_);
    }
    Vec3 a_, b_, c_, foot_ = Vec3::Zero();
    std::size_t count_ = 1, before_ = 0;
    double length_ = 0, height_ = 0, spacing_ = 0;
    bool sliver_ = false;
};

/// How the facets are divided.
struct Division {
    enum Kind : std::uint8_t { none, shared, own, own_fine };
    std::vector<Kind> kinds;
    std::vector<std::size_t> first_point, first_triangle; ///< of own points; one more than facets
    std::size_t shared_points = 0;
    std::size_t points() const { return shared_points + first_point.back(); }
};

double spacing_of(Division::Kind kind, double spacing) {
    return kind == Division::own_fine ? 0.5 * spacing : spacing;
}

std::vector<std::array<Index, 2>> open_edges(const Mesh& part, const Progress& progress) {
    const EdgeTable table(part, progress);
    std::vector<std::array<Index, 2>> open;
    for (std::size_t low = 0; low < table.vertex_count(); ++low) {
        if (low % facets_per_block == 0) progress.check();
        table.for_edges(low, [&](Index high, std::span<const EdgeSide> sides) {
            if (sides.size() == 1) open.push_back({Index(low), high});
        });
    }
    return open;
}

/// Facets on whose edges a probe may run in the plane of the facet beyond, and those at the part's open
/// border: a tool that comes by there in touch with the edge alone may have the direction of the probe.
std::vector<char> edged_facets(const Mesh& part, const std::vector<Vec3>& vertex_normals,
                               const std::vector<std::array<Index, 2>>& open, const Progress& progress) {
    const double crease = std::cos(radians(crease_degrees));
    std::vector<char> on_border(part.vertices.size(), 0), edged(part.facet_count(), 0);
    for (const auto& edge : open)
        for (Index v : edge)
            on_border[v] = 1;
    parallel_for(part.facet_count(), facets_per_block, progress, [&](std::size_t f) {
        const Vec3 normal = part.facet_normal(f);
        for (Index v : part.facets[f])
            if (on_border[v] || vertex_normals[v].dot(normal) < crease) edged[f] = 1;
    });
    return edged;
}

Division divide(const Mesh& part, const std::vector<Vec3>& normals, const std::vector<char>& edged,
                double spacing, const Progress& progress) {
    const double curved = std::cos(radians(curved_degrees));
    const std::size_t n = part.facet_count();
    Division d;
    d.kinds.assign(n, Division::none);
    d.first_point.assign(n + 1, 0);
    d.first_triangle.assign(n + 1, 0);
    parallel_for(n, facets_per_block, progress, [&](std::size_t f) {
        const Vec3 normal = part.facet_normal(f);
        if (normal.isZero(0)) return;
        double turn = 1, edge = 0;
        const bool creased = edged[f] != 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3 &a = normals[part.facets[f][std::size_t(k)]],
                       &b = normals[part.facets[f][std::size_t((k + 1) % 3)]];
            turn = std::min(turn, a.dot(b));
            edge = std::max(edge, (part.corner(f, k) - part.corner(f, (k + 1) % 3)).norm());
        }
        const bool fine = !creased && turn < curved;
        if (!creased && edge <= (fine ? 0.5 : 1.0) * spacing) {
            d.kinds[f] = Division::shared;
            return;
        }
        d.kinds[f] = fine ? Division::own_fine : Division::own;
        const Rows rows(part, f, spacing_of(d.kinds[f], spacing));
        d.first_point[f + 1] = rows.points();
        d.first_triangle[f + 1] = rows.triangles();
    });
    std::partial_sum(d.first_point.begin(), d.first_point.end(), d.first_point.begin());
    std::partial_sum(d.first_triangle.begin(), d.first_triangle.end(), d.first_triangle.begin());
    std::vector<bool> used(part.vertices.size());
    for (std::size_t f = 0; f < n; ++f) {
        if (f % facets_per_block == 0) progress.check();
        if (d.kinds[f] != Division::shared) continue;
        for (Index v : part.facets[f]) {
            if (!used[v]) ++d.shared_points;
            used[v] = true;
        }
    }
    return d;
}

/// Triangles between two rows of points, of m + 1 and k + 1 points in the same direction.
template <class Add>
void join_rows(std::size_t below, std::size_t m, std::size_t above, std::size_t k, Add&& add) {
    std::size_t i = 0, j = 0;
    while (i < m || j < k) {
        // The row that is behind goes on.
        const bool lower = j == k || (i < m && (2 * i + 1) * k <= (2 * j + 1) * m);
        if (lower) {
            add(below + i, below + i + 1, above + j);
            ++i;
        } else {
            add(below + i, above + j + 1, above + j);
            ++j;
        }
    }
}

} // namespace

namespace {

/// Moves points of a facet off its edges.
class EdgeInset {
public:
    EdgeInset(const Mesh& mesh, std::size_t facet, const Vec3& normal, double inset) : inset_(inset) {
        const double area2 = mesh.facet_cross(facet).norm();
        double around = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3 &a = mesh.corner(facet, k), along = mesh.corner(facet, (k + 1) % 3) - a;
            const double length = along.norm();
            edges_[std::size_t(k)] = {a, normal.cross(along / length),
                                      std::min(inset, 0.25 * area2 / length)};
            middle_ += length * mesh.corner(facet, (k + 2) % 3);
            around += length;
        }
        middle_ /= around;
        radius_ = area2 / around;
    }
    Vec3 operator()(const Vec3& point) const {
        // Across the edges, where that leads off them all.
        Vec3 p = point;
        for (const Edge& e : edges_)
            p += std::max(0.0, e.least - e.above(point)) * e.inward;
        if (std::all_of(edges_.begin(), edges_.end(),
                        [&](const Edge& e) { return e.above(p) >= 0.5 * e.least; }))
            return p;
        // In acute corners towards the middle of the circle within, but not far.
        double share = 0;
        for (const Edge& e : edges_) {
            const double have = e.above(point), least = std::min(e.least, 0.25 * radius_);
            if (have < least) share = std::max(share, (least - have) / (radius_ - have));
        }
        const Vec3 route = share * (middle_ - point);
        const double most = 16 * inset_;
        return route.norm() > most ? Vec3(point + most / route.norm() * route) : Vec3(point + route);
    }

private:
    struct Edge {
        Vec3 start, inward;
        double least = 0;
        double above(const Vec3& p) const { return (p - start).dot(inward); }
    };
    std::array<Edge, 3> edges_;
    Vec3 middle_ = Vec3::Zero(); ///< of the circle within, and its radius
    double radius_ = 0, inset_;
};

} // namespace

SurfaceSamples sample_surface(const Mesh& part, double spacing, std::size_t most, const Progress& progress,
                              double edge_inset) {
    const std::vector<Vec3> normals = vertex_normals(part, NormalWeight::angle, progress.part(0.0, 0.2));
    auto open = open_edges(part, progress.part(0.2, 0.2));
    const std::vector<char> edged = edged_facets(part, normals, open, progress.part(0.2, 0.22));
    Division division = divide(part, normals, edged, spacing, progress.part(0.22, 0.3));
    std::size_t own = 0;
    // What is saved grows with the square of the spacing, of what is divided.
    for (int round = 0; round < 60 && division.points() > most && division.first_point.back() != own;
         ++round) {
        own = division.first_point.back();
        const double room = std::max(double(most) - double(division.shared_points), 0.25 * double(most));
        spacing *= std::clamp(std::sqrt(double(own) / room), 1.02, 8.0);
        division = divide(part, normals, edged, spacing, progress.part(0.3, 0.4));
    }

    SurfaceSamples s;
    s.open_edges = std::move(open);
    s.spacing = spacing;
    const std::size_t n = part.facet_count();
    s.points.reserve(division.points());
    s.normals.reserve(division.points());
    std::vector<Index> place(part.vertices.size(), no_index);
    for (std::size_t f = 0; f < n; ++f) {
        if (f % facets_per_block == 0) progress.check();
        if (division.kinds[f] != Division::shared) continue;
        std::array<std::uint32_t, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const Index v = part.facets[f][k];
            if (place[v] == no_index) {
                place[v] = Index(s.points.size());
                s.points.push_back(part.vertices[v]);
                s.normals.push_back(normals[v]);
            }
            corners[k] = place[v];
        }
        s.triangles.push_back(corners);
    }
    const std::size_t first_point = s.points.size(), first_triangle = s.triangles.size();
    s.points.resize(first_point + division.first_point.back());
    s.normals.resize(s.points.size());
    s.places = s.points;
    s.triangles.resize(first_triangle + division.first_triangle.back());
    parallel_for(n, facets_per_block / 8, progress.part(0.4, 0.9), [&](std::size_t f) {
        const Division::Kind kind = division.kinds[f];
        if (kind == Division::none || kind == Division::shared) return;
        const Rows rows(part, f, spacing_of(kind, spacing));
        const Vec3 normal = part.facet_normal(f);
        const bool inset = edge_inset > 0 && edged[f] != 0;
        const EdgeInset off_edges(part, f, normal, edge_inset);
        std::size_t at = first_point + division.first_point[f],
                    triangle = first_triangle + division.first_triangle[f];
        for (std::size_t row = 0; row < rows.rows(); ++row) {
            const auto [from, to] = rows.ends(row);
            const std::size_t m = rows.pieces(row);
            for (std::size_t i = 0; i <= m; ++i) {
                s.points[at + i] = m == 0 ? from : Vec3(from + (double(i) / double(m)) * (to - from));
                s.normals[at + i] = normal;
                s.places[at + i] = inset ? off_edges(s.points[at + i]) : s.points[at + i];
            }
            if (row + 1 < rows.rows())
                join_rows(
                    at, m, at + m + 1, rows.pieces(row + 1),
                    [&](std::size_t a, std::size_t b, std::size_t c) {
                        if (!rows.next_on_left()) std::swap(b, c);
                        s.triangles[triangle++] = {std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)};
                    });
            at += m + 1;
        }
    });
    s.weights.assign(s.points.size(), 0);
    s.flags.assign(s.points.size(), DeviationSurface::counted);
    s.upright.assign(s.points.size(), 0);
    s.slopes.assign(s.points.size(), 0);
    for (std::size_t i = 0; i < s.triangles.size(); ++i) {
        if (i % facets_per_block == 0) progress.check();
        const auto [a, b, c] = s.triangles[i];
        const double third = (s.points[b] - s.points[a]).cross(s.points[c] - s.points[a]).norm() / 6;
        for (std::uint32_t p : {a, b, c})
            s.weights[p] += third;
    }
    progress.set(1.0);
    return s;
}

std::vector<Vec3> cutting_axes(std::span<const VerifyProgram> programs, const Progress& progress) {
    std::vector<Vec3> axes;
    double merged = radians(axis_degrees);
    const auto add = [&](const Vec3& axis) {
        const double near = std::cos(merged);
        for (const Vec3& a : axes)
            if (a == axis || a.dot(axis) > near) return;
        axes.push_back(axis);
        if (axes.size() <= max_axes) return;
        merged *= 2;
        std::vector<Vec3> all;
        all.swap(axes);
        for (const Vec3& a : all)
            if (std::none_of(axes.begin(), axes.end(),
                             [&](const Vec3& b) { return a.dot(b) > std::cos(merged); }))
                axes.push_back(a);
    };
    for (const VerifyProgram& program : programs) {
        const auto& motions = program.motions->motions;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            if (i % 4096 == 0) progress.check();
            if (motions[i].kind == MotionKind::rapid) continue;
            const CutterLocation &to = motions[i].to, &from = motions[i > 0 ? i - 1 : 0].to;
            if (i > 0 && from.axis != to.axis) {
                const double angle = angle_between(from.axis, to.axis);
                const int pieces = int(std::ceil(angle / merged));
                for (int k = 0; k < pieces; ++k)
                    add(location_between(from, to, program.turning, double(k) / pieces).axis);
            }
            add(to.axis);
        }
    }
    return axes;
}

std::vector<Vec3> looking_axes(std::span<const VerifyProgram> programs, const Progress& progress) {
    std::vector<VerifyProgram> turning;
    for (const VerifyProgram& program : programs)
        if (!program.seen_along) turning.push_back(program);
    std::vector<Vec3> axes = cutting_axes(turning, progress);
    const double near = std::cos(radians(axis_degrees));
    for (const VerifyProgram& program : programs)
        if (program.seen_along && std::none_of(axes.begin(), axes.end(), [&](const Vec3& a) {
                return a.dot(*program.seen_along) > near;
            }))
            axes.push_back(*program.seen_along);
    return axes;
}

namespace {

/// How far beside a wall its line of sight runs, in radii of the widest cutter.
constexpr double beside_share = 0.02;

double distance_to_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 route = b - a;
    const double square = route.squaredNorm();
    const double t = square > 0 ? std::clamp((p - a).dot(route) / square, 0.0, 1.0) : 0.0;
    return (p - a - t * route).norm();
}

} // namespace

void flag_samples(SurfaceSamples& s, const Mesh& part, const MeshSight& sight, double cutter_radius,
                  const std::vector<Vec3>& axes, const Progress& progress) {
    const auto& open = s.open_edges;
    std::vector<Box3> boxes(open.size());
    for (std::size_t i = 0; i < open.size(); ++i)
        for (Index v : open[i])
            boxes[i].add(part.vertices[v]);
    const BoxTree tree(std::move(boxes), progress);
    const auto seen_along = [&](std::size_t i, const Vec3& axis) {
        return axis.dot(s.normals[i]) > tolerance::vertical_normal_z && sight.is_free(s.places[i], axis);
    };
    // Beside the wall, so that one that is a little out of true does not stand in its own way.
    const double beside = beside_share * cutter_radius;
    const auto passed_along = [&](std::size_t i, const Vec3& axis) {
        return axis.dot(s.normals[i]) >= -tolerance::vertical_normal_z
               && sight.is_free(s.places[i] + beside * s.normals[i], axis);
    };
    parallel_for(s.points.size(), samples_per_block, progress, [&](std::size_t i) {
        double steepest = -1;
        const Vec3* best = nullptr;
        for (const Vec3& a : axes)
            if (const double along = a.dot(s.normals[i]); along > steepest) {
                steepest = along;
                best = &a;
            }
        s.slopes[i] = std::acos(std::clamp(steepest, -1.0, 1.0));
        if (steepest <= tolerance::vertical_normal_z) {
            s.flags[i] |= DeviationSurface::away;
            s.upright[i] =
                std::any_of(axes.begin(), axes.end(), [&](const Vec3& a) { return passed_along(i, a); });
        } else if (!seen_along(i, *best)
                   && std::none_of(axes.begin(), axes.end(), [&](const Vec3& a) { return seen_along(i, a); }))
            s.flags[i] |= DeviationSurface::hidden;
        const Vec3& p = s.points[i];
        bool near = false;
        tree.each(
            [&](const Box3& box) {
                return !near
                       && (p - p.cwiseMax(box.lo).cwiseMin(box.hi)).squaredNorm()
                              < cutter_radius * cutter_radius;
            },
            [&](std::size_t e) {
                near = near
                       || distance_to_edge(p, part.vertices[open[e][0]], part.vertices[open[e][1]])
                              < cutter_radius;
            });
        if (near) s.flags[i] |= DeviationSurface::border;
    });
}

// ---- StockExit ----

struct StockExit::Facets {
    BoxTree tree;
    double outward = 1; ///< -1: the facets are wound the other way
};

StockExit::StockExit(const StockSolid& stock, const Progress& progress) : stock_(stock) {
    if (stock.kind != StockSolid::Kind::mesh) return;
    auto facets = std::make_unique<Facets>();
    std::vector<Box3> boxes(stock.mesh->facet_count());
    double volume = 0;
    const Vec3 middle = stock.box.center();
    for (std::size_t f = 0; f < boxes.size(); ++f) {
        for (int k = 0; k < 3; ++k)
            boxes[f].add(stock.mesh->corner(f, k));
        volume += (stock.mesh->corner(f, 0) - middle).dot(stock.mesh->facet_cross(f));
    }
    facets->outward = volume < 0 ? -1 : 1;
    facets->tree = BoxTree(std::move(boxes), progress);
    facets_ = std::move(facets);
}

StockExit::~StockExit() = default;

double StockExit::operator()(const Vec3& p, const Vec3& n) const {
    switch (stock_.kind) {
    case StockSolid::Kind::box:
        return of_box(p, n);
    case StockSolid::Kind::cylinder:
        return of_cylinder(p, n);
    case StockSolid::Kind::mesh:
        return of_mesh(p, n);
    }
    return -1;
}

double StockExit::of_box(const Vec3& p, const Vec3& n) const {
    double exit = infinity;
    for (int k = 0; k < 3; ++k) {
        const double below = p[k] - stock_.box.lo[k], above = stock_.box.hi[k] - p[k];
        if (below < -tolerance::contact_distance || above < -tolerance::contact_distance) return -1;
        if (n[k] > 0) exit = std::min(exit, std::max(above, 0.0) / n[k]);
        if (n[k] < 0) exit = std::min(exit, std::max(below, 0.0) / -n[k]);
    }
    return exit;
}

double StockExit::of_cylinder(const Vec3& p, const Vec3& n) const {
    const double ends = of_box(p, n);
    if (ends < 0) return ends;
    Vec3 q = p - stock_.box.center(), u = n;
    q[stock_.axis] = u[stock_.axis] = 0;
    const double c = (q.norm() - stock_.radius) * (q.norm() + stock_.radius);
    if (q.norm() - stock_.radius > tolerance::contact_distance) return -1;
    const double a = u.squaredNorm(), b = q.dot(u);
    if (!(a > 0)) return ends;
    return std::min(ends, std::max(0.0, (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a));
}

double StockExit::of_mesh(const Vec3& p, const Vec3& n) const {
    // The nearest crossing ahead leaves the stock, or p is outside.
    const Mesh& mesh = *stock_.mesh;
    double nearest = infinity, facing = 0;
    facets_->tree.each(
        [&](const Box3& box) {
            double from = -tolerance::contact_distance, to = nearest;
            for (int k = 0; k < 3; ++k) {
                const double a = box.lo[k] - tolerance::contact_distance - p[k],
                             b = box.hi[k] + tolerance::contact_distance - p[k];
                if (n[k] == 0) {
                    if (a > 0 || b < 0) return false;
                } else {
                    from = std::max(from, std::min(a / n[k], b / n[k]));
                    to = std::min(to, std::max(a / n[k], b / n[k]));
                }
            }
            return from <= to;
        },
        [&](std::size_t f) {
            const Vec3 &a = mesh.corner(f, 0), e1 = mesh.corner(f, 1) - a, e2 = mesh.corner(f, 2) - a;
            const Vec3 across = e1.cross(e2), from = p - a;
            const double steep = across.dot(n);
            if (steep == 0) return;
            const double t = -across.dot(from) / steep;
            if (t < -tolerance::contact_distance || t > nearest) return;
            // Shares of the corners; a line through an edge meets both facets, which face alike or are passed
            // by.
            const Vec3 at = from + t * n;
            const double square = across.squaredNorm();
            const double v = across.dot(at.cross(e2)) / square, w = across.dot(e1.cross(at)) / square;
            const double rim = -tolerance::unit_rounding * 100;
            if (v < rim || w < rim || v + w > 1 - rim) return;
            nearest = t;
            facing = steep * facets_->outward;
        });
    return facing > 0 ? std::max(nearest, 0.0) : -1;
}

} // namespace facetmill
