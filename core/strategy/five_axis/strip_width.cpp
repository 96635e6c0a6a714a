#include "core/strategy/five_axis/strip_width.h"

#include "core/base/tolerances.h"

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
    return std::max(1L, std::lround(field.fineness() * field.settings().strip_look_share * field.radius()
                                    / field.lines().spacing()));
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
        // Neighbouring lines are most likely touched in the same place.
        if (!looks.empty()) next.hint = looks.back().hint;
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

StripWidth::Standing StripWidth::standing(const PostureValue& posture) const {
    return {posture_pose(field_.cutter(), place_.frame, {posture.lead, posture.yaw, 0}), posture.lead,
            posture.delta};
}

double StripWidth::margin(const Standing& at, Look& line, double enough) const {
    return field_.builder().top(at.pose, at.lead, line.line, line.hint, enough) - at.delta;
}

bool StripWidth::holds(const Standing& at, Look& line) const {
    return field_.builder().reaches(at.pose, at.lead, line.line, line.hint, at.delta);
}

StripWidth::Width StripWidth::operator()(const Standing& at, int side) {
    const double most = StripWidth::max_width(field_);
    double last_v = place_.v;
    for (std::size_t i = 0;; ++i) {
        // Beyond the last one that counts no line need be cut.
        if (std::abs(last_v - place_.v) > most) return {most, 0};
        Look& here = look(side, i);
        const double away = std::abs(here.v - place_.v);
        if (!here.holds) return {infinity, away};
        // Of lines that are cleared it is enough to know that they are, but for the last of them.
        const double left = margin(at, here, at.delta);
        if (!(left >= 0)) {
            // The margin falls ever faster: the straight line between two looks is on the safe side.
            const double last = i > 0 ? margin(at, look(side, i - 1), infinity) : infinity;
            const double share = std::isfinite(last) && std::isfinite(left) ? last / (last - left) : 0;
            return {used_width * std::abs(last_v + share * (here.v - last_v) - place_.v),
                    here.ends ? away : 0};
        }
        if (here.ends) return {infinity, away};
        last_v = here.v;
    }
}

bool StripWidth::may_exceed(const Standing& at, int side, double width) {
    const double most = StripWidth::max_width(field_);
    // The farthest line at which a strip that ends there is not wider.
    std::size_t count = 0;
    for (double last = 0; last <= most; ++count) {
        const Look& next = look(side, count);
        last = std::abs(next.v - place_.v);
        if (used_width * last > width * (1 - tolerance::level_angle)) break;
        if (!next.holds) return true;
        if (next.ends) last = infinity; // counted, and the last one
    }
    return count == 0 || holds(at, look(side, count - 1));
}

bool StripWidth::clears_own_line(const PostureValue& posture) {
    if (!own_) {
        own_.emplace();
        own_->holds = field_.own_line(place_, own_->line);
    }
    const Standing at = standing(posture);
    return !own_->holds || holds(at, *own_);
}

} // namespace facetmill
