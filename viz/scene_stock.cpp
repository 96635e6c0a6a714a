#include "viz/scene_stock.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <utility>

namespace facetmill {

namespace {

// Each takes some 0.3 ms to get to the graphics card for the first time.
constexpr std::size_t few_patches = 30;

/// The patch's own arrays, without a copy: whoever has the data keeps the patch.
vtkSmartPointer<vtkPolyData> patch_data(const StockPatch& patch) {
    static_assert(sizeof(std::array<float, 3>) == 3 * sizeof(float)
                  && sizeof(std::array<std::uint32_t, 3>) == 3 * sizeof(std::int32_t));
    return triangle_data(patch.points.front().data(), patch.normals.front().data(), patch.points.size(),
                         reinterpret_cast<const std::int32_t*>(patch.triangles.front().data()),
                         patch.triangles.size());
}

} // namespace

SceneStock::SceneStock(SceneStage& stage)
    : SceneLayer(stage), cut_look_(vtkSmartPointer<vtkProperty>::New()) {
    for (SceneActor* a : {&faces_, &lines_}) {
        add_actor(*a);
        a->unlit();
    }
    // All faces have the same colour and no light, so that they blend alike in any order.
    faces_.property()->SetOpacity(0.10);
    // They lie behind the part's where both have the same plane.
    faces_.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(4, 6);
    lines_.nearer(36);
    cut_look_->SetAmbient(0.10);
    cut_look_->SetDiffuse(0.90);
    cut_look_->SetSpecular(0.10);
    cut_look_->SetSpecularPower(24);
}

void SceneStock::set(StockShapePtr shape) {
    if (shape == shape_) return;
    // The arrays stay until the actors have others.
    const StockShapePtr old = std::exchange(shape_, std::move(shape));
    faces_.clear();
    lines_.clear();
    box_ = Box3();
    if (!shape_) return;
    box_ = shape_->box;
    faces_.set_data(triangle_data(shape_->points, {}, shape_->triangles), shape_->center);
    lines_.set_data(segment_data(shape_->points, shape_->segments), shape_->center);
}

void SceneStock::set_box(const Box3& box) {
    StockSolid solid;
    solid.box = box;
    set(make_stock_shape(solid, {}));
}

void SceneStock::set_cut(const StockPatches& patches, const StockPatches& detail) {
    swap(cut_, patches);
    swap(detail_, detail);
}

void SceneStock::swap(Surface& surface, const StockPatches& patches) {
    // The arrays stay until the actors have others.
    const StockPatches old = std::exchange(surface.patches, patches);
    SceneActors& actors = surface.actors;
    vtkRenderer* renderer = stage_.renderer;
    stage_.steps.forget();
    for (std::size_t i = patches.size(); i < actors.size(); ++i)
        if (actors[i]) renderer->RemoveActor(actors[i]->actor);
    actors.resize(patches.size());
    surface.any = false;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto& patch = patches[i];
        const bool drawn = patch && !patch->triangles.empty();
        surface.any |= drawn;
        if (i < old.size() && old[i] == patch && bool(actors[i]) == drawn) continue;
        if (!drawn) {
            if (actors[i]) renderer->RemoveActor(actors[i]->actor);
            actors[i] = nullptr;
            continue;
        }
        if (!actors[i]) {
            actors[i] = std::make_unique<SceneActor>();
            actors[i]->actor->SetProperty(cut_look_);
            add_actor(*actors[i]);
        }
        actors[i]->set_data(patch_data(*patch), Vec3::Zero());
    }
}

bool SceneStock::shows_cut() const {
    return cut_.any && stage_.on(Layer::stock);
}

bool SceneStock::has(Layer layer) const {
    return layer == Layer::stock && (has_uncut() || cut_.any);
}

void SceneStock::apply_palette(const Colors& colors) {
    faces_.color(colors.stock);
    lines_.color(colors.stock);
    cut_look_->SetColor(colors.cut_stock.r, colors.cut_stock.g, colors.cut_stock.b);
}

void SceneStock::apply_line_widths() {
    lines_.set_line_width(1.4 * stage_.line_ratio());
}

void SceneStock::apply_visibility(ShownSurface shown) {
    const bool cut = shown == ShownSurface::cut_stock, detailed = detail_.any && !stage_.moving;
    for (auto& a : cut_.actors)
        if (a) a->show(cut && !detailed);
    for (auto& a : detail_.actors)
        if (a) a->show(cut && detailed);
    const bool on = (stage_.on(Layer::stock) || dimensioned()) && !cut;
    faces_.show(on);
    lines_.show(on);
}

/// At the middle of the box's edge along each axis that is lowest on the screen, or farthest left where that
/// says nothing: not before the part.
void SceneStock::add_to(OverlayContent& content) const {
    if (box_.empty() || !lines_.shown()) return;
    for (int k = 0; k < 3; ++k) {
        const std::string& text = dimensions_[std::size_t(k)];
        if (text.empty()) continue;
        Vec2 best = Vec2::Zero();
        double outermost = -infinity;
        for (unsigned corner = 0; corner < 4; ++corner) {
            Vec3 p = box_.center();
            const int u = (k + 1) % 3, v = (k + 2) % 3;
            p[u] = corner & 1 ? box_.hi[u] : box_.lo[u];
            p[v] = corner & 2 ? box_.hi[v] : box_.lo[v];
            const Vec2 at = stage_.camera.display_of(p) / stage_.ratio;
            const double out = k == 2 ? -at.x() : at.y() + 1e-3 * at.x();
            if (out <= outermost) continue;
            outermost = out;
            best = at;
        }
        // What stands farthest left begins there, or the window would cut it off.
        content.notes.push_back({best, k == 2 ? -1 : 0, text, true, true});
    }
}

bool SceneStock::has_preview() const {
    return detail_.any || cut_.actors.size() > few_patches;
}

void SceneStock::add_bounds(Box3& box) const {
    if (!stage_.on(Layer::stock) && !dimensioned()) return;
    box.add(box_);
    if (!box_.empty()) return;
    for (const auto& patch : cut_.patches)
        if (patch) box.add(patch->box);
}

void SceneStock::add_known(KnownBoxes& known) const {
    for (const Surface* surface : {&cut_, &detail_})
        for (std::size_t i = 0; i < surface->patches.size(); ++i) {
            const auto& a = surface->actors[i];
            if (!a || !a->shown()) continue;
            known.box.add(surface->patches[i]->box);
            known.actors.push_back(a->actor);
        }
}

void SceneStock::add_heavy(HeavyActors& heavy) {
    for (Surface* surface : {&cut_, &detail_})
        for (auto& a : surface->actors)
            if (a) heavy.surfaces.push_back(a.get());
}

void SceneStock::add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const {
    const Colors& colors = colors_of(stage_.palette);
    if (shown == ShownSurface::cut_stock)
        entries.push_back({LegendEntry::Sample::surface, colors.cut_stock, 1, "Stock"});
    else if ((stage_.on(Layer::stock) || dimensioned()) && lines_.filled)
        entries.push_back({LegendEntry::Sample::box, colors.stock, 1, "Stock"});
}

void SceneStock::rehearse(std::size_t k, SceneRehearsal& rehearsal) {
    if (k == 2) {
        rehearsal.unlit_triangle(faces_);
        rehearsal.segments(lines_);
    }
    if (k == 5) {
        // The look of the cut stock, which is that of the tool too.
        SceneActor patch;
        patch.actor->SetProperty(cut_look_);
        rehearsal.triangle(patch);
    }
}

} // namespace facetmill
