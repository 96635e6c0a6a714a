// A whole tool (cutter, shank, holder) at any posture over a mesh: how far it must retreat along its own axis
// so that it cuts nothing, and whether it does at all. The bottom surface of the configuration space (Lu
// 3.5.5.1, with the lift along the tool axis as in 3.8 and 3.87), and the test of a pose.
//
// Lifts have the meaning of axial_lift.h: the tool comes down its axis from far away, the lift is how far
// above its pose it is stopped, negative where it could go deeper. What is above a body inside its radius
// counts as met on the way: a pose is free only if the way out along the axis is free too.
#pragma once

#include "core/cutter/cutter.h"
#include "core/gouge/contact_index.h"
#include "core/setup/tool.h"
#include "core/setup/tool_pose.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace facetmill {

/// The body of a tool that is stopped first.
enum class ToolBody { none, cutter, shank, holder };
/// "cutter", "shank", "holder"; "none".
const char* tool_body_name(ToolBody body);

/// What the bodies of a tool keep from the part, mm.
struct ToolClearance {
    double cutter = 0; ///< the stock allowance
    double shank = 0, holder = 0;
};

/// Where a tool is stopped, coming down its axis.
struct ToolContact {
    double lift = -infinity; ///< along the axis from the pose; -inf: it meets nothing
    ToolBody body = ToolBody::none;
    int section = -1;          ///< the section of the holder; -1: another body
    Index facet = no_index;    ///< a facet it touches
    Vec3 point = Vec3::Zero(); ///< the touched point of the mesh, part coordinates
};

/// Why a posture at a contact point is not free (Lu 3.5.5: local and global gouging, collision).
enum class BlockCause { none, local, global, shank, holder };
const char* block_cause_name(BlockCause cause);

/// One tool over one mesh; safe to use from many threads at once.
class ToolLift {
public:
    /// Cutter, shank and up to 14 sections of a holder: more than holders have, and hints have this size.
    static constexpr std::size_t max_bodies = 16;

    /// What was touched last, body by body. Lifts of neighbouring poses are found faster when they share a
    /// hint; the lifts are the same. For one ToolLift and one thread at a time.
    class Hint {
        friend class ToolLift;
        std::array<std::uint32_t, max_bodies> slot_;

    public:
        Hint() { slot_.fill(0xFFFFFFFFu); }
    };

    /// What of the mesh matters to poses near to each other, above some depth.
    class Group {
    public:
        Group();
        ~Group();

    private:
        friend class ToolLift;
        struct Cuts;
        std::unique_ptr<Cuts> cuts_;
    };

    /// A whole tool. Bodies whose shadow along the axis lies in that of a body below are left out: they never
    /// stop the tool. Throws Error(out_of_range) for a tool that check_tool refuses, for negative clearances
    /// and for more than max_bodies bodies.
    ToolLift(ContactIndexPtr index, const Tool& tool, const ToolClearance& clearance = {});
    /// A cutter alone.
    ToolLift(ContactIndexPtr index, const CutterProfile& cutter, double allowance = 0);
    ~ToolLift();

    /// How far along its axis the tool is stopped. Throws Error(internal) for a pose that is not finite or
    /// whose axis is no unit vector (tolerance::unit_axis).
    double lift(const ToolPose& pose) const;
    double lift(const ToolPose& pose, Hint& hint) const;
    /// max(depth, lift(pose)), faster; where that is surely above `enough`, any number between the two.
    double lift_above(const ToolPose& pose, double depth, double enough, Hint& hint) const;
    /// The same lift, and where it comes from.
    ToolContact contact(const ToolPose& pose) const;
    /// What stops the tool above `depth`: the lift is max(depth, lift(pose)); no body where nothing stops it
    /// higher than `depth`.
    ToolContact contact_above(const ToolPose& pose, double depth, Hint& hint) const;
    /// Makes `group` that of these poses and of depths from `depth` upward. It pays from about eight poses on
    /// that differ by no more than the cutter's radius and some twenty degrees.
    void gather(std::span<const ToolPose> poses, double depth, Group& group) const;
    /// The same lift as without a group, faster. `pose` and `depth` must be of the group.
    ToolContact contact_above(const ToolPose& pose, double depth, Hint& hint, const Group& group) const;
    /// True when lift(pose) > depth; ends as soon as that is sure.
    bool is_deeper(const ToolPose& pose, double depth, Hint& hint) const;

    /// Lifts of many poses, in parallel; the same bits as one by one. Throws Error(internal) when the spans
    /// differ in length.
    void lift(std::span<const ToolPose> poses, std::span<double> lifts, const Progress& progress) const;

    const CutterProfile& cutter() const { return cutter_; }

private:
    struct Body;
    void add(const CutterProfile& profile, double offset, double clearance, ToolBody kind, int section);
    double search(const ToolPose& pose, double least, double enough, Hint& hint, ToolContact* contact,
                  const Group* group = nullptr) const;

    ContactIndexPtr index_;
    CutterProfile cutter_;
    std::vector<Body> bodies_;
};

/// Where a plane touches the lower surface of a cutter: (rho, z) in its frame, uphill of the axis, for a
/// plane that makes `angle` >= 0 with the axis' normal plane. The outermost such point where there are many;
/// where the plane is steeper than the surface anywhere, the end of it.
Vec2 plane_contact(const CutterProfile& cutter, double angle);

/// Where the tip of a cutter with this axis is when the cutter touches a plane through `point` with this unit
/// normal (away from the part; at an acute angle with the axis). Where the cutter touches along a line or in
/// an area, the touched point is the one farthest from the axis. Throws Error(out_of_range) when normal and
/// axis make no acute angle.
Vec3 tip_at_contact(const CutterProfile& cutter, const Vec3& point, const Vec3& normal, const Vec3& axis);

/// Says why a tool that is stopped above its pose is stopped: `local` where the cutter touches the part
/// within `local_radius` of the contact point, `global` elsewhere.
BlockCause block_cause(const ToolContact& contact, const Vec3& contact_point, double local_radius);

} // namespace facetmill
