#include "viz/scene_tool.h"

#include "core/base/turn.h"
#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkProperty.h>

#include <cmath>
#include <utility>

namespace facetmill {

SceneTool::SceneTool(SceneStage& stage) : SceneLayer(stage) {
    for (std::size_t k = 0; k < 3; ++k) {
        add_actor(bodies_[k]);
        add_actor(rings_[k]);
        bodies_[k].property()->SetAmbient(0.08);
        bodies_[k].property()->SetSpecular(0.35);
        bodies_[k].property()->SetSpecularPower(40);
        rings_[k].unlit();
        rings_[k].nearer(20);
    }
}

void SceneTool::set(const std::optional<Tool>& tool) {
    std::optional<ToolShape> shape;
    if (tool) shape = make_tool_shape(*tool);
    const auto old = std::exchange(shape_, std::move(shape)); // its arrays stay until there are others
    for (std::size_t k = 0; k < 3; ++k) {
        bodies_[k].clear();
        rings_[k].clear();
        if (!shape_) continue;
        const RevolvedShape& s = k == 0 ? shape_->cutter : k == 1 ? shape_->shank : shape_->holder;
        bodies_[k].set_data(triangle_data(s.points, s.normals, s.triangles), Vec3::Zero());
        rings_[k].set_data(segment_data(s.points, s.rings), Vec3::Zero());
    }
}

void SceneTool::set_pose(const std::optional<CutterLocation>& pose) {
    pose_ = pose;
    if (!pose) return;
    const Mat3 r = turn_between(Vec3(0, 0, 1), pose->axis).toRotationMatrix();
    vtkNew<vtkMatrix4x4> m;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            m->SetElement(i, j, r(i, j));
        m->SetElement(i, 3, pose->tip[i]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        bodies_[k].actor->SetUserMatrix(m);
        rings_[k].actor->SetUserMatrix(m);
    }
}

Box3 SceneTool::bounds() const {
    Box3 b;
    if (!shape_ || !pose_ || !stage_.on(Layer::tool)) return b;
    // A cylinder around the axis from tip to top.
    const Vec3 top = pose_->tip + shape_->length * pose_->axis;
    for (int k = 0; k < 3; ++k) {
        const double side = shape_->radius * std::sqrt(std::max(0.0, 1.0 - pose_->axis[k] * pose_->axis[k]));
        b.lo[k] = std::min(pose_->tip[k], top[k]) - side;
        b.hi[k] = std::max(pose_->tip[k], top[k]) + side;
    }
    return b;
}

bool SceneTool::has(Layer layer) const {
    return layer == Layer::tool && shape_ && pose_;
}

void SceneTool::apply_palette(const Colors& colors) {
    const std::array<Rgb, 3> bodies{colors.cutter, colors.shank, colors.holder};
    for (std::size_t k = 0; k < 3; ++k) {
        bodies_[k].color(bodies[k]);
        rings_[k].color(colors.feature_edges);
    }
}

void SceneTool::apply_line_widths() {
    for (auto& a : rings_)
        a.set_line_width(1.0 * stage_.line_ratio());
}

void SceneTool::apply_visibility(ShownSurface) {
    for (auto* actors : {&bodies_, &rings_})
        for (auto& a : *actors)
            a.show(stage_.on(Layer::tool) && pose_.has_value());
}

bool SceneMarks::has(Layer layer) const {
    return layer == Layer::marker && (marker_.has_value() || !touches_.empty());
}

void SceneMarks::add_legend(std::vector<LegendEntry>& entries, ShownSurface) const {
    if (stage_.on(Layer::marker) && !touches_.empty())
        entries.push_back(
            {LegendEntry::Sample::spot, colors_of(stage_.palette).contacts, 1, "Touches of the tool"});
}

void SceneMarks::add_to(OverlayContent& content) const {
    if (!stage_.on(Layer::marker)) return;
    const SceneCamera& camera = stage_.camera;
    for (const Vec3& p : touches_)
        content.spots.push_back(
            {Vec2(camera.display_of(p) / stage_.ratio), colors_of(stage_.palette).contacts});
    if (!marker_) return;
    content.marker = Vec2(camera.display_of(marker_->point) / stage_.ratio);
    const Vec3 n = camera.frame() * marker_->normal;
    content.marker_normal = Vec2(n.x(), -n.y());
}

} // namespace facetmill
