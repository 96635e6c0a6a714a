#include "viz/scene_steps.h"

#include "viz/poly_data.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace facetmill {

std::size_t SceneSteps::begin(const HeavyActors& heavy, SceneActor* apart) {
    step_.reset();
    groups_.clear();
    std::size_t elements = 0;
    for (const auto* actors : {&heavy.surfaces, &heavy.lines})
        for (SceneActor* a : *actors) {
            if (!a->shown()) continue;
            if (groups_.empty() || elements + a->elements() > elements_in_piece) {
                groups_.emplace_back();
                elements = 0;
            }
            groups_.back().push_back(a);
            elements += a->elements();
        }
    const bool alone = apart && apart->shown() && groups_.size() > 1;
    if (alone) groups_.insert(groups_.begin(), {apart});
    first_ = alone ? 1 : 0;
    return last_of_all() + 1;
}

void SceneSteps::set(std::size_t step) {
    step_ = std::min(step, last_of_all());
}

void SceneSteps::forget() {
    step_.reset();
    groups_.clear();
}

void SceneSteps::hide_others(vtkRenderer* renderer) const {
    if (!step_) return;
    const auto in = [](const std::vector<SceneActor*>& group, const vtkActor* actor) {
        return std::any_of(group.begin(), group.end(),
                           [&](SceneActor* a) { return a->actor.Get() == actor; });
    };
    vtkActorCollection* actors = renderer->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it)) {
        const bool heavy =
            std::any_of(groups_.begin(), groups_.end(), [&](const auto& group) { return in(group, actor); });
        if (*step_ > groups_.size() || (light() ? heavy : !in(groups_[*step_], actor)))
            actor->VisibilityOff();
    }
}

namespace {

const std::vector<float> normals{0, -1, 0, 0, -1, 0, 0, -1, 0};
const std::vector<std::int32_t> one_triangle{0, 1, 2}, two_segments{0, 1, 1, 2};
const std::vector<std::uint8_t> opaque_white(12, 255);

} // namespace

SceneRehearsal::~SceneRehearsal() = default;

void SceneRehearsal::begin(const Vec3& center, const Vec3& right, const Vec3& up) {
    end();
    running_ = true;
    center_ = center;
    points_.clear();
    for (const Vec3& corner : {Vec3(-right), right, up})
        for (Eigen::Index i = 0; i < 3; ++i)
            points_.push_back(float(corner[i]));
}

void SceneRehearsal::end() {
    running_ = false;
    for (auto& a : actors_)
        renderer_->RemoveActor(a->actor);
    actors_.clear();
}

void SceneRehearsal::add(const SceneActor& like, vtkPolyData* data) {
    actors_.push_back(std::make_unique<SceneActor>());
    SceneActor& a = *actors_.back();
    a.look_like(like);
    a.set_data(data, center_);
    renderer_->AddActor(a.actor);
}

void SceneRehearsal::triangle(const SceneActor& like) {
    add(like, triangle_data(points_, normals, one_triangle));
}

void SceneRehearsal::unlit_triangle(const SceneActor& like) {
    add(like, triangle_data(points_, {}, one_triangle));
}

void SceneRehearsal::colored_triangle(const SceneActor& like) {
    const auto data = triangle_data(points_, normals, one_triangle);
    set_point_colors({data}, opaque_white);
    add(like, data);
}

void SceneRehearsal::segments(const SceneActor& like) {
    add(like, segment_data(points_, two_segments));
}

void SceneRehearsal::dots(const SceneActor& like) {
    add(like, dot_data(points_));
}

void SceneRehearsal::show() {
    vtkActorCollection* actors = renderer_->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it))
        actor->VisibilityOff();
    for (auto& a : actors_)
        a->actor->VisibilityOn();
}

} // namespace facetmill
