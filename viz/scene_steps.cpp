// A picture in steps: large things piece by piece, then everything else, then smoothing and what is flat on
// top. And the rehearsal of a first picture.
#include "viz/poly_data.h"
#include "viz/scene_impl.h"

#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <utility>

namespace facetmill {

void SceneActor::look_like(SceneActor& other) {
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

void Scene::Impl::set_pieces(SceneActor& first, std::vector<std::unique_ptr<SceneActor>>& more,
                             const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, const Vec3& center) {
    forget_steps();
    for (auto& piece : more)
        renderer->RemoveActor(piece->actor);
    more.clear();
    if (pieces.empty()) {
        first.clear();
        return;
    }
    first.set_data(pieces.front(), center);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        auto piece = std::make_unique<SceneActor>();
        piece->look_like(first);
        piece->set_data(pieces[i], center);
        renderer->AddActor(piece->actor);
        more.push_back(std::move(piece));
    }
}

std::vector<std::vector<SceneActor*>> Scene::Impl::heavy_groups() {
    std::vector<SceneActor*> heavy{&part_surface};
    for (auto& piece : more_surface)
        heavy.push_back(piece.get());
    heavy.push_back(&deviation_surface);
    for (auto& piece : more_deviation)
        heavy.push_back(piece.get());
    for (auto* patches : {&cut_patches, &detail_patches})
        for (auto& patch : *patches)
            if (patch) heavy.push_back(patch.get());
    heavy.push_back(&part_lines);
    heavy.push_back(&part_edges);
    for (auto& piece : more_edges)
        heavy.push_back(piece.get());
    heavy.push_back(&contact_lines);
    heavy.push_back(&contact_dots);
    for (auto* lines : {&motion_lines, &tint_lines})
        for (auto& a : *lines)
            heavy.push_back(&a);
    std::vector<std::vector<SceneActor*>> groups;
    std::size_t elements = 0;
    for (SceneActor* a : heavy) {
        if (!a->actor->GetVisibility()) continue;
        if (groups.empty() || elements + a->elements() > elements_in_piece) {
            groups.emplace_back();
            elements = 0;
        }
        groups.back().push_back(a);
        elements += a->elements();
    }
    return groups;
}

void Scene::Impl::show_step() {
    const auto in = [](const std::vector<SceneActor*>& group, const vtkActor* actor) {
        return std::any_of(group.begin(), group.end(),
                           [&](SceneActor* a) { return a->actor.Get() == actor; });
    };
    vtkActorCollection* actors = renderer->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it)) {
        const bool heavy = std::any_of(step_groups.begin(), step_groups.end(),
                                       [&](const auto& group) { return in(group, actor); });
        if (*step > step_groups.size() || (light_step() ? heavy : !in(step_groups[*step], actor)))
            actor->VisibilityOff();
    }
}

std::size_t Scene::begin_steps() {
    impl_->step.reset();
    impl_->apply_visibility();
    impl_->set_clipping_range();
    impl_->step_groups = impl_->heavy_groups();
    // The points of a large part take as long as several steps to get to the graphics card, and their normals
    // too: the lines bring the one, the first piece of the surface the other.
    const bool apart = std::exchange(impl_->part_is_new, false) && impl_->part_lines.actor->GetVisibility()
                       && impl_->step_groups.size() > 1;
    if (apart) impl_->step_groups.insert(impl_->step_groups.begin(), {&impl_->part_lines});
    impl_->first_step = apart ? 1 : 0;
    return impl_->last_step_of_all() + 1;
}

void Scene::set_step(std::size_t step) {
    impl_->step = std::min(step, impl_->last_step_of_all());
    impl_->apply_visibility();
}

void Scene::Impl::forget_steps() {
    step.reset();
    step_groups.clear();
}

void Scene::end_steps() {
    impl_->forget_steps();
    impl_->apply_visibility();
}

void Scene::rehearse(std::size_t k) {
    static const std::vector<float> normals{0, -1, 0, 0, -1, 0, 0, -1, 0};
    static const std::vector<std::int32_t> triangle{0, 1, 2}, segments{0, 1, 1, 2};
    static const std::vector<std::uint8_t> colors(12, 255);
    end_rehearsal();
    Impl& s = *impl_;
    s.rehearsing = true;
    s.all_overlay = k == 3;
    // In the middle of the view, wherever that is: what is out of sight VTK does not draw.
    const CameraPlace place = camera_place();
    const Vec3 right = 0.2 * place.height * place.up.cross(place.toward_eye),
               up = 0.2 * place.height * place.up;
    s.rehearsal_points.clear();
    for (const Vec3& corner : {Vec3(-right), right, up})
        for (Eigen::Index i = 0; i < 3; ++i)
            s.rehearsal_points.push_back(float(corner[i]));
    const auto show = [&](SceneActor& like, vtkPolyData* data) {
        s.rehearsal.push_back(std::make_unique<SceneActor>());
        SceneActor& a = *s.rehearsal.back();
        a.look_like(like);
        a.set_data(data, place.target);
        s.renderer->AddActor(a.actor);
    };
    const auto& points = s.rehearsal_points;
    if (k == 0) {
        show(s.part_surface, triangle_data(points, normals, triangle));
    } else if (k == 1) {
        show(s.part_lines, segment_data(points, segments));
    } else if (k == 2) {
        show(s.stock_faces, triangle_data(points, {}, triangle));
        show(s.stock_lines, segment_data(points, segments));
    } else if (k == 4) {
        const auto data = triangle_data(points, normals, triangle);
        set_point_colors({data}, colors);
        show(s.deviation_surface, data);
    } else if (k == 5) {
        // The look of the cut stock, which is that of the tool too.
        SceneActor patch;
        patch.actor->SetProperty(s.cut_look);
        show(patch, triangle_data(points, normals, triangle));
    } else if (k == 6) {
        show(s.finding_dots.front(), dot_data(points));
    }
    s.apply_visibility();
}

void Scene::end_rehearsal() {
    impl_->rehearsing = impl_->all_overlay = false;
    for (auto& a : impl_->rehearsal)
        impl_->renderer->RemoveActor(a->actor);
    impl_->rehearsal.clear();
    impl_->apply_visibility();
}

void Scene::Impl::show_rehearsal() {
    vtkActorCollection* actors = renderer->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it))
        actor->VisibilityOff();
    for (auto& a : rehearsal)
        a->actor->VisibilityOn();
}

} // namespace facetmill
