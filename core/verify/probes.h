// Points and lines against one body that moves along the motions of a program: how deep, of all motions, a
// point comes to lie inside it, and where it reaches lowest on a line.
//
// A tree of boxes over the motions says which to ask. A pose is passed over by a supporting plane: the body
// at one pose lies on one side of it, and how far the plane can come when the pose changes within a box, or
// within a motion, is a matter of a few products. What is left is asked exactly: straight motions with fixed
// axis by SweepRays, motions whose axis turns by halving them until nothing can be lower by more than a given
// bound.
#pragma once

#include "core/base/progress.h"
#include "core/verify/axis_courses.h"
#include "core/verify/sweep.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

/// A convex body of revolution by its supporting planes. It is made from the profile without TurnedBody, so
/// that neither can hide a mistake of the other.
class BodySupport {
public:
    explicit BodySupport(const CutterProfile& cutter);
    explicit BodySupport(const ToolSection& section);

    struct Plane {
        double inside; ///< how far behind it the point is; below 0: how far the body is from the point
        Vec3 normal;   ///< unit, outward
    };
    /// The supporting plane nearest to a point; the body has its tip at 0 and this unit axis.
    Plane nearest(const Vec3& point, const Vec3& axis) const { return closest(point, axis).plane(axis); }

    /// That plane before its normal is worked out: `inside` alone turns most questions away.
    struct Closest {
        double inside;
        Vec2 out;      ///< along the normal, (rho, z) about the axis
        double length; ///< of `out`
        Vec3 across;   ///< the point's way off the axis
        double rho;    ///< its length
        Plane plane(const Vec3& axis) const;
    };
    Closest closest(const Vec3& point, const Vec3& axis) const;
    /// The point of the body, from the tip, that lies farthest in a unit direction.
    Vec3 support(const Vec3& direction, const Vec3& axis) const;
    /// Height on the axis of a point well inside, near the lower end.
    double middle() const { return middle_; }
    double reach() const { return reach_; } ///< no point of the body is farther from the tip

private:
    struct Feature { // outward normals `first` to `last`, (rho, z), round a point
        Vec2 center, first, last;
        double r;
    };
    void add(const Vec2& center, double r, double from, double to);
    void finish(double radius, double bottom, double top);
    std::vector<Feature> features_;
    double middle_ = 0, reach_ = 0;
};

/// What is known of a line so far.
struct LineProbe {
    double value = 0;        ///< the lowest end of a stretch
    Index motion = no_index; ///< that has it
};

/// How deep inside a moving body a point has been found so far.
struct DepthProbe {
    double depth = 0;        ///< mm; below 0: so far from it
    Index motion = no_index; ///< that has it
    AxisCourse course = AxisCourse::great_circle;
};

/// The motions of a program, or some of them, in a tree of boxes.
class MotionTree {
public:
    /// A tree of the motions of those kinds for which `counts` is true. `program` must outlive this.
    MotionTree(const VerifyProgram& program, const std::function<bool(MotionKind)>& counts,
               const Progress& progress);

    bool empty() const { return nodes_.empty(); }
    bool turns() const { return turns_; }
    const VerifyProgram& program() const { return *program_; }

private:
    friend class MotionProbes;
    friend class MotionShadows;
    friend class NearMotions;
    struct Node {
        Vec3 lo, hi, axis; ///< box of the tips; middle of the axes
        double cone = 0;   ///< no axis is farther from the middle; 0: all are the same
        double size = 0;   ///< the box's diagonal
        Index right = 0;   ///< the other child; 0: a leaf. The first child is the next node
        Index motion = 0;  ///< leaf
    };
    const CutterLocation& from(Index motion) const;
    const CutterLocation& to(Index motion) const { return program_->motions->motions[motion].to; }
    Node leaf(Index motion) const;
    Index build(std::size_t begin, std::size_t end, std::vector<Node>& leaves, const Progress& progress);
    static void bound(Node& node, const std::vector<Node>& leaves, std::size_t begin, std::size_t end);

    const VerifyProgram* program_;
    AxisCourses courses_;
    bool turns_ = false;
    double lever_ =
        0; ///< what a turn of the axis moves of the tool counts as much as the tip, from here on up
    std::vector<Node> nodes_;
};

class MotionProbes;
class MotionShadows; // motion_shadows.h

/// What single motions sweep, each for lines of one direction: places of one facet ask the same motions in
/// the same direction, one after the other.
class RecentSweeps {
public:
    std::vector<Index> asked; ///< motions that one line was asked about
    /// For the lines along `direction`; `body` must outlive this.
    const SweepRays& of(const TurnedBody& body, Index motion, const StraightMove& move,
                        const Vec3& direction);

private:
    struct Sweep {
        const TurnedBody* body;
        Index motion;
        Vec3 direction;
        SweepRays rays;
    };
    std::array<std::optional<Sweep>, 64> kept_; ///< at the motion's number modulo so many
};

