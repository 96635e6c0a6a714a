#include "viz/sight_tree.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill {

namespace {

constexpr std::size_t boxes_per_block = 8192; // facets or boxes: a few ms
constexpr std::size_t boxes_per_check = 1u << 16;
constexpr int bits_per_axis = 10;
/// Boxes are larger than their facets by this share of the part, for the rounding of the tests against them.
constexpr double box_margin = 1e-9;

/// The bits of a number of ten bits, two zeros after each.
std::uint32_t spread(std::uint32_t x) {
    x = (x | x << 16) & 0x030000FFu;
    x = (x | x << 8) & 0x0300F00Fu;
    x = (x | x << 4) & 0x030C30C3u;
    return (x | x << 2) & 0x09249249u;
}

float down(double v) {
    return std::nextafter(float(v), -std::numeric_limits<float>::infinity());
}
float up(double v) {
    return std::nextafter(float(v), std::numeric_limits<float>::infinity());
}

/// Sorts by the upper half, of which the lowest 30 bits count; equal ones keep their order.
void sort_by_code(std::vector<std::uint64_t>& items, const Progress& progress) {
    std::vector<std::uint64_t> other(items.size());
    for (int shift = 32; shift < 32 + 3 * bits_per_axis; shift += bits_per_axis) {
        constexpr std::uint64_t mask = (1u << bits_per_axis) - 1;
        std::array<std::size_t, mask + 2> start{};
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (i % boxes_per_check == 0) progress.check();
            ++start[(items[i] >> shift & mask) + 1];
        }
        for (std::size_t k = 0; k <= mask; ++k)
            start[k + 1] += start[k];
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (i % boxes_per_check == 0) progress.check();
            other[start[items[i] >> shift & mask]++] = items[i];
        }
        items.swap(other);
    }
}

/// Moeller and Trumbore 1997; infinity where the line misses the facet.
double distance_to(const Mesh& mesh, std::size_t f, const Vec3& origin, const Vec3& direction) {
    const Vec3& a = mesh.corner(f, 0);
    const Vec3 e1 = mesh.corner(f, 1) - a, e2 = mesh.corner(f, 2) - a;
    const Vec3 p = direction.cross(e2);
    const double det = e1.dot(p);
    if (det == 0.0) return infinity;
    const Vec3 s = origin - a;
    const double u = s.dot(p) / det;
    if (!(u >= 0.0 && u <= 1.0)) return infinity;
    const Vec3 q = s.cross(e1);
    const double v = direction.dot(q) / det;
    if (!(v >= 0.0 && u + v <= 1.0)) return infinity;
    const double t = e2.dot(q) / det;
    return t < infinity ? t : infinity;
}

} // namespace

SightTree::SightTree(const Mesh& mesh, const Progress& progress) {
    const std::size_t n = mesh.facets.size();
    if (n == 0) return;
    const Box3 all = parallel_reduce(
        n, boxes_per_block, Box3{}, progress.part(0, 0.1),
        [&](std::size_t begin, std::size_t end) {
            Box3 b;
            for (std::size_t f = begin; f < end; ++f)
                for (int k = 0; k < 3; ++k)
                    b.add(mesh.corner(f, k));
            return b;
        },
        [](Box3 a, const Box3& b) {
            a.add(b);
            return a;
        });
    center_ = all.center();
    const double margin = box_margin * all.diagonal();
    slack_ = 4 * margin;

    const double side = all.size().maxCoeff();
    const double scale = side > 0 ? ((1 << bits_per_axis) - 1) / side : 0;
    std::vector<std::uint64_t> items(n);
    parallel_for(n, boxes_per_block, progress.part(0.1, 0.3), [&](std::size_t f) {
        const Vec3 middle = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
        std::uint64_t code = 0;
        for (int k = 0; k < 3; ++k) {
            const double at = (middle[k] - all.lo[k]) * scale;
            const double most = (1 << bits_per_axis) - 1;
            code |= std::uint64_t(spread(std::uint32_t(at > 0 ? std::min(at, most) : 0.0))) << k;
        }
        items[f] = code << 32 | f;
    });
    sort_by_code(items, progress);
    order_.resize(n);
    parallel_for(n, boxes_per_block, progress.part(0.6, 0.7),
                 [&](std::size_t i) { order_[i] = std::uint32_t(items[i]); });

    const auto empty_box = [] {
        constexpr float most = std::numeric_limits<float>::infinity();
        return Box{{most, most, most}, {-most, -most, -most}};
    };
    levels_.emplace_back((n + arity - 1) / arity);
    parallel_for(levels_[0].size(), boxes_per_block / arity, progress.part(0.7, 0.95), [&](std::size_t i) {
        Box box = empty_box();
        for (std::size_t j = i * arity; j < std::min(n, (i + 1) * arity); ++j)
            for (int c = 0; c < 3; ++c) {
                const Vec3 p = mesh.corner(order_[j], c) - center_;
                for (std::size_t k = 0; k < 3; ++k) {
                    box.lo[k] = std::min(box.lo[k], down(p[Eigen::Index(k)] - margin));
                    box.hi[k] = std::max(box.hi[k], up(p[Eigen::Index(k)] + margin));
                }
            }
        levels_[0][i] = box;
    });
    while (levels_.back().size() > 1) {
        const std::vector<Box>& below = levels_.back();
        std::vector<Box> level((below.size() + arity - 1) / arity, empty_box());
        for (std::size_t i = 0; i < below.size(); ++i) {
            if (i % boxes_per_check == 0) progress.check();
            Box& box = level[i / arity];
            for (std::size_t k = 0; k < 3; ++k) {
                box.lo[k] = std::min(box.lo[k], below[i].lo[k]);
                box.hi[k] = std::max(box.hi[k], below[i].hi[k]);
            }
        }
        levels_.push_back(std::move(level));
    }
    progress.set(1);
}

bool SightTree::meets(const Box& box, const Vec3& origin, const Vec3& direction, double from,
                      double to) const {
    for (std::size_t k = 0; k < 3; ++k) {
        const double o = origin[Eigen::Index(k)], d = direction[Eigen::Index(k)];
        const double lo = double(box.lo[k]) - o, hi = double(box.hi[k]) - o;
        if (d == 0) {
            if (lo > 0 || hi < 0) return false;
            continue;
        }
        const double a = lo / d, b = hi / d;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to + slack_;
}

SightHit SightTree::first(const Mesh& mesh, const Vec3& origin, const Vec3& direction, double after) const {
    SightHit best;
    if (levels_.empty()) return best;
    const Vec3 from = origin - center_;
    struct Node {
        std::size_t level, index;
    };
    std::vector<Node> open{{levels_.size() - 1, 0}};
    while (!open.empty()) {
        const Node node = open.back();
        open.pop_back();
        if (!meets(levels_[node.level][node.index], from, direction, after, best.distance)) continue;
        const std::size_t begin = node.index * arity, end = begin + arity;
        if (node.level > 0) {
            for (std::size_t i = begin; i < std::min(end, levels_[node.level - 1].size()); ++i)
                open.push_back({node.level - 1, i});
            continue;
        }
        for (std::size_t i = begin; i < std::min(end, order_.size()); ++i) {
            const std::size_t f = order_[i];
            const double t = distance_to(mesh, f, origin, direction);
            if (t < after) continue;
            if (t < best.distance || (t == best.distance && t < infinity && f < best.facet)) best = {t, f};
        }
    }
    return best;
}

} // namespace facetmill
