// The configuration space of one contact point as a box to look into: its two surfaces and the free volume
// between them over inclination and yaw, as triangles with colours. No VTK.
//
// Box coordinates: x the inclination lambda, y the yaw omega, z the lift delta. The longer of the two
// angular ranges is 1 long, the other one in proportion but not below 0.45; the lift from 0 to `delta_max` is
// 0.6 high. Below it, at `floor`, lies a map of the postures in the colours of what blocks them.
#pragma once

#include "core/base/units.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "viz/palette.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

/// Number of PostureBlock's enumerators.
inline constexpr std::size_t posture_blocks = 7;
/// "Free", "Cutter, near the contact" ...: for legends.
const char* posture_block_label(PostureBlock block);
Rgb posture_block_color(PostureBlock block);
Rgb cspace_top_color();

/// CM2, local, global, and what the operation was planned with.
inline constexpr std::size_t cspace_choices = 4;
const char* cspace_choice_label(std::size_t choice);
Rgb cspace_choice_color(std::size_t choice);

/// What the display shows of a point. Radians and mm.
struct CSpaceContent {
    PostureGrid grid;
    std::vector<double> bottom, top; ///< per node, as in CSpace
    std::vector<PostureBlock> block;
    std::array<ChosenPosture, cspace_choices> choices;
    std::size_t free_nodes = 0;

    static CSpaceContent of(const FiveAxisStudy::Point& point);
};

/// Separate triangles: 9 numbers and a colour (RGBA) each.
struct CSpaceTriangles {
    std::vector<float> points;
    std::vector<std::uint8_t> colors;
    std::size_t size() const { return points.size() / 9; }
    void add(const Vec3& a, const Vec3& b, const Vec3& c, const Rgb& color, double alpha = 1);
};
/// Separate segments: 6 numbers each.
using CSpaceSegments = std::vector<float>;

struct CSpaceDisplay {
    static constexpr double height = 0.6, floor = -0.16;

    /// `content` with at least one node; the height of the box from its lifts, a round number in `unit`.
    CSpaceDisplay(const CSpaceContent& content, LengthUnit unit);

    Vec3 size = Vec3(1, 1, height);
    double delta_max = 1;   ///< mm
    CSpaceTriangles bottom; ///< S2, in the colours of what blocks
    CSpaceTriangles volume; ///< S1 and the walls of the free volume, translucent
    CSpaceTriangles map;    ///< on the floor
    CSpaceSegments bottom_lines, top_lines;
    std::vector<double> lead_ticks, yaw_ticks; ///< radians
    std::vector<double> delta_ticks;           ///< mm

    /// Lifts above the box stand at its top.
    Vec3 place(const PostureValue& posture) const;
    PostureValue value(const Vec3& place) const;

    /// Where a line of sight meets the volume, S2 or the map first; of the map delta is 0.
    struct Hit {
        PostureValue posture;
        enum class On { volume, bottom, map } on = On::map;
    };
    std::optional<Hit> hit(const Vec3& from, const Vec3& direction) const;

private:
    struct Builder;
    double lead_lo_ = 0, lead_hi_ = 0, yaw_lo_ = 0, yaw_hi_ = 0;
};

} // namespace facetmill
