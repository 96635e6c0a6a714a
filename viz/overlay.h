// The flat things drawn over a scene: title, legend, scale bar, names of the axes, the text of an empty
// scene. Laid out again for every frame, in layout pixels (device pixels / pixel ratio) from the top left;
// what does not fit is left out rather than drawn over something else.
#pragma once

#include "core/base/units.h"
#include "core/base/vec.h"
#include "viz/overlay_canvas.h"
#include "viz/palette.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

/// In layout pixels, y down.
struct LayoutRect {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    double width() const { return x1 - x0; }
    double height() const { return y1 - y0; }
    bool empty() const { return !(x1 > x0 && y1 > y0); }
};

struct LegendEntry {
    enum class Sample { line, dashes, dot, spot, box, surface, none };
    Sample sample = Sample::line;
    Rgb color;
    double width = 1; ///< width of a line, layout pixels
    std::string label;
};

/// A scale of colours in the legend, upright, its low end below.
struct ColorBar {
    std::string title, note;                           ///< the note stands under the title
    std::vector<Rgb> colors;                           ///< from the low end to the high one
    Rgb below, above;                                  ///< colours of what lies beyond the ends
    bool has_below = false, has_above = false;         ///< there is something: an arrow is drawn
    std::string low_text, high_text;                   ///< what the ends mean
    std::vector<std::pair<double, std::string>> marks; ///< place (0..1) and text, ascending
    std::optional<std::pair<Rgb, std::string>> other;  ///< a colour apart from the scale
};

/// A text beside a place, layout pixels.
struct OverlayNote {
    Vec2 at = Vec2::Zero(); ///< middle of the left end (-1), of the text (0), of the right end (1)
    int end = 0;
    std::string text;
    bool bold = false;
    bool framed = false; ///< on a panel, where it stands over something
};

/// A ringed dot at a place, layout pixels.
struct OverlaySpot {
    Vec2 at = Vec2::Zero();
    Rgb color;
};

struct OverlayContent {
    int width = 0, height = 0; ///< device pixels
    double ratio = 1;
    Palette palette = Palette::light;
    std::string title, subtitle, empty_text;
    std::vector<LegendEntry> legend;
    std::vector<ColorBar> color_bars; ///< below the legend's entries; the first where there is room for one
    bool scale = false;
    LengthUnit unit = LengthUnit::mm;
    double mm_per_pixel = 0;  ///< per layout pixel
    double covered_below = 0; ///< layout pixels along the lower edge that something else covers
    LayoutRect covered;       ///< what something else covers in the lower right corner, above the scale
    bool axes = false;
    std::vector<OverlaySpot> spots; ///< the later ones over the ones before
    std::vector<OverlayNote> notes;
    std::optional<Vec2> marker;        ///< layout pixels
    Vec2 marker_normal = Vec2::Zero(); ///< image of the unit normal, y down
    std::array<Vec3, 3>
        axis_directions; ///< X, Y, Z of the part in the camera's frame: right, up, towards the eye
};

/// Where things stand; empty where there is nothing.
struct OverlayLayout {
    LayoutRect title, legend, scale, axes;
    LayoutRect covered; ///< as the content says
};

class Overlay {
public:
    explicit Overlay(vtkRenderer* renderer) : canvas_(renderer) {}

    /// Places everything, without drawing.
    OverlayLayout layout(const OverlayContent& content);
    /// Brings the actors up to date for the frame about to be drawn.
    void update(const OverlayContent& content);
    /// Layout pixels, at the size of notes; for `layout`'s or `update`'s last pixel ratio.
    double note_width(const std::string& text, bool bold);

private:
    void draw_marker(const OverlayContent& content);
    void draw_notes(const OverlayContent& content);
    void draw_empty_text(const OverlayContent& content);
    OverlayLayout lay_out(const OverlayContent& content, bool draw);
    void lay_out_title(const OverlayContent& content, bool draw, OverlayLayout& layout);
    void lay_out_legend(const OverlayContent& content, bool draw, OverlayLayout& layout);
    void draw_legend_entry(const LegendEntry& entry, double x0, double y, const Colors& colors);
    void draw_color_bar(const ColorBar& bar, const LayoutRect& in, const Colors& colors);
    void lay_out_scale(const OverlayContent& content, bool draw, OverlayLayout& layout);
    void lay_out_axes(const OverlayContent& content, bool draw, OverlayLayout& layout);

    OverlayCanvas canvas_;
};

/// Side of the square in the bottom left corner that the axes take, layout pixels; 0 where there is no room.
double axes_side(double width, double height);

/// The largest of 1, 2, 5 times a power of ten (in `unit`) whose bar is not longer than `longest_mm`; in mm.
double round_length(double longest_mm, LengthUnit unit);

} // namespace facetmill
