#include "viz/scene_camera.h"

#include "viz/overlay.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr double fit_margin = 1.07;       // free room around what is fitted
constexpr double empty_view_height = 100; // mm, of an empty scene
constexpr double view_angle = 30;         // degrees, of a perspective picture's height
/// Places nearer to the eye than this share of the focal point's distance are behind it.
constexpr double nearest_share = 1e-3;
constexpr double behind_eye = -1e6; // pixels

double eye_distance(double scale) {
    return scale / std::tan(0.5 * radians(view_angle));
}

/// Direction from the scene to the eye, and up.
std::pair<Vec3, Vec3> view_vectors(StandardView view) {
    const Vec3 z(0, 0, 1), y(0, 1, 0);
    switch (view) {
    case StandardView::iso:
        return {Vec3(1, -1, 0.9).normalized(), z};
    case StandardView::front:
        return {Vec3(0, -1, 0), z};
    case StandardView::rear:
        return {Vec3(0, 1, 0), z};
    case StandardView::right:
        return {Vec3(1, 0, 0), z};
    case StandardView::left:
        return {Vec3(-1, 0, 0), z};
    case StandardView::top:
        return {Vec3(0, 0, 1), y};
    case StandardView::bottom:
        return {Vec3(0, 0, -1), y};
    }
    return {z, y};
}

