#include "ui/cspace_view.h"

#include <QKeyEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
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
constexpr double marker_radius = 10.0;
} // namespace

CSpaceView::CSpaceView(QWidget* parent) : GlCanvas(parent), window_(std::make_unique<Window>()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 140);
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

template <class Read>
void CSpaceView::render(const Read& read) {
    auto* w = window_->vtk.Get();
    auto* state = w->GetState();
    state->Reset();
    state->Push();
    w->Render();
    w->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    w->GetDisplayFramebuffer()->ActivateReadBuffer(0);
    read();
    state->Pop();
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
    render([&] { take_picture(size); });
}

QImage CSpaceView::export_picture(const QSize& size) {
    if (!make_current()) return {};
    auto* w = window_->vtk.Get();
    w->SetSize(size.width(), size.height());
    scene_.set_pixel_ratio(1);
    scene_.set_legend_visible(true);
    QImage picture(size, QImage::Format_RGB32);
    render([&] {
        auto* gl = QOpenGLContext::currentContext()->functions();
        gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
        gl->glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                         picture.bits());
    });
    picture.mirror();
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
    if (drag_) return;
    rest_.stop();
    const QPointF p = device(event->position());
    marker_ = scene_.marker_at(p.x(), p.y(), marker_radius * devicePixelRatioF());
    const bool left = event->button() == Qt::LeftButton, right = event->button() == Qt::RightButton;
    drag_.begin(left    ? (marker_ ? Drag::marker : Drag::turn)
                : right ? Drag::zoom
                        : Drag::none,
                event->position());
}

void CSpaceView::mouseMoveEvent(QMouseEvent* event) {
    const auto by = drag_.travel(*event);
    if (!drag_) return rest_.moved(event->position());
    if (!by) return;
    const double side = std::max(1, std::min(width(), height()));
    switch (drag_.kind()) {
    case Drag::turn:
        scene_.turn(-by->x() / side * pi, -by->y() / side * pi);
        refresh();
        break;
    case Drag::zoom:
        scene_.zoom(std::exp(-by->y() * 0.01));
        refresh();
        break;
    case Drag::marker:
        if (const auto under = hit(event->position())) emit tried(under->posture);
        break;
    case Drag::none:
        break;
    }
}

void CSpaceView::mouseReleaseEvent(QMouseEvent* event) {
    const Drag was = drag_.end();
    if (drag_.moved() || event->button() != Qt::LeftButton) return;
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
    const double steps = wheel_steps(*event);
    if (steps == 0) return;
    scene_.zoom(std::pow(1.15, steps));
    refresh();
    event->accept();
}

void CSpaceView::leaveEvent(QEvent* event) {
    GlCanvas::leaveEvent(event);
    rest_.stop();
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
