// What the verifier is given: the stock before the first motion, tools, and their motions. It knows nothing
// of how the motions came about: this room includes the mesh, the cutter's profile and the plain records of
// tools and motions, and shares no geometry with the planners. Millimetres, radians, part coordinates.
#pragma once

#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"
#include "core/setup/motion.h"
#include "core/setup/stock_solid.h"
#include "core/setup/tool.h"
#include "core/setup/turning_axis.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

/// A cylinder on the tool's axis that does not cut.
struct ToolSection {
    enum class Part : std::uint8_t { shank, holder };
    Part part = Part::shank;
    double radius = 0, from = 0, to = 0; ///< heights above the tip
};

struct VerifyTool {
    CutterProfile cutter;
    std::vector<ToolSection> sections; ///< from the flutes upward

    explicit VerifyTool(const Tool& tool);
    /// Of a CL file, which knows of no shank and no holder.
    explicit VerifyTool(const AptCutter& apt) : cutter(apt) {}
};

/// One operation, in machining order. Motion i goes from the location of motion i - 1 to its own; of the
/// first only the end counts. GOTO numbers are those of motions, from 1.
struct VerifyProgram {
    std::string name;
    VerifyTool tool;
    std::shared_ptr<const ToolMotions> motions;
    /// A part that turns (lathe-mill): between CL points the tool turns about this axis at a constant rate,
    /// and moves along it and towards it in proportion. Else the tip moves straight and the axis turns in one
    /// plane.
    std::optional<TurningAxis> turning;
};

/// A motion of one of several programs; both count from 0.
struct MotionPlace {
    std::size_t program = std::size_t(-1), motion = std::size_t(-1);
    bool known() const { return program != std::size_t(-1); }
    bool operator==(const MotionPlace&) const = default;
};

} // namespace facetmill
