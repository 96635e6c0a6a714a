// What the workbench's viewport and the pictures show: a part, its stock, tool paths and a tool, with legend,
// scale, axes and title. A Scene owns renderers but no window: it is attached to any vtkRenderWindow, a
// widget's or an off-screen one (offscreen.h). It knows no widgets and runs on the thread that renders.
//
// Frames. World coordinates are part coordinates in mm. Display coordinates are device pixels of the window
// with the origin at the top left and y down, as widgets and pictures have them. Projection is parallel, so
// that the scale bar holds everywhere.
//
// Everything that takes long for a large part or path (arrays, normals, edges) is done by
// prepare_part_display and prepare_path_display on any thread; the Scene takes the finished display and only
// hands it to the graphics card.
#pragma once

#include "core/base/units.h"
#include "core/base/vec.h"
#include "core/setup/motion.h"
#include "core/setup/tool.h"
#include "core/verify/stock_model.h"
#include "viz/deviation_display.h"
#include "viz/palette.h"
#include "viz/part_display.h"
#include "viz/path_display.h"
#include "viz/path_tint.h"
#include "viz/stock_shape.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

class vtkCamera;
class vtkRenderer;
class vtkRenderWindow;

namespace facetmill {

struct StripDisplay; // strip_display.h
using StripDisplayPtr = std::shared_ptr<const StripDisplay>;

/// All have Z up on the screen, but top and bottom, where Y is up. `front` looks along +Y, `right` along -X.
enum class StandardView { iso, front, top, right, rear, bottom, left };

/// "iso", "front", ...: the words of the command line. `view_label` is for menus: "Isometric".
const std::vector<StandardView>& standard_views();
std::string_view view_name(StandardView view);
std::string_view view_label(StandardView view);
/// Throws Error(out_of_range) that names `where` and lists the words.
StandardView parse_view(std::string_view text, const std::string& where);

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

enum class PartStyle { smooth, flat, wire };

/// Level frames around a box, at the heights of layers.
struct LevelMarks {
    Box3 box;
    std::vector<double> heights;
    std::optional<std::size_t> chosen; ///< drawn apart from the others
    bool operator==(const LevelMarks& o) const {
        return box.lo == o.box.lo && box.hi == o.box.hi && heights == o.heights && chosen == o.chosen;
    }
};

struct Marker {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero(); ///< zero: none drawn
};

/// A place where the verification found something.
struct FindingMark {
    enum class Kind { gouge, excess, collision };
    Kind kind = Kind::gouge;
    Vec3 point = Vec3::Zero();
};
inline constexpr std::size_t finding_kinds = 3;
/// The deepest gouges, the places where most is left, and at most a few hundred collisions.
std::vector<FindingMark> finding_marks(const Verification& verification);

/// The surface of the stock in patches, as StockPlayback has them.
using StockPatches = std::vector<std::shared_ptr<const StockPatch>>;

/// Where the camera looks: see `look_at`.
struct CameraPlace {
    Vec3 target = Vec3::Zero(), toward_eye = Vec3::UnitZ(), up = Vec3::UnitY();
    double height = 1; ///< mm in the window
};

/// Where the line of sight through a pixel meets the part first.
struct PartPick {
    Vec3 point;
    Vec3 normal; ///< unit, of the facet, by its winding
    std::size_t facet;
    bool back_side; ///< seen from inside
};

/// The CC or CL nearest to a pixel. `source` counts the paths given to set_path.
struct PathPick {
    std::size_t source = 0;
    Index pass = no_index, point = no_index; ///< no_index for a motion that cuts no CC
    std::size_t motion = std::size_t(-1);    ///< into ToolMotions, when a CL was picked
    bool is_contact = false;                 ///< a CC was picked, not a CL
    Vec3 position;                           ///< the CC or the tool tip
    CutterLocation location;                 ///< the tool that cuts it
};

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
    vtkCamera* camera();

    /// Device pixels per layout pixel: text, lines and margins grow with it. 1 at first.
    void set_pixel_ratio(double ratio);
    void set_palette(Palette palette);
    Palette palette() const;
    /// Unit of the scale bar. Everything else in a Scene is mm.
    void set_unit(LengthUnit unit);
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
    /// What a first picture of something takes long for, the shaders, can be had before it is there: after
    /// `rehearse(k)`, k below `rehearsals`, a frame draws nothing but something small in one of their ways,
    /// whatever layers are shown. It is not to be seen; not between the steps of a picture; `end_rehearsal`
    /// follows.
    static constexpr std::size_t rehearsals = 7;
    void rehearse(std::size_t k);
    void end_rehearsal();
    /// Smooths jagged edges after drawing (FXAA). On at first.
    void set_antialiasing(bool on);

    /// The part; nullptr removes it. The view does not change: call `set_view` or `fit`.
    void set_part(PartDisplayPtr part);
    /// The same, prepared on this thread.
    void set_part(MeshPtr mesh);
    void set_part_style(PartStyle style);
    PartStyle part_style() const;

