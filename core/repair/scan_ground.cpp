#include "core/base/parallel.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/geometry_incidence.h"
#include "core/mesh/triangle_distance.h"
#include "core/repair/join.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace facetmill::detail {

namespace {

/// Vertices that the fit asks at most, and rounds.
constexpr std::size_t max_fit_places = 20000;
constexpr int max_fit_rounds = 40;
/// Places farther off than this many times the median say nothing: there the scans differ.
constexpr double far_from_median = 4;
/// Share of the trace that keeps a fit from sliding along what does not hold it.
constexpr double held_share = 1e-7;

struct FitPlace {
    Vec3 at, nearest, normal;
    double off = 0; ///< along the normal
    bool counts = false;
};

std::vector<Vec3> summed_normals(const Mesh& mesh) {
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        for (const Index v : mesh.facets[f])
            normals[v] += mesh.facet_cross(f);
    return normals;
}

/// The small turn about `center` and the move that take the places nearest to their planes; false where there
/// are too few.
bool best_move(const std::vector<FitPlace>& places, const Vec3& center, double size, Mat3& turn, Vec3& move) {
    std::vector<double> offs;
    for (const FitPlace& p : places)
        if (p.counts) offs.push_back(std::abs(p.off));
    constexpr std::size_t fewest = 12;
    if (offs.size() < fewest) return false;
    std::nth_element(offs.begin(), offs.begin() + std::ptrdiff_t(offs.size() / 2), offs.end());
    const double most = far_from_median * offs[offs.size() / 2] + 1e-12 * size;
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (const FitPlace& p : places) {
        if (!p.counts || std::abs(p.off) > most) continue;
        Eigen::Matrix<double, 6, 1> row;
        row << ((p.at - center) / size).cross(p.normal), p.normal;
        sum += row * row.transpose();
        right -= p.off * row;
    }
    sum.diagonal().array() += held_share * sum.trace();
    const Eigen::Matrix<double, 6, 1> x = sum.ldlt().solve(right);
    if (!x.allFinite()) return false;
    const Vec3 axis = x.head<3>() / size;
    const double angle = axis.norm();
    turn =
        angle > 0 ? Eigen::AngleAxisd(angle, Vec3(axis / angle)).toRotationMatrix() : Mat3(Mat3::Identity());
    move = x.tail<3>();
    return true;
}

} // namespace

std::vector<Index> border_courses(const Mesh& mesh, std::vector<char>* open_sides, const Progress& progress) {
    const EdgeTable edges(mesh, progress);
    std::vector<Index> next(mesh.vertices.size(), no_index);
    std::vector<char> meets(mesh.vertices.size(), 0);
    if (open_sides) open_sides->assign(mesh.facet_count(), 0);
    for (std::size_t low = 0; low < edges.vertex_count(); ++low) {
        if (low % 65536 == 0) progress.check();
        edges.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
            if (sides.size() != 1) return;
            const EdgeSide side = sides.front();
            if (open_sides) (*open_sides)[side.facet()] |= char(1 << side.corner());
            // In the hole the border runs against the facet.
            const Index from = side_end(mesh, side.side), to = side_start(mesh, side.side);
            if (next[from] != no_index) meets[from] = 1;
            next[from] = to;
        });
    }
    for (std::size_t v = 0; v < next.size(); ++v)
        if (meets[v]) next[v] = no_index;
    return next;
}

ScanGround::ScanGround(const Mesh& mesh, double reach, const Progress& progress)
    : mesh_(mesh), reach_(reach), index_(mesh, progress.part(0, 0.6), reach),
      next_(border_courses(mesh, &open_sides_, progress.part(0.6, 1))) {}

DeviationIndex::Place ScanGround::place(const Vec3& p, const Vec3& normal) const {
    DeviationIndex::Place found;
    if (!index_.is_within(p, reach_ * reach_)) return found;
    found = index_.place(p);
    const Index f = found.facet;
    if (mesh_.facet_cross(f).dot(normal) <= 0) return {};
    constexpr double on_border = 1e-18; // of the size, squared: rounding alone
    for (int k = 0; k < 3; ++k) {
        if (!(open_sides_[f] & (1 << k))) continue;
        const Vec3 &a = mesh_.corner(f, k), &b = mesh_.corner(f, (k + 1) % 3);
        if (squared_distance(found.nearest, a, b) <= on_border * (a.squaredNorm() + b.squaredNorm()))
            return {};
    }
    return found;
}

double lay_on(const ScanGround& ground, Mesh& scan, const Progress& progress) {
    const std::vector<Vec3> before = scan.vertices, normals = summed_normals(scan);
    const std::size_t step = (scan.vertices.size() - 1) / max_fit_places + 1;
    std::vector<FitPlace> places((scan.vertices.size() - 1) / step + 1);
    const Box3 box = scan.box();
    const double size = std::max(box.diagonal(), 1e-9);
    Mat3 turned = Mat3::Identity();
    Vec3 moved = Vec3::Zero();
    const auto now = [&](const Vec3& p) { return Vec3(turned * (p - box.center()) + box.center() + moved); };
    for (int round = 0; round < max_fit_rounds; ++round) {
        parallel_for(places.size(), 256, progress.part(double(round) / max_fit_rounds, 1),
                     [&](std::size_t i) {
                         const std::size_t v = i * step;
                         const Vec3 at = now(before[v]);
                         const DeviationIndex::Place on = ground.place(at, turned * normals[v]);
                         places[i].counts = on.facet != no_index;
                         if (!places[i].counts) return;
                         const Vec3 normal = ground.normal(on.facet);
                         places[i] = {at, on.nearest, normal, (at - on.nearest).dot(normal), true};
                     });
        Mat3 turn;
        Vec3 move;
        if (!best_move(places, box.center() + moved, size, turn, move)) break;
        turned = turn * turned;
        moved += move;
        constexpr double still = 1e-9;
        if (move.norm() < still * size && (turn - Mat3::Identity()).norm() < still) break;
    }
    double farthest = 0;
    for (std::size_t v = 0; v < before.size(); ++v) {
        scan.vertices[v] = rounded_to_float(now(before[v]));
        farthest = std::max(farthest, (scan.vertices[v] - before[v]).norm());
    }
    return farthest;
}

} // namespace facetmill::detail
