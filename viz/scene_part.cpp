#include "viz/scene_part.h"

#include "core/base/parallel.h"
#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <vtkActor.h>
#include <vtkProperty.h>

#include <utility>

namespace facetmill {

ScenePart::ScenePart(SceneStage& stage) : SceneLayer(stage) {
    for (SceneActor* a : {&surface_.first, &preview_, &lines_, &edges_.first})
        add_actor(*a);
    lines_.unlit();
    edges_.first.unlit();
    edges_.first.nearer(32);
    lines_.nearer(36);
    vtkProperty* look = surface_.first.property();
    look->SetAmbient(0.10);
    look->SetDiffuse(0.90);
    look->SetSpecular(0.12);
    look->SetSpecularPower(24);
    surface_.first.actor->SetBackfaceProperty(vtkSmartPointer<vtkProperty>::New());
    preview_.actor->SetProperty(look);
    preview_.actor->SetBackfaceProperty(surface_.first.actor->GetBackfaceProperty());
}

void ScenePart::set(PartDisplayPtr part) {
    // The old arrays stay until the actors have the new ones.
    const PartDisplayPtr old = std::exchange(part_, std::move(part));
    is_new_ = true;
    if (turn_ != Mat3::Identity() || move_ != Vec3::Zero()) set_pose(Mat3::Identity(), Vec3::Zero());
    if (!part_ || part_->triangles.empty()) {
        part_ = nullptr;
        surface_.set(stage_, {}, Vec3::Zero());
        edges_.set(stage_, {}, Vec3::Zero());
        lines_.clear();
        preview_.clear();
        return;
    }
    const PartDisplay& p = *part_;
    const auto surface = triangle_pieces(p.points, p.normals, p.triangles, elements_in_piece);
    vtkPolyData* like = surface.front();
    surface_.set(stage_, surface, p.center);
    edges_.set(stage_, segment_pieces(like, p.edges, elements_in_piece), p.center);
    lines_.set_data(segment_pieces(like, p.lines, p.lines.size()).front(), p.center);
    preview_.set_data(triangle_data(p.preview.points, p.preview.normals, p.preview.triangles), p.center);
}

void ScenePart::set(MeshPtr mesh) {
    set(mesh ? prepare_part_display(std::move(mesh), {}) : PartDisplayPtr());
}

void ScenePart::set_pose(const Mat3& turn, const Vec3& move) {
    turn_ = turn;
    move_ = move;
    std::vector<SceneActor*> actors{&lines_, &preview_};
    surface_.add_to(actors);
    edges_.add_to(actors);
    for (SceneActor* a : actors)
        a->set_pose(turn, move);
}

Box3 ScenePart::posed_box() const {
    if (turn_ == Mat3::Identity() && move_ == Vec3::Zero()) return part_->box;
    const Vec3 half = turn_.cwiseAbs() * (0.5 * part_->box.size()),
               middle = turn_ * part_->box.center() + move_;
    Box3 box;
    box.add(middle - half);
    box.add(middle + half);
    return box;
}

void ScenePart::set_style(PartStyle style) {
    style_ = style;
    apply_palette(colors_of(stage_.palette));
}

std::optional<PartPick> ScenePart::pick(double x, double y) const {
    const SceneCamera& camera = stage_.camera;
    if (!part_ || camera.pixel_size() <= 0) return std::nullopt;
    const Mesh& mesh = *part_->mesh;
    const SightLine line = camera.sight_at(x, y);
    const Vec3& direction = line.direction;
    // Start before everything: in parallel projection the eye's own place means nothing.
    const Vec3 origin = line.start(2 * part_->box.diagonal() + (part_->box.center() - line.at).norm());
    const SightHit hit = part_->sights.first(mesh, origin, direction, 0);
    if (!hit.found()) return std::nullopt;
    PartPick pick;
    pick.point = origin + hit.distance * direction;
    pick.normal = mesh.facet_normal(hit.facet);
    pick.facet = hit.facet;
    pick.back_side = pick.normal.dot(direction) > 0;
    return pick;
}

bool ScenePart::hides(const Vec3& place) const {
    if (!part_) return false;
    const SightLine line = stage_.camera.sight_to(place);
    const Vec3 start = line.start(2 * part_->box.diagonal() + (part_->box.center() - place).norm());
    const SightHit hit = part_->sights.first(*part_->mesh, start, line.direction, 0);
    const double slack = 2 * stage_.camera.pixel_size(place) + 1e-3 * part_->box.diagonal();
    return hit.distance < (place - start).norm() - slack;
}

ScenePart::FacetSearch ScenePart::facets_in(const Vec2& from, const Vec2& to, bool through) const {
    const SceneCamera& camera = stage_.camera;
    if (!part_ || camera.pixel_size() <= 0) return [](const Progress&) { return std::vector<Index>(); };
    return [=, part = part_, view = camera.projection()](const Progress& progress) {
        const Mesh& mesh = *part->mesh;
        const double back = 2 * part->box.diagonal(), slack = 1e-6 * part->box.diagonal();
        std::vector<char> in(mesh.facet_count(), 0);
        constexpr std::size_t facets_per_block = 2048;
        parallel_for(mesh.facet_count(), facets_per_block, progress, [&](std::size_t f) {
            Vec3 middle = Vec3::Zero();
            for (int k = 0; k < 3; ++k) {
                const Vec3& corner = mesh.corner(f, k);
                const Vec2 at = view.pixel(corner);
                if ((at.array() < from.array()).any() || (at.array() > to.array()).any()) return;
                middle += corner / 3;
            }
            const SightLine line = view.sight_to(middle);
            const Vec3 start = line.start(back);
            in[f] = through
                    || part->sights.first(mesh, start, line.direction, 0).distance
                           > (middle - start).norm() - slack;
        });
        std::vector<Index> found;
        for (std::size_t f = 0; f < in.size(); ++f)
            if (in[f]) found.push_back(Index(f));
        return found;
    };
}

bool ScenePart::covers() const {
    return part_ && stage_.on(Layer::part) && style_ != PartStyle::wire;
}

SceneActor* ScenePart::lines_of_new() {
    return std::exchange(is_new_, false) ? &lines_ : nullptr;
}

bool ScenePart::has(Layer layer) const {
    return (layer == Layer::part || layer == Layer::edges) && part_;
}

void ScenePart::apply_palette(const Colors& colors) {
    lines_.color(colors.feature_edges);
    edges_.first.color(colors.mesh_edges);
    surface_.first.color(colors.part);
    vtkProperty* front = surface_.first.property();
    if (style_ == PartStyle::flat)
        front->SetInterpolationToFlat();
    else
        front->SetInterpolationToGouraud();
    vtkProperty* back = surface_.first.actor->GetBackfaceProperty();
    back->DeepCopy(front);
    back->SetColor(colors.part_back.r, colors.part_back.g, colors.part_back.b);
}

void ScenePart::apply_line_widths() {
    lines_.set_line_width(1.1 * stage_.line_ratio());
    edges_.first.set_line_width(0.6 * stage_.line_ratio());
}

void ScenePart::apply_visibility(ShownSurface shown) {
    const bool wire = style_ == PartStyle::wire, coarse = stage_.moving && preview_.filled;
    const bool cut = shown == ShownSurface::cut_stock || shown == ShownSurface::repair,
               own = shown == ShownSurface::part;
    const bool on = stage_.on(Layer::part) && !cut;
    surface_.show(on && !wire && !coarse && own);
    preview_.show(on && coarse && own);
    lines_.show(on);
    edges_.show(((stage_.on(Layer::edges) && !cut) || (on && wire)) && !coarse);
}

bool ScenePart::has_preview() const {
    return preview_.filled;
}

void ScenePart::add_bounds(Box3& box) const {
    if (part_ && (stage_.on(Layer::part) || stage_.on(Layer::edges))) box.add(posed_box());
}

void ScenePart::add_known(KnownBoxes& known) const {
    if (!part_ || !(surface_.first.shown() || edges_.first.shown())) return;
    known.box.add(posed_box());
    surface_.add_to(known.actors);
    edges_.add_to(known.actors);
    known.actors.push_back(lines_.actor);
}

void ScenePart::add_heavy(HeavyActors& heavy) {
    surface_.add_to(heavy.surfaces);
    heavy.lines.push_back(&lines_);
    edges_.add_to(heavy.lines);
}

void ScenePart::add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const {
    if (shows_back(shown))
        entries.push_back(
            {LegendEntry::Sample::surface, colors_of(stage_.palette).part_back, 1, "Back of the surface"});
}

bool ScenePart::shows_back(ShownSurface shown) const {
    if (shown != ShownSurface::part || !covers() || !part_->has_border) return false;
    // A sample is enough for a line of the legend.
    const std::size_t n = part_->mesh->facets.size(), stride = n / 2048 + 1;
    const Vec3 toward = stage_.camera.toward_eye();
    std::size_t seen = 0, back = 0;
    for (std::size_t f = 0; f < n; f += stride, ++seen)
        back += part_->mesh->facet_normal(f).dot(toward) < 0;
    return 50 * back > seen;
}

void ScenePart::rehearse(std::size_t k, SceneRehearsal& rehearsal) {
    if (k == 0) rehearsal.triangle(surface_.first);
    if (k == 1) rehearsal.segments(lines_);
}

} // namespace facetmill