    /// The uncut stock; nullptr removes it.
    void set_stock_shape(StockShapePtr shape);
    /// A box; an empty one removes the stock.
    void set_stock(const Box3& box);

    /// The cut stock instead of the uncut one, while there is that; empty: the uncut one again. Patches that
    /// are the same objects as before cost nothing, so that a few changed ones can be swapped between two
    /// frames. `detail`, where not empty, is a finer surface of the same stock: drawn in full pictures, while
    /// `patches` serve when the view moves.
    void set_cut_stock(const StockPatches& patches, const StockPatches& detail = {});

    /// nullptr removes it.
    void set_deviation(DeviationDisplayPtr deviation);
    /// Colours anew: some milliseconds for a hundred thousand samples.
    void set_deviation_scale(const DeviationScale& scale);
    const DeviationScale& deviation_scale() const;
    /// What the legend says behind the word "Deviation", such as "out of date".
    void set_deviation_note(const std::string& note);
    void set_findings(const std::vector<FindingMark>& findings);

    /// Layers of roughing; none: nullopt. Shown whatever the layers of the view are.
    void set_levels(const std::optional<LevelMarks>& levels);
    /// Regions of the surface; nullptr removes them.
    void set_strips(StripDisplayPtr strips);
    /// The one, by its place in the list, that stands out.
    void set_strip_chosen(std::optional<std::size_t> strip);
    /// A part of the window that something else stands on, from its upper left to its lower right corner in
    /// layout pixels: labels keep off it. Both the same: none.
    void set_covered(const Vec2& from, const Vec2& to);
    /// Dots on their boundaries that can be picked. Off at first.
    void set_strip_handles(bool on);
    /// The dot nearest to a pixel within `radius` pixels, on the side of the part that is seen.
    std::optional<Vec3> pick_strip_handle(double x, double y, double radius) const;

    /// Paths of one or several operations; an empty display or nullptr removes them.
    void set_path(PathDisplayPtr path);
    /// Colours for the path that was set, instead of those of the kinds of motion, until another path is set;
    /// nullptr: the kinds' again. Their scale stands in the legend.
    void set_path_tint(TintedPathPtr tint);

    /// The tool, or none. Its values must make a cutter (check_tool); throws Error(out_of_range) otherwise.
    void set_tool(const std::optional<Tool>& tool);
    /// Tip and unit axis; the tool is drawn after both a tool and a pose were given.
    void set_tool_pose(const std::optional<CutterLocation>& pose);
    const std::optional<CutterLocation>& tool_pose() const;

    void set_marker(const std::optional<Marker>& marker);
    /// Where the tool that is shown touches the part: dots of the layer `marker`, over everything else.
    void set_touches(const std::vector<Vec3>& points);
    const std::vector<Vec3>& touches() const;

    /// Top left; both lines are shortened in the middle to the width of the window. Bytes that are not UTF-8
    /// and control characters are replaced.
    void set_title(const std::string& title, const std::string& subtitle = {});
    /// Shown in the middle while there is no part, stock or path.
    void set_empty_text(const std::string& text);

    void set_visible(Layer layer, bool on);
    bool visible(Layer layer) const;
    /// True when there is something to show in the layer, visible or not.
    bool has(Layer layer) const;
    /// Motions of one kind in the layer `cl`; all are shown at first.
    void set_motion_visible(MotionKind kind, bool on);
    bool motion_visible(MotionKind kind) const;

    /// Box of what is visible of part, stock and paths; of the tool too when `with_tool`. Empty when nothing
    /// is.
    Box3 bounds(bool with_tool = false) const;
    /// Looks from a standard direction and fits.
    void set_view(StandardView view);
    /// Centres and scales to `bounds` with a margin, keeping the direction.
    void fit(bool with_tool = false);
    /// Zoom by a factor (> 1: nearer) that keeps the world point under the pixel in place.
    void zoom_at(double x, double y, double factor);
    /// Brings a world point to the middle of the window, where the camera turns about it.
    void center_on(const Vec3& point);

    CameraPlace camera_place() const;
    /// The target comes to the middle of the window. `toward_eye` is a unit vector, not along `up`.
    void look_at(const CameraPlace& place);
    /// From where one sees a place of the part well: the direction of now, or where the surface turns away
    /// from it another one from above; at least so near that the window is `height` high.
    CameraPlace place_to_see(const Vec3& point, const Vec3& normal, double height) const;

    /// Needs an attached window with a size. Takes microseconds, whatever the size of the part.
    std::optional<PartPick> pick_part(double x, double y) const;
    /// The nearest CL or CC of the visible layers within `radius` pixels. Among those about equally near, the
    /// one nearest to the eye; points hidden behind the visible part are passed over. Takes about 10 ms for a
    /// million points.
    std::optional<PathPick> pick_path(double x, double y, double radius) const;
    /// Pixel of a world point.
    Vec2 display_of(const Vec3& point) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace facetmill
