#include "tests/bench/least_time.h"

#include "core/strategy/five_axis/strip_width.h"
#include "core/strategy/five_axis/tilted_stepover.h"
#include "tests/bench/sampled_surface.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace facetmill {

namespace {

/// Directions of travel, over half a turn; each is gone both ways.
constexpr int directions = 12;
/// In radii of the cutter: distance of the planes that are looked at and of the surface's samples, and how
/// far a contact speaks for these.
constexpr double plane_share = 0.2, sample_share = 0.1, reach_share = 0.25;
/// A strip is no wider on the surface than this many times what it is seen from above.
constexpr double steepest = 0.01;

/// Full strip of a ball where the part is hollow across the travel by `hollowness`, 1/mm.
double ball_strip(double diameter, double hollowness, double cusp) {
    const double difference = 2 / diameter - hollowness;
    return difference * diameter * diameter > 8 * cusp ? std::sqrt(8 * cusp / difference) : diameter;
}

/// The widest strips of both tools at a sample, mm; 0: no contact came near.
struct Strips {
    double flat = 0, ball = 0;

    void widen(const Strips& by) {
        flat = std::max(flat, by.flat);
        ball = std::max(ball, by.ball);
    }
};

class Search {
public:
    Search(const PlanContext& context, const Finish5Settings& settings, double ball_diameter,
           const Progress& progress)
        : settings_(settings), surface_(context, sample_share, reach_share, progress),
          ball_diameter_(ball_diameter) {}

    LeastTime run(const Progress& progress) {
        LeastTime least;
        least.straight_seconds = infinity;
        std::vector<Strips> best(surface_.samples.size());
        for (int d = 0; d < directions; ++d) {
            const double angle = pi * d / directions;
            const std::vector<Strips> own =
                along(angle, progress.part(double(d) / directions, double(d + 1) / directions));
            double seconds = 0;
            for (std::size_t i = 0; i < surface_.samples.size(); ++i) {
                best[i].widen(own[i]);
                seconds += seconds_of(i, std::max(own[i].flat, own[i].ball));
            }
            if (!(seconds < least.straight_seconds)) continue;
            least.straight_seconds = seconds;
            least.direction = angle;
        }
        for (std::size_t i = 0; i < surface_.samples.size(); ++i) {
            const auto [flat, ball] = best[i];
            const double seconds = seconds_of(i, std::max(flat, ball));
            least.area += surface_.samples[i].area;
            least.seconds += seconds;
            least.ball_alone_seconds += seconds_of(i, ball);
            if (flat > ball) continue;
            least.ball_area += surface_.samples[i].area;
            least.ball_seconds += seconds;
        }
        return least;
    }

private:
    /// Where no contact came near, the strip is as wide as the cutter.
    double seconds_of(std::size_t sample, double width) const {
        return surface_.samples[sample].area / (width > 0 ? width : 2 * surface_.radius)
               / (settings_.feed / 60);
    }

    std::vector<Strips> along(double angle, const Progress& progress) const {
        Finish5Settings settings = settings_;
        settings.direction = {angle, ""};
        const FiveAxisField field(surface_.context, settings, progress.part(0, 0.2));
        const TiltedStepOver widths(field);
        const auto& lines = field.lines();
        const double reach = reach_share * surface_.radius, cusp = field.cusp() - field.chord();
        const long step = std::max(1L, std::lround(plane_share * surface_.radius / lines.spacing()));
        const long end = lines.beyond(lines.hi(), lines.lo());
        std::vector<Strips> best(surface_.samples.size());
        for (long plane = 1; plane < end; plane += step)
            for (const int travel : {1, -1}) {
                const EstimatedPass pass = widths.widest(plane, travel, progress.part(0.2, 1));
                for (const auto& contacts : pass.contacts)
                    for (const auto& c : contacts) {
                        const Strips here{c.usable ? flat_width(c, field, widths) : 0,
                                          ball_strip(ball_diameter_, field.hollowness(c.place), cusp)};
                        surface_.grid.near(c.place.surface, reach, [&](std::size_t i) {
                            if ((surface_.samples[i].point - c.place.surface).squaredNorm() <= reach * reach
                                && surface_.samples[i].normal.dot(c.place.frame.normal) > 0)
                                best[i].widen(here);
                        });
                    }
            }
        return best;
    }

    /// On the surface; where that ends within the strip, it is as wide as it can be.
    double flat_width(const EstimatedContact& c, const FiveAxisField& field,
                      const TiltedStepOver& widths) const {
        const double from_above =
            std::min((c.width_lo + c.width_hi) / StripWidth::used_width, widths.passes().largest_step());
        const double slope = std::abs(field.drive().v(c.place.frame.left));
        return std::min(from_above / std::max(slope, steepest), 2 * surface_.radius);
    }

    const Finish5Settings& settings_;
    SampledSurface surface_;
    double ball_diameter_;
};

} // namespace

LeastTime least_time(const PlanContext& context, const Finish5Settings& settings, double ball_diameter,
                     const Progress& progress) {
    return Search(context, settings, ball_diameter, progress.part(0, 0.02)).run(progress.part(0.02, 1));
}

} // namespace facetmill
