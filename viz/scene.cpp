#include "viz/scene.h"

#include "viz/poly_data.h"
#include "viz/scene_impl.h"

#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>
#include <vtk_glew.h>

#include <cmath>

namespace facetmill {

namespace {

constexpr double fit_margin = 1.07;       // free room around what is fitted
constexpr double empty_view_height = 100; // mm, of an empty scene

void set_color(SceneActor& a, const Rgb& c) {
    a.actor->GetProperty()->SetColor(c.r, c.g, c.b);
}

void unlit(SceneActor& a) {
    a.actor->GetProperty()->LightingOff();
}

void add_light(vtkRenderer* renderer, double x, double y, double z, double intensity) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight(); // in the camera's frame: x right, y up, z towards the eye
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(intensity);
    light->SetSwitch(1);
    renderer->AddLight(light);
}

void add_lights(vtkRenderer* renderer) {
    renderer->AutomaticLightCreationOff();
    add_light(renderer, -0.5, 0.6, 1.0, 0.62); // key, over the left shoulder
    add_light(renderer, 0.0, 0.0, 1.0, 0.38);  // from the eye
    add_light(renderer, 0.9, -0.3, 0.5, 0.20); // fill from the right
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
bool meets(const LayoutRect& r, double by, const Vec2& centre, const std::array<Vec2, 3>& half) {
    if (r.empty()) return false;
    const Vec2 middle((r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2), extent(r.width() / 2 + by, r.height() / 2 + by);
    const auto apart = [&](const Vec2& axis) {
        const double reach = std::abs(axis.x()) * extent.x() + std::abs(axis.y()) * extent.y()
                             + std::abs(axis.dot(half[0])) + std::abs(axis.dot(half[1]))
                             + std::abs(axis.dot(half[2]));
        return std::abs(axis.dot(centre - middle)) > reach;
    };
    if (apart({1, 0}) || apart({0, 1})) return false;
    for (const Vec2& h : half)
        if (h.squaredNorm() > 0 && apart({-h.y(), h.x()})) return false;
    return true;
}

struct Fit {
    double pixels_per_mm = 0;
    Vec2 centre; ///< of the box on the screen, layout pixels, y down
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
    for (int way = 0; way < 81; ++way) {
        LayoutRect r = all;
        for (int i = 0, rest = way; i < 4; ++i, rest /= 3) {
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
            const Vec2 centre = own + t * (middle - own);
            bool clear = true;
            for (const LayoutRect& thing : things)
                clear = clear && !meets(thing, 7, centre, drawn);
            if (!clear) continue;
            // A little smaller is better than far off the middle; the last factor settles ties the same way
            // on every machine.
            const double score =
                scale * (1.0 - 0.3 * (centre - middle).norm() / (width + height)) * (1.0 - 1e-6 * way);
            if (score > best_score) {
                best_score = score;
                best = {scale, centre};
            }
            break;
        }
    }
    return best;
}

} // namespace

SceneActor::SceneActor() {
    mapper->ScalarVisibilityOff();
    mapper->StaticOn(); // the data never change in place
    actor->SetMapper(mapper);
    actor->VisibilityOff();
}

void SceneActor::set_data(vtkPolyData* data, const Vec3& centre) {
    mapper->SetInputData(data);
    actor->SetPosition(centre.x(), centre.y(), centre.z());
    filled = data->GetNumberOfCells() > 0;
}

void SceneActor::clear() {
    mapper->SetInputData(vtkSmartPointer<vtkPolyData>::New());
    filled = false;
}

Scene::Impl::Impl() {
    // Lines on a surface are drawn in front of it. VTK keeps this setting for the whole process.
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();

    layer_on.assign(all_layers().size(), true);
    layer_on[std::size_t(Layer::edges)] = false;
    motion_on.fill(true);

    renderer->SetBackgroundAlpha(1.0); // a widget that is composed with others must not be seen through
    renderer->GradientBackgroundOn();
    renderer->TwoSidedLightingOn();
    renderer->UseFXAAOn();
    add_lights(renderer);
    renderer->GetActiveCamera()->ParallelProjectionOn(); // makes the camera, too

    axes_renderer->SetLayer(1);
    axes_renderer->InteractiveOff();
    axes_renderer->EraseOff();
    axes_renderer->UseFXAAOff();
    add_lights(axes_renderer);
    axes_renderer->GetActiveCamera()->ParallelProjectionOn();

    const auto add_all = [&](auto&... actors) { (renderer->AddActor(actors.actor), ...); };
    add_all(part_surface, part_lines, part_edges, stock_faces, stock_lines, contact_lines, contact_dots);
    for (auto& a : motion_lines)
        renderer->AddActor(a.actor);
    for (std::size_t k = 0; k < 3; ++k) {
        renderer->AddActor(tool_bodies[k].actor);
        renderer->AddActor(tool_rings[k].actor);
        axes_renderer->AddActor(axes[k].actor);
    }
    for (SceneActor* a :
         {&part_lines, &part_edges, &stock_faces, &stock_lines, &contact_lines, &contact_dots})
        unlit(*a);
    for (auto& a : motion_lines)
        unlit(a);
    for (auto& a : tool_rings)
        unlit(a);

    vtkProperty* surface = part_surface.actor->GetProperty();
    surface->SetAmbient(0.10);
    surface->SetDiffuse(0.90);
    surface->SetSpecular(0.12);
    surface->SetSpecularPower(24);
    part_surface.actor->SetBackfaceProperty(vtkSmartPointer<vtkProperty>::New());
    for (auto& a : tool_bodies) {
        a.actor->GetProperty()->SetAmbient(0.08);
        a.actor->GetProperty()->SetSpecular(0.35);
        a.actor->GetProperty()->SetSpecularPower(40);
    }
    // All faces of the stock have the same colour and no light, so that they blend alike in any order.
    stock_faces.actor->GetProperty()->SetOpacity(0.10);
    // What lies on the surface is drawn a little nearer (1/65000 of the depth of the view each), or the
    // facets beside it would cut it up. About half a pixel on a steep facet; the order settles what lies on
    // what.
    const auto nearer = [](SceneActor& a, double by) {
        a.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -by);
        a.mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-by);
    };
    nearer(part_edges, 32);
    nearer(part_lines, 36);
    nearer(stock_lines, 36);
    nearer(contact_lines, 40);
    nearer(contact_dots, 48);
    for (auto& a : motion_lines)
        nearer(a, 44);
    for (auto& a : tool_rings)
        nearer(a, 20);
    // The stock's faces lie behind the part's where both have the same plane.
    stock_faces.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(4, 6);
    contact_dots.actor->GetProperty()->SetRenderPointsAsSpheres(true);

