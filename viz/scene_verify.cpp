// What the verification adds to a scene: the cut stock, the colours of the deviations, the findings.
#include "viz/poly_data.h"
#include "viz/scene_impl.h"

#include <vtkPointData.h>

#include <algorithm>
#include <utility>

namespace facetmill {

namespace {

/// The patch's own arrays, without a copy: whoever has the data keeps the patch.
vtkSmartPointer<vtkPolyData> patch_data(const StockPatch& patch) {
    static_assert(sizeof(std::array<float, 3>) == 3 * sizeof(float)
                  && sizeof(std::array<std::uint32_t, 3>) == 3 * sizeof(std::int32_t));
    return triangle_data(patch.points.front().data(), patch.normals.front().data(), patch.points.size(),
                         reinterpret_cast<const std::int32_t*>(patch.triangles.front().data()),
                         patch.triangles.size());
}

} // namespace

std::vector<FindingMark> finding_marks(const Verification& verification) {
    constexpr std::size_t max_collisions = 400; // more of them say no more
    using Kind = FindingMark::Kind;
    std::vector<FindingMark> marks;
    for (const DeviationExtreme& e : verification.gouges)
        marks.push_back({Kind::gouge, e.point});
    for (const DeviationExtreme& e : verification.excess)
        marks.push_back({Kind::excess, e.point});
    const std::size_t n = verification.collisions.size(), stride = n / max_collisions + 1;
    for (std::size_t i = 0; i < n; i += stride)
        marks.push_back({Kind::collision, verification.collisions[i].place});
    return marks;
}

bool Scene::Impl::shows_cut_stock() const {
    return has_cut && layer_on[std::size_t(Layer::stock)];
}

bool Scene::Impl::shows_deviation() const {
    return deviation_surface.filled && layer_on[std::size_t(Layer::deviation)] && !shows_cut_stock();
}

bool Scene::Impl::swap_patches(const StockPatches& patches, const StockPatches& old,
                               std::vector<std::unique_ptr<SceneActor>>& actors) {
    forget_steps();
    for (std::size_t i = patches.size(); i < actors.size(); ++i)
        if (actors[i]) renderer->RemoveActor(actors[i]->actor);
    actors.resize(patches.size());
    bool any = false;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto& patch = patches[i];
        const bool drawn = patch && !patch->triangles.empty();
        any |= drawn;
        if (i < old.size() && old[i] == patch && bool(actors[i]) == drawn) continue;
        if (!drawn) {
            if (actors[i]) renderer->RemoveActor(actors[i]->actor);
            actors[i] = nullptr;
            continue;
        }
        if (!actors[i]) {
            actors[i] = std::make_unique<SceneActor>();
            actors[i]->actor->SetProperty(cut_look);
            renderer->AddActor(actors[i]->actor);
        }
        actors[i]->set_data(patch_data(*patch), Vec3::Zero());
    }
    return any;
}

void Scene::set_cut_stock(const StockPatches& patches, const StockPatches& detail) {
    // The arrays stay until the actors have others.
    const StockPatches old = std::exchange(impl_->cut_stock, patches),
                       old_detail = std::exchange(impl_->cut_detail, detail);
    impl_->has_cut = impl_->swap_patches(patches, old, impl_->cut_patches);
    impl_->has_detail = impl_->swap_patches(detail, old_detail, impl_->detail_patches);
    impl_->apply_visibility();
}

void Scene::set_deviation(DeviationDisplayPtr deviation) {
    const DeviationDisplayPtr old = std::move(impl_->deviation);
    impl_->deviation = std::move(deviation);
    const DeviationDisplayPtr& d = impl_->deviation;
    impl_->deviation_data.clear();
    if (!d || d->triangles.empty()) {
        impl_->deviation = nullptr;
        impl_->set_pieces(impl_->deviation_surface, impl_->more_deviation, {}, Vec3::Zero());
        impl_->deviation_preview.clear();
    } else {
        impl_->deviation_data = triangle_pieces(d->points, d->normals, d->triangles, elements_in_piece);
        impl_->deviation_scale = d->scale;
        impl_->set_pieces(impl_->deviation_surface, impl_->more_deviation, impl_->deviation_data, d->center);
        const PartPreview& preview = d->preview;
        impl_->deviation_preview.set_data(triangle_data(preview.points, preview.normals, preview.triangles),
                                          d->center);
        impl_->deviation_rgba = d->colors;
        impl_->deviation_preview_rgba = d->preview_colors;
        impl_->color_deviation();
    }
    impl_->apply_visibility();
}

void Scene::Impl::color_deviation() {
    set_point_colors(deviation_data, deviation_rgba);
    if (deviation_preview.filled) {
        const vtkSmartPointer<vtkPolyData> preview = deviation_preview.mapper->GetInput();
        set_point_colors({preview}, deviation_preview_rgba);
    }
}

