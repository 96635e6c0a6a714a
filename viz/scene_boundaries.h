// Boundaries of operations in a scene: their facets, or what lies in them, tinted on the part, closed curves
// drawn on it as lines.
#pragma once

#include "viz/part_display.h"
#include "viz/scene_layer.h"

#include <array>
#include <memory>
#include <vector>

namespace facetmill {

class ScenePart;

/// What a boundary that is shown is for.
enum class BoundaryRole {
    within,
    avoided,
    steep,   ///< no boundary: the side of an operation's divide that is cut by levels
    shallow, ///< the other side
};
inline constexpr std::size_t boundary_roles = 4;

class SceneBoundaries : public SceneLayer {
public:
    SceneBoundaries(SceneStage& stage, const ScenePart& part);
    ~SceneBoundaries() override;

    /// One mark for each facet of the part that the scene has; others than so many: nothing is tinted.
    /// `area`: what lies in it where that is not whole facets; the marks are for a coarse picture then.
    void set(BoundaryRole role, std::vector<char> marks, PartDisplayPtr area = nullptr);
    /// Corners of a curve, drawn where it lies on the part looked at along Z; none: no curve. A closed one
    /// goes on from the last to the first.
    void set_curve(BoundaryRole role, const std::vector<Vec3>& corners, bool closed);
    /// Some facets of the boundary within were taken in, or out. Takes as long as they are many.
    void paint(const std::vector<Index>& facets, bool in);

    /// The part is shown with its tints even where deviations or the cut stock would stand for it.
    void set_foremost(bool foremost) { foremost_ = foremost; }
    bool foremost() const { return foremost_; }

    /// Before a whole picture: what was painted comes to the rest.
    void settle();
    /// What was painted since the last picture, alone, to be drawn over that picture. False: nothing was.
    bool begin_added();
    void end_added();
    bool shows_added() const { return adding_; }
    void hide_others() const;

private:
    /// The tinted facets of a run of the part's, with what is behind the actor.
    struct Piece {
        std::vector<std::int32_t> triangles;
        SceneActor actor;
        bool stale = true;
    };
    struct Tint {
        std::vector<char> marks;
        std::size_t count = 0; ///< of those in
        std::vector<std::unique_ptr<Piece>> pieces;
        Piece coarse; ///< while the view moves: a large part is drawn coarsely then
        std::vector<float> curve;
        std::vector<std::int32_t> segments;
        std::vector<float> corners;
        SceneActor line, dots;
        PartDisplayPtr area;
        SceneActor area_actor;
    };

    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    void add_known(KnownBoxes& known) const override;
    void add_heavy(HeavyActors& heavy) override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;
    bool fits(const Tint& tint) const;
    const Tint& tint_of(BoundaryRole role) const { return tints_[std::size_t(role)]; }
    bool divided() const;
    bool tinted(std::size_t role, std::size_t facet) const;
    void divide_anew();
    void look(SceneActor& actor, std::size_t role);
    void fill(Piece& piece, const std::vector<Index>& facets);
    void fill_coarse(std::size_t role);
    Vec3 draped(const Vec3& place) const;

    const ScenePart& part_;
    PartDisplayPtr display_; ///< whose points the actors refer to
    std::array<Tint, boundary_roles> tints_;
    std::vector<Index> added_; ///< painted since the last picture
    Piece added_in_, added_out_;
    bool adding_ = false, foremost_ = false;
};

} // namespace facetmill
