#include "viz/scene_layer.h"

#include "viz/scene_renderer.h"

#include <vtkActor.h>
#include <vtkRenderer.h>

namespace facetmill {

SceneStage::SceneStage() : renderer(vtkSmartPointer<SceneRenderer>::New()), camera(renderer) {
    layers_on.assign(all_layers().size(), true);
    layers_on[std::size_t(Layer::edges)] = false;
}

SceneStage::~SceneStage() = default;

void SceneLayer::add_actor(SceneActor& actor) {
    stage_.renderer->AddActor(actor.actor);
}

} // namespace facetmill
