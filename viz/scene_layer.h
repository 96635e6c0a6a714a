// What the layers of a scene have in common. A layer shows one kind of thing: it owns its actors, says when
// they are to be seen and what the legend tells of them, and offers its users an interface of its own
// (scene_part.h, scene_paths.h ...).
#pragma once

#include "core/base/units.h"
#include "viz/overlay.h"
#include "viz/palette.h"
#include "viz/scene_camera.h"
#include "viz/scene_steps.h"

#include <string_view>
#include <vector>

namespace facetmill {

/// What can be shown and hidden. All but `edges` are shown at first.
enum class Layer {
    part,      ///< the part's surface with its sharp and open edges
    edges,     ///< all facet edges
    stock,     ///< the uncut stock, transparent; the cut stock, which hides the part, where there is one
    deviation, ///< the part's surface in the colours of its deviations; stands for the surface of `part`
    findings,  ///< dots where something was found
    strips,    ///< regions for rework and clean-up, translucent, with labels
    cc,     ///< cutter contacts; those left to clean-up and those of kept postures with either of cc and cl
    cl,     ///< tool tip, coloured by the kind of motion
    tool,   ///< cutter, shank and holder at the pose
    marker, ///< picked point, and where a tool touches
    axes,   ///< orientation axes in the corner
    scale,  ///< scale bar with its unit
    legend, ///< colours of what is shown
    title,
};

const std::vector<Layer>& all_layers();
std::string_view layer_name(Layer layer);
std::string_view layer_label(Layer layer);

/// What is drawn where the part's surface is: cut stock, deviations and what a recipe makes of it stand for
/// it.
enum class ShownSurface { part, deviation, cut_stock, repair };

/// What all layers of a scene share.
struct SceneStage {
    SceneStage();
    ~SceneStage();
    bool on(Layer layer) const { return layers_on[std::size_t(layer)]; }

    vtkSmartPointer<vtkRenderer> renderer;
    SceneCamera camera;
    SceneSteps steps;
    Palette palette = Palette::light;
    LengthUnit unit = LengthUnit::mm;
    double ratio = 1;
    double line_scale = 1;
    double covered_below = 0; ///< logical pixels along the lower edge; see Scene::set_covered_below
    LayoutRect covered;       ///< see Scene::set_covered
    double line_ratio() const { return ratio * line_scale; } ///< pixels of a line of width 1
    bool moving = false;                                     ///< large things are drawn coarsely
    std::vector<bool> layers_on;
};

/// A box that is known, and the actors that are in it: VTK would go through all facets of a new part.
struct KnownBoxes {
    Box3 box;
    std::vector<vtkActor*> actors;
};

class SceneLayer {
public:
    explicit SceneLayer(SceneStage& stage) : stage_(stage) {}
    virtual ~SceneLayer() = default;
    SceneLayer(const SceneLayer&) = delete;
    SceneLayer& operator=(const SceneLayer&) = delete;

    /// True when there is something to show in the layer, visible or not.
    virtual bool has(Layer) const { return false; }
    virtual void apply_palette(const Colors&) {}
    virtual void apply_line_widths() {}
    /// Visibility of the actors.
    virtual void apply_visibility(ShownSurface) {}
    /// Before every frame.
    virtual void prepare_frame() {}
    /// Some of its actors stand for others while the view moves, or are so many that they are better drawn by
    /// steps.
    virtual bool has_preview() const { return false; }
    /// Box of what is visible.
    virtual void add_bounds(Box3&) const {}
    virtual void add_known(KnownBoxes&) const {}
    virtual void add_heavy(HeavyActors&) {}
    virtual void add_legend(std::vector<LegendEntry>&, ShownSurface) const {}
    virtual void add_color_bars(std::vector<ColorBar>&, ShownSurface) const {}
    /// Step k of what a first picture takes long for.
    virtual void rehearse(std::size_t, SceneRehearsal&) {}

protected:
    /// Shows an actor, and owns nothing of it.
    void add_actor(SceneActor& actor);

    SceneStage& stage_;
};

} // namespace facetmill
