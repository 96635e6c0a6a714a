#include "core/strategy/global_local/coverage.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/five_axis/posture_path.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace facetmill {

namespace {

/// In radii of the cutter: how far the tool moves at most in one piece of its path, the size of the cells of
/// samples, and what is given away because within a piece places are taken to move straight as the tool sees
/// them.
constexpr double step_share = 0.25, cell_share = 0.25, straight_share = 2e-4;
/// The deepest place of a path through the cutter is looked for so often, each time on two thirds of the
/// rest.
constexpr int deepest_rounds = 24;
/// So much of the cutter above its tip counts, in radii: all that an inclined cutter clears a surface with,
/// and few samples to look at.
constexpr double height_share = 1;

/// Samples by cells of a level grid.
class Cells {
public:
    Cells(std::span<const Vec3> points, double cell) : cell_(cell) {
        Box3 box;
        for (const Vec3& p : points)
            box.add(p);
        lo_ = points.empty() ? Vec3(0, 0, 0) : box.lo;
        const Vec3 size = points.empty() ? Vec3(0, 0, 0) : Vec3(box.hi - box.lo);
        // Where points are scattered, no more than a few cells per point.
        while (size.x() * size.y() > 16.0 * double(points.size() + 1) * cell_ * cell_)
            cell_ *= 2;
        nx_ = std::size_t(size.x() / cell_) + 1;
        ny_ = std::size_t(size.y() / cell_) + 1;
        start_.assign(nx_ * ny_ + 1, 0);
        for (const Vec3& p : points)
            ++start_[at(p) + 1];
        for (std::size_t i = 1; i < start_.size(); ++i)
            start_[i] += start_[i - 1];
        order_.resize(points.size());
        auto next = start_;
        for (std::size_t i = 0; i < points.size(); ++i)
            order_[next[at(points[i])]++] = i;
    }

    template <class Use>
    void near(const Vec3& p, double reach, Use&& use) const {
        const auto clamp = [&](double v, std::size_t n) {
            return std::size_t(std::clamp(v, 0.0, double(n - 1)));
        };
        const std::size_t x0 = clamp((p.x() - reach - lo_.x()) / cell_, nx_),
                          x1 = clamp((p.x() + reach - lo_.x()) / cell_, nx_),
                          y0 = clamp((p.y() - reach - lo_.y()) / cell_, ny_),
                          y1 = clamp((p.y() + reach - lo_.y()) / cell_, ny_);
        for (std::size_t y = y0; y <= y1; ++y)
            for (std::size_t k = start_[y * nx_ + x0]; k < start_[y * nx_ + x1 + 1]; ++k)
                use(order_[k]);
    }

private:
    std::size_t at(const Vec3& p) const {
        const auto x = std::min(std::size_t((p.x() - lo_.x()) / cell_), nx_ - 1);
        const auto y = std::min(std::size_t((p.y() - lo_.y()) / cell_), ny_ - 1);
        return y * nx_ + x;
    }

    double cell_;
    Vec3 lo_;
    std::size_t nx_ = 1, ny_ = 1;
    std::vector<std::size_t> start_, order_;
};

} // namespace

std::vector<SurfaceSample> surface_samples(const Mesh& mesh, std::span<const Vec3> normals, const UpSide& up,
                                           double spacing) {
    std::vector<SurfaceSample> samples;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        const Vec3 own = up.towards_tool(mesh.facet_normal(f));
        if (own.z() <= tolerance::vertical_normal_z) continue;
        const std::array<Vec3, 3> p{mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)};
        double longest = 0;
        for (std::size_t k = 0; k < 3; ++k)
            longest = std::max(longest, (p[(k + 1) % 3] - p[k]).norm());
        // n^2 equal parts, a sample in the middle of each.
        const auto n = std::size_t(std::max(1.0, std::ceil(longest / spacing)));
        const double area = 0.5 * mesh.facet_cross(f).norm() / double(n * n);
        const auto add = [&](double a, double b) {
            const double c = 1 - a - b;
            Vec3 normal = Vec3::Zero();
            const std::array<double, 3> share{c, a, b};
            for (std::size_t k = 0; k < 3; ++k)
                normal += share[k] * up.towards_tool(normals[mesh.facets[f][k]]);
            normal = normal.norm() > 0.1 && normal.dot(own) > 0 ? normal.normalized() : own;
            samples.push_back({c * p[0] + a * p[1] + b * p[2], normal, area});
        };
        const double third = 1.0 / 3, parts = double(n);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; i + k < n; ++k) {
                add((double(i) + third) / parts, (double(k) + third) / parts);
                if (i + k + 1 < n) add((double(i) + 2 * third) / parts, (double(k) + 2 * third) / parts);
            }
    }
    return samples;
}

