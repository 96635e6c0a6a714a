// Passes as they will about run, in a scene, before they are planned: thin dashes in a colour of their own.
#pragma once

#include "viz/preview_display.h"
#include "viz/scene_layer.h"

#include <string>

namespace facetmill {

class ScenePreview : public SceneLayer {
public:
    explicit ScenePreview(SceneStage& stage);

    /// `label` stands in the legend, line by line: what it is or, without lines, why there are none; nullptr
    /// and no label remove it.
    void set(PreviewDisplayPtr preview, const std::string& label);
    /// Shown at first.
    void set_visible(bool on) { visible_ = on; }
    bool empty() const { return !lines_.filled; }
    const std::string& label() const { return label_; }

private:
    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;

    PreviewDisplayPtr preview_;
    std::string label_;
    bool visible_ = true;
    SceneActor lines_;
};

} // namespace facetmill
