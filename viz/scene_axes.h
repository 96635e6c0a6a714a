// The orientation axes in the corner of a scene, and the light that both have.
#pragma once

#include "viz/scene_layer.h"
#include "viz/tool_shape.h"

#include <array>

namespace facetmill {

/// From over the left shoulder, from the eye and from the right, in the camera's frame.
void add_lights(vtkRenderer* renderer);

/// Drawn by a renderer of their own, on top, that covers a square and turns as the scene's camera does.
class SceneAxes {
public:
    explicit SceneAxes(const SceneStage& stage);
    ~SceneAxes();

    vtkRenderer* renderer() const { return renderer_; }
    void apply_palette(const Colors& colors);
    /// Before every frame; `wanted`: this frame draws what lies on top.
    void prepare_frame(bool wanted);

private:
    const SceneStage& stage_;
    vtkSmartPointer<vtkRenderer> renderer_;
    std::array<RevolvedShape, 3> shapes_; ///< behind the actors' data
    std::array<SceneActor, 3> arrows_;
};

} // namespace facetmill
