// The scan room in a scene: the curves of the holes of the part as it is, and in its place what a recipe
// makes of it, before or after.
#pragma once

#include "viz/repair_display.h"
#include "viz/scene_layer.h"

#include <vector>

namespace facetmill {

/// A curve that ends where it begins.
using ClosedCurve = std::vector<Vec3>;

class SceneRepair : public SceneLayer {
public:
    explicit SceneRepair(SceneStage& stage);

    /// Shown in the place of the part; nullptr: the part itself is.
    void set(RepairDisplayPtr display);
    const RepairDisplayPtr& display() const { return display_; }
    /// Which side of the display is seen. At first after.
    void set_after(bool after);
    bool after() const { return after_; }
    /// Curves of holes that are left, and of those that the recipe fills.
    void set_holes(const std::vector<ClosedCurve>& left, const std::vector<ClosedCurve>& filled);
    bool has_holes() const { return left_.filled || filled_.filled; }
    /// Curves of what is chosen, thick; none: nothing.
    void set_chosen(const std::vector<ClosedCurve>& curves);
    bool has_chosen() const { return chosen_.filled; }

    /// Something stands in the part's place.
    bool covers() const { return display_ && stage_.on(Layer::part); }

private:
    /// Segments behind an actor's data.
    struct Lines : SceneActor {
        std::vector<float> points;
        std::vector<std::int32_t> segments;
        void set(const std::vector<ClosedCurve>& curves);
    };
    bool has(Layer layer) const override;
    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    bool has_preview() const override;
    void add_bounds(Box3& box) const override;
    void add_known(KnownBoxes& known) const override;
    void add_heavy(HeavyActors& heavy) override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;
    void add_color_bars(std::vector<ColorBar>& bars, ShownSurface shown) const override;
    bool moves() const { return display_ && display_->largest > 0; }

    RepairDisplayPtr display_;
    bool after_ = true;
    ScenePieces before_, kept_, added_, removed_;
    SceneActor before_preview_, kept_preview_, before_lines_;
    std::vector<vtkSmartPointer<vtkPolyData>> data_;
    Lines left_, filled_, chosen_;
};

} // namespace facetmill
