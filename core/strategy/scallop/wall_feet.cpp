#include "core/strategy/scallop/wall_feet.h"

#include <cmath>

namespace facetmill {

namespace {

/// A foot is looked for so many places beside a line.
constexpr double feet_within = 3;
/// Chords of a curve round a wall, which is as round as the cutter at least, stay out of it by so much of the
/// square of a place over the radius.
constexpr double chord_room = 0.4;
/// Heights that differ by less are the same, of a place.
constexpr double same_height = 1e-3;

} // namespace

void move_to_feet(const ScallopField& field, const AxialLift& lift, double steepest, FieldContour& line,
                  const Progress& progress) {
    const double steep = std::tan(steepest), spacing = field.spacing();
    const double room = chord_room * spacing * spacing / lift.profile().max_radius();
    for (Vec2& p : line.places) {
        progress.check();
        Vec2 towards = Vec2::Zero();
        for (const std::size_t i : field.around(p))
            towards += field.towards_wall(i);
        if (!(towards.norm() > 1e-9)) continue;
        towards.normalize();
        const double from = lift.tip_z(p.x(), p.y());
        const auto risen = [&](double far) {
            const Vec2 q = p + far * towards;
            return !(lift.tip_z(q.x(), q.y()) <= from + steep * far + same_height * spacing);
        };
        double lo = 0, hi = feet_within * spacing;
        if (!risen(hi)) continue;
        constexpr int halvings = 16;
        for (int k = 0; k < halvings; ++k) {
            const double middle = 0.5 * (lo + hi);
            (risen(middle) ? hi : lo) = middle;
        }
        p += std::max(0.0, lo - room) * towards;
    }
}

bool stands_at_foot(const ScallopField& field, const Vec3& tip, double steepest) {
    const auto near = int(std::ceil(feet_within));
    for (int r = -near; r <= near; ++r)
        for (int c = -near; c <= near; ++c)
            for (const std::size_t i : field.around(tip.head<2>() + field.spacing() * Vec2(c, r))) {
                const double far = (field.place(i) - tip.head<2>()).norm();
                if (far <= feet_within * field.spacing() && field.at_foot(i)
                    && std::abs(tip.z() - field.touch(i).tip.z())
                           <= std::tan(steepest) * far + same_height * field.spacing())
                    return true;
            }
    return false;
}

} // namespace facetmill
