#include "core/strategy/global_local/find_regions.h"

#include "core/strategy/global_local/tool_advice.h"
#include "core/strategy/surface/travel_direction.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Distance of the trajectories, in radii of the main cutter; no more contacts than about the number.
constexpr double spacing_share = 1.0 / 8, max_study_contacts = 400'000;
/// Diameter of a rework tool that is not known yet, in diameters of the main tool.
constexpr double usual_rework_share = 0.25;
/// Motion of (10), (11) is judged along the machining direction only where the two go along by this.
constexpr double along_share = 0.1;

void check_regions(const RegionSource& source, const GlobalLocalSettings& settings, LengthUnit unit) {
    if (!(settings.lead_limit > 0))
        throw Error(ErrorCode::out_of_range, "lead_limit",
                    "a lead limit of 0 leaves the main path no hollows", "enter an angle above 0");
    if (settings.lead_limit > settings.assumed_lead_limit)
        throw Error(ErrorCode::out_of_range, "lead_limit",
                    "the lead limit " + angle_text(settings.lead_limit)
                        + " is above that of the assumed path, " + angle_text(settings.assumed_lead_limit),
                    "lower it, or raise the assumed lead limit");
    const Vec3 size = source.part->box().size();
    if (settings.rework_offset > std::max(size.x(), size.y()))
        throw Error(ErrorCode::out_of_range, "rework_offset",
                    "the offset of " + length_text(settings.rework_offset, unit)
                        + " is larger than the part, which is " + length_text(size.x(), unit) + " by "
                        + length_text(size.y(), unit),
                    "enter a smaller length");
}

AssumedPath assumed_along(const PlanContext& context, Finish5Settings settings, double direction,
                          const Progress& progress) {
    settings.direction = {direction, ""};
    const FiveAxisField field(context, settings, progress.part(0, 0.3));
    if (!(field.lines().lo() <= field.lines().hi()))
        throw Error(ErrorCode::empty_result, settings.name, "no drive plane meets the part",
                    "check part and direction");
    return assume_path(field, trajectory_spacing(context.part_box, field.radius()), progress.part(0.3, 1));
}

} // namespace

double trajectory_spacing(const Box3& part, double radius) {
    const Vec3 size = part.size();
    return std::max(spacing_share * radius, std::sqrt(size.x() * size.y() / max_study_contacts));
}

std::string angle_text(double radians) {
    return format_number(degrees(radians), 3) + "°";
}

double machining_angle(const NumberOrWord& asked, double main) {
    if (asked.is_number()) return asked.number;
    return asked.is("x") ? 0 : asked.is("y") ? 0.5 * pi : main;
}

std::shared_ptr<const RegionSource>
region_source(const PlanContext& context, const GlobalLocalSettings& settings, const Progress& progress) {
    auto source = std::make_shared<RegionSource>();
    PlanContext own = context;
    if (!own.geometry) own.geometry = compute_geometry(*own.part, progress.part(0, 0.1));
    if (!own.curvatures)
        own.curvatures = std::make_shared<std::vector<VertexCurvature>>(
            vertex_curvatures(*own.part, own.geometry->vertex_normals, progress.part(0.1, 0.3)));
    source->part = own.part;
    source->geometry = own.geometry;
    source->curvatures = own.curvatures;
    Finish5Settings assumed = settings;
    assumed.lead_limits = {0, settings.assumed_lead_limit};
    if (!settings.direction.is("auto")) {
        source->assumed =
            assumed_along(own, assumed, travel_direction(settings.direction, own, progress.part(0.3, 0.3)),
                          progress.part(0.3, 1));
    } else {
        const double diameter = 2 * CutterProfile(own.tool.cutter()).max_radius();
        const double rework =
            own.further_tools.empty() ? usual_rework_share * diameter : own.further_tools[0].diameter;
        double least = infinity;
        for (const bool along_y : {false, true}) {
            RegionSource one = *source;
            one.assumed = assumed_along(own, assumed, along_y ? 0.5 * pi : 0,
                                        along_y ? progress.part(0.65, 1) : progress.part(0.3, 0.65));
            const double seconds = estimate(one, diameter, diameter, settings.lead_limit, rework,
                                            settings.tolerance, settings.feed)
                                       .seconds();
            if (!(seconds < least)) continue;
            least = seconds;
            *source = std::move(one);
        }
    }
    if (source->assumed.contacts.empty())
        throw Error(ErrorCode::empty_result, settings.name, "no place of the part can be come to from above",
                    "turn the part");
    return source;
}

FoundRegions find_regions(const RegionSource& source, const GlobalLocalSettings& settings, LengthUnit unit,
                          std::span<const UncutPlace> further, const Progress& progress) {
    check_regions(source, settings, unit);
    const Vec3 view(settings.view_direction[0], settings.view_direction[1], settings.view_direction[2]);
    const double angle = machining_angle(settings.machining_direction, source.assumed.direction);
    const DriveFrame frame(angle);
    Vec3 machining(frame.along.x(), frame.along.y(), 0);
    if (!(view.cross(machining).norm() > along_share * view.norm()))
        throw Error(ErrorCode::out_of_range, "view_direction",
                    "the view direction has no length or runs along the machining direction",
                    "look across it, as along 0, 0, 1");
    // Across the travel nothing is forward: then the travel itself is meant.
    if (std::abs(machining.dot(source.assumed.travel)) < along_share) machining = source.assumed.travel;
    ScreenedPath screened =
        screen(source.assumed, settings.lead_limit, settings.rework_offset, view, machining, progress);
    screened.uncut.insert(screened.uncut.end(), further.begin(), further.end());
    RegionInput input;
    input.part = source.part;
    input.geometry = source.geometry;
    input.curvatures = source.curvatures;
    input.spacing = source.assumed.spacing;
    input.offset = settings.rework_offset;
    input.edits = settings.region_edits;
    input.drags = settings.boundary_drags;
    FoundRegions found;
    found.regions = rework_regions(input, screened.uncut, progress);
    found.pairs = std::move(screened.pairs);
    assign_pairs(found.regions, found.pairs, progress);
    for (ReworkRegion& r : found.regions.regions) {
        r.strip.tool = settings.rework_tool;
        r.strip.reason = r.lead_largest > settings.assumed_lead_limit
                             ? "no lead up to " + angle_text(settings.assumed_lead_limit) + " is free"
                         : r.lead_largest > settings.lead_limit
                             ? "needs a lead of up to " + angle_text(r.lead_largest) + ", allowed are "
                                   + angle_text(settings.lead_limit)
                             : "left by the main path";
    }
    return found;
}

} // namespace facetmill
