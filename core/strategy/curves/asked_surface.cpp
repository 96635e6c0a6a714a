#include "core/strategy/curves/asked_surface.h"

#include "core/strategy/surface/boundary_region.h"

#include <cmath>

namespace facetmill {

namespace {

/// Corners of a circle, and edges that cross a curve, in radii of the cutter.
constexpr int circle_corners = 720;
constexpr double border_edge = 0.05;

} // namespace

PlanCurve circle_about(const Vec2& center, double radius) {
    PlanCurve circle{{}, true};
    for (int k = 0; k < circle_corners; ++k) {
        const double a = 2 * pi * k / circle_corners;
        circle.points.emplace_back(center + radius * Vec2(std::cos(a), std::sin(a)));
    }
    return circle;
}

PlanContext cut_to_curves(const PlanContext& context, const std::string& where,
                          const std::optional<PlanCurve>& within, const std::optional<PlanCurve>& outside,
                          double radius, const Progress& progress) {
    PlanContext own = context;
    const auto cut = [&](const PlanCurve& curve, bool invert, const Progress& here) {
        Boundary boundary;
        boundary.kind = Boundary::Kind::curve;
        boundary.invert = invert;
        for (const Vec2& p : curve.points)
            boundary.curve.push_back({{p.x(), p.y(), 0}});
        try {
            own.part = BoundaryRegion(boundary, own.part, here.part(0, 0.5))
                           .surface(0, border_edge * radius, here.part(0.5, 1));
        } catch (const Error& e) {
            if (e.code() != ErrorCode::empty_result) throw;
            throw Error(ErrorCode::empty_result, where, "nothing of the part lies where it is to cut",
                        "move its curves or its centre onto the part");
        }
        own.is_piece = true;
    };
    if (within) cut(*within, false, progress.part(0, 0.4));
    if (outside) cut(*outside, true, progress.part(0.4, 0.8));
    if (own.part != context.part) own.geometry = compute_geometry(*own.part, progress.part(0.8, 1));
    progress.set(1);
    return own;
}

} // namespace facetmill
