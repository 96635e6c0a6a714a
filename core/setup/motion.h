// Where a tool is, and how it moves: the plain data that planners make, links join, programs write and the
// verifier judges. Nothing here computes anything, so the verifier can read what the planners made and yet
// share no geometry with them. Millimetres, part coordinates.
//
// CC, cutter contact: the point of the part's surface that the cutter is to cut, with the surface's unit
// normal there.
// CL, cutter location: the tool tip and the unit tool axis (tip towards spindle) that cut it.
#pragma once

#include "core/base/vec.h"
#include "core/mesh/mesh.h"
#include "core/setup/turning_axis.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace facetmill {

struct CutterContact {
    Vec3 point, normal;
};

struct CutterLocation {
    Vec3 tip, axis;
};

enum class MotionKind : std::uint8_t {
    rapid,    ///< clearance move, never in contact
    approach, ///< down to the part at feed
    cut,
    link,    ///< between cuts at feed, on or just above the surface
    retract, ///< away from the part at feed
};

struct Motion {
    MotionKind kind = MotionKind::rapid;
    CutterLocation to;
    Index pass = no_index; ///< pass that `to` belongs to, and below its CC point; no_index: none
    Index point = no_index;
};

/// The complete motion of the tool for one operation: cuts joined by links and clearance moves. Every motion
/// starts where the one before ended.
struct ToolMotions {
    /// The first is a rapid to the start: nothing is known of where the tool was before.
    std::vector<Motion> motions;
    double clearance_z = 0;
    double air_length = 0; ///< length of the motions at feed that cut nothing, mm; roughing only
    /// Set where the part turns: motions between locations whose axes differ run as TurningAxis says. Without
    /// it the tip moves straight and the axis turns in one plane.
    std::optional<TurningAxis> turning;
};

} // namespace facetmill
