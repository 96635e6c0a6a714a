#include "viz/scene.h"

#include "core/base/turn.h"
#include "viz/poly_data.h"
#include "viz/scene_impl.h"

#include <vtkMatrix4x4.h>

#include <cmath>

namespace facetmill {

bool Scene::Impl::shows_content() const {
    return part || deviation || !stock.empty() || (path && !path->box.empty());
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

void Scene::set_moving(bool moving) {
    impl_->moving = moving;
    impl_->apply_visibility();
}

// Each takes some 0.3 ms to get to the graphics card for the first time.
constexpr std::size_t few_patches = 30;

bool Scene::has_preview() const {
    bool any = impl_->part_preview.filled || impl_->contact_preview.filled || impl_->deviation_preview.filled
               || impl_->has_detail || impl_->cut_patches.size() > few_patches;
    for (const auto* previews : {&impl_->motion_preview, &impl_->tint_preview})
        for (const SceneActor& a : *previews)
            any = any || a.filled;
    return any;
}

void Scene::set_antialiasing(bool on) {
    impl_->antialiasing = on;
}

void Scene::set_part(PartDisplayPtr part) {
    // The old arrays stay until the actors have the new ones.
    const PartDisplayPtr old = std::move(impl_->part);
    impl_->part = std::move(part);
    impl_->part_is_new = true;
    const PartDisplayPtr& p = impl_->part;
    if (!p || p->triangles.empty()) {
        impl_->part = nullptr;
        impl_->set_pieces(impl_->part_surface, impl_->more_surface, {}, Vec3::Zero());
        impl_->set_pieces(impl_->part_edges, impl_->more_edges, {}, Vec3::Zero());
        impl_->part_lines.clear();
        impl_->part_preview.clear();
    } else {
        const auto surface = triangle_pieces(p->points, p->normals, p->triangles, elements_in_piece);
        vtkPolyData* like = surface.front();
        impl_->set_pieces(impl_->part_surface, impl_->more_surface, surface, p->center);
        impl_->set_pieces(impl_->part_edges, impl_->more_edges,
                          segment_pieces(like, p->edges, elements_in_piece), p->center);
        impl_->part_lines.set_data(segment_pieces(like, p->lines, p->lines.size()).front(), p->center);
        const PartPreview& preview = p->preview;
        impl_->part_preview.set_data(triangle_data(preview.points, preview.normals, preview.triangles),
                                     p->center);
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

void Scene::set_stock_shape(StockShapePtr shape) {
    if (shape == impl_->stock_shape) return;
    // The arrays stay until the actors have others.
    const StockShapePtr old = std::exchange(impl_->stock_shape, std::move(shape));
    impl_->stock_faces.clear();
    impl_->stock_lines.clear();
    impl_->stock = Box3();
    if (const StockShapePtr& s = impl_->stock_shape) {
        impl_->stock = s->box;
        impl_->stock_faces.set_data(triangle_data(s->points, {}, s->triangles), s->center);
        impl_->stock_lines.set_data(segment_data(s->points, s->segments), s->center);
    }
    impl_->apply_visibility();
}

void Scene::set_stock(const Box3& box) {
    StockSolid solid;
    solid.box = box;
    set_stock_shape(make_stock_shape(solid, {}));
}

void Scene::set_levels(const std::optional<LevelMarks>& levels) {
    if (levels == impl_->levels) return;
    impl_->levels = levels;
    for (std::size_t k = 0; k < 2; ++k) {
        impl_->level_lines[k].clear();
        auto& points = impl_->level_points[k];
        auto& segments = impl_->level_segments[k];
        points.clear();
        segments.clear();
        if (!levels) continue;
        const Box3& box = levels->box;
        const Vec3 center = box.center();
        for (std::size_t i = 0; i < levels->heights.size(); ++i) {
            if ((levels->chosen == i) != (k == 1)) continue;
            const auto first = std::int32_t(points.size() / 3);
            for (const auto& [x, y] : {std::pair(box.lo.x(), box.lo.y()),
                                       {box.hi.x(), box.lo.y()},
                                       {box.hi.x(), box.hi.y()},
                                       {box.lo.x(), box.hi.y()}})
                for (const double v : {x - center.x(), y - center.y(), levels->heights[i] - center.z()})
                    points.push_back(float(v));
            for (std::int32_t c = 0; c < 4; ++c)
                segments.insert(segments.end(), {first + c, first + (c + 1) % 4});
        }
        if (!segments.empty()) impl_->level_lines[k].set_data(segment_data(points, segments), center);
    }
    impl_->apply_visibility();
}

void Scene::set_path_tint(TintedPathPtr tint) {
    // The old arrays stay until the actors have the new ones.
    const TintedPathPtr old = std::move(impl_->tint);
    impl_->tint = std::move(tint);
    static const TintedPath none;
    const TintedPath& t = impl_->tint ? *impl_->tint : none;
    const auto set = [&](SceneActor& a, const TintedPath::Lines& lines) {
        if (lines.empty()) {
            a.clear();
            return;
        }
        const auto data = segment_data(lines.points, lines.segments);
        set_point_colors({data}, lines.rgba);
        a.set_data(data, t.center);
    };
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        set(impl_->tint_lines[k], t.lines[k]);
        set(impl_->tint_preview[k], t.preview[k]);
    }
    impl_->apply_visibility();
}

void Scene::set_path(PathDisplayPtr path) {
    set_path_tint(nullptr);
    const PathDisplayPtr old = std::move(impl_->path);
    impl_->path = std::move(path);
    const auto set = [](SceneActor& a, vtkPolyData* data, const Vec3& center) { a.set_data(data, center); };
    static const PathDisplay none;
    const PathDisplay& p = impl_->path ? *impl_->path : none;
    set(impl_->contact_lines, polyline_data(p.contacts), p.center);
    set(impl_->contact_dots, dot_data(p.contacts), p.center);
    set(impl_->contact_preview, polyline_data(p.contacts_preview), p.center);
    set(impl_->left_dots, dot_data(p.left_points), p.center);
    set(impl_->kept_dots, dot_data(p.kept_points), p.center);
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        set(impl_->motion_lines[k], polyline_data(p.motions[k]), p.center);
        set(impl_->motion_preview[k], polyline_data(p.motions_preview[k]), p.center);
    }
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

const std::optional<CutterLocation>& Scene::tool_pose() const {
    return impl_->pose;
}

void Scene::set_tool_pose(const std::optional<CutterLocation>& pose) {
    impl_->pose = pose;
    impl_->place_tool();
}

void Scene::Impl::place_tool() {
    if (pose) {
        const Eigen::Quaterniond turn = turn_between(Vec3(0, 0, 1), pose->axis);
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

void Scene::set_touches(const std::vector<Vec3>& points) {
    impl_->touches = points;
}
const std::vector<Vec3>& Scene::touches() const {
    return impl_->touches;
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
        return !impl_->stock.empty() || impl_->has_cut;
    case Layer::deviation:
        return impl_->deviation != nullptr;
    case Layer::findings:
        return !impl_->findings.empty();
    case Layer::strips:
        return impl_->strips && !impl_->strips->strips.empty();
    case Layer::cc:
        return impl_->path && !impl_->path->contacts.empty();
    case Layer::cl:
        for (std::size_t k = 0; impl_->path && k < motion_kinds; ++k)
            if (!impl_->path->motions[k].empty()) return true;
        return false;
    case Layer::tool:
        return impl_->tool && impl_->pose;
    case Layer::marker:
        return impl_->marker.has_value() || !impl_->touches.empty();
    case Layer::axes:
        return true;
    case Layer::scale:
        return impl_->shows_content();
    case Layer::legend:
        return !impl_->legend().empty() || !impl_->color_bars().empty();
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

} // namespace facetmill
