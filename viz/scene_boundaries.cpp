#include "viz/scene_boundaries.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"
#include "viz/scene_part.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace facetmill {

namespace {

/// In front of the surface and behind the lines on it, 1/65000 of the view's depth; pieces that are drawn at
/// the same place come one over the other by their order.
constexpr double tint_nearer = 8;
/// Of a curve between two corners.
constexpr int pieces_per_side = 64;

void put_point(std::vector<float>& to, const Vec3& v) {
    to.insert(to.end(), {float(v.x()), float(v.y()), float(v.z())});
}

struct RoleLook {
    Rgb surface, line;
    const char* legend;
};
RoleLook look_of(const Colors& colors, std::size_t role) {
    switch (BoundaryRole(role)) {
    case BoundaryRole::within:
        return {colors.boundary, colors.boundary_line, "Boundary"};
    case BoundaryRole::avoided:
        return {colors.avoided, colors.avoided_line, "Kept off"};
    case BoundaryRole::steep:
        return {colors.steep, colors.steep, "Steep"};
    case BoundaryRole::shallow:
        break;
    }
    return {colors.shallow, colors.shallow, "Shallow"};
}

} // namespace

SceneBoundaries::SceneBoundaries(SceneStage& stage, const ScenePart& part) : SceneLayer(stage), part_(part) {
    for (Piece* p : {&added_in_, &added_out_})
        add_actor(p->actor);
    for (Tint& tint : tints_) {
        for (SceneActor* a : {&tint.coarse.actor, &tint.line, &tint.dots, &tint.area_actor})
            add_actor(*a);
        tint.line.unlit();
        tint.line.nearer(48);
        tint.dots.unlit();
        tint.dots.nearer(54);
        tint.dots.property()->SetRenderPointsAsSpheres(true);
    }
}

SceneBoundaries::~SceneBoundaries() = default;

bool SceneBoundaries::fits(const Tint& tint) const {
    return display_ && display_ == part_.display() && tint.marks.size() == display_->mesh->facet_count();
}

/// Whether the sides of a divide are shown: they stand for the boundary, which they keep to.
bool SceneBoundaries::divided() const {
    return fits(tint_of(BoundaryRole::steep)) || fits(tint_of(BoundaryRole::shallow));
}

bool SceneBoundaries::tinted(std::size_t role, std::size_t facet) const {
    if (!tints_[role].marks[facet]) return false;
    if (role < std::size_t(BoundaryRole::steep)) return true;
    const Tint &within = tint_of(BoundaryRole::within), &avoided = tint_of(BoundaryRole::avoided);
    return !(fits(within) && within.count > 0 && !within.marks[facet])
           && !(fits(avoided) && avoided.marks[facet]);
}

void SceneBoundaries::divide_anew() {
    for (const BoundaryRole role : {BoundaryRole::steep, BoundaryRole::shallow}) {
        Tint& tint = tints_[std::size_t(role)];
        for (const auto& piece : tint.pieces)
            piece->stale = true;
        tint.coarse.stale = true;
    }
}

void SceneBoundaries::set(BoundaryRole role, std::vector<char> marks, PartDisplayPtr area) {
    Tint& tint = tints_[std::size_t(role)];
    stage_.steps.forget();
    if (display_ != part_.display()) {
        // The actors let go of the old points, all together.
        for (Tint& t : tints_) {
            for (const auto& piece : t.pieces)
                stage_.renderer->RemoveActor(piece->actor.actor);
            t.pieces.clear();
            t.coarse.actor.clear();
            t.area_actor.clear();
            t.area = nullptr;
        }
        added_in_.actor.clear();
        added_out_.actor.clear();
        added_.clear();
        display_ = part_.display();
    }
    tint.marks = std::move(marks);
    tint.count = std::size_t(std::count_if(tint.marks.begin(), tint.marks.end(), [](char m) { return m; }));
    const std::size_t needed =
        fits(tint) ? (tint.marks.size() + elements_in_piece - 1) / elements_in_piece : 0;
    while (tint.pieces.size() > needed) {
        stage_.renderer->RemoveActor(tint.pieces.back()->actor.actor);
        tint.pieces.pop_back();
    }
    while (tint.pieces.size() < needed) {
        tint.pieces.push_back(std::make_unique<Piece>());
        add_actor(tint.pieces.back()->actor);
    }
    for (const auto& piece : tint.pieces)
        piece->stale = true;
    tint.coarse.stale = true;
    tint.area_actor.clear();
    tint.area = fits(tint) ? std::move(area) : nullptr;
    if (tint.area)
        tint.area_actor.set_data(triangle_data(tint.area->points, tint.area->normals, tint.area->triangles),
                                 tint.area->center);
    if (role == BoundaryRole::within) added_.clear();
    if (role < BoundaryRole::steep) divide_anew();
}

