#include "core/setup/lying.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/base/turn.h"
#include "core/mesh/convex_hull.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>
#include <map>

namespace facetmill {

namespace {

constexpr double noticeable_move = 5e-4; // mm

/// Share of the part's box that a face may be uneven and still be one face, and the cosine and sine of what
/// its normals may differ by: a scanned or milled plane is one.
constexpr double uneven_share = 2e-4, even_cosine = 0.9998, even_sine = 0.02;
/// Hull faces that are looked at closely, the largest first.
constexpr std::size_t max_looked_at = 200;
/// What the worth of a face is told in: smaller differences are none.
constexpr double worth_step = 1e-4;
/// A part that falls at this angle or more stands firmly; one that falls at once is worth so much less, as a
/// share of the surface.
constexpr double firm_angle = 20 * (pi / 180), firmness_worth = 0.2;
/// Share of the hull that a closed part fills at least; what is less has no inside to speak of.
constexpr double min_filling = 0.02;

Eigen::Matrix<double, 2, 3> plane_axes(const Vec3& normal) {
    const Vec3 u = normal.unitOrthogonal();
    Eigen::Matrix<double, 2, 3> axes;
    axes.row(0) = u;
    axes.row(1) = normal.cross(u);
    return axes;
}

/// Centre and volume of what facets enclose, about a point near them.
struct Mass {
    Vec3 center = Vec3::Zero();
    double volume = 0;
};

template <class Corner>
Mass mass_of(const std::vector<Facet>& facets, const Vec3& about, Corner&& corner) {
    Mass m;
    for (const Facet& f : facets) {
        const Vec3 a = corner(f[0]) - about, b = corner(f[1]) - about, c = corner(f[2]) - about;
        const double six = a.dot(b.cross(c));
        m.volume += six / 6;
        m.center += six / 24 * (a + b + c);
    }
    m.center = m.volume != 0 ? Vec3(about + m.center / m.volume) : about;
    return m;
}

/// A face of the hull with its outline.
LyingFace face_of(const std::vector<Vec3>& corners, const Vec3& down) {
    LyingFace face;
    face.down = down;
    const auto axes = plane_axes(down);
    std::vector<Vec2> flat;
    for (const Vec3& p : corners)
        flat.push_back(axes * p);
    const std::vector<Index> ring = convex_outline(flat);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 p = flat[ring[i]] - flat[ring[0]], q = flat[ring[(i + 1) % ring.size()]] - flat[ring[0]];
        face.support_area += 0.5 * (p.x() * q.y() - p.y() * q.x());
        face.outline.push_back(corners[ring[i]]);
    }
    return face;
}

/// Facets of a hull that lie in one plane as one face, the largest facets first.
class HullFaces {
public:
    HullFaces(const std::vector<Vec3>& points, const ConvexHull& hull, double slack)
        : points_(points), facets_(hull.facets), slack_(slack), taken_(hull.facets.size(), false) {
        std::map<std::pair<Index, Index>, Index> by_side;
        for (std::size_t f = 0; f < facets_.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k)
                by_side[{facets_[f][k], facets_[f][(k + 1) % 3]}] = Index(f);
        across_.resize(facets_.size());
        for (std::size_t f = 0; f < facets_.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto other = by_side.find({facets_[f][(k + 1) % 3], facets_[f][k]});
                across_[f][k] = other == by_side.end() ? no_index : other->second;
            }
    }

    std::vector<LyingFace> all(const Progress& progress) {
        std::vector<std::pair<double, Index>> order;
        for (std::size_t f = 0; f < facets_.size(); ++f)
            order.emplace_back(-cross(f).norm(), Index(f));
        std::sort(order.begin(), order.end());
        std::vector<LyingFace> faces;
        for (const auto& [area, f] : order) {
            if (taken_[f] || area == 0) continue;
            if (faces.size() % 256 == 0) progress.check();
            faces.push_back(grow(f));
        }
        return faces;
    }

private:
    Vec3 cross(std::size_t f) const {
        const Vec3& a = points_[facets_[f][0]];
        return (points_[facets_[f][1]] - a).cross(points_[facets_[f][2]] - a);
    }

    LyingFace grow(Index seed) {
        const Vec3 normal = cross(seed).normalized();
        const double offset = normal.dot(points_[facets_[seed][0]]);
        std::vector<Index> group{seed};
        taken_[seed] = true;
        Vec3 sum = Vec3::Zero();
        std::vector<Index> corners;
        for (std::size_t i = 0; i < group.size(); ++i) {
            const Index f = group[i];
            sum += cross(f);
            corners.insert(corners.end(), facets_[f].begin(), facets_[f].end());
            for (const Index next : across_[f]) {
                if (next == no_index || taken_[next]) continue;
                const Vec3 n = cross(next);
                bool in = n.dot(normal) >= 0; // a sliver may lean any way
                for (const Index v : facets_[next])
                    in = in && std::abs(normal.dot(points_[v]) - offset) <= slack_;
                if (!in) continue;
                taken_[next] = true;
                group.push_back(next);
            }
        }
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        std::vector<Vec3> places;
        for (const Index v : corners)
            places.push_back(points_[v]);
        return face_of(places, sum.normalized());
    }

