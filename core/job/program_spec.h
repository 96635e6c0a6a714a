// What a project says of its programs: the control they are for, and what they are told by.
#pragma once

#include "core/base/parameter.h"

#include <string>

namespace facetmill {

/// Keys of the project file itself.
struct ProgramSpec {
    enum class Files { each, one };
    std::string post; ///< a name, or a file; empty: no control was chosen
    std::string wcs;  ///< the work coordinate system of the part's origin; empty: the control's first
    long number = 1;  ///< of the first program
    Files files = Files::each;
    bool arcs = true; ///< programs of three axes may have them
    bool operator==(const ProgramSpec&) const = default;
};

const ParameterTable<ProgramSpec>& program_parameters();

} // namespace facetmill
