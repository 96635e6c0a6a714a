#include "viz/scene_actor.h"

#include "viz/palette.h"
#include "viz/scene_layer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace facetmill {

SceneActor::SceneActor()
    : actor(vtkSmartPointer<vtkActor>::New()), mapper(vtkSmartPointer<vtkPolyDataMapper>::New()) {
    mapper->ScalarVisibilityOff();
    mapper->StaticOn(); // the data never change in place
    actor->SetMapper(mapper);
    actor->VisibilityOff();
}

SceneActor::~SceneActor() = default;

void SceneActor::set_data(vtkPolyData* data, const Vec3& center) {
    mapper->SetInputData(data);
    actor->SetPosition(center.x(), center.y(), center.z());
    filled = data->GetNumberOfCells() > 0;
}

void SceneActor::clear() {
    mapper->SetInputData(vtkSmartPointer<vtkPolyData>::New());
    filled = false;
}

void SceneActor::set_pose(const Mat3& turn, const Vec3& move) {
    vtkNew<vtkMatrix4x4> pose;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k)
            pose->SetElement(i, k, turn(i, k));
        pose->SetElement(i, 3, move[i]);
    }
    actor->SetUserMatrix(pose);
}

void SceneActor::show(bool wanted) {
    actor->SetVisibility(wanted && filled);
}

bool SceneActor::shown() const {
    return actor->GetVisibility() != 0;
}

vtkProperty* SceneActor::property() const {
    return actor->GetProperty();
}

void SceneActor::color(const Rgb& color) {
    property()->SetColor(color.r, color.g, color.b);
}

void SceneActor::unlit() {
    property()->LightingOff();
}

void SceneActor::set_line_width(double pixels) {
    property()->SetLineWidth(float(pixels));
}

void SceneActor::set_point_size(double pixels) {
    property()->SetPointSize(float(pixels));
}

void SceneActor::nearer(double by) {
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -by);
    mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-by);
}

void SceneActor::look_like(const SceneActor& other) {
    actor->SetProperty(other.actor->GetProperty());
    actor->SetBackfaceProperty(other.actor->GetBackfaceProperty());
    mapper->SetScalarVisibility(other.mapper->GetScalarVisibility());
    double factor = 0, units = 0;
    other.mapper->GetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
    other.mapper->GetRelativeCoincidentTopologyLineOffsetParameters(factor, units);
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(factor, units);
    other.mapper->GetRelativeCoincidentTopologyPointOffsetParameter(units);
    mapper->SetRelativeCoincidentTopologyPointOffsetParameter(units);
}

std::size_t SceneActor::elements() const {
    vtkPolyData* data = mapper->GetInput();
    const vtkIdType lines = data->GetLines()->GetNumberOfConnectivityIds() - data->GetNumberOfLines();
    return std::size_t(data->GetNumberOfPolys() + lines + data->GetNumberOfVerts());
}

void ScenePieces::set(SceneStage& stage, const std::vector<vtkSmartPointer<vtkPolyData>>& pieces,
                      const Vec3& center) {
    stage.steps.forget();
    // Actors are used again: making and destroying them costs more than all else here, and an old one has its
    // shader.
    const std::size_t wanted = pieces.empty() ? 0 : pieces.size() - 1;
    while (more_.size() > wanted) {
        stage.renderer->RemoveActor(more_.back()->actor);
        more_.pop_back();
    }
    if (pieces.empty()) {
        first.clear();
        return;
    }
    first.set_data(pieces.front(), center);
    while (more_.size() < wanted) {
        more_.push_back(std::make_unique<SceneActor>());
        stage.renderer->AddActor(more_.back()->actor);
    }
    for (std::size_t i = 0; i < wanted; ++i) {
        more_[i]->look_like(first);
        more_[i]->set_data(pieces[i + 1], center);
    }
}

void ScenePieces::show(bool wanted) {
    first.show(wanted);
    for (auto& piece : more_)
        piece->show(wanted);
}

void ScenePieces::add_to(std::vector<SceneActor*>& all) {
    all.push_back(&first);
    for (auto& piece : more_)
        all.push_back(piece.get());
}

void ScenePieces::add_to(std::vector<vtkActor*>& all) const {
    all.push_back(first.actor);
    for (const auto& piece : more_)
        all.push_back(piece->actor);
}

} // namespace facetmill