/// The rectangle r grown by `by` and the shadow of a box, given by its centre and the flat images of its
/// three half edges, have a point in common (separating axes: the rectangle's two and the three edges'
/// normals).
bool meets(const LayoutRect& r, double by, const Vec2& center, const std::array<Vec2, 3>& half) {
    if (r.empty()) return false;
    const Vec2 middle((r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2), extent(r.width() / 2 + by, r.height() / 2 + by);
    const auto apart = [&](const Vec2& axis) {
        const double reach = std::abs(axis.x()) * extent.x() + std::abs(axis.y()) * extent.y()
                             + std::abs(axis.dot(half[0])) + std::abs(axis.dot(half[1]))
                             + std::abs(axis.dot(half[2]));
        return std::abs(axis.dot(center - middle)) > reach;
    };
    if (apart({1, 0}) || apart({0, 1})) return false;
    for (const Vec2& h : half)
        if (h.squaredNorm() > 0 && apart({-h.y(), h.x()})) return false;
    return true;
}

LayoutRect around(const LayoutRect& a, const LayoutRect& b) {
    if (a.empty() || b.empty()) return a.empty() ? b : a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

struct Fit {
    double pixels_per_mm = 0;
    Vec2 center; ///< middle of the box on the screen, layout pixels, y down
};

/// The largest scale at which a box's shadow stays clear of the things in the corners. `half` are the flat
/// images of the half edges in mm, y down. Each corner is left out in one of three ways: not at all (the
/// shadow may just miss it), to its side, or above or below it; the best of all ways that keep clear wins.
Fit best_fit(double width, double height, const OverlayLayout& overlay, const std::array<Vec2, 3>& half) {
    const double reach_x = std::abs(half[0].x()) + std::abs(half[1].x()) + std::abs(half[2].x());
    const double reach_y = std::abs(half[0].y()) + std::abs(half[1].y()) + std::abs(half[2].y());
    // Two things stand one above the other in the lower right corner.
    const std::array<LayoutRect, 5> things{overlay.title, overlay.legend, overlay.axes, overlay.scale,
                                           overlay.covered};
    const std::array<LayoutRect, 4> corners{overlay.title, overlay.legend, overlay.axes,
                                            around(overlay.scale, overlay.covered)};
    const auto scale_in = [&](const LayoutRect& r) {
        const double sx = reach_x > 0 ? r.width() / (2 * reach_x * fit_margin) : infinity;
        const double sy = reach_y > 0 ? r.height() / (2 * reach_y * fit_margin) : infinity;
        return std::min(sx, sy);
    };
    const LayoutRect all{0, 0, width, height};
    Fit best{scale_in(all), Vec2(width / 2, height / 2)};
    double best_score = 0;
    for (int route = 0; route < 81; ++route) {
        LayoutRect r = all;
        for (int i = 0, rest = route; i < 4; ++i, rest /= 3) {
            const LayoutRect& t = corners[std::size_t(i)];
            if (t.empty()) continue;
            const bool left = i == 0 || i == 2, top = i < 2;
            if (rest % 3 == 1) {
                if (left)
                    r.x0 = std::max(r.x0, t.x1);
                else
                    r.x1 = std::min(r.x1, t.x0);
            } else if (rest % 3 == 2) {
                if (top)
                    r.y0 = std::max(r.y0, t.y1);
                else
                    r.y1 = std::min(r.y1, t.y0);
            }
        }
        if (r.width() < 0.35 * width || r.height() < 0.35 * height) continue;
        const double scale = scale_in(r);
        if (!std::isfinite(scale)) continue;
        const std::array<Vec2, 3> drawn{half[0] * scale, half[1] * scale, half[2] * scale};
        // As near to the window's middle as it stays clear.
        const Vec2 own((r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2), middle(width / 2, height / 2);
        for (const double t : {1.0, 0.75, 0.5, 0.25, 0.0}) {
            const Vec2 center = own + t * (middle - own);
            bool clear = true;
            for (const LayoutRect& thing : things)
                clear = clear && !meets(thing, 7, center, drawn);
            if (!clear) continue;
            // A little smaller is better than far off the middle; the last factor settles ties the same way
            // on every machine.
            const double score =
                scale * (1.0 - 0.3 * (center - middle).norm() / (width + height)) * (1.0 - 1e-6 * route);
            if (score > best_score) {
                best_score = score;
                best = {scale, center};
            }
            break;
        }
    }
    return best;
}

} // namespace

SceneCamera::SceneCamera(vtkRenderer* renderer) : renderer_(renderer) {
    vtk()->ParallelProjectionOn(); // makes the camera, too
    vtk()->SetViewAngle(view_angle);
}

SceneCamera::~SceneCamera() = default;

vtkCamera* SceneCamera::vtk() const {
    return renderer_->GetActiveCamera();
}

void SceneCamera::set_window(vtkRenderWindow* window) {
    window_ = window;
}

vtkRenderWindow* SceneCamera::window() const {
    return window_;
}

Eigen::Vector2i SceneCamera::window_size() const {
    if (!window_) return {0, 0};
    const int* size = window_->GetSize();
    return {size[0], size[1]};
}

Mat3 SceneCamera::frame() const {
    vtkMatrix4x4* m = vtk()->GetViewTransformMatrix();
    Mat3 axes;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            axes(r, c) = m->GetElement(r, c);
    return axes;
}

Vec3 SceneCamera::toward_eye() const {
    return frame().row(2).transpose();
}

double SceneCamera::pixel_size() const {
    const int height = window_size().y();
    return height > 0 ? 2.0 * vtk()->GetParallelScale() / height : 0.0;
}

Vec2 Projection::pixel(const Vec3& place) const {
    if (mm_ <= 0) return Vec2::Zero();
    const double mm = pixel_size(place);
    if (!(mm > 0)) return Vec2::Constant(behind_eye);
    const Vec3 d = axes_ * (place - focal_);
    return middle_ + Vec2(d.x(), -d.y()) / mm;
}

double Projection::pixel_size(const Vec3& place) const {
    if (eye_ == infinity) return mm_;
    const double share = 1 + depth(place) / eye_;
    return share > nearest_share ? share * mm_ : 0;
}

SightLine Projection::sight_to(const Vec3& place) const {
    if (eye_ == infinity) return {place, -axes_.row(2).transpose(), infinity};
    const Vec3 from_eye = place - (focal_ + eye_ * axes_.row(2).transpose());
    const double length = from_eye.norm();
    if (!(length > 0)) return {place, -axes_.row(2).transpose(), 0};
    return {place, from_eye / length, (1 - nearest_share) * length};
}

SightLine Projection::sight_at(double x, double y) const {
    const Vec2 off = (Vec2(x, y) - middle_) * mm_;
    return sight_to(focal_ + axes_.row(0).transpose() * off.x() - axes_.row(1).transpose() * off.y());
}

Projection SceneCamera::projection() const {
    Projection now;
    now.focal_ = Vec3(vtk()->GetFocalPoint());
    now.axes_ = frame();
    now.middle_ = window_size().cast<double>() / 2;
    now.mm_ = pixel_size();
    if (perspective()) now.eye_ = eye_distance(vtk()->GetParallelScale());
    return now;
}

Vec3 SceneCamera::point_at(double x, double y) const {
    return projection().sight_at(x, y).at;
}

Vec2 SceneCamera::display_of(const Vec3& point) const {
    return projection().pixel(point);
}

bool SceneCamera::perspective() const {
    return vtk()->GetParallelProjection() == 0;
}

void SceneCamera::set_perspective(bool on) {
    if (on == perspective()) return;
    if (on) away_ = vtk()->GetDistance();
    vtk()->SetParallelProjection(!on);
    place_at(Vec3(vtk()->GetFocalPoint()), away_, vtk()->GetParallelScale());
}

CameraPlace SceneCamera::place() const {
    vtkCamera* camera = vtk();
    const Mat3 axes = frame();
    return {Vec3(camera->GetFocalPoint()), axes.row(2).transpose(), axes.row(1).transpose(),
            2 * camera->GetParallelScale()};
}

void SceneCamera::look_at(const CameraPlace& place) {
    vtkCamera* camera = vtk();
    const double distance =
        perspective() ? eye_distance(place.height / 2) : std::max(camera->GetDistance(), 1e-3);
    const Vec3 eye = place.target + distance * place.toward_eye;
    camera->SetFocalPoint(place.target.x(), place.target.y(), place.target.z());
    camera->SetPosition(eye.x(), eye.y(), eye.z());
    camera->SetViewUp(place.up.x(), place.up.y(), place.up.z());
    camera->SetParallelScale(place.height / 2);
}

CameraPlace SceneCamera::place_to_see(const Vec3& point, const Vec3& normal, double height) const {
    CameraPlace place = this->place();
    place.target = point;
    place.height = std::min(place.height, height);
    constexpr double seen = 0.35; // cosine of the slant under which one still sees what is there
    if (normal.norm() < 0.5 || normal.dot(place.toward_eye) >= seen) return place;
    // From the four corners above and below, the one that the surface faces most; ties go to the front.
    double best = -2;
    for (const double z : {0.9, -0.9})
        for (const auto& [x, y] : {std::pair(1.0, -1.0), {-1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
            const Vec3 eye = Vec3(x, y, z).normalized();
            if (normal.dot(eye) <= best + 1e-9) continue;
            best = normal.dot(eye);
            place.toward_eye = eye;
        }
    const Vec3 right = Vec3::UnitZ().cross(place.toward_eye).normalized();
    place.up = place.toward_eye.cross(right);
    return place;
}

void SceneCamera::turn_to(StandardView view) {
    const auto [toward, up] = view_vectors(view);
    vtkCamera* camera = vtk();
    double focal[3];
    camera->GetFocalPoint(focal);
    camera->SetPosition(focal[0] + toward.x(), focal[1] + toward.y(), focal[2] + toward.z());
    camera->SetViewUp(up.x(), up.y(), up.z());
}

void SceneCamera::place_at(const Vec3& focal, double distance, double scale) {
    vtkCamera* camera = vtk();
    const Vec3 eye = focal + (perspective() ? eye_distance(scale) : distance) * toward_eye();
    camera->SetFocalPoint(focal.x(), focal.y(), focal.z());
    camera->SetPosition(eye.x(), eye.y(), eye.z());
    camera->SetParallelScale(scale);
}

void SceneCamera::fit_empty() {
    place_at(Vec3::Zero(), empty_view_height, empty_view_height / 2);
}

void SceneCamera::fit(const Box3& box, const OverlayLayout& clear_of, double ratio) {
    const Vec3 half = box.size() / 2;
    const Mat3 axes = frame();
    Vec3 focal = box.center();
    double scale = empty_view_height / 2;
    Eigen::Vector2i size = window_size();
    if (size.x() < 1 || size.y() < 1) size = {400, 300}; // no window yet: fitted again when there is one
    const double width = size.x() / ratio, height = size.y() / ratio;
    std::array<Vec2, 3> edges;
    for (int k = 0; k < 3; ++k)
        edges[std::size_t(k)] = Vec2(axes(0, k), -axes(1, k)) * half[k];
    const Fit f = best_fit(width, height, clear_of, edges);
    const double per_mm = f.pixels_per_mm;
    if (std::isfinite(per_mm) && per_mm > 0) {
        scale = height / 2 / per_mm;
        const Vec2 off = (f.center - Vec2(width / 2, height / 2)) / per_mm; // of the box from the middle
        focal -= axes.row(0).transpose() * off.x() - axes.row(1).transpose() * off.y();
    }
    away_ = std::max(2 * box.diagonal(), 1e-3);
    // What is nearer is larger: the middle of the box goes back until its front is as large as it may be.
    const double front = axes.row(2).cwiseAbs().dot(half);
    const double back = perspective() ? front * scale / eye_distance(scale) : 0;
    place_at(focal, away_, scale + back);
    if (!perspective() || !window_ || !(per_mm > 0) || !std::isfinite(per_mm)) return;
    Vec2 reach = Vec2::Zero();
    for (const Vec2& edge : edges)
        reach += edge.cwiseAbs();
    fit_perspective(box, f.center * ratio, reach * per_mm * ratio);
}

bool SceneCamera::shadow_meets(const Box3& box, const LayoutRect& rect, double ratio) const {
    if (box.empty() || window_size().y() < 1) return false;
    const Projection now = projection();
    const Vec2 center = now.pixel(box.center()) / ratio;
    std::array<Vec2, 3> half;
    for (int k = 0; k < 3; ++k)
        half[std::size_t(k)] = now.pixel(box.center() + Vec3::Unit(k) * (box.size()[k] / 2)) / ratio - center;
    return meets(rect, 0, center, half);
}

void SceneCamera::fit_perspective(const Box3& box, const Vec2& middle, const Vec2& reach) {
    constexpr int rounds = 6; // each leaves a tenth of what was missing
    for (int round = 0; round < rounds; ++round) {
        const Projection now = projection();
        Vec2 lo = Vec2::Constant(infinity), hi = -lo;
        double mm = now.mm_; // of its front, which is what its shadow's edges are of
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p(corner & 1 ? box.hi.x() : box.lo.x(), corner & 2 ? box.hi.y() : box.lo.y(),
                         corner & 4 ? box.hi.z() : box.lo.z());
            lo = lo.cwiseMin(now.pixel(p));
            hi = hi.cwiseMax(now.pixel(p));
            mm = std::min(mm, now.pixel_size(p));
        }
        const Vec2 off = ((lo + hi) / 2 - middle) * mm;
        double larger = 0;
        for (int k = 0; k < 2; ++k)
            if (reach[k] > 0) larger = std::max(larger, (hi - lo)[k] / (2 * reach[k]));
        const double scale = vtk()->GetParallelScale();
        const Vec3 focal =
            now.focal_ + now.axes_.row(0).transpose() * off.x() - now.axes_.row(1).transpose() * off.y();
        // Not so near that the box comes behind the eye.
        const double front = now.axes_.row(2).cwiseAbs().dot(box.size() / 2);
        place_at(focal, away_,
                 std::max(larger > 0 ? scale * larger : scale, 1.05 * front * scale / eye_distance(scale)));
    }
}

void SceneCamera::zoom_at(double x, double y, double factor) {
    if (!(factor > 0) || !std::isfinite(factor) || pixel_size() <= 0) return;
    const double scale = vtk()->GetParallelScale();
    const Vec3 focal(vtk()->GetFocalPoint());
    place_at(focal + (1 - 1 / factor) * (point_at(x, y) - focal), vtk()->GetDistance(), scale / factor);
}

void SceneCamera::focus_at(const Vec3& place) {
    if (!perspective()) return;
    const double scale = vtk()->GetParallelScale(), eye = eye_distance(scale);
    const double depth = projection().depth(place);
    if (!(eye + depth > nearest_share * eye)) return;
    place_at(Vec3(vtk()->GetFocalPoint()) - depth * toward_eye(), away_, scale * (1 + depth / eye));
}

void SceneCamera::center_on(const Vec3& point) {
    vtkCamera* camera = vtk();
    const Vec3 move = point - Vec3(camera->GetFocalPoint()), eye = Vec3(camera->GetPosition()) + move;
    camera->SetFocalPoint(point.x(), point.y(), point.z());
    camera->SetPosition(eye.x(), eye.y(), eye.z());
}

} // namespace facetmill
