#include "viz/scene.h"

#include "viz/overlay.h"
#include "viz/scene_axes.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <utility>

#include <vtk_glew.h>

namespace facetmill {

struct Scene::Impl {
    Impl();
    ~Impl();

    void apply_palette();
    void apply_line_widths();
    void apply_visibility();
    void update_frame();       ///< before every frame
    void set_clipping_range(); ///< from what is visible
    ShownSurface surface() const;
    bool shows_content() const; ///< there is something, seen or not
    Box3 seen_box() const;      ///< of what is visible of part, stock and paths
    /// Nothing of it is seen: it is not there, or switched off.
    bool looks_empty() const;
    std::vector<LegendEntry> legend() const;
    std::vector<ColorBar> color_bars() const; ///< for what is shown, the one to be kept first
    OverlayContent overlay_content();

    LayoutRect fitted_beside; ///< the legend at the last fit
    LayoutRect asked_beside;  ///< at the last one that was not made to make room
    bool makes_room = false;  ///< the next fit does
    bool made_room = false; ///< the last one did: a legend no larger than `asked_beside` gives the room back
    SceneStage stage;
    SceneAxes axes{stage};
    SceneRehearsal rehearsal{stage.renderer};
    SceneFindings findings{stage};
    ScenePart part{stage};
    SceneFormer former{stage};
    SceneBoundaries boundaries{stage, part};
    SceneDeviation deviation{stage};
    SceneStock stock{stage};
    SceneFixtures fixtures{stage};
    ScenePaths paths{stage, part};
    SceneLevels levels{stage};
    ScenePreview preview{stage};
    SceneSupport support{stage};
    SceneRepair repair{stage};
    SceneTool tool{stage};
    SceneStrips strips{stage, part};
    SceneMarks marks{stage};
    SceneZero zero{stage};
    /// In the order of the legend.
    const std::array<SceneLayer*, 16> layers{&part,   &boundaries, &former,  &repair,   &stock,  &fixtures,
                                             &levels, &preview,    &support, &findings, &strips, &marks,
                                             &paths,  &deviation,  &tool,    &zero};
    Overlay overlay{stage.renderer};
    vtkNew<vtkCallbackCommand> frame_callback;

    bool antialiasing = true;
    bool all_overlay = false; ///< for the shaders, not to be shown
    std::string title, subtitle, empty_text = "Nothing to show";
};

Scene::Impl::Impl() {
    // Lines on a surface are drawn in front of it. VTK keeps this setting for the whole process.
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
    vtkRenderer* renderer = stage.renderer;
    renderer->SetBackgroundAlpha(1.0); // a widget that is composed with others must not be seen through
    renderer->GradientBackgroundOn();
    renderer->TwoSidedLightingOn();
    renderer->UseFXAAOn();
    add_lights(renderer);
    frame_callback->SetClientData(this);
    frame_callback->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
        static_cast<Scene::Impl*>(self)->update_frame();
    });
    renderer->AddObserver(vtkCommand::StartEvent, frame_callback);
    apply_palette();
    apply_line_widths();
}

Scene::Impl::~Impl() {
    stage.renderer->RemoveObserver(frame_callback);
}

void Scene::Impl::apply_palette() {
    const Colors& c = colors_of(stage.palette);
    stage.renderer->SetBackground(c.background_bottom.r, c.background_bottom.g, c.background_bottom.b);
    stage.renderer->SetBackground2(c.background_top.r, c.background_top.g, c.background_top.b);
    axes.apply_palette(c);
    for (SceneLayer* layer : layers)
        layer->apply_palette(c);
}

void Scene::Impl::apply_line_widths() {
    for (SceneLayer* layer : layers)
        layer->apply_line_widths();
}

ShownSurface Scene::Impl::surface() const {
    if (repair.covers()) return ShownSurface::repair;
    if (boundaries.foremost()) return ShownSurface::part;
    if (stock.shows_cut()) return ShownSurface::cut_stock;
    return deviation.wanted() ? ShownSurface::deviation : ShownSurface::part;
}

void Scene::Impl::apply_visibility() {
    const ShownSurface shown = surface();
    for (SceneLayer* layer : layers)
        layer->apply_visibility(shown);
    stage.steps.hide_others(stage.renderer);
    boundaries.hide_others();
    if (rehearsal.running()) rehearsal.show();
}

