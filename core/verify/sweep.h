// The solid that a convex body of revolution sweeps when it moves straight without turning, and the stretch
// of a line within it, exactly.
//
// The swept solid is convex, so a line p + t u meets it in one stretch. Seen along the motion the body's
// outline is a convex curve in the plane across the motion; the line is a line there too, and where it enters
// and leaves the outline the body touches it at some share of the motion. Where that share is between start
// and end, it is the answer; else it is the body at the nearer end. (Of points with equal offset from the
// plane of line and motion all lie in one plane, where the pairs (t, share) inside the body are a convex
// set.) The outline is a chain of circles' images (ellipses), circular arcs, straight pieces and, of tori,
// offsets of ellipses.
#pragma once

#include "core/base/vec.h"
#include "core/cutter/cutter.h"
#include "core/verify/program.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace facetmill {

/// A stretch of a line p + t u, from t = lo to t = hi; empty when lo > hi.
struct Stretch {
    double lo = infinity, hi = -infinity;
    bool empty() const { return !(lo <= hi); }
};

/// A convex body of revolution about z, by its profile from the bottom of the axis outward and up to its top.
class TurnedBody {
public:
    /// The cutting part of a tool: tip at 0, flat top at its height.
    explicit TurnedBody(const CutterProfile& cutter);
    TurnedBody(double radius, double from, double to); ///< a cylinder between two heights above the tip

    double radius() const { return radius_; }
    double bottom() const { return bottom_; }
    double top() const { return top_; }
    /// Largest distance of a point of the body from the tip (0, 0, 0).
    double reach() const;
    /// The body made smaller about a point of its axis, by at least `by` (mm) at its side: what it only
    /// touches by rounding it does not touch then.
    TurnedBody shrunk(double by) const;
    /// The stretch within the body of the line p + t u, which is given in the body's frame; u of any length
    /// but 0.
    Stretch along(const Vec3& p, const Vec3& u) const;

private:
    friend class SweepRays;
    friend class SweepRow;
    /// A stretch of the profile whose outward normals are between two angles from straight down: a corner (a
    /// circle in space; r = 0) or an arc. Straight parts of the profile join one feature's end to the next
    /// one's start.
    struct Feature {
        Vec2 center;                    ///< (rho, z)
        double r = 0, from = 0, to = 0; ///< angles, 0 to pi
        Vec2 at(double angle) const { return center + r * Vec2(std::sin(angle), -std::cos(angle)); }
    };
    void add(const Vec2& center, double r, double to);
    void finish();
    double radius_at(double z) const;
    Stretch heights_at(double rho) const;
    Stretch along_general(const Vec3& p, const Vec3& u) const;

    std::vector<Feature> features_;                       ///< angles without gaps from 0 to pi
    std::vector<ProfilePiece> sides_;                     ///< the profile, bottom and top discs included
    std::size_t lower_ = 0;                               ///< so many of them are below the widest place
    double radius_ = 0, bottom_ = 0, top_ = 0, size_ = 0; ///< size: of the sphere about the body's middle
};

/// Turns vectors of part coordinates into a frame whose z is the tool axis, by one rotation. The identity for
/// (0, 0, 1).
Mat3 to_tool_frame(const Vec3& axis);

/// A straight motion with a fixed unit axis.
struct StraightMove {
    Vec3 from, to, axis;                    ///< tips
    Box3 box(const TurnedBody& body) const; ///< of the swept solid, tight for vertical axes
};

/// One swept solid and all lines of one direction.
class SweepRays {
public:
    /// `direction` is a unit vector. The body must outlive this.
    SweepRays(const TurnedBody& body, const StraightMove& move, const Vec3& direction);
    /// The stretch within the swept solid of the line p + t direction, in part coordinates. Where nothing of
    /// it lies between `low` and `high` it may come back empty.
    Stretch operator()(const Vec3& p, double low = -infinity, double high = infinity) const;

