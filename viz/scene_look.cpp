// How things look: actors, lights, colours, widths, what is shown, and what every frame needs.
#include "viz/poly_data.h"
#include "viz/scene_impl.h"

#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>
#include <vtk_glew.h>

namespace facetmill {

namespace {

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
    add_light(renderer, -0.6, 0.6, 1.0, 0.66); // key, over the left shoulder
    add_light(renderer, 0.0, 0.0, 1.0, 0.38);  // from the eye
    add_light(renderer, 0.9, -0.3, 0.5, 0.24); // fill from the right
}

} // namespace

SceneActor::SceneActor() {
    mapper->ScalarVisibilityOff();
    mapper->StaticOn(); // the data never change in place
    actor->SetMapper(mapper);
    actor->VisibilityOff();
}

void SceneActor::set_data(vtkPolyData* data, const Vec3& center) {
    mapper->SetInputData(data);
    actor->SetPosition(center.x(), center.y(), center.z());
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
    axes_renderer->UseFXAAOff();
    add_lights(axes_renderer);
    axes_renderer->GetActiveCamera()->ParallelProjectionOn();

    const auto add_all = [&](auto&... actors) { (renderer->AddActor(actors.actor), ...); };
    for (auto& a : finding_dots)
        renderer->AddActor(a.actor);
    add_all(part_surface, part_preview, deviation_surface, deviation_preview, part_lines, part_edges,
            contact_preview, stock_faces, stock_lines, contact_lines, contact_dots, left_dots, kept_dots);
    for (auto* lines : {&motion_lines, &motion_preview, &tint_lines, &tint_preview})
        for (auto& a : *lines)
            renderer->AddActor(a.actor);
    for (auto& a : level_lines) {
        renderer->AddActor(a.actor);
        unlit(a);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        renderer->AddActor(tool_bodies[k].actor);
        renderer->AddActor(tool_rings[k].actor);
        axes_renderer->AddActor(axes[k].actor);
    }
    for (SceneActor* a : {&part_lines, &part_edges, &stock_faces, &stock_lines, &contact_lines, &contact_dots,
                          &contact_preview, &left_dots, &kept_dots})
        unlit(*a);
    for (auto* lines : {&motion_lines, &motion_preview, &tint_lines, &tint_preview})
        for (auto& a : *lines)
            unlit(a);
    for (auto& a : tool_rings)
        unlit(a);
    for (auto& a : finding_dots)
        unlit(a);

    vtkProperty* surface = part_surface.actor->GetProperty();
    surface->SetAmbient(0.10);
    surface->SetDiffuse(0.90);
    surface->SetSpecular(0.12);
    surface->SetSpecularPower(24);
    part_surface.actor->SetBackfaceProperty(vtkSmartPointer<vtkProperty>::New());
    part_preview.actor->SetProperty(surface);
    part_preview.actor->SetBackfaceProperty(part_surface.actor->GetBackfaceProperty());
    // Colours that mean something are drawn with little shade, so that they can be found in the legend.
    vtkProperty* colored = deviation_surface.actor->GetProperty();
    colored->SetAmbient(0.35);
    colored->SetDiffuse(0.65);
    colored->SetSpecular(0);
    deviation_surface.mapper->ScalarVisibilityOn();
    deviation_preview.mapper->ScalarVisibilityOn();
    deviation_preview.actor->SetProperty(colored);
    cut_look->SetAmbient(0.10);
    cut_look->SetDiffuse(0.90);
    cut_look->SetSpecular(0.10);
    cut_look->SetSpecularPower(24);
    // The previews look as what they stand for.
    contact_preview.actor->SetProperty(contact_lines.actor->GetProperty());
    for (std::size_t k = 0; k < motion_kinds; ++k)
        motion_preview[k].actor->SetProperty(motion_lines[k].actor->GetProperty());
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        tint_preview[k].actor->SetProperty(tint_lines[k].actor->GetProperty());
        tint_lines[k].mapper->ScalarVisibilityOn();
        tint_preview[k].mapper->ScalarVisibilityOn();
    }
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
    nearer(level_lines[0], 38);
    nearer(level_lines[1], 42);
    nearer(contact_lines, 40);
    nearer(contact_preview, 40);
    nearer(contact_dots, 48);
    nearer(left_dots, 50);
    nearer(kept_dots, 52);
    for (auto* lines : {&motion_lines, &motion_preview, &tint_lines, &tint_preview})
        for (auto& a : *lines)
            nearer(a, 44);
    for (auto& a : tool_rings)
        nearer(a, 20);
    // The stock's faces lie behind the part's where both have the same plane.
    stock_faces.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(4, 6);
    for (SceneActor* dots : {&contact_dots, &left_dots, &kept_dots})
        dots->actor->GetProperty()->SetRenderPointsAsSpheres(true);
    for (auto& a : finding_dots)
        a.actor->GetProperty()->SetRenderPointsAsSpheres(true);

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
    set_color(level_lines[0], c.stock);
    set_color(level_lines[1], c.marker);
    cut_look->SetColor(c.cut_stock.r, c.cut_stock.g, c.cut_stock.b);
    set_color(finding_dots[std::size_t(FindingMark::Kind::gouge)], c.gouge);
    set_color(finding_dots[std::size_t(FindingMark::Kind::excess)], c.excess);
    set_color(finding_dots[std::size_t(FindingMark::Kind::collision)], c.collision);
    set_color(contact_lines, c.contacts);
    set_color(contact_dots, c.contacts);
    set_color(left_dots, c.left);
    set_color(kept_dots, c.kept);
    for (std::size_t k = 0; k < motion_kinds; ++k)
        set_color(motion_lines[k], c.motions[k]);
    const Rgb tool_colors[3] = {c.cutter, c.shank, c.holder};
    for (std::size_t k = 0; k < 3; ++k) {
        set_color(tool_bodies[k], tool_colors[k]);
        set_color(tool_rings[k], c.feature_edges);
        set_color(axes[k], c.axes[k]);
    }
    color_strips();
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
    set(level_lines[0], 0.9);
    set(level_lines[1], 2.4);
    for (std::size_t i = 0; i < strip_lines.size(); ++i)
        set(*strip_lines[i], chosen_strip == i ? 3.4 : 2.0);
    for (auto& a : strip_handles)
        a->actor->GetProperty()->SetPointSize(float(8 * ratio));
    for (auto& a : tool_rings)
        set(a, 1.0);
    for (std::size_t k = 0; k < motion_kinds; ++k)
        set(motion_lines[k], motion_line_width(MotionKind(k)));
    for (auto& a : tint_lines) // colours that are to be told apart
        set(a, 2.2);
    for (auto& a : finding_dots)
        a.actor->GetProperty()->SetPointSize(float(10 * ratio));
    left_dots.actor->GetProperty()->SetPointSize(float(6 * ratio));
    kept_dots.actor->GetProperty()->SetPointSize(float(9 * ratio));
}