void Scene::Impl::update_frame() {
    const SceneSteps& steps = stage.steps;
    const bool adds = boundaries.shows_added();
    if (!steps.running() && !adds) boundaries.settle();
    // A context that others draw in too may come with GL_LESS; then nothing flat shows on top of something
    // flat.
    if (auto* gl = vtkOpenGLRenderWindow::SafeDownCast(stage.camera.window())) {
        gl->GetState()->vtkglDepthFunc(GL_LEQUAL);
        if (steps.running() || adds) {
            // What VTK does when it clears the depth, which the steps after the first leave alone.
            gl->GetState()->vtkglDepthMask(GL_TRUE);
            gl->GetState()->vtkglEnable(GL_DEPTH_TEST);
        }
    }
    apply_visibility();
    for (SceneLayer* layer : layers)
        layer->prepare_frame();
    stage.renderer->SetUseFXAA(antialiasing && steps.smooths() && !adds);
    stage.renderer->SetErase(steps.erases() && !adds);
    if (!steps.running() && !adds) set_clipping_range(); // what makes up one picture has one range
    const bool last = steps.last() && !adds;
    overlay.update(last ? overlay_content() : OverlayContent());
    axes.prepare_frame(last);
}

void Scene::Impl::set_clipping_range() {
    KnownBoxes known;
    for (const SceneLayer* layer : layers)
        layer->add_known(known);
    std::sort(known.actors.begin(), known.actors.end());
    Box3& box = known.box;
    vtkActorCollection* actors = stage.renderer->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it)) {
        if (!actor->GetVisibility() || std::binary_search(known.actors.begin(), known.actors.end(), actor))
            continue;
        const double* b = actor->GetBounds();
        if (!b || b[0] > b[1]) continue;
        box.add(Vec3(b[0], b[2], b[4]));
        box.add(Vec3(b[1], b[3], b[5]));
    }
    if (box.empty()) {
        stage.renderer->ResetCameraClippingRange();
        return;
    }
    const double ends[6] = {box.lo.x(), box.hi.x(), box.lo.y(), box.hi.y(), box.lo.z(), box.hi.z()};
    stage.renderer->ResetCameraClippingRange(ends);
    if (!stage.camera.perspective()) return;
    // Depth is finest near the eye: much before what is looked at it would be wasted on what is not there.
    constexpr double nearest_share = 0.05;
    vtkCamera* camera = stage.camera.vtk();
    double range[2];
    camera->GetClippingRange(range);
    range[0] = std::max(range[0], nearest_share * camera->GetDistance());
    camera->SetClippingRange(range[0], std::max(range[1], 2 * range[0]));
}

bool Scene::Impl::shows_content() const {
    const SceneLayer &of_part = part, &of_deviation = deviation;
    return repair.covers() || of_part.has(Layer::part) || of_deviation.has(Layer::deviation)
           || stock.has_uncut() || !paths.empty();
}

Box3 Scene::Impl::seen_box() const {
    Box3 box;
    for (const SceneLayer* layer : layers)
        layer->add_bounds(box);
    return box;
}

bool Scene::Impl::looks_empty() const {
    if (!shows_content()) return true;
    const SceneLayer& of_strips = strips;
    return seen_box().empty() && !(of_strips.has(Layer::strips) && stage.on(Layer::strips))
           && tool.bounds().empty();
}

std::vector<LegendEntry> Scene::Impl::legend() const {
    std::vector<LegendEntry> all;
    for (const SceneLayer* layer : layers)
        layer->add_legend(all, surface());
    return all;
}

std::vector<ColorBar> Scene::Impl::color_bars() const {
    std::vector<ColorBar> bars;
    for (const SceneLayer* layer : layers)
        layer->add_color_bars(bars, surface());
    return bars;
}

OverlayContent Scene::Impl::overlay_content() {
    const SceneCamera& camera = stage.camera;
    const Eigen::Vector2i size = camera.window_size();
    OverlayContent content;
    content.width = size.x();
    content.height = size.y();
    content.ratio = stage.ratio;
    content.palette = stage.palette;
    if (stage.on(Layer::title)) {
        content.title = title;
        content.subtitle = subtitle;
    }
    if (looks_empty()) content.empty_text = empty_text;
    if (stage.on(Layer::legend)) {
        content.legend = legend();
        content.color_bars = color_bars();
    }
    content.scale = stage.on(Layer::scale) && shows_content() && !camera.perspective();
    content.unit = stage.unit;
    content.mm_per_pixel = camera.pixel_size() * stage.ratio;
    content.axes = stage.on(Layer::axes);
    content.covered_below = stage.covered_below;
    content.covered = stage.covered;
    if (all_overlay) {
        using Sample = LegendEntry::Sample;
        content.title = content.subtitle = "-";
        content.scale = true;
        for (const Sample sample : {Sample::surface, Sample::box, Sample::dot, Sample::line, Sample::dashes})
            content.legend.push_back({sample, colors_of(stage.palette).stock, 1, "-"});
    }
    marks.add_to(content);
    zero.add_to(content);
    stock.add_to(content);
    const Mat3 frame = camera.frame();
    for (int k = 0; k < 3; ++k)
        content.axis_directions[std::size_t(k)] = frame.col(k);
    if (strips.shown()) content.notes = strips.notes(overlay, overlay.layout(content));
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
    window->AddRenderer(impl_->stage.renderer);
    window->AddRenderer(impl_->axes.renderer());
    impl_->stage.camera.set_window(window);
}

