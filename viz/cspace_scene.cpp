#include "viz/cspace_scene.h"

#include "viz/cspace_axes.h"
#include "viz/cspace_labels.h"
#include "viz/overlay.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <vtk_glew.h>

namespace facetmill {

namespace {

constexpr double grid_margin = 10;
constexpr double beside_axis = 46; ///< layout pixels beside the box for numbers and names of the axes
constexpr double above_box = 52;   ///< above it

Vec3 vec(const double* v) {
    return {v[0], v[1], v[2]};
}

vtkSmartPointer<vtkPolyData> data_of(const CSpaceTriangles& triangles) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        cells->InsertNextCell(3);
        for (std::size_t k = 0; k < 3; ++k) {
            const float* p = &triangles.points[9 * t + 3 * k];
            cells->InsertCellPoint(points->InsertNextPoint(p));
            colors->InsertNextTypedTuple(&triangles.colors[4 * t]);
        }
    }
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetScalars(colors); // not the cells': see OverlayCanvas
    return data;
}

vtkSmartPointer<vtkPolyData> data_of(const CSpaceSegments& segments) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (std::size_t i = 0; i + 5 < segments.size(); i += 6) {
        cells->InsertNextCell(2);
        for (std::size_t k = 0; k < 2; ++k)
            cells->InsertCellPoint(points->InsertNextPoint(&segments[i + 3 * k]));
    }
    data->SetPoints(points);
    data->SetLines(cells);
    return data;
}

struct Drawn {
    vtkNew<vtkActor> actor;
    vtkNew<vtkPolyDataMapper> mapper;
    Drawn() {
        actor->SetMapper(mapper);
        actor->PickableOff();
        actor->VisibilityOff();
        mapper->SetResolveCoincidentTopologyToPolygonOffset();
        mapper->SetScalarModeToUsePointData();
        mapper->ScalarVisibilityOn();
    }
    void set(vtkPolyData* data) {
        mapper->SetInputData(data);
        actor->SetVisibility(data->GetNumberOfCells() > 0);
    }
    void unlit() {
        vtkProperty* p = actor->GetProperty();
        p->LightingOff();
        mapper->ScalarVisibilityOff();
    }
    void color(const Rgb& c) { actor->GetProperty()->SetColor(c.r, c.g, c.b); }
};

/// Translucent faces blend from the back to the front.
CSpaceTriangles from_the_back(const CSpaceTriangles& all, const Vec3& toward) {
    std::vector<std::pair<double, std::size_t>> order(all.size());
    for (std::size_t t = 0; t < all.size(); ++t) {
        double depth = 0;
        for (std::size_t k = 0; k < 9; ++k)
            depth += toward[int(k % 3)] * double(all.points[9 * t + k]);
        order[t] = {depth, t};
    }
    std::sort(order.begin(), order.end());
    CSpaceTriangles sorted;
    for (const auto& [depth, t] : order) {
        sorted.points.insert(sorted.points.end(), &all.points[9 * t], &all.points[9 * t] + 9);
        sorted.colors.insert(sorted.colors.end(), &all.colors[4 * t], &all.colors[4 * t] + 4);
    }
    return sorted;
}

} // namespace

struct CSpaceScene::Impl {
    vtkNew<vtkRenderer> view;
    vtkNew<vtkCallbackCommand> frame_callback;
    vtkWeakPointer<vtkRenderWindow> window;
    std::unique_ptr<Overlay> overlay;
    Palette palette = Palette::light;
    LengthUnit unit = LengthUnit::mm;
    double ratio = 1;
    bool antialiasing = true, legend_on = true, fitted = true;
    std::string title, subtitle, empty_text = "No point";
    std::shared_ptr<const CSpaceContent> content;
    std::optional<CSpaceDisplay> display;
    std::optional<PostureValue> probe;
    Drawn bottom, volume, map, bottom_lines, top_lines, frame, stems;
    Vec3 sorted_for = Vec3::Zero(); // the direction towards the eye

