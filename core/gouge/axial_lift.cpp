#include "core/gouge/axial_lift.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/contact_impl.h"
#include "core/gouge/lower_surface.h"
#include "core/gouge/shared_cut.h"

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

/// Fewer places than this are asked for one by one: a packet takes about as long as so many queries.
constexpr std::size_t fewest_in_packet = 4;

/// For cutters of this radius at all places of a box.
void make_cut(SharedCut& cut, const IndexView& index, double radius, const Vec2& lo, const Vec2& hi) {
    constexpr std::size_t nodes_per_cut = 2;
    // Positions of boxes are floats: half sizes are rounded outward, the middles as good as exact.
    const double slack = tolerance::float_slack * (index.half_size[0] + index.half_size[1] + radius);
    const double x0 = lo.x() - index.origin[0] - radius - slack,
                 x1 = hi.x() - index.origin[0] + radius + slack;
    const double y0 = lo.y() - index.origin[1] - radius - slack,
                 y1 = hi.y() - index.origin[1] + radius + slack;
    cut.make(index, nodes_per_cut, [&](const TreeNode& node, std::size_t k) {
        const double cx = double(node.cx[k]), cy = double(node.cy[k]), hx = double(node.hx[k]),
                     hy = double(node.hy[k]);
        return cx + hx >= x0 && cx - hx <= x1 && cy + hy >= y0 && cy - hy <= y1;
    });
}

/// One of a batch.
struct Place {
    Vec2 at;
    std::size_t number;
};

/// What a thread needs for a batch, kept for its next one: for many small batches it costs more to ask for
/// memory than to find the lifts.
struct Scratch {
    std::vector<Place> places, sorted;
    std::vector<std::uint32_t> cell, first;
    PreparedBlocks prepared;
};

Scratch& scratch() {
    thread_local const auto kept = std::make_unique_for_overwrite<Scratch>();
    return *kept;
}

/// How many of the first places lie in a square of this side; [lo, hi] becomes their box.
std::size_t near(std::span<const Place> places, double side, Vec2& lo, Vec2& hi) {
    lo = hi = places[0].at;
    std::size_t count = 1;
    for (; count < places.size(); ++count) {
        const Vec2 new_lo = lo.cwiseMin(places[count].at), new_hi = hi.cwiseMax(places[count].at);
        if ((new_hi - new_lo).maxCoeff() > side) break;
        lo = new_lo;
        hi = new_hi;
    }
    return count;
}

/// Orders places so that as many as a packet has, one after another, lie about in a square: in bands along X
/// as high as such a square, to and fro within strips some squares wide, so that the part of the mesh that a
/// band needs is still near at hand for the next. Places too far apart for packets stay as they are.
void arrange(Scratch& scratch, std::size_t in_packet, double widest) {
    std::vector<Place>& places = scratch.places;
    const std::size_t n = places.size();
    if (n < in_packet) return;
    Vec2 lo = places[0].at, hi = lo;
    for (const Place& p : places) {
        lo = lo.cwiseMin(p.at);
        hi = hi.cwiseMax(p.at);
    }
    const Vec2 size = hi - lo;
    const double side = std::max(std::sqrt(double(in_packet) * size.x() * size.y() / double(n)),
                                 double(in_packet) * size.maxCoeff() / double(n));
    if (!(side > 0) || side > widest) return;
    // Counting sort by cells of a packet's side in height and a place's share of it in width: about as many
    // as places.
    const double wide = side / double(in_packet);
    const auto bands = std::size_t(size.y() / side) + 1, cells = std::size_t(size.x() / wide) + 1;
    const std::size_t per_strip = std::min<std::size_t>(8 * in_packet, cells),
                      strips = (cells + per_strip - 1) / per_strip;
    std::vector<std::uint32_t>&cell = scratch.cell, &first = scratch.first;
    cell.resize(n);
    first.assign(strips * bands * per_strip + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 d = places[i].at - lo;
        const std::size_t band = std::min(std::size_t(d.y() / side), bands - 1),
                          along = std::min(std::size_t(d.x() / wide), cells - 1),
                          in_strip = along % per_strip;
        cell[i] = std::uint32_t((along / per_strip * bands + band) * per_strip
                                + (band % 2 == 0 ? in_strip : per_strip - 1 - in_strip));
        ++first[cell[i] + 1];
    }
    for (std::size_t c = 1; c < first.size(); ++c)
        first[c] += first[c - 1];
    std::vector<Place>& sorted = scratch.sorted;
    sorted.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        sorted[first[cell[i]]++] = places[i];
    places.swap(sorted);
}

