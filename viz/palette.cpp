#include "viz/palette.h"

namespace facetmill {

namespace {

/// From 0xRRGGBB.
constexpr Rgb rgb(unsigned hex) {
    return {double((hex >> 16) & 255u) / 255.0, double((hex >> 8) & 255u) / 255.0,
            double(hex & 255u) / 255.0};
}

constexpr Rgb white = rgb(0xFFFFFF), black = rgb(0x000000);

// Motions: rapid, approach, cut, link, retract.
constexpr Colors light{
    .background_top = rgb(0xC3D0E0),
    .background_bottom = rgb(0xFBFCFE),
    .text = rgb(0x1B2430),
    .faint_text = rgb(0x4A5666),
    .panel = white,
    .panel_border = rgb(0x9AA8B8),
    .part = rgb(0xB4C0CC),
    .part_back = rgb(0xD8AE78),
    .feature_edges = rgb(0x2F3A47),
    .mesh_edges = rgb(0x5E6C7B),
    .former_part = rgb(0x8A4FB0),
    .new_surface = rgb(0xB783D9),
    .new_surface_line = rgb(0x7A36A8),
    .taken_away = rgb(0xE0574C),
    .hole = rgb(0xC75300),
    .stock = rgb(0x1F8A70),
    .cut_stock = rgb(0xC9B08A),
    .fixture = rgb(0x8C6F9E),
    .chosen_fixture = rgb(0xD98A2B),
    .boundary = rgb(0x4FA3E3),
    .avoided = rgb(0xD9706B),
    .boundary_line = rgb(0x0B5FA5),
    .avoided_line = rgb(0xA3231C),
    .steep = rgb(0x45B5A6),
    .shallow = rgb(0xDDD08C),
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
    .marker_ring = white,
    .axes = {rgb(0xC8391F), rgb(0x1B7F4B), rgb(0x1E5FB8)},
    .strips = {rgb(0xE4572E), rgb(0x17A2A2), rgb(0x8E44AD), rgb(0xD99A00), rgb(0x2E8B57), rgb(0xC2185B),
               rgb(0x3F51B5), rgb(0x795548)},
    .strip_off = rgb(0x707A84),
    .chart_lines = {rgb(0x005FA8), rgb(0xC75300), rgb(0x1C7C46)},
    .widgets = {.window = rgb(0xF1F3F5),
                .base = white,
                .alternate = rgb(0xF6F8FA),
                .button = rgb(0xF4F6F8),
                .text = rgb(0x1F2933),
                .quiet = rgb(0x627080),
                .light = white,
                .midlight = rgb(0xE9EDF1),
                .mid = rgb(0xC4CCD4),
                .dark = rgb(0xA3AEB9),
                .shadow = rgb(0x5F6B77),
                .highlight = rgb(0x1F6FB2),
                .on_highlight = white,
                .bright = white,
                .link = rgb(0x1A66A5),
                .disabled = rgb(0x9AA5B1),
                .tip = rgb(0x26323D),
                .on_tip = rgb(0xF1F3F5)},
    .signal = {.good = rgb(0x1C7C46),
               .attention = rgb(0x9A5B00),
               .bad = rgb(0xC0271D),
               .busy = rgb(0x1F6FB2),
               .quiet = rgb(0x5F6B78)},
    .sketch = {.cutter = rgb(0xF3C66B),
               .shank = rgb(0xC3CCD5),
               .holder = rgb(0x9AA7B4),
               .axis = rgb(0xC0271D)},
    .cube = {.ink = rgb(0x26323D), .body = rgb(0xF7F9FB), .edge = rgb(0x8593A1), .on_accent = white},
    .preview = rgb(0x5B2A86),
};

constexpr Colors dark{
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
    .former_part = rgb(0xC79BE6),
    .new_surface = rgb(0x9C6CC2),
    .new_surface_line = rgb(0xCBA0F0),
    .taken_away = rgb(0xD8605A),
    .hole = rgb(0xFF9A4A),
    .stock = rgb(0x4FD1B0),
    .cut_stock = rgb(0xB79F78),
    .fixture = rgb(0x9A82AE),
    .chosen_fixture = rgb(0xE5A04A),
    .boundary = rgb(0x3E97DB),
    .avoided = rgb(0xCF5F5A),
    .boundary_line = rgb(0x8FD0FF),
    .avoided_line = rgb(0xFFB0AA),
    .steep = rgb(0x359B8E),
    .shallow = rgb(0xA79B5C),
    .gouge = rgb(0xFF5A52),
    .excess = rgb(0x6E8BFF),
    .collision = rgb(0xFF6FC4),
    .contacts = white,
    .left = rgb(0xFF6B61),
    .kept = rgb(0xC2A0FF),
    .motions = {rgb(0xFF7F2A), rgb(0xE58FC8), rgb(0x5CC0F5), rgb(0xF2D33C), rgb(0xE58FC8)},
    .cutter = rgb(0xE2B13C),
    .shank = rgb(0xA9B2BC),
    .holder = rgb(0x66727F),
    .marker = rgb(0xFF4F8B),
    .marker_ring = white,
    .axes = {rgb(0xF0654B), rgb(0x4CC38A), rgb(0x5FA2F2)},
    .strips = {rgb(0xFF7B54), rgb(0x3FD0D0), rgb(0xC07BE0), rgb(0xFFC233), rgb(0x5CC98A), rgb(0xF0649A),
               rgb(0x8291FF), rgb(0xB58A76)},
    .strip_off = rgb(0xA0A8B0),
    .chart_lines = {rgb(0x5CC0F5), rgb(0xFF9A4A), rgb(0x7BD88F)},
    .widgets = {.window = rgb(0x23282E),
                .base = rgb(0x2C333A),
                .alternate = rgb(0x30373F),
                .button = rgb(0x2D343B),
                .text = rgb(0xDDE3E9),
                .quiet = rgb(0x9AA6B2),
                .light = rgb(0x4A545F),
                .midlight = rgb(0x3B444D),
                .mid = rgb(0x3D464F),
                .dark = rgb(0x15181C),
                .shadow = rgb(0x0C0E10),
                .highlight = rgb(0x2A77B8),
                .on_highlight = white,
                .bright = white,
                .link = rgb(0x6CB2EE),
                .disabled = rgb(0x69747F),
                .tip = rgb(0x39434D),
                .on_tip = rgb(0xF1F3F5)},
    .signal = {.good = rgb(0x5CC98A),
               .attention = rgb(0xF0B849),
               .bad = rgb(0xFF7B72),
               .busy = rgb(0x6CB2EE),
               .quiet = rgb(0x9AA6B2)},
    .sketch = {.cutter = rgb(0xC9973A),
               .shank = rgb(0x7D8894),
               .holder = rgb(0x56616C),
               .axis = rgb(0xFF7B72)},
    .cube = {.ink = rgb(0xDDE3E9), .body = rgb(0x46515C), .edge = rgb(0x8A97A4), .on_accent = white},
    .preview = rgb(0xD4B0FF),
};

constexpr FixedColors fixed{
    .missing = {rgb(0x6CCB5F), rgb(0xE8B530), rgb(0xE8682A), rgb(0xB40F20)},
    .standing = {rgb(0x6CCB5F), rgb(0x35B5C4), rgb(0x2F7FDD), rgb(0x24309E)},
    .unjudged = rgb(0xA4A9AE),
    .quantity = {rgb(0x440154), rgb(0x472D7B), rgb(0x3B528B), rgb(0x2C728E), rgb(0x21918C), rgb(0x28AE80),
                 rgb(0x5EC962), rgb(0xADDC30), rgb(0xFDE725)},
    .no_quantity = rgb(0x9AA3AD),
    .postures = {.free = rgb(0x2FA876),
                 .near_contact = rgb(0xD55E00),
                 .elsewhere = rgb(0xEDB120),
                 .shank = rgb(0xD487B6),
                 .holder = rgb(0x7B3FA0),
                 .lift = rgb(0x7FB8E6),
                 .machine = rgb(0x5A6470),
                 .top = rgb(0x1F6FB5),
                 .choices = {rgb(0xFFE14D), rgb(0x4DB8FF), rgb(0xE0218A), rgb(0x14181E)}},
    .paper = {.ground = white, .ink = black, .quiet = rgb(0x5A6470), .cursor = rgb(0x2F7FC1)},
    .outline = black,
    .outline_ring = white,
};

} // namespace

const Colors& colors_of(Palette palette) {
    return palette == Palette::dark ? dark : light;
}

const FixedColors& fixed_colors() {
    return fixed;
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
