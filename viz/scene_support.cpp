#include "viz/scene_support.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace facetmill {

SceneSupport::SceneSupport(SceneStage& stage) : SceneLayer(stage) {
    for (SceneActor* a : {&face_, &lines_}) {
        add_actor(*a);
        a->unlit();
    }
    face_.property()->SetOpacity(0.55);
    face_.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -34); // it lies in the part's own
    lines_.nearer(42);
}

void SceneSupport::set(const std::vector<Vec3>& outline) {
    if (outline == outline_) return;
    face_.clear();
    lines_.clear();
    outline_ = outline;
    points_.clear();
    triangles_.clear();
    segments_.clear();
    if (outline.size() < 3) return;
    const Vec3& center = outline.front();
    const auto n = std::int32_t(outline.size());
    for (const Vec3& p : outline)
        for (int k = 0; k < 3; ++k)
            points_.push_back(float(p[k] - center[k]));
    for (std::int32_t i = 0; i < n; ++i) {
        segments_.insert(segments_.end(), {i, (i + 1) % n});
        if (i >= 2) triangles_.insert(triangles_.end(), {0, i - 1, i});
    }
    face_.set_data(triangle_data(points_, {}, triangles_), center);
    lines_.set_data(segment_data(points_, segments_), center);
}

void SceneSupport::apply_palette(const Colors& colors) {
    face_.color(colors.marker);
    lines_.color(colors.marker);
}

void SceneSupport::apply_line_widths() {
    lines_.set_line_width(2.4 * stage_.line_ratio());
}

void SceneSupport::apply_visibility(ShownSurface) {
    face_.show(true);
    lines_.show(true);
}

void SceneSupport::add_legend(std::vector<LegendEntry>& entries, ShownSurface) const {
    if (lines_.filled)
        entries.push_back(
            {LegendEntry::Sample::surface, colors_of(stage_.palette).marker, 1, "Lies on the table"});
}

} // namespace facetmill