    // The axes in the corner: an arrow along Z, turned.
    for (std::size_t k = 0; k < 3; ++k) {
        axis_shapes[k] = make_arrow(0.055, 0.13, 0.30, 1.0);
        axes[k].set_data(
            triangle_data(axis_shapes[k].points, axis_shapes[k].normals, axis_shapes[k].triangles),
            Vec3::Zero());
        axes[k].actor->VisibilityOn();
        axes[k].actor->GetProperty()->SetAmbient(0.15);
    }
    axes[0].actor->RotateY(90);
    axes[1].actor->RotateX(-90);

    overlay = std::make_unique<Overlay>(renderer);
    frame_callback->SetClientData(this);
    frame_callback->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
        static_cast<Scene::Impl*>(self)->update_frame();
    });
    renderer->AddObserver(vtkCommand::StartEvent, frame_callback);
    apply_palette();
    apply_line_widths();
    apply_part_style();
}

Scene::Impl::~Impl() {
    renderer->RemoveObserver(frame_callback);
}

void Scene::Impl::apply_palette() {
    const Colors& c = colors_of(palette);
    renderer->SetBackground(c.background_bottom.r, c.background_bottom.g, c.background_bottom.b);
    renderer->SetBackground2(c.background_top.r, c.background_top.g, c.background_top.b);
    set_color(part_lines, c.feature_edges);
    set_color(part_edges, c.mesh_edges);
    set_color(stock_faces, c.stock);
    set_color(stock_lines, c.stock);
    set_color(contact_lines, c.contacts);
    set_color(contact_dots, c.contacts);
    for (std::size_t k = 0; k < motion_kinds; ++k)
        set_color(motion_lines[k], c.motions[k]);
    const Rgb tool_colors[3] = {c.cutter, c.shank, c.holder};
    for (std::size_t k = 0; k < 3; ++k) {
        set_color(tool_bodies[k], tool_colors[k]);
        set_color(tool_rings[k], c.feature_edges);
        set_color(axes[k], c.axes[k]);
    }
    apply_part_style();
}