    Impl() {
        for (Drawn* d : {&map, &bottom, &bottom_lines, &top_lines, &frame, &stems, &volume})
            view->AddActor(d->actor);
        for (Drawn* d : {&map, &bottom_lines, &top_lines, &frame, &stems})
            d->unlit();
        map.mapper->ScalarVisibilityOn();
        // Colours that mean something are drawn with little shade, so that they can be found in the legend.
        vtkProperty* look = bottom.actor->GetProperty();
        look->SetAmbient(0.70);
        look->SetDiffuse(0.35);
        look->SetInterpolationToFlat();
        volume.actor->GetProperty()->SetLighting(false);
        volume.actor->ForceTranslucentOn();
        for (Drawn* d : {&bottom_lines, &top_lines, &frame, &stems})
            d->mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -24);
        volume.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -8);
        view->GradientBackgroundOn();
        view->GetActiveCamera()->ParallelProjectionOn();
        view->SetLayer(0);
        overlay = std::make_unique<Overlay>(view);
        frame_callback->SetClientData(this);
        frame_callback->SetCallback(
            [](vtkObject*, unsigned long, void* self, void*) { static_cast<Impl*>(self)->update_frame(); });
        view->AddObserver(vtkCommand::StartEvent, frame_callback);
        apply_palette();
        apply_widths();
        look_from_standard();
    }
    ~Impl() { view->RemoveObserver(frame_callback); }

    void apply_palette() {
        const Colors& c = colors_of(palette);
        view->SetBackground(c.background_bottom.r, c.background_bottom.g, c.background_bottom.b);
        view->SetBackground2(c.background_top.r, c.background_top.g, c.background_top.b);
        bottom_lines.color(c.feature_edges);
        top_lines.color(cspace_top_color());
        frame.color(c.faint_text);
        stems.color(c.text);
    }
    void apply_widths() {
        const auto set = [&](Drawn& d, double width) {
            d.actor->GetProperty()->SetLineWidth(float(width * ratio));
        };
        set(bottom_lines, 0.7);
        set(top_lines, 0.8);
        set(frame, 1.0);
        set(stems, 1.3);
        bottom_lines.actor->GetProperty()->SetOpacity(0.6);
        top_lines.actor->GetProperty()->SetOpacity(0.7);
    }

    void look_from_standard() {
        const Vec3 toward = Vec3(-0.72, -1.0, 0.72).normalized();
        const Vec3 focus = middle(), eye = focus + 4 * toward;
        vtkCamera* camera = view->GetActiveCamera();
        camera->SetFocalPoint(focus.data());
        camera->SetPosition(eye.data());
        camera->SetViewUp(0, 0, 1);
        camera->SetParallelScale(0.9);
    }
    Vec3 middle() const {
        const Vec3 size = display ? display->size : Vec3(1, 1, CSpaceDisplay::height);
        return {size.x() / 2, size.y() / 2, (CSpaceDisplay::height + CSpaceDisplay::floor) / 2};
    }

    Eigen::Vector2i window_size() const {
        if (!window) return {0, 0};
        const int* s = window->GetSize();
        return {s[0], s[1]};
    }
    /// Right, up, towards the eye.
    Mat3 camera_frame() const {
        vtkCamera* camera = const_cast<Impl*>(this)->view->GetActiveCamera();
        const Vec3 toward = -vec(camera->GetDirectionOfProjection());
        const Vec3 right = vec(camera->GetViewUp()).cross(toward).normalized();
        Mat3 m;
        m.row(0) = right;
        m.row(1) = toward.cross(right);
        m.row(2) = toward;
        return m;
    }
    /// Box lengths per device pixel.
    double pixel_size() const {
        const int high = window_size().y();
        return high > 0 ? 2 * const_cast<Impl*>(this)->view->GetActiveCamera()->GetParallelScale() / high : 0;
    }
    Vec2 display_of(const Vec3& at) const {
        const Eigen::Vector2i size = window_size();
        const Vec3 focus = vec(const_cast<Impl*>(this)->view->GetActiveCamera()->GetFocalPoint());
        const Vec3 seen = camera_frame() * (at - focus) / std::max(1e-12, pixel_size());
        return {size.x() / 2.0 + seen.x(), size.y() / 2.0 - seen.y()};
    }

    CSpaceAxes axes() const { return cspace_axes(*display, camera_frame(), unit); }

    /// Where it would be cut by the left or right border it comes in, and farther out along its axis where
    /// numbers are in the way.
    void add_axis_name(OverlayContent& c, OverlayNote name, const Vec2& route) {
        const auto width = [&](const std::string& text) { return overlay->note_width(text, true); };
        const double half = 0.5 * width(name.text) + 0.5 * grid_margin, wide = c.width / ratio;
        const double x =
            std::clamp(name.at.x(), std::min(half, 0.5 * wide), std::max(wide - half, 0.5 * wide));
        if (x != name.at.x()) {
            constexpr double row = 6;
            for (int k = 0; k < 6; ++k) {
                OverlayNote moved = name;
                moved.at = {x, name.at.y() + (route.y() < 0 ? -k : k) * row};
                if (lies_on_another(c, moved, width) || moved.at.y() > c.height / ratio - grid_margin)
                    continue;
                name = moved;
                break;
            }
        }
        c.notes.push_back(std::move(name));
    }

    void add_axis_notes(OverlayContent& c) {
        const CSpaceAxes a = axes();
        const auto shown = [&](const Vec3& p) { return Vec2(display_of(p) / ratio); };
        std::vector<std::pair<OverlayNote, Vec2>> names; // they go where all numbers leave room
        for (const CSpaceAxis* axis : {&a.lead, &a.yaw}) {
            if (axis->ticks.empty()) continue;
            // Numbers stand off the box in the direction of the ticks as it is seen.
            Vec2 route = shown(axis->middle + axis->outward) - shown(axis->middle);
            if (route.norm() < 1e-6) continue;
            route.normalize();
            Vec2 last(-1e9, -1e9);
            for (const CSpaceTick& t : axis->ticks) {
                const Vec2 p = shown(t.at) + 15 * route;
                if ((p - last).norm() < 24) continue; // they would run into each other
                c.notes.push_back({p, 0, t.text, false, false});
                last = p;
            }
            if (small() && names_fit()) continue; // postures have theirs there
            const double aside = 0.5 * overlay->note_width(axis->name, true) * std::abs(route.x()) + 28;
            names.push_back({{shown(axis->middle) + aside * route, 0, axis->name, true, false}, route});
        }
        for (auto& [name, route] : names)
            add_axis_name(c, std::move(name), route);
        Vec2 last(-1e9, -1e9);
        for (const CSpaceTick& t : a.delta.ticks) {
            const Vec2 p = shown(t.at + CSpaceAxes::tick * a.delta.outward) + Vec2(-4, 0);
            if ((p - last).norm() < 14) continue;
            c.notes.push_back({p, 1, t.text, false, false});
            last = p;
        }
        const Vec2 end = shown(a.delta.middle) + Vec2(0, -15);
        const double w = overlay->note_width(a.delta.name, true);
        c.notes.push_back({{std::max(grid_margin + w / 2, end.x()), end.y()}, 0, a.delta.name, true, false});
    }

    void sort_volume() {
        const Vec3 toward = camera_frame().row(2);
        if ((toward - sorted_for).norm() < 1e-9) return;
        sorted_for = toward;
        volume.set(data_of(from_the_back(display->volume, toward)));
    }

    void build_stems() {
        CSpaceSegments lines;
        const auto stem = [&](const PostureValue& p) {
            const Vec3 up = display->place(p);
            for (const Vec3& v : {up, Vec3(up.x(), up.y(), CSpaceDisplay::floor)})
                for (int k = 0; k < 3; ++k)
                    lines.push_back(float(v[k]));
        };
        if (display) {
            for (const ChosenPosture& c : content->choices)
                if (c.free) stem(c.posture);
            if (probe) stem(*probe);
        }
        stems.set(data_of(lines));
    }

    void update_frame() {
        if (auto* gl = vtkOpenGLRenderWindow::SafeDownCast(window)) {
            gl->GetState()->vtkglDepthFunc(GL_LEQUAL);
            gl->GetState()->vtkglDepthMask(GL_TRUE);
            gl->GetState()->vtkglEnable(GL_DEPTH_TEST);
        }
        view->SetUseFXAA(antialiasing);
        if (fitted) fit();
        if (display) {
            frame.set(data_of(cspace_frame(*display, axes())));
            sort_volume();
        }
        view->ResetCameraClippingRange(-0.5, 1.5, -0.5, 1.5, -0.5, 1.2);
        overlay->update(overlay_content(true));
    }

    /// Too small for more than the box itself.
    bool small() const { return window_size().y() / ratio < 240; }
    bool names_fit() const { return window_size().y() / ratio >= min_height_of_names; }

    OverlayContent overlay_content(bool with_notes) {
        const Eigen::Vector2i size = window_size();
        OverlayContent c;
        c.width = size.x();
        c.height = size.y();
        c.ratio = ratio;
        c.palette = palette;
        if (!small()) {
            c.title = title;
            c.subtitle = subtitle;
        }
        c.unit = unit;
        if (!display) {
            c.empty_text = empty_text;
            return c;
        }
        if (legend_on) c.legend = cspace_legend(*content, palette);
        if (with_notes) {
            add_axis_notes(c);
            std::vector<CSpaceMarker> markers = cspace_markers(
                *content, [&](const PostureValue& p) { return Vec2(display_of(display->place(p)) / ratio); });
            if (probe)
                markers.push_back(
                    {display_of(display->place(*probe)) / ratio, colors_of(palette).marker_ring, "tried"});
            if (!names_fit())
                for (CSpaceMarker& marker : markers)
                    marker.name.clear();
            const auto width = [&](const std::string& name) { return overlay->note_width(name, true); };
            add_markers(c, std::move(markers), width);
            if (content->free_nodes == 0)
                c.notes.push_back(
                    {{c.width / ratio / 2, above_box + 6}, 0, "No posture is free here", true, true});
            leave_out_covered(c, width);
        }
        return c;
    }

    void fit() {
        const Eigen::Vector2i size = window_size();
        if (size.x() <= 0 || size.y() <= 0 || !display) return;
        const double w = size.x() / ratio, h = size.y() / ratio;
        const OverlayLayout layout = overlay->layout(overlay_content(false));
        // The box as the camera sees it.
        const Mat3 camera = camera_frame();
        Vec2 lo(infinity, infinity), hi(-infinity, -infinity);
        for (const Vec2& p : floor_corners(*display))
            for (const double z : {CSpaceDisplay::floor, CSpaceDisplay::height}) {
                const Vec3 seen = camera * Vec3(p.x(), p.y(), z);
                lo = lo.cwiseMin(Vec2(seen.head<2>()));
                hi = hi.cwiseMax(Vec2(seen.head<2>()));
            }
        const Vec2 extent = (hi - lo).cwiseMax(Vec2(1e-6, 1e-6));
        const double above =
            std::max(layout.title.empty() ? 0.0 : layout.title.y1, 0.0) + (small() ? 22 : 34);
        const double aside = small() ? 30 : beside_axis;
        struct Area {
            double x0, y0, x1, y1;
        };
        std::vector<Area> areas;
        if (layout.legend.empty()) {
            areas.push_back({0, above, w, h});
        } else {
            areas.push_back({0, above, layout.legend.x0, h});
            areas.push_back({0, std::max(above, layout.legend.y1 + 20), w, h});
        }
        double best = infinity;
        Area in = areas.front();
        for (const Area& a : areas) {
            const double wide = a.x1 - a.x0 - 2 * aside, high = a.y1 - a.y0 - aside - grid_margin;
            if (wide < 20 || high < 20) continue;
            const double per = std::max(extent.x() / wide, extent.y() / high);
            if (per < best) {
                best = per;
                in = a;
            }
        }
        if (!std::isfinite(best)) best = std::max(extent.x() / w, extent.y() / h) * 1.3;
        // The middle of the area shows the middle of the box.
        const Vec2 aim((in.x0 + in.x1) / 2, (in.y0 + in.y1 - aside + grid_margin) / 2);
        const Vec2 box = (lo + hi) / 2;
        const Vec2 focus(box.x() - (aim.x() - w / 2) * best, box.y() + (aim.y() - h / 2) * best);
        const double deep = (camera * middle()).z();
        const Vec3 world = camera.transpose() * Vec3(focus.x(), focus.y(), deep);
        const Vec3 eye = world + 4 * Vec3(camera.row(2));
        vtkCamera* c = view->GetActiveCamera();
        c->SetFocalPoint(world.data());
        c->SetPosition(eye.data());
        c->SetParallelScale(best * h / 2);
    }
};

