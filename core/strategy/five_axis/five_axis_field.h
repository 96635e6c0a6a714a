// What finishing with five axes works on: the tool over the part, the surface's lines, the strip that each
// contact point has to clear, and so its configuration space. Made from an operation's settings alone, so
// that a contact point can be studied again after planning. Millimetres, radians, part coordinates.
#pragma once

#include "core/cspace/cspace.h"
#include "core/mesh/geometry.h"
#include "core/setup/kinematics.h"
#include "core/strategy/five_axis/finish5.h"
#include "core/strategy/surface/pass_map.h"
#include "core/strategy/surface/surface_lines.h"

#include <array>
#include <optional>

namespace facetmill {

/// A contact point in a drive plane, or on a line of a map.
struct ContactPlace {
    ContactFrame frame;          ///< x along the travel; its point keeps the allowance from the part
    Vec3 surface = Vec3::Zero(); ///< on the part
    Index facet = no_index;      ///< of what the field's lines are cut from
    double u = 0, v = 0;
    double s = 0;                              ///< along the surface's line
    double v_lo = 0, v_hi = 0;                 ///< the strip that the pass has to clear here
    std::optional<std::array<double, 2>> kept; ///< lead and yaw that were chosen by hand
    /// Lead and yaw by which the widths of the strip were found; none beyond the ends of the surface.
    std::optional<std::array<double, 2>> estimated;
};

class FiveAxisField {
public:
    /// `whole_spaces`: configuration spaces have their bottom everywhere, for showing; planning needs it only
    /// where the top is not below 0. Throws Error(out_of_range) whose place is the key.
    /// `view`: a rotation after which the side of the part that is cut faces up; drive planes are upright
    /// then. Everything else stays in part coordinates. Where the settings ask for passes that follow the
    /// part, the lines of a map stand for planes, all the rest stays as it is.
    FiveAxisField(const PlanContext& context, const Finish5Settings& settings, const Progress& progress,
                  bool whole_spaces = false, const Mat3& view = Mat3::Identity());
    FiveAxisField(const FiveAxisField&) = delete;
    FiveAxisField& operator=(const FiveAxisField&) = delete;

    /// The contact at `s` along a line of the plane v; travel +1: towards growing u, -1: back.
    ContactPlace place(const SurfaceLine& line, double s, double v, int travel) const;

    /// The line of plane `plane` beside a place, raised by what may stay there; false: the surface ends
    /// before. One plane beyond its end the surface is taken to go on, so that its border is not lost between
    /// two planes. It goes `along` radii of the cutter to either side.
    bool raised_line(const ContactPlace& place, long plane, RaisedCurve& curve,
                     double along = whole_reach) const;
    /// The place's own line, raised, as far as a posture there has to hold a point of it.
    bool own_line(const ContactPlace& place, RaisedCurve& curve) const;
    /// All that a posture at this place has to clear: its own line, and lines in the strip on either side.
    std::vector<RaisedCurve> strip_curves(const ContactPlace& place) const;

    /// Hollowness of the part across the travel, 1/mm; > 0 where it is hollow.
    double hollowness(const ContactPlace& place) const { return hollowness(place, place.frame.left); }
    /// The same along any unit direction across the normal.
    double hollowness(const ContactPlace& place, const Vec3& direction) const;
    /// The lead that matches the curvature across the travel there (CM2), held to the lead limits.
    double cm2_lead(const ContactPlace& place) const;

    /// Lengths along a line, ends included, at which straight pieces stay within half the chord tolerance of
    /// it and normals turn by at most the limit.
    std::vector<double> samples(const SurfaceLine& line) const;

    const PlanContext& context() const { return context_; }
    const Finish5Settings& settings() const { return settings_; }
    const DriveFrame& drive() const { return drive_; }
    const Mat3& view() const { return view_; }
    /// The v of a point of the surface.
    double v_of(const Vec3& p) const;
    /// What v grows by to the left of a place, mm per mm.
    double across(const ContactPlace& place) const {
        const Vec3& left = place.frame.left;
        const Vec3 seen = turned_ ? Vec3(view_ * left) : left;
        return map_ ? map_->gradients[place.facet].dot(seen) : drive_.v(seen);
    }
    /// The range of u.
    std::array<double, 2> travelled() const;
    /// How much finer than the cutter asks for lines have to lie, since v grows so slowly along some of the
    /// surface; at most 1.
    double fineness() const { return map_ ? map_->flattest_v : 1; }
    /// How much farther than the end of a line the end of another one beside it reaches, mm.
    double reaches_beyond(const SurfaceLine& line, const SurfaceSlice::End& other) const;
    /// The part as the drive planes see it.
    const Box3& seen_box() const { return seen_box_; }
    const SurfaceLines& lines() const { return *lines_; }
    SurfaceLines& lines() { return *lines_; }
    const ToolLift& lift() const { return *lift_; }
    const CutterProfile& cutter() const { return lift_->cutter(); }
    const PostureGrid& grid() const { return grid_; }
    const Kinematics& kinematics() const { return *kinematics_; }
    const CSpaceBuilder& builder() const { return *builder_; }
    double radius() const { return radius_; } ///< the cutter's
    double cusp() const { return cusp_; }     ///< what may stay, without the tessellation's share
    double chord() const { return chord_; }
    double allowance() const { return allowance_; }
    ToolClearance clearance() const;

private:
    void make_map(const Progress& progress);

    static constexpr double whole_reach = 1.25; ///< what a cutter can hold of a line, and a little more
    PlanContext context_;
    Finish5Settings settings_;
    double cusp_, chord_, allowance_, radius_ = 0;
    Mat3 view_;
    bool turned_;
    PlanContext seen_; ///< part and geometry, turned by the view, and divided finely for a map
    std::optional<PassMap> map_;
    std::vector<Index> facet_of_; ///< of the part, for each facet of that; empty: they are the same
    Box3 seen_box_;
    DriveFrame drive_;
    PostureGrid grid_;
    std::optional<ToolLift> lift_;
    std::optional<Kinematics> kinematics_;
    std::optional<SurfaceLines> lines_;
    std::optional<CSpaceBuilder> builder_;
    std::shared_ptr<const std::vector<VertexCurvature>> curvatures_;
};

} // namespace facetmill
