#include "core/gouge/lower_surface.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"

#include <cmath>

namespace facetmill {

namespace {

double piece_slope(double angle, bool vertical) {
    return vertical ? infinity : std::tan(angle);
}

/// Where g has this slope.
double distance_of_slope(const SurfaceTable& table, double slope) {
    for (int i = 0; i < table.count; ++i) {
        const SurfacePiece& p = table.piece[i];
        if (slope <= p.slope0) return p.rho0;
        if (p.r != 0 && slope <= p.slope1)
            return std::clamp(p.e + p.r * slope / std::sqrt(1 + slope * slope), p.rho0, p.rho1);
    }
    return table.max_radius;
}

void add_outer_line(SurfaceTable& table, const CutterProfile& profile) {
    table.outer_slope = tolerance::steepest_followed;
    const double outer = distance_of_slope(table, table.outer_slope);
    table.outer_at0 = profile.height_at(outer) - table.outer_slope * outer;
}

void add_rough(SurfaceTable& table, const CutterProfile& profile) {
    for (int i = 0; i < table.count; ++i) {
        const SurfacePiece& p = table.piece[i];
        table.rough[i] = {float(p.rho0),
                          float(profile.height_at(p.rho0)),
                          float(p.rho1),
                          float(p.slope0),
                          float(p.slope1),
                          float(p.e),
                          float(p.f),
                          float(p.r),
                          p.r == 0 ? 0 : float(1 / p.r)};
    }
    table.rim_height = float(profile.height_at(table.max_radius));
}

void add_guess(SurfaceTable& table) {
    const SurfacePiece& first = table.piece[0];
    table.guess_level = float(first.slope0 / std::hypot(1.0, first.slope0));
    table.guess_e = float(table.max_radius);
    for (int i = 0; i < table.count; ++i)
        if (table.piece[i].r != 0) {
            table.guess_e = float(table.piece[i].e);
            table.guess_r = float(table.piece[i].r);
        }
}

} // namespace

SurfaceTable lower_surface(const CutterProfile& profile) {
    SurfaceTable table;
    table.max_radius = profile.max_radius();
    for (const ProfilePiece& p : profile.lower_pieces()) {
        if (p.to.x() <= p.from.x()) continue;
        if (table.count == max_surface_pieces)
            throw Error(ErrorCode::internal, "lower_surface", "the profile has too many pieces",
                        "report this");
        SurfacePiece q{};
        q.rho0 = p.from.x();
        q.rho1 = p.to.x();
        if (p.kind == ProfilePiece::Kind::line) {
            q.z0 = p.from.y();
            q.slope0 = q.slope1 = std::max(0.0, (p.to.y() - p.from.y()) / (q.rho1 - q.rho0));
        } else {
            q.e = p.center.x();
            q.f = p.center.y();
            q.r = p.radius;
            q.slope0 = std::max(0.0, piece_slope(p.angle_at_start(), false));
            q.slope1 = piece_slope(p.angle_at_end(), p.to.y() >= q.f);
        }
        table.piece[table.count++] = q;
    }
    add_outer_line(table, profile);
    add_rough(table, profile);
    add_guess(table);
    const SurfacePiece& first = table.piece[0];
    if (table.count == 1 && first.r > 0 && first.e == 0)
        table.shape = SurfaceShape::ball;
    else if (table.count == 1 && first.r == 0 && first.slope0 == 0)
        table.shape = SurfaceShape::flat;
    return table;
}

} // namespace facetmill
