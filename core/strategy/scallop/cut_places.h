// Which places of a grid of tips are cut: not those where the cutter only rolls over an outer edge, and
// nothing goes on over walls. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/base/vec.h"

#include <vector>

namespace facetmill {

/// What a place may be: a tip that rolls over an edge touches, but is as steep as no facet there.
inline constexpr char not_cut = 0, cut_surface = 1, rolling = 2;

/// Refers to what a field has of its places, row by row: what they are, touched points, normals, heights of
/// tips.
class CutPlaces {
public:
    CutPlaces(int columns, double spacing, std::vector<char>& cut, std::vector<Eigen::Vector3f>& touched,
              std::vector<Eigen::Vector3f>& normal, const std::vector<float>& tip)
        : columns_(columns), rows_(columns > 0 ? int(cut.size() / std::size_t(columns)) : 0),
          spacing_(spacing), cut_(cut), touched_(touched), normal_(normal), tip_(tip) {}

    void fill_lone_gaps();
    void join_level_bottoms();
    /// `steepest`: slope that is cut, radians.
    void part_at_walls(double steepest);
    /// `radius`: of the cutter. Afterwards places are cut or not.
    void leave_outer_edges(double radius, const Progress& progress);

private:
    std::size_t size() const { return cut_.size(); }
    std::size_t number(int column, int row) const {
        return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
    }

    int columns_, rows_;
    double spacing_;
    std::vector<char>& cut_;
    std::vector<Eigen::Vector3f>&touched_, &normal_;
    const std::vector<float>& tip_;
};

} // namespace facetmill
