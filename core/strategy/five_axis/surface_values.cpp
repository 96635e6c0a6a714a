#include "core/strategy/five_axis/surface_values.h"

#include "core/mesh/edge_table.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// Of two that pull at a vertex none pulls less than this: facets with obtuse corners would push.
constexpr double min_pull = 1e-4;
/// The solver stops at this share of the residual it began with, or after so many rounds.
constexpr double solved_share = 1e-9;
constexpr int max_rounds = 5000;
/// Pieces of a value's range that are stretched each by itself.
constexpr int stretch_pieces = 64;

double cotangent_across(const Mesh& mesh, std::size_t side) {
    const Vec3& p = mesh.vertices[side_across(mesh, side)];
    const Vec3 a = mesh.vertices[side_start(mesh, side)] - p, b = mesh.vertices[side_end(mesh, side)] - p;
    const double twice_area = a.cross(b).norm();
    return twice_area > 0 ? a.dot(b) / twice_area : 0;
}

} // namespace

PieceEdges piece_edges(const Mesh& mesh, const Progress& progress) {
    PieceEdges found;
    const EdgeTable edges(mesh, progress);
    found.next.assign(mesh.vertices.size(), {});
    for (std::size_t low = 0; low < edges.vertex_count(); ++low) {
        if (low % 1024 == 0) progress.check();
        edges.for_edges(low, [&](Index high, std::span<const EdgeSide> sides) {
            double weight = 0;
            for (const EdgeSide& side : sides)
                weight += 0.5 * cotangent_across(mesh, side.side);
            found.pulls.push_back({Index(low), high, std::max(weight, min_pull)});
            if (sides.size() == 1)
                found.next[side_start(mesh, sides[0].side)].push_back(side_end(mesh, sides[0].side));
        });
    }
    return found;
}

std::vector<std::vector<Index>> border_of(const PieceEdges& edges) {
    std::vector<std::vector<Index>> next = edges.next, loops;
    for (std::size_t start = 0; start < next.size(); ++start)
        while (!next[start].empty()) {
            std::vector<Index> loop;
            auto at = Index(start);
            while (!next[at].empty()) {
                loop.push_back(at);
                const Index to = next[at].back();
                next[at].pop_back();
                at = to;
                if (at == Index(start)) break;
            }
            loops.push_back(std::move(loop));
        }
    return loops;
}

void solve_harmonic(const std::vector<Pull>& pulls, const std::vector<double>& fixed,
                    std::vector<double>& value, const Progress& progress) {
    const std::size_t n = value.size();
    std::vector<double> diagonal(n, 0), residual(n), step(n, 0), scaled(n), pulled(n);
    for (const Pull& p : pulls) {
        diagonal[p.a] += p.weight;
        diagonal[p.b] += p.weight;
    }
    std::vector<char> is_free(n);
    for (std::size_t i = 0; i < n; ++i) {
        is_free[i] = std::isnan(fixed[i]) && diagonal[i] > 0;
        if (!std::isnan(fixed[i])) value[i] = fixed[i];
    }
    const auto pull_at = [&](const std::vector<double>& x, double jumps, std::vector<double>& sum) {
        std::fill(sum.begin(), sum.end(), 0.0);
        for (const Pull& p : pulls) {
            const double d = p.weight * (x[p.a] - x[p.b] - jumps * p.jump);
            sum[p.a] += d;
            sum[p.b] -= d;
        }
        for (std::size_t i = 0; i < n; ++i)
            if (!is_free[i]) sum[i] = 0;
    };
    const auto product = [n](const std::vector<double>& x, const std::vector<double>& y) {
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i)
            sum += x[i] * y[i];
        return sum;
    };
    const auto scale = [&] {
        for (std::size_t i = 0; i < n; ++i)
            scaled[i] = is_free[i] ? residual[i] / diagonal[i] : 0;
    };
    pull_at(value, 1, residual);
    for (double& r : residual)
        r = -r;
    scale();
    step = scaled;
    double energy = product(residual, scaled);
    const double enough = solved_share * solved_share * energy;
    for (int round = 0; round < max_rounds && energy > enough; ++round) {
        progress.check();
        pull_at(step, 0, pulled);
        const double stiff = product(step, pulled);
        if (!(stiff > 0)) break;
        const double go = energy / stiff;
        for (std::size_t i = 0; i < n; ++i) {
            value[i] += go * step[i];
            residual[i] -= go * pulled[i];
        }
        scale();
        const double next = product(residual, scaled);
        const double keep = next / energy;
        energy = next;
        for (std::size_t i = 0; i < n; ++i)
            step[i] = scaled[i] + keep * step[i];
    }
}

Vec3 value_gradient(const Mesh& mesh, std::size_t facet, const std::vector<double>& value, double period) {
    const Vec3 cross = mesh.facet_cross(facet);
    const double square = cross.squaredNorm();
    if (!(square > 0)) return Vec3::Zero();
    const double first = value[mesh.facets[facet][0]];
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        double at = value[mesh.facets[facet][std::size_t(k)]];
        if (period > 0) at = std::remainder(at - first, period);
        sum += at * cross.cross(mesh.corner(facet, (k + 2) % 3) - mesh.corner(facet, (k + 1) % 3));
    }
    return sum / square;
}

double steepness_at(const Mesh& mesh, const std::vector<Index>& facets, const std::vector<double>& value,
                    double share, double period) {
    std::vector<std::pair<double, double>> all;
    double area = 0, sum = 0;
    for (const Index f : facets) {
        all.emplace_back(value_gradient(mesh, f, value, period).norm(), mesh.facet_cross(f).norm());
        area += all.back().second;
    }
    std::sort(all.begin(), all.end());
    for (const auto& [steepness, own] : all) {
        sum += own;
        if (sum >= share * area) return steepness;
    }
    return all.empty() ? 0 : all.back().first;
}

void stretch_value(const Mesh& mesh, const std::vector<Index>& facets, std::vector<double>& value,
                   const std::vector<Index>& vertices) {
    double lo = infinity, hi = -infinity;
    for (const Index i : vertices) {
        lo = std::min(lo, value[i]);
        hi = std::max(hi, value[i]);
    }
    if (!(hi > lo)) return;
    std::array<double, stretch_pieces> steepness{}, area{};
    const auto piece_of = [&](double x) {
        return std::size_t(std::clamp((x - lo) / (hi - lo) * stretch_pieces, 0.0, stretch_pieces - 1.0));
    };
    for (const Index f : facets) {
        const Facet& c = mesh.facets[f];
        const std::size_t k = piece_of((value[c[0]] + value[c[1]] + value[c[2]]) / 3);
        const double own = mesh.facet_cross(f).norm();
        area[k] += own;
        steepness[k] += own * value_gradient(mesh, f, value).norm();
    }
    std::array<double, stretch_pieces + 1> at{};
    double last = 1;
    for (std::size_t k = 0; k < stretch_pieces; ++k) {
        if (steepness[k] > 0) last = steepness[k] / area[k];
        at[k + 1] = at[k] + (hi - lo) / stretch_pieces / last;
    }
    for (const Index i : vertices) {
        const std::size_t k = piece_of(value[i]);
        const double share = (value[i] - lo) / (hi - lo) * stretch_pieces - double(k);
        value[i] = at[k] + share * (at[k + 1] - at[k]);
    }
    const double most = steepness_at(mesh, facets, value, 1 - left_out_share);
    if (!(most > 0)) return;
    for (const Index i : vertices)
        value[i] /= most;
}

} // namespace facetmill
