// The part before it was replaced, faint, beside the one that has taken its place.
#pragma once

#include "viz/part_display.h"
#include "viz/scene_layer.h"

namespace facetmill {

class SceneFormer : public SceneLayer {
public:
    explicit SceneFormer(SceneStage& stage);

    /// nullptr removes it. Seen together with the layer of the part; views are not fitted to it.
    void set(PartDisplayPtr part);
    bool any() const { return faces_.first.filled; }

private:
    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    bool has_preview() const override;
    void add_known(KnownBoxes& known) const override;
    void add_heavy(HeavyActors& heavy) override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;

    PartDisplayPtr part_; ///< behind the actors' data
    ScenePieces faces_;
    SceneActor lines_;
};

} // namespace facetmill