void Scene::Impl::apply_part_style() {
    const Colors& c = colors_of(palette);
    vtkProperty* front = part_surface.actor->GetProperty();
    front->SetColor(c.part.r, c.part.g, c.part.b);
    if (part_style == PartStyle::flat)
        front->SetInterpolationToFlat();
    else
        front->SetInterpolationToGouraud();
    vtkProperty* back = part_surface.actor->GetBackfaceProperty();
    back->DeepCopy(front);
    back->SetColor(c.part_back.r, c.part_back.g, c.part_back.b);
}

void Scene::Impl::apply_line_widths() {
    const auto set = [&](SceneActor& a, double width) {
        a.actor->GetProperty()->SetLineWidth(float(width * ratio));
    };
    set(part_lines, 1.1);
    set(part_edges, 0.6);
    set(stock_lines, 1.4);
    set(contact_lines, 0.8);
    for (auto& a : tool_rings)
        set(a, 1.0);
    for (std::size_t k = 0; k < motion_kinds; ++k)
        set(motion_lines[k], motion_line_width(MotionKind(k)));
    contact_dots.actor->GetProperty()->SetPointSize(float(2.6 * ratio));
}

void Scene::Impl::apply_visibility() {
    const auto on = [&](Layer layer) { return bool(layer_on[std::size_t(layer)]); };
    const auto show = [](SceneActor& a, bool wanted) { a.actor->SetVisibility(wanted && a.filled); };
    const bool wire = part_style == PartStyle::wire;
    show(part_surface, on(Layer::part) && !wire);
    show(part_lines, on(Layer::part));
    show(part_edges, on(Layer::edges) || (on(Layer::part) && wire));
    show(stock_faces, on(Layer::stock));
    show(stock_lines, on(Layer::stock));
    show(contact_lines, on(Layer::cc));
    show(contact_dots, on(Layer::cc));
    for (std::size_t k = 0; k < motion_kinds; ++k)
        show(motion_lines[k], on(Layer::cl) && motion_on[k]);
    for (std::size_t k = 0; k < 3; ++k) {
        show(tool_bodies[k], on(Layer::tool) && pose.has_value());
        show(tool_rings[k], on(Layer::tool) && pose.has_value());
    }
}

bool Scene::Impl::shows_content() const {
    return part || !stock.empty() || (path && !path->box.empty());
}

bool Scene::Impl::shows_back() const {
    if (!part || !part->has_border || !layer_on[std::size_t(Layer::part)] || part_style == PartStyle::wire)
        return false;
    // A sample is enough for a line of the legend.
    const std::size_t n = part->mesh->facets.size(), step = n / 2048 + 1;
    const Vec3 toward = camera_frame().row(2).transpose();
    std::size_t seen = 0, back = 0;
    for (std::size_t f = 0; f < n; f += step, ++seen)
        back += part->mesh->facet_normal(f).dot(toward) < 0;
    return 50 * back > seen;
}

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

