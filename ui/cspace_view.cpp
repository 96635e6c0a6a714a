#include "ui/cspace_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QWheelEvent>
#include <QWindow>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <cmath>

namespace facetmill::ui {

struct CSpaceView::Window {
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> vtk = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
};

namespace {
constexpr double click_slack = 4.0, marker_radius = 10.0;
} // namespace

CSpaceView::CSpaceView(QWidget* parent) : GlCanvas(parent), window_(std::make_unique<Window>()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 140);
    hover_timer_.setSingleShot(true);
    hover_timer_.setInterval(60);
    connect(&hover_timer_, &QTimer::timeout, this, [this] { emit hovered(hit(hover_at_)); });
}

CSpaceView::~CSpaceView() {
    if (!initialized() || !make_current()) return;
    scene_.detach();
    window_->vtk->Finalize();
    window_->vtk->SetReadyForRendering(false);
    done_current();
}

void CSpaceView::initialize_gl() {
    auto* w = window_->vtk.Get();
    w->SetOwnContext(0);
    w->SetIsCurrent(true);
    w->SetReadyForRendering(true);
    w->SetFrameBlitModeToNoBlit(); // the canvas reads back what is drawn
    w->SetMultiSamples(0);
    w->OpenGLInit();
    scene_.attach(w);
    dirty_ = true;
}

void CSpaceView::paint_gl() {
    auto* w = window_->vtk.Get();
    if (!w->GetReadyForRendering()) return;
    const QSize size = frame_size();
    const bool resized = w->GetSize()[0] != size.width() || w->GetSize()[1] != size.height();
    if (!dirty_ && !resized) return;
    dirty_ = false;
    w->SetSize(size.width(), size.height());
    scene_.set_pixel_ratio(devicePixelRatioF());
    auto* state = w->GetState();
    state->Reset();
    state->Push();
    w->Render();
    w->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    w->GetDisplayFramebuffer()->ActivateReadBuffer(0);
    take_picture(size);
    state->Pop();
}

QImage CSpaceView::export_picture(const QSize& size) {
    if (!make_current()) return {};
    auto* w = window_->vtk.Get();
    w->SetSize(size.width(), size.height());
    scene_.set_pixel_ratio(1);
    scene_.set_legend_visible(true);
    auto* state = w->GetState();
    state->Reset();
    state->Push();
    w->Render();
    w->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    w->GetDisplayFramebuffer()->ActivateReadBuffer(0);
    QImage picture(size, QImage::Format_RGB32);
    auto* gl = QOpenGLContext::currentContext()->functions();
    gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, picture.bits());
    picture.mirror();
    state->Pop();
    done_current();
    scene_.set_legend_visible(false);
    refresh(); // the size goes back with the next picture
    return picture;
}

void CSpaceView::refresh() {
    dirty_ = true;
    update();
}

bool CSpaceView::finished() const {
    const QWindow* shown = isVisible() ? window()->windowHandle() : nullptr;
    return !(dirty_ && shown && shown->isExposed() && !visibleRegion().isEmpty());
}

std::optional<CSpaceDisplay::Hit> CSpaceView::hit(const QPointF& at) const {
    const QPointF p = device(at);
    return scene_.hit(p.x(), p.y());
}

void CSpaceView::mousePressEvent(QMouseEvent* event) {
    if (drag_ != Drag::none) return;
    press_ = last_ = event->position();
    dragged_ = false;
    hover_timer_.stop();
    const QPointF p = device(press_);
    marker_ = scene_.marker_at(p.x(), p.y(), marker_radius * devicePixelRatioF());
    if (event->button() == Qt::LeftButton)
        drag_ = marker_ ? Drag::marker : Drag::turn;
    else if (event->button() == Qt::RightButton)
        drag_ = Drag::zoom;
}

void CSpaceView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (event->buttons() == Qt::NoButton) drag_ = Drag::none; // the release went elsewhere
    if (drag_ == Drag::none) {
        hover_at_ = at;
        hover_timer_.start();
        return;
    }
    if (!dragged_ && std::hypot(at.x() - press_.x(), at.y() - press_.y()) < click_slack) return;
    dragged_ = true;
    const QPointF by = at - last_;
    last_ = at;
    const double side = std::max(1, std::min(width(), height()));
    switch (drag_) {
    case Drag::turn:
        scene_.turn(-by.x() / side * pi, -by.y() / side * pi);
        refresh();
        break;
    case Drag::zoom:
        scene_.zoom(std::exp(-by.y() * 0.01));
        refresh();
        break;
    case Drag::marker:
        if (const auto under = hit(at)) emit tried(under->posture);
        break;
    case Drag::none:
        break;
    }
}

void CSpaceView::mouseReleaseEvent(QMouseEvent* event) {
    const Drag was = drag_;
    drag_ = Drag::none;
    if (dragged_ || event->button() != Qt::LeftButton) return;
    if (was == Drag::marker && marker_ && *marker_ < cspace_choices)
        emit choice_clicked(*marker_);
    else if (was == Drag::turn)
        if (const auto under = hit(event->position())) emit tried(under->posture);
}

void CSpaceView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    scene_.reset_view();
    refresh();
}

void CSpaceView::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps == 0) return;
    scene_.zoom(std::pow(1.15, steps));
    refresh();
    event->accept();
}

void CSpaceView::leaveEvent(QEvent* event) {
    GlCanvas::leaveEvent(event);
    hover_timer_.stop();
    emit hovered(std::nullopt);
}

void CSpaceView::keyPressEvent(QKeyEvent* event) {
    const int by = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (event->key()) {
    case Qt::Key_Left:
        return emit stepped(-by, 0);
    case Qt::Key_Right:
        return emit stepped(by, 0);
    case Qt::Key_Up:
        return emit stepped(0, -1);
    case Qt::Key_Down:
        return emit stepped(0, 1);
    default:
        GlCanvas::keyPressEvent(event);
    }
}

void CSpaceView::resizeEvent(QResizeEvent* event) {
    GlCanvas::resizeEvent(event);
    refresh();
}

} // namespace facetmill::ui
