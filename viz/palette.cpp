#include "viz/palette.h"

namespace facetmill {

const Colors& colors_of(Palette palette) {
    // motions: rapid, approach, cut, link, retract
    static const Colors light{
        .background_top = rgb(0xC3D0E0),
        .background_bottom = rgb(0xFBFCFE),
        .text = rgb(0x1B2430),
        .faint_text = rgb(0x4A5666),
        .panel = rgb(0xFFFFFF),
        .panel_border = rgb(0x9AA8B8),
        .part = rgb(0xB4C0CC),
        .part_back = rgb(0xD8AE78),
        .feature_edges = rgb(0x2F3A47),
        .mesh_edges = rgb(0x5E6C7B),
        .stock = rgb(0x1F8A70),
        .cut_stock = rgb(0xC9B08A),
        .gouge = rgb(0xFF5A52),
        .excess = rgb(0x6E8BFF),
        .collision = rgb(0xFF4FB4),
        .contacts = rgb(0x14181E),
        .left = rgb(0xC62828),
        .kept = rgb(0x7B3FE4),
        .motions = {rgb(0xD55E00), rgb(0xA8327D), rgb(0x005FA8), rgb(0xE69F00), rgb(0xA8327D)},
        .cutter = rgb(0xE2B13C),
        .shank = rgb(0x9FA8B2),
        .holder = rgb(0x5C6875),
        .marker = rgb(0xD81B60),
        .marker_ring = rgb(0xFFFFFF),
        .axes = {rgb(0xC8391F), rgb(0x1B7F4B), rgb(0x1E5FB8)},
    };
    static const Colors dark{
        .background_top = rgb(0x39424E),
        .background_bottom = rgb(0x171B21),
        .text = rgb(0xEEF2F6),
        .faint_text = rgb(0xB2BECB),
        .panel = rgb(0x222831),
        .panel_border = rgb(0x56626F),
        .part = rgb(0x8E9BA9),
        .part_back = rgb(0xB98B52),
        .feature_edges = rgb(0x11151A),
        .mesh_edges = rgb(0x3C4753),
        .stock = rgb(0x4FD1B0),
        .cut_stock = rgb(0xB79F78),
        .gouge = rgb(0xFF5A52),
        .excess = rgb(0x6E8BFF),
        .collision = rgb(0xFF6FC4),
        .contacts = rgb(0xFFFFFF),
        .left = rgb(0xFF6B61),
        .kept = rgb(0xC2A0FF),
        .motions = {rgb(0xFF7F2A), rgb(0xE58FC8), rgb(0x5CC0F5), rgb(0xF2D33C), rgb(0xE58FC8)},
        .cutter = rgb(0xE2B13C),
        .shank = rgb(0xA9B2BC),
        .holder = rgb(0x66727F),
        .marker = rgb(0xFF4F8B),
        .marker_ring = rgb(0xFFFFFF),
        .axes = {rgb(0xF0654B), rgb(0x4CC38A), rgb(0x5FA2F2)},
    };
    return palette == Palette::dark ? dark : light;
}

double motion_line_width(MotionKind kind) {
    switch (kind) {
    case MotionKind::cut:
        return 1.3;
    case MotionKind::link:
        return 2.0;
    case MotionKind::rapid:
        return 1.3;
    case MotionKind::approach:
    case MotionKind::retract:
        return 1.8;
    }
    return 1.0;
}

} // namespace facetmill
