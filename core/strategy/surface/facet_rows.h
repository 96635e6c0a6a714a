// Samples of a facet: rows of places along its longest edge. Millimetres.
#pragma once

#include "core/mesh/mesh.h"

#include <array>

namespace facetmill {

/// Samples in the middles of even pieces of a facet: rows along its longest edge.
class FacetRows {
public:
    FacetRows(const Mesh& mesh, std::size_t f, double spacing)
        : FacetRows({mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)}, spacing) {}
    FacetRows(const std::array<Vec3, 3>& corner, double spacing) {
        std::size_t longest = 0;
        double edge[3];
        for (std::size_t k = 0; k < 3; ++k) {
            edge[k] = (corner[(k + 1) % 3] - corner[k]).norm();
            if (edge[k] > edge[longest]) longest = k;
        }
        origin_ = corner[longest];
        along_ = corner[(longest + 1) % 3] - origin_;
        up_ = corner[(longest + 2) % 3] - origin_;
        area_ = 0.5 * along_.cross(up_).norm();
        base_ = edge[longest];
        rows_ = std::size_t(2 * area_ / base_ / spacing) + 1;
        spacing_ = spacing;
    }
    double area() const { return area_; }
    std::size_t rows() const { return rows_; }
    std::size_t columns(std::size_t row) const { return std::size_t(base_ * (1 - t(row)) / spacing_) + 1; }
    Vec3 point(std::size_t row, std::size_t column) const {
        const double s = (double(column) + 0.5) / double(columns(row));
        return origin_ + t(row) * up_ + s * (1 - t(row)) * along_;
    }
    /// Area that one sample of a row stands for.
    double weight(std::size_t row) const {
        const double row_area = rows_ == 1 ? area_ : 2 * area_ * (1 - t(row)) / double(rows_);
        return row_area / double(columns(row));
    }

private:
    double t(std::size_t row) const {
        // A single row runs through the facet's middle.
        return rows_ == 1 ? 1.0 / 3 : (double(row) + 0.5) / double(rows_);
    }
    Vec3 origin_, along_, up_;
    double area_, base_, spacing_;
    std::size_t rows_;
};

} // namespace facetmill
