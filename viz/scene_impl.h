// Inside of Scene; included by scene*.cpp only.
#pragma once

#include "viz/overlay.h"
#include "viz/scene.h"
#include "viz/strip_display.h"
#include "viz/tool_shape.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

namespace facetmill {

/// An actor with its mapper, hidden until it has data. The arrays behind the data belong to whoever made
/// them.
struct SceneActor {
    vtkNew<vtkActor> actor;
    vtkNew<vtkPolyDataMapper> mapper;
    bool filled = false;

    SceneActor();
    void set_data(vtkPolyData* data, const Vec3& center);
    void clear();
    /// Property, colours of points and place before or behind the surface are those of another.
    void look_like(SceneActor& other);
    /// Triangles, line segments and dots; only of an actor that has data.
    std::size_t elements() const;
};

/// Triangles of a large part in one actor, and about what one step of a picture draws: some 10 ms without a
/// graphics card.
inline constexpr std::size_t elements_in_piece = 30'000;

struct Scene::Impl {
    Impl();
    ~Impl();

    void apply_palette();
    void apply_visibility();
    void apply_line_widths();
    void apply_part_style();
    void place_tool();
    void update_frame(); ///< before every frame
    /// Splits among `first`, which must have its looks already, and as many more actors as it takes.
    void set_pieces(SceneActor& first, std::vector<std::unique_ptr<SceneActor>>& more,
                    const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, const Vec3& center);
    /// What the steps of a picture draw before the last one: visible actors with many cells.
    std::vector<std::vector<SceneActor*>> heavy_groups();
    void set_clipping_range(); ///< from what is visible
    void show_step();          ///< hides what the present step leaves out of what is shown
    void forget_steps();       ///< before actors go that they name
    void show_rehearsal();     ///< nothing but the rehearsal's actors
    /// All that is light; then the smoothing, for which what it smooths must be drawn; then what is flat on
    /// top of it.
    bool light_step() const { return !step || *step == step_groups.size(); }
    bool smoothing_step() const { return !step || *step == step_groups.size() + 1; }
    bool last_step() const { return !step || *step == last_step_of_all(); }
    std::size_t last_step_of_all() const { return step_groups.size() + 2; }
    OverlayContent overlay_content() const;
    std::vector<LegendEntry> legend() const;
    bool shows_content() const;
    bool shows_cut_stock() const;
    bool shows_deviation() const;
    std::vector<ColorBar> color_bars() const; ///< for what is shown, the one to be kept first
    /// True when some patch has a surface. `old` are the patches the actors have now.
    bool swap_patches(const StockPatches& patches, const StockPatches& old,
                      std::vector<std::unique_ptr<SceneActor>>& actors);
    bool shows_strips() const;
    void color_strips();
    void add_strip_legend(std::vector<LegendEntry>& entries) const;
    /// Labels of the strips, where they stand over nothing of what is laid out.
    std::vector<OverlayNote> strip_notes(const OverlayLayout& layout) const;
    /// The scale's colours on all deviation actors.
    void color_deviation();
    bool shows_back() const; ///< part of the surface turns its back to the eye
    Vec2 display_of(const Vec3& point) const;
    Box3 tool_bounds() const;

    /// Device pixels of the window; {0, 0} when there is none.
    Eigen::Vector2i window_size() const;
    /// Axes of the camera: right, up, towards the eye; unit.
    Mat3 camera_frame() const;
    /// mm per device pixel.
    double pixel_size() const;
    /// World point in the camera's plane through the focal point under a pixel.
    Vec3 point_at(double x, double y) const;

    vtkNew<vtkRenderer> renderer, axes_renderer;
    vtkNew<vtkCallbackCommand> frame_callback;
    vtkWeakPointer<vtkRenderWindow> window;
    std::unique_ptr<Overlay> overlay;

    Palette palette = Palette::light;
    LengthUnit unit = LengthUnit::mm;
    double ratio = 1;
    bool moving = false, antialiasing = true;
    std::optional<std::size_t> step;
    std::vector<std::vector<SceneActor*>> step_groups; ///< steps of the picture that is being drawn
    std::size_t first_step =
        0; ///< begins the picture; the ones before only bring points to the graphics card
    bool rehearsing = false, all_overlay = false; ///< for the shaders, not to be shown
    std::vector<std::unique_ptr<SceneActor>> rehearsal;
    std::vector<float> rehearsal_points; ///< behind the actors' data
    bool part_is_new = false;            ///< since the last picture in steps
    PartStyle part_style = PartStyle::smooth;
    std::string title, subtitle, empty_text = "Nothing to show";
    std::vector<bool> layer_on;
    std::array<bool, motion_kinds> motion_on{};

    PartDisplayPtr part;
    Box3 stock;
    StockShapePtr stock_shape; ///< behind the actors' data
    StockPatches cut_stock, cut_detail;
    DeviationDisplayPtr deviation;
    DeviationScale deviation_scale;
    std::string deviation_note;
    std::vector<FindingMark> findings;
    StripDisplayPtr strips;
    std::optional<std::size_t> chosen_strip;
    bool handles_on = false;
    LayoutRect covered; ///< where a widget lies over the window
    PathDisplayPtr path;
    TintedPathPtr tint;
    std::optional<ToolShape> tool;
    std::optional<CutterLocation> pose;
    std::optional<Marker> marker;
    std::vector<Vec3> touches;
    std::optional<LevelMarks> levels;
    std::array<std::vector<float>, 2> level_points; ///< behind the actors' data
    std::array<std::vector<std::int32_t>, 2> level_segments;

    SceneActor part_surface, part_lines, part_edges, part_preview;
    std::vector<std::unique_ptr<SceneActor>> more_surface, more_edges; ///< further pieces of a large part
    SceneActor stock_faces, stock_lines;
    std::array<SceneActor, 2> level_lines; ///< the others, the chosen one
    /// By the patches' numbers; null: no surface.
    std::vector<std::unique_ptr<SceneActor>> cut_patches, detail_patches;
    vtkNew<vtkProperty> cut_look;
    bool has_cut = false, has_detail = false; ///< some patch has a surface
    SceneActor deviation_surface, deviation_preview;
    std::vector<std::unique_ptr<SceneActor>> more_deviation;
    std::vector<vtkSmartPointer<vtkPolyData>> deviation_data;
    std::vector<std::uint8_t> deviation_rgba, deviation_preview_rgba; ///< behind the actors' data
    std::array<SceneActor, finding_kinds> finding_dots;
    std::array<std::vector<float>, finding_kinds> finding_points;
    std::vector<std::unique_ptr<SceneActor>> strip_bands, strip_lines, strip_handles; ///< one each per strip
    SceneActor contact_lines, contact_dots, contact_preview, left_dots, kept_dots;
    std::array<SceneActor, motion_kinds> motion_lines, motion_preview;
    std::array<SceneActor, motion_kinds> tint_lines, tint_preview; ///< stand for them where they have data
    std::array<SceneActor, 3> tool_bodies, tool_rings;             ///< cutter, shank, holder
    std::array<SceneActor, 3> axes;
    std::array<RevolvedShape, 3> axis_shapes;
};

} // namespace facetmill
