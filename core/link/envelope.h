// How a tool of five axes travels between passes: out along its axis, round the part in rapids, and in along
// the next axis. Millimetres, part coordinates.
#pragma once

#include "core/setup/motion.h"
#include "core/setup/tool.h"

#include <functional>
#include <vector>

namespace facetmill {

/// What rapids keep clear of.
struct EnvelopeInput {
    Box3 part, stock; ///< boxes; an empty one is not there
    const Tool* tool = nullptr;
    double cutter_radius = 0;                          ///< the largest
    double highest_tip = -infinity, lowest_axis_z = 1; ///< of the path's locations
    double clearance = 0;                              ///< kept from both
    /// Whether the machine can hold the tool there; empty: it can hold it anywhere.
    std::function<bool(const CutterLocation&)> reachable;
};

/// Two surfaces on which the tool, cutter, shank and holder, is clear of part and stock: a level one above,
/// at which it may turn from any of the path's axes to any other, and a sphere about both, on which it may
/// stand with any axis that points outward. Rapids take the shorter way of those that the machine can go, in
/// pieces in which the axis turns by 5 degrees at most, so that every machine goes nearly the same way
/// between two of them.
///
/// On the sphere: where a tool leaves it along its axis a (unit) with its tip at c + R u, a . u >= 0, and so
/// every point of its body, which lies within w of the ray from the tip along a, is at least R - w away from
/// c. R is half the diagonal of the box round part and stock, the clearance, and the largest w.
class Envelope {
public:
    explicit Envelope(const EnvelopeInput& input);

    double level() const { return level_; } ///< height of the tip on the level surface
    double radius() const { return radius_; }
    /// Where it comes out to, the nearer one of the two surfaces where the machine reaches both or neither.
    CutterLocation out(const CutterLocation& at) const;
    /// All places of a rapid from where the tool comes out of one location to where it goes in to another:
    /// both ends included, and where these are the same only once.
    std::vector<CutterLocation> route(const CutterLocation& from, const CutterLocation& to) const;

private:
    CutterLocation on_level(const CutterLocation& at) const;
    CutterLocation on_sphere(const CutterLocation& at) const;
    std::vector<CutterLocation> over(const CutterLocation& from, const CutterLocation& to) const;
    std::vector<CutterLocation> round(const CutterLocation& from, const CutterLocation& to) const;

    bool reachable(const std::vector<CutterLocation>& route) const;

    std::function<bool(const CutterLocation&)> reachable_;
    Vec3 center_ = Vec3::Zero();
    double level_ = 0, radius_ = 0;
};

} // namespace facetmill
