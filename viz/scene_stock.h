// The stock in a scene: uncut, transparent with its edges, or cut, which hides the part.
#pragma once

#include "core/verify/stock_model.h"
#include "viz/scene_layer.h"
#include "viz/stock_shape.h"

#include <array>
#include <string>

namespace facetmill {

struct OverlayContent; // overlay.h

/// The surface of the stock in patches, as StockPlayback has them.
using StockPatches = std::vector<std::shared_ptr<const StockPatch>>;

class SceneStock : public SceneLayer {
public:
    explicit SceneStock(SceneStage& stage);

    /// The uncut stock; nullptr removes it.
    void set(StockShapePtr shape);
    /// A box; an empty one removes the stock.
    void set_box(const Box3& box);
    /// The cut stock instead of the uncut one, while there is that; empty: the uncut one again. Patches that
    /// are the same objects as before cost nothing, so that a few changed ones can be swapped between two
    /// frames. `detail`, where not empty, is a finer surface of the same stock: drawn in full pictures, while
    /// `patches` serve when the view moves.
    void set_cut(const StockPatches& patches, const StockPatches& detail = {});

    /// What is written at an edge along X, Y and Z; of what is not empty the uncut stock is shown whatever
    /// the layers of the view are.
    void set_dimensions(const std::array<std::string, 3>& texts) { dimensions_ = texts; }
    const std::array<std::string, 3>& dimensions() const { return dimensions_; }
    void add_to(OverlayContent& content) const;

    bool has_uncut() const { return !box_.empty(); }
    /// The cut stock is visible.
    bool shows_cut() const;

private:
    /// A surface in patches.
    struct Surface {
        StockPatches patches;
        SceneActors actors; ///< by the patches' numbers; null: no surface
        bool any = false;   ///< some patch has a surface
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
    void rehearse(std::size_t k, SceneRehearsal& rehearsal) override;
    void swap(Surface& surface, const StockPatches& patches);

    bool dimensioned() const { return dimensions_ != std::array<std::string, 3>(); }

    Box3 box_;
    std::array<std::string, 3> dimensions_;
    StockShapePtr shape_; ///< behind the actors' data
    SceneActor faces_, lines_;
    Surface cut_, detail_;
    vtkSmartPointer<vtkProperty> cut_look_;
};

} // namespace facetmill
