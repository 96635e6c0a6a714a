#include "viz/scene_fixtures.h"

#include "core/mesh/edge_table.h"
#include "viz/overlay.h"
#include "viz/poly_data.h"
#include "viz/scene_part.h"

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Edges between facets that turn by less are not drawn: a cylinder's sides.
const double sharp_fixture_cos = std::cos(radians(20));

void put(std::vector<float>& to, const Vec3& v) {
    to.insert(to.end(), {float(v.x()), float(v.y()), float(v.z())});
}

} // namespace

SceneFixtures::SceneFixtures(SceneStage& stage) : SceneLayer(stage) {}

void SceneFixtures::shape(Body& body, const Mesh& mesh) {
    body.center = mesh.box().center();
    body.sights = SightTree(mesh, {});
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        for (int k = 0; k < 3; ++k) {
            body.triangles.push_back(std::int32_t(body.triangles.size()));
            put(body.points, mesh.corner(f, k) - body.center);
            put(body.normals, mesh.facet_normal(f));
        }
    const EdgeTable edges(mesh, {});
    const auto corner = [](std::size_t side) { return std::int32_t(side); };
    for (std::size_t low = 0; low < edges.vertex_count(); ++low)
        edges.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
            const bool smooth =
                sides.size() == 2
                && mesh.facet_normal(sides[0].facet()).dot(mesh.facet_normal(sides[1].facet()))
                       > sharp_fixture_cos;
            if (smooth) return;
            const std::size_t side = sides[0].side, next = side / 3 * 3 + (side % 3 + 1) % 3;
            body.segments.insert(body.segments.end(), {corner(side), corner(next)});
        });
}

void SceneFixtures::set(std::shared_ptr<const std::vector<FixtureSolid>> fixtures) {
    if (fixtures == fixtures_) return;
    for (const auto& body : bodies_)
        for (SceneActor* a : {&body->faces, &body->edges})
            stage_.renderer->RemoveActor(a->actor);
    bodies_.clear();
    fixtures_ = std::move(fixtures);
    if (fixtures_)
        for (const FixtureSolid& fixture : *fixtures_) {
            auto body = std::make_unique<Body>();
            shape(*body, *fixture.mesh);
            add_actor(body->faces);
            add_actor(body->edges);
            body->edges.unlit();
            body->edges.nearer(12);
            body->faces.set_data(triangle_data(body->points, body->normals, body->triangles), body->center);
            body->edges.set_data(segment_data(body->points, body->segments), body->center);
            bodies_.push_back(std::move(body));
        }
    apply_palette(colors_of(stage_.palette));
    apply_line_widths();
    apply_visibility(ShownSurface::part);
}

void SceneFixtures::choose(std::optional<std::size_t> chosen) {
    chosen_ = chosen;
    apply_palette(colors_of(stage_.palette));
}

void SceneFixtures::shift(std::size_t i, const Vec3& by) {
    if (i >= bodies_.size()) return;
    const Vec3 at = bodies_[i]->center + by;
    for (SceneActor* a : {&bodies_[i]->faces, &bodies_[i]->edges})
        a->actor->SetPosition(at.x(), at.y(), at.z());
}

std::optional<SceneFixtures::Pick> SceneFixtures::pick(double x, double y, const ScenePart& part) const {
    const SceneCamera& camera = stage_.camera;
    if (bodies_.empty() || camera.pixel_size() <= 0) return std::nullopt;
    const SightLine line = camera.sight_at(x, y);
    const Vec3 &at = line.at, &direction = line.direction;
    double nearest = infinity;
    Pick found;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const double along =
            bodies_[i]->sights.first(*(*fixtures_)[i].mesh, at, direction, -line.back).distance;
        if (along < nearest) {
            nearest = along;
            found = {i, at + along * direction};
        }
    }
    if (nearest == infinity) return std::nullopt;
    const auto behind = part.pick(x, y);
    if (behind && (behind->point - found.point).dot(direction) < 0) return std::nullopt;
    return found;
}

void SceneFixtures::apply_palette(const Colors& colors) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        bodies_[i]->faces.color(chosen_ == i          ? colors.chosen_fixture
                                : (*fixtures_)[i].tab ? colors.cut_stock
                                                      : colors.fixture);
        bodies_[i]->edges.color(colors.feature_edges);
    }
}

void SceneFixtures::apply_line_widths() {
    for (const auto& body : bodies_)
        body->edges.set_line_width(1.2 * stage_.line_ratio());
}

void SceneFixtures::apply_visibility(ShownSurface) {
    for (const auto& body : bodies_) {
        body->faces.show(true);
        body->edges.show(true);
    }
}

void SceneFixtures::add_bounds(Box3& box) const {
    if (!fixtures_) return;
    for (const FixtureSolid& fixture : *fixtures_)
        box.add(fixture.mesh->box());
}

void SceneFixtures::add_legend(std::vector<LegendEntry>& entries, ShownSurface) const {
    if (!fixtures_) return;
    const Colors& colors = colors_of(stage_.palette);
    const auto tabs = std::size_t(
        std::count_if(fixtures_->begin(), fixtures_->end(), [](const FixtureSolid& f) { return f.tab; }));
    const std::size_t others = fixtures_->size() - tabs;
    if (others > 0)
        entries.push_back(
            {LegendEntry::Sample::surface, colors.fixture, 1, others == 1 ? "Fixture" : "Fixtures"});
    if (tabs > 0)
        entries.push_back({LegendEntry::Sample::surface, colors.cut_stock, 1, tabs == 1 ? "Tab" : "Tabs"});
}

} // namespace facetmill