/// Straight motions that may matter to places near a center, each with a plane that all of its swept body
/// lies behind: a point p lies no deeper in motion k than height[k] - normal[k] . (p - center).
class NearMotions {
public:
    /// Finds the motions of the nodes `among` in which a point within `radius` of `center` may lie inside the
    /// body by more than `depth`. False where that is too much: axes turn, or they are too many.
    bool find(const MotionProbes& probes, const Vec3& center, double radius, double depth,
              std::span<const Index> among);
    /// Finds those that may reach lines that run within `radius` of p + t n, t in [0, length]. False as
    /// above.
    bool find_along(const MotionProbes& probes, const Vec3& p, const Vec3& n, double length, double radius);

private:
    friend class MotionProbes;
    struct Promising {
        std::size_t place;
        double bound;
    };
    /// How deep in a motion a point may lie, `off` away from the center.
    double inside(std::size_t k, const Vec3& off) const {
        return height_[k] - (x_[k] * off.x() + y_[k] * off.y() + z_[k] * off.z());
    }
    void clear(const Vec3& center);
    void add(Index motion, const Vec3& normal, double at_center);
    /// The places of those whose bound(place) is above `least`, the highest first.
    template <class Bound>
    std::span<const Promising> promising(double least, const Bound& bound);

    Vec3 center_ = Vec3::Zero();
    std::vector<Index> motions_;
    std::vector<double> x_, y_, z_, height_; ///< of the planes' normals; at the center
    std::vector<double> bounds_;
    std::vector<Promising> promising_;
    std::vector<Index> open_; ///< nodes still to be looked into
};

/// Asks one body of a tool where it reaches on lines.
class MotionProbes {
public:
    /// `bound` (mm): motions whose axis turns are followed this exactly, others to rounding.
    MotionProbes(TurnedBody body, BodySupport support, std::shared_ptr<const MotionTree> motions,
                 double bound);

    static constexpr std::array<Index, 1> all_nodes{0}; ///< the root
    const MotionTree& motions() const { return *tree_; }
    /// Nodes of the tree, few, that hold every motion in which a point within `radius` of `center` may lie
    /// inside the body by more than `depth`: where many places that are close together are asked, they are
    /// all that has to be asked.
    std::vector<Index> near(const Vec3& center, double radius, double depth) const;
    /// Lowers `probe.value` to the least `lo` of the stretches [lo, hi] that the moving body has on the line
    /// p + t n, and says whether it did. A stretch counts if it holds part of [min(value, 0), value]: one
    /// that is wholly below 0 only where it joins what is missing above it. `hint`: a motion to ask first, or
    /// no_index; it does not change the value. `among`: the nodes that are asked.
    /// `recent`: remembers what was asked before.
    bool lower(const Vec3& p, const Vec3& n, Index hint, LineProbe& probe,
               std::span<const Index> among = all_nodes, RecentSweeps* recent = nullptr) const;
    bool lower(const Vec3& p, const Vec3& n, LineProbe& probe, NearMotions& near, RecentSweeps& recent) const;
    /// Raises `probe.depth` to the largest depth of the point p inside the moving body, and says whether it
    /// did: the depth is the distance to the body's surface, which needs to know nothing of the part but the
    /// point. Of the courses that the axis may take the deepest. `hint`, `among`: as above.
    bool deepen(const Vec3& p, Index hint, DepthProbe& probe, std::span<const Index> among = all_nodes) const;
    bool deepen(const Vec3& p, Index hint, DepthProbe& probe, NearMotions& near) const;
    /// The first of an unbroken run of motions, up to `probe.motion`, in which p lies as deep: where a motion
    /// ends the next one begins, and both have that place.
    Index first_as_deep(const Vec3& p, const DepthProbe& probe) const;

private:
    friend class MotionShadows;
    friend class NearMotions;
    static constexpr std::size_t max_near = 32; ///< nodes; below them the tree finds faster than a list
    struct Open {
        Index node;
        double most;
    };
    class OpenNodes;
    /// The line, and the part of it, from `near` to `far`, that a motion has to reach to change anything.
    struct Line {
        Vec3 p, n;
        double near = 0, far = 0;

        void set(double value, double slack) {
            far = value - slack;
            near = std::min(far, 0.0);
        }
        /// The part's point nearest to `x`, as its t.
        double place(const Vec3& x) const { return std::clamp(n.dot(x - p), near, far); }
        Vec3 at(double t) const { return p + t * n; }
        /// The most that a plane, `inside` at t, has of the part behind it.
        double max_inside(const BodySupport::Plane& plane, double t) const {
            const double slope = plane.normal.dot(n);
            return plane.inside - std::min(slope * (near - t), slope * (far - t));
        }
    };
    struct Pose;
    class TurnedPart;
    double reaches(const MotionTree::Node& node, const Line& line) const;
    BodySupport::Plane between(const CutterLocation& pose, const Line& line, double& t) const;
    bool may_reach(Index motion, const Line& line) const;
    bool ask(Index motion, Line& line, LineProbe& probe, RecentSweeps* recent) const;
    bool ask_turning(Index motion, Line& line, LineProbe& probe) const;
    double max_depth(const MotionTree::Node& node, const Vec3& p, double least) const;
    bool ask_depth(Index motion, const Vec3& p, DepthProbe& probe) const;
    bool ask_depth_turning(Index motion, AxisCourse course, const Vec3& p, DepthProbe& probe) const;

    TurnedBody body_;
    BodySupport support_;
    std::shared_ptr<const MotionTree> tree_;
    double bound_ = 0, slack_ = 0;
};

} // namespace facetmill