void Scene::Impl::update_frame() {
    // A context that others draw in too may come with GL_LESS; then nothing flat shows on top of something
    // flat.
    if (auto* gl = vtkOpenGLRenderWindow::SafeDownCast(window)) gl->GetState()->vtkglDepthFunc(GL_LEQUAL);
    apply_visibility();
    renderer->ResetCameraClippingRange();
    overlay->update(overlay_content());
    // The axes' renderer covers a square in the corner and turns as the camera does.
    const Eigen::Vector2i size = window_size();
    const double side = axes_side(size.x() / ratio, size.y() / ratio) * ratio, off = 6 * ratio;
    const bool on = layer_on[std::size_t(Layer::axes)] && side > 0;
    axes_renderer->SetDraw(on);
    if (!on) return;
    axes_renderer->SetViewport(off / size.x(), off / size.y(), (off + side) / size.x(),
                               (off + side) / size.y());
    vtkCamera *from = renderer->GetActiveCamera(), *to = axes_renderer->GetActiveCamera();
    const Vec3 toward = camera_frame().row(2).transpose();
    to->SetFocalPoint(0, 0, 0);
    to->SetPosition(10 * toward.x(), 10 * toward.y(), 10 * toward.z());
    to->SetViewUp(from->GetViewUp());
    to->SetParallelScale(1.5);
    to->SetClippingRange(1, 20);
}

std::vector<LegendEntry> Scene::Impl::legend() const {
    using Sample = LegendEntry::Sample;
    const Colors& c = colors_of(palette);
    const auto seen = [](const SceneActor& a) {
        return const_cast<vtkActor*>(a.actor.Get())->GetVisibility() != 0;
    };
    std::vector<LegendEntry> all;
    if (shows_back()) all.push_back({Sample::surface, c.part_back, 1, "Back of the surface"});
    if (seen(stock_lines)) all.push_back({Sample::box, c.stock, 1, "Stock"});
    if (seen(contact_dots)) all.push_back({Sample::dot, c.contacts, 1, "Contact points"});
    const auto add = [&](MotionKind kind, const char* label) {
        const auto k = std::size_t(kind);
        if (seen(motion_lines[k]))
            all.push_back({kind == MotionKind::rapid ? Sample::dashes : Sample::line, c.motions[k],
                           motion_line_width(kind), label});
    };
    add(MotionKind::cut, "Cut");
    add(MotionKind::link, "Link");
    const bool approach = seen(motion_lines[std::size_t(MotionKind::approach)]);
    const bool retract = seen(motion_lines[std::size_t(MotionKind::retract)]);
    if (approach && retract)
        add(MotionKind::approach, "Approach, retract");
    else if (approach)
        add(MotionKind::approach, "Approach");
    else
        add(MotionKind::retract, "Retract");
    add(MotionKind::rapid, "Rapid");
    return all;
}

OverlayContent Scene::Impl::overlay_content() const {
    const auto on = [&](Layer layer) { return bool(layer_on[std::size_t(layer)]); };
    const Eigen::Vector2i size = window_size();
    OverlayContent content;
    content.width = size.x();
    content.height = size.y();
    content.ratio = ratio;
    content.palette = palette;
    if (on(Layer::title)) {
        content.title = title;
        content.subtitle = subtitle;
    }
    if (!shows_content()) content.empty_text = empty_text;
    if (on(Layer::legend)) content.legend = legend();
    content.scale = on(Layer::scale) && shows_content();
    content.unit = unit;
    content.mm_per_pixel = pixel_size() * ratio;
    content.axes = on(Layer::axes);
    if (marker && on(Layer::marker)) {
        content.marker = Vec2(display_of(marker->point) / ratio);
        const Vec3 n = camera_frame() * marker->normal;
        content.marker_normal = Vec2(n.x(), -n.y());
    }
    const Mat3 frame = camera_frame();
    for (int k = 0; k < 3; ++k)
        content.axis_directions[std::size_t(k)] = frame.col(k);
    return content;
}

Scene::Scene() : impl_(std::make_unique<Impl>()) {
    set_view(StandardView::iso);
}
Scene::~Scene() {
    detach();
}

void Scene::attach(vtkRenderWindow* window) {
    detach();
    window->SetNumberOfLayers(2);
    window->AddRenderer(impl_->renderer);
    window->AddRenderer(impl_->axes_renderer);
    impl_->window = window;
}

