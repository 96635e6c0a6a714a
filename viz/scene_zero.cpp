#include "viz/scene_zero.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"

namespace facetmill {

SceneZero::SceneZero(SceneStage& stage) : SceneLayer(stage) {
    for (SceneActor& a : axes_) {
        add_actor(a);
        a.unlit();
        a.nearer(44);
    }
}

void SceneZero::set(const std::optional<ZeroMark>& mark) {
    if (mark == mark_) return;
    mark_ = mark;
    for (std::size_t k = 0; k < 3; ++k) {
        axes_[k].clear();
        if (!mark) continue;
        points_[k].assign(6, 0.0f);
        points_[k][3 + k] = float(mark->length);
        axes_[k].set_data(segment_data(points_[k], segments_), mark->point);
    }
}

void SceneZero::add_to(OverlayContent& content) const {
    if (!mark_) return;
    const SceneCamera& camera = stage_.camera;
    const auto pixel = [&](const Vec3& p) { return Vec2(camera.display_of(p) / stage_.ratio); };
    content.spots.push_back({pixel(mark_->point), colors_of(stage_.palette).marker});
    constexpr double aside = 12;
    content.notes.push_back({pixel(mark_->point) + Vec2(aside, aside), -1, mark_->name, true, true});
    const char* const names[] = {"X", "Y", "Z"};
    for (int k = 0; k < 3; ++k)
        content.notes.push_back(
            {pixel(mark_->point + 1.12 * mark_->length * Vec3::Unit(k)), 0, names[k], true, false});
}

void SceneZero::apply_palette(const Colors& colors) {
    for (std::size_t k = 0; k < 3; ++k)
        axes_[k].color(colors.axes[k]);
}

void SceneZero::apply_line_widths() {
    for (SceneActor& a : axes_)
        a.set_line_width(3 * stage_.line_ratio());
}

void SceneZero::apply_visibility(ShownSurface) {
    for (SceneActor& a : axes_)
        a.show(true);
}

} // namespace facetmill