    /// A condition low <= value . p <= high that every line p + t direction which meets the swept tool
    /// fulfils.
    struct Strip {
        Vec3 value = Vec3::Zero();
        double low = -infinity, high = infinity;
    };
    /// From the outline, and from the cylinder round the body.
    const std::array<Strip, 2>& strips() const { return strips_; }

private:
    friend class SweepRow;
    /// One piece of the outline's chain over [c0, c1]: offsets c along `across_`; heights y along `out_`,
    /// places l along the motion.
    struct Link {
        enum class Kind : std::uint8_t { line, circle, sphere, torus };
        Kind kind = Kind::line;
        double c0 = 0, c1 = 0;
        double y0 = 0, l0 = 0;                           ///< line: at c0
        double slope_y = 0, slope_l = 0;                 ///< line
        double middle_c = 0, middle_y = 0, middle_l = 0; ///< else: image of the centre
        double scale = 0, cos_y = 0, sin_y = 0, cos_l = 0,
               sin_l = 0;      ///< circle and sphere: C = (c - middle_c) scale
        double e = 0, r = 0;   ///< torus
        std::size_t first = 0; ///< torus: in `starts_`, of `cells` and one
        int cells = 0;
        double cos0 = 0, cos1 = 0, p0 = 0, p1 = 0; ///< torus: of psi at c0 and c1, see Angle
    };
    struct Touch {
        double y, l;
    };
    struct Angle;
    struct TorusPoint;
    struct Start {
        double cosine, change;
    };
    void build(double side, std::vector<Link>& chain);
    Vec3 normal(double side, double psi) const;
    Vec3 outline_point(const TurnedBody::Feature& f, double side, double psi, double from_psi) const;
    Touch touch(const std::vector<Link>& chain, double side, double c) const;
    TorusPoint torus_point(const Link& link, double side, const Angle& psi) const;
    TorusPoint find_on_torus(const Link& link, double side, double c, double cosine, Angle& psi) const;
    void tabulate_torus(Link& link, double side);
    Touch touch_torus(const Link& link, double side, double c) const;
    Stretch at_end(const Vec3& p, bool last) const;
    void set_cylinder(const StraightMove& move, const Vec3& direction, double noise);
    bool misses(const Vec3& p, double low, double high) const;

    /// What holds the swept body, to turn most lines away: the cylinder round it, as far as it is moved, and
    /// the slab between its ends. At place p a line is nearest to the cylinder's axis at t = nearest . p, and
    /// crosses the slab's faces at level . p, each between two offsets more.
    struct Hull {
        Vec3 nearest = Vec3::Zero(), level = Vec3::Zero();
        double from = -infinity, to = infinity, bottom = -infinity, top = infinity;
        double middle = 0, half = 0, per_lean = 0; ///< of strips_[1]
    };

    const TurnedBody* body_;
    Mat3 frame_;
    Vec3 from_; ///< tip at the start, part coordinates
    Vec3 u_, along_, across_,
        out_; ///< in the tool's frame: the lines' direction; of the motion; see sweep.cpp
    Vec3 world_along_, world_across_, world_out_;
    double length_ = 0, sine_ = 0, u_along_ = 0;
    bool parallel_ = false; ///< lines and motion, or no motion
    bool slow_ = false;     ///< some of what is asked cannot be done for a whole row at once
    std::array<Strip, 2> strips_;
    Hull hull_;
    std::vector<Link> entry_, exit_;
    std::vector<Start> starts_; ///< of tori
};

/// The stretches of up to `lanes` lines in a row, which take far less time together.
class SweepRow {
public:
    static constexpr int lanes = 16;
    using Values = std::array<double, lanes>;
    using Flags = std::array<std::int64_t, lanes>; ///< 0 or not; as wide as the values
    /// Sets lo and hi of the `count` lines (p + i step) + t direction that are wanted, empty where lo > hi,
    /// and of the others to anything. Those that have nothing between `low` and `high` may come back empty,
    /// and so may those whose stretch between them surely lies in one that is not asked about: [known_lo,
    /// known_hi] of each line, where they are given.
    void ask(const SweepRays& swept, const Vec3& p, const Vec3& step, int count, double low, double high,
             Flags wanted, const float* known_lo = nullptr, const float* known_hi = nullptr);

    Values lo, hi;

private:
    struct Touches;
    void set_along(const TurnedBody& body, const Vec3& p, const Vec3& step, int count, const Vec3& u,
                   const Flags& wanted);
    void set_at_end(const SweepRays& swept, const Vec3& p, const Vec3& step, int count, bool last,
                    const Flags& wanted);
    static void touch(const SweepRays& swept, double side, const Values& c, int count, const Flags& wanted,
                      Touches& found);
};

/// Where the tool is at a share s of a motion, 0 at its start and 1 at its end.
CutterLocation location_between(const CutterLocation& from, const CutterLocation& to,
                                const std::optional<TurningAxis>& turning, double s);

/// The angle between two axes, or that by which the axis turns about the part's, where that is larger.
double angle_turned(const Vec3& from, const Vec3& to, const std::optional<TurningAxis>& turning);

/// Into how many straight moves a motion is divided whose axis turns by `angle`, with the tip at most `lever`
/// (mm) from where it turns about; the rest as in straight_moves.
std::size_t pieces_of_turn(double angle, double lever, double reach, double bound);

/// Appends to `moves` the part of a motion from s0 to s1 (shares of it) as straight moves, each with the axis
/// of its middle, such that no point within `reach` (mm) of the tip is farther than `bound` (mm) from where
/// it should be: one move where the axis does not turn.
void straight_moves(const CutterLocation& from, const CutterLocation& to,
                    const std::optional<TurningAxis>& turning, double s0, double s1, double reach,
                    double bound, std::vector<StraightMove>& moves);

} // namespace facetmill
