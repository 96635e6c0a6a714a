// Tool paths in a scene: cutter contacts, motions by their kind, or in the colours of a quantity.
#pragma once

#include "core/setup/motion.h"
#include "viz/path_display.h"
#include "viz/path_tint.h"
#include "viz/scene_layer.h"

#include <array>
#include <optional>

namespace facetmill {

class ScenePart;

/// The CC or CL nearest to a pixel. `source` counts the paths given to `ScenePaths::set`.
struct PathPick {
    std::size_t source = 0;
    Index pass = no_index, point = no_index; ///< no_index for a motion that cuts no CC
    std::size_t motion = std::size_t(-1);    ///< into ToolMotions, when a CL was picked
    bool is_contact = false;                 ///< a CC was picked, not a CL
    Vec3 position;                           ///< the CC or the tool tip
    CutterLocation location;                 ///< the tool that cuts it
};

class ScenePaths : public SceneLayer {
public:
    ScenePaths(SceneStage& stage, const ScenePart& part);

    /// Paths of one or several operations; an empty display or nullptr removes them.
    void set(PathDisplayPtr path);
    /// Colours for the path that was set, instead of those of the kinds of motion, until another path is set;
    /// nullptr: the kinds' again. Their scale stands in the legend.
    void set_tint(TintedPathPtr tint);
    /// Motions of one kind in the layer `cl`; all are shown at first.
    void set_visible(MotionKind kind, bool on);
    bool visible(MotionKind kind) const;

    bool empty() const { return !path_ || path_->box.empty(); }
    /// The nearest CL or CC of the visible layers within `radius` pixels. Among those about equally near, the
    /// one nearest to the eye; points hidden behind the visible part are passed over. Takes about 10 ms for a
    /// million points.
    std::optional<PathPick> pick(double x, double y, double radius) const;

private:
    struct Candidate;

    bool has(Layer layer) const override;
    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    void prepare_frame() override;
    bool has_preview() const override;
    void add_bounds(Box3& box) const override;
    void add_heavy(HeavyActors& heavy) override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;
    void add_color_bars(std::vector<ColorBar>& bars, ShownSurface shown) const override;
    std::vector<Candidate> candidates(double x, double y, double radius) const;
    PathPick pick_of(const Candidate& candidate) const;
    bool moves(MotionKind kind) const; ///< some in the kind's colour are shown

    const ScenePart& part_;
    PathDisplayPtr path_;
    TintedPathPtr tint_;
    std::array<bool, motion_kinds> on_{};
    SceneActor contact_lines_, contact_dots_, contact_preview_, left_dots_, kept_dots_;
    std::array<SceneActor, motion_kinds> lines_, preview_;
    std::array<SceneActor, motion_kinds> tint_lines_, tint_preview_; ///< stand for them where they have data
};

} // namespace facetmill
