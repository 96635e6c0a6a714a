// Level frames around a part in a scene: the heights of the layers of roughing.
#pragma once

#include "viz/scene_layer.h"

#include <array>
#include <cstdint>
#include <optional>

namespace facetmill {

/// Level frames around a box, at the heights of layers.
struct LevelMarks {
    Box3 box;
    std::vector<double> heights;
    std::optional<std::size_t> chosen; ///< drawn apart from the others
    bool operator==(const LevelMarks& o) const {
        return box.lo == o.box.lo && box.hi == o.box.hi && heights == o.heights && chosen == o.chosen;
    }
};

class SceneLevels : public SceneLayer {
public:
    explicit SceneLevels(SceneStage& stage);

    /// None: nullopt. Shown whatever the layers of the view are.
    void set(const std::optional<LevelMarks>& levels);

private:
    /// The chosen one, or all others.
    struct Frames {
        SceneActor lines;
        std::vector<float> points; ///< behind the actor's data
        std::vector<std::int32_t> segments;
    };

    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;
    static void set(Frames& frames, const LevelMarks& levels, bool chosen);

    std::optional<LevelMarks> levels_;
    Frames others_, chosen_;
};

} // namespace facetmill
