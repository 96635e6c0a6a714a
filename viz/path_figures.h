// What happens along the program of one operation, motion by motion: how far, how long, how fast, and where
// the rotary axes stand. For the colours of a path and for charts. Millimetres, seconds, radians.
#pragma once

#include "core/base/progress.h"
#include "core/setup/machine.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace facetmill {

struct OperationResult; // core/job/planner.h

struct PathFigures {
    std::shared_ptr<const OperationResult> operation;
    Machine machine;
    // One value per motion, at its end or over it.
    std::vector<double> length;  ///< way of the tool tip since the beginning
    std::vector<double> elapsed; ///< since the beginning
    std::vector<double> seconds; ///< what the motion takes
    std::vector<double> feed;    ///< reached, mm/min; NaN for what takes no time or has no length
    std::vector<double>
        joint_rate; ///< share of its largest speed at which the joint nearest to it goes; NaN as above
    /// Angles of the machine's rotary axes, in their order; empty where it has fewer. NaN where the machine
    /// cannot hold the tool's axis.
    std::array<std::vector<double>, 2> rotary;
    /// Motions at whose end a rotary axis turns back, ascending: those that MachineMotion counts.
    std::array<std::vector<std::size_t>, 2> reversals;

    std::size_t motions() const { return length.size(); }
};
using PathFiguresPtr = std::shared_ptr<const PathFigures>;

/// Runs the program on the machine. Throws what machine_motion throws.
PathFiguresPtr path_figures(const std::shared_ptr<const OperationResult>& operation, const Machine& machine,
                            const Progress& progress);

/// Cusp to expect beside the contact point of every motion, mm; NaN for motions without one. Known at the
/// contact points that were planned, and taken evenly between them. Empty for an operation of three axes,
/// which keeps no cusps. The strips are looked at again, which takes part of the planning time.
std::vector<double> motion_cusps(const OperationResult& operation, const Progress& progress);

} // namespace facetmill
