// The workbench's looks: Fusion with a light and a dark palette of our own, the same on every desktop.
#pragma once

#include <QColor>
#include <QString>

class QApplication;
class QPalette;

namespace facetmill {
struct Colors; // viz/palette.h
struct Rgb;
} // namespace facetmill

namespace facetmill::ui {

enum class Theme { system, light, dark };

/// "system", "light", "dark"; anything else is system.
Theme theme_from_name(const QString& name);
QString theme_name(Theme theme);

/// Sets style and palette of the application. `system` follows the lightness of the desktop's own palette, as
/// it was when the program started.
void apply_theme(QApplication& app, Theme theme);
QPalette light_palette();
QPalette dark_palette();

QColor to_qt(const Rgb& color);
/// Those of the look, light or dark, that the palette belongs to.
const Colors& view_colors(const QPalette& palette);
/// `parts` of the ground to one of the mark.
QColor mixed(const QColor& ground, int parts, const QColor& mark);

/// Colours with a meaning, in the shade that is readable on the palette's window.
struct SignalColors {
    QColor good, attention, bad, busy, quiet;
};
SignalColors signal_colors(const QPalette& palette);
bool is_dark(const QPalette& palette);

/// A widget, such as a menu, whose small icons are so wide instead, in points.
inline constexpr char menu_icon_property[] = "menu_icon_width";

} // namespace facetmill::ui
