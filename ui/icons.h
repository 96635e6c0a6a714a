// The workbench's icons, drawn in code in the colours of the palette they are painted with: sharp at every
// size, right in the light and in the dark theme, and nothing to find on disk.
#pragma once

#include <QIcon>

namespace facetmill {
struct Rgb; // viz/palette.h
}

namespace facetmill::ui {

enum class Icon {
    // files and edits
    new_project,
    open,
    save,
    export_program,
    picture,
    undo,
    redo,
    add,
    remove,
    duplicate,
    up,
    down,
    reset,
    edit,
    close,
    pick,
    // jobs
    plan,
    verify,
    cancel,
    // playback
    play,
    pause,
    step_back,
    step_forward,
    to_start,
    to_end,
    // views
    fit,
    view_iso,
    view_front,
    view_top,
    view_right,
    view_rear,
    view_bottom,
    view_left,
    // the tree
    part,
    stock,
    machine,
    tools,
    tool,
    operations,
    operation,
    // states
    not_planned,
    planning,
    planned,
    stale,
    failed,
    verified,
    verify_failed,
    verify_stale,
    information,
    warning,
    error,
};

QIcon icon(Icon which);
/// A facet with a cutter over it.
QIcon application_icon();

constexpr int swatch_size = 12; ///< points
/// A rounded square of the colour, to show in a list what the view draws in it.
QPixmap swatch(const Rgb& color, qreal device_pixel_ratio);

} // namespace facetmill::ui
