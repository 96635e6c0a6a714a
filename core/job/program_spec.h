// What a project says of its programs: the control they are for, and what they are told by.
#pragma once

#include "core/base/parameter.h"

#include <array>
#include <string>

namespace facetmill {

/// Keys of the project file itself.
struct ProgramSpec {
    enum class Files { each, one };
    enum class ZeroFrom { origin, stock, part };
    std::string post; ///< a name, or a file; empty: no control was chosen
    std::string wcs;  ///< the work coordinate system that programs are told in; empty: the control's first
    long number = 1;  ///< of the first program
    Files files = Files::each;
    bool arcs = true;                          ///< programs of three axes may have them
    ZeroFrom zero_from = ZeroFrom::origin;     ///< what its zero is on: the part's origin, a box
    std::array<double, 3> zero_place{0, 0, 0}; ///< of a box: from -1, its low side, to 1, its high side
    std::array<double, 3> zero{0, 0, 0};       ///< mm, from there
    bool operator==(const ProgramSpec&) const = default;
};

const ParameterTable<ProgramSpec>& program_parameters();

} // namespace facetmill
