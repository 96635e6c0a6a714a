// What the verifier is given: the stock before the first motion, tools, and their motions. It knows nothing
// of how the motions came about: this room includes the mesh, the cutter's profile and the plain records of
// tools and motions, and shares no geometry with the planners. Millimetres, radians, part coordinates.
#pragma once

#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"
#include "core/setup/fixture.h"
#include "core/setup/kinematics.h"
#include "core/setup/machine.h"
#include "core/setup/motion.h"
#include "core/setup/stock_solid.h"
#include "core/setup/tool.h"
#include "core/setup/turning_axis.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

/// A cylinder on the tool's axis that does not cut.
struct ToolSection {
    enum class Part : std::uint8_t { shank, holder };
    Part part = Part::shank;
    double radius = 0, from = 0, to = 0; ///< mm; `from` and `to` are heights above the tip
};

struct VerifyTool {
    CutterProfile cutter;
    std::vector<ToolSection> sections; ///< from the flutes upward

    explicit VerifyTool(const Tool& tool);
    /// The tool of a CL file, which knows of no shank and no holder.
    explicit VerifyTool(const AptCutter& apt) : cutter(apt) {}
};

/// One operation; programs are given in the order of machining. Motion i goes from where motion i - 1 ended
/// to its own location; where the tool was before the first motion is not known, so only its end counts. GOTO
/// numbers count the motions from 1.
struct VerifyProgram {
    std::string name;
    VerifyTool tool;
    std::shared_ptr<const ToolMotions> motions;
    /// Set where the part turns (lathe-mill): between two locations the tool turns about this axis at a
    /// constant rate, and moves along it and towards it in proportion. Without it the tip moves straight and
    /// the tool axis turns in one plane.
    std::optional<TurningAxis> turning;
    /// The line of the program file that each motion comes from; empty where there is no such file.
    std::vector<std::uint32_t> lines;
    /// The machine that runs it; null: not known, and what its joints do between locations is not asked.
    std::shared_ptr<const Machine> machine = nullptr;
    /// How its joints stand at the end of each motion, as posts write them (joint_course.h); null: as they
    /// stand best, wherever the part is on the machine.
    std::shared_ptr<const std::vector<Joints>> joints = nullptr;
    /// What holds the part meanwhile, in the coordinates of the motions; null: nothing that is known.
    std::shared_ptr<const std::vector<FixtureSolid>> fixtures = nullptr;
    /// Whether the operation is to cut at a place of the part; empty: everywhere. Only a reason why surface
    /// stays uncut is made of it.
    std::function<bool(const Vec3&)> asked = nullptr;
    /// From the machine's coordinates to those of the motions, where a program is judged together with those
    /// of another setup.
    Mat3 machine_turn = Mat3::Identity();
    /// What its operation may leave on the part, mm: one that roughs would not finish where its tool fits.
    /// Only a reason why surface stays uncut is made of it.
    double leaves = 0;
    /// The cutter before it, of an operation that cuts no more than this cannot enter: what stands where it
    /// fits is for the operation that it belongs to. Only a reason why surface stays uncut is made of it.
    std::optional<AptCutter> beyond = {};
    /// The one axis from which its operation looks at the part, where the tool leans for no other reason than
    /// to keep shank and holder clear: what only a leaning tool sees is not asked for. None: all axes of its
    /// motions.
    std::optional<Vec3> seen_along = {};
    /// The feed of each motion, mm/min; empty: all at `feed`, of which 0 says that it is not known. For loads
    /// alone.
    std::vector<double> feeds = {};
    double feed = 0;
    double feed_of(std::size_t motion) const { return feeds.empty() ? feed : feeds[motion]; }
};

/// How the tool axis may go from one location to the next; the tip moves straight.
enum class AxisCourse : std::uint8_t {
    great_circle,      ///< turns evenly in one plane
    normalized_linear, ///< its end moves straight: in the same plane, slower at the ends
    joint_linear,      ///< the machine's rotary axes turn evenly
};

/// A motion of one of several programs; both count from 0.
struct MotionPlace {
    std::size_t program = std::size_t(-1), motion = std::size_t(-1);
    AxisCourse course = AxisCourse::great_circle; ///< on which it was so
    bool known() const { return program != std::size_t(-1); }
    bool operator==(const MotionPlace&) const = default;
};

} // namespace facetmill
