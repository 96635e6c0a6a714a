// The modes of a control while it runs a program: units, kinds of motion and feed, tool, its length, work
// coordinates, who leads the tip. What no code has said is not known, and is refused where it is needed.
// Internal to the room.
#pragma once

#include "core/base/error.h"
#include "core/output/post/nc_line.h"
#include "core/output/post/tilted_plane.h"

#include <map>
#include <optional>
#include <string>

namespace facetmill {

class NcModes {
public:
    enum class Tcp { off, axes, vectors, plane };

    /// `wcs`: the only one that may be chosen; empty: the post's own, or none where it needs none.
    NcModes(const std::string& file, const Post& post, const std::string& wcs);

    /// Takes over what a block says. Throws Error for what contradicts itself, within "file:line".
    void block(const NcLine& line, long number);
    /// What a motion needs to be known. Throws Error(missing_key).
    void check_motion() const;

    [[noreturn]] void refuse(const std::string& what, const std::string& remedy,
                             ErrorCode code = ErrorCode::out_of_range) const;

    long line_number() const { return line_; }
    /// A word that is a length, mm.
    double length(double word) const;
    double feed_unit() const;                 ///< mm/min
    NcCode motion() const { return motion_; } ///< rapid, feed, arc_clockwise, arc_anticlockwise or none
    int arc_normal() const; ///< the axis across the plane of arcs; refuses where no code said it
    bool gives_centre() const { return centre_now_; } ///< in this block
    bool inverse_time() const { return inverse_; }
    double feed() const { return *feed_; } ///< as the program has it; of a checked motion
    Tcp tcp() const { return tcp_; }
    const TiltedPlane& plane() const { return *plane_; } ///< of Tcp::plane
    bool turns_to_plane() const { return turn_now_; }    ///< in this block
    bool length_counts() const { return length_; }
    bool incremental() const { return incremental_; }
    bool goes_home() const { return home_now_; } ///< in this block
    bool changes_tool() const { return change_now_; }
    std::optional<long> tool() const { return tool_; }
    bool ended() const { return ended_; }

private:
    void codes(const NcLine& line);
    bool motion_code(NcCode code);
    void one_code(NcCode code, const NcLine& line);
    void call_length(NcCode code, const NcLine& line);
    void planes(const NcLine& line);
    void choose_wcs(std::string_view name);
    void wcs_lines(const NcLine& line);
    void values(const NcLine& line);
    void change_tool();

    const std::string& file_;
    const Post& post_;
    std::string wanted_wcs_;
    long line_ = 0;
    int next_wcs_line_ = 0; ///< of those that choose work coordinates together
    std::string named_wcs_;
    double unit_ = 0;         ///< mm; 0: not yet said
    bool blocks_say_ = false; ///< each that it moves
    bool absolute_ = false, incremental_ = false, inverse_ = false, inverse_known_ = false, wcs_ = false;
    bool spindle_ = false, speed_ = false, length_ = false, counts_length_ = false, ended_ = false,
         home_now_ = false;
    bool change_now_ = false, rapid_now_ = false, vectors_now_ = false, centre_now_ = false;
    int arc_normal_ = -1; ///< -1: not yet said
    std::optional<double> feed_;
    NcCode motion_ = NcCode::none, turns_ = NcCode::none;
    Tcp tcp_ = Tcp::off;
    std::optional<TiltedPlane> plane_;
    bool turn_now_ = false, turned_ = false; ///< the rotary axes, to the plane
    std::optional<long> prepared_, tool_;
};

} // namespace facetmill