    const std::vector<Vec3>& points_;
    const std::vector<Facet>& facets_;
    const double slack_;
    std::vector<bool> taken_;
    std::vector<std::array<Index, 3>> across_;
};

/// How far the foot of the centre of mass is inside the outline, as the angle to tilt.
double tilt_to_fall(const LyingFace& face, const Vec3& center) {
    double inside = infinity;
    for (std::size_t i = 0; i < face.outline.size(); ++i) {
        const Vec3 &a = face.outline[i], &b = face.outline[(i + 1) % face.outline.size()];
        const Vec3 inward = face.down.cross(b - a).normalized();
        inside = std::min(inside, inward.dot(center - a));
    }
    const double high = face.down.dot(face.outline.front() - center);
    return std::atan2(inside, std::max(high, 0.0));
}

/// What touches the table and what faces it.
void measure(LyingFace& face, const Mesh& mesh, const std::vector<Vec3>& hull, double slack,
             const Progress& progress) {
    double low = -infinity, high = infinity;
    for (const Vec3& p : hull) {
        low = std::max(low, face.down.dot(p));
        high = std::min(high, face.down.dot(p));
    }
    face.height = low - high;
    double all = 0, over = 0;
    constexpr std::size_t facets_between_checks = 1 << 16;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % facets_between_checks == 0) progress.check();
        const Vec3 cross = 0.5 * mesh.facet_cross(f);
        const double area = cross.norm(), toward = face.down.dot(cross);
        all += area;
        bool touches = std::abs(toward) >= even_cosine * area;
        for (int k = 0; k < 3 && touches; ++k)
            touches = low - face.down.dot(mesh.corner(f, k)) <= slack;
        if (touches)
            face.contact_area += area;
        else if (toward > tolerance::vertical_normal_z * area)
            over += area;
    }
    face.facing_down = all > 0 ? over / all : 0;
}

void sort_faces(std::vector<LyingFace>& faces, LyingOrder order, double surface) {
    const auto steps = [](double share) { return std::round(share / worth_step); };
    const auto key = [&](const LyingFace& f) {
        // Of faces alike that which lies downward already, then the flattest part.
        const double contact = steps(f.contact_area / surface), support = steps(f.support_area / surface),
                     upward = steps(f.down.z()), height = steps(f.height / std::sqrt(surface));
        const double firm = std::min(f.tips_at / firm_angle, 1.0);
        const double worth = steps(f.facing_down - f.contact_area / surface - firmness_worth * firm);
        return order == LyingOrder::largest ? std::array{-contact, -support, worth, height, upward}
                                            : std::array{worth, -contact, -support, height, upward};
    };
    std::stable_sort(faces.begin(), faces.end(),
                     [&](const LyingFace& a, const LyingFace& b) { return key(a) < key(b); });
}

/// Facets between two looks at a Progress.
constexpr std::size_t facets_a_look = 1 << 16;

std::vector<Vec3> points_of(const Mesh& mesh, const Progress& progress) {
    std::vector<bool> used(mesh.vertices.size(), false);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % facets_a_look == 0) progress.check();
        for (const Index v : mesh.facets[f])
            used[v] = true;
    }
    std::vector<Vec3> points;
    for (std::size_t v = 0; v < used.size(); ++v)
        if (used[v]) points.push_back(mesh.vertices[v]);
    return points;
}

