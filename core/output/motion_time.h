// How long a program takes and how far it goes.
#pragma once

#include "core/output/cl_program.h"
#include "core/setup/machine.h"

#include <vector>

namespace facetmill {

struct MotionTotals {
    double cut_length = 0;   ///< mm, all motion at feed
    double rapid_length = 0; ///< mm
    double time_seconds = 0; ///< feed moves at feed; rapids with every axis at its own largest speed
};

MotionTotals motion_totals(const ClProgram& program, const Machine& machine);

/// Of every motion; the first comes from nobody knows where and takes no time. Their sum is the total's time.
std::vector<double> motion_seconds(const ClProgram& program, const Machine& machine);

} // namespace facetmill
