// The workbench's looks: Fusion with a light and a dark palette of our own, the same on every desktop.
#pragma once

#include <QColor>
#include <QString>

class QApplication;
class QPalette;

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

/// Colours with a meaning, in the shade that is readable on the palette's window.
struct SignalColors {
    QColor good, attention, bad, busy, quiet;
};
SignalColors signal_colors(const QPalette& palette);
bool is_dark(const QPalette& palette);

} // namespace facetmill::ui
