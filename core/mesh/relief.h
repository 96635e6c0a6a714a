// Reliefs from pictures: rows of brightness come in from the top and become a grid of heights, and that an
// open sheet. Internal to the room; what a job says of a relief stands in mesh_reading.h.
//
// A picture with more pixels than `max_relief_points` gets a coarser grid, whose points lie evenly from its
// first column to its last one and are means of the pixels around, weighted by how near they are.
#pragma once

#include "core/mesh/mesh_reader.h"

#include <cstdint>
#include <span>
#include <vector>

namespace facetmill::detail {

/// Larger pictures are refused before anything of their size is allocated.
inline constexpr std::uint64_t max_picture_pixels = 100'000'000, max_picture_side = 100'000;
inline constexpr std::uint64_t max_relief_points = 4'000'000;

/// Throws Error(too_large) for more pixels than that, Error(no_facets) for a picture without
/// area: one of less than two columns or rows.
void check_picture_size(const MeshSource& source, std::uint64_t columns, std::uint64_t rows);

class ReliefBuilder {
public:
    /// The size must have been checked.
    ReliefBuilder(const MeshSource& source, std::size_t columns, std::size_t rows);

    /// The next row: brightness from 0 to 1, and how opaque each pixel is (empty: all are). What is
    /// transparent lies on the ground, whether or not the relief is inverted.
    void add_row(std::span<const double> brightness, std::span<const double> opacity = {});
    /// Makes brightness 0 of the darkest point and 1 of the brightest, for values without a scale of their
    /// own.
    void stretch();
    /// The sheet, once all rows were added. Numbers are in the unit that the job assumes.
    TriangleSoup finish(const std::string& format, std::set<std::string> warnings, const Progress& progress);

private:
    /// The points of a grid that a pixel counts for: this one and the next. From the first pixel on.
    class Share;
    void divide_by_weights();
    void smooth(double bound, const Progress& progress);

    const MeshSource& source_;
    std::size_t columns_, rows_;           ///< of the picture
    std::size_t grid_columns_, grid_rows_; ///< points
    std::size_t row_ = 0;                  ///< the next one
    std::vector<double> heights_;          ///< row by row from the top; 0 to 1
    std::vector<double> row_values_, column_weights_, row_weights_;
};

} // namespace facetmill::detail
