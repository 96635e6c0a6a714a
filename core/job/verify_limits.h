// What a job may do to the part and still be called verified: the project's key `verification`.
#pragma once

#include "core/base/parameter.h"

namespace facetmill {

struct VerifyLimits {
    /// mm; surface that came deeper inside a cutter is gouged. auto: twice the chord tolerance that the paths
    /// keep.
    NumberOrWord gouge_limit{0, "auto"};
    double uncut_limit = 0.02; ///< share of the surface to be cut that may stay uncut
    bool operator==(const VerifyLimits&) const = default;
};

const ParameterTable<VerifyLimits>& verify_limit_parameters();

} // namespace facetmill
