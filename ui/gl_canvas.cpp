#include "ui/gl_canvas.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace facetmill::ui {

GlCanvas::GlCanvas(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
}

GlCanvas::~GlCanvas() = default;

QSize GlCanvas::frame_size() const {
    const double ratio = devicePixelRatioF();
    return {std::max(1, int(std::lround(width() * ratio))), std::max(1, int(std::lround(height() * ratio)))};
}

bool GlCanvas::make_current() {
    if (failed_) return false;
    if (!context_) {
        surface_ = std::make_unique<QOffscreenSurface>();
        surface_->create();
        context_ = std::make_unique<QOpenGLContext>();
        failed_ = !context_->create();
    }
    if (failed_ || !context_->makeCurrent(surface_.get())) {
        failed_ = true;
        return false;
    }
    if (!std::exchange(initialized_, true)) initialize_gl();
    return true;
}

void GlCanvas::done_current() {
    context_->doneCurrent();
}

void GlCanvas::take_picture(const QSize& drawn) {
    const QSize size = frame_size();
    const bool whole = drawn == size;
    QImage& read = whole ? picture_ : small_;
    if (read.size() != drawn) read = QImage(drawn, QImage::Format_RGB32);
    auto* gl = context_->functions();
    gl->glPixelStorei(GL_PACK_ALIGNMENT, 4); // rows of 32 bits a pixel lie without gaps in a QImage, too
    gl->glReadPixels(0, 0, drawn.width(), drawn.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, read.bits());
    read.mirror();
    if (!whole) {
        if (picture_.size() != size) picture_ = QImage(size, QImage::Format_RGB32);
        picture_.setDevicePixelRatio(1);
        QPainter painter(&picture_);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setCompositionMode(QPainter::CompositionMode_Source);
        painter.drawImage(picture_.rect(), small_);
    }
    picture_.setDevicePixelRatio(devicePixelRatioF());
}

void GlCanvas::draw() {
    if (!make_current()) return;
    paint_gl();
    done_current();
}

QImage GlCanvas::picture() {
    draw();
    return picture_;
}

void GlCanvas::paintEvent(QPaintEvent*) {
    draw();
    QPainter painter(this);
    if (picture_.isNull())
        painter.fillRect(rect(), palette().window());
    else if (picture_.size() == frame_size())
        painter.drawImage(QPoint(0, 0), picture_);
    else
        painter.drawImage(rect(), picture_); // until it is drawn in the new size
}

} // namespace facetmill::ui
