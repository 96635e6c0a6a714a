// Where the camera stands: standard views, fitting, zooming.
#include "viz/scene_impl.h"

#include <vtkActorCollection.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr double fit_margin = 1.07;       // free room around what is fitted
constexpr double empty_view_height = 100; // mm, of an empty scene

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
    const std::array<LayoutRect, 4> things{overlay.title, overlay.legend, overlay.axes, overlay.scale};
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
            const LayoutRect& t = things[std::size_t(i)];
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

Eigen::Vector2i Scene::Impl::window_size() const {
    if (!window) return {0, 0};
    const int* size = window->GetSize();
    return {size[0], size[1]};
}

Mat3 Scene::Impl::camera_frame() const {
    auto* camera = const_cast<vtkRenderer*>(renderer.Get())->GetActiveCamera();
    vtkMatrix4x4* m = camera->GetViewTransformMatrix();
    Mat3 frame;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            frame(r, c) = m->GetElement(r, c);
    return frame;
}

double Scene::Impl::pixel_size() const {
    const int height = window_size().y();
    auto* camera = const_cast<vtkRenderer*>(renderer.Get())->GetActiveCamera();
    return height > 0 ? 2.0 * camera->GetParallelScale() / height : 0.0;
}

Vec3 Scene::Impl::point_at(double x, double y) const {
    const Eigen::Vector2i size = window_size();
    auto* camera = const_cast<vtkRenderer*>(renderer.Get())->GetActiveCamera();
    const Vec3 focal(camera->GetFocalPoint());
    const Mat3 frame = camera_frame();
    const double mm = pixel_size();
    return focal + frame.row(0).transpose() * ((x - size.x() / 2.0) * mm)
           + frame.row(1).transpose() * ((size.y() / 2.0 - y) * mm);
}

Box3 Scene::bounds(bool with_tool) const {
    Box3 b;
    if (impl_->part && (visible(Layer::part) || visible(Layer::edges))) b.add(impl_->part->box);
    if (impl_->deviation && visible(Layer::deviation)) b.add(impl_->deviation->box);
    if (visible(Layer::stock)) {
        b.add(impl_->stock);
        if (impl_->stock.empty())
            for (const auto& patch : impl_->cut_stock)
                if (patch) b.add(patch->box);
    }
    if (impl_->path && (visible(Layer::cc) || visible(Layer::cl))) b.add(impl_->path->box);
    if (with_tool && visible(Layer::tool)) b.add(impl_->tool_bounds());
    return b;
}

void Scene::Impl::set_clipping_range() {
    // VTK would go through all facets of a new part, whose box is known.
    Box3 box;
    std::vector<vtkActor*> known;
    const auto know = [&](const SceneActor& first, const auto& more) {
        known.push_back(first.actor);
        for (const auto& piece : more)
            known.push_back(piece->actor);
    };
    if (part && (part_surface.actor->GetVisibility() || part_edges.actor->GetVisibility())) {
        box = part->box;
        know(part_surface, more_surface);
        know(part_edges, more_edges);
        known.push_back(part_lines.actor);
    }
    if (deviation && deviation_surface.actor->GetVisibility()) {
        box.add(deviation->box);
        know(deviation_surface, more_deviation);
    }
    for (const auto& [patches, actors_of] :
         {std::pair(&cut_stock, &cut_patches), std::pair(&cut_detail, &detail_patches)})
        for (std::size_t i = 0; i < patches->size(); ++i) {
            const auto& a = (*actors_of)[i];
            if (!a || !a->actor->GetVisibility()) continue;
            box.add((*patches)[i]->box);
            known.push_back(a->actor);
        }
    std::sort(known.begin(), known.end());
    vtkActorCollection* actors = renderer->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it)) {
        if (!actor->GetVisibility() || std::binary_search(known.begin(), known.end(), actor)) continue;
        const double* b = actor->GetBounds();
        if (!b || b[0] > b[1]) continue;
        box.add(Vec3(b[0], b[2], b[4]));
        box.add(Vec3(b[1], b[3], b[5]));
    }
    if (box.empty()) {
        renderer->ResetCameraClippingRange();
        return;
    }
    const double ends[6] = {box.lo.x(), box.hi.x(), box.lo.y(), box.hi.y(), box.lo.z(), box.hi.z()};
    renderer->ResetCameraClippingRange(ends);
}

void Scene::set_view(StandardView view) {
    const auto [toward, up] = view_vectors(view);
    vtkCamera* camera = impl_->renderer->GetActiveCamera();
    double focal[3];
    camera->GetFocalPoint(focal);
    camera->SetPosition(focal[0] + toward.x(), focal[1] + toward.y(), focal[2] + toward.z());
    camera->SetViewUp(up.x(), up.y(), up.z());
    fit();
}

void Scene::fit(bool with_tool) {
    impl_->apply_visibility();
    vtkCamera* camera = impl_->renderer->GetActiveCamera();
    const Box3 box = bounds(with_tool);
    const Vec3 half = box.size() / 2;
    const Mat3 frame = impl_->camera_frame();
    Vec3 focal = box.empty() ? Vec3(Vec3::Zero()) : box.center();
    double scale = empty_view_height / 2; // half the window's height in mm
    double distance = empty_view_height;
    if (!box.empty()) {
        Eigen::Vector2i size = impl_->window_size();
        if (size.x() < 1 || size.y() < 1) size = {400, 300}; // no window yet: fitted again when there is one
        const double width = size.x() / impl_->ratio, height = size.y() / impl_->ratio;
        std::array<Vec2, 3> edges;
        for (int k = 0; k < 3; ++k)
            edges[std::size_t(k)] = Vec2(frame(0, k), -frame(1, k)) * half[k];
        const Fit f = best_fit(width, height, impl_->overlay->layout(impl_->overlay_content()), edges);
        const double per_mm = f.pixels_per_mm;
        if (std::isfinite(per_mm) && per_mm > 0) {
            scale = height / 2 / per_mm;
            const Vec2 off = (f.center - Vec2(width / 2, height / 2)) / per_mm; // of the box from the middle
            focal -= frame.row(0).transpose() * off.x() - frame.row(1).transpose() * off.y();
        }
        distance = std::max(2 * box.diagonal(), 1e-3);
    }
    const Vec3 eye = focal + distance * Vec3(frame.row(2).transpose());
    camera->SetFocalPoint(focal.x(), focal.y(), focal.z());
    camera->SetPosition(eye.x(), eye.y(), eye.z());
    camera->SetParallelScale(scale);
    camera->ParallelProjectionOn();
}

void Scene::zoom_at(double x, double y, double factor) {
    if (!(factor > 0) || !std::isfinite(factor) || impl_->pixel_size() <= 0) return;
    vtkCamera* camera = impl_->renderer->GetActiveCamera();
    const Vec3 before = impl_->point_at(x, y);
    camera->SetParallelScale(camera->GetParallelScale() / factor);
    const Vec3 move = before - impl_->point_at(x, y);
    const Vec3 focal = Vec3(camera->GetFocalPoint()) + move, eye = Vec3(camera->GetPosition()) + move;
    camera->SetFocalPoint(focal.x(), focal.y(), focal.z());
    camera->SetPosition(eye.x(), eye.y(), eye.z());
}

void Scene::center_on(const Vec3& point) {
    vtkCamera* camera = impl_->renderer->GetActiveCamera();
    const Vec3 move = point - Vec3(camera->GetFocalPoint()), eye = Vec3(camera->GetPosition()) + move;
    camera->SetFocalPoint(point.x(), point.y(), point.z());
    camera->SetPosition(eye.x(), eye.y(), eye.z());
}

} // namespace facetmill
