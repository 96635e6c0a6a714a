#include "core/gouge/part_distance.h"

#include "core/gouge/contact_impl.h"
#include "core/mesh/triangle_distance.h"

#include <array>
#include <cmath>

namespace facetmill {

namespace {

class NearestFacet {
public:
    NearestFacet(const ContactIndex& index, const Vec3& p, double most)
        : mesh_(index.mesh()), view_(index.impl().view()), p_(p),
          from_origin_(p - Vec3(view_.origin[0], view_.origin[1], view_.origin[2])), near2_(most * most) {
        if (view_.nodes) node(0);
    }
    double squared() const { return near2_; }

private:
    /// The nearest child first: those behind it are then mostly too far.
    void node(std::uint32_t i) {
        const TreeNode& n = view_.nodes[i];
        std::array<double, block_width> square;
        for (std::size_t lane = 0; lane < block_width; ++lane) {
            const double x = std::max(std::abs(from_origin_.x() - n.cx[lane]) - n.hx[lane], 0.0),
                         y = std::max(std::abs(from_origin_.y() - n.cy[lane]) - n.hy[lane], 0.0),
                         z = std::max(std::abs(from_origin_.z() - n.cz[lane]) - n.hz[lane], 0.0);
            square[lane] = x * x + y * y + z * z;
        }
        for (;;) {
            std::size_t next = block_width;
            for (std::size_t lane = 0; lane < block_width; ++lane)
                if (square[lane] < near2_ && n.hx[lane] >= 0
                    && (next == block_width || square[lane] < square[next]))
                    next = lane;
            if (next == block_width) return;
            square[next] = infinity;
            const std::uint32_t child = n.child[next];
            if (child & TreeNode::leaf)
                block(view_.blocks[child & ~TreeNode::leaf]);
            else
                node(child);
        }
    }

    void block(const FacetBlock& block) {
        for (std::size_t lane = 0; lane < block_width; ++lane) {
            const Index f = block.facet[lane];
            if (f == no_index) continue;
            near2_ = std::min(
                near2_, squared_distance(p_, mesh_.corner(f, 0), mesh_.corner(f, 1), mesh_.corner(f, 2)));
        }
    }

    const Mesh& mesh_;
    const IndexView view_;
    const Vec3 p_, from_origin_;
    double near2_;
};

} // namespace

double part_distance(const ContactIndex& index, const Vec3& p, double most) {
    return std::sqrt(NearestFacet(index, p, most).squared());
}

} // namespace facetmill
