// Operations on a part that turns about an axis while a radial cutter travels along it (Jasra's lathe-mill,
// 3.2-3.4): what roughing and finishing have in common, and the frame they are measured in.
//
// Frame. The turning axis runs through a point O along the unit vector d. At the angle theta the radial
// direction is r = cos(theta) z0 + sin(theta) d x z0, the tangent t = d x r. A cutter at the place (theta, y)
// has the axis a = cos(tilt) r + sin(tilt) d, its tip on the line O + y d + offset t + u a. Its u is the
// axial lift over the part (core/gouge), so that it is exact for every cutter against facets, edges and
// vertices; Jasra's three checks (triangle, edge, vertex) for a ball give the same u once they are put right:
//
//   (1) triangle  the right side of the system is P1 + N r - T1, not + T1
//   (2) edge      A^-1 is (A^T A)^-1 A^T; the printed normal T x E makes the ball touch the edge's line in
//                 the plane across the motion only: a ball that moves along T touches where its centre is r
//                 away from the edge's *line*, a quadratic
//   (3) vertex    as printed
//
// tests/unit/strategy/lathe/test_lathe holds the lift to them. Jasra stops at the outermost contact, and so
// does the lift: what lies beyond the axis does not count, since the tip goes no farther in than
// `core_radius`.
//
// Between two locations the machine turns the part, moves along it and towards it in proportion, so a motion
// is straight in (theta, y, u).
#pragma once

#include "core/setup/turning_axis.h"
#include "core/strategy/plan/operation.h"

namespace facetmill {

struct LatheCommon : OperationCommon {
    enum class Axis { x, y, z, points };
    enum class Through { origin, middle };
    enum class Pattern { helix, rings, lengthwise };
    enum class Winding { unwound, modulo };

    Axis axis = Axis::x;
    Through axis_through = Through::origin;
    std::array<double, 3> axis_from{0, 0, 0}, axis_to{100, 0, 0}; ///< mm; of Axis::points
    Pattern pattern = Pattern::helix;
    NumberOrWord points_per_turn{0, "auto"};
    NumberOrWord side_feed{0, "adaptive"};              ///< mm a turn
    NumberOrWord start{0, "auto"}, stop{0, "auto"};     ///< mm along the axis, from its point
    double offset = 0;                                  ///< mm beside the centre line
    double tilt = 0;                                    ///< radians, towards +d
    double core_radius = 0;                             ///< mm; the tip comes no nearer to the axis
    std::array<double, 2> chuck{0, 0}, tailstock{0, 0}; ///< length from the stock's end, diameter; mm
    NumberOrWord chord_tolerance{0, "auto"};            ///< mm
    double holder_clearance = 0;                        ///< mm
    Winding winding = Winding::unwound;                 ///< turning angles in the table of positions
    // No parameters: what plans keep safe by, which tests halve and double.
    /// The share of the chord tolerance that motions may use between the places looked at; as much is for
    /// leaving points out, the rest for arcs that a reader of the program takes for straight.
    double look_share = 0.4;
    /// The share of the allowed cusp that side feeds aim at. The rest is for the angles between those looked
    /// at.
    double aimed_share = 0.9;
};

/// Description of a parameter of LatheCommon, the same for all lathe-mill operations; its default is the
/// member's.
const ParameterInfo& lathe_parameter(std::string_view key);

/// Adds what all lathe-mill operations have beside the common parameters.
template <class S>
void add_lathe_parameters(ParameterTable<S>& table) {
    using C = LatheCommon;
    const auto add = [&]<class T>(T C::*member, std::string_view key) {
        if constexpr (std::is_enum_v<T>)
            table.add_choice(static_cast<T S::*>(member), lathe_parameter(key));
        else
            table.add(static_cast<T S::*>(member), lathe_parameter(key));
    };
    add(&C::axis, "axis");
    add(&C::axis_through, "axis_through");
    add(&C::axis_from, "axis_from");
    add(&C::axis_to, "axis_to");
    add(&C::pattern, "pattern");
    add(&C::points_per_turn, "points_per_turn");
    add(&C::side_feed, "side_feed");
    add(&C::start, "start");
    add(&C::stop, "stop");
    add(&C::offset, "offset");
    add(&C::tilt, "tilt");
    add(&C::core_radius, "core_radius");
    add(&C::chuck, "chuck");
    add(&C::tailstock, "tailstock");
    add(&C::chord_tolerance, "chord_tolerance");
    add(&C::holder_clearance, "holder_clearance");
    add(&C::winding, "winding");
    table.set_stage("clearance", Stage::strategy); // chuck and tailstock are kept clear by it
}

/// What the operations on a part that turns have in common.
template <class Settings, const ParameterTable<Settings>& (*table)()>
class TurningOperation : public OperationWith<Settings, table> {
public:
    using OperationWith<Settings, table>::OperationWith;

    bool keeps_axis() const override { return false; }
    double holder_clearance() const override { return this->settings_.holder_clearance; }
    Linking linking() const override { return Linking::about_axis; }
    const LatheCommon* turning() const override { return &this->settings_; }
};

/// A place of the cutter: where on the part's turn and along it.
struct LathePlace {
    double angle = 0; ///< radians, unwound
    double y = 0;     ///< mm along the axis
};

class LatheFrame {
public:
    /// Throws Error(out_of_range) where two points make no axis or the axis passes beside the part's box.
    LatheFrame(const LatheCommon& settings, const PlanContext& context);

    const TurningAxis& axis() const { return axis_; }
    const Vec3& zero() const { return zero_; }
    double offset() const { return offset_; }
    double tilt() const { return tilt_; }

    Vec3 radial(double angle) const;
    Vec3 tool_axis(double angle) const;
    /// The tool with its tip `u` out from the line across the axis at y.
    CutterLocation at(const LathePlace& place, double u) const;
    /// Where a tool of this operation stands; the angle within half a turn of 0.
    LathePlace place(const CutterLocation& at) const;
    /// u of a tip that stands at an angle.
    double height(const Vec3& tip, double angle) const;
    /// Place along the axis, and distance from it.
    double along(const Vec3& p) const { return (p - axis_.point).dot(axis_.direction); }
    double away(const Vec3& p) const;

private:
    TurningAxis axis_;
    Vec3 zero_, side_; ///< directions at 0 and a quarter turn
    double offset_, tilt_, cos_tilt_, sin_tilt_;
};

} // namespace facetmill