CSpaceScene::CSpaceScene() : impl_(std::make_unique<Impl>()) {}
CSpaceScene::~CSpaceScene() {
    detach();
}

void CSpaceScene::attach(vtkRenderWindow* window) {
    detach();
    window->SetNumberOfLayers(1);
    window->AddRenderer(impl_->view);
    impl_->window = window;
}

void CSpaceScene::detach() {
    if (!impl_->window) return;
    impl_->window->MakeCurrent(); // what lies on the graphics card is freed in its own context
    impl_->window->RemoveRenderer(impl_->view);
    impl_->window = nullptr;
}

vtkRenderer* CSpaceScene::renderer() {
    return impl_->view;
}

void CSpaceScene::set_pixel_ratio(double ratio) {
    impl_->ratio = ratio > 0 ? ratio : 1.0;
    impl_->apply_widths();
}
void CSpaceScene::set_antialiasing(bool on) {
    impl_->antialiasing = on;
}
void CSpaceScene::set_palette(Palette palette) {
    impl_->palette = palette;
    impl_->apply_palette();
}

void CSpaceScene::set_unit(LengthUnit unit) {
    if (unit == impl_->unit) return;
    impl_->unit = unit;
    set_content(impl_->content);
}

void CSpaceScene::set_content(std::shared_ptr<const CSpaceContent> content) {
    Impl& i = *impl_;
    i.content = std::move(content);
    i.probe.reset();
    i.display.reset();
    for (Drawn* d : {&i.bottom, &i.volume, &i.map, &i.bottom_lines, &i.top_lines, &i.frame})
        d->actor->VisibilityOff();
    if (i.content && i.content->grid.size() > 0) {
        i.display.emplace(*i.content, i.unit);
        i.bottom.set(data_of(i.display->bottom));
        i.map.set(data_of(i.display->map));
        i.bottom_lines.set(data_of(i.display->bottom_lines));
        i.top_lines.set(data_of(i.display->top_lines));
        i.sorted_for = Vec3::Zero();
    }
    i.build_stems();
}

