// Regions of the surface in a scene: bands, boundary curves, labels, and dots to take hold of.
#pragma once

#include "viz/scene_layer.h"
#include "viz/strip_display.h"

#include <optional>

namespace facetmill {

class ScenePart;

class SceneStrips : public SceneLayer {
public:
    SceneStrips(SceneStage& stage, const ScenePart& part);

    /// nullptr removes them.
    void set(StripDisplayPtr strips);
    /// The one, by its place in the list, that stands out.
    void choose(std::optional<std::size_t> strip);
    /// Dots on their boundaries that can be picked. Off at first.
    void set_handles(bool on);
    /// The dot nearest to a pixel within `radius` pixels, on the side of the part that is seen.
    std::optional<Vec3> pick_handle(double x, double y, double radius) const;

    /// Labels of the strips, where they stand over nothing of what is laid out.
    std::vector<OverlayNote> notes(Overlay& overlay, const OverlayLayout& layout) const;
    /// There are some, and their layer is on.
    bool shown() const;

private:
    bool has(Layer layer) const override;
    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;
    /// As many actors as there are strips.
    template <class Look>
    void fit(SceneActors& actors, std::size_t count, const Look& look);

    const ScenePart& part_;
    StripDisplayPtr strips_;
    std::optional<std::size_t> chosen_;
    bool handles_on_ = false;
    SceneActors bands_, lines_, handles_; ///< one each per strip
};

} // namespace facetmill
