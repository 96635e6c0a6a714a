// Posts: what a control's programs look like, as data files describe it (resources/posts/README.md). The
// writer (post_writer.h) and the reader (nc_reader.h) work from the same description, so that a program is
// read by what its control understands and not by what the writer meant.
#pragma once

#include "core/base/units.h"
#include "core/output/cl_program.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// What a code of a control does: "G1", "M6", "TRAORI".
enum class NcCode {
    none, ///< is read over: it moves nothing and changes no number
    rapid,
    feed,
    arc_clockwise,
    arc_anticlockwise,
    arc,             ///< of controls that say its direction apart
    turns_clockwise, ///< and the direction
    turns_anticlockwise,
    arc_centre, ///< this block gives the centre of the arcs that follow
    plane_xy,   ///< of arcs
    plane_xz,
    plane_yz,
    straight,         ///< of controls that say in every block that it moves: this one does, at feed
    straight_vectors, ///< the same, with the tool axis as a vector
    rapid_block,      ///< and this one is a rapid
    mm,
    inch,
    absolute,
    incremental, ///< only where an axis goes home
    per_minute,
    inverse_time,
    length_on,
    length_off,
    machine,      ///< this block's Z counts from the top of the travel
    home,         ///< this block's axes go to the end of their travel
    spindle_axis, ///< stands with the number of a tool
    tool_change,
    spindle_on,
    spindle_off,
    tcp,         ///< X, Y, Z are the tip on the part, rotary words the axes
    tcp_switch,  ///< the same as tcp, where the tool's length counts already
    tcp_vectors, ///< the same, with the tool axis as a vector
    tcp_off,
    plane_axes, ///< the rotary axes turn until the tool stands on the tilted plane
    end,
    wcs, ///< a work coordinate system; those of the post's list
};

/// What a word of a control says, a letter with a number.
enum class NcWord {
    x,
    y,
    z,
    a,
    b,
    c,
    i,
    j,
    k,
    centre_x,
    centre_y,
    centre_z,
    radius,
    feed,
    speed,
    tool,
    length,
    edge,
    ignored
};
inline constexpr std::size_t nc_words = std::size_t(NcWord::ignored);