Vec3 SceneBoundaries::draped(const Vec3& place) const {
    const PartDisplay& part = *part_.display();
    const Vec3 above(place.x(), place.y(), part.box.hi.z() + 1);
    const SightHit hit = part.sights.first(*part.mesh, above, -Vec3::UnitZ());
    return hit.found() ? Vec3(above - hit.distance * Vec3::UnitZ()) : place;
}

void SceneBoundaries::set_curve(BoundaryRole role, const std::vector<Vec3>& corners, bool closed) {
    Tint& tint = tints_[std::size_t(role)];
    tint.line.clear();
    tint.dots.clear();
    tint.curve.clear();
    tint.segments.clear();
    tint.corners.clear();
    if (corners.empty() || !part_.display()) return;
    const Vec3 center = part_.display()->center;
    const std::size_t n = corners.size(), sides = closed ? n : n - 1;
    for (const Vec3& c : corners)
        put_point(tint.corners, c - center);
    for (std::size_t i = 0; i < sides; ++i)
        for (int k = 0; k <= pieces_per_side; ++k) {
            const double t = double(k) / pieces_per_side;
            put_point(tint.curve, draped((1 - t) * corners[i] + t * corners[(i + 1) % n]) - center);
            const auto last = std::int32_t(tint.curve.size() / 3 - 1);
            if (k > 0) tint.segments.insert(tint.segments.end(), {last - 1, last});
        }
    if (!tint.segments.empty()) tint.line.set_data(segment_data(tint.curve, tint.segments), center);
    tint.dots.set_data(dot_data(tint.corners), center);
    apply_palette(colors_of(stage_.palette));
    apply_line_widths();
}

void SceneBoundaries::paint(const std::vector<Index>& facets, bool in) {
    Tint& tint = tints_[std::size_t(BoundaryRole::within)];
    if (!fits(tint)) return;
    for (const Index f : facets) {
        if (bool(tint.marks[f]) == in) continue;
        tint.marks[f] = in;
        tint.count += in ? 1 : std::size_t(-1);
        tint.pieces[f / elements_in_piece]->stale = true;
        added_.push_back(f);
    }
    tint.coarse.stale = true;
    divide_anew();
}

void SceneBoundaries::look(SceneActor& actor, std::size_t role) {
    const Colors& colors = colors_of(stage_.palette);
    actor.property()->DeepCopy(part_.surface().property());
    actor.color(look_of(colors, role).surface);
    actor.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -tint_nearer);
}

void SceneBoundaries::fill(Piece& piece, const std::vector<Index>& facets) {
    std::vector<std::int32_t> triangles;
    triangles.reserve(3 * facets.size());
    for (const Index f : facets)
        triangles.insert(triangles.end(), display_->triangles.begin() + 3 * std::ptrdiff_t(f),
                         display_->triangles.begin() + 3 * std::ptrdiff_t(f) + 3);
    // The old indices stay until the actor has the new ones.
    piece.triangles.swap(triangles);
    if (piece.triangles.empty())
        piece.actor.clear();
    else
        piece.actor.set_data(triangles_like(part_.surface().mapper->GetInput(), piece.triangles),
                             display_->center);
    piece.stale = false;
}

void SceneBoundaries::fill_coarse(std::size_t role) {
    Tint& tint = tints_[role];
    const PartPreview& preview = display_->preview;
    std::vector<std::int32_t> triangles;
    for (std::size_t f = 0; f < tint.marks.size(); ++f) {
        if (!tinted(role, f)) continue;
        std::array<std::int32_t, 3> t{};
        for (std::size_t k = 0; k < 3; ++k)
            t[k] = preview.merged[std::size_t(display_->triangles[3 * f + k])];
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
            triangles.insert(triangles.end(), t.begin(), t.end());
    }
    tint.coarse.triangles.swap(triangles);
    if (tint.coarse.triangles.empty())
        tint.coarse.actor.clear();
    else
        tint.coarse.actor.set_data(triangle_data(preview.points, preview.normals, tint.coarse.triangles),
                                   display_->center);
    tint.coarse.stale = false;
}

