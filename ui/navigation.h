// How the mouse turns, moves and zooms a view: by Facetmill's own buttons, or by those of a program that the
// user knows. No widgets.
#pragma once

#include "core/base/vec.h"

#include <Qt>

#include <array>

namespace facetmill::ui {

enum class NavigationStyle { facetmill, fusion, freecad, blender, solidworks };
/// turntable: the part's Z stays upright on the screen; trackball: it rolls as well.
enum class Orbit { turntable, trackball };

struct Navigation {
    NavigationStyle style = NavigationStyle::facetmill;
    Orbit orbit = Orbit::turntable;
    bool operator==(const Navigation&) const = default;
};

/// "facetmill", "fusion", "freecad", "blender", "solidworks", as settings keep them, in the order of the
/// styles.
inline constexpr std::array<const char*, 5> navigation_styles{"facetmill", "fusion", "freecad", "blender",
                                                              "solidworks"};

/// What a drag does that begins with a button. hold: nothing; it is a click, or none.
enum class Gesture { hold, turn, move, zoom };
/// `held`: the buttons that are down, the one that was pressed last among them.
Gesture gesture_of(NavigationStyle style, Qt::MouseButton pressed, Qt::MouseButtons held,
                   Qt::KeyboardModifiers modifiers);

/// Where a camera looks, and what is up on the screen; unit vectors across each other.
struct Sight {
    Vec3 forward, up;
};
/// The turn of a camera that a drag asks for: `across` about what is upright, `down` about what is level on
/// the screen, radians. A turntable brings a view that was rolled upright first, and stops where it looks
/// straight up or down.
Mat3 orbit_turn(Orbit orbit, const Sight& sight, double across, double down);

} // namespace facetmill::ui
