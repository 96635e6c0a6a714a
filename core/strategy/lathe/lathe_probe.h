// The cutter over places of a turning part: where it stands that touches a plane, what it leaves over a
// point, and the place that brings it nearest to one. Millimetres, radians; frame and letters as in lathe.h.
#pragma once

#include "core/strategy/lathe/lathe_route.h"

namespace facetmill {

class LatheProbe {
public:
    /// All of it must outlive this. `allowed`: what may stay above the allowance, mm.
    LatheProbe(const LatheField& field, const LatheRange& range, double allowed)
        : field_(field), frame_(field.frame()), range_(range), allowed_(allowed) {}

    const LatheField& field() const { return field_; }
    const LatheFrame& frame() const { return frame_; }
    const LatheRange& range() const { return range_; }
    double allowed() const { return allowed_; }
    /// Radius of the cutter.
    double radius() const { return field_.cover().radius(); }

    /// Where the cutter stands that touches the plane through p with normal n; over p where it cannot.
    LathePlace place_over(const Vec3& p, const Vec3& n) const;
    /// The place whose tool axis runs through p, or beside it where p is nearer to the turning axis than the
    /// offset.
    LathePlace straight_over(const Vec3& p) const;
    double angle_of(const Vec3& p) const;
    /// Radius at which a step to the side of the tool turns the part by step / radius.
    double away_of(const Vec3& p) const { return std::max(frame_.away(p), 0.5 * radius()); }

    /// The cutter lowered at a place, or where the range ends before it, and its frame.
    struct Stand {
        LathePoint at;
        Vec3 tip = Vec3::Zero(), x = Vec3::Zero(), y = Vec3::Zero(), axis = Vec3::Zero();
        Vec3 local(const Vec3& v) const { return {v.dot(x), v.dot(y), v.dot(axis)}; }
    };
    Stand stand(LathePlace place, LatheField::Hint& hint) const;

    /// What a cutter leaves over p along n, and how far it is from p.
    struct Rest {
        double height = infinity, distance = infinity; ///< above what the allowance leaves; from p
    };
    Rest rest(const Stand& tool, const Vec3& p, const Vec3& n) const;

    /// The place, of those that a search from `place` downhill in the distance comes to, that serves p, or
    /// that is nearest to it.
    struct Nearest : Rest {
        LathePoint at;
    };
    Nearest nearest_from(LathePlace place, double step, const Vec3& p, const Vec3& n, LatheField::Hint& hint,
                         const Progress& progress) const;

private:
    const LatheField& field_;
    const LatheFrame& frame_;
    LatheRange range_;
    double allowed_;
};

} // namespace facetmill