void Scene::Impl::apply_visibility() {
    const auto on = [&](Layer layer) { return bool(layer_on[std::size_t(layer)]); };
    const auto show = [](SceneActor& a, bool wanted) { a.actor->SetVisibility(wanted && a.filled); };
    const bool wire = part_style == PartStyle::wire;
    const bool coarse_part = moving && part_preview.filled,
               coarse_contacts = moving && contact_preview.filled;
    const auto show_all = [&](SceneActor& first, auto& more, bool wanted) {
        show(first, wanted);
        for (auto& piece : more)
            show(*piece, wanted);
    };
    // Cut stock and deviations stand where the part's surface is: one of them is drawn.
    const bool cut = shows_cut_stock(), colored = shows_deviation();
    const bool part_on = on(Layer::part) && !cut;
    show_all(part_surface, more_surface, part_on && !wire && !coarse_part && !colored);
    show(part_preview, part_on && coarse_part && !colored);
    show(part_lines, part_on);
    show_all(part_edges, more_edges, ((on(Layer::edges) && !cut) || (part_on && wire)) && !coarse_part);
    const bool coarse_colors = moving && deviation_preview.filled;
    show_all(deviation_surface, more_deviation, colored && !coarse_colors);
    show(deviation_preview, colored && coarse_colors);
    const bool detailed = has_detail && !moving;
    for (auto& a : cut_patches)
        if (a) show(*a, cut && !detailed);
    for (auto& a : detail_patches)
        if (a) show(*a, cut && detailed);
    for (auto& a : finding_dots)
        show(a, on(Layer::findings));
    for (auto* actors : {&strip_bands, &strip_lines})
        for (auto& a : *actors)
            show(*a, on(Layer::strips));
    for (auto& a : strip_handles)
        show(*a, on(Layer::strips) && handles_on);
    show(stock_faces, on(Layer::stock) && !cut);
    show(stock_lines, on(Layer::stock) && !cut);
    for (auto& a : level_lines)
        show(a, true);
    show(contact_lines, on(Layer::cc) && !coarse_contacts);
    show(contact_dots, on(Layer::cc) && !coarse_contacts);
    show(contact_preview, on(Layer::cc) && coarse_contacts);
    for (SceneActor* dots : {&left_dots, &kept_dots}) // what the path leaves is shown with it
        show(*dots, on(Layer::cc) || on(Layer::cl));
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        const bool shown = on(Layer::cl) && motion_on[k], tinted = tint_lines[k].filled;
        const bool coarse = moving && (tinted ? tint_preview[k] : motion_preview[k]).filled;
        show(motion_lines[k], shown && !tinted && !coarse);
        show(motion_preview[k], shown && !tinted && coarse);
        show(tint_lines[k], shown && !coarse);
        show(tint_preview[k], shown && coarse);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        show(tool_bodies[k], on(Layer::tool) && pose.has_value());
        show(tool_rings[k], on(Layer::tool) && pose.has_value());
    }
    if (step) show_step();
    if (rehearsing) show_rehearsal();
}

