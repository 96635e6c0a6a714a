// Programs for a control, written as its post says.
//
// Every section starts and ends with the post's way up. From there the tool comes down to the section's start
// in three moves: rotary axes, X and Y, and at last Z. A rapid that would combine a descent with anything
// else is written at feed, as fast as the machine goes, and so are all rapids of several axes where these do
// not arrive together (Post::straight_rapids).
//
// Where the joints have to swing (they rewind, or turn round the pole of the machine) the tool goes out along
// its axis until it is clear of part and stock, up, and comes down again with the axes turned.
//
// X, Y, Z of a program that tells joints (three axes, too) count from where the part's origin stands at zero
// angles, and to the tip of a tool that stands upright: the work coordinate system lies in the part's origin,
// and the control knows the length of the tool.
#pragma once

#include "core/base/progress.h"
#include "core/output/cl_program.h"
#include "core/output/post/post.h"
#include "core/setup/machine.h"

#include <array>
#include <string>
#include <vector>

namespace facetmill {

/// What a program is posted for.
struct PostSetup {
    Machine machine;
    Vec3 part_origin =
        Vec3::Zero(); ///< in the frame of the machine, as for Kinematics: the zero of the program
    std::string wcs;  ///< one of the post's; empty: its first
    long program_number = 1;
    /// How far the tip may stray from the verified route between two blocks, and how far a control may round
    /// its corners; mm.
    double tip_tolerance = 0.002;
    /// Runs of motions of three axes, and in tilted planes, are told as arcs where the control has them: the
    /// ends of the motions within tip_tolerance of the arc, and it within `arc_bulge` of the motions; mm.
    bool arcs = false;
    double arc_bulge = 0.004;
    /// Part and stock, and how far away from them the tool may turn over; mm.
    Box3 keep_clear;
    double clearance = 5;
};

struct PostedProgram {
    static constexpr Travel nowhere{infinity, -infinity};
    std::string text;
    std::size_t blocks = 0; ///< lines that move something
    /// As the machine's model has them (motion_time.h), ways over the top included; without coming with a
    /// tool and going.
    double seconds = 0;
    Box3 reach;                                    ///< of X, Y and Z in the machine's frame
    std::array<Travel, 2> turns{nowhere, nowhere}; ///< of the rotary axes, radians
    std::vector<std::size_t> first_lines;          ///< of each section, from 1
    std::vector<long> tools;                       ///< in the order of their use
    bool tcp = false;                              ///< the control does the kinematics
    std::size_t planes = 0;                        ///< sections told in a tilted plane
    std::size_t arcs = 0;                          ///< blocks that are arcs
    std::size_t rewinds = 0; ///< how often the tool goes up so that rotary axes can turn
};

/// What the control does not know, whatever a program holds. Throw Error(out_of_range).
void check_wcs(const Post& post, const std::string& wcs);
void check_program_number(const Post& post, long number);
void check_tool_number(const Post& post, long number, const std::string& operation);
/// An operation that inclines the tool.
void check_inclined(const Post& post, const std::string& operation);
/// One that turns the part.
void check_turning(const Post& post, const std::string& operation);
void check_feed(const Post& post, const Machine& machine, double mm_per_min, const std::string& operation);

/// Throws what check_writable throws and Error(out_of_range, missing_reference, limit_exceeded) for what the
/// control or the machine cannot do: a program of several axes for a control of three, a place out of travel,
/// a feed, tool or program number that is too large, a work coordinate system it does not know. Nothing is
/// written then.
PostedProgram post_program(const ClProgram& program, const Post& post, const PostSetup& setup,
                           const Progress& progress);

} // namespace facetmill
