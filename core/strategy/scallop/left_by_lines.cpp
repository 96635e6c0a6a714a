#include "core/strategy/scallop/left_by_lines.h"

#include "core/base/parallel.h"
#include "core/strategy/scallop/field_hollow.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t left_block = 256;
/// Lines so near, in usual distances, are looked for first, and no farther than so many.
constexpr double near_lines = 0.8, farthest_lines = 8;
/// A hollow counts where the cutter that touches both its flanks stays from their corner by so much of the
/// cusp. Lines may add the rest of the cusp to that, but no less than so much of it.
/// Crests are sharp: so often they are looked for on the half of the way to a place beside, where a place has
/// at least so much of the cusp and no less than its neighbours.
constexpr int crest_looks = 4;
constexpr double crest_from = 0.6;
constexpr double hollow_depth = 0.03, min_in_hollow = 0.4;
/// Places that tell of a step lie so far from the lines, in steps; between two of them in each row and column
/// one is passed over.
constexpr double telling_from = 0.3;
constexpr int telling_every = 2;
/// Gaps between flat bottoms have sharp borders: on surface as level as this they are looked for so much
/// farther from lines, of a place's width, so that none lies between places.
constexpr double level_normal = 1 - 1e-6, between_places = 0.71;
/// Of one round; none where what is left hardly depends on the distance of lines.
constexpr double min_power = 0.2;
constexpr double max_correction = 1.5;

/// How far along a piece, from 0 to 1, what is nearest to p lies.
double nearest_share(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    return std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-30), 0.0, 1.0);
}

} // namespace

LeftByLines::LeftByLines(const ScallopField& field, const CutterCover& cover, const AxialLift& lift,
                         double usual, const std::vector<FieldContour>& lines, const Progress& progress)
    : field_(field), cover_(cover), usual_(usual), middles_(usual) {
    std::vector<std::vector<Vec3>> tips(lines.size());
    parallel_for(lines.size(), 1, progress, [&](std::size_t k) {
        for (const Vec2& p : lines[k].places) {
            progress.check();
            tips[k].emplace_back(p.x(), p.y(), lift.tip_z(p.x(), p.y()));
        }
    });
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const std::vector<Vec3>& t = tips[k];
        for (std::size_t i = 0; i < t.size(); ++i) {
            if (i + 1 == t.size() && !lines[k].closed && i > 0) continue;
            const Vec3 &a = t[i], &b = t[(i + 1) % t.size()];
            if (!std::isfinite(a.z()) || !std::isfinite(b.z())) continue; // beside all of the part
            pieces_.push_back({a, b, k, i});
            middles_.add(0.5 * (pieces_.back().a + pieces_.back().b));
        }
    }
}

/// `left`: what is left over a touch.
template <class Left>
double LeftByLines::highest(std::size_t place, double cusp, const Left& left) const {
    const double here = left(field_.touch(place));
    const auto hollow = field_hollow(field_, place, cover_, hollow_depth * cusp);
    if (!hollow) return here;
    const double may_stay = std::max(1 - hollow->depth / cusp, min_in_hollow);
    return std::max(here, left(hollow->touch) / may_stay);
}

double LeftByLines::high(std::size_t place, double cusp) const {
    return highest(place, cusp, [&](const ScallopField::Touch& at) { return over(at, 2 * cusp); });
}

double LeftByLines::crest(std::size_t place, std::size_t before, std::size_t after, double enough) const {
    double most = 0;
    for (const std::size_t beside : {before, after})
        for (int k = 1; k <= crest_looks; ++k)
            if (const auto at = field_.between(place, beside, 0.5 * k / crest_looks))
                if (const double here = over(*at, enough); here < infinity) most = std::max(most, here);
    return most;
}

double LeftByLines::high_by(std::size_t place, double cusp, std::span<const Vec3> course) const {
    return highest(place, cusp, [&](const ScallopField::Touch& at) {
        double best = infinity;
        for (std::size_t i = 1; i < course.size(); ++i)
            best = std::min(best, entry(at, course[i - 1], course[i]));
        return best;
    });
}