void Scene::set_deviation_scale(const DeviationScale& scale) {
    if (!impl_->deviation || scale == impl_->deviation_scale) return;
    impl_->deviation_scale = scale;
    const DeviationSurface& s = *impl_->deviation->surface;
    // The arrays that are shown stay until the data have the new ones.
    const auto old = std::move(impl_->deviation_rgba), old_preview = std::move(impl_->deviation_preview_rgba);
    impl_->deviation_rgba = deviation_colors(s.deviation, s.flags, scale);
    impl_->deviation_preview_rgba = deviation_colors(impl_->deviation->preview_deviation, {}, scale);
    impl_->color_deviation();
}

const DeviationScale& Scene::deviation_scale() const {
    return impl_->deviation_scale;
}

void Scene::set_deviation_note(const std::string& note) {
    impl_->deviation_note = printable(note, 40);
}

void Scene::set_findings(const std::vector<FindingMark>& findings) {
    impl_->findings = findings;
    const auto old = std::exchange(impl_->finding_points, {});
    for (const FindingMark& f : findings)
        for (Eigen::Index k = 0; k < 3; ++k)
            impl_->finding_points[std::size_t(f.kind)].push_back(float(f.point[k]));
    for (std::size_t k = 0; k < finding_kinds; ++k)
        impl_->finding_dots[k].set_data(dot_data(impl_->finding_points[k]), Vec3::Zero());
    impl_->apply_visibility();
}

std::vector<ColorBar> Scene::Impl::color_bars() const {
    std::vector<ColorBar> bars;
    const auto tinted = [&](std::size_t k) {
        return layer_on[std::size_t(Layer::cl)] && motion_on[k] && tint_lines[k].filled;
    };
    for (std::size_t k = 0; k < motion_kinds && bars.empty(); ++k)
        if (tinted(k)) bars.push_back(tint->bar());
    if (!deviation || !shows_deviation()) return bars;
    ColorBar bar;
    bar.title = "Deviation (" + std::string(unit_name(unit)) + ")";
    bar.note = deviation_note;
    const DeviationScale& s = deviation_scale;
    constexpr int steps = 160;
    for (int i = 0; i < steps; ++i)
        bar.colors.push_back(deviation_color(s, s.low + (s.high - s.low) * (i + 0.5) / steps));
    bar.below = deviation_color(s, std::min(s.low, -s.gouge_limit) - 1);
    bar.above = deviation_color(s, std::max(s.high, s.tolerance) + 1);
    bar.has_below = deviation->lowest < s.low;
    bar.has_above = deviation->highest > s.high;
    for (const ScaleMark& m : scale_marks(s, unit, 0.12))
        bar.marks.emplace_back((m.value - s.low) / (s.high - s.low), m.label);
    bar.low_text = "gouge";
    bar.high_text = "excess";
    if (deviation->has_unjudged) bar.other = {unjudged_color(), "not judged"};
    bars.push_back(std::move(bar));
    return bars;
}

CameraPlace Scene::camera_place() const {
    vtkCamera* camera = impl_->renderer->GetActiveCamera();
    const Mat3 frame = impl_->camera_frame();
    return {Vec3(camera->GetFocalPoint()), frame.row(2).transpose(), frame.row(1).transpose(),
            2 * camera->GetParallelScale()};
}

void Scene::look_at(const CameraPlace& place) {
    vtkCamera* camera = impl_->renderer->GetActiveCamera();
    const double distance = std::max(camera->GetDistance(), 1e-3);
    const Vec3 eye = place.target + distance * place.toward_eye;
    camera->SetFocalPoint(place.target.x(), place.target.y(), place.target.z());
    camera->SetPosition(eye.x(), eye.y(), eye.z());
    camera->SetViewUp(place.up.x(), place.up.y(), place.up.z());
    camera->SetParallelScale(place.height / 2);
}

CameraPlace Scene::place_to_see(const Vec3& point, const Vec3& normal, double height) const {
    CameraPlace place = camera_place();
    place.target = point;
    place.height = std::min(place.height, height);
    constexpr double seen = 0.35; // cosine of the slant under which one still sees what is there
    if (normal.norm() < 0.5 || normal.dot(place.toward_eye) >= seen) return place;
    // From the four corners above and below, the one that the surface faces most; ties go to the front.
    double best = -2;
    for (const double z : {0.9, -0.9})
        for (const auto& [x, y] : {std::pair(1.0, -1.0), {-1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
            const Vec3 eye = Vec3(x, y, z).normalized();
            if (normal.dot(eye) <= best + 1e-9) continue;
            best = normal.dot(eye);
            place.toward_eye = eye;
        }
    const Vec3 right = Vec3::UnitZ().cross(place.toward_eye).normalized();
    place.up = place.toward_eye.cross(right);
    return place;
}

} // namespace facetmill
