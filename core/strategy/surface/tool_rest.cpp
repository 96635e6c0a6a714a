#include "core/strategy/surface/tool_rest.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/surface/cutter_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace facetmill {

namespace {

/// Places are no farther apart than this share of the cutter's radius, and nearer until they are so many.
constexpr double usual_share = 1.0 / 8, coarsest_share = 1.0 / 3, free_places = 5e4;
/// A tip this far beside its place stays higher by the amount, at most, on a surface that is round.
double even_spacing(double radius, double more_than) {
    return std::sqrt(radius * more_than);
}
/// What the cutter stays too low by counts as no more than this share of the amount: it does not move the
/// border, and nobody has to look for lower.
constexpr double enough_share = 0.5;
/// What leans by less than this share of the amount over the cutter's flat bottom is level.
constexpr double level_share = 0.01;
/// Of the search beside the lowest tip of the grid: how often the step is halved, and steps in all.
constexpr int halvings = 7, max_steps = 40;
/// Tips that are looked at round a place, the cutter's rim over it.
constexpr int rim_places = 64;
constexpr double just_within = 1 - 1e-9;

} // namespace

ToolRest::ToolRest(ContactIndexPtr part, const CutterProfile& cutter, double more_than,
                   const Progress& progress)
    : part_(std::move(part)), lift_(part_, cutter),
      needle_(part_, CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height))),
      cover_(cutter, level_share * more_than), radius_(cutter.max_radius()), more_than_(more_than) {
    if (!(more_than > 0))
        throw Error(ErrorCode::out_of_range, "more_than", "the amount is not above 0",
                    "name a positive length");
    const Box3 box = part_->mesh().box();
    const Vec2 size = (box.hi - box.lo).head<2>();
    const auto places = [&](double spacing) { return (size.x() / spacing + 3) * (size.y() / spacing + 3); };
    const double wanted = std::min(usual_share * radius_, even_spacing(radius_, more_than_));
    const double coarsest = coarsest_share * radius_;
    if (places(coarsest) > max_places)
        throw Error(ErrorCode::limit_exceeded, "",
                    "the tool is so small against the part that its rest cannot be looked for in "
                        + std::to_string(std::size_t(max_places)) + " places",
                    "name a larger tool");
    spacing_ = std::clamp(std::sqrt(size.x() * size.y() / free_places), 1e-3 * radius_, wanted);
    while (places(spacing_) > max_places)
        spacing_ *= 1.05;
    columns_ = std::size_t(std::ceil(size.x() / spacing_)) + 3;
    rows_ = std::size_t(std::ceil(size.y() / spacing_)) + 3;
    lo_ = box.center().head<2>() - 0.5 * spacing_ * Vec2(double(columns_ - 1), double(rows_ - 1));
    tip_spacing_ = std::max(spacing_, wanted);
    find_tips(progress);
}

void ToolRest::find_tips(const Progress& progress) {
    const Box3 box = part_->mesh().box();
    const auto count = [&](double length) {
        return int(std::ceil((length + 2 * radius_) / tip_spacing_)) + 3;
    };
    tip_columns_ = count(box.hi.x() - box.lo.x());
    tip_rows_ = count(box.hi.y() - box.lo.y());
    tips_lo_ = box.center().head<2>() - 0.5 * tip_spacing_ * Vec2(tip_columns_ - 1, tip_rows_ - 1);
    const std::size_t columns = std::size_t(tip_columns_), count_all = columns * std::size_t(tip_rows_);
    std::vector<Vec2> at(count_all);
    for (std::size_t i = 0; i < count_all; ++i)
        at[i] = tip_place(int(i % columns), int(i / columns));
    tips_.resize(count_all);
    lift_.tip_z(at, tips_, progress);
    tile_columns_ = (tip_columns_ + tile - 1) / tile;
    tile_rows_ = (tip_rows_ + tile - 1) / tile;
    tile_lowest_.assign(std::size_t(tile_columns_) * std::size_t(tile_rows_), infinity);
    for (std::size_t i = 0; i < count_all; ++i) {
        double& lowest = tile_lowest_[(i / columns / tile) * std::size_t(tile_columns_) + i % columns / tile];
        lowest = std::min(lowest, tips_[i]);
    }
}

double ToolRest::over(const Vec3& q, const Vec2& tip, double tip_z) const {
    return tip_z + lift_.profile().height_at((q.head<2>() - tip).norm()) - q.z();
}

