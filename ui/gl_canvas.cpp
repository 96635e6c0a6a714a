#include "ui/gl_canvas.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QSurfaceFormat>

#include <algorithm>
#include <cmath>
#include <utility>

namespace facetmill::ui {

namespace {
/// Between two looks whether a picture is drawn.
constexpr int look_ms = 1;
constexpr int band_rows = 48;
} // namespace

GlCanvas::GlCanvas(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    look_timer_.setInterval(look_ms);
    look_timer_.setTimerType(Qt::PreciseTimer);
    connect(&look_timer_, &QTimer::timeout, this, [this] { look_for_frame(false); });
}

GlCanvas::~GlCanvas() {
    if (fence_ && make_current()) {
        context_->extraFunctions()->glDeleteSync(static_cast<GLsync>(fence_));
        done_current();
    }
}

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
    GLint framebuffer = 0;
    context_->functions()->glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    read(unsigned(framebuffer), drawn);
}

void GlCanvas::read(unsigned framebuffer, const QSize& drawn) {
    const QSize size = frame_size();
    const bool whole = drawn == size;
    QImage& read = whole ? picture_ : small_;
    if (read.size() != drawn) read = QImage(drawn, QImage::Format_RGB32);
    auto* gl = context_->functions();
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    gl->glPixelStorei(GL_PACK_ALIGNMENT, 4); // rows of 32 bits a pixel lie without gaps in a QImage, too
    gl->glReadPixels(0, 0, drawn.width(), drawn.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, read.bits());
    read.mirror();
    if (!whole) {
        if (picture_.size() != size) picture_ = QImage(size, QImage::Format_RGB32);
        picture_.setDevicePixelRatio(1);
        QPainter painter(&picture_);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setCompositionMode(QPainter::CompositionMode_Source);
        // In bands so low that Qt does not give them to other threads and wait for those.
        for (int y = 0; y < size.height(); y += band_rows) {
            painter.setClipRect(0, y, size.width(), band_rows);
            painter.drawImage(picture_.rect(), small_);
        }
    }
    picture_.setDevicePixelRatio(devicePixelRatioF());
}

void GlCanvas::start_waiting() {
    auto* gl = context_->extraFunctions();
    fence_ = gl->glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl->glFlush();
    look_timer_.start();
}

void GlCanvas::await_picture(const QSize& drawn) {
    GLint framebuffer = 0;
    context_->functions()->glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    to_read_.emplace(unsigned(framebuffer), drawn);
    start_waiting();
}

void GlCanvas::await_drawn() {
    to_read_.reset();
    start_waiting();
}

void GlCanvas::look_for_frame(bool wait) {
    if (!fence_ || !make_current()) return;
    auto* gl = context_->extraFunctions();
    const GLuint64 longest_ns = wait ? 10'000'000'000u : 0u;
    const GLenum state = gl->glClientWaitSync(static_cast<GLsync>(fence_), 0, longest_ns);
    // After an error nothing is known of the fence: reading waits by itself.
    if (state == GL_TIMEOUT_EXPIRED && !wait) return done_current();
    gl->glDeleteSync(static_cast<GLsync>(fence_));
    fence_ = nullptr;
    look_timer_.stop();
    if (const auto picture = std::exchange(to_read_, std::nullopt)) read(picture->first, picture->second);
    done_current();
    frame_done();
}

void GlCanvas::draw() {
    if (!make_current()) return;
    paint_gl();
    done_current();
}

QImage GlCanvas::picture() {
    look_for_frame(true); // what is under way may be of something older
    draw();
    look_for_frame(true);
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

void GlCanvas::set_default_format() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setAlphaBufferSize(8);
    format.setSamples(0);
    format.setSwapBehavior(QSurfaceFormat::DoubleBuffer);
    QSurfaceFormat::setDefaultFormat(format);
}

QString GlCanvas::why_unavailable() {
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface)) return tr("the display offers no OpenGL");
    const QSurfaceFormat got = context.format();
    context.doneCurrent();
    if (got.version() >= qMakePair(3, 2)) return {};
    return tr("the display offers OpenGL %1.%2 only; 3.2 is needed")
        .arg(got.majorVersion())
        .arg(got.minorVersion());
}

} // namespace facetmill::ui
