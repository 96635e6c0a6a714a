// The tool in a scene, and marks that stand over everything: a picked point, and where the tool touches.
#pragma once

#include "core/setup/motion.h"
#include "core/setup/tool.h"
#include "viz/scene_layer.h"
#include "viz/tool_shape.h"

#include <array>
#include <optional>

namespace facetmill {

struct OverlayContent; // overlay.h

class SceneTool : public SceneLayer {
public:
    explicit SceneTool(SceneStage& stage);

    /// The tool, or none. Its values must make a cutter (check_tool); throws Error(out_of_range) otherwise.
    void set(const std::optional<Tool>& tool);
    /// Tip and unit axis; the tool is drawn after both a tool and a pose were given.
    void set_pose(const std::optional<CutterLocation>& pose);
    const std::optional<CutterLocation>& pose() const { return pose_; }
    /// Empty when there is no tool, no pose or it is not visible.
    Box3 bounds() const;

private:
    bool has(Layer layer) const override;
    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;

    std::optional<ToolShape> shape_;
    std::optional<CutterLocation> pose_;
    std::array<SceneActor, 3> bodies_, rings_; ///< cutter, shank, holder
};

struct Marker {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero(); ///< zero: none drawn
};

class SceneMarks : public SceneLayer {
public:
    using SceneLayer::SceneLayer;

    void set_marker(const std::optional<Marker>& marker) { marker_ = marker; }
    /// Where the tool that is shown touches the part.
    void set_touches(const std::vector<Vec3>& points) { touches_ = points; }
    const std::vector<Vec3>& touches() const { return touches_; }

    void add_to(OverlayContent& content) const;

private:
    bool has(Layer layer) const override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;

    std::optional<Marker> marker_;
    std::vector<Vec3> touches_;
};

} // namespace facetmill
