// Postures that were chosen by hand for single contact points of an operation with five axes. A point is
// given by its place on the part, so that a posture stays with it when the passes move a little: it belongs
// to the nearest contact point of the first pass whose strip holds the place.
#pragma once

#include "core/base/parameter.h"

#include <array>
#include <vector>

namespace facetmill {

/// The angles are those of contact_frame.h, against the travel of the pass there. The lift is the least that
/// is free.
struct ManualPosture {
    std::array<double, 3> point{0, 0, 0}; ///< on the part, mm, part coordinates
    double lead = 0, yaw = 0;             ///< lambda and omega, radians
    bool operator==(const ManualPosture&) const = default;
};

const ParameterTable<ManualPosture>& manual_posture_parameters();
/// Among the parameters of an operation that takes such postures.
inline constexpr RecordList<ManualPosture> manual_posture_list{"manual_postures", manual_posture_parameters};

} // namespace facetmill