bool Scene::Impl::shows_back() const {
    if (shows_cut_stock() || shows_deviation()) return false;
    if (!part || !part->has_border || !layer_on[std::size_t(Layer::part)] || part_style == PartStyle::wire)
        return false;
    // A sample is enough for a line of the legend.
    const std::size_t n = part->mesh->facets.size(), stride = n / 2048 + 1;
    const Vec3 toward = camera_frame().row(2).transpose();
    std::size_t seen = 0, back = 0;
    for (std::size_t f = 0; f < n; f += stride, ++seen)
        back += part->mesh->facet_normal(f).dot(toward) < 0;
    return 50 * back > seen;
}

void Scene::Impl::update_frame() {
    // A context that others draw in too may come with GL_LESS; then nothing flat shows on top of something
    // flat.
    if (auto* gl = vtkOpenGLRenderWindow::SafeDownCast(window)) {
        gl->GetState()->vtkglDepthFunc(GL_LEQUAL);
        if (step) {
            // What VTK does when it clears the depth, which the steps after the first leave alone.
            gl->GetState()->vtkglDepthMask(GL_TRUE);
            gl->GetState()->vtkglEnable(GL_DEPTH_TEST);
        }
    }
    apply_visibility();
    // Dots and lines that would run into each other are thinner.
    const double gap = path && path->contact_spacing > 0 && pixel_size() > 0
                           ? path->contact_spacing / pixel_size()
                           : infinity;
    contact_dots.actor->GetProperty()->SetPointSize(float(std::clamp(0.4 * gap, 0.8 * ratio, 2.6 * ratio)));
    contact_lines.actor->GetProperty()->SetLineWidth(float(std::clamp(0.2 * gap, 0.4 * ratio, 0.8 * ratio)));
    renderer->SetUseFXAA(antialiasing && smoothing_step());
    renderer->SetErase(!step || *step <= first_step);
    axes_renderer->SetDraw(false);
    if (!step) set_clipping_range(); // the steps of one picture have one range
    overlay->update(last_step() ? overlay_content() : OverlayContent());
    if (!last_step()) return;
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
    const auto on = [&](Layer layer) { return bool(layer_on[std::size_t(layer)]); };
    const auto moves = [&](MotionKind kind) {
        const auto k = std::size_t(kind);
        return on(Layer::cl) && motion_on[k] && motion_lines[k].filled && !tint_lines[k].filled;
    };
    std::vector<LegendEntry> all;
    if (shows_back()) all.push_back({Sample::surface, c.part_back, 1, "Back of the surface"});
    if (shows_cut_stock())
        all.push_back({Sample::surface, c.cut_stock, 1, "Stock"});
    else if (on(Layer::stock) && stock_lines.filled)
        all.push_back({Sample::box, c.stock, 1, "Stock"});
    if (level_lines[0].filled) all.push_back({Sample::line, c.stock, 1, "Layers"});
    if (level_lines[1].filled) all.push_back({Sample::line, c.marker, 2.4, "Layer chosen"});
    const auto found = [&](FindingMark::Kind kind, const Rgb& color, const char* label) {
        if (on(Layer::findings) && finding_dots[std::size_t(kind)].filled)
            all.push_back({Sample::spot, color, 1, label});
    };
    found(FindingMark::Kind::gouge, c.gouge, "Deepest gouges");
    found(FindingMark::Kind::collision, c.collision, "Collisions");
    found(FindingMark::Kind::excess, c.excess, "Largest excess");
    add_strip_legend(all);
    if (on(Layer::marker) && !touches.empty())
        all.push_back({Sample::spot, c.contacts, 1, "Touches of the tool"});
    if (on(Layer::cc) && contact_dots.filled) all.push_back({Sample::dot, c.contacts, 1, "Contact points"});
    const auto mark = [&](const SceneActor& dots, const Rgb& color, const char* label) {
        if (dots.filled && (on(Layer::cc) || on(Layer::cl))) all.push_back({Sample::spot, color, 1, label});
    };
    mark(left_dots, c.left, "Left to clean-up");
    mark(kept_dots, c.kept, "Posture kept by hand");
    const auto add = [&](MotionKind kind, const char* label) {
        const auto k = std::size_t(kind);
        if (moves(kind))
            all.push_back({kind == MotionKind::rapid ? Sample::dashes : Sample::line, c.motions[k],
                           motion_line_width(kind), label});
    };
    add(MotionKind::cut, "Cut");
    add(MotionKind::link, "Link");
    const bool approach = moves(MotionKind::approach);
    const bool retract = moves(MotionKind::retract);
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
    if (on(Layer::legend)) {
        content.legend = legend();
        content.color_bars = color_bars();
    }
    content.scale = on(Layer::scale) && shows_content();
    content.unit = unit;
    content.mm_per_pixel = pixel_size() * ratio;
    content.axes = on(Layer::axes);
    if (all_overlay) {
        using Sample = LegendEntry::Sample;
        content.title = content.subtitle = "-";
        content.scale = true;
        for (const Sample sample : {Sample::surface, Sample::box, Sample::dot, Sample::line, Sample::dashes})
            content.legend.push_back({sample, colors_of(palette).stock, 1, "-"});
    }
    if (on(Layer::marker))
        for (const Vec3& p : touches)
            content.spots.push_back({Vec2(display_of(p) / ratio), colors_of(palette).contacts});
    if (marker && on(Layer::marker)) {
        content.marker = Vec2(display_of(marker->point) / ratio);
        const Vec3 n = camera_frame() * marker->normal;
        content.marker_normal = Vec2(n.x(), -n.y());
    }
    const Mat3 frame = camera_frame();
    for (int k = 0; k < 3; ++k)
        content.axis_directions[std::size_t(k)] = frame.col(k);
    if (shows_strips()) content.notes = strip_notes(overlay->layout(content));
    return content;
}

} // namespace facetmill
