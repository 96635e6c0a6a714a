#include "core/gouge/shared_cut.h"

#include <algorithm>
#include <limits>

namespace facetmill {

void SharedCut::fill(const Children& children, std::size_t size) {
    empty_ = size == 0;
    count_ = std::max(1, int((size + block_width - 1) / block_width));
    for (std::size_t i = 0; i < std::size_t(count_) * block_width; ++i) {
        TreeNode& to = nodes_[i / block_width];
        const std::size_t lane = i % block_width;
        if (i >= size) {
            to.cx[lane] = to.cy[lane] = to.cz[lane] = to.roof[lane] = to.slope_x[lane] = to.slope_y[lane] = 0;
            to.normal_x[lane] = to.normal_y[lane] = to.normal_z[lane] = to.above[lane] = to.below[lane] = 0;
            to.slope_lo_x[lane] = to.slope_hi_x[lane] = to.slope_lo_y[lane] = to.slope_hi_y[lane] = 0;
            to.hx[lane] = to.hy[lane] = to.hz[lane] = -std::numeric_limits<float>::infinity();
            to.across_x[lane] = to.across_y[lane] = to.strip_lo[lane] = to.strip_hi[lane] = 0;
            to.highest[lane] = -std::numeric_limits<double>::infinity();
            to.child[lane] = TreeNode::leaf;
            continue;
        }
        const TreeNode& from = *children[i].node;
        const std::size_t k = children[i].lane;
        to.cx[lane] = from.cx[k];
        to.cy[lane] = from.cy[k];
        to.cz[lane] = from.cz[k];
        to.hx[lane] = from.hx[k];
        to.hy[lane] = from.hy[k];
        to.hz[lane] = from.hz[k];
        to.roof[lane] = from.roof[k];
        to.slope_x[lane] = from.slope_x[k];
        to.slope_y[lane] = from.slope_y[k];
        to.child[lane] = from.child[k];
        to.normal_x[lane] = from.normal_x[k];
        to.normal_y[lane] = from.normal_y[k];
        to.normal_z[lane] = from.normal_z[k];
        to.above[lane] = from.above[k];
        to.below[lane] = from.below[k];
        to.slope_lo_x[lane] = from.slope_lo_x[k];
        to.slope_hi_x[lane] = from.slope_hi_x[k];
        to.slope_lo_y[lane] = from.slope_lo_y[k];
        to.slope_hi_y[lane] = from.slope_hi_y[k];
        to.highest[lane] = from.highest[k];
        to.across_x[lane] = from.across_x[k];
        to.across_y[lane] = from.across_y[k];
        to.strip_lo[lane] = from.strip_lo[k];
        to.strip_hi[lane] = from.strip_hi[k];
    }
}

} // namespace facetmill
