#include "core/gouge/axial_lift.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/contact_impl.h"
#include "core/gouge/lower_surface.h"

#include <cmath>

namespace facetmill {

namespace {

/// What a query at a place that is no place gives: nothing is under infinity.
double lift_nowhere(double x, double y) {
    return std::isnan(x) || std::isnan(y) ? std::numeric_limits<double>::quiet_NaN() : -infinity;
}

bool is_place(double x, double y) {
    return std::isfinite(x) && std::isfinite(y);
}

/// Places that lie close together share the way down the tree: a cut through it below which is all that the
/// cutter reaches at any of them.
class SharedCut {
public:
    SharedCut(const IndexView& index, double radius) : index_(index), radius_(radius) {}

    /// For all places of a box: as far down as the boxes in reach fit into most_nodes nodes.
    void make(const Vec2& lo, const Vec2& hi) {
        struct Child {
            const TreeNode* node;
            std::size_t lane;
            std::uint32_t child() const { return node->child[lane]; }
        };
        count_ = 0;
        if (!index_.nodes) return;
        // Positions of boxes are floats: half sizes are rounded outward, the middles as good as exact.
        const double slack = tolerance::float_slack * (index_.half_size[0] + index_.half_size[1] + radius_);
        const double x0 = lo.x() - index_.origin[0] - radius_ - slack,
                     x1 = hi.x() - index_.origin[0] + radius_ + slack;
        const double y0 = lo.y() - index_.origin[1] - radius_ - slack,
                     y1 = hi.y() - index_.origin[1] + radius_ + slack;
        std::array<Child, most_children> children, finer;
        std::size_t n = 0;
        // False when there are too many.
        const auto add_reached = [&](const TreeNode& node, std::array<Child, most_children>& to,
                                     std::size_t& size) {
            for (std::size_t k = 0; k < block_width; ++k) {
                const double cx = double(node.cx[k]), cy = double(node.cy[k]), hx = double(node.hx[k]),
                             hy = double(node.hy[k]);
                if (!(cx + hx >= x0 && cx - hx <= x1 && cy + hy >= y0 && cy - hy <= y1)) continue;
                if (size == most_children) return false;
                to[size++] = {&node, k};
            }
            return true;
        };
        add_reached(index_.nodes[0], children, n);
        for (bool divided = true; divided;) {
            divided = false;
            std::size_t m = 0;
            bool fits = true;
            for (std::size_t i = 0; i < n && fits; ++i) {
                if (children[i].child() & TreeNode::leaf) {
                    fits = m < most_children;
                    if (fits) finer[m++] = children[i];
                } else {
                    fits = add_reached(index_.nodes[children[i].child()], finer, m);
                    divided = true;
                }
            }
            if (!fits) break;
            std::copy_n(finer.begin(), m, children.begin());
            n = m;
        }
        count_ = std::max(1, int((n + block_width - 1) / block_width));
        for (std::size_t i = 0; i < std::size_t(count_) * block_width; ++i) {
            TreeNode& to = nodes_[i / block_width];
            const std::size_t lane = i % block_width;
            if (i >= n) {
                to.cx[lane] = to.cy[lane] = to.cz[lane] = to.roof[lane] = to.slope_x[lane] =
                    to.slope_y[lane] = 0;
                to.hx[lane] = to.hy[lane] = to.hz[lane] = -std::numeric_limits<float>::infinity();
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
        }
    }

    const TreeNode* nodes() const { return nodes_.data(); }
    int count() const { return count_; }

private:
    static constexpr std::size_t most_nodes = 2, most_children = most_nodes * block_width;
    IndexView index_;
    double radius_;
    std::array<TreeNode, most_nodes> nodes_;
    int count_ = 0;
};

AxialAnswer search(const IndexView& index, const SurfaceTable& surface, double x, double y,
                   std::uint32_t hint, const SharedCut* cut = nullptr) {
    AxialQuery query;
    query.place[0] = x;
    query.place[1] = y;
    query.hint = hint;
    if (cut) {
        query.cut = cut->nodes();
        query.cut_nodes = cut->count();
    }
    AxialAnswer answer;
    axial_kernels().upright(index, surface, query, answer);
    return answer;
}

} // namespace

AxialLift::AxialLift(ContactIndexPtr index, const CutterProfile& cutter, double allowance)
    : index_(std::move(index)), profile_(cutter), allowance_(allowance),
      surface_(std::make_shared<const SurfaceTable>(lower_surface(cutter.grown(allowance)))) {}

double AxialLift::tip_z(double x, double y, LiftHint& hint) const {
    if (!is_place(x, y)) return lift_nowhere(x, y);
    const AxialAnswer answer = search(index_->impl().view(), *surface_, x, y, hint.slot_);
    if (answer.slot != no_slot) hint.slot_ = answer.slot;
    return answer.tip + allowance_;
}

double AxialLift::tip_z(double x, double y) const {
    LiftHint none;
    return tip_z(x, y, none);
}

AxialContact AxialLift::contact(double x, double y) const {
    AxialContact contact;
    if (!is_place(x, y)) {
        contact.tip_z = lift_nowhere(x, y);
        return contact;
    }
    const AxialAnswer answer = search(index_->impl().view(), *surface_, x, y, no_slot);
    if (answer.slot == no_slot) return contact;
    const FacetBlock& block = index_->impl().blocks[answer.slot / block_width];
    const std::size_t lane = answer.slot % block_width;
    contact.tip_z = answer.tip + allowance_;
    contact.facet = block.facet[lane];
    contact.point = Vec3(answer.point[0] + x, answer.point[1] + y, answer.point[2]);
    contact.feature = answer.edge < 0 ? AxialContact::Feature::facet : AxialContact::Feature::edge;
    if (answer.edge >= 0) // a corner's lift comes from the corner's own coordinates
        for (const std::size_t k : {std::size_t(answer.edge), std::size_t(answer.edge + 1) % 3})
            if (answer.point[0] == block.x[k][lane] - x && answer.point[1] == block.y[k][lane] - y
                && answer.point[2] == block.z[k][lane])
                contact.feature = AxialContact::Feature::vertex;
    return contact;
}

void AxialLift::tip_z(std::span<const Vec2> points, std::span<double> heights,
                      const Progress& progress) const {
    if (points.size() != heights.size())
        throw Error(ErrorCode::internal, "AxialLift", "as many heights as points are needed", "report this");
    constexpr std::size_t points_per_block = 256, points_per_cut = 32;
    const IndexView view = index_->impl().view();
    const double radius = surface_->max_radius, widest = 4 * radius;
    parallel_blocks(points.size(), points_per_block, progress, [&](std::size_t begin, std::size_t end) {
        std::uint32_t hint = no_slot;
        SharedCut cut(view, radius);
        std::size_t cut_end = begin;
        for (std::size_t i = begin; i < end; ++i) {
            const Vec2& p = points[i];
            if (!is_place(p.x(), p.y())) {
                heights[i] = lift_nowhere(p.x(), p.y());
                continue;
            }
            if (i >= cut_end) {
                Vec2 lo = p, hi = p;
                for (cut_end = i + 1; cut_end < std::min(end, i + points_per_cut); ++cut_end) {
                    const Vec2& q = points[cut_end];
                    if (!is_place(q.x(), q.y())) break;
                    const Vec2 new_lo = lo.cwiseMin(q), new_hi = hi.cwiseMax(q);
                    if ((new_hi - new_lo).maxCoeff() > widest) break;
                    lo = new_lo;
                    hi = new_hi;
                }
                cut.make(lo, hi);
            }
            const AxialAnswer answer = search(view, *surface_, p.x(), p.y(), hint, &cut);
            if (answer.slot != no_slot) hint = answer.slot;
            heights[i] = answer.tip + allowance_;
        }
    });
}

} // namespace facetmill
