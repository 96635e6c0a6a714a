// What a scene's overlay is drawn with: flat shapes and texts over the picture, in layout pixels (device
// pixels / pixel ratio) from the top left, y down.
#pragma once

#include "core/base/vec.h"
#include "viz/palette.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkActor2D;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;
class vtkUnsignedCharArray;

namespace facetmill {

struct OverlayText {
    double x = 0, y = 0; ///< the middle of the left end, the right end or the middle of the text
    enum class Align { left, right, center } align = Align::left;
    std::string text;
    double size = 12;
    bool bold = false;
    Rgb color;
};

class OverlayCanvas {
public:
    explicit OverlayCanvas(vtkRenderer* renderer);
    ~OverlayCanvas();
    OverlayCanvas(const OverlayCanvas&) = delete;
    OverlayCanvas& operator=(const OverlayCanvas&) = delete;

    /// Device pixels; before anything is measured or drawn.
    void set_size(int width, int height, double ratio);
    double width() const { return width_ / ratio_; }
    double height() const { return height_ / ratio_; }

    double text_width(const std::string& text, double size, bool bold) const;
    /// In the middle, to a width; empty where nothing readable fits.
    std::string shortened(const std::string& text, double width, double size, bool bold) const;

    /// A frame without anything; then what is to be seen; `end` brings the actors up to date.
    void begin();
    void end();
    void polygon(const std::vector<Vec2>& corners, const Rgb& color, double alpha);
    void rectangle(double x0, double y0, double x1, double y1, const Rgb& color, double alpha = 1.0);
    void disc(double x, double y, double radius, const Rgb& color);
    void stroke(const Vec2& from, const Vec2& to, double width, const Rgb& color);
    /// Capitals and digits are centred on y, whatever letters the text has.
    void write(const OverlayText& text);

private:
    vtkRenderer* renderer_;
    double ratio_ = 1;
    int width_ = 0, height_ = 0;
    vtkSmartPointer<vtkPolyData> shapes_;
    vtkSmartPointer<vtkActor2D> shapes_actor_;
    vtkSmartPointer<vtkPoints> shape_points_;
    vtkSmartPointer<vtkUnsignedCharArray> shape_colors_;
    std::vector<vtkSmartPointer<vtkTextActor>> text_actors_;
    std::size_t texts_used_ = 0;
};

} // namespace facetmill
