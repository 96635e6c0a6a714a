#include "core/mesh/round_face.h"

#include "core/base/error.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/flat_face.h"
#include "core/mesh/normal_equations.h"
#include "core/mesh/refine.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace facetmill {

namespace {

const double smooth_cosine = std::cos(radians(50)); ///< between neighbours on one wall
const double across_sine = std::sin(radians(10));   ///< that a wall's facets lean from its axis at most
constexpr double round_share = 0.02;                ///< of the radius: root mean square
const double min_around = radians(120);
/// How much more the upper third of a wall may face up than the lower one: what bulges like a ball is no
/// wall.
constexpr double max_bulge = 0.06;

/// Neighbours of facets over their sides.
class Neighbours {
public:
    Neighbours(const Mesh& mesh, const Progress& progress)
        : mesh_(mesh), of_side_(3 * mesh.facet_count(), no_index) {
        const EdgeTable edges(mesh, progress);
        for (std::size_t low = 0; low < edges.vertex_count(); ++low)
            edges.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
                if (sides.size() != 2) return;
                of_side_[sides[0].side] = sides[1].facet();
                of_side_[sides[1].side] = sides[0].facet();
            });
    }
    /// What hangs together with a facet over smooth sides and is wanted; the nearest by steps first, at most
    /// so many.
    template <class Wanted>
    std::vector<Index> grow(Index from, Wanted&& wanted, std::size_t most = std::size_t(-1)) const {
        std::vector<Index> found{from};
        std::set<Index> seen{from};
        for (std::size_t i = 0; i < found.size() && found.size() < most; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const Index next = of_side_[3 * std::size_t(found[i]) + k];
                if (next == no_index || seen.count(next) || !wanted(next)) continue;
                if (mesh_.facet_normal(found[i]).dot(mesh_.facet_normal(next)) < smooth_cosine) continue;
                seen.insert(next);
                found.push_back(next);
            }
        return found;
    }

private:
    const Mesh& mesh_;
    std::vector<Index> of_side_;
};

/// Across the normals of facets; none where they are alike in more than one direction.
std::optional<Vec3> axis_across(const Mesh& mesh, const std::vector<Index>& facets) {
    constexpr double spread = 1e-4;
    Mat3 sum = Mat3::Zero();
    for (const Index f : facets) {
        const Vec3 n = mesh.facet_normal(f);
        sum += mesh.facet_cross(f).norm() * n * n.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(sum);
    const Vec3& values = solver.eigenvalues();
    if (!(values[1] - values[0] > spread * values[2])) return std::nullopt;
    return Vec3(solver.eigenvectors().col(0));
}

std::vector<Vec3> corners_of(const Mesh& mesh, const std::vector<Index>& facets) {
    std::set<Index> corners;
    for (const Index f : facets)
        corners.insert(mesh.facets[f].begin(), mesh.facets[f].end());
    std::vector<Vec3> points;
    points.reserve(corners.size());
    for (const Index v : corners)
        points.push_back(mesh.vertices[v]);
    return points;
}

struct Cylinder {
    Vec3 center = Vec3::Zero(), axis = Vec3::UnitZ();
    double radius = 0;

    double off(const Vec3& p) const { return (p - center).cross(axis).norm() - radius; }
};

/// A circle about an axis by linear least squares (|q|^2 = 2 c q + d).
Cylinder circle_about(const std::vector<Vec3>& points, const Vec3& axis) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : points)
        middle += p / double(points.size());
    const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
    Mat3 normal = Mat3::Zero();
    Vec3 right = Vec3::Zero();
    for (const Vec3& p : points) {
        const Vec3 row(2 * (p - middle).dot(u), 2 * (p - middle).dot(v), 1);
        const double square = row.head<2>().squaredNorm() / 4;
        normal += row * row.transpose();
        right += square * row;
    }
    const Vec3 x = solve_normal_equations(normal, right).x;
    return {middle + x[0] * u + x[1] * v, axis, std::sqrt(std::max(0.0, x[2] + x[0] * x[0] + x[1] * x[1]))};
}

