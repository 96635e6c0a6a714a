// The part's surface in a scene in the colours of its deviations.
#pragma once

#include "viz/deviation_display.h"
#include "viz/scene_layer.h"

#include <string>

namespace facetmill {

class SceneDeviation : public SceneLayer {
public:
    explicit SceneDeviation(SceneStage& stage);

    /// nullptr removes it.
    void set(DeviationDisplayPtr deviation);
    /// Colours anew: some milliseconds for a hundred thousand samples.
    void set_scale(const DeviationScale& scale);
    const DeviationScale& scale() const { return scale_; }
    /// What the legend says behind the word "Deviation", such as "out of date".
    void set_note(const std::string& note);

    /// Is there, and its layer is on.
    bool wanted() const;

private:
    bool has(Layer layer) const override;
    void apply_visibility(ShownSurface shown) override;
    bool has_preview() const override;
    void add_bounds(Box3& box) const override;
    void add_known(KnownBoxes& known) const override;
    void add_heavy(HeavyActors& heavy) override;
    void add_color_bars(std::vector<ColorBar>& bars, ShownSurface shown) const override;
    void rehearse(std::size_t k, SceneRehearsal& rehearsal) override;
    /// The scale's colours on all actors.
    void color();

    DeviationDisplayPtr deviation_;
    DeviationScale scale_;
    std::string note_;
    ScenePieces surface_;
    SceneActor preview_;
    std::vector<vtkSmartPointer<vtkPolyData>> data_;
    std::vector<std::uint8_t> rgba_, preview_rgba_; ///< behind the actors' data
};

} // namespace facetmill
