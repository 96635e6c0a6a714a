#include "tests/bench/scalar/axial_lift.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/bench/scalar/axial_elements.h"
#include "tests/bench/scalar/contact_blocks.h"

#include <cmath>

namespace facetmill::scalar {

namespace {

using Feature = AxialContact::Feature;

/// The highest lift found so far.
struct Best {
    double tip_z = -infinity;
    Index facet = no_index;
    Index block = no_index;
    Vec3 point = Vec3::Zero(); ///< x, y relative to the axis
    Feature feature = Feature::none;

    void take(const ElementLift& lift, Index of_facet, Index of_block, Feature of_feature) {
        if (!(lift.tip_z > tip_z)) return;
        tip_z = lift.tip_z;
        point = lift.point;
        facet = of_facet;
        block = of_block;
        feature = of_feature;
    }
};

class Query {
public:
    Query(const ContactIndex::Impl& index, const LowerSurface& surface, double x, double y)
        : index_(index), surface_(surface), x_(x), y_(y), radius_(surface.max_radius()),
          slack_(tolerance::bound_slack * (radius_ + std::abs(x) + std::abs(y) + index.largest_coordinate)) {}

    /// All facets of one block.
    void test_block(Index block_index) {
        const FacetBlock& block = index_.blocks[block_index];
        for (std::size_t lane = 0; lane < block_width; ++lane) {
            const unsigned duty = block.duty[lane];
            if (duty == 0) continue;
            const double highest = std::max({block.z[0][lane], block.z[1][lane], block.z[2][lane]});
            if (highest <= best_.tip_z) continue;
            Vec3 p[3];
            for (std::size_t k = 0; k < 3; ++k)
                p[k] = Vec3(block.x[k][lane] - x_, block.y[k][lane] - y_, block.z[k][lane]);
            const double dx = std::max(
                {std::min({p[0].x(), p[1].x(), p[2].x()}), -std::max({p[0].x(), p[1].x(), p[2].x()}), 0.0});
            const double dy = std::max(
                {std::min({p[0].y(), p[1].y(), p[2].y()}), -std::max({p[0].y(), p[1].y(), p[2].y()}), 0.0});
            if (promise(dx, dy, highest) <= best_.tip_z) continue;
            const Index facet = block.facet[lane];
            for (std::size_t k = 0; k < 3; ++k)
                if (duty & (duty_vertex << k) && p[k].z() > best_.tip_z)
                    best_.take(vertex_lift(surface_, p[k]), facet, block_index, Feature::vertex);
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 &a = p[k], &b = p[(k + 1) % 3];
                if (duty & (duty_edge << k) && std::max(a.z(), b.z()) > best_.tip_z)
                    best_.take(edge_lift(surface_, a, b), facet, block_index, Feature::edge);
            }
            if (duty & duty_plane)
                best_.take(facet_lift(surface_, p[0], p[1], p[2]), facet, block_index, Feature::facet);
        }
    }

    /// The whole tree, nearest promise first.
    void run() {
        if (index_.nodes.empty()) return;
        struct Entry {
            double bound;
            Index child;
        };
        // Seven siblings wait on every level but the last, which is that of the blocks; with full nodes the
        // tree is no deeper than the digits of the facet count in base 8.
        std::array<Entry, block_width * 16> stack;
        std::size_t depth = 0;
        stack[depth++] = {infinity, 0};
        while (depth > 0) {
            const Entry top = stack[--depth];
            if (top.bound <= best_.tip_z) continue;
            if (top.child & TreeNode::leaf) {
                test_block(top.child & ~TreeNode::leaf);
                continue;
            }
            const TreeNode& node = index_.nodes[top.child];
            const std::size_t from = depth;
            for (std::size_t lane = 0; lane < block_width; ++lane) {
                const double dx = std::max({double(node.xlo[lane]) - x_, x_ - double(node.xhi[lane]), 0.0});
                const double dy = std::max({double(node.ylo[lane]) - y_, y_ - double(node.yhi[lane]), 0.0});
                const double bound = promise(dx, dy, double(node.zhi[lane]));
                if (bound <= best_.tip_z) continue;
                // Kept in order of bound, the highest last.
                std::size_t at = depth++;
                while (at > from && stack[at - 1].bound > bound) {
                    stack[at] = stack[at - 1];
                    --at;
                }
                stack[at] = {bound, node.child[lane]};
            }
        }
    }

    const Best& best() const { return best_; }

private:
    /// No lift of anything in a box is higher: the box is dx, dy away from the axis and reaches up to
    /// `highest`.
    double promise(double dx, double dy, double highest) const {
        const double square = dx * dx + dy * dy, reach = radius_ + slack_;
        if (!(square <= reach * reach)) return -infinity;
        const double under = surface_.bound(std::max(0.0, std::sqrt(square) - slack_));
        return highest - under + tolerance::bound_slack * (std::abs(highest) + under + radius_);
    }

    const ContactIndex::Impl& index_;
    const LowerSurface& surface_;
    double x_, y_, radius_;
    double slack_; ///< more than distances from the axis are wrong by
    Best best_;
};

/// What a query at a place that is no place gives: nothing is under infinity.
double lift_nowhere(double x, double y) {
    return std::isnan(x) || std::isnan(y) ? std::numeric_limits<double>::quiet_NaN() : -infinity;
}

bool is_place(double x, double y) {
    return std::isfinite(x) && std::isfinite(y);
}

} // namespace

AxialLift::AxialLift(ContactIndexPtr index, const CutterProfile& cutter, double allowance)
    : index_(std::move(index)), profile_(cutter), allowance_(allowance),
      surface_(std::make_shared<const LowerSurface>(cutter.grown(allowance))) {}

double AxialLift::tip_z(double x, double y) const {
    if (!is_place(x, y)) return lift_nowhere(x, y);
    Query query(index_->impl(), *surface_, x, y);
    query.run();
    return query.best().tip_z + allowance_;
}

AxialContact AxialLift::contact(double x, double y) const {
    AxialContact contact;
    if (!is_place(x, y)) {
        contact.tip_z = lift_nowhere(x, y);
        return contact;
    }
    Query query(index_->impl(), *surface_, x, y);
    query.run();
    const Best& best = query.best();
    if (best.feature == Feature::none) return contact;
    contact.tip_z = best.tip_z + allowance_;
    contact.facet = best.facet;
    contact.feature = best.feature;
    contact.point = best.point + Vec3(x, y, 0);
    return contact;
}

void AxialLift::tip_z(std::span<const Vec2> points, std::span<double> heights,
                      const Progress& progress) const {
    if (points.size() != heights.size())
        throw Error(ErrorCode::internal, "AxialLift", "as many heights as points are needed", "report this");
    constexpr std::size_t points_per_block = 256;
    parallel_blocks(points.size(), points_per_block, progress, [&](std::size_t begin, std::size_t end) {
        // A neighbour's blocking facets are a good first guess: the height they give prunes the rest. The
        // result is the same, because only what cannot be higher is pruned.
        Index last_block = no_index;
        for (std::size_t i = begin; i < end; ++i) {
            const double x = points[i].x(), y = points[i].y();
            if (!is_place(x, y)) {
                heights[i] = lift_nowhere(x, y);
                continue;
            }
            Query query(index_->impl(), *surface_, x, y);
            if (last_block != no_index) query.test_block(last_block);
            query.run();
            if (query.best().block != no_index) last_block = query.best().block;
            heights[i] = query.best().tip_z + allowance_;
        }
    });
}

} // namespace facetmill::scalar