/// The faces that a part can lie on, without what they touch, and the points of its hull.
std::vector<LyingFace> stable_faces(const Mesh& mesh, double slack, std::vector<Vec3>& corners,
                                    const Progress& progress) {
    const std::vector<Vec3> points = points_of(mesh, progress);
    const ConvexHull hull = convex_hull(points, progress);
    if (hull.dimension < 2)
        throw Error(ErrorCode::empty_result, "part", "its points lie on a line: there is no face to lie on",
                    "check the mesh");
    std::vector<LyingFace> faces;
    if (hull.dimension == 2) {
        for (const Index v : hull.outline)
            corners.push_back(points[v]);
        for (const Vec3& down : {hull.normal, Vec3(-hull.normal)}) {
            faces.push_back(face_of(corners, down));
            faces.back().tips_at = 0.5 * pi;
        }
        return faces;
    }
    std::vector<bool> used(points.size(), false);
    for (const Facet& f : hull.facets)
        for (const Index v : f)
            used[v] = true;
    for (std::size_t v = 0; v < points.size(); ++v)
        if (used[v]) corners.push_back(points[v]);
    const Vec3 middle = mesh.box().center();
    const Mass body = mass_of(hull.facets, middle, [&](Index v) { return points[v]; });
    const Mass part = mass_of(mesh.facets, middle, [&](Index v) { return mesh.vertices[v]; });
    Vec3 center = body.center;
    if (part.volume > min_filling * body.volume && part.volume <= body.volume) center = part.center;
    LyingFace upmost;
    upmost.tips_at = -infinity;
    for (LyingFace& face : HullFaces(points, hull, slack).all(progress)) {
        if (face.outline.size() < 3) continue;
        face.tips_at = tilt_to_fall(face, center);
        if (face.tips_at > upmost.tips_at) upmost = face;
        if (face.tips_at > 0) faces.push_back(std::move(face));
    }
    if (faces.empty() && !upmost.outline.empty()) faces.push_back(upmost);
    std::stable_sort(faces.begin(), faces.end(),
                     [](const LyingFace& a, const LyingFace& b) { return a.support_area > b.support_area; });
    return faces;
}

/// The least turn about Z that lays a line along X, either way round; in (-pi/2, pi/2].
double angle_to_x(const Vec2& line) {
    double angle = -std::atan2(line.y(), line.x());
    if (angle > 0.5 * pi) angle -= pi;
    if (angle <= -0.5 * pi) angle += pi;
    return angle;
}

} // namespace

std::vector<LyingFace> lying_faces(const Mesh& mesh, LyingOrder order, const Progress& progress) {
    const double slack = uneven_share * mesh.box().diagonal();
    std::vector<Vec3> corners;
    std::vector<LyingFace> faces =
        stable_faces(mesh, slack, corners, progress.part(0, 0.6, "Looking for faces to lie on"));
    faces.resize(std::min(faces.size(), max_looked_at));
    const Progress measuring = progress.part(0.6, 1);
    parallel_for(faces.size(), 1, measuring,
                 [&](std::size_t i) { measure(faces[i], mesh, corners, slack, measuring); });
    double surface = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        surface += 0.5 * mesh.facet_cross(f).norm();
    if (surface > 0) sort_faces(faces, order, surface);
    faces.resize(std::min(faces.size(), max_lying_faces));
    return faces;
}

Mat3 turn_to_lie(const Vec3& down) {
    const Vec3 floor = -Vec3::UnitZ();
    if ((down - floor).norm() < tolerance::level_angle) return Mat3::Identity();
    if ((down + floor).norm() < tolerance::level_angle) return quarter_turn(0, 2);
    return turn_between(down, floor).toRotationMatrix();
}

Mat3 quarter_turn(int axis, int quarters) {
    constexpr double sines[] = {0, 1, 0, -1};
    const int k = ((quarters % 4) + 4) % 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double s = sines[k], c = sines[(k + 1) % 4];
    Mat3 m = Mat3::Identity();
    m(u, u) = m(v, v) = c;
    m(u, v) = -s;
    m(v, u) = s;
    return m;
}

Mat3 turn_along_x(const Vec3& edge) {
    const double level = edge.head<2>().norm();
    if (!(level > even_sine * edge.norm()))
        throw Error(ErrorCode::out_of_range, "edge", "it stands upright: no turn about Z lays it along X",
                    "pick another edge, or lay the part first");
    return Eigen::AngleAxisd(angle_to_x(edge.head<2>()), Vec3::UnitZ()).toRotationMatrix();
}

Vec3 down_through(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& middle) {
    const Vec3 n = (b - a).cross(c - a);
    const double longest = std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
    if (!(n.norm() > even_sine * longest * longest))
        throw Error(ErrorCode::out_of_range, "points",
                    "they lie nearly on a line: no plane goes through them",
                    "pick three points that are farther apart");
    const Vec3 unit = n.normalized();
    const double above = unit.dot(a - middle);
    if (std::abs(above) < tolerance::level_angle * longest)
        throw Error(ErrorCode::out_of_range, "points",
                    "their plane goes through the middle of the part: there is no side to lie on",
                    "pick points of one side");
    return above > 0 ? unit : Vec3(-unit);
}

