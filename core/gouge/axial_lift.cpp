#include "core/gouge/axial_lift.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
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

AxialAnswer search(const IndexView& index, const SurfaceTable& surface, double x, double y,
                   std::uint32_t hint) {
    AxialQuery query;
    query.place[0] = x;
    query.place[1] = y;
    query.hint = hint;
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
    constexpr std::size_t points_per_block = 256;
    parallel_blocks(points.size(), points_per_block, progress, [&](std::size_t begin, std::size_t end) {
        LiftHint hint;
        for (std::size_t i = begin; i < end; ++i)
            heights[i] = tip_z(points[i].x(), points[i].y(), hint);
    });
}

} // namespace facetmill
