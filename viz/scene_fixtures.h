// What holds the part, in a scene: solid bodies with their edges, one of them chosen.
#pragma once

#include "core/setup/fixture.h"
#include "viz/scene_layer.h"
#include "viz/sight_tree.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace facetmill {

class ScenePart; // scene_part.h

class SceneFixtures : public SceneLayer {
public:
    explicit SceneFixtures(SceneStage& stage);

    /// Null: none. Shown whatever the layers of the view are.
    void set(std::shared_ptr<const std::vector<FixtureSolid>> fixtures);
    /// The one that stands out by its colour, by its place among them.
    void choose(std::optional<std::size_t> chosen);
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// Draws one of them so far from its place, until there are others.
    void shift(std::size_t i, const Vec3& by);

    struct Pick {
        std::size_t index = 0;
        Vec3 point = Vec3::Zero();
    };
    /// What lies under a pixel, before everything else but the part.
    std::optional<Pick> pick(double x, double y, const ScenePart& part) const;

private:
    /// Faces with a corner of their own for each facet, and sharp edges.
    struct Body {
        std::vector<float> points, normals; ///< 3 per corner, from `center`
        std::vector<std::int32_t> triangles, segments;
        Vec3 center = Vec3::Zero();
        SightTree sights; ///< for picking
        SceneActor faces, edges;
    };
    static void shape(Body& body, const Mesh& mesh);

    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    void add_bounds(Box3& box) const override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;

    std::shared_ptr<const std::vector<FixtureSolid>> fixtures_;
    std::vector<std::unique_ptr<Body>> bodies_;
    std::optional<std::size_t> chosen_;
};

} // namespace facetmill
