#include "viz/scene_axes.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace facetmill {

namespace {

void add_light(vtkRenderer* renderer, double x, double y, double z, double intensity) {
    vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToCameraLight(); // in the camera's frame: x right, y up, z towards the eye
    lamp->SetPosition(x, y, z);
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetIntensity(intensity);
    lamp->SetSwitch(1);
    renderer->AddLight(lamp);
}

} // namespace

void add_lights(vtkRenderer* renderer) {
    renderer->AutomaticLightCreationOff();
    add_light(renderer, -0.6, 0.6, 1.0, 0.66); // key, over the left shoulder
    add_light(renderer, 0.0, 0.0, 1.0, 0.38);  // from the eye
    add_light(renderer, 0.9, -0.3, 0.5, 0.24); // fill from the right
}

SceneAxes::SceneAxes(const SceneStage& stage)
    : stage_(stage), renderer_(vtkSmartPointer<vtkRenderer>::New()) {
    renderer_->SetLayer(1);
    renderer_->InteractiveOff();
    renderer_->UseFXAAOff();
    add_lights(renderer_);
    renderer_->GetActiveCamera()->ParallelProjectionOn();
    // An arrow along Z, turned.
    for (std::size_t k = 0; k < 3; ++k) {
        shapes_[k] = make_arrow(0.055, 0.13, 0.30, 1.0);
        arrows_[k].set_data(triangle_data(shapes_[k].points, shapes_[k].normals, shapes_[k].triangles),
                            Vec3::Zero());
        arrows_[k].actor->VisibilityOn();
        arrows_[k].property()->SetAmbient(0.15);
        renderer_->AddActor(arrows_[k].actor);
    }
    arrows_[0].actor->RotateY(90);
    arrows_[1].actor->RotateX(-90);
}

SceneAxes::~SceneAxes() = default;

void SceneAxes::apply_palette(const Colors& colors) {
    for (std::size_t k = 0; k < 3; ++k)
        arrows_[k].color(colors.axes[k]);
}

void SceneAxes::prepare_frame(bool wanted) {
    const Eigen::Vector2i size = stage_.camera.window_size();
    const double ratio = stage_.ratio;
    const double covered = stage_.covered_below * ratio;
    const double side = axes_side(size.x() / ratio, (size.y() - covered) / ratio) * ratio, off = 6 * ratio,
                 below = covered + off;
    const bool on = wanted && stage_.on(Layer::axes) && side > 0;
    renderer_->SetDraw(on);
    if (!on) return;
    renderer_->SetViewport(off / size.x(), below / size.y(), (off + side) / size.x(),
                           (below + side) / size.y());
    vtkCamera* camera = renderer_->GetActiveCamera();
    const Vec3 toward = stage_.camera.toward_eye();
    camera->SetFocalPoint(0, 0, 0);
    camera->SetPosition(10 * toward.x(), 10 * toward.y(), 10 * toward.z());
    camera->SetViewUp(stage_.camera.vtk()->GetViewUp());
    camera->SetParallelScale(1.5);
    camera->SetClippingRange(1, 20);
}

} // namespace facetmill
