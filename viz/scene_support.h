// The face that a part is to lie on, in a scene: a polygon on the part.
#pragma once

#include "viz/scene_layer.h"

#include <cstdint>

namespace facetmill {

class SceneSupport : public SceneLayer {
public:
    explicit SceneSupport(SceneStage& stage);

    /// Corners of a convex polygon in their order; none: nothing. Shown whatever the layers of the view are.
    void set(const std::vector<Vec3>& outline);
    bool shown() const { return !outline_.empty(); }

private:
    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;

    std::vector<Vec3> outline_;
    std::vector<float> points_; ///< behind the actors' data
    std::vector<std::int32_t> triangles_, segments_;
    SceneActor face_, lines_;
};

} // namespace facetmill
