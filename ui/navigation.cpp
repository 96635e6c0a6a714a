#include "ui/navigation.h"

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

Gesture own(Qt::MouseButton pressed, Qt::KeyboardModifiers keys) {
    if (pressed == Qt::LeftButton) return keys & Qt::ShiftModifier ? Gesture::move : Gesture::turn;
    if (pressed == Qt::MiddleButton) return Gesture::move;
    return pressed == Qt::RightButton ? Gesture::zoom : Gesture::hold;
}

/// The wheel pressed turns, moves or zooms, by keys.
Gesture by_middle(Qt::MouseButton pressed, Qt::KeyboardModifiers keys, Gesture plain, Gesture shift,
                  Gesture control) {
    if (pressed != Qt::MiddleButton) return Gesture::hold;
    if (keys & Qt::ShiftModifier) return shift;
    return keys & Qt::ControlModifier ? control : plain;
}

Gesture freecad(Qt::MouseButton pressed, Qt::MouseButtons held, Qt::KeyboardModifiers keys) {
    if (held & Qt::MiddleButton)
        return held & (Qt::LeftButton | Qt::RightButton) ? Gesture::turn : Gesture::move;
    if (pressed != Qt::RightButton) return Gesture::hold;
    if (keys & Qt::ShiftModifier) return Gesture::turn;
    return keys & Qt::ControlModifier ? Gesture::move : Gesture::hold;
}

/// The sight with a level horizon; as it was where it looks straight up or down.
Sight upright(const Sight& sight) {
    const Vec3 right = sight.forward.cross(sight.up);
    const Vec3 level = sight.forward.cross(Vec3::UnitZ());
    constexpr double straight = 1e-6;
    if (level.norm() < straight) return sight;
    const Vec3 across = (level.dot(right) < 0 ? -1 : 1) * level.normalized();
    return {sight.forward, across.cross(sight.forward).normalized()};
}

/// Takes the one sight to the other.
Mat3 between(const Sight& from, const Sight& to) {
    Mat3 a, b;
    a << from.forward, from.up, from.forward.cross(from.up);
    b << to.forward, to.up, to.forward.cross(to.up);
    return b * a.transpose();
}

} // namespace

Gesture gesture_of(NavigationStyle style, Qt::MouseButton pressed, Qt::MouseButtons held,
                   Qt::KeyboardModifiers modifiers) {
    switch (style) {
    case NavigationStyle::facetmill:
        return own(pressed, modifiers);
    case NavigationStyle::fusion:
        return by_middle(pressed, modifiers, Gesture::move, Gesture::turn, Gesture::zoom);
    case NavigationStyle::freecad:
        return freecad(pressed, held, modifiers);
    case NavigationStyle::blender:
        return by_middle(pressed, modifiers, Gesture::turn, Gesture::move, Gesture::zoom);
    case NavigationStyle::solidworks:
        return by_middle(pressed, modifiers, Gesture::turn, Gesture::zoom, Gesture::move);
    }
    return Gesture::hold;
}

Mat3 orbit_turn(Orbit orbit, const Sight& sight, double across, double down) {
    const auto about = [](double angle, const Vec3& axis) {
        return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    };
    if (orbit == Orbit::trackball) {
        const Vec3 right = sight.forward.cross(sight.up).normalized();
        return about(across, sight.up) * about(down, right);
    }
    const Sight level = upright(sight);
    const Vec3 right = level.forward.cross(level.up).normalized();
    // How far it looks up; beyond a quarter of a turn the picture stands on its head.
    const double pitch = std::atan2(level.forward.z(), level.up.z());
    const bool on_its_head = std::abs(pitch) > 0.5 * pi + 1e-9;
    if (!on_its_head) down = std::clamp(down, -0.5 * pi - pitch, 0.5 * pi - pitch);
    return about(on_its_head ? -across : across, Vec3::UnitZ()) * about(down, right) * between(sight, level);
}

} // namespace facetmill::ui