void Scene::detach() {
    if (!impl_->window) return;
    impl_->window->MakeCurrent(); // what lies on the graphics card is freed in its own context
    impl_->window->RemoveRenderer(impl_->renderer);
    impl_->window->RemoveRenderer(impl_->axes_renderer);
    impl_->window = nullptr;
}

vtkRenderer* Scene::renderer() {
    return impl_->renderer;
}
vtkCamera* Scene::camera() {
    return impl_->renderer->GetActiveCamera();
}

void Scene::set_pixel_ratio(double ratio) {
    impl_->ratio = ratio > 0 ? ratio : 1.0;
    impl_->apply_line_widths();
}

void Scene::set_palette(Palette palette) {
    impl_->palette = palette;
    impl_->apply_palette();
}
Palette Scene::palette() const {
    return impl_->palette;
}

void Scene::set_unit(LengthUnit unit) {
    impl_->unit = unit;
}

void Scene::set_antialiasing(bool on) {
    impl_->renderer->SetUseFXAA(on);
}

void Scene::set_part(PartDisplayPtr part) {
    // The old arrays stay until the actors have the new ones.
    const PartDisplayPtr old = std::move(impl_->part);
    impl_->part = std::move(part);
    const PartDisplayPtr& p = impl_->part;
    if (!p || p->triangles.empty()) {
        impl_->part = nullptr;
        for (SceneActor* a : {&impl_->part_surface, &impl_->part_lines, &impl_->part_edges})
            a->clear();
    } else {
        const auto surface = triangle_data(p->points, p->normals, p->triangles);
        impl_->part_surface.set_data(surface, p->centre);
        impl_->part_lines.set_data(segment_data(p->points, p->lines), p->centre);
        impl_->part_edges.set_data(segment_data(p->points, p->edges), p->centre);
    }
    impl_->apply_visibility();
}

void Scene::set_part(MeshPtr mesh) {
    set_part(mesh ? prepare_part_display(std::move(mesh), {}) : PartDisplayPtr());
}

void Scene::set_part_style(PartStyle style) {
    impl_->part_style = style;
    impl_->apply_part_style();
    impl_->apply_visibility();
}
PartStyle Scene::part_style() const {
    return impl_->part_style;
}

void Scene::set_stock(const Box3& box) {
    impl_->stock = box;
    impl_->stock_faces.clear();
    impl_->stock_lines.clear();
    if (!box.empty()) {
        const Vec3 half = box.size() / 2;
        impl_->stock_points.clear();
        for (int corner = 0; corner < 8; ++corner)
            for (int k = 0; k < 3; ++k)
                impl_->stock_points.push_back(float(corner >> k & 1 ? half[k] : -half[k]));
        impl_->stock_triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                  2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
        impl_->stock_segments = {0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7};
        impl_->stock_faces.set_data(triangle_data(impl_->stock_points, {}, impl_->stock_triangles),
                                    box.center());
        impl_->stock_lines.set_data(segment_data(impl_->stock_points, impl_->stock_segments), box.center());
    }
    impl_->apply_visibility();
}

void Scene::set_path(PathDisplayPtr path) {
    const PathDisplayPtr old = std::move(impl_->path);
    impl_->path = std::move(path);
    const auto set = [](SceneActor& a, vtkPolyData* data, const Vec3& centre) { a.set_data(data, centre); };
    static const PathDisplay none;
    const PathDisplay& p = impl_->path ? *impl_->path : none;
    set(impl_->contact_lines, polyline_data(p.contacts), p.centre);
    set(impl_->contact_dots, dot_data(p.contacts), p.centre);
    for (std::size_t k = 0; k < motion_kinds; ++k)
        set(impl_->motion_lines[k], polyline_data(p.motions[k]), p.centre);
    impl_->apply_visibility();
}

