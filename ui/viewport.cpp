#include "ui/viewport.h"

#include "ui/cube_place.h"
#include "ui/view_cube.h"

#include <QPainter>

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

/// Half a turn of the part for one travel over the shorter side of the view.
constexpr double turn_per_side = pi;
constexpr double pick_radius = 8.0;

Vec3 vec(const double* v) {
    return {v[0], v[1], v[2]};
}

/// How far a place that is held goes to stay on a line of sight: in its level plane, or upright. Where that
/// plane is seen from the side it goes in the upright plane that faces the eye.
Vec3 travel_of(const Vec3& held, const SightLine& line, bool upright) {
    constexpr double level_seen = 0.25; // a quarter of a circle's width
    const Vec3& sight = line.direction;
    const bool level = !upright && std::abs(sight.z()) > level_seen;
    const Vec3 facing(sight.x(), sight.y(), 0);
    const Vec3 n = level ? Vec3(Vec3::UnitZ()) : facing;
    const double along = sight.dot(n);
    if (!(std::abs(along) > 1e-6)) return Vec3::Zero(); // straight from above nothing can be raised
    const Vec3 by = line.at + (held - line.at).dot(n) / along * sight - held;
    return upright ? Vec3(0, 0, by.z()) : by;
}

} // namespace

Viewport::Viewport(QWidget* parent) : SceneCanvas(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    cube_ = new ViewCube(this);
    cube_place_ = new CubePlace(*this, *cube_);
    connect(cube_, &ViewCube::chosen, this, &Viewport::set_view);
    connect(cube_, &ViewCube::rolled, this, &Viewport::roll);
    connect(this, &Viewport::camera_changed, cube_, [this] { cube_->set_orientation(sight(), up()); });
    cube_->set_orientation(sight(), up());
}

Viewport::~Viewport() = default;

SceneCanvas::Hand Viewport::hand() const {
    if (!drag_ || drag_.kind() == Drag::hold) return Hand::free;
    if (drag_.kind() == Drag::tool) return Hand::paints;
    if (drag_.kind() == Drag::gizmo) return Hand::drags_view; // the part moves in it, coarse
    return drag_.kind() == Drag::handle || drag_.kind() == Drag::fixture ? Hand::drags_in_view
                                                                         : Hand::drags_view;
}

void Viewport::content_changed() {
    cube_place_->update(); // what stood in the way may be gone
    SceneCanvas::content_changed();
}

void Viewport::set_view(StandardView view) {
    scene().set_view(view);
    set_fitted(true);
    emit camera_changed();
    refresh();
}

void Viewport::roll(int quarters) {
    const Vec3 now = Eigen::AngleAxisd(-0.5 * pi * quarters, sight()) * up();
    scene().camera().vtk()->SetViewUp(now.data());
    camera_moved();
}

void Viewport::fit() {
    scene().fit();
    set_fitted(true);
    emit camera_changed();
    refresh();
}

Vec3 Viewport::sight() const {
    return vec(scene().camera().vtk()->GetDirectionOfProjection());
}

Vec3 Viewport::up() const {
    return vec(scene().camera().vtk()->GetViewUp());
}

void Viewport::resizeEvent(QResizeEvent* event) {
    cube_place_->update();
    SceneCanvas::resizeEvent(event);
}

void Viewport::turn(const QPointF& by) {
    vtkCamera* camera = scene().camera().vtk();
    const double side = std::max(1, std::min(width(), height()));
    const Vec3 forward = vec(camera->GetDirectionOfProjection());
    const Vec3 upward = forward.cross(vec(camera->GetViewUp())).cross(forward).normalized();
    const Mat3 rotation = orbit_turn(navigation_.orbit, {forward, upward}, -by.x() / side * turn_per_side,
                                     -by.y() / side * turn_per_side);
    const Vec3 position = pivot_ + rotation * (vec(camera->GetPosition()) - pivot_);
    const Vec3 focus = pivot_ + rotation * (vec(camera->GetFocalPoint()) - pivot_);
    const Vec3 new_up = (rotation * upward).normalized();
    camera->SetPosition(position.data());
    camera->SetFocalPoint(focus.data());
    camera->SetViewUp(new_up.data());
    camera_moved();
}

void Viewport::move(const QPointF& by) {
    vtkCamera* camera = scene().camera().vtk();
    const double mm_per_point = 2.0 * camera->GetParallelScale() / std::max(1, height());
    const Vec3 forward = vec(camera->GetDirectionOfProjection());
    const Vec3 right = forward.cross(vec(camera->GetViewUp())).normalized();
    const Vec3 upward = right.cross(forward);
    const Vec3 shift = mm_per_point * (-by.x() * right + by.y() * upward);
    const Vec3 position = vec(camera->GetPosition()) + shift, focus = vec(camera->GetFocalPoint()) + shift;
    camera->SetPosition(position.data());
    camera->SetFocalPoint(focus.data());
    camera_moved();
}