/// The lowest of the tips on the grid, on each side of the place; tiles that cannot be lower are passed over,
/// and none is asked once one is low enough.
void ToolRest::look_on_grid(Place& place) const {
    const Vec2 mid = (place.over.head<2>() - tips_lo_) / tip_spacing_;
    const double reach = radius_ / tip_spacing_, enough = -enough_share * more_than_;
    const auto tile_of = [](double x, int count) {
        return std::clamp(int(std::floor(x)) / tile, 0, count - 1);
    };
    const int from_x = tile_of(mid.x() - reach, tile_columns_),
              to_x = tile_of(mid.x() + reach, tile_columns_), from_y = tile_of(mid.y() - reach, tile_rows_),
              to_y = tile_of(mid.y() + reach, tile_rows_);
    std::array<double, sides> lowest{};
    lowest.fill(infinity);
    place.beside.fill(place.tip);
    for (int ty = from_y; ty <= to_y; ++ty)
        for (int tx = from_x; tx <= to_x; ++tx) {
            const int c0 = tx * tile, r0 = ty * tile, c1 = std::min(c0 + tile, tip_columns_) - 1,
                      r1 = std::min(r0 + tile, tip_rows_) - 1;
            const Vec2 nearest(std::clamp(mid.x(), double(c0), double(c1)),
                               std::clamp(mid.y(), double(r0), double(r1)));
            const double least = tile_lowest_[std::size_t(ty) * std::size_t(tile_columns_) + std::size_t(tx)];
            if (over(place.over, tips_lo_ + tip_spacing_ * nearest, least)
                >= *std::max_element(lowest.begin(), lowest.end()))
                continue;
            for (int row = r0; row <= r1; ++row)
                for (int column = c0; column <= c1; ++column) {
                    const Vec2 tip = tip_place(column, row);
                    const double here =
                        over(place.over, tip,
                             tips_[std::size_t(row) * std::size_t(tip_columns_) + std::size_t(column)]);
                    const std::size_t side = (column > mid.x() ? 1 : 0) + (row > mid.y() ? 2 : 0);
                    if (here >= lowest[side]) continue;
                    lowest[side] = here;
                    place.beside[side] = tip;
                    place.lack = std::min(place.lack, here);
                }
            if (place.lack <= enough) return;
        }
}