/// The cylinder with the least squares of distances, from one that is near (Gauss-Newton); with `held` its
/// axis stays.
Cylinder fitted(const std::vector<Vec3>& points, Cylinder c, bool held) {
    constexpr int rounds = 12;
    for (int round = 0; round < rounds; ++round) {
        const Vec3 u = c.axis.unitOrthogonal(), v = c.axis.cross(u);
        NormalMatrix normal = NormalMatrix::Zero(5, 5);
        NormalVector right = NormalVector::Zero(5);
        for (const Vec3& p : points) {
            const Vec3 from = p - c.center;
            const double along = from.dot(c.axis);
            const Vec3 out = from - along * c.axis;
            const double length = out.norm();
            if (!(length > 0)) continue;
            const Vec3 n = out / length;
            NormalVector row(5);
            row << -n.dot(u), -n.dot(v), -1, -along * n.dot(u), -along * n.dot(v);
            if (held) row.tail<2>().setZero();
            normal += row * row.transpose();
            right -= (length - c.radius) * row;
        }
        if (held) normal.bottomRightCorner<2, 2>().setIdentity();
        const NormalVector step = solve_normal_equations(normal, right).x;
        if (!step.allFinite()) break;
        c.center += step[0] * u + step[1] * v;
        c.radius += step[2];
        c.axis = (c.axis + step[3] * u + step[4] * v).normalized();
        if (step.norm() < 1e-12 * c.radius) break;
    }
    return c;
}

double angle_around(const std::vector<Vec3>& points, const Cylinder& c) {
    const Vec3 u = c.axis.unitOrthogonal(), v = c.axis.cross(u);
    std::vector<double> angles;
    angles.reserve(points.size());
    for (const Vec3& p : points)
        angles.push_back(std::atan2((p - c.center).dot(v), (p - c.center).dot(u)));
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + 2 * pi - angles.back();
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
        gap = std::max(gap, angles[i + 1] - angles[i]);
    // A gap no wider than a side of an octagon is a side.
    return gap <= radians(50) ? 2 * pi : 2 * pi - gap;
}

/// Round to two hundredths; `uneven` and `around` are told.
bool is_round(const std::vector<Vec3>& points, const Cylinder& c, RoundFace& told) {
    if (points.size() < 5 || !(c.radius > 0) || !std::isfinite(c.radius)) return false;
    double squares = 0;
    told.uneven = 0;
    for (const Vec3& p : points) {
        const double off = c.off(p);
        squares += off * off;
        told.uneven = std::max(told.uneven, std::abs(off));
    }
    told.around = angle_around(points, c);
    return std::sqrt(squares / double(points.size())) <= round_share * c.radius && told.around >= min_around;
}

/// The end of a wall that is told, by height; of a level one that which is nearer to a place.
void choose_end(RoundFace& face, const std::vector<Vec3>& points, const Vec3& near) {
    constexpr double level = 1e-3;
    if (face.axis.z() < 0) face.axis = -face.axis;
    double low = infinity, high = -infinity;
    for (const Vec3& p : points) {
        low = std::min(low, (p - face.center).dot(face.axis));
        high = std::max(high, (p - face.center).dot(face.axis));
    }
    if (face.axis.z() < level) {
        const double at = (near - face.center).dot(face.axis);
        if (at - low < high - at) {
            face.axis = -face.axis;
            std::swap(low, high);
            low = -low;
            high = -high;
        }
    }
    face.center += high * face.axis;
    face.depth = high - low;
}

class WallSearch {
public:
    WallSearch(const Mesh& mesh, Index facet, const Vec3& near, const Progress& progress)
        : mesh_(mesh), facet_(facet), near_(near), progress_(progress), neighbours_(mesh, progress) {}

