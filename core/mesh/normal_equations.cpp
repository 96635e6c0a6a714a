#include "core/mesh/normal_equations.h"

#include <Eigen/Cholesky>

namespace facetmill {

NormalSolution solve_normal_equations(const NormalMatrix& matrix, const NormalVector& right) {
    const Eigen::LDLT<NormalMatrix> ldlt(matrix);
    return {ldlt.solve(right), ldlt.vectorD().minCoeff()};
}

} // namespace facetmill
