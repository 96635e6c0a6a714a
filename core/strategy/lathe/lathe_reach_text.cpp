#include "core/base/tolerances.h"
#include "core/strategy/lathe/lathe_reach.h"
#include "core/strategy/plan/plan_text.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace facetmill {

namespace {

/// Regions that a warning names.
constexpr std::size_t max_named = 3;

/// "12° to 35°, 10 to 14 mm": angle and place along the axis.
std::string place_text(const UnreachedRegion& r, LengthUnit unit) {
    const auto angle = [](double v) { return format_number(std::round(10 * degrees(v)) / 10, 4) + "°"; };
    const auto length = [&](double mm) { return format_number(mm / mm_per(unit), 4); };
    const std::string turn = r.angle_to - r.angle_from >= 2 * pi - tolerance::level_angle
                                 ? std::string("all around")
                                 : angle(r.angle_from) + " to " + angle(r.angle_to);
    return turn + ", " + length(r.from) + " to " + length_text(r.to, unit) + " along the axis";
}

} // namespace

const char* unreached_name(UnreachedRegion::Why why) {
    switch (why) {
    case UnreachedRegion::Why::narrow:
        return "narrow";
    case UnreachedRegion::Why::covered:
        return "covered";
    case UnreachedRegion::Why::shaft:
        return "shaft";
    case UnreachedRegion::Why::core:
        return "core";
    case UnreachedRegion::Why::held:
        return "held";
    }
    return "";
}

std::vector<std::string> reach_warnings(const LatheReach& reach, LengthUnit unit) {
    using Why = UnreachedRegion::Why;
    std::vector<std::string> warnings;
    for (const auto& [why, what, remedy] :
         {std::tuple(Why::narrow, "the cutter is too large for hollows of the part",
                     "use a smaller tool there"),
          std::tuple(Why::covered, "places lie under the part itself, seen along the tool",
                     "cut them with the part held another way"),
          std::tuple(Why::shaft, "shank or holder keep the cutter from hollows of the part",
                     "use a longer tool, or less holder clearance"),
          std::tuple(Why::core, "the core radius keeps the cutter from the part",
                     "choose a smaller core radius"),
          std::tuple(Why::held, "chuck or tailstock keep the cutter from the part",
                     "hold less of the stock, or take a smaller tool or clearance")}) {
        double area = 0, most = 0;
        std::size_t regions = 0;
        std::string places;
        for (const UnreachedRegion& r : reach.regions) {
            if (r.why != why) continue;
            area += r.area;
            most = std::max(most, r.distance);
            if (regions++ >= max_named) continue;
            places += (places.empty() ? "" : "; ") + place_text(r, unit);
        }
        if (regions == 0) continue;
        if (regions > max_named) {
            const std::string rest = "and " + std::to_string(regions - max_named) + " more";
            places += "; " + rest;
        }
        const double per = mm_per(unit);
        warnings.push_back(std::string(what) + ": " + format_number(area / (per * per), 3) + " "
                           + std::string(unit_name(unit)) + "² (" + share_text(area, reach.area)
                           + " of the surface), where it stays up to " + length_text(most, unit)
                           + " away, at " + places + ": " + remedy);
    }
    return warnings;
}

} // namespace facetmill
