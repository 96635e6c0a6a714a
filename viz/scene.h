// What the workbench's viewport and the pictures show: a part, its stock, tool paths and a tool, with legend,
// scale, axes and title. A Scene owns renderers but no window: it is attached to any vtkRenderWindow, a
// widget's or an off-screen one (offscreen.h). It knows no widgets and runs on the thread that renders.
//
// Each kind of thing is a layer with an interface of its own: `scene.part().set(display)`.
//
// Frames. World coordinates are part coordinates in mm. Display coordinates are device pixels of the window
// with the origin at the top left and y down, as widgets and pictures have them. Projection is parallel at
// first; in perspective there is no scale bar, which would not hold everywhere.
//
// Everything that takes long for a large part or path (arrays, normals, edges) is done by
// prepare_part_display and prepare_path_display on any thread; the layers take the finished display and only
// hand it to the graphics card.
#pragma once

#include "viz/scene_boundaries.h"
#include "viz/scene_camera.h"
#include "viz/scene_deviation.h"
#include "viz/scene_findings.h"
#include "viz/scene_fixtures.h"
#include "viz/scene_former.h"
#include "viz/scene_layer.h"
#include "viz/scene_levels.h"
#include "viz/scene_part.h"
#include "viz/scene_paths.h"
#include "viz/scene_preview.h"
#include "viz/scene_repair.h"
#include "viz/scene_stock.h"
#include "viz/scene_strips.h"
#include "viz/scene_support.h"
#include "viz/scene_tool.h"
#include "viz/scene_zero.h"

#include <cstddef>
#include <memory>
#include <string>

namespace facetmill {

class Scene {
public:
    Scene();
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// Adds the scene's renderers (two layers) to a window. Call once per window; the window may go before
    /// the scene.
    void attach(vtkRenderWindow* window);
    void detach();
    /// The renderer of the 3D content, for interactor styles.
    vtkRenderer* renderer();

    ScenePart& part();
    const ScenePart& part() const;
    SceneFormer& former();
    const SceneFormer& former() const;
    SceneBoundaries& boundaries();
    SceneStock& stock();
    SceneFixtures& fixtures();
    const SceneFixtures& fixtures() const;
    SceneDeviation& deviation();
    const SceneDeviation& deviation() const;
    SceneFindings& findings();
    SceneLevels& levels();
    ScenePreview& preview();
    const ScenePreview& preview() const;
    SceneSupport& support();
    SceneRepair& repair();
    SceneZero& zero();
    SceneStrips& strips();
    const SceneStrips& strips() const;
    ScenePaths& paths();
    const ScenePaths& paths() const;
    SceneTool& tool();
    const SceneTool& tool() const;
    SceneMarks& marks();
    const SceneMarks& marks() const;
    SceneCamera& camera();
    const SceneCamera& camera() const;

    /// Device pixels per layout pixel: text, lines and margins grow with it. 1 at first.
    void set_pixel_ratio(double ratio);
    /// Lines and dots are so much wider than the ratio says: on a screen with many pixels and no ratio. 1 at
    /// first.
    void set_line_scale(double scale);
    /// Something covers so many logical pixels along the lower edge: axes and scale stand above it. True
    /// where that is new.
    bool set_covered_below(double pixels);
    /// Something covers this rectangle of the lower right corner, logical pixels from the upper left one:
    /// what is fitted and labels of strips keep clear of it. Both the same: nothing, as at first.
    void set_covered(const Vec2& from, const Vec2& to);
    void set_palette(Palette palette);
    Palette palette() const;
    /// Unit of the scale bar. Everything else in a Scene is mm.
    void set_unit(LengthUnit unit);
    /// Smooths jagged edges after drawing (FXAA). On at first.
    void set_antialiasing(bool on);
    /// While the view turns, large parts and paths are drawn coarsely, so that it keeps up on slow graphics.
    /// Say true when the user begins to move it and false at the end. Pictures, picking and bounds do not
    /// change.
    void set_moving(bool moving);
    /// True when `set_moving` makes a difference, or a first picture takes so long that it is better drawn by
    /// steps.
    bool has_preview() const;
    /// One picture in several frames of the window, so that whoever waits for other things too, a window
    /// without a graphics card, need not wait for a whole one. `begin_steps` takes stock of what is to be
    /// drawn and returns the number of steps; then every frame draws what `set_step` says, 0 first, over what
    /// the frames before have left in the window, and only after the last one the picture is whole. Nothing
    /// else of the scene may change on the way: where it does, the steps begin anew. `end_steps` lets every
    /// frame be a whole picture again.
    std::size_t begin_steps();
    void set_step(std::size_t step);
    void end_steps();
    /// What SceneBoundaries::paint was told since the last picture can be drawn over that one, as long as
    /// nothing else has changed: after this, frames draw nothing else, and clear nothing. False: there is
    /// nothing. `end_added` lets frames be whole pictures again.
    bool begin_added();
    void end_added();
    /// What a first picture of something takes long for, the shaders, can be had before it is there: after
    /// `rehearse(k)`, k below `rehearsals`, a frame draws nothing but something small in one of their ways,
    /// whatever layers are shown. It is not to be seen; not between the steps of a picture; `end_rehearsal`
    /// follows.
    static constexpr std::size_t rehearsals = 7;
    void rehearse(std::size_t k);
    void end_rehearsal();

    /// Top left; both lines are shortened in the middle to the width of the window. Bytes that are not UTF-8
    /// and control characters are replaced.
    void set_title(const std::string& title, const std::string& subtitle = {});
    /// Shown in the middle while no part, stock or path is seen.
    void set_empty_text(const std::string& text);
    /// What stands in the middle now; empty where there is something to see.
    std::string shown_empty_text() const;

    void set_visible(Layer layer, bool on);
    bool visible(Layer layer) const;
    /// True when there is something to show in the layer, visible or not.
    bool has(Layer layer) const;

    /// Box of what is visible of part, stock and paths; of the tool too when `with_tool`. Empty when nothing
    /// is.
    Box3 bounds(bool with_tool = false) const;
    /// Looks from a standard direction and fits.
    void set_view(StandardView view);
    /// Centres and scales to `bounds` with a margin, keeping the direction.
    void fit(bool with_tool = false);
    /// The legend lies over `bounds`.
    bool legend_lies_over() const;
    /// It is another one than at the last `fit`, and lies over `bounds`, or is no larger than before a `fit`
    /// made room for one that did: time for another `fit`.
    bool legend_came_over() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace facetmill
