// All colours of the views and of the window, by what they are for, in a light and a dark look. They are
// numbers: `ui` makes QColor of them (ui/theme.h). tests/arch fails where a colour stands anywhere else.
//
// Kinds of motion are told apart by colours that stay apart for colour-blind eyes (after Okabe and Ito), by
// line width, and by dashes.
#pragma once

#include "core/setup/motion.h"

#include <array>
#include <cstddef>

namespace facetmill {

enum class Palette { light, dark };

inline constexpr std::size_t motion_kinds = 5; ///< number of MotionKind's enumerators

/// Red, green and blue from 0 to 1, as a screen takes them.
struct Rgb {
    double r = 0, g = 0, b = 0;
};

/// Shades of the window, by the roles that a desktop's style knows.
struct WidgetColors {
    Rgb window, base, alternate, button, text, quiet;
    Rgb light, midlight, mid, dark, shadow; ///< from the lit edge of a button to its shadow
    Rgb highlight, on_highlight, bright, link, disabled, tip, on_tip;
};

/// Colours with a meaning, readable on the window.
struct SignalShades {
    Rgb good, attention, bad, busy, quiet;
};

struct ToolSketchColors {
    Rgb cutter, shank, holder, axis;
};

struct ViewCubeColors {
    Rgb ink, body, edge, on_accent;
};

struct Colors {
    Rgb background_top, background_bottom;
    Rgb text, faint_text, panel, panel_border;
    Rgb part, part_back, feature_edges, mesh_edges;
    Rgb former_part;                                     ///< before it was replaced
    Rgb new_surface, new_surface_line, taken_away, hole; ///< of the scan room
    Rgb stock, cut_stock;
    Rgb fixture, chosen_fixture;
    Rgb boundary, avoided, boundary_line, avoided_line; ///< where operations cut within, and keep off
    Rgb steep, shallow;                                 ///< what an operation cuts by levels, and by passes
    Rgb gouge, excess, collision;                       ///< findings
    Rgb contacts;
    Rgb left, kept;                        ///< contact points left to clean-up; postures kept by hand
    std::array<Rgb, motion_kinds> motions; ///< one per MotionKind
    Rgb cutter, shank, holder;
    Rgb marker, marker_ring;
    std::array<Rgb, 3> axes;
    std::array<Rgb, 8> strips; ///< in turn
    Rgb strip_off;
    std::array<Rgb, 3> chart_lines;
    WidgetColors widgets;
    SignalShades signal;
    ToolSketchColors sketch;
    ViewCubeColors cube;
    Rgb preview; ///< passes before they are planned
};

const Colors& colors_of(Palette palette);

/// Colours of what is measured, and of pictures for paper: the same in both looks, so that they say the same.
struct FixedColors {
    std::array<Rgb, 4> missing, standing; ///< deviations from within the tolerance to the end of the scale
    Rgb unjudged;
    std::array<Rgb, 9> quantity; ///< of a path, from low to high
    Rgb no_quantity;
    struct {
        Rgb free, near_contact, elsewhere, shank, holder, lift, machine; ///< what blocks a posture
        Rgb top;                                                         ///< surface S1
        std::array<Rgb, 4> choices;                                      ///< CM2, local, global, planned
    } postures;
    struct {
        Rgb ground, ink, quiet, cursor;
    } paper;
    Rgb outline, outline_ring; ///< of a mark on any colour: dark and bright together are seen everywhere
};

const FixedColors& fixed_colors();

/// In layout pixels.
double motion_line_width(MotionKind kind);

} // namespace facetmill
