// The neutral CL program: what writers and posts read, and what the reader of foreign APT files makes.
// Millimetres, minutes, part coordinates.
#pragma once

#include "core/base/units.h"
#include "core/cutter/cutter.h"
#include "core/setup/motion.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

enum class Coolant { off, on, mist, flood }; ///< on: as the machine has it

enum class AngleWinding { unwound, modulo };

/// Motions [first, last) of a section.
struct ClRange {
    int pass = -1; ///< number of the roughing pass, from 0; -1: all there is
    std::size_t first = 0, last = 0;
};

/// How a section on a turning part is told as positions; its axis is that of the motions
/// (ToolMotions::turning).
struct ClTurning {
    Vec3 zero = Vec3::UnitZ(); ///< direction of the angle 0: unit vector across the axis
    AngleWinding winding = AngleWinding::unwound;
    std::vector<ClRange> ranges;
};

/// What one operation does with one tool. Its first motion is a rapid to the start, from wherever the tool
/// was.
struct ClSection {
    std::string operation_name;
    long tool_number = 1;
    std::string tool_name;
    AptCutter cutter;
    double gauge_length = 0; ///< from tip to spindle nose; 0 where it is not known
    double feed_mm_per_min = 1000, spindle_rpm = 1000;
    Coolant coolant = Coolant::on;
    bool multi_axis = false;
    Box3 part_box; ///< box of the part that is cut; empty where it is not known
    ToolMotions motions;
    std::vector<double> motion_feeds; ///< mm/min of each motion; empty: all at feed_mm_per_min
    std::optional<ClTurning> turning;

    /// Feed of a motion that is not rapid.
    double feed(std::size_t motion) const {
        return motion_feeds.empty() ? feed_mm_per_min : motion_feeds[motion];
    }
};

/// What a program file holds: sections in machining order, the tool changed between two of different tools.
struct ClProgram {
    std::string part_name = "PART";
    LengthUnit unit = LengthUnit::mm; ///< unit of the file; the values here are mm
    std::vector<std::shared_ptr<const ClSection>> sections;
};

/// True when the spindle holds the same tool in both.
bool same_tool(const ClSection& a, const ClSection& b);

/// Throws Error(empty_result) for a program without sections or a section in which nothing cuts,
/// Error(non_finite, coordinate_range, out_of_range, internal) for values that no machine could run: of every
/// motion, feed, speed and cutter, and for one tool number that stands for two cutters. Every writer begins
/// so.
void check_writable(const ClProgram& program);

} // namespace facetmill