void Scene::set_tool(const std::optional<Tool>& tool) {
    std::optional<ToolShape> shape;
    if (tool) shape = make_tool_shape(*tool);
    const auto old = std::move(impl_->tool);
    impl_->tool = std::move(shape);
    for (std::size_t k = 0; k < 3; ++k) {
        impl_->tool_bodies[k].clear();
        impl_->tool_rings[k].clear();
        if (!impl_->tool) continue;
        const RevolvedShape& s = k == 0   ? impl_->tool->cutter
                                 : k == 1 ? impl_->tool->shank
                                          : impl_->tool->holder;
        impl_->tool_bodies[k].set_data(triangle_data(s.points, s.normals, s.triangles), Vec3::Zero());
        impl_->tool_rings[k].set_data(segment_data(s.points, s.rings), Vec3::Zero());
    }
    impl_->place_tool();
}

void Scene::set_tool_pose(const std::optional<CutterLocation>& pose) {
    impl_->pose = pose;
    impl_->place_tool();
}

void Scene::Impl::place_tool() {
    if (pose) {
        const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3(0, 0, 1), pose->axis);
        const Mat3 r = turn.toRotationMatrix();
        vtkNew<vtkMatrix4x4> m;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                m->SetElement(i, j, r(i, j));
            m->SetElement(i, 3, pose->tip[i]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            tool_bodies[k].actor->SetUserMatrix(m);
            tool_rings[k].actor->SetUserMatrix(m);
        }
    }
    apply_visibility();
}

Box3 Scene::Impl::tool_bounds() const {
    Box3 b;
    if (!tool || !pose) return b;
    // A cylinder around the axis from tip to top.
    const Vec3 top = pose->tip + tool->length * pose->axis;
    for (int k = 0; k < 3; ++k) {
        const double side = tool->radius * std::sqrt(std::max(0.0, 1.0 - pose->axis[k] * pose->axis[k]));
        b.lo[k] = std::min(pose->tip[k], top[k]) - side;
        b.hi[k] = std::max(pose->tip[k], top[k]) + side;
    }
    return b;
}

void Scene::set_marker(const std::optional<Marker>& marker) {
    impl_->marker = marker;
}

void Scene::set_title(const std::string& title, const std::string& subtitle) {
    impl_->title = printable(title, 1000);
    impl_->subtitle = printable(subtitle, 1000);
}

void Scene::set_empty_text(const std::string& text) {
    impl_->empty_text = printable(text, 1000);
}

void Scene::set_visible(Layer layer, bool on) {
    impl_->layer_on[std::size_t(layer)] = on;
    impl_->apply_visibility();
}
bool Scene::visible(Layer layer) const {
    return impl_->layer_on[std::size_t(layer)];
}

bool Scene::has(Layer layer) const {
    switch (layer) {
    case Layer::part:
    case Layer::edges:
        return impl_->part != nullptr;
    case Layer::stock:
        return !impl_->stock.empty();
    case Layer::cc:
        return impl_->path && !impl_->path->contacts.empty();
    case Layer::cl:
        for (std::size_t k = 0; impl_->path && k < motion_kinds; ++k)
            if (!impl_->path->motions[k].empty()) return true;
        return false;
    case Layer::tool:
        return impl_->tool && impl_->pose;
    case Layer::marker:
        return impl_->marker.has_value();
    case Layer::axes:
        return true;
    case Layer::scale:
        return impl_->shows_content();
    case Layer::legend:
        return !impl_->legend().empty();
    case Layer::title:
        return !impl_->title.empty() || !impl_->subtitle.empty();
    }
    return false;
}

void Scene::set_motion_visible(MotionKind kind, bool on) {
    impl_->motion_on[std::size_t(kind)] = on;
    impl_->apply_visibility();
}
bool Scene::motion_visible(MotionKind kind) const {
    return impl_->motion_on[std::size_t(kind)];
}

Box3 Scene::bounds(bool with_tool) const {
    Box3 b;
    if (impl_->part && (visible(Layer::part) || visible(Layer::edges))) b.add(impl_->part->box);
    if (visible(Layer::stock)) b.add(impl_->stock);
    if (impl_->path && (visible(Layer::cc) || visible(Layer::cl))) b.add(impl_->path->box);
    if (with_tool && visible(Layer::tool)) b.add(impl_->tool_bounds());
    return b;
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
            const Vec2 off = (f.centre - Vec2(width / 2, height / 2)) / per_mm; // of the box from the middle
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