const std::shared_ptr<const CSpaceContent>& CSpaceScene::content() const {
    return impl_->content;
}

void CSpaceScene::set_title(const std::string& title, const std::string& subtitle) {
    impl_->title = printable(title, 1000);
    impl_->subtitle = printable(subtitle, 1000);
}
void CSpaceScene::set_empty_text(const std::string& text) {
    impl_->empty_text = printable(text, 1000);
}
void CSpaceScene::set_legend_visible(bool on) {
    impl_->legend_on = on;
}
void CSpaceScene::set_probe(const std::optional<PostureValue>& posture) {
    impl_->probe = posture;
    impl_->build_stems();
}
std::vector<OverlayNote> CSpaceScene::notes() const {
    return impl_->overlay_content(true).notes;
}
std::vector<LegendEntry> CSpaceScene::legend() const {
    if (!impl_->content) return {};
    return cspace_legend(*impl_->content, impl_->palette);
}

void CSpaceScene::reset_view() {
    impl_->look_from_standard();
    fit();
}

void CSpaceScene::fit() {
    impl_->fitted = true;
    impl_->fit();
}

void CSpaceScene::turn(double about_up, double about_right) {
    impl_->fitted = false;
    vtkCamera* camera = impl_->view->GetActiveCamera();
    const Vec3 focus = vec(camera->GetFocalPoint()), center = impl_->middle();
    const Mat3 frame = impl_->camera_frame();
    const Vec3 right = frame.row(0);
    // The lift stays upright on the screen; never quite from above, where that would have no direction.
    const double height = std::asin(std::clamp(frame(2, 2), -1.0, 1.0));
    const double tilt = std::clamp(height - about_right, radians(3), radians(87)) - height;
    const Mat3 turned =
        (Eigen::AngleAxisd(about_up, Vec3::UnitZ()) * Eigen::AngleAxisd(-tilt, right)).toRotationMatrix();
    const Vec3 new_focus = center + turned * (focus - center);
    const Vec3 eye = new_focus + 4 * (turned * Vec3(frame.row(2)));
    camera->SetFocalPoint(new_focus.data());
    camera->SetPosition(eye.data());
    camera->SetViewUp(0, 0, 1);
}

