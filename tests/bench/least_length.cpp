#include "tests/bench/least_length.h"

#include "core/strategy/five_axis/contact_widths.h"
#include "core/strategy/five_axis/strip_width.h"
#include "tests/bench/sampled_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <tuple>

namespace facetmill {

namespace {

constexpr int direction_count = 8;
/// In radii of the cutter: distance of the samples and of the places that are looked at, and how far a place
/// may be from the sample that it speaks for: where it is steep planes are far apart on the surface.
constexpr double place_share = 0.4, speaks_share = 1;
/// How far the best strip may be from what it clears, in radii.
constexpr double near_share = 0.5;
/// Of a slope across the travel, and of a strip in radii to both sides, as passes are placed.
constexpr double least_slope = 0.01, least_width = 1.0 / 20;
/// How fast strips get wider along the travel.
const double spread = std::tan(radians(15));

class LengthSearch {
public:
    LengthSearch(const PlanContext& context, const Finish5Settings& settings, const Progress& progress)
        : settings_(settings), surface_(context, place_share, speaks_share, progress) {
        PlanContext& own = surface_.context;
        if (!own.curvatures)
            own.curvatures = std::make_shared<std::vector<VertexCurvature>>(
                vertex_curvatures(*own.part, own.geometry->vertex_normals, progress));
    }

    LeastLength run(const Progress& progress) {
        LeastLength least;
        least.straight = least.straight_steady = infinity;
        std::vector<double> free(surface_.samples.size(), 0), steady = free;
        for (int d = 0; d < direction_count; ++d) {
            const double angle = pi * d / direction_count;
            const std::vector<double> own =
                along(angle, progress.part(double(d) / direction_count, double(d + 1) / direction_count));
            const std::vector<double> slow = held_by_neighbours(own, angle);
            const double length = length_by(own);
            if (length < least.straight) {
                least.straight = length;
                least.straight_direction = angle;
            }
            least.straight_steady = std::min(least.straight_steady, length_by(slow));
            for (std::size_t i = 0; i < surface_.samples.size(); ++i) {
                free[i] = std::max(free[i], own[i]);
                steady[i] = std::max(steady[i], slow[i]);
            }
        }
        for (std::size_t i = 0; i < surface_.samples.size(); ++i)
            if (free[i] > 0) least.area += surface_.samples[i].area;
        least.free = length_by(free);
        least.steady = length_by(steady);
        std::vector<double> near = free;
        const double reach = near_share * surface_.radius;
        for (std::size_t i = 0; i < surface_.samples.size(); ++i)
            if (free[i] > 0)
                surface_.grid.near(surface_.samples[i].point, reach, [&](std::size_t k) {
                    if (beside(i, k, reach)) near[i] = std::max(near[i], free[k]);
                });
        least.near = length_by(near);
        return least;
    }

private:
    /// Places without a strip are not cut and take nothing.
    double length_by(const std::vector<double>& widths) const {
        double length = 0;
        for (std::size_t i = 0; i < surface_.samples.size(); ++i)
            if (widths[i] > 0) length += surface_.samples[i].area / widths[i];
        return length;
    }

    bool beside(std::size_t i, std::size_t k, double reach) const {
        return (surface_.samples[i].point - surface_.samples[k].point).squaredNorm() <= reach * reach
               && surface_.samples[i].normal.dot(surface_.samples[k].normal) > 0;
    }

    /// Of every sample the strip on the surface, mm, in that direction; 0: no posture serves.
    std::vector<double> along(double angle, const Progress& progress) const {
        Finish5Settings settings = settings_;
        settings.direction = {angle, ""};
        const FiveAxisField field(surface_.context, settings, progress.part(0, 0.2));
        const ContactWidths widths(field, 0);
        const auto& lines = field.lines();
        const double apart = place_share * surface_.radius, reach = speaks_share * surface_.radius;
        const long step = std::max(1L, std::lround(apart / lines.spacing()));
        const long end = lines.beyond(lines.hi(), lines.lo());
        std::vector<double> best(surface_.samples.size(), 0), nearest(surface_.samples.size(), infinity);
        for (long plane = 1; plane < end; plane += step) {
            std::array<std::vector<EstimatedContact>, 2> ways;
            for (const SurfaceLine& line : lines.lines(lines.v(plane))) {
                const auto pieces = std::max(1L, std::lround(line.length() / apart));
                for (const std::size_t way : {0, 1})
                    for (long k = 0; k < pieces; ++k)
                        ways[way].push_back(
                            {.place = field.place(line, line.length() * (double(k) + 0.5) / double(pieces),
                                                  lines.v(plane), way == 0 ? 1 : -1)});
            }
            for (auto& contacts : ways)
                widths.find(contacts, 2 * StripWidth::max_width(field), progress.part(0.2, 1));
            for (std::size_t c = 0; c < ways[0].size(); ++c) {
                const double strip = std::max(strip_of(ways[0][c], field), strip_of(ways[1][c], field));
                const ContactPlace& place = ways[0][c].place;
                surface_.grid.near(place.surface, reach, [&](std::size_t i) {
                    const double away = (surface_.samples[i].point - place.surface).norm();
                    if (!(away < std::min(nearest[i], reach))
                        || !(surface_.samples[i].normal.dot(place.frame.normal) > 0))
                        return;
                    nearest[i] = away;
                    best[i] = strip;
                });
            }
        }
        return best;
    }

    double strip_of(const EstimatedContact& c, const FiveAxisField& field) const {
        if (!c.usable) return 0;
        const double from_above = std::min(c.width_lo + c.width_hi, 2 * StripWidth::max_width(field));
        return std::clamp(from_above / std::max(std::abs(field.across(c.place)), least_slope),
                          least_width * surface_.radius, 2 * surface_.radius);
    }

    /// Strips no wider than those before and behind along the travel, and what passes spread by from there.
    std::vector<double> held_by_neighbours(const std::vector<double>& widths, double angle) const {
        const Vec3 travel(std::cos(angle), std::sin(angle), 0), across(-travel.y(), travel.x(), 0);
        struct Stop {
            long row;
            double u;
            std::size_t sample;
        };
        std::vector<Stop> stops;
        for (std::size_t i = 0; i < surface_.samples.size(); ++i)
            if (widths[i] > 0)
                stops.push_back(
                    {std::lround(surface_.samples[i].point.dot(across) / (place_share * surface_.radius)),
                     surface_.samples[i].point.dot(travel), i});
        std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) {
            return std::tie(a.row, a.u, a.sample) < std::tie(b.row, b.u, b.sample);
        });
        std::vector<double> held = widths;
        const auto hold = [&](const Stop& stop, const Stop& by) {
            if (stop.row != by.row) return;
            const double away =
                (surface_.samples[stop.sample].point - surface_.samples[by.sample].point).norm();
            held[stop.sample] = std::min(held[stop.sample], held[by.sample] + spread * away);
        };
        for (std::size_t k = 1; k < stops.size(); ++k)
            hold(stops[k], stops[k - 1]);
        for (std::size_t k = stops.size(); k-- > 1;)
            hold(stops[k - 1], stops[k]);
        return held;
    }

    const Finish5Settings& settings_;
    SampledSurface surface_;
};

} // namespace

LeastLength least_length(const PlanContext& context, const Finish5Settings& settings,
                         const Progress& progress) {
    return LengthSearch(context, settings, progress.part(0, 0.02)).run(progress.part(0.02, 1));
}

} // namespace facetmill
