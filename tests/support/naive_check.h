// A second opinion on programs of any machine, by brute force: it shares nothing with the verifier and
// nothing with the planners. It knows the part's facets, the cutter's outline, and where the tool is at
// densely interpolated poses; its only help is a grid of squares.
//
//   gouge   how deep a sample of the part's surface comes to lie inside a cutter (distance to its outline)
//   touch   how deep a point of what is left of the stock comes to lie inside a shank or holder
//   uncut   the line from a sample outward, walked in small steps, meets remaining material that is farther
//           than twice the tolerance from all of the part before it comes to where something was cut
//
// Outward is the side from which a tool axis sees the sample, so winding is of no account; where all facets
// are wound alike, that side of all of them of which more is seen.
#pragma once

#include "core/base/progress.h"
#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"
#include "core/setup/motion.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace facetmill::test {

/// A cylinder on the tool's axis that cuts nothing: shank or holder, between heights above the tip.
struct NaiveBarrel {
    double radius = 0, from = 0, to = 0;
};

struct NaiveProgram {
    AptCutter cutter;
    std::vector<Motion> motions;
    std::vector<NaiveBarrel> barrels = {};
    std::optional<TurningAxis> turning = {}; ///< where the part turns between locations
};

/// How the axis turns between two locations; the tip always moves straight.
enum class AxisCourse : std::uint8_t { great_circle, normalized_linear };

struct NaiveOptions {
    double spacing = 0.5;   ///< of samples, mm
    double tolerance = 0.1; ///< more than twice of it is uncut
    Box3 stock;
    int round_axis =
        -1; ///< the stock is a cylinder along this coordinate axis about its box's middle; -1: a block
    double stock_radius = 0;   ///< of a cylinder
    double pose_share = 0.025; ///< between poses no point of the cutter moves farther than this of its radius
    AxisCourse course = AxisCourse::great_circle;
};

struct NaiveSample {
    Vec3 point, normal;  ///< normal: towards the side that is seen, else as wound
    double weight = 0;   ///< mm^2; 0 on edges, which are looked at for gouges only
    bool to_cut = false; ///< a tool axis sees it, and no open border is near
    double depth = 0;    ///< deepest inside a cutter, >= 0
    bool uncut = false;
};

struct NaiveResult {
    std::vector<NaiveSample> samples;
    std::size_t poses = 0;
    double gouge_max = 0;
    Vec3 gouge_at = Vec3::Zero();
    std::vector<double> program_gouges;
    double area_to_cut = 0, uncut_area = 0;
    double uncut_share() const { return area_to_cut > 0 ? uncut_area / area_to_cut : 0; }
    /// Length of motions at feed, and of those pieces of it where the cutter is farther than a quarter of its
    /// radius from the part and from what is left of the stock.
    double feed_length = 0, air_length = 0;
    std::array<double, 5> feed_by_kind{}, air_by_kind{}; ///< the same by MotionKind
    std::vector<double> program_feed, program_air;       ///< and by program
    /// Deepest point of the stock inside a shank or holder, of points a quarter of the smallest radius apart:
    /// what is shallower than a fiftieth of the radius, or falls between the points, is not seen.
    double touch_max = 0;
    Vec3 touch_at = Vec3::Zero();
    std::size_t touch_program = 0, touch_motion = 0;
};

NaiveResult naive_check(const Mesh& part, std::span<const NaiveProgram> programs, const NaiveOptions& options,
                        const Progress& progress = Progress());

} // namespace facetmill::test
