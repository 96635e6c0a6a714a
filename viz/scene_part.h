// The part in a scene: its surface, sharp and open edges, facet edges.
#pragma once

#include "viz/part_display.h"
#include "viz/scene_layer.h"

#include <functional>
#include <optional>

namespace facetmill {

enum class PartStyle { smooth, flat, wire };

/// Where the line of sight through a pixel meets the part first.
struct PartPick {
    Vec3 point;
    Vec3 normal; ///< unit, of the facet, by its winding
    std::size_t facet;
    bool back_side; ///< seen from inside
};

class ScenePart : public SceneLayer {
public:
    explicit ScenePart(SceneStage& stage);

    /// nullptr removes it. The view does not change: call `set_view` or `fit` of the scene.
    void set(PartDisplayPtr part);
    /// The same, prepared on this thread.
    void set(MeshPtr mesh);
    /// Drawn at turn * p + move for every place p of it until another part is there; where it is picked
    /// stays.
    void set_pose(const Mat3& turn, const Vec3& move);
    void set_style(PartStyle style);
    PartStyle style() const { return style_; }

    /// Needs an attached window with a size. Takes microseconds, whatever the size of the part.
    std::optional<PartPick> pick(double x, double y) const;
    /// The part is between the eye and a place. A place on the surface is seen although the facets around it
    /// lie a little before it.
    bool hides(const Vec3& place) const;
    /// Facets that lie wholly within a rectangle of the window, device pixels from its upper left to its
    /// lower right corner, ascending; unless `through`, those alone whose middle is seen.
    using FacetSearch = std::function<std::vector<Index>(const Progress&)>;
    /// As they are seen now, whatever becomes of the view until the search is called, in any thread.
    FacetSearch facets_in(const Vec2& from, const Vec2& to, bool through) const;
    /// As it is drawn; null without a part.
    const PartDisplayPtr& display() const { return part_; }
    /// All of it or, of a large one, a piece: how it looks, and the points that all pieces share.
    const SceneActor& surface() const { return surface_.first; }
    /// Is there and seen as a surface.
    bool covers() const;
    /// The lines, once after a new part. The points of a large one take as long as several steps to get to
    /// the graphics card, and their normals too: the lines bring the one, the first piece of the surface the
    /// other.
    SceneActor* lines_of_new();

private:
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
    Box3 posed_box() const;
    bool shows_back(ShownSurface shown) const; ///< part of the surface turns its back to the eye

    PartDisplayPtr part_;
    Mat3 turn_ = Mat3::Identity(); ///< see set_pose
    Vec3 move_ = Vec3::Zero();
    PartStyle style_ = PartStyle::smooth;
    bool is_new_ = false; ///< since the last picture in steps
    ScenePieces surface_, edges_;
    SceneActor lines_, preview_;
};

} // namespace facetmill