AxialAnswer search(const IndexView& index, const SurfaceTable& surface, double x, double y,
                   std::uint32_t hint, const SharedCut* cut = nullptr, double least = -infinity,
                   double enough = infinity) {
    AxialQuery query;
    query.place[0] = x;
    query.place[1] = y;
    query.hint = hint;
    query.least = least;
    query.enough = enough;
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

double AxialLift::tip_z(double x, double y, LiftHint& hint, double least) const {
    if (!is_place(x, y)) return std::max(lift_nowhere(x, y), least);
    const AxialAnswer answer =
        search(index_->impl().view(), *surface_, x, y, hint.slot_, nullptr, least - allowance_);
    if (answer.slot == no_slot) return least;
    hint.slot_ = answer.slot;
    return std::max(answer.tip + allowance_, least);
}

bool AxialLift::is_above(double x, double y, double z, LiftHint& hint) const {
    if (!is_place(x, y)) return false;
    const double least = z - allowance_;
    const AxialAnswer answer =
        search(index_->impl().view(), *surface_, x, y, hint.slot_, nullptr, least, least);
    if (answer.slot == no_slot) return false;
    hint.slot_ = answer.slot;
    return true;
}

AxialContact AxialLift::contact(double x, double y) const {
    LiftHint none;
    return contact(x, y, none);
}

AxialContact AxialLift::contact_of(const AxialAnswer& answer, double x, double y) const {
    AxialContact contact;
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

AxialContact AxialLift::contact(double x, double y, LiftHint& hint) const {
    AxialContact nothing;
    nothing.tip_z = is_place(x, y) ? -infinity : lift_nowhere(x, y);
    if (!is_place(x, y)) return nothing;
    const AxialAnswer answer = search(index_->impl().view(), *surface_, x, y, hint.slot_);
    if (answer.slot == no_slot) return nothing;
    hint.slot_ = answer.slot;
    return contact_of(answer, x, y);
}

namespace {

void check_size(std::size_t points, std::size_t answers) {
    if (points != answers)
        throw Error(ErrorCode::internal, "AxialLift", "as many answers as points are needed", "report this");
}

} // namespace

void AxialLift::tip_z(std::span<const Vec2> points, std::span<double> heights,
                      const Progress& progress) const {
    check_size(points.size(), heights.size());
    each_of(points, progress, [&](std::size_t i, double tip, std::uint32_t) { heights[i] = tip; });
}

void AxialLift::contact(std::span<const Vec2> points, std::span<AxialContact> contacts,
                        const Progress& progress) const {
    check_size(points.size(), contacts.size());
    const IndexView view = index_->impl().view();
    each_of(points, progress, [&](std::size_t i, double tip, std::uint32_t slot) {
        contacts[i] = {};
        contacts[i].tip_z = tip;
        if (slot == no_slot) return;
        AxialQuery query;
        query.place[0] = points[i].x();
        query.place[1] = points[i].y();
        query.hint = slot;
        AxialAnswer answer;
        axial_kernels().touch(view, *surface_, query, answer);
        contacts[i] = contact_of(answer, points[i].x(), points[i].y());
    });
}

template <class Take>
void AxialLift::each_of(std::span<const Vec2> points, const Progress& progress, const Take& take) const {
    // Large blocks, so that there is much to arrange; the last of them in quarters, so that all threads end
    // at about the same time.
    constexpr std::size_t fewest = 256, most = 16384, packets_per_cut = 4, between_checks = 512;
    const std::size_t large = std::clamp(points.size() / 16, fewest, most),
                      small = std::max(large / 4, fewest);
    std::vector<std::size_t> bounds{0};
    for (std::size_t left = points.size(); left > 0; left = points.size() - bounds.back())
        bounds.push_back(bounds.back() + std::min(left, left > 2 * large ? large : small));
    const IndexView view = index_->impl().view();
    const std::size_t in_packet = std::size_t(axial_kernels().packet_places);
    const double radius = surface_->max_radius, widest_cut = 4 * radius;
    parallel_ranges(bounds, progress, [&](std::size_t begin, std::size_t end) {
        Scratch& kept = scratch();
        std::vector<Place>& places = kept.places;
        places.clear();
        places.reserve(end - begin);
        for (std::size_t i = begin; i < end; ++i) {
            if (is_place(points[i].x(), points[i].y()))
                places.push_back({points[i], i});
            else
                take(i, lift_nowhere(points[i].x(), points[i].y()), no_slot);
        }
        arrange(kept, in_packet, radius);
        SharedCut cut;
        PreparedBlocks& prepared = kept.prepared;
        prepared.clear();
        std::uint32_t hint = no_slot;
        std::size_t cut_end = 0, next_check = between_checks;
        for (std::size_t i = 0; i < places.size();) {
            if (i >= next_check) {
                progress.check();
                next_check += between_checks;
            }
            const std::span<const Place> left = std::span(places).subspan(i);
            Vec2 lo, hi;
            if (i >= cut_end) {
                cut_end = i
                          + near(left.first(std::min(left.size(), packets_per_cut * in_packet)), widest_cut,
                                 lo, hi);
                make_cut(cut, view, radius, lo, hi);
            }
            AxialPacket packet;
            const std::size_t count =
                view.mostly_needles ? 1 : near(left.first(std::min(cut_end - i, in_packet)), radius, lo, hi);
            if (count < fewest_in_packet) {
                const AxialAnswer answer =
                    search(view, *surface_, left[0].at.x(), left[0].at.y(), hint, &cut);
                if (answer.slot != no_slot) hint = answer.slot;
                take(left[0].number, answer.tip + allowance_, answer.slot);
                ++i;
                continue;
            }
            for (std::size_t k = 0; k < count; ++k) {
                packet.x[k] = left[k].at.x();
                packet.y[k] = left[k].at.y();
            }
            packet.count = int(count);
            packet.cut = cut.nodes();
            packet.cut_nodes = cut.count();
            packet.prepared = &prepared;
            AxialPacketAnswer answer;
            axial_kernels().packet(view, *surface_, packet, answer);
            for (std::size_t k = 0; k < count; ++k)
                take(left[k].number, answer.tips[k] + allowance_, answer.touched[k]);
            i += count;
        }
    });
}

} // namespace facetmill
