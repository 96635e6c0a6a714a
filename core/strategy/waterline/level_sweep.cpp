#include "core/strategy/waterline/level_sweep.h"

#include "core/base/tolerances.h"
#include "core/strategy/surface/up_side.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Pieces are so long at most, places near a hint are looked for so far from it at first, tiles are so wide;
/// in radii of the cutter.
constexpr double longest_piece = 0.2, first_look = 0.25, tile_width = 0.5;
/// Each leaves two thirds of a piece that slopes.
constexpr int slope_rounds = 12;

} // namespace

LevelSweep::LevelSweep(std::span<const Pass> passes, const CutterProfile& profile, const Progress& progress)
    : profile_(profile), radius_(profile.max_radius()), middles_(first_look * radius_) {
    for (const Pass& pass : passes) {
        progress.check();
        for (std::size_t i = 0; i < pass.cl.size(); ++i)
            add(pass.cl[i > 0 ? i - 1 : 0].tip, pass.cl[i].tip);
    }
    for (auto& [at, numbers] : tiles_)
        std::stable_sort(numbers.begin(), numbers.end(), [&](std::uint32_t a, std::uint32_t b) {
            return pieces_[a].a.z() < pieces_[b].a.z();
        });
}

void LevelSweep::add(const Vec3& a, const Vec3& b) {
    const double parts = std::floor((b - a).norm() / (longest_piece * radius_)) + 1;
    for (double k = 0; k < parts; ++k) {
        const Piece piece{a + k / parts * (b - a), a + (k + 1) / parts * (b - a)};
        const Vec3 middle = 0.5 * (piece.a + piece.b);
        tiles_[tile(middle.head<2>())].push_back(std::uint32_t(pieces_.size()));
        middles_.add(middle);
        pieces_.push_back(piece);
    }
}

std::pair<long, long> LevelSweep::tile(const Vec2& p) const {
    return {long(std::floor(p.x() / (tile_width * radius_))),
            long(std::floor(p.y() / (tile_width * radius_)))};
}

/// How low the cutter comes over q.
double LevelSweep::over(const Piece& piece, const Vec3& q, double enough) const {
    const Vec2 d = (piece.b - piece.a).head<2>(), to = (q - piece.a).head<2>();
    const double square = d.squaredNorm(), t = square > 0 ? std::clamp(to.dot(d) / square, 0.0, 1.0) : 0.0;
    const auto at = [&](double s) {
        const Vec3 tip = piece.a + s * (piece.b - piece.a);
        const double rho = (q - tip).head<2>().norm();
        return rho <= radius_ ? tip.z() + profile_.height_at(rho) : infinity;
    };
    const double near = at(t);
    if (piece.a.z() == piece.b.z() || near == infinity) return near;
    // Height and distance are convex along the piece, and so is their sum for a convex cutter: it is least
    // between the nearest place and the lower end.
    double first = t, last = piece.a.z() < piece.b.z() ? 0.0 : 1.0;
    if (near - std::abs(piece.b.z() - piece.a.z()) * std::abs(last - first) >= enough) return near;
    for (int round = 0; round < slope_rounds; ++round) {
        const double low = first + (last - first) / 3, high = last - (last - first) / 3;
        if (at(low) <= at(high))
            last = high;
        else
            first = low;
    }
    return std::min(near, at(0.5 * (first + last)));
}

double LevelSweep::lowest(const Vec3& q, const Vec3& hint, double enough) const {
    double best = infinity;
    const auto look = [&](std::size_t i) {
        best = std::min(best, over(pieces_[i], q, best));
        return best <= enough;
    };
    if (middles_.near_until(hint, first_look * radius_, look)) return best;
    const double reach = radius_ * (1 + longest_piece);
    const auto [x0, y0] = tile(q.head<2>() - Vec2::Constant(reach));
    const auto [x1, y1] = tile(q.head<2>() + Vec2::Constant(reach));
    for (long x = x0; x <= x1; ++x)
        for (long y = y0; y <= y1; ++y) {
            const auto found = tiles_.find({x, y});
            if (found == tiles_.end()) continue;
            for (const std::uint32_t i : found->second) {
                if (std::min(pieces_[i].a.z(), pieces_[i].b.z()) >= best) break;
                if (look(i)) return best;
            }
        }
    return best;
}

UncutReport uncut_by_levels(UncutInput input, const PlanContext& context, const SweptCourses& courses,
                            const CutterProfile& profile, double cusp_allowed, const Progress& progress) {
    const LevelSweep swept(courses.passes, profile, progress.part(0, 0.15)),
        left_out(courses.left_out, profile, progress.part(0.15, 0.2));
    input.contact = context.contact;
    input.allowed = (1 + tolerance::uncut_margin) * cusp_allowed;
    input.top = std::max(context.stock_box.hi.z(), context.part_box.hi.z());
    input.swept = &swept;
    if (!courses.left_out.empty()) input.swept_left_out = &left_out;
    input.outside_up = context.is_piece || UpSide(*context.part, progress.part(0.2, 0.2)).closed();
    return find_uncut(input, progress.part(0.2, 1));
}

} // namespace facetmill