double LeftByLines::entry(const ScallopField::Touch& at, const Vec3& a, const Vec3& b) const {
    const double t = nearest_share(at.tip, a, b);
    const Vec3 tip = a + t * (b - a);
    Vec3 point = at.point;
    if (field_.flat_bottom() && at.normal.z() > level_normal) {
        const Vec2 aside = (point - tip).head<2>();
        if (const double far = aside.norm(); far > 0)
            point.head<2>() += between_places * field_.spacing() / far * aside;
    }
    return cover_.ray_entry(point, at.normal, tip, 2 * cover_.radius());
}

double LeftByLines::over(const ScallopField::Touch& at, double enough) const {
    double best = infinity;
    for (double reach = near_lines * usual_; reach <= farthest_lines * usual_; reach *= 2) {
        middles_.near(at.tip, reach,
                      [&](std::size_t i) { best = std::min(best, entry(at, pieces_[i].a, pieces_[i].b)); });
        if (best <= enough) break;
    }
    return std::max(best, 0.0);
}

std::optional<LeftByLines::Near> LeftByLines::nearest(const Vec3& tip) const {
    std::optional<Near> best;
    double best2 = infinity;
    for (double reach = near_lines * usual_; reach <= farthest_lines * usual_ && !best; reach *= 2)
        middles_.near(tip, reach, [&](std::size_t i) {
            const auto& [a, b, line, number] = pieces_[i];
            const double t = nearest_share(tip, a, b);
            const Vec3 place = a + t * (b - a);
            const double d2 = (place - tip).squaredNorm();
            if (!(d2 < best2)) return;
            best2 = d2;
            best = Near{line, number, t, place};
        });
    return best;
}

std::vector<float> step_corrections(const ScallopField& field, const LeftByLines& left,
                                    const std::vector<double>& away, double cusp, const Progress& progress) {
    std::vector<float> correction(field.size(), 1), weight(field.size(), 0);
    parallel_blocks(field.size(), left_block, progress.part(0, 0.8), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto column = int(i % std::size_t(field.columns())),
                       row = int(i / std::size_t(field.columns()));
            if (!field.cut(i) || column % telling_every != 0 || row % telling_every != 0) continue;
            if (!(away[i] >= telling_from && away[i] < infinity)) continue;
            const double here = left.over(i, 2 * cusp);
            if (!(here < infinity)) continue;
            // Under a flat bottom nothing is left, however far apart lines are, and tells nothing.
            if (const double power = field.power(i); power >= min_power)
                correction[i] = float(std::clamp(std::pow(here / cusp, power) / (2 * away[i]),
                                                 1 / max_correction, max_correction));
            weight[i] = float(away[i] * away[i]);
        }
    });
    return field.smoothed(correction, weight, progress.part(0.8, 1));
}

namespace {

/// The two places beside one, on opposite sides, that are no higher than it and lowest of all such pairs.
std::optional<std::array<std::size_t, 2>> crest_across(const ScallopField& field,
                                                       const std::vector<double>& heights, std::size_t i) {
    const auto column = int(i % std::size_t(field.columns())), row = int(i / std::size_t(field.columns()));
    if (column == 0 || row == 0 || column + 1 == field.columns() || row + 1 == field.rows())
        return std::nullopt;
    std::optional<std::array<std::size_t, 2>> best;
    double least = infinity;
    for (const auto& [dc, dr] : {std::pair(1, 0), std::pair(1, 1), std::pair(0, 1), std::pair(-1, 1)}) {
        const std::size_t a = field.number(column + dc, row + dr), b = field.number(column - dc, row - dr);
        if (heights[a] > heights[i] || heights[b] > heights[i] || heights[a] + heights[b] >= least) continue;
        least = heights[a] + heights[b];
        best = {a, b};
    }
    return best;
}

} // namespace

std::vector<double> left_high(const ScallopField& field, const LeftByLines& left,
                              const std::vector<char>& asked, double cusp, const Progress& progress) {
    std::vector<double> high(field.size(), 0);
    parallel_blocks(field.size(), left_block, progress.part(0, 0.5), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (asked[i]) high[i] = std::min(left.high(i, cusp), 4 * cusp);
    });
    const std::vector<double> at_places = high;
    parallel_blocks(field.size(), left_block, progress.part(0.5, 1), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (at_places[i] < crest_from * cusp || at_places[i] > 2 * cusp) continue;
            if (const auto across = crest_across(field, at_places, i))
                high[i] = std::max(high[i], left.crest(i, (*across)[0], (*across)[1], 2 * cusp));
        }
    });
    return high;
}

} // namespace facetmill
