#include "viz/scene_deviation.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <utility>

namespace facetmill {

SceneDeviation::SceneDeviation(SceneStage& stage) : SceneLayer(stage) {
    add_actor(surface_.first);
    add_actor(preview_);
    // Colours that mean something are drawn with little shade, so that they can be found in the legend.
    vtkProperty* look = surface_.first.property();
    look->SetAmbient(0.35);
    look->SetDiffuse(0.65);
    look->SetSpecular(0);
    surface_.first.mapper->ScalarVisibilityOn();
    preview_.mapper->ScalarVisibilityOn();
    preview_.actor->SetProperty(look);
}

void SceneDeviation::set(DeviationDisplayPtr deviation) {
    const DeviationDisplayPtr old = std::exchange(deviation_, std::move(deviation));
    data_.clear();
    if (!deviation_ || deviation_->triangles.empty()) {
        deviation_ = nullptr;
        surface_.set(stage_, {}, Vec3::Zero());
        preview_.clear();
        return;
    }
    const DeviationDisplay& d = *deviation_;
    data_ = triangle_pieces(d.points, d.normals, d.triangles, elements_in_piece);
    scale_ = d.scale;
    surface_.set(stage_, data_, d.center);
    preview_.set_data(triangle_data(d.preview.points, d.preview.normals, d.preview.triangles), d.center);
    rgba_ = d.colors;
    preview_rgba_ = d.preview_colors;
    color();
}

void SceneDeviation::color() {
    if (deviation_ && deviation_->shown.size() * 4 == rgba_.size()) {
        const Rgb& part = colors_of(stage_.palette).part;
        const std::array<double, 3> plain{255 * part.r, 255 * part.g, 255 * part.b};
        for (std::size_t i = 0; i < deviation_->shown.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                std::uint8_t& c = rgba_[4 * i + k];
                c = std::uint8_t(plain[k] + (double(c) - plain[k]) * double(deviation_->shown[i]) + 0.5);
            }
    }
    set_point_colors(data_, rgba_);
    if (!preview_.filled) return;
    const vtkSmartPointer<vtkPolyData> preview = preview_.mapper->GetInput();
    set_point_colors({preview}, preview_rgba_);
}

void SceneDeviation::set_scale(const DeviationScale& scale) {
    if (!deviation_ || scale == scale_) return;
    scale_ = scale;
    const DeviationSurface& s = *deviation_->surface;
    // The arrays that are shown stay until the data have the new ones.
    const auto old = std::move(rgba_), old_preview = std::move(preview_rgba_);
    rgba_ = deviation_colors(s.deviation, s.flags, scale);
    preview_rgba_ = deviation_colors(deviation_->preview_deviation, {}, scale);
    color();
}

void SceneDeviation::set_note(const std::string& note) {
    note_ = printable(note, 40);
}

bool SceneDeviation::wanted() const {
    return surface_.first.filled && stage_.on(Layer::deviation);
}

bool SceneDeviation::has(Layer layer) const {
    return layer == Layer::deviation && deviation_;
}

void SceneDeviation::apply_visibility(ShownSurface shown) {
    const bool own = shown == ShownSurface::deviation, coarse = stage_.moving && preview_.filled;
    surface_.show(own && !coarse);
    preview_.show(own && coarse);
}

bool SceneDeviation::has_preview() const {
    return preview_.filled;
}

void SceneDeviation::add_bounds(Box3& box) const {
    if (deviation_ && stage_.on(Layer::deviation)) box.add(deviation_->box);
}

void SceneDeviation::add_known(KnownBoxes& known) const {
    if (!deviation_ || !surface_.first.shown()) return;
    known.box.add(deviation_->box);
    surface_.add_to(known.actors);
}

void SceneDeviation::add_heavy(HeavyActors& heavy) {
    surface_.add_to(heavy.surfaces);
}

void SceneDeviation::add_color_bars(std::vector<ColorBar>& bars, ShownSurface shown) const {
    if (!deviation_ || shown != ShownSurface::deviation) return;
    ColorBar bar;
    bar.title = "Deviation (" + std::string(unit_name(stage_.unit)) + ")";
    bar.note = note_;
    const DeviationScale& s = scale_;
    constexpr int steps = 160;
    for (int i = 0; i < steps; ++i)
        bar.colors.push_back(deviation_color(s, s.low + (s.high - s.low) * (i + 0.5) / steps));
    bar.below = deviation_color(s, std::min(s.low, -s.gouge_limit) - 1);
    bar.above = deviation_color(s, std::max(s.high, s.tolerance) + 1);
    bar.has_below = deviation_->lowest < s.low;
    bar.has_above = deviation_->highest > s.high;
    for (const ScaleMark& m : scale_marks(s, stage_.unit, 0.12))
        bar.marks.emplace_back((m.value - s.low) / (s.high - s.low), m.label);
    bar.low_text = "gouge";
    bar.high_text = "excess";
    if (deviation_->has_unjudged) bar.other = {unjudged_color(), "not judged"};
    bars.push_back(std::move(bar));
}

void SceneDeviation::rehearse(std::size_t k, SceneRehearsal& rehearsal) {
    if (k == 4) rehearsal.colored_triangle(surface_.first);
}

} // namespace facetmill
