#include "viz/scene_former.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <utility>

namespace facetmill {

SceneFormer::SceneFormer(SceneStage& stage) : SceneLayer(stage) {
    for (SceneActor* a : {&faces_.first, &lines_}) {
        add_actor(*a);
        a->unlit();
    }
    // All faces have the same colour and no light, so that they blend alike in any order.
    faces_.first.property()->SetOpacity(0.22);
    // Where nothing has changed the part that is there now lies before it.
    faces_.first.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(4, 6);
    lines_.nearer(20);
}

void SceneFormer::set(PartDisplayPtr part) {
    if (part == part_) return;
    // The arrays stay until the actors have others.
    const PartDisplayPtr old = std::exchange(part_, std::move(part));
    faces_.set(stage_, {}, Vec3::Zero());
    lines_.clear();
    if (!part_ || part_->triangles.empty()) return;
    faces_.set(stage_, triangle_pieces(part_->points, {}, part_->triangles, elements_in_piece),
               part_->center);
    lines_.set_data(segment_data(part_->points, part_->lines), part_->center);
}

void SceneFormer::apply_palette(const Colors& colors) {
    faces_.first.color(colors.former_part);
    lines_.color(colors.former_part);
}

void SceneFormer::apply_line_widths() {
    lines_.set_line_width(1.4 * stage_.line_ratio());
}

void SceneFormer::apply_visibility(ShownSurface) {
    const bool on = stage_.on(Layer::part);
    faces_.show(on && !(stage_.moving && has_preview()));
    lines_.show(on);
}

/// The coarse copy of a large one would stand out of the part where nothing has changed: its lines are drawn
/// alone while the view moves.
bool SceneFormer::has_preview() const {
    return part_ && !part_->preview.triangles.empty();
}

void SceneFormer::add_known(KnownBoxes& known) const {
    if (!part_ || !lines_.shown()) return;
    known.box.add(part_->box);
    faces_.add_to(known.actors);
    known.actors.push_back(lines_.actor);
}

void SceneFormer::add_heavy(HeavyActors& heavy) {
    faces_.add_to(heavy.surfaces);
}

void SceneFormer::add_legend(std::vector<LegendEntry>& entries, ShownSurface) const {
    if (any() && stage_.on(Layer::part))
        entries.push_back(
            {LegendEntry::Sample::surface, colors_of(stage_.palette).former_part, 1, "Part before"});
}

} // namespace facetmill