void Viewport::camera_moved() {
    set_fitted(false);
    emit camera_changed();
    refresh();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    // A further button may change what a drag does.
    if (drag_.kind() == Drag::move || drag_.kind() == Drag::turn || drag_.kind() == Drag::hold) {
        const Drag now = drag_of(*event);
        if (navigation_.style == NavigationStyle::freecad && now != drag_.kind() && now != Drag::hold) {
            drag_.begin(now, event->position());
            choose_pivot(drag_.press());
        }
        return;
    }
    if (drag_) return;
    rest_.stop();
    if (tool_ && event->button() == Qt::LeftButton && !(event->modifiers() & Qt::ControlModifier)
        && tool_->press(event->position(), event->modifiers()))
        return drag_.begin(Drag::tool, event->position());
    if (has_gizmo() && event->button() == Qt::LeftButton && !(event->modifiers() & Qt::ControlModifier)
        && gizmo_->press(event->position(), event->modifiers()))
        return drag_.begin(Drag::gizmo, event->position());
    drag_.begin(drag_of(*event), event->position());
    const bool takes =
        event->button() == Qt::LeftButton && (drag_.kind() == Drag::turn || drag_.kind() == Drag::hold);
    if (!(takes && take_hold(drag_.press()))) choose_pivot(drag_.press());
}

bool Viewport::take_hold(const QPointF& at) {
    if (const auto handle = handle_at(at)) {
        drag_.begin(Drag::handle, at);
        handle_from_ = handle_to_ = *handle;
        return true;
    }
    if (const auto held = fixture_at(at); held && scene().fixtures().chosen() == held->index) {
        drag_.begin(Drag::fixture, at);
        held_ = *held;
        held_by_ = Vec3::Zero();
        return true;
    }
    return false;
}

/// What is under the pointer is to stay there: in perspective that depends on how far away it is.
void Viewport::focus_under(const QPointF& at) {
    if (!scene().camera().perspective()) return;
    const QPointF p = device(at);
    if (const auto pick = scene().part().pick(p.x(), p.y())) scene().camera().focus_at(pick->point);
}

void Viewport::set_perspective(bool on) {
    scene().camera().set_perspective(on);
    is_fitted() ? fit() : camera_moved();
}

/// What is under the pointer stays there; off the part it turns about the middle of what is shown.
void Viewport::choose_pivot(const QPointF& at) {
    if (drag_.kind() == Drag::move) return focus_under(at);
    if (drag_.kind() != Drag::turn) return;
    const Box3 bounds = scene().bounds();
    pivot_ = bounds.empty() ? Vec3(Vec3::Zero()) : bounds.center();
    const QPointF p = device(at);
    if (const auto pick = scene().part().pick(p.x(), p.y())) pivot_ = pick->point;
}

Viewport::Drag Viewport::drag_of(const QMouseEvent& press) const {
    if (!(press.button() & (Qt::LeftButton | Qt::MiddleButton | Qt::RightButton))) return Drag::none;
    switch (gesture_of(navigation_.style, press.button(), press.buttons(), press.modifiers())) {
    case Gesture::turn:
        return Drag::turn;
    case Gesture::move:
        return Drag::move;
    case Gesture::zoom:
        return Drag::zoom;
    case Gesture::hold:
        return Drag::hold;
    }
    return Drag::none;
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    if (tool_ || has_gizmo()) {
        pointer_ = event->position();
        update();
    }
    if (drag_.kind() == Drag::tool && event->buttons() != Qt::NoButton)
        return tool_->drag(event->position(), event->modifiers());
    if (drag_.kind() == Drag::gizmo && event->buttons() != Qt::NoButton)
        return gizmo_->drag(event->position(), event->modifiers());
    const auto by = drag_.travel(*event);
    if (!drag_) return rest_.moved(event->position());
    if (!by) return;
    switch (drag_.kind()) {
    case Drag::turn:
        turn(*by);
        break;
    case Drag::move:
        move(*by);
        break;
    case Drag::zoom:
        zoom_at(drag_.press(), std::exp(-by->y() * 0.01));
        break;
    case Drag::handle: {
        const QPointF over = device(event->position());
        if (const auto pick = scene().part().pick(over.x(), over.y())) {
            handle_to_ = pick->point;
            emit handle_dragged(handle_from_, handle_to_);
        }
        break;
    }
    case Drag::fixture: {
        const QPointF over = device(event->position());
        held_by_ = travel_of(held_.point, scene().camera().sight_at(over.x(), over.y()),
                             event->modifiers() & Qt::ControlModifier);
        emit fixture_dragged(held_.index, held_by_);
        break;
    }
    case Drag::tool:
    case Drag::gizmo:
    case Drag::hold:
    case Drag::none:
        break;
    }
}