void SceneBoundaries::settle() {
    for (std::size_t role = 0; role < tints_.size(); ++role) {
        Tint& tint = tints_[role];
        if (!fits(tint)) continue;
        look(tint.area_actor, role);
        std::vector<Index> facets;
        for (std::size_t p = 0; p < tint.pieces.size(); ++p) {
            Piece& piece = *tint.pieces[p];
            if (!piece.stale || tint.area) continue;
            facets.clear();
            const std::size_t end = std::min(tint.marks.size(), (p + 1) * elements_in_piece);
            for (std::size_t f = p * elements_in_piece; f < end; ++f)
                if (tinted(role, f)) facets.push_back(Index(f));
            fill(piece, facets);
            look(piece.actor, role);
        }
        if (stage_.moving && tint.coarse.stale && !display_->preview.triangles.empty()) fill_coarse(role);
        look(tint.coarse.actor, role);
    }
    added_.clear();
}

bool SceneBoundaries::begin_added() {
    const Tint& tint = tints_[std::size_t(BoundaryRole::within)];
    if (added_.empty() || !fits(tint)) return false;
    std::vector<Index> in, out;
    for (const Index f : added_)
        (tint.marks[f] ? in : out).push_back(f);
    added_.clear();
    fill(added_in_, in);
    fill(added_out_, out);
    look(added_in_.actor, std::size_t(BoundaryRole::within));
    added_out_.actor.look_like(part_.surface());
    added_out_.actor.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -tint_nearer);
    adding_ = true;
    return true;
}

void SceneBoundaries::end_added() {
    adding_ = false;
}

void SceneBoundaries::apply_palette(const Colors& colors) {
    for (std::size_t role = 0; role < tints_.size(); ++role) {
        Tint& tint = tints_[role];
        const RoleLook own = look_of(colors, role);
        for (const auto& piece : tint.pieces)
            look(piece->actor, role);
        look(tint.coarse.actor, role);
        look(tint.area_actor, role);
        tint.line.color(own.line);
        tint.dots.color(own.line);
    }
}

void SceneBoundaries::apply_line_widths() {
    for (Tint& tint : tints_) {
        tint.line.set_line_width(2.4 * stage_.line_ratio());
        tint.dots.set_point_size(8 * stage_.line_ratio());
    }
}

void SceneBoundaries::apply_visibility(ShownSurface shown) {
    const bool on = shown == ShownSurface::part && stage_.on(Layer::part);
    for (std::size_t role = 0; role < tints_.size(); ++role) {
        Tint& tint = tints_[role];
        const bool tinted =
            on && fits(tint) && !adding_ && !(divided() && role == std::size_t(BoundaryRole::within));
        const bool coarse = stage_.moving && display_ && !display_->preview.triangles.empty();
        for (const auto& piece : tint.pieces)
            piece->actor.show(tinted && !coarse && !tint.area);
        tint.coarse.actor.show(tinted && coarse);
        tint.area_actor.show(tinted && !coarse);
        tint.line.show(!adding_);
        tint.dots.show(!adding_);
    }
    for (Piece* p : {&added_in_, &added_out_})
        p->actor.show(adding_ && on);
}

void SceneBoundaries::hide_others() const {
    if (!adding_) return;
    vtkActorCollection* actors = stage_.renderer->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it))
        if (actor != added_in_.actor.actor && actor != added_out_.actor.actor) actor->VisibilityOff();
}

void SceneBoundaries::add_known(KnownBoxes& known) const {
    for (const Tint& tint : tints_) {
        if (!fits(tint)) continue;
        known.actors.push_back(tint.coarse.actor.actor);
        known.actors.push_back(tint.area_actor.actor);
        for (const auto& piece : tint.pieces)
            known.actors.push_back(piece->actor.actor);
    }
}

void SceneBoundaries::add_heavy(HeavyActors& heavy) {
    for (Tint& tint : tints_)
        for (const auto& piece : tint.pieces)
            heavy.surfaces.push_back(&piece->actor);
}

void SceneBoundaries::add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const {
    const Colors& colors = colors_of(stage_.palette);
    for (std::size_t role = 0; role < tints_.size(); ++role) {
        const Tint& tint = tints_[role];
        const RoleLook own = look_of(colors, role);
        const bool tinted = shown == ShownSurface::part && fits(tint) && tint.count > 0
                            && !(divided() && role == std::size_t(BoundaryRole::within));
        if (tinted || tint.dots.filled)
            entries.push_back({LegendEntry::Sample::surface, own.surface, 1, own.legend});
    }
}

} // namespace facetmill
