// The configuration space of one contact point: which postures (lead, yaw) and lifts delta leave a part
// neither gouged nor uncut there (Lu 3.5.5). Over a grid of postures it lies between two surfaces,
//
//   bottom (S2)  the least lift at which cutter, shank and holder cut nothing of the part, and
//   top (S1)     the largest lift at which the strip beside the pass is cleared to within the tolerance,
//
// and is empty at a posture where the bottom is above the top. Frames and angles: contact_frame.h.
//
// The bottom is the axial lift of the whole tool (core/gouge/tool_lift.h), because delta is along the tool's
// axis.
//
// The top. A strip boundary is a curve on the part that this pass and its neighbour share; raised by the
// tolerance along the normals it is the *raised curve*, and the cusp is low enough where the tool's sweep
// reaches it everywhere. One pose reaches it if it holds one point of it. That is enough: the poses of a pass
// follow each other continuously, so do the points of the raised curve that they hold, and together they hold
// all of it. So the top is the highest delta at which the pose holds a point of every raised curve: the
// smallest over the curves of the axial lift of the curve over the cutter's lower surface
// (core/gouge/curve_lift.h). It may be negative: then even the pose that touches leaves too much.
//
// For a stock allowance, build the ToolLift with that clearance and put the frame's point that much above the
// part.
#pragma once

#include "core/base/progress.h"
#include "core/cspace/contact_frame.h"
#include "core/gouge/curve_lift.h"
#include "core/gouge/tool_lift.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

class Kinematics;

/// Points of the part that this pass has to clear, each raised by the tolerance along its normal; in order,
/// roughly along the feed. One point is a curve.
using RaisedCurve = std::vector<Vec3>;

/// Why a posture is not free: the first cause that applies, in the order of core/cspace/README.md.
enum class PostureBlock : std::uint8_t {
    free,    ///< bottom <= top, and the machine can hold it
    local,   ///< bottom > top: the part within local_radius of the contact point stops the cutter
    global,  ///< the same, the part elsewhere
    shank,   ///< the same for the shank; or the cutter leans so far that it cannot touch (can_touch)
    holder,  ///< the same for the holder
    lift,    ///< top < 0: even the tool that touches leaves more than the tolerance at a strip boundary
    machine, ///< free of the part, but beyond what the machine's axes can do at the bottom
};
/// "free", "local", "global", "shank", "holder", "lift", "machine".
const char* posture_block_name(PostureBlock block);

struct CSpaceInput {
    const ToolLift* lift = nullptr;         ///< cutter, shank and holder over the mesh; required
    const PostureGrid* grid = nullptr;      ///< required for `build`
    const Kinematics* kinematics = nullptr; ///< none: a machine without limits
    double lowest_axis_z = -1;              ///< no tool axis with a smaller z is held, by any machine
    /// What counts as near the contact point, mm. With the cutter's diameter all that lies under an upright
    /// flat end is local.
    double local_radius = 0;
    /// Height of the flutes, mm: above it the cutter removes nothing; 0: the cutter's own height.
    double height = 0;
    /// False: where the top is below 0 (`lift`) the bottom is not looked for and stays 0. Enough for choosing
    /// postures, in a fraction of the time.
    bool bottom_everywhere = true;
    /// False: tops below 0 are any number below 0, as the choice of the best path does not ask for them.
    bool low_tops = true;
};

/// Surfaces and causes per node of the grid (PostureGrid::node), mm. Where the cutter cannot touch
/// (can_touch), bottom is +inf and top -inf.
struct CSpace {
    ContactFrame frame;
    std::vector<double> bottom; ///< S2 >= 0
    std::vector<double> top; ///< S1: +inf without raised curves, -inf where one is out of the cutter's reach
    std::vector<PostureBlock> block;
};

/// Safe to use from many threads at once. What the input points to has to live as long as the builder.
class CSpaceBuilder {
public:
    /// Throws Error(internal) when there is no ToolLift, Error(out_of_range) for a negative height or radius.
    explicit CSpaceBuilder(const CSpaceInput& input);

    const CSpaceInput& input() const { return input_; }

    /// Whether the machine can hold a pose whose axis is not too low.
    bool holds(const ToolPose& pose) const;
    bool holds(const ContactFrame& frame, const PostureValue& posture) const {
        return holds(posture_pose(input_.lift->cutter(), frame, posture));
    }

    /// Any posture, also between nodes, without allocation; the values of `build`.
    /// The bottom is exact up to `enough`, and where it is above that any number between the two.
    double bottom(const ContactFrame& frame, double lead, double yaw, ToolLift::Hint& hint,
                  double enough = infinity) const;
    /// Below 0 where the posture leaves more than it may at one of the curves.
    double top(const ContactFrame& frame, double lead, double yaw, std::span<const RaisedCurve> curves) const;
    /// The same for any pose and one curve: the exact value up to `enough`, any number between it and that
    /// above. -inf where the cutter cannot touch with this lead.
    double top(const ToolPose& pose, double lead, const RaisedCurve& curve, CurveLift::Hint& hint,
               double enough) const;
    /// Whether that is `level` or higher; sooner than the value.
    bool reaches(const ToolPose& pose, double lead, const RaisedCurve& curve, CurveLift::Hint& hint,
                 double level) const;
    /// Whether the top of a pose is `level` or higher.
    bool reaches(const ToolPose& pose, std::span<const RaisedCurve> curves, double level) const;

    /// What makes the next of similar postures at a contact point faster.
    struct Hints {
        ToolLift::Hint bottom;
        std::vector<CurveLift::Hint> top;
    };
    /// A posture lifted as little as cuts nothing, and the top there.
    struct Free {
        PostureValue posture;
        double top = 0;
    };
    /// Nothing where that is not free.
    std::optional<Free> free(const ContactFrame& frame, double lead, double yaw,
                             std::span<const RaisedCurve> curves, Hints& hints) const;

    /// The whole space of one contact point. Needs input().grid.
    CSpace build(const ContactFrame& frame, std::span<const RaisedCurve> curves,
                 const Progress& progress = Progress()) const;

    /// Processor time, s, added up over the threads.
    struct Stages {
        double bottom = 0, top = 0;
    };
    /// Many contact points, each with its curves, in parallel. Throws Error(internal) when the spans differ
    /// in length. `stages`, if given, is added to.
    std::vector<CSpace> build(std::span<const ContactFrame> frames,
                              std::span<const std::vector<RaisedCurve>> curves, const Progress& progress,
                              Stages* stages = nullptr) const;

    /// One posture, and what stops it: `contact` is where the tool has to be lifted off above delta = 0; its
    /// body is none where nothing stops it.
    struct Reason {
        PostureBlock block = PostureBlock::free;
        double bottom = 0, top = 0;
        ToolContact contact;
    };
    Reason reason(const ContactFrame& frame, double lead, double yaw,
                  std::span<const RaisedCurve> curves) const;

private:
    PostureBlock judge(const Reason& reason, const ToolPose& pose, const ContactFrame& frame) const;
    struct GridTerms;
    Stages fill(CSpace& space, std::span<const RaisedCurve> curves, const Progress& progress) const;
    void fill_top(CSpace& space, const GridTerms& terms, std::span<const RaisedCurve> curves,
                  const Progress& progress) const;
    void fill_bottom(CSpace& space, const GridTerms& terms, const Progress& progress) const;
    void judge_patch(CSpace& space, std::span<const std::size_t> nodes, std::span<const ToolPose> poses,
                     ToolLift::Hint& hint, ToolLift::Group& group) const;

    CSpaceInput input_;
    CurveLift curve_;
};

} // namespace facetmill
