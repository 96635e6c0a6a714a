#include "core/strategy/tilt/tilted_record.h"

namespace facetmill {

namespace {

/// The grid of postures that is shown about a contact, and its largest lead: from 90 degrees on no cutter
/// touches.
constexpr double shown_step = pi / 30, max_shown_lead = pi * 88 / 180;
/// Points that are studied together: few, so that the first of them is shown at once.
constexpr std::size_t points_a_line = 400;

Finish5Settings shown_settings(const OperationCommon& settings, const TiltOptions& options) {
    Finish5Settings shown;
    static_cast<OperationCommon&>(shown) = settings;
    shown.grid_step = shown_step;
    shown.lead_limits = {0, max_shown_lead};
    shown.yaw_limits = {-pi, pi};
    shown.chord_tolerance = {options.chord, {}};
    shown.holder_clearance = options.allowance + options.holder_clearance;
    shown.max_tilt = options.limit;
    return shown;
}

/// `ball`: its radius. The contact is told from the ball's middle and the normal: locations that were put in
/// between two have none of their own.
FiveAxisRecord::Point point_at(double ball, const Vec3& normal, const CutterLocation& location,
                               const Vec3& travel, double allowance) {
    FiveAxisRecord::Point point;
    ContactPlace& place = point.place;
    const Vec3 touched = location.tip + ball * (location.axis - normal);
    place.surface = touched - allowance * normal;
    place.frame = ContactFrame::at(touched, normal, travel);
    point.choice = {true, posture_of_axis(place.frame, location.axis)};
    return point;
}

} // namespace

std::shared_ptr<const FiveAxisRecord> tilted_record(std::span<const Pass> passes,
                                                    const OperationCommon& settings,
                                                    const PlanContext& context, const TiltOptions& options,
                                                    const Progress& progress) {
    auto record = std::make_shared<FiveAxisRecord>();
    record->context = context;
    record->settings = shown_settings(settings, options);
    record->has_strips = false;
    record->pieces.push_back({context, Mat3::Identity(), record->settings.lead_limits});
    const double ball = ball_radius(CutterProfile(context.tool.cutter()));
    for (std::size_t p = 0; p < passes.size(); ++p) {
        progress.set(double(p) / double(passes.size()));
        const Pass& pass = passes[p];
        for (std::size_t i = 0; i < pass.cl.size(); ++i) {
            const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, pass.cl.size() - 1);
            if (i % points_a_line == 0)
                record->lines.push_back({record->points.size(), record->points.size(), int(p), 0});
            record->points.push_back(point_at(ball, pass.cc[i].normal, pass.cl[i],
                                              pass.cl[b].tip - pass.cl[a].tip, options.allowance));
            record->lines.back().end = record->points.size();
        }
    }
    return record;
}

} // namespace facetmill
