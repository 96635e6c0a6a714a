#include "core/strategy/preview/coarse_tips.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// What a field of tips may cost: cells of the ground that are looked at, all tips together.
constexpr double largest_work = 12e6;
/// Beyond a border a tip is counted while it rolls over a slope that is this steep, radians; nearly level
/// ground ends at its border.
constexpr double level_border = 0.05, border_slack = 0.2;

double work_of(const CoarseGrid& grid, double radius) {
    const double reach = radius / grid.cell;
    return (grid.columns + 2 * reach) * (grid.rows + 2 * reach) * pi * std::max(reach * reach, 1.0);
}

} // namespace

CoarseTips::CoarseTips(std::shared_ptr<const CoarseGround> ground, const CutterProfile& profile,
                       double allowance, const Progress& progress)
    : ground_(std::move(ground)), profile_(profile.grown(std::max(allowance, 0.0))),
      radius_(profile_.max_radius()), lift_(std::max(allowance, 0.0)) {
    while (work_of(ground_->grid(), radius_) > largest_work && ground_->grid().size() > 1)
        ground_ = std::make_shared<const CoarseGround>(ground_->halved());
    const CoarseGrid& base = ground_->grid();
    pad_ = int(std::ceil(radius_ / base.cell)) + 1;
    grid_ = base;
    grid_.columns += 2 * pad_;
    grid_.rows += 2 * pad_;
    grid_.origin -= pad_ * base.cell * Vec2(1, 1);

    for (int y = -pad_; y <= pad_; ++y)
        for (int x = -pad_; x <= pad_; ++x) {
            const double distance = base.cell * std::hypot(x, y);
            if (distance <= radius_)
                offsets_.push_back({x, y, distance, float(profile_.height_at(distance))});
        }
    // The nearest of those that hold it equally high counts.
    std::stable_sort(offsets_.begin(), offsets_.end(),
                     [](const Offset& a, const Offset& b) { return a.distance < b.distance; });
    const float lift = float(lift_);
    z_.assign(grid_.size(), nothing_there);
    holder_.assign(grid_.size(), -1);
    const std::vector<float>& height = ground_->height();
    parallel_for(std::size_t(grid_.rows), 1, progress, [&](std::size_t row) {
        for (int x = 0; x < grid_.columns; ++x) {
            float best = nothing_there;
            int holder = -1;
            for (const Offset& o : offsets_) {
                const int gx = x - pad_ + o.x, gy = int(row) - pad_ + o.y;
                if (!base.has(gx, gy)) continue;
                const std::size_t i = base.index(gx, gy);
                const float z = height[i] - o.z;
                if (z <= best || !is_there(height[i])) continue;
                best = z;
                holder = int(i);
            }
            const std::size_t i = grid_.index(x, int(row));
            z_[i] = holder < 0 ? nothing_there : best + lift;
            holder_[i] = holder;
        }
    });
}

std::vector<float> CoarseTips::left_heights(const Progress& progress) const {
    const CoarseGrid& base = ground_->grid();
    std::vector<float> left(base.size(), nothing_there);
    parallel_for(std::size_t(base.rows), 1, progress, [&](std::size_t row) {
        for (int x = 0; x < base.columns; ++x) {
            const std::size_t i = base.index(x, int(row));
            if (!is_there(ground_->height()[i])) continue;
            float low = -nothing_there;
            for (const Offset& o : offsets_) {
                const float z = z_[grid_.index(x + pad_ + o.x, int(row) + pad_ + o.y)];
                if (is_there(z)) low = std::min(low, z + o.z - float(lift_));
            }
            left[i] = std::max(low, ground_->height()[i]);
        }
    });
    return left;
}

int CoarseTips::below(std::size_t tip) const {
    const int x = int(tip % std::size_t(grid_.columns)) - pad_,
              y = int(tip / std::size_t(grid_.columns)) - pad_;
    return ground_->grid().has(x, y) ? int(ground_->grid().index(x, y)) : -1;
}

std::optional<double> CoarseTips::height(const Vec2& p) const {
    const double x = (p.x() - grid_.origin.x()) / grid_.cell, y = (p.y() - grid_.origin.y()) / grid_.cell;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    double sum = 0, weight = 0;
    for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx) {
            if (!grid_.has(x0 + dx, y0 + dy)) continue;
            const float z = z_[grid_.index(x0 + dx, y0 + dy)];
            if (!is_there(z)) continue;
            const double w = (dx ? x - x0 : 1 - (x - x0)) * (dy ? y - y0 : 1 - (y - y0));
            sum += w * double(z);
            weight += w;
        }
    if (!(weight > 0)) return std::nullopt;
    return sum / weight;
}

Vec2 CoarseTips::rise(std::size_t tip) const {
    const int x = int(tip % std::size_t(grid_.columns)), y = int(tip / std::size_t(grid_.columns));
    const auto along = [&](int dx, int dy) {
        const bool before = grid_.has(x - dx, y - dy) && is_there(z_[grid_.index(x - dx, y - dy)]),
                   after = grid_.has(x + dx, y + dy) && is_there(z_[grid_.index(x + dx, y + dy)]);
        const double low = double(before ? z_[grid_.index(x - dx, y - dy)] : z_[tip]),
                     high = double(after ? z_[grid_.index(x + dx, y + dy)] : z_[tip]);
        const int steps = int(before) + int(after);
        return steps == 0 ? 0.0 : (high - low) / (steps * grid_.cell);
    };
    return {along(1, 0), along(0, 1)};
}

double CoarseTips::slope(std::size_t tip) const {
    return std::atan(rise(tip).norm());
}

bool CoarseTips::on_surface(std::size_t tip) const {
    const int holder = holder_[tip];
    if (holder < 0 || !ground_->on_part(std::size_t(holder))) return false;
    const int under = below(tip);
    if (under >= 0 && ground_->facet()[std::size_t(under)] != no_index) return true;
    // Beside the part: the surface has to fall away towards the tip as steeply as the cutter rises there.
    const CoarseGrid& base = ground_->grid();
    const Vec2 from = base.middle(std::size_t(holder)), to = grid_.middle(tip) - from;
    const double distance = to.norm();
    if (!(distance > 0)) return true;
    const Vec2 inward = from - 2 * base.cell / distance * to;
    const int x = base.column(inward.x()), y = base.row(inward.y());
    if (!base.has(x, y)) return false;
    const float inner = ground_->height()[base.index(x, y)];
    if (!is_there(inner)) return false;
    const double fall = std::atan(double(inner - ground_->height()[std::size_t(holder)]) / (2 * base.cell));
    if (fall < level_border) return false;
    const double d = 0.5 * base.cell;
    const double near = std::max(distance - d, 0.0), far = std::min(distance + d, radius_);
    const double steep =
        far > near ? std::atan((profile_.height_at(far) - profile_.height_at(near)) / (far - near)) : 0;
    return steep <= fall + border_slack;
}

} // namespace facetmill
