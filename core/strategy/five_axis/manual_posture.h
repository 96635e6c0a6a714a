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

/// One posture: in files the members of the list `manual_postures` of an operation.
const ParameterTable<ManualPosture>& manual_posture_parameters();

/// An operation that takes such postures, beside its parameters.
class TakesManualPostures {
public:
    static constexpr const char* file_key = "manual_postures";
    virtual const std::vector<ManualPosture>& manual_postures() const = 0;
    /// Takes them as they are; check_project checks.
    virtual void set_manual_postures(std::vector<ManualPosture> postures) = 0;

protected:
    ~TakesManualPostures() = default;
};

} // namespace facetmill