Coverage::Coverage(std::vector<SurfaceSample> samples, double raise)
    : samples_(std::move(samples)), cleared_(samples_.size(), 0) {
    raised_.reserve(samples_.size());
    for (const SurfaceSample& s : samples_)
        raised_.push_back(s.point + raise * s.normal);
}

namespace {

/// A place as a tool in some pose sees it: along its axis, and beside it.
struct Seen {
    double z;
    Vec3 beside;
};

Seen seen_from(const CutterLocation& at, const Vec3& place) {
    const Vec3 from = place - at.tip;
    const double z = from.dot(at.axis);
    return {z, from - z * at.axis};
}

/// Whether a place that goes straight from `a` to `b`, as the tool sees it, comes `slack` deep into the
/// cutter.
bool comes_in(const Seen& a, const Seen& b, const CutterProfile& cutter, double height, double slack) {
    if (std::max(a.z, b.z) < slack || std::min(a.z, b.z) > height) return false;
    const double r = cutter.max_radius() - slack;
    const Vec3 move = b.beside - a.beside;
    // The part of the path that is beside the cutter: |a + t move| <= r, 0 <= z <= height.
    double from = 0, to = 1;
    const double square = move.squaredNorm(), half = a.beside.dot(move),
                 rest = a.beside.squaredNorm() - r * r;
    if (square > 0) {
        const double root = half * half - square * rest;
        if (root < 0) return false;
        from = std::max(from, (-half - std::sqrt(root)) / square);
        to = std::min(to, (-half + std::sqrt(root)) / square);
    } else if (rest > 0) {
        return false;
    }
    if (const double rise = b.z - a.z; rise != 0) {
        const double at_tip = -a.z / rise, at_top = (height - a.z) / rise;
        from = std::max(from, std::min(at_tip, at_top));
        to = std::min(to, std::max(at_tip, at_top));
    }
    if (!(from <= to)) return false;
    const auto depth = [&](double t) {
        return a.z + t * (b.z - a.z) - cutter.height_at((a.beside + t * move).norm());
    };
    // The cutter is convex: on a straight path the depth rises, then falls.
    double at_from = depth(from), at_to = depth(to);
    if (at_from >= slack || at_to >= slack) return true;
    for (int round = 0; round < deepest_rounds; ++round) {
        const double third = (to - from) / 3, first = depth(from + third), second = depth(to - third);
        if (first >= slack || second >= slack) return true;
        // No chord of such a curve, made longer, runs below it.
        const double between =
            std::min(std::max(first, 2 * first - at_from), std::max(second, 2 * second - at_to));
        if (std::max({between, 2 * first - second, 2 * second - first}) < slack) return false;
        if (first < second) {
            from += third;
            at_from = first;
        } else {
            to -= third;
            at_to = second;
        }
    }
    return false;
}

} // namespace

void Coverage::add(std::span<const Pass> passes, const CutterProfile& cutter, const Progress& progress) {
    const double r = cutter.max_radius(), height = std::min(cutter.height(), height_share * r);
    const double reach = std::hypot(r, height), slack = straight_share * r;
    const Cells cells(raised_, cell_share * r);
    parallel_for(passes.size(), 1, progress, [&](std::size_t i) {
        const Pass& pass = passes[i];
        const auto look = [&](const CutterLocation& a, const CutterLocation& b) {
            cells.near(0.5 * (a.tip + b.tip), reach + 0.5 * (b.tip - a.tip).norm(), [&](std::size_t s) {
                std::atomic_ref<unsigned char> flag(cleared_[s]);
                if (flag.load(std::memory_order_relaxed)) return;
                if (comes_in(seen_from(a, raised_[s]), seen_from(b, raised_[s]), cutter, height, slack))
                    flag.store(1, std::memory_order_relaxed);
            });
        };
        if (pass.cl.size() == 1) look(pass.cl[0], pass.cl[0]);
        for (std::size_t k = 0; k + 1 < pass.cl.size(); ++k) {
            const CutterLocation &a = pass.cl[k], &b = pass.cl[k + 1];
            const double distance = (b.tip - a.tip).norm(), turn = (b.axis - a.axis).norm();
            // What a turning tool sees of a straight path bends by turn (reach turn + 2 distance) / 8.
            const double pieces =
                std::ceil(std::max({1.0, distance / (step_share * r),
                                    std::sqrt(turn * (reach * turn + 2 * distance) / (8 * slack))}));
            CutterLocation last = a;
            for (double p = 1; p <= pieces; ++p) {
                progress.check();
                const CutterLocation next = p < pieces ? location_on_route(a, b, p / pieces) : b;
                look(last, next);
                last = next;
            }
        }
    });
}

double Coverage::area() const {
    double sum = 0;
    for (const SurfaceSample& s : samples_)
        sum += s.area;
    return sum;
}

double Coverage::cleared_area() const {
    double sum = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i)
        if (cleared_[i]) sum += samples_[i].area;
    return sum;
}

} // namespace facetmill
