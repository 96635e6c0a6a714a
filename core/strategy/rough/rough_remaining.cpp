#include "core/strategy/rough/rough_remaining.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/strategy/surface/up_side.h"

#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// Places that are looked at, at most: some seconds of work.
constexpr double max_looked_at = 2e5;
/// Places that a thread takes at a time.
constexpr std::size_t block = 256;
/// Where the part keeps the cutter away by more than this share of what is allowed, a place is out of reach.
constexpr double reach_share = 0.05;
/// Places beside the tip that would touch, from which the cutter may reach a place too.
constexpr std::size_t looks_beside = 8;
/// What the field cannot tell apart along a slanting line, as a share of the cells' size.
constexpr double field_noise = 1;
/// Steeper places are under the cutter's side: what stays there is in the wall's own cell.
const double flattest_normal = std::cos(85 * pi / 180);

/// How far from p along n the stock reaches, in steps of half a cell.
double height_along(const StockField& field, const Vec3& p, const Vec3& n, double most) {
    const double step = 0.5 * field.cell();
    for (double t = 0; t < most; t += step) {
        const Vec3 q = p + t * n;
        const double u = (q.x() - field.box().lo.x()) / field.cell(),
                     v = (q.y() - field.box().lo.y()) / field.cell();
        if (!(u >= 0 && v >= 0 && u < field.columns() && v < field.rows())) return t;
        if (q.z() >= field.middle(int(u), int(v))) return t;
    }
    return most;
}

} // namespace

Remaining find_remaining(const RemainingInput& in, const Progress& progress) {
    const StockField& field = *in.field;
    const AxialLift needle(in.contact,
                           CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height)));
    const AxialLift kept(in.contact,
                         CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height)),
                         in.allowance);
    const AxialLift lift(in.contact, *in.profile, in.allowance);
    const CutterCover cover(*in.profile, cusp_detail(in.allowed));
    const UpSide up(*in.mesh, progress);
    const double cells = double(field.columns()) * double(field.rows());
    const int stride = std::max(1, int(std::ceil(std::sqrt(cells / max_looked_at))));
    const auto columns = std::size_t((field.columns() - 1) / stride + 1),
               rows = std::size_t((field.rows() - 1) / stride + 1);
    return parallel_reduce(
        columns * rows, block, Remaining(), progress,
        [&](std::size_t begin, std::size_t end) {
            Remaining worst;
            LiftHint hint, over_tip;
            std::array<Vec2, looks_beside> beside;
            std::array<double, looks_beside> beside_z{};
            for (std::size_t i = begin; i < end; ++i) {
                const int column = int(i % columns) * stride, row = int(i / columns) * stride;
                const Vec2 p = field.center(column, row);
                if (field.middle(column, row) == -infinity) continue;
                if (in.within && in.within->region->depth(p) < 2 * in.within->radius) continue;
                const AxialContact seen = needle.contact(p.x(), p.y());
                // What else it sees is no part, but keeps the cutter off it.
                if (seen.facet == no_index || seen.facet >= in.mesh->facet_count()) continue;
                const Vec3 n = up.towards_tool(in.mesh->facet_normal(seen.facet));
                if (!(n.z() > flattest_normal)) continue;
                const Vec3 on_part(p.x(), p.y(), seen.tip_z);
                ++worst.places;
                const Vec3 over = on_part + in.allowance * n;
                const Vec3 tip = over + cover.tip_offset(n);
                // Along the normal, where the stock over neighbouring cells may be higher.
                const double left = height_along(field, over, n, field.box().size().z());
                if (left <= in.allowed + field_noise * field.cell()) continue;
                // Beside a wall the place lies in the wall's own allowance.
                if (kept.is_above(over.x(), over.y(), over.z() + reach_share * in.allowed, hint)) continue;
                if (tip.z() < in.lowest_tip) {
                    ++worst.too_low;
                    if (left > worst.low_height) {
                        worst.low_height = left;
                        worst.low_at = on_part;
                    }
                    continue;
                }
                // How far away the cutter stays, from wherever it comes down: over the place that would
                // touch, or a little beside it where the part holds it up less.
                const double near = reach_share * in.allowed;
                const auto away_from = [&](const Vec2& at, double z) {
                    return cover.ray_entry(over, n, Vec3(at.x(), at.y(), z), 4 * cover.radius());
                };
                double away = away_from(tip.head<2>(), lift.tip_z(tip.x(), tip.y(), over_tip));
                if (away > near) {
                    for (std::size_t k = 0; k < looks_beside; ++k) {
                        const double turn = 2 * pi * double(k + 1) / double(looks_beside);
                        beside[k] = tip.head<2>() + near * Vec2(std::cos(turn), std::sin(turn));
                    }
                    lift.tip_z(beside, beside_z, progress.part(0, 0));
                    for (std::size_t k = 0; k < beside.size() && away > near; ++k)
                        away = std::min(away, away_from(beside[k], beside_z[k]));
                }
                if (away > near) {
                    ++worst.out_of_reach;
                    if (left > worst.beyond) {
                        worst.beyond = left;
                        worst.beyond_at = on_part;
                    }
                } else if (left > worst.height) {
                    worst.height = left;
                    worst.at = on_part;
                }
            }
            return worst;
        },
        [](Remaining a, const Remaining& b) {
            if (b.height > a.height) {
                a.height = b.height;
                a.at = b.at;
            }
            if (b.beyond > a.beyond) {
                a.beyond = b.beyond;
                a.beyond_at = b.beyond_at;
            }
            if (b.low_height > a.low_height) {
                a.low_height = b.low_height;
                a.low_at = b.low_at;
            }
            a.places += b.places;
            a.too_low += b.too_low;
            a.out_of_reach += b.out_of_reach;
            return a;
        });
}

} // namespace facetmill
