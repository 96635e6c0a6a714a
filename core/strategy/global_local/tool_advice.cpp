#include "core/strategy/global_local/tool_advice.h"

#include "core/strategy/surface/point_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace facetmill {

namespace {

/// No strip is wider than this share of the diameter.
constexpr double widest_share = 0.97;
/// What turning round at the end of a pass costs, in diameters. The tip of a flat end is a radius behind its
/// contact in either direction.
constexpr double turn_share = 1;
/// Curvatures below this share of the scallop over the radius squared are none.
constexpr double flat_share = 1e-3;
/// Neighbours in a region are no farther apart, in spacings.
constexpr double neighbor_share = 1.6;
/// Diameters that are compared, in shares of the tool's own; lead limits, in degrees.
constexpr std::array<double, 9> diameter_shares{0.25, 0.375, 0.5, 0.625, 0.75, 1, 1.25, 1.5, 2};
constexpr std::array<double, 14> lead_degrees{1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40};

/// The curvature that a contact's lead stands for, (4).
double effective_curvature(const AssumedContact& c, double source_diameter) {
    return std::isfinite(c.lead) ? 2 * std::sin(c.lead) / source_diameter : infinity;
}

/// Full width of a strip where tool and part differ in curvature by this.
double strip_width(double difference, double scallop, double diameter) {
    const double widest = widest_share * diameter;
    if (!(difference > flat_share * 8 * scallop / (widest * widest))) return widest;
    return std::min(widest, 2 * std::sqrt(2 * scallop / difference));
}

} // namespace

double largest_diameter(double lead, double curvature) {
    return curvature > 0 ? 2 * std::sin(lead) / curvature : infinity;
}

double lead_for(double diameter, double curvature) {
    const double sine = 0.5 * diameter * curvature;
    return sine >= 1 ? 0.5 * pi : std::asin(std::max(sine, 0.0));
}

double widest_strip(double radius_of_curvature, double scallop) {
    return 2 * std::sqrt(2 * scallop * radius_of_curvature);
}

StrategyEstimate estimate(const RegionSource& source, double source_diameter, double diameter,
                          double lead_limit, double rework_diameter, double scallop, double feed) {
    const auto& contacts = source.assumed.contacts;
    const double spacing = source.assumed.spacing;
    const Vec3 across = Vec3::UnitZ().cross(source.assumed.travel);
    StrategyEstimate e;
    e.diameter = diameter;
    e.lead_limit = lead_limit;
    std::vector<Vec3> uncut;
    double area = 0, uncut_area = 0;
    const double per_second = feed / 60;
    for (std::size_t start = 0; start < contacts.size(); start = contacts[start].end + 1) {
        double cut = 0, length = 0;
        for (std::size_t i = start; i <= contacts[start].end; ++i) {
            const AssumedContact& c = contacts[i];
            // A level step of one spacing takes so much of the surface.
            const double slanted = std::sqrt(std::max(1e-4, 1 - std::pow(c.normal.dot(across), 2)));
            const double piece = i < contacts[start].end ? contacts[i + 1].s - c.s : 0;
            const double own = spacing * piece / slanted;
            area += own;
            const double curvature = effective_curvature(c, source_diameter);
            if (lead_for(diameter, curvature) > lead_limit) {
                uncut.push_back(c.point);
                uncut_area += own;
                const double width =
                    strip_width(2 / rework_diameter - c.hollowness, scallop, rework_diameter);
                e.rework_seconds += own / width / per_second;
                continue;
            }
            length += piece;
            cut += own / strip_width(std::max(curvature, 0.0) - c.hollowness, scallop, diameter);
        }
        // As many passes as the strips' mean width asks for, each turned at its end.
        if (length > 0) e.main_seconds += cut * (1 + turn_share * diameter / length) / per_second;
    }
    e.rework_share = area > 0 ? uncut_area / area : 0;
    // Uncut contacts that are neighbours belong to one region.
    std::vector<std::size_t> parent(uncut.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto root = [&](std::size_t i) {
        while (parent[i] != i)
            i = parent[i] = parent[parent[i]];
        return i;
    };
    const double reach = neighbor_share * spacing;
    const PointGrid grid(uncut, reach);
    for (std::size_t i = 0; i < uncut.size(); ++i)
        grid.near(uncut[i], reach, [&](std::size_t k) {
            if (k >= i || (uncut[k] - uncut[i]).squaredNorm() > reach * reach) return;
            const std::size_t a = root(i), b = root(k);
            parent[std::max(a, b)] = std::min(a, b);
        });
    for (std::size_t i = 0; i < uncut.size(); ++i)
        e.regions += parent[i] == i;
    return e;
}

ToolAdvice tool_advice(const RegionSource& source, double diameter, const GlobalLocalSettings& settings,
                       double rework_diameter, const Progress& progress) {
    ToolAdvice advice;
    std::vector<double> hollow, round;
    for (const AssumedContact& c : source.assumed.contacts) {
        if (c.hollowness > 0) hollow.push_back(c.hollowness);
        if (c.hollowness < 0) round.push_back(-c.hollowness);
    }
    const auto at = [](std::vector<double>& values, double share) {
        if (values.empty()) return 0.0;
        const auto place = values.begin() + long(share * double(values.size() - 1));
        std::nth_element(values.begin(), place, values.end());
        return *place;
    };
    advice.curvature_half = at(hollow, 0.5);
    advice.curvature_max = at(hollow, 0.95);
    advice.curvature_largest = at(hollow, 1);
    advice.diameter = largest_diameter(settings.lead_limit, advice.curvature_max);
    const double half_round = at(round, 0.5);
    advice.strip_convex = half_round > 0 ? widest_strip(1 / half_round, settings.tolerance) : infinity;
    const auto estimated = [&](double d, double lead) {
        progress.check();
        return estimate(source, diameter, d, lead, rework_diameter, settings.tolerance, settings.feed);
    };
    std::vector<double> leads;
    for (const double lead : lead_degrees)
        if (radians(lead) <= settings.assumed_lead_limit) leads.push_back(radians(lead));
    for (const double lead : leads)
        advice.by_lead.push_back(estimated(diameter, lead));
    bool first = true;
    for (const double share : diameter_shares) {
        const double d = share * diameter;
        advice.by_diameter.push_back(estimated(d, settings.lead_limit));
        for (const double lead : leads) {
            const StrategyEstimate e = estimated(d, lead);
            if (first || e.seconds() < advice.best.seconds()) advice.best = e;
            first = false;
        }
    }
    return advice;
}

} // namespace facetmill