void CSpaceScene::zoom(double factor) {
    impl_->fitted = false;
    vtkCamera* camera = impl_->view->GetActiveCamera();
    camera->SetParallelScale(std::clamp(camera->GetParallelScale() / factor, 0.02, 5.0));
}

std::optional<CSpaceDisplay::Hit> CSpaceScene::hit(double x, double y) const {
    const Impl& i = *impl_;
    const Eigen::Vector2i size = i.window_size();
    if (!i.display || size.x() <= 0) return std::nullopt;
    const Mat3 frame = i.camera_frame();
    const Vec3 focus = vec(impl_->view->GetActiveCamera()->GetFocalPoint());
    const double pixel = i.pixel_size();
    const Vec3 from = focus + (x - size.x() / 2.0) * pixel * Vec3(frame.row(0))
                      - (y - size.y() / 2.0) * pixel * Vec3(frame.row(1)) + 8 * Vec3(frame.row(2));
    return i.display->hit(from, -Vec3(frame.row(2)));
}

std::optional<std::size_t> CSpaceScene::marker_at(double x, double y, double radius) const {
    if (!impl_->display) return std::nullopt;
    double nearest = radius;
    std::optional<std::size_t> found;
    const auto look = [&](std::size_t number, const PostureValue& p) {
        const double away = (display_of(p) - Vec2(x, y)).norm();
        if (away <= nearest) {
            nearest = away;
            found = number;
        }
    };
    for (std::size_t k = 0; k < cspace_choices; ++k)
        if (impl_->content->choices[k].free) look(k, impl_->content->choices[k].posture);
    if (impl_->probe) look(cspace_choices, *impl_->probe);
    return found;
}

Vec2 CSpaceScene::display_of(const PostureValue& posture) const {
    return impl_->display_of(impl_->display->place(posture));
}

} // namespace facetmill
