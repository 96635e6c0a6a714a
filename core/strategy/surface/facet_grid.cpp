#include "core/strategy/surface/facet_grid.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <array>

namespace facetmill {

namespace {

constexpr std::size_t facets_per_check = 8192;
constexpr double max_cells = 4e6;
/// Facets of usual size are in about this many cells along x and y.
constexpr double cells_per_facet = 0.5;

} // namespace

FacetGrid::FacetGrid(const Mesh& mesh, const Progress& progress) : mesh_(mesh), box_(mesh.box()) {
    const Vec3 size = box_.size();
    const std::size_t n = mesh.facet_count();
    const auto spread = [&](std::size_t f) {
        const Vec3 &a = mesh.corner(f, 0), &b = mesh.corner(f, 1), &c = mesh.corner(f, 2);
        return std::array<Vec2, 2>{a.cwiseMin(b).cwiseMin(c).head<2>(), a.cwiseMax(b).cwiseMax(c).head<2>()};
    };
    double extent = parallel_reduce(
        n, facets_per_check, 0.0, progress.part(0, 0),
        [&](std::size_t begin, std::size_t end) {
            double sum = 0;
            for (std::size_t f = begin; f < end; ++f) {
                const auto [lo, hi] = spread(f);
                sum += (hi - lo).sum();
            }
            return sum;
        },
        [](double x, double y) { return x + y; });
    extent /= 2 * std::max<double>(1, double(n));
    const double area = std::max(size.x() * size.y(), tolerance::smallest_extent);
    cell_ = std::max({extent / cells_per_facet, std::sqrt(area / max_cells),
                      std::max(size.x(), size.y()) / std::sqrt(max_cells), tolerance::smallest_extent});
    columns_ = int(size.x() / cell_) + 1;
    rows_ = int(size.y() / cell_) + 1;
    start_.assign(std::size_t(columns_) * std::size_t(rows_) + 1, 0);
    std::vector<std::array<int, 4>> cells(n); // columns and rows of each
    parallel_for(n, facets_per_check, progress.part(0, 0), [&](std::size_t f) {
        const auto [lo, hi] = spread(f);
        cells[f] = {column(lo.x()), column(hi.x()), row(lo.y()), row(hi.y())};
    });
    const auto each = [&](auto&& put) {
        for (std::size_t f = 0; f < n; ++f) {
            if (f % facets_per_check == 0) progress.check();
            const auto& [x0, x1, y0, y1] = cells[f];
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x)
                    put(std::size_t(y) * std::size_t(columns_) + std::size_t(x), Index(f));
        }
    };
    each([&](std::size_t cell, Index) { ++start_[cell + 1]; });
    for (std::size_t i = 1; i < start_.size(); ++i)
        start_[i] += start_[i - 1];
    facets_.resize(start_.back());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    each([&](std::size_t cell, Index f) { facets_[next[cell]++] = f; });
}

std::optional<FacetGrid::Hit> FacetGrid::first_hit(const Vec3& from, const Vec3& direction,
                                                   double reach) const {
    Hit best;
    best.distance = reach;
    const auto meet = [&](Index f) {
        const Vec3& a = mesh_.corner(f, 0);
        const Vec3 e1 = mesh_.corner(f, 1) - a, e2 = mesh_.corner(f, 2) - a;
        const Vec3 p = direction.cross(e2);
        const double det = e1.dot(p);
        if (std::abs(det) <= tolerance::unit_rounding * e1.norm() * e2.norm()) return;
        // What falls between two facets by rounding belongs to both.
        const double slack = tolerance::grid_rounding;
        const Vec3 s = from - a;
        const double u = s.dot(p) / det;
        if (u < -slack || u > 1 + slack) return;
        const Vec3 q = s.cross(e1);
        const double v = direction.dot(q) / det;
        if (v < -slack || u + v > 1 + slack) return;
        const double t = e2.dot(q) / det;
        if (t >= 0 && (t < best.distance || (t == best.distance && f < best.facet))) best = {t, f};
    };
    // Cell by cell along the ray.
    int x = int(std::floor((from.x() - box_.lo.x()) / cell_)),
        y = int(std::floor((from.y() - box_.lo.y()) / cell_));
    const auto next_side = [&](int k, int cell) {
        const double side = box_.lo[k] + cell_ * (direction[k] > 0 ? cell + 1 : cell);
        return direction[k] == 0 ? infinity : (side - from[k]) / direction[k];
    };
    double tx = next_side(0, x), ty = next_side(1, y), t = 0;
    while (t <= best.distance) {
        if (x >= 0 && x < columns_ && y >= 0 && y < rows_) {
            const std::size_t cell = std::size_t(y) * std::size_t(columns_) + std::size_t(x);
            for (std::uint32_t i = start_[cell]; i < start_[cell + 1]; ++i)
                meet(facets_[i]);
        } else if ((x < 0 && direction.x() <= 0) || (x >= columns_ && direction.x() >= 0)
                   || (y < 0 && direction.y() <= 0) || (y >= rows_ && direction.y() >= 0)) {
            break;
        }
        t = std::min(tx, ty);
        if (t == infinity) break;
        if (tx <= ty) {
            x += direction.x() > 0 ? 1 : -1;
            tx = next_side(0, x);
        } else {
            y += direction.y() > 0 ? 1 : -1;
            ty = next_side(1, y);
        }
    }
    if (best.facet == no_index) return std::nullopt;
    return best;
}

} // namespace facetmill