void Viewport::zoom_at(const QPointF& at, double factor) {
    const QPointF p = device(at);
    focus_under(at);
    scene().camera().zoom_at(p.x(), p.y(), factor);
    camera_moved();
}

std::optional<Vec3> Viewport::handle_at(const QPointF& at) const {
    const QPointF p = device(at);
    return scene().strips().pick_handle(p.x(), p.y(), pick_radius * devicePixelRatioF());
}

std::optional<SceneFixtures::Pick> Viewport::fixture_at(const QPointF& at) const {
    const QPointF p = device(at);
    return scene().fixtures().pick(p.x(), p.y(), scene().part());
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    // One of two buttons was let go: the other one goes on.
    if (navigation_.style == NavigationStyle::freecad && drag_.kind() == Drag::turn
        && event->buttons() & Qt::MiddleButton)
        return drag_.begin(Drag::move, event->position());
    const Drag was = drag_.end();
    if (was == Drag::tool) return tool_->release(event->position(), event->modifiers());
    if (was == Drag::gizmo) return gizmo_->release(event->position(), event->modifiers());
    if (was == Drag::handle && drag_.moved()) emit handle_dropped(handle_from_, handle_to_);
    if (was == Drag::fixture && drag_.moved()) emit fixture_dropped(held_.index, held_by_);
    if (drag_.moved() || was == Drag::none) return;
    if ((was == Drag::turn || was == Drag::hold || was == Drag::handle || was == Drag::fixture)
        && event->button() == Qt::LeftButton)
        click(event->position(), event->modifiers());
    if ((was == Drag::zoom || was == Drag::hold) && event->button() == Qt::RightButton)
        emit menu_requested(event->globalPosition().toPoint());
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    // Two drags in quick succession, and a second button during one.
    if (event->button() != Qt::LeftButton || drag_) return mousePressEvent(event);
    if (!tool_)
        fit();
    else if (!tool_->double_click(event->position()))
        mousePressEvent(event);
}

void Viewport::wheelEvent(QWheelEvent* event) {
    const double steps = wheel_steps(*event);
    if (steps == 0) return;
    zoom_at(event->position(), std::pow(1.2, steps));
    event->accept();
}

void Viewport::leaveEvent(QEvent* event) {
    rest_.stop();
    if (std::exchange(pointer_, std::nullopt)) update();
    emit hovered(std::nullopt);
    SceneCanvas::leaveEvent(event);
}

void Viewport::set_picking(bool on) {
    picking_ = on;
    if (on)
        setCursor(Qt::CrossCursor);
    else
        unsetCursor();
}

void Viewport::set_tool(ViewTool* tool) {
    if (drag_.kind() == Drag::tool) drag_.end();
    tool_ = tool;
    pointer_.reset();
    if (tool)
        setCursor(Qt::CrossCursor);
    else
        unsetCursor();
    update();
}

void Viewport::set_gizmo(ViewTool* gizmo) {
    if (gizmo == gizmo_) return;
    if (drag_.kind() == Drag::gizmo) drag_.end();
    gizmo_ = gizmo;
    update();
}

void Viewport::paintEvent(QPaintEvent* event) {
    SceneCanvas::paintEvent(event);
    if (!(tool_ && pointer_) && !has_gizmo()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (tool_)
        tool_->paint(painter, *pointer_);
    else
        gizmo_->paint(painter, pointer_.value_or(QPointF(-1e6, -1e6)));
}

void Viewport::click(const QPointF& at, Qt::KeyboardModifiers modifiers) {
    if (!ready()) return;
    const QPointF p = device(at);
    if (picking_) return emit point_picked(scene().part().pick(p.x(), p.y()), modifiers);
    if (const auto pick = scene().paths().pick(p.x(), p.y(), pick_radius * devicePixelRatioF()))
        emit path_picked(*pick);
    else if (const auto held = fixture_at(at))
        emit fixture_picked(held->index);
    else if (const auto part = scene().part().pick(p.x(), p.y()))
        emit part_picked(*part);
    else
        emit nothing_picked();
}

void Viewport::hover(const QPointF& at) {
    if (!ready() || drag_) return;
    const QPointF p = device(at);
    if (picking_ || tool_)
        setCursor(Qt::CrossCursor);
    else if (has_gizmo() && gizmo_->takes(at))
        setCursor(Qt::SizeAllCursor);
    else if (const auto held = fixture_at(at);
             handle_at(at) || (held && scene().fixtures().chosen() == held->index))
        setCursor(Qt::SizeAllCursor);
    else
        unsetCursor();
    emit hovered(scene().part().pick(p.x(), p.y()));
}

} // namespace facetmill::ui