void Scene::detach() {
    vtkRenderWindow* window = impl_->stage.camera.window();
    if (!window) return;
    window->MakeCurrent(); // what lies on the graphics card is freed in its own context
    window->RemoveRenderer(impl_->stage.renderer);
    window->RemoveRenderer(impl_->axes.renderer());
    impl_->stage.camera.set_window(nullptr);
}

vtkRenderer* Scene::renderer() {
    return impl_->stage.renderer;
}

ScenePart& Scene::part() {
    return impl_->part;
}
const ScenePart& Scene::part() const {
    return impl_->part;
}
SceneFormer& Scene::former() {
    return impl_->former;
}
const SceneFormer& Scene::former() const {
    return impl_->former;
}
SceneBoundaries& Scene::boundaries() {
    return impl_->boundaries;
}
SceneStock& Scene::stock() {
    return impl_->stock;
}

SceneFixtures& Scene::fixtures() {
    return impl_->fixtures;
}

const SceneFixtures& Scene::fixtures() const {
    return impl_->fixtures;
}
SceneDeviation& Scene::deviation() {
    return impl_->deviation;
}
const SceneDeviation& Scene::deviation() const {
    return impl_->deviation;
}
SceneFindings& Scene::findings() {
    return impl_->findings;
}
SceneZero& Scene::zero() {
    return impl_->zero;
}
ScenePreview& Scene::preview() {
    return impl_->preview;
}
const ScenePreview& Scene::preview() const {
    return impl_->preview;
}
SceneSupport& Scene::support() {
    return impl_->support;
}
SceneRepair& Scene::repair() {
    return impl_->repair;
}

SceneLevels& Scene::levels() {
    return impl_->levels;
}
SceneStrips& Scene::strips() {
    return impl_->strips;
}
const SceneStrips& Scene::strips() const {
    return impl_->strips;
}
ScenePaths& Scene::paths() {
    return impl_->paths;
}
const ScenePaths& Scene::paths() const {
    return impl_->paths;
}
SceneTool& Scene::tool() {
    return impl_->tool;
}
const SceneTool& Scene::tool() const {
    return impl_->tool;
}
SceneMarks& Scene::marks() {
    return impl_->marks;
}
const SceneMarks& Scene::marks() const {
    return impl_->marks;
}
SceneCamera& Scene::camera() {
    return impl_->stage.camera;
}
const SceneCamera& Scene::camera() const {
    return impl_->stage.camera;
}

void Scene::set_pixel_ratio(double ratio) {
    impl_->stage.ratio = ratio > 0 ? ratio : 1.0;
    impl_->apply_line_widths();
}

void Scene::set_line_scale(double scale) {
    impl_->stage.line_scale = scale;
    impl_->apply_line_widths();
}

bool Scene::set_covered_below(double pixels) {
    return std::exchange(impl_->stage.covered_below, pixels) != pixels;
}

void Scene::set_covered(const Vec2& from, const Vec2& to) {
    impl_->stage.covered = {from.x(), from.y(), to.x(), to.y()};
}

void Scene::set_palette(Palette palette) {
    impl_->stage.palette = palette;
    impl_->apply_palette();
}
Palette Scene::palette() const {
    return impl_->stage.palette;
}

void Scene::set_unit(LengthUnit unit) {
    impl_->stage.unit = unit;
}

void Scene::set_antialiasing(bool on) {
    impl_->antialiasing = on;
}

void Scene::set_moving(bool moving) {
    impl_->stage.moving = moving;
}

bool Scene::has_preview() const {
    return std::any_of(impl_->layers.begin(), impl_->layers.end(),
                       [](const SceneLayer* layer) { return layer->has_preview(); });
}

bool Scene::begin_added() {
    if (!impl_->boundaries.begin_added()) return false;
    impl_->apply_visibility();
    return true;
}

