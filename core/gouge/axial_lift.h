// Axial lift: the lowest tip height at which a cutter with vertical axis over (x, y) does not cut into the
// mesh, there and all the way up (Lu 3.5.4; Yau). Exact for every convex APT cutter against vertices, edges
// and facets: within tolerance::lift_accuracy of a brute-force reference. The mesh is a sheet of facets,
// either side of which may be up.
//
// Only the lower surface counts, up to the cutter's largest radius: what is above it inside that radius is
// passed on the way down. So the part may reach above the cutter's height; shank and holder are other bodies,
// asked for themselves. The cutter reaches to its largest radius and no farther: a part that it only passes
// along its side does not lift it, and at exactly that radius it counts as under it.
#pragma once

#include "core/cutter/cutter.h"
#include "core/gouge/contact_index.h"

#include <span>
#include <vector>

namespace facetmill {

struct AxialAnswer;
struct SurfaceTable;

/// Where the cutter would touch.
struct AxialContact {
    double tip_z = -infinity;  ///< -inf: the cutter meets nothing on its way down
    Index facet = no_index;    ///< a facet it touches
    Vec3 point = Vec3::Zero(); ///< the touched point of the mesh
    enum class Feature { none, vertex, edge, facet } feature = Feature::none;
};

/// Where the last lift came from. Lifts of neighbouring places are found faster when they share a hint; the
/// heights are the same. For one index and one thread at a time.
class LiftHint {
    friend class AxialLift;
    std::uint32_t slot_ = 0xFFFFFFFFu;
};

/// One cutter over one mesh. Cheap to make; safe to use from many threads at once. Not-a-number for x or y
/// gives not-a-number, with no contact.
class AxialLift {
public:
    /// `allowance` >= 0 keeps that distance along the cutter's surface normal: the cutter is used grown by it
    /// (CutterProfile::grown), and heights are those of the cutter's own tip. Throws Error(out_of_range) for
    /// a negative allowance.
    AxialLift(ContactIndexPtr index, const CutterProfile& cutter, double allowance = 0);

    /// Tip height only.
    double tip_z(double x, double y) const;
    double tip_z(double x, double y, LiftHint& hint) const;
    /// The tip height, or `least` where that is higher: what cannot lift the tip above `least` is passed over
    /// early.
    double tip_z(double x, double y, LiftHint& hint, double least) const;
    /// True when the tip height is above z, but for rounding where it is z itself. Found much sooner than the
    /// height, where z is well above or below it.
    bool is_above(double x, double y, double z, LiftHint& hint) const;
    /// The same height, and where it comes from. With an allowance the touched point is that distance away
    /// from the cutter.
    AxialContact contact(double x, double y) const;
    /// The same; where several places are touched at once the hint may choose another one.
    AxialContact contact(double x, double y, LiftHint& hint) const;
    /// Tip heights for many points, in parallel; the same bits as `tip_z` one by one. Throws Error(internal)
    /// when the two spans differ in length. Points are arranged by where they are; those of a grid that is
    /// fine for the cutter are several times faster than one by one.
    void tip_z(std::span<const Vec2> points, std::span<double> heights, const Progress& progress) const;
    /// The same with what is touched: of several places that are touched at once it may be another one than
    /// `contact` tells.
    void contact(std::span<const Vec2> points, std::span<AxialContact> contacts,
                 const Progress& progress) const;

    /// The cutter as given, without the allowance.
    const CutterProfile& profile() const { return profile_; }

private:
    AxialContact contact_of(const AxialAnswer& answer, double x, double y) const;
    /// take(number, tip, slot of a facet that is touched), in any order and from many threads.
    template <class Take>
    void each_of(std::span<const Vec2> points, const Progress& progress, const Take& take) const;

    ContactIndexPtr index_;
    CutterProfile profile_;
    double allowance_;
    std::shared_ptr<const SurfaceTable> surface_;
};

} // namespace facetmill
