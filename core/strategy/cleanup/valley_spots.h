// Where a cutter stands on a valley's centre or beside it. Millimetres, part coordinates, axis +Z.
#pragma once

#include "core/base/golden_section.h"
#include "core/gouge/vector_lift.h"
#include "core/strategy/cleanup/strip_passes.h"

#include <memory>
#include <optional>
#include <vector>

namespace facetmill {

/// A cutter at a place of a pass.
struct ValleySpot {
    bool free = false; ///< false: it has no place there
    Vec3 tip = Vec3::Zero(), touch = Vec3::Zero(), normal = Vec3::UnitZ();
};

/// Places of the cutter along one curve: moved along the fitted vector, or along Z, until it cuts nothing.
class ValleySpots {
public:
    ValleySpots(const StripCutting& with, const ValleyCurve& curve, const RestBand& band,
                const Progress& progress);

    /// The cutter at `offset` to the left of a point of the curve.
    ValleySpot spot(std::size_t i, double offset) const { return spot(place(i), offset); }

    /// Between points i and k the last place, coming from i, at which the cutter can stand.
    std::optional<ValleySpot> last_before(std::size_t i, std::size_t k, double offset) const;

    /// The farthest offset between `near`, at which there is a place, and `far`, at which there is none.
    /// Returns that place and sets `far` to its offset; nothing where there is none between.
    std::optional<ValleySpot> farthest(std::size_t i, double near, double& far) const;

    const Vec3& along(std::size_t i) const { return along_[i]; }

private:
    /// A place of the curve, at one of its points or between two.
    struct Place {
        PencilPoint point;
        Vec3 along = Vec3::Zero();
        const VectorLift* lift = nullptr;
        bool corner = false; ///< where it meets others
    };
    Place place(std::size_t i) const;
    Place between(std::size_t i, std::size_t k, double t) const;
    ValleySpot spot(const Place& of, double offset) const;
    bool place_along_vector(const Place& of, const Vec3& left, double offset, ValleySpot& s) const;
    bool place_along_z(const PencilPoint& p, const Vec3& left, double offset, ValleySpot& s) const;
    Vec3 lowest(const Place& of, const Vec3& tip, const Vec3& left) const;
    struct Sloping;
    std::optional<Sloping> sloping(const Place& of, const Vec3& from, const Vec3& left, double at) const;
    std::optional<LowPlace> lowest_by_slopes(const Place& of, const Vec3& from, const Vec3& left) const;

    const StripCutting& with_;
    const ValleyCurve& curve_;
    std::vector<Vec3> along_;
    double radius_;
    std::vector<std::shared_ptr<const VectorLift>> lift_of_;
};

} // namespace facetmill