void Scene::end_added() {
    impl_->boundaries.end_added();
    impl_->apply_visibility();
}

std::size_t Scene::begin_steps() {
    Impl& s = *impl_;
    s.stage.steps.forget();
    s.boundaries.settle();
    s.apply_visibility();
    s.set_clipping_range();
    HeavyActors heavy;
    // What covers most first, what can be seen through last.
    for (SceneLayer* layer :
         std::array<SceneLayer*, 6>{&s.part, &s.boundaries, &s.deviation, &s.stock, &s.paths, &s.former})
        layer->add_heavy(heavy);
    return s.stage.steps.begin(heavy, s.part.lines_of_new());
}

void Scene::set_step(std::size_t step) {
    impl_->stage.steps.set(step);
    impl_->apply_visibility();
}

void Scene::end_steps() {
    impl_->stage.steps.forget();
    impl_->apply_visibility();
}

void Scene::rehearse(std::size_t k) {
    Impl& s = *impl_;
    // In the middle of the view, wherever that is: what is out of sight VTK does not draw.
    const CameraPlace place = s.stage.camera.place();
    s.rehearsal.begin(place.target, 0.2 * place.height * place.up.cross(place.toward_eye),
                      0.2 * place.height * place.up);
    s.all_overlay = k == 3;
    for (SceneLayer* layer : s.layers)
        layer->rehearse(k, s.rehearsal);
    s.apply_visibility();
}

void Scene::end_rehearsal() {
    impl_->rehearsal.end();
    impl_->all_overlay = false;
    impl_->apply_visibility();
}

void Scene::set_title(const std::string& title, const std::string& subtitle) {
    impl_->title = printable(title, 1000);
    impl_->subtitle = printable(subtitle, 1000);
}

void Scene::set_empty_text(const std::string& text) {
    impl_->empty_text = printable(text, 1000);
}
std::string Scene::shown_empty_text() const {
    return impl_->looks_empty() ? impl_->empty_text : std::string();
}

void Scene::set_visible(Layer layer, bool on) {
    impl_->stage.layers_on[std::size_t(layer)] = on;
}
bool Scene::visible(Layer layer) const {
    return impl_->stage.on(layer);
}

bool Scene::has(Layer layer) const {
    switch (layer) {
    case Layer::axes:
        return true;
    case Layer::scale:
        return impl_->shows_content();
    case Layer::legend:
        return !impl_->legend().empty() || !impl_->color_bars().empty();
    case Layer::title:
        return !impl_->title.empty() || !impl_->subtitle.empty();
    default:
        return std::any_of(impl_->layers.begin(), impl_->layers.end(),
                           [&](const SceneLayer* l) { return l->has(layer); });
    }
}

Box3 Scene::bounds(bool with_tool) const {
    Box3 box = impl_->seen_box();
    if (with_tool) box.add(impl_->tool.bounds());
    return box;
}

void Scene::set_view(StandardView view) {
    impl_->stage.camera.turn_to(view);
    fit();
}

void Scene::fit(bool with_tool) {
    Impl& s = *impl_;
    const Box3 box = bounds(with_tool);
    if (box.empty())
        s.stage.camera.fit_empty();
    else
        s.stage.camera.fit(box, s.overlay.layout(s.overlay_content()), s.stage.ratio);
    s.fitted_beside = s.overlay.layout(s.overlay_content()).legend;
    s.made_room = std::exchange(s.makes_room, false);
    if (!s.made_room) s.asked_beside = s.fitted_beside;
}

bool Scene::legend_lies_over() const {
    Impl& s = *impl_;
    const LayoutRect legend = s.overlay.layout(s.overlay_content()).legend;
    return s.stage.camera.shadow_meets(bounds(), legend, s.stage.ratio);
}

bool Scene::legend_came_over() const {
    Impl& s = *impl_;
    const LayoutRect legend = s.overlay.layout(s.overlay_content()).legend, &before = s.fitted_beside;
    const bool same =
        legend.x0 == before.x0 && legend.y0 == before.y0 && legend.x1 == before.x1 && legend.y1 == before.y1;
    if (same) return false;
    const LayoutRect& asked = s.asked_beside;
    const bool no_larger =
        legend.empty()
        || (legend.x0 >= asked.x0 && legend.y0 >= asked.y0 && legend.x1 <= asked.x1 && legend.y1 <= asked.y1);
    s.makes_room = legend_lies_over();
    return s.makes_room || (s.made_room && no_larger);
}

} // namespace facetmill