/// At the foot of a wall the cutter holds a place with its rim or not at all: tips are looked at from which
/// it does so. Then from the best so far on every side by ever smaller steps: in an inner corner the one
/// place where the cutter reaches farthest lies between those of the grid.
void ToolRest::look_closer(Place& place) const {
    static constexpr std::array<std::array<double, 2>, 8> directions{
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    LiftHint hint;
    const auto height = [&](const Vec2& tip) {
        return over(place.over, tip, lift_.tip_z(tip.x(), tip.y(), hint));
    };
    const Vec2 at = place.over.head<2>();
    for (int k = 0; k < rim_places && place.lack > 0; ++k) {
        const double angle = 2 * pi * k / rim_places;
        const Vec2 out(std::cos(angle), std::sin(angle));
        place.lack = std::min(place.lack, height(at + just_within * radius_ * out));
    }
    const auto descend = [&](Vec2 tip) {
        double lowest = height(tip), step = 0.5 * tip_spacing_;
        for (int halved = 0, steps = 0; halved < halvings && steps < max_steps && lowest > 0; ++steps) {
            const Vec2 from = tip;
            for (const auto& [x, y] : directions) {
                const Vec2 next = from + step * Vec2(x, y);
                const double here = height(next);
                if (here >= lowest) continue;
                lowest = here;
                tip = next;
            }
            if (tip != from) continue;
            step *= 0.5;
            ++halved;
        }
        place.lack = std::min(place.lack, lowest);
    };
    if (place.lack > 0) descend(place.tip);
    for (std::size_t side = 0; side < sides && place.lack > 0; ++side)
        descend(place.beside[side]);
}

ToolRest::Place ToolRest::look(const Vec2& p) const {
    Place place;
    const AxialContact top = needle_.contact(p.x(), p.y());
    if (top.tip_z == -infinity || top.facet == no_index) return place;
    Vec3 n = part_->mesh().facet_normal(top.facet);
    if (n.z() < 0) n = -n; // seen from above
    const Vec3 on(p.x(), p.y(), top.tip_z);
    place.over = on + more_than_ * n;
    // Where it would stand were the part even here.
    place.tip = (on + cover_.tip_offset(n)).head<2>();
    place.lack = over(place.over, place.tip, lift_.tip_z(place.tip.x(), place.tip.y()));
    if (place.lack > -enough_share * more_than_) look_on_grid(place);
    return place;
}

double ToolRest::lack(const Vec2& p) const {
    Place place = look(p);
    look_closer(place);
    return place.lack;
}

/// Of all places, with -enough_share of the amount where it is lower. Where the border is is looked for
/// closer: from places where nothing is left on, as long as a closer look finds more of them.
std::vector<double> ToolRest::lacks(const Progress& progress) const {
    std::vector<double> lacks(columns_ * rows_, -enough_share * more_than_);
    parallel_for(rows_ - 2, 1, progress.part(0, 0.6), [&](std::size_t row) {
        for (std::size_t column = 1; column + 1 < columns_; ++column) {
            double& lack = lacks[(row + 1) * columns_ + column];
            lack = std::max(lack, look(place_at(column, row + 1)).lack);
        }
    });
    std::vector<char> seen(lacks.size(), 0);
    std::vector<std::size_t> next;
    const auto add_beside = [&](std::size_t i) {
        for (const std::size_t k : neighbors(i))
            if (lacks[k] > 0 && !seen[k]) {
                seen[k] = 1;
                next.push_back(k);
            }
    };
    for (std::size_t row = 1; row + 1 < rows_; ++row)
        for (std::size_t i = row * columns_ + 1; i + 1 < (row + 1) * columns_; ++i)
            if (lacks[i] <= 0) add_beside(i);
    while (!next.empty()) {
        const std::vector<std::size_t> now = std::exchange(next, {});
        parallel_for(now.size(), 64, progress.part(0.6, 1), [&](std::size_t k) {
            lacks[now[k]] =
                std::max(-enough_share * more_than_, lack(place_at(now[k] % columns_, now[k] / columns_)));
        });
        for (const std::size_t i : now)
            if (lacks[i] <= 0) add_beside(i);
    }
    drop_specks(lacks);
    return lacks;
}

/// A single place that the cutter all but reaches is no region that anybody would cut.
void ToolRest::drop_specks(std::vector<double>& lacks) const {
    std::vector<std::size_t> specks;
    for (std::size_t row = 1; row + 1 < rows_; ++row)
        for (std::size_t i = row * columns_ + 1; i + 1 < (row + 1) * columns_; ++i) {
            if (!(lacks[i] > 0) || lacks[i] > more_than_) continue;
            const auto beside = neighbors(i);
            if (std::all_of(beside.begin(), beside.end(), [&](std::size_t k) { return lacks[k] <= 0; }))
                specks.push_back(i);
        }
    for (const std::size_t i : specks)
        lacks[i] = -enough_share * more_than_;
}

std::vector<PlanEdge> ToolRest::outline(const Progress& progress) const {
    const std::vector<double> lacks = this->lacks(progress);
    using Corner = std::array<std::size_t, 2>;
    const auto value = [&](const Corner& at) { return lacks[at[1] * columns_ + at[0]]; };
    // From the lower place to the other, so that both cells beside an edge get the same point. Far above 0
    // the height says little of where the border is: what is left ends within a few times the amount.
    const auto crossing = [&](Corner a, Corner b) {
        if (b < a) std::swap(a, b);
        const double most = enough_share * more_than_, fa = std::min(value(a), most),
                     fb = std::min(value(b), most), t = fa / (fa - fb);
        const Vec2 from = place_at(a[0], a[1]), to = place_at(b[0], b[1]);
        return Vec2(from + t * (to - from));
    };
    std::vector<PlanEdge> edges;
    for (std::size_t row = 0; row + 1 < rows_; ++row)
        for (std::size_t column = 0; column + 1 < columns_; ++column) {
            // Corners counter-clockwise; an edge leaves the cell where the next corner is no longer in.
            const std::array<Corner, 4> corners{
                {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}}};
            std::array<bool, 4> in{};
            double sum = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const double f = value(corners[k]);
                in[k] = f > 0;
                sum += std::min(f, enough_share * more_than_);
            }
            for (std::size_t k = 0; k < 4; ++k) {
                if (!in[k] || in[(k + 1) % 4]) continue;
                // Out here. In again where the last corner before was not in: round one corner, or, with two
                // opposite corners in and the middle too, round what is out.
                const bool opposite = in[(k + 2) % 4] && !in[(k + 3) % 4];
                std::size_t back = k;
                if (opposite && sum > 0) {
                    back = (k + 2) % 4;
                } else {
                    while (in[(back + 3) % 4])
                        back = (back + 3) % 4;
                }
                edges.push_back({crossing(corners[k], corners[(k + 1) % 4]),
                                 crossing(corners[back], corners[(back + 3) % 4])});
            }
        }
    return edges;
}

} // namespace facetmill
