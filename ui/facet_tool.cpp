#include "ui/facet_tool.h"

#include "ui/theme.h"
#include "ui/viewport.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace facetmill::ui {

namespace {

/// Between two places that a brush touches on its way: a share of its radius, and no less than some points.
constexpr double brush_step = 0.4, min_step = 2;
/// A box of fewer points is a slip of the hand.
constexpr double min_box = 3;

} // namespace

FacetTool::FacetTool(Viewport& viewport, QObject* parent) : QObject(parent), viewport_(viewport) {
    connect(&search_, &BackgroundJob::ended, this, [this] { emit settled(); });
}

void FacetTool::begin(std::shared_ptr<FacetPainter> painter, std::vector<char> marks) {
    painter_ = std::move(painter);
    marks_ = std::move(marks);
    changed_ = false;
    corner_.reset();
    search_.cancel();
}

void FacetTool::take(const std::vector<Index>& facets) {
    std::vector<Index> changed;
    for (const Index f : facets)
        if (bool(marks_[f]) != in_) {
            marks_[f] = in_;
            changed.push_back(f);
        }
    if (changed.empty()) return;
    changed_ = true;
    emit painted(changed, in_);
}

double FacetTool::mm_per_point(const QPointF& at) const {
    const Scene& scene = viewport_.scene();
    const double ratio = viewport_.devicePixelRatioF();
    if (!scene.camera().perspective()) return scene.camera().pixel_size() * ratio;
    const auto pick = scene.part().pick(at.x() * ratio, at.y() * ratio);
    return ratio * (pick ? scene.camera().pixel_size(pick->point) : scene.camera().pixel_size());
}

bool FacetTool::touch(const QPointF& at) {
    const QPointF p = at * viewport_.devicePixelRatioF();
    const auto pick = viewport_.scene().part().pick(p.x(), p.y());
    if (!pick) return false;
    const auto facet = Index(pick->facet);
    take(settings_.shape == PaintSettings::Shape::flood
             ? painter_->flood(facet, settings_.angle)
             : painter_->brush(facet, pick->point, settings_.radius));
    return true;
}

bool FacetTool::press(const QPointF& at, Qt::KeyboardModifiers keys) {
    if (!painter_) return false;
    if (busy()) return true;
    in_ = settings_.erase == bool(keys & Qt::ShiftModifier);
    changed_ = false;
    last_ = at;
    if (settings_.shape != PaintSettings::Shape::box) return touch(at);
    corner_ = at;
    return true;
}

void FacetTool::drag(const QPointF& at, Qt::KeyboardModifiers) {
    if (busy() || settings_.shape != PaintSettings::Shape::brush) return;
    const double mm = mm_per_point(at);
    const double step = std::max(min_step, mm > 0 ? brush_step * settings_.radius / mm : 0);
    const QPointF travel = at - last_;
    const double length = std::hypot(travel.x(), travel.y());
    const int steps = int(length / step);
    const QPointF from = last_;
    for (int k = 1; k <= steps; ++k) {
        last_ = from + travel * (k * step / length);
        touch(last_);
    }
}

void FacetTool::release(const QPointF& at, Qt::KeyboardModifiers keys) {
    drag(at, keys);
    if (const auto from = std::exchange(corner_, std::nullopt)) {
        const QRectF box = QRectF(*from, at).normalized();
        if (std::max(box.width(), box.height()) >= min_box) take_box(box);
        viewport_.update();
    }
    end_stroke();
}

/// On a million facets it takes a second to find those that are seen: not in the window's thread.
void FacetTool::take_box(const QRectF& box) {
    const double ratio = viewport_.devicePixelRatioF();
    const auto search = viewport_.scene().part().facets_in(
        Vec2(box.left(), box.top()) * ratio, Vec2(box.right(), box.bottom()) * ratio, settings_.through);
    const auto found = std::make_shared<std::vector<Index>>();
    search_.start(
        tr("Finding facets in a box"), [search, found](const Progress& p) { *found = search(p); },
        [this, found, of = painter_](const JobEnd& end) {
            if (!end.done() || painter_ != of) return;
            take(*found);
            end_stroke();
        });
}

void FacetTool::end_stroke() {
    if (std::exchange(changed_, false)) emit stroke_ended();
}

void FacetTool::paint(QPainter& painter, const QPointF& pointer) {
    const FixedColors& colors = fixed_colors();
    // Dark on bright: seen on any colour.
    for (const auto& [color, width] :
         {std::pair(to_qt(colors.outline_ring), 3.0), std::pair(to_qt(colors.outline), 1.2)}) {
        painter.setPen(QPen(color, width));
        painter.setBrush(Qt::NoBrush);
        if (corner_) painter.drawRect(QRectF(*corner_, pointer).normalized());
        const double mm = mm_per_point(pointer);
        if (settings_.shape == PaintSettings::Shape::brush && mm > 0)
            painter.drawEllipse(pointer, settings_.radius / mm, settings_.radius / mm);
    }
}

} // namespace facetmill::ui
