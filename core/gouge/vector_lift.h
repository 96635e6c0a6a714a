// Lift along any vector of a tool with any axis (Lu 3.6.2.2, equations 3.126-3.188, corrected): how far a
// tool that comes from far away has still to go when it first touches the mesh.
//
// A posture is a tip position, a tool axis (from the tip into the tool) and a direction v, unit vectors, all
// in part coordinates, mm. The tool stands with its tip at tip + s v, without turning. Its lift is the
// largest s at which the tool, a closed set, has a point in common with the mesh; -inf when there is none for
// any s. So it may stand at every s above the lift, it touches at the lift, and it comes there from s = +inf
// without cutting anything. It follows that
//  - a tool is moved clear along v by max(0, lift), on a way that stays clear (there may be other free places
//    below the lift, behind a part of the mesh; they are not looked for);
//  - with v = axis = +Z the tip's height is tip.z + lift, the same as AxialLift for the same tip x, y;
//  - the negative of a lift <= 0 is how far the tool may go along -v before it touches.
// The mesh is a sheet of facets without an inside, as in AxialLift: a tool wholly inside of a closed part is
// found by what it crosses on its way out.
//
// The tool is one or more convex bodies of revolution about the axis: the cutting part with its full height
// and a flat top, and shank and holder sections as cylinders. Its lift is the largest of theirs.
//
// Exact for every convex cutter, axis and direction: what comes back is the exact answer for coordinates
// moved by a few roundings of their size (tolerance::touch_roundings). Where the tool's surface at the
// contact is not parallel to v, that is within tolerance::lift_accuracy. Where it only grazes, a contact
// nearer than that counts as touched.
#pragma once

#include "core/gouge/contact_index.h"

#include <span>
#include <vector>

namespace facetmill {

class RevolvedBody;
class VectorTree;

struct Posture {
    Vec3 tip = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();      ///< unit, from the tip into the tool
    Vec3 direction = Vec3::UnitZ(); ///< unit, the way the tool is lifted
};

/// A cylinder about the tool axis; `from` and `to` are heights above the tip, mm.
struct BodySection {
    double radius = 0, from = 0, to = 0;
};

struct VectorContact {
    double lift = -infinity;   ///< mm along the direction; -inf: the tool meets nothing
    Index facet = no_index;    ///< a facet it touches
    Vec3 point = Vec3::Zero(); ///< the touched point of the mesh, part coordinates
    enum class Feature { none, vertex, edge, facet } feature = Feature::none;
    unsigned body = 0; ///< 0 the cutting part, i the section i - 1
    /// Piece of the body's profile that touches: of the cutting part as in CutterProfile::pieces() of the
    /// cutter (grown by the allowance), of a section 0 its bottom, 1 its side (sections grown by an allowance
    /// have an arc at either end of the side); their number for the flat top. On the circle between two
    /// pieces either.
    unsigned piece = 0;
};

/// One tool over one mesh. Safe to use from many threads at once. A posture that is not finite, or whose axis
/// or direction is no unit vector (to tolerance::unit_axis), gives not-a-number, with no contact.
class VectorLift {
public:
    /// `allowance` >= 0 keeps that distance from every body, as if each were grown by it; lifts are those of
    /// the tool's own tip. Throws Error(out_of_range) for a negative allowance, and for a section without a
    /// positive radius and length.
    VectorLift(ContactIndexPtr index, const CutterProfile& cutter, std::span<const BodySection> sections = {},
               double allowance = 0);
    ~VectorLift();
    VectorLift(const VectorLift&) = delete;
    VectorLift& operator=(const VectorLift&) = delete;

    double lift(const Posture& posture) const;
    VectorContact contact(const Posture& posture) const;
    /// Lifts for many postures, in parallel; the same bits as `lift` one by one. Throws Error(internal) when
    /// the two spans differ in length.
    void lift(std::span<const Posture> postures, std::span<double> lifts, const Progress& progress) const;

private:
    ContactIndexPtr index_;
    std::unique_ptr<const VectorTree> tree_;
    std::vector<RevolvedBody> bodies_;
};

} // namespace facetmill
