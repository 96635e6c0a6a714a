#include "ui/viewport.h"

#include "ui/view_cube.h"

#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <QWheelEvent>
#include <QWindow>

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <utility>

namespace facetmill::ui {

struct Viewport::Window {
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> vtk = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
};

namespace {

/// Pointer travel, in points, below which a press and release is a click.
constexpr double click_slack = 4.0;
/// Half a turn of the part for one travel over the shorter side of the view.
constexpr double turn_per_side = pi;
constexpr double pick_radius = 8.0;
/// A full picture that takes longer is replaced by a coarse one until nothing changes any more.
constexpr double slow_frame_ms = 40.0;
/// Coarseness 1 is the scene's preview without smoothing; 2 has half the pixels a side besides, 3 a third.
constexpr int coarsest = 3;
constexpr double dear_frame_ms = 16.0, cheap_frame_ms = 5.0;
constexpr int rest_ms = 250;
/// Without a new picture before shaders of later ones are rehearsed: none while something moves. In an empty
/// window there is nothing that could.
constexpr int rehearsal_ms = 120, empty_rehearsal_ms = 20;

Vec3 vec(const double* v) {
    return {v[0], v[1], v[2]};
}

} // namespace

void Viewport::set_default_format() {
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

QString Viewport::why_unavailable() {
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

Viewport::Viewport(QWidget* parent) : GlCanvas(parent), window_(std::make_unique<Window>()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    cube_ = new ViewCube(this);
    connect(cube_, &ViewCube::chosen, this, &Viewport::set_view);
    connect(this, &Viewport::camera_changed, cube_, [this] { cube_->set_orientation(sight(), up()); });
    hover_timer_.setSingleShot(true);
    hover_timer_.setInterval(60);
    connect(&hover_timer_, &QTimer::timeout, this, &Viewport::hover);
    cube_->set_orientation(sight(), up());
    rest_timer_.setSingleShot(true);
    rest_timer_.setInterval(rest_ms);
    connect(&rest_timer_, &QTimer::timeout, this, &Viewport::rested);
    step_timer_.setSingleShot(true);
    step_timer_.setInterval(0);
    connect(&step_timer_, &QTimer::timeout, this, &Viewport::draw_step);
    pace_timer_.setSingleShot(true);
    pace_timer_.setInterval(0);
    connect(&pace_timer_, &QTimer::timeout, this, [this] { update(); });
    rehearsal_timer_.setSingleShot(true);
    connect(&rehearsal_timer_, &QTimer::timeout, this, &Viewport::rehearse);
}

Viewport::~Viewport() {
    if (!initialized() || !make_current()) return;
    scene_.detach();
    window_->vtk->Finalize();
    window_->vtk->SetReadyForRendering(false);
    done_current();
}

void Viewport::initialize_gl() {
    auto* w = window_->vtk.Get();
    w->SetOwnContext(0);
    w->SetIsCurrent(true);
    w->SetReadyForRendering(true);
    // The canvas reads back what is drawn, where it is drawn: without a graphics card, copying it elsewhere
    // first would wait for it.
    w->SetFrameBlitModeToNoBlit();
    w->SetSwapBuffers(0);
    w->SetMultiSamples(0);
    w->OpenGLInit();
    scene_.attach(w);
    dirty_ = true;
    const auto* name = QOpenGLContext::currentContext()->functions()->glGetString(GL_RENDERER);
    const QString renderer = name ? QString::fromUtf8(reinterpret_cast<const char*>(name)) : QString();
    without_card_ = false;
    for (const char* processor :
         {"llvmpipe", "softpipe", "swrast", "software", "swiftshader", "basic render"})
        without_card_ = without_card_ || renderer.contains(QLatin1String(processor), Qt::CaseInsensitive);
}

bool Viewport::slow() const {
    return full_frame_ms_ < 0 ? scene_.has_preview() : full_frame_ms_ > slow_frame_ms;
}

void Viewport::paint_gl() {
    auto* w = window_->vtk.Get();
    if (!w->GetReadyForRendering()) return;
    const double ratio = devicePixelRatioF();
    const QSize size = frame_size();
    const bool resized = w->GetSize()[0] != size.width() || w->GetSize()[1] != size.height();
    if (resized) stop_steps();
    if (awaiting() || (!dirty_ && !resized)) return;
    dirty_ = false;
    w->SetSize(size.width(), size.height());
    scene_.set_pixel_ratio(ratio);
    if (fitted_ && resized) scene_.fit();
    coarse_ = !std::exchange(whole_, false) && slow();
    // New content goes to the graphics card in its first picture, which says nothing about the later ones. It
    // does so by steps, as long as nobody turns it; until then the old picture stands.
    const bool fresh = std::exchange(fresh_, false);
    if (coarse_ && fresh && drag_ == Drag::none) {
        rested();
        return;
    }
    const bool first = full_frame_ms_ < 0;
    drawing_ = !coarse_ ? Drawing::full_picture : first ? Drawing::first_picture : Drawing::coarse_picture;
    draw(!coarse_ ? 0 : first ? 2 : coarseness_);
}

void Viewport::frame_done() {
    const Drawing drawn = std::exchange(drawing_, Drawing::nothing);
    const double ms = double(drawing_since_.nsecsElapsed()) * 1e-6;
    switch (drawn) {
    case Drawing::nothing: // something changed meanwhile
    case Drawing::rehearsal:
        break;
    case Drawing::step:
        step_ms_ += ms;
        if (*step_ < steps_) {
            step_timer_.start();
            return;
        }
        stop_steps();
        full_frame_ms_ = last_frame_ms_ = step_ms_;
        coarse_ = false;
        ++frames_;
        break;
    case Drawing::first_picture:
    case Drawing::coarse_picture:
        ++frames_;
        last_frame_ms_ = ms;
        if (drawn == Drawing::first_picture)
            coarseness_ = 1;
        else if (ms > dear_frame_ms)
            coarseness_ = std::min(coarseness_ + 1, coarsest);
        else if (ms < cheap_frame_ms)
            coarseness_ = std::max(coarseness_ - 1, 1);
        rest_timer_.start();
        break;
    case Drawing::full_picture:
        ++frames_;
        last_frame_ms_ = ms;
        // The first picture of all compiles shaders and says nothing about the later ones.
        if (frames_ > 1 && !fresh_) full_frame_ms_ = ms;
        break;
    }
    if (rehearsed_ < Scene::rehearsals)
        rehearsal_timer_.start(scene_.has(Layer::scale) ? rehearsal_ms : empty_rehearsal_ms);
    update();
    if (drawn == Drawing::step || drawn == Drawing::full_picture) emit this->drawn();
}

void Viewport::draw(int coarseness) {
    auto* w = window_->vtk.Get();
    const int width_px = w->GetSize()[0], height_px = w->GetSize()[1], part = std::max(1, coarseness);
    const double ratio = devicePixelRatioF();
    drawing_since_.start();
    scene_.set_moving(coarseness > 0);
    scene_.set_antialiasing(coarseness == 0);
    auto* state = w->GetState();
    state->Reset();
    state->Push();
    if (part == 1) {
        w->Render();
        await_frame();
    } else {
        // Fewer pixels, shown larger. Afterwards the window has its size again: picking counts in its pixels.
        w->SetSize(std::max(1, width_px / part), std::max(1, height_px / part));
        scene_.set_pixel_ratio(ratio / part);
        w->Render();
        await_frame();
        w->SetSize(width_px, height_px);
        scene_.set_pixel_ratio(ratio);
    }
    state->Pop();
}

void Viewport::await_frame() {
    const bool seen = drawing_ == Drawing::step ? *step_ == steps_ : drawing_ != Drawing::rehearsal;
    if (!seen) return await_drawn();
    auto* w = window_->vtk.Get();
    w->GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    w->GetRenderFramebuffer()->ActivateReadBuffer(0);
    await_picture({w->GetSize()[0], w->GetSize()[1]});
}

void Viewport::rehearse() {
    // A shader takes some 50 ms: only while nothing else goes on. The next picture starts the timer again.
    if (dirty_ || awaiting() || coarse_ || step_ || drag_ != Drag::none || rehearsed_ >= Scene::rehearsals
        || !window_->vtk->GetReadyForRendering())
        return;
    if (!make_current()) return;
    scene_.rehearse(rehearsed_++);
    drawing_ = Drawing::rehearsal;
    draw(1);
    scene_.end_rehearsal();
    scene_.set_moving(false);
    scene_.set_antialiasing(true);
    done_current();
}

void Viewport::rested() {
    if (drag_ != Drag::none && drag_ != Drag::handle) {
        rest_timer_.start(); // held still, but not let go
        return;
    }
    if (!coarse_ || dirty_ || awaiting() || !window_->vtk->GetReadyForRendering()) return;
    scene_.set_moving(false);
    scene_.set_antialiasing(true);
    steps_ = scene_.begin_steps();
    step_ = 0;
    step_ms_ = 0;
    step_timer_.start();
}

void Viewport::draw_step() {
    if (!step_ || awaiting() || !make_current()) return;
    drawing_since_.start();
    auto* w = window_->vtk.Get();
    auto* state = w->GetState();
    state->Reset();
    state->Push();
    scene_.set_step(*step_);
    w->Render();
    ++*step_;
    drawing_ = Drawing::step;
    await_frame();
    state->Pop();
    done_current();
}

void Viewport::stop_steps() {
    if (!step_) return;
    step_.reset();
    step_timer_.stop();
    if (drawing_ == Drawing::step) drawing_ = Drawing::nothing;
    scene_.end_steps();
}

bool Viewport::finished() const {
    const QWindow* shown = isVisible() ? window()->windowHandle() : nullptr;
    return !coarse_ && !step_ && !awaiting() && !(dirty_ && shown && shown->isExposed());
}

void Viewport::content_changed() {
    full_frame_ms_ = -1;
    fresh_ = true;
    place_overlays(); // what stood in the way may be gone
    refresh();
}

void Viewport::refresh() {
    stop_steps();
    dirty_ = true;
    if (awaiting()) return; // the next one follows it
    // Pictures that take a while come by way of a timer, so that other timers and events get their turn in
    // between.
    if (!slow())
        update();
    else if (!pace_timer_.isActive())
        pace_timer_.start();
}

QImage Viewport::full_picture() {
    refresh();
    whole_ = true;
    return picture();
}

void Viewport::set_view(StandardView view) {
    scene_.set_view(view);
    fitted_ = true;
    emit camera_changed();
    refresh();
}

void Viewport::fit() {
    scene_.fit();
    fitted_ = true;
    emit camera_changed();
    refresh();
}

Vec3 Viewport::sight() const {
    return vec(scene_.camera().vtk()->GetDirectionOfProjection());
}

Vec3 Viewport::up() const {
    return vec(scene_.camera().vtk()->GetViewUp());
}

void Viewport::resizeEvent(QResizeEvent* event) {
    GlCanvas::resizeEvent(event);
    place_overlays();
    refresh();
}

void Viewport::place_overlays() {
    // Lower right, above the scale bar: the legend stands above, the axes on the left.
    const int margin = 8, scale_bar = 52;
    cube_->move(width() - cube_->width() - margin, height() - cube_->height() - scale_bar);
    bool free = width() > 260 && height() > 200;
    for (const QWidget* other : findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        if (other != cube_ && !other->isHidden() && other->geometry().intersects(cube_->geometry()))
            free = false;
    cube_->setVisible(free);
    const QRectF covered = free ? QRectF(cube_->geometry()) : QRectF();
    scene_.strips().set_covered({covered.left(), covered.top()}, {covered.right(), covered.bottom()});
}

void Viewport::turn(const QPointF& by) {
    fitted_ = false;
    vtkCamera* camera = scene_.camera().vtk();
    const double side = std::max(1, std::min(width(), height()));
    const Vec3 forward = vec(camera->GetDirectionOfProjection());
    Vec3 upward = vec(camera->GetViewUp());
    const Vec3 right = forward.cross(upward).normalized();
    upward = right.cross(forward).normalized();
    const Eigen::AngleAxisd about_up(-by.x() / side * turn_per_side, upward);
    const Eigen::AngleAxisd about_right(-by.y() / side * turn_per_side, right);
    const Mat3 rotation = (about_up * about_right).toRotationMatrix();
    const Vec3 position = pivot_ + rotation * (vec(camera->GetPosition()) - pivot_);
    const Vec3 focus = pivot_ + rotation * (vec(camera->GetFocalPoint()) - pivot_);
    const Vec3 new_up = (rotation * upward).normalized();
    camera->SetPosition(position.data());
    camera->SetFocalPoint(focus.data());
    camera->SetViewUp(new_up.data());
    emit camera_changed();
    refresh();
}

void Viewport::move(const QPointF& by) {
    fitted_ = false;
    vtkCamera* camera = scene_.camera().vtk();
    const double mm_per_point = 2.0 * camera->GetParallelScale() / std::max(1, height());
    const Vec3 forward = vec(camera->GetDirectionOfProjection());
    const Vec3 right = forward.cross(vec(camera->GetViewUp())).normalized();
    const Vec3 upward = right.cross(forward);
    const Vec3 shift = mm_per_point * (-by.x() * right + by.y() * upward);
    const Vec3 position = vec(camera->GetPosition()) + shift, focus = vec(camera->GetFocalPoint()) + shift;
    camera->SetPosition(position.data());
    camera->SetFocalPoint(focus.data());
    emit camera_changed();
    refresh();
}

void Viewport::camera_moved() {
    fitted_ = false;
    emit camera_changed();
    refresh();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    if (drag_ != Drag::none) return; // a second button during a drag changes nothing
    press_ = last_ = event->position();
    dragged_ = false;
    hover_timer_.stop();
    if (event->button() == Qt::LeftButton)
        drag_ = event->modifiers() & Qt::ShiftModifier ? Drag::move : Drag::turn;
    else if (event->button() == Qt::MiddleButton)
        drag_ = Drag::move;
    else if (event->button() == Qt::RightButton)
        drag_ = Drag::zoom;
    if (drag_ == Drag::turn) {
        if (const auto handle = handle_at(press_)) {
            drag_ = Drag::handle;
            handle_from_ = handle_to_ = *handle;
            return;
        }
        // What is under the pointer stays there; off the part it turns about the middle of what is shown.
        const Box3 bounds = scene_.bounds();
        pivot_ = bounds.empty() ? Vec3(Vec3::Zero()) : bounds.center();
        const QPointF at = device(press_);
        if (const auto pick = scene_.part().pick(at.x(), at.y())) pivot_ = pick->point;
    }
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
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
    switch (drag_) {
    case Drag::turn:
        turn(by);
        break;
    case Drag::move:
        move(by);
        break;
    case Drag::zoom: {
        const QPointF center = device(press_);
        scene_.camera().zoom_at(center.x(), center.y(), std::exp(-by.y() * 0.01));
        fitted_ = false;
        emit camera_changed();
        refresh();
        break;
    }
    case Drag::handle: {
        const QPointF over = device(at);
        if (const auto pick = scene_.part().pick(over.x(), over.y())) {
            handle_to_ = pick->point;
            emit handle_dragged(handle_from_, handle_to_);
        }
        break;
    }
    case Drag::none:
        break;
    }
}

std::optional<Vec3> Viewport::handle_at(const QPointF& at) const {
    const QPointF p = device(at);
    return scene_.strips().pick_handle(p.x(), p.y(), pick_radius * devicePixelRatioF());
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    const Drag was = drag_;
    drag_ = Drag::none;
    if (was == Drag::handle && dragged_) emit handle_dropped(handle_from_, handle_to_);
    if (dragged_ || was == Drag::none) return;
    if ((was == Drag::turn || was == Drag::handle) && event->button() == Qt::LeftButton)
        click(event->position(), event->modifiers());
    if (was == Drag::zoom) emit menu_requested(event->globalPosition().toPoint());
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) fit();
}

void Viewport::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps == 0) return;
    const QPointF at = device(event->position());
    scene_.camera().zoom_at(at.x(), at.y(), std::pow(1.2, steps));
    fitted_ = false;
    emit camera_changed();
    refresh();
    event->accept();
}

void Viewport::leaveEvent(QEvent* event) {
    hover_timer_.stop();
    emit hovered(std::nullopt);
    GlCanvas::leaveEvent(event);
}

void Viewport::set_picking(bool on) {
    picking_ = on;
    if (on)
        setCursor(Qt::CrossCursor);
    else
        unsetCursor();
}

void Viewport::click(const QPointF& at, Qt::KeyboardModifiers modifiers) {
    if (!window_->vtk->GetReadyForRendering()) return;
    const QPointF p = device(at);
    if (picking_) return emit point_picked(scene_.part().pick(p.x(), p.y()), modifiers);
    if (const auto pick = scene_.paths().pick(p.x(), p.y(), pick_radius * devicePixelRatioF()))
        emit path_picked(*pick);
    else if (const auto part = scene_.part().pick(p.x(), p.y()))
        emit part_picked(*part);
    else
        emit nothing_picked();
}

void Viewport::hover() {
    if (!window_->vtk->GetReadyForRendering() || drag_ != Drag::none) return;
    const QPointF p = device(hover_at_);
    if (picking_)
        setCursor(Qt::CrossCursor);
    else if (handle_at(hover_at_))
        setCursor(Qt::SizeAllCursor);
    else
        unsetCursor();
    emit hovered(scene_.part().pick(p.x(), p.y()));
}

} // namespace facetmill::ui
