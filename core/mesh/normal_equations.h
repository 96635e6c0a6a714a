// Normal equations of small fits.
#pragma once

#include "core/base/vec.h"

namespace facetmill {

/// Sizes are known only when they run: one solver for all fits, instead of one a size, each of which takes
/// seconds to compile.
using NormalMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 9, 9>;
using NormalVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 9, 1>;

struct NormalSolution {
    NormalVector x;
    double pivot_min; ///< of the decomposition: near zero, or negative, where the unknowns are not determined
};

/// Solves matrix x = right, the matrix symmetric and of at most nine rows (LDL^T with pivots).
NormalSolution solve_normal_equations(const NormalMatrix& matrix, const NormalVector& right);

} // namespace facetmill
