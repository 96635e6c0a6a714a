// The facets of a mesh by where they are, seen from above: rays and neighbourhoods that are small against the
// part. Millimetres, part coordinates.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <cmath>
#include <optional>
#include <vector>

namespace facetmill {

class FacetGrid {
public:
    /// `mesh` must outlive the grid.
    FacetGrid(const Mesh& mesh, const Progress& progress);

    struct Hit {
        double distance = infinity; ///< along the ray
        Index facet = no_index;
    };
    /// The first facet, either side of it, that a ray from `from` along the unit vector `direction` meets
    /// within `reach`. Facets that the ray runs along are not met.
    std::optional<Hit> first_hit(const Vec3& from, const Vec3& direction, double reach) const;

    /// visit(facet) for every facet whose box seen from above is within `radius` of `at` along x and y, and
    /// maybe others; some more than once.
    template <class Visit>
    void near(const Vec2& at, double radius, Visit&& visit) const {
        const int x0 = column(at.x() - radius), x1 = column(at.x() + radius);
        const int y0 = row(at.y() - radius), y1 = row(at.y() + radius);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const std::size_t cell = std::size_t(y) * std::size_t(columns_) + std::size_t(x);
                for (std::uint32_t i = start_[cell]; i < start_[cell + 1]; ++i)
                    visit(facets_[i]);
            }
    }

private:
    int column(double x) const {
        return int(std::clamp(std::floor((x - box_.lo.x()) / cell_), 0.0, double(columns_ - 1)));
    }
    int row(double y) const {
        return int(std::clamp(std::floor((y - box_.lo.y()) / cell_), 0.0, double(rows_ - 1)));
    }

    const Mesh& mesh_;
    Box3 box_;
    double cell_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> start_, facets_;
};

} // namespace facetmill
