// The workbench's icons: resources/icons/NAME.svg, compiled in and painted in the colours of the palette, so
// that they are sharp at every size and right in the light and in the dark theme.
#pragma once

#include <QColor>
#include <QIcon>
#include <QObject>

namespace facetmill {
struct Rgb; // viz/palette.h
}

namespace facetmill::ui {

Q_NAMESPACE

/// The names are those of the files.
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
    // how the part lies
    place,
    lay_on_face,
    lay_on_points,
    align_edge,
    square_up,
    principal_axes,
    hole,
    quarter_turn,
    quarter_back,
    mirror,
    drop,
    centre,
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
    fixture,
    boundary,
    machine,
    tool,
    operations,
    operation,
    // states
    not_planned,
    switched_off,
    planning,
    planned,
    stale,
    verified,
    verify_failed,
    verify_stale,
    information,
    warning,
    error,
};
Q_ENUM_NS(Icon)

QIcon icon(Icon which);

/// What the words for colours in the files stand for.
struct IconColors {
    QColor ink;       ///< currentColor
    QColor accent;    ///< blue: what the icon is about
    QColor good;      ///< green
    QColor attention; ///< orange
    QColor bad;       ///< red
    QColor busy;      ///< royalblue
    QColor quiet;     ///< gray
};
/// The text of a file with its words replaced, also where an editor has written them as numbers. Others stay.
QString with_colors(const QString& svg, const IconColors& colors);
/// An icon from the text of a file.
QIcon svg_icon(const QString& svg);

/// A facet with a cutter over it.
QIcon application_icon();

constexpr int swatch_size = 12; ///< points
/// A rounded square of the colour, to show in a list what the view draws in it.
QPixmap swatch(const Rgb& color, qreal device_pixel_ratio);

} // namespace facetmill::ui