struct Post {
    /// How programs of several axes are told.
    enum class MultiAxis {
        none,    ///< not at all
        joints,  ///< where the axes stand; straight between them
        tcp,     ///< the tip on the part and where the rotary axes stand; the control does the rest
        vectors, ///< the tip on the part and the tool axis
    };
    /// How arcs are told.
    enum class Arcs {
        none,
        centre, ///< by the way from where they begin to their centre
        radius,
        pole, ///< by a block with their centre before them
    };
    std::string name; ///< "linuxcnc", or the file's
    std::string label, description;
    std::string extension; ///< with the dot
    std::string line_end = "\n", separator = " ";
    std::size_t max_block = 255; ///< characters
    std::string comment_open = "(", comment_close = ")";
    std::string comment_also; ///< how comments that are read, and never written, begin; empty: none
    std::size_t max_comment = 60;
    int mm_decimals = 4, inch_decimals = 5, angle_decimals = 4, vector_decimals = 7, feed_decimals = 2,
        inch_feed_decimals = 3;
    bool trailing_zeros = false, point = true, plus = false; ///< "1.500", "1.", "+1"
    double inch_feed = 1;                                    ///< inches that a feed of 1 is
    bool numbers_blocks = false;
    std::string block_letter; ///< of block numbers; they can be bare
    long block_first = 10, block_step = 10, block_last = 99999;
    std::array<std::string, nc_words> words; ///< "X", or "A3="; empty where the control has none
    std::vector<std::string> ignored_words;  ///< of templates: read over
    std::map<std::string, NcCode> codes;
    std::vector<std::string> wcs; ///< codes that a project may ask for; the first unless it asks
    /// Where work coordinates have numbers: the lines that choose one, and the numbers there are.
    std::vector<std::string> wcs_lines;
    long wcs_first = 0, wcs_last = 0;
    bool wcs_optional = false;          ///< unless a project asks, none is chosen
    std::array<std::string, 4> coolant; ///< by Coolant
    MultiAxis multi_axis = MultiAxis::none;
    Arcs arcs = Arcs::none;
    std::array<bool, 3> arc_planes{false, false, true}; ///< by the axis across: YZ, XZ, XY
    bool helix = true;                                  ///< an arc may climb
    double smallest_radius = 0.1, largest_radius = 1000;
    bool straight_rapids = true; ///< axes of a rapid arrive together
    bool rapid_feed = false;     ///< a rapid needs a feed, too
    bool changes_tools = true;   ///< within a program
    bool modal = true;           ///< words that did not change are left out
    bool drops_wcs = false;      ///< who leads the tip, and who stops, forgets the work coordinates
    bool vector_at_start = true; ///< the block that leads to the tip has the tool axis, too
    double axis_tolerance = 0;   ///< how far the tool axis may stray between the blocks of joint programs
    double max_feed = 0;         ///< mm/min; 0: as the machine
    double max_inverse_time = 0; ///< of blocks with their own time, 1/min; 0: any
    long max_tool = 99, max_program = 9999;
    /// Lines with words in braces, see post_template_words.
    std::vector<std::string> start, tool_change, operation, retract, tcp_on, tcp_off, end;
    /// Switch a tilted plane on and off, in which X, Y, Z are told: the frame of the part, turned about its Z
    /// by {plane_z}, then about its new X by {plane_x}; one line of the first has both words. Empty: there
    /// are none.
    std::vector<std::string> plane_on, plane_off;
    bool plane_turns = false; ///< the rotary axes turn at once, not by a code of their own
    /// Stand in the block that takes the tool down to a section's start; the second where it leads to TCP,
    /// the third in a tilted plane.
    std::string approach, tcp_approach, plane_approach;
    std::string source; ///< text of the file

    int feed_digits(LengthUnit unit) const {
        return unit == LengthUnit::inch ? inch_feed_decimals : feed_decimals;
    }
    /// The first code that does this; empty where the control has none.
    const std::string& code(NcCode what) const;
    bool has_planes() const { return !plane_on.empty(); }
    bool has(NcCode what) const { return !code(what).empty(); }
    /// Programs say this: a line of theirs has the word in braces.
    bool tells(std::string_view template_word) const;
    /// Comments that begin so are read over.
    bool reads_comment(std::string_view begin) const {
        return comment_open == begin || comment_also == begin;
    }
    const std::string& word(NcWord which) const { return words[std::size_t(which)]; }
    /// The word of an arc's centre along X, Y or Z: its own, or that of the tool axis.
    NcWord centre_word(int axis) const;
    bool knows_wcs(std::string_view name) const;
    /// What programs are told in unless a project asks; empty: those that are active in the control.
    std::string default_wcs() const;
    std::string known_wcs() const; ///< "G54, G55", "the numbers from 0 to 99"; empty where there are none
};

/// Words that lines of a post may hold in braces: "program", "tool", "wcs" ...
const std::vector<std::string>& post_template_words();

/// The posts that are part of the program, in the order in which forms list them.
const std::vector<Post>& posts();
/// Throws Error(missing_reference) that lists the known names.
const Post& find_post(std::string_view name);
/// A post of one's own: a name that ends with ".json" is a file.
bool is_post_file(std::string_view name);
/// Strict: every key is known, has its type and its range, templates hold known words, and every code and
/// word that the post writes is one that it reads. Throws Error(syntax, truncated, encoding, limit_exceeded,
/// unknown_key, wrong_type, missing_key, out_of_range, newer_version) whose place is "file: codes.G0".
Post parse_post(std::string_view json, const std::string& file);
Post load_post(const std::filesystem::path& path);

/// A name from a user for a comment: letters, digits, blanks and ".-_" pass, all else becomes one blank, and
/// it is cut. No control reads anything into what is left.
std::string nc_text(std::string_view name, std::size_t max_characters);

} // namespace facetmill
