// Colours of the scene. Kinds of motion are told apart by colours that stay apart for colour-blind eyes
// (after Okabe and Ito), by line width, and by dashes.
#pragma once

#include "core/setup/motion.h"
#include "viz/scene.h"

#include <array>

namespace facetmill {

struct Rgb {
    double r = 0, g = 0, b = 0;
};

/// From 0xRRGGBB.
constexpr Rgb rgb(unsigned hex) {
    return {double((hex >> 16) & 255u) / 255.0, double((hex >> 8) & 255u) / 255.0,
            double(hex & 255u) / 255.0};
}

struct Colors {
    Rgb background_top, background_bottom;
    Rgb text, faint_text, panel, panel_border;
    Rgb part, part_back, feature_edges, mesh_edges;
    Rgb stock, cut_stock;
    Rgb gouge, excess, collision; ///< findings
    Rgb contacts;
    Rgb left, kept;                        ///< contact points left to clean-up; postures kept by hand
    std::array<Rgb, motion_kinds> motions; ///< one per MotionKind
    Rgb cutter, shank, holder;
    Rgb marker, marker_ring;
    std::array<Rgb, 3> axes;
};

const Colors& colors_of(Palette palette);

/// In layout pixels.
double motion_line_width(MotionKind kind);

} // namespace facetmill