Mat3 turn_to_square(const Mesh& mesh, const Progress& progress) {
    std::vector<Vec2> seen;
    for (const Vec3& p : points_of(mesh, progress))
        seen.emplace_back(p.head<2>());
    progress.check();
    const std::vector<Index> ring = convex_outline(seen);
    double best = infinity, angle = 0;
    // The smallest rectangle has a side on one of the outline's.
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 side = seen[ring[(i + 1) % ring.size()]] - seen[ring[i]];
        if (!(side.norm() > 0)) continue;
        const Vec2 u = side.normalized(), v(-u.y(), u.x());
        Vec2 lo = Vec2::Constant(infinity), hi = -lo;
        for (const Index p : ring) {
            const Vec2 at(u.dot(seen[p]), v.dot(seen[p]));
            lo = lo.cwiseMin(at);
            hi = hi.cwiseMax(at);
        }
        const Vec2 size = hi - lo, along = size.x() >= size.y() ? u : v;
        const double turn = angle_to_x(along);
        const double area = size.x() * size.y(), slack = tolerance::figure_rounding * area;
        if (area < best - slack || (area < best + slack && std::abs(turn) < std::abs(angle))) {
            best = std::min(area, best);
            angle = turn;
        }
    }
    return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
}

namespace {

/// Second moments of a surface about its middle, by area. A triangle's are those of its corners and its
/// middle.
Mat3 surface_moments(const Mesh& mesh, const Progress& progress) {
    Vec3 sum = Vec3::Zero();
    double area = 0;
    const auto weight = [&](std::size_t f) { return 0.5 * mesh.facet_cross(f).norm(); };
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % facets_a_look == 0) progress.check();
        area += weight(f);
        sum += weight(f) * (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
    }
    if (!(area > 0)) return Mat3::Zero();
    const Vec3 middle = sum / area;
    Mat3 moments = Mat3::Zero();
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % facets_a_look == 0) progress.check();
        Vec3 all = Vec3::Zero();
        Mat3 own = Mat3::Zero();
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = mesh.corner(f, k) - middle;
            all += p;
            own += p * p.transpose();
        }
        moments += weight(f) / 12 * (own + all * all.transpose());
    }
    return moments / area;
}

/// The smallest turn that brings a direction, either way, along a coordinate axis.
Mat3 turn_along(const Vec3& direction, int axis) {
    const Vec3 to = Vec3::Unit(axis);
    return turn_between(direction.dot(to) < 0 ? Vec3(-direction) : direction, to).toRotationMatrix();
}

} // namespace

Mat3 turn_to_principal(const Mesh& mesh, const Progress& progress) {
    constexpr double alike = 1e-3; // of the largest moment
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(surface_moments(mesh, progress));
    const Vec3& moments = solver.eigenvalues(); // ascending
    const Mat3& axes = solver.eigenvectors();
    const bool short_two = moments[1] - moments[0] <= alike * moments[2],
               long_two = moments[2] - moments[1] <= alike * moments[2];
    if (short_two && long_two)
        throw Error(ErrorCode::out_of_range, "part",
                    "it is alike in all directions and has no principal axes",
                    "lay it on a face, or turn it by an angle");
    if (short_two) return turn_along(axes.col(2), 0);
    if (long_two) return turn_along(axes.col(0), 2);
    Mat3 best = Mat3::Identity();
    double largest = -infinity;
    for (const int x : {-1, 1})
        for (const int z : {-1, 1}) {
            Mat3 turn;
            turn.row(0) = x * axes.col(2).transpose();
            turn.row(2) = z * axes.col(0).transpose();
            turn.row(1) = turn.row(2).cross(turn.row(0));
            if (turn.trace() <= largest) continue;
            largest = turn.trace();
            best = turn;
        }
    return best;
}

Box3 turned_box(const Mesh& mesh, const Mat3& turn, const Progress& progress) {
    Box3 box;
    for (const Vec3& p : points_of(mesh, progress))
        box.add(turn * p);
    return box;
}

Placement laid(const Placement& placement, const Mesh& mesh, const Mat3& given, const Progress& progress) {
    const Box3 before = mesh.box();
    Placement after = turned(placement, given, Vec3::Zero());
    // Normals of facets are as good as the numbers of their file: angles that are whole degrees but for what
    // moves no point noticeably are whole degrees.
    const double reach = 0.5 * before.size().norm();
    for (double& angle : after.rotate)
        if (const double whole = radians(std::round(degrees(angle)));
            std::abs(angle - whole) * reach < noticeable_move)
            angle = whole + 0.0;
    const Mat3 turn = rotation_of(after.rotate) * rotation_of(placement.rotate).transpose();
    after.translate = turned(placement, turn, Vec3::Zero()).translate;
    const Box3 box = turned_box(mesh, turn, progress);
    return moved(after, Vec3(before.center().x() - box.center().x(), before.center().y() - box.center().y(),
                             -box.lo.z()));
}

} // namespace facetmill
