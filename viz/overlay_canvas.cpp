#include "viz/overlay_canvas.h"

#include "viz/overlay_words.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr int dots_per_inch = 72;                   // a point is a pixel
constexpr double cap_height = 0.72, descent = 0.21; // of VTK's own font, in font sizes

void set_font(vtkTextProperty* property, double pixels, bool bold) {
    property->SetFontFamilyToArial();
    property->SetFontSize(std::max(1, int(std::lround(pixels))));
    property->SetBold(bold ? 1 : 0);
}

/// Starts of UTF-8 characters, and the end.
std::vector<std::size_t> character_starts(const std::string& text) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) starts.push_back(i);
    starts.push_back(text.size());
    return starts;
}

} // namespace

OverlayCanvas::OverlayCanvas(vtkRenderer* renderer) : renderer_(renderer) {
    shapes_ = vtkSmartPointer<vtkPolyData>::New();
    shape_points_ = vtkSmartPointer<vtkPoints>::New();
    shape_colors_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
    shape_colors_->SetNumberOfComponents(4);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shapes_);
    // A colour for each corner, though a shape has one: colours of cells reach the shader as a buffer, for
    // each kind of whose size OpenGL without a graphics card makes a shader of its own, which takes it 30 ms.
    mapper->SetScalarModeToUsePointData();
    mapper->ScalarVisibilityOn();
    shapes_actor_ = vtkSmartPointer<vtkActor2D>::New();
    shapes_actor_->SetMapper(mapper);
    shapes_actor_->SetLayerNumber(0);
    shapes_actor_->PickableOff();
    renderer_->AddViewProp(shapes_actor_);
}

OverlayCanvas::~OverlayCanvas() = default;

void OverlayCanvas::set_size(int width, int height, double ratio) {
    width_ = width;
    height_ = height;
    ratio_ = ratio;
}

double OverlayCanvas::text_width(const std::string& english, double size, bool bold) const {
    const std::string text = overlay_words(english);
    vtkNew<vtkTextProperty> property;
    set_font(property, size * ratio_, bold);
    int box[4] = {0, 0, 0, 0};
    if (text.empty() || !vtkTextRenderer::GetInstance()->GetBoundingBox(property, text, box, dots_per_inch))
        return 0.0;
    return (box[1] - box[0] + 1) / ratio_;
}

std::string OverlayCanvas::shortened(const std::string& english, double width, double size, bool bold) const {
    const std::string text = overlay_words(english);
    if (text_width(text, size, bold) <= width) return text;
    // The two ends tell names apart: "long-fixture-n…e-2-rev-b.stl".
    const auto starts = character_starts(text);
    const std::size_t n = starts.size() - 1;
    const auto cut_to = [&](std::size_t keep) {
        const std::size_t front = (keep + 1) / 2, back = keep - front;
        return text.substr(0, starts[front]) + "\u2026" + text.substr(starts[n - back]);
    };
    std::size_t low = 0, high = n; // cut_to(low) fits or nothing does
    while (high - low > 1) {
        const std::size_t middle = (low + high) / 2;
        (text_width(cut_to(middle), size, bold) <= width ? low : high) = middle;
    }
    return low < 3 ? std::string() : cut_to(low);
}

void OverlayCanvas::polygon(const std::vector<Vec2>& corners, const Rgb& color, double alpha) {
    std::vector<vtkIdType> ids;
    for (const Vec2& c : corners) {
        ids.push_back(shape_points_->InsertNextPoint(c.x() * ratio_, height_ - c.y() * ratio_, 0.0));
        shape_colors_->InsertNextTuple4(255 * color.r, 255 * color.g, 255 * color.b, 255 * alpha);
    }
    shapes_->GetPolys()->InsertNextCell(vtkIdType(ids.size()), ids.data());
}

void OverlayCanvas::rectangle(double x0, double y0, double x1, double y1, const Rgb& color, double alpha) {
    // Whole device pixels keep thin rectangles sharp.
    const auto snap = [&](double v) { return std::round(v * ratio_) / ratio_; };
    polygon({{snap(x0), snap(y0)}, {snap(x1), snap(y0)}, {snap(x1), snap(y1)}, {snap(x0), snap(y1)}}, color,
            alpha);
}

void OverlayCanvas::disc(double x, double y, double radius, const Rgb& color) {
    std::vector<Vec2> corners;
    for (int k = 0; k < 32; ++k)
        corners.emplace_back(x + radius * std::cos(pi * k / 16), y + radius * std::sin(pi * k / 16));
    polygon(corners, color, 1.0);
}

void OverlayCanvas::stroke(const Vec2& from, const Vec2& to, double width, const Rgb& color) {
    const Vec2 along = (to - from).normalized(), side = width / 2 * Vec2(-along.y(), along.x());
    polygon({from + side, to + side, to - side, from - side}, color, 1.0);
}

void OverlayCanvas::write(const OverlayText& text) {
    if (text.text.empty()) return;
    if (texts_used_ == text_actors_.size()) {
        auto actor = vtkSmartPointer<vtkTextActor>::New();
        actor->SetTextScaleModeToNone();
        actor->SetLayerNumber(1);
        actor->PickableOff();
        actor->GetTextProperty()->SetVerticalJustificationToBottom();
        renderer_->AddViewProp(actor);
        text_actors_.push_back(actor);
    }
    vtkTextActor* actor = text_actors_[texts_used_++];
    // Whole pixels keep it sharp.
    const double pixels = text.size * ratio_;
    const double width = text_width(text.text, text.size, text.bold);
    const double x = text.align == OverlayText::Align::left    ? text.x
                     : text.align == OverlayText::Align::right ? text.x - width
                                                               : text.x - width / 2;
    vtkTextProperty* property = actor->GetTextProperty();
    set_font(property, pixels, text.bold);
    property->SetColor(text.color.r, text.color.g, text.color.b);
    actor->SetInput(overlay_words(text.text).c_str());
    actor->SetVisibility(1);
    actor->SetPosition(std::round(x * ratio_),
                       std::round(height_ - text.y * ratio_ - (0.5 * cap_height + descent) * pixels));
}

void OverlayCanvas::begin() {
    shape_points_->Reset();
    shape_colors_->Reset();
    shapes_->SetPoints(shape_points_);
    shapes_->SetPolys(vtkSmartPointer<vtkCellArray>::New());
    shapes_->GetPointData()->SetScalars(shape_colors_);
    texts_used_ = 0;
}

void OverlayCanvas::end() {
    for (std::size_t i = texts_used_; i < text_actors_.size(); ++i)
        text_actors_[i]->SetVisibility(0);
    shape_points_->Modified();
    shape_colors_->Modified();
    shapes_->Modified();
}

} // namespace facetmill
