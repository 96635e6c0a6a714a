#include "core/strategy/five_axis/strip_width.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// In radii of the cutter. Short of the whole of it: at its edge the cutter's surface rises steeply, and of
/// two strips that met there a pass a hair beside its plane would leave a wall between.
constexpr double max_width_share = 0.97;

} // namespace

double StripWidth::max_width(const FiveAxisField& field) {
    return max_width_share * field.radius();
}

long StripWidth::planes_apart(const FiveAxisField& field) {
    return std::max(
        1L, std::lround(field.settings().strip_look_share * field.radius() / field.lines().spacing()));
}

StripWidth::Look& StripWidth::look(int side, std::size_t number) {
    const auto& lines = field_.lines();
    const long own = lines.beyond(place_.v, place_.v);
    auto& looks = looks_[side > 0];
    while (looks.size() <= number) {
        long inside = own, plane = own + side;
        while (plane % look_ != 0)
            plane += side;
        if (!looks.empty()) {
            plane += side * look_ * long(looks.size());
            inside = plane - side * look_;
        }
        Look next;
        next.v = lines.v(plane);
        if (!field_.raised_line(place_, plane, next.line)) {
            next.ends = true;
            // Up to the very last plane that the surface has.
            for (long outside = plane; std::abs(outside - inside) > 1;) {
                const long middle = inside + (outside - inside) / 2;
                (field_.raised_line(place_, middle, next.line) ? inside : outside) = middle;
            }
            next.v = lines.v(inside);
            next.holds = field_.raised_line(place_, inside, next.line);
        }
        looks.push_back(std::move(next));
    }
    return looks[number];
}

StripWidth::Width StripWidth::operator()(const PostureValue& posture, int side) {
    const double most = StripWidth::max_width(field_);
    const ToolPose pose =
        posture_pose(field_.builder().input().lift->cutter(), place_.frame, {posture.lead, posture.yaw, 0});
    // Of lines that are cleared it is enough to know that they are, but for the last of them.
    const auto margin_at = [&](Look& at, double enough) {
        return field_.builder().top(pose, posture.lead, at.line, at.hint, enough) - posture.delta;
    };
    double last_v = place_.v;
    for (std::size_t i = 0;; ++i) {
        // Beyond the last one that counts no line need be cut.
        if (std::abs(last_v - place_.v) > most) return {most, 0};
        Look& at = look(side, i);
        const double away = std::abs(at.v - place_.v);
        if (!at.holds) return {infinity, away};
        const double margin = margin_at(at, posture.delta);
        if (!(margin >= 0)) {
            // The margin falls ever faster: the straight line between two looks is on the safe side.
            const double last = i > 0 ? margin_at(look(side, i - 1), infinity) : infinity;
            const double share = std::isfinite(last) && std::isfinite(margin) ? last / (last - margin) : 0;
            return {used_width * std::abs(last_v + share * (at.v - last_v) - place_.v), at.ends ? away : 0};
        }
        if (at.ends) return {infinity, away};
        last_v = at.v;
    }
}

bool StripWidth::clears_own_line(const PostureValue& posture) {
    if (!own_known_) {
        own_known_ = true;
        RaisedCurve line;
        if (field_.own_line(place_, line)) own_.push_back(std::move(line));
    }
    return field_.builder().top(place_.frame, posture.lead, posture.yaw, own_) >= posture.delta;
}

} // namespace facetmill