    std::optional<RoundFace> find() const {
        std::optional<RoundFace> best;
        for (const Vec3& axis : axes()) {
            progress_.check();
            auto wall = wall_about(axis);
            if (wall && (!best || wall->around * wall->depth > best->around * best->depth))
                best = std::move(wall);
        }
        return best;
    }

private:
    /// What the axis may be: across the facet and those about it, near and farther.
    std::vector<Vec3> axes() const {
        std::vector<Vec3> all;
        const Vec3 own = mesh_.facet_normal(facet_);
        const auto any = [](Index) { return true; };
        for (const Index f : neighbours_.grow(facet_, any, 24)) {
            const Vec3 across = own.cross(mesh_.facet_normal(f));
            constexpr double turned = 0.02; // a degree
            if (across.norm() > turned && all.size() < 8) all.push_back(across.normalized());
        }
        for (const std::size_t most : {60U, 240U, 960U, 3840U})
            if (const auto axis = axis_across(mesh_, neighbours_.grow(facet_, any, most)))
                all.push_back(*axis);
        return all;
    }
    std::optional<RoundFace> wall_about(Vec3 axis) const {
        RoundFace face;
        for (int round = 0; round < 3; ++round) {
            face.facets = neighbours_.grow(
                facet_, [&](Index f) { return std::abs(mesh_.facet_normal(f).dot(axis)) < across_sine; });
            const auto again = axis_across(mesh_, face.facets);
            if (!again) return std::nullopt;
            axis = *again;
        }
        const std::vector<Vec3> points = corners_of(mesh_, face.facets);
        const Cylinder c = fitted(points, circle_about(points, axis), false);
        if (!is_round(points, c, face) || bulges(face.facets, c)) return std::nullopt;
        face.center = c.center;
        face.axis = c.axis;
        face.radius = c.radius;
        double facing = 0;
        for (const Index f : face.facets) {
            const Vec3 p = mesh_.corner(f, 0) - c.center;
            facing += mesh_.facet_cross(f).dot(p - p.dot(c.axis) * c.axis);
        }
        face.hole = facing < 0;
        choose_end(face, points, near_);
        if (!(face.depth > 0)) return std::nullopt;
        return face;
    }
    bool bulges(const std::vector<Index>& facets, const Cylinder& c) const {
        double low = infinity, high = -infinity;
        const auto height = [&](Index f) {
            return ((mesh_.corner(f, 0) + mesh_.corner(f, 1) + mesh_.corner(f, 2)) / 3 - c.center)
                .dot(c.axis);
        };
        for (const Index f : facets) {
            low = std::min(low, height(f));
            high = std::max(high, height(f));
        }
        double up[2] = {0, 0}, area[2] = {0, 0};
        for (const Index f : facets) {
            const double share = (height(f) - low) / std::max(high - low, 1e-300);
            const int third = share < 1.0 / 3 ? 0 : share > 2.0 / 3 ? 1 : 2;
            if (third == 2) continue;
            const double a = mesh_.facet_cross(f).norm();
            up[third] += a * mesh_.facet_normal(f).dot(c.axis);
            area[third] += a;
        }
        return area[0] > 0 && area[1] > 0 && std::abs(up[1] / area[1] - up[0] / area[0]) > max_bulge;
    }

    const Mesh& mesh_;
    Index facet_;
    Vec3 near_;
    const Progress& progress_;
    Neighbours neighbours_;
};

std::optional<RoundFace> rim_near(const Mesh& mesh, Index facet, const Vec3& near) {
    RoundFace face;
    face.facets = flat_face(mesh, facet);
    face.axis = mesh.facet_normal(facet);
    if (face.axis == Vec3::Zero()) return std::nullopt;
    const std::vector<std::vector<Vec3>> rims = border_loops(part_of(mesh, face.facets).mesh);
    const auto side = nearest_side(rims, near);
    if (!side) return std::nullopt;
    const std::vector<Vec3>& nearest = rims[side->loop];
    if (nearest.size() < 8) return std::nullopt;
    const Cylinder c = fitted(nearest, circle_about(nearest, face.axis), true);
    if (!is_round(nearest, c, face) || face.around < 2 * pi) return std::nullopt;
    face.center = c.center + (mesh.corner(facet, 0) - c.center).dot(face.axis) * face.axis;
    face.radius = c.radius;
    // Counter-clockwise about the normal it goes round the face, else round what is not there.
    Vec3 turn = Vec3::Zero();
    for (std::size_t i = 0; i < nearest.size(); ++i)
        turn += (nearest[i] - c.center).cross(nearest[(i + 1) % nearest.size()] - c.center);
    face.hole = turn.dot(face.axis) < 0;
    return face;
}

} // namespace

RoundFace round_face(const Mesh& mesh, Index facet, const Vec3& near, const Progress& progress) {
    if (auto wall = WallSearch(mesh, facet, near, progress).find()) return std::move(*wall);
    if (auto rim = rim_near(mesh, facet, near)) return std::move(*rim);
    throw Error(ErrorCode::out_of_range, "part", "there is no round wall or rim",
                "click into a hole, on a boss, or on the flat face beside a hole");
}

} // namespace facetmill
