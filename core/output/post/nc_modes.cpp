#include "core/output/post/nc_modes.h"

#include "core/base/error.h"

#include <cmath>

namespace facetmill {

NcModes::NcModes(const std::string& file, const Post& post, const std::string& wcs)
    : file_(file), post_(post), wanted_wcs_(wcs) {
    if (wanted_wcs_.empty()) wanted_wcs_ = post.default_wcs();
    blocks_say_ = post.has(NcCode::straight);
    absolute_ = !post.has(NcCode::absolute);
    inverse_known_ = !post.has(NcCode::inverse_time);
    spindle_ = !post.has(NcCode::spindle_on);
    speed_ = post.word(NcWord::speed).empty() || !post.tells("speed");
    length_ = !post.has(NcCode::length_on) && post.word(NcWord::edge).empty();
    counts_length_ = length_;
    // Without codes for planes there is one.
    if (!post.has(NcCode::plane_xy)) arc_normal_ = 2;
}

int NcModes::arc_normal() const {
    if (arc_normal_ < 0)
        refuse("an arc is given, and nothing says in which plane",
               "write " + post_.code(NcCode::plane_xy) + " at the start", ErrorCode::missing_key);
    return arc_normal_;
}

void NcModes::refuse(const std::string& what, const std::string& remedy, ErrorCode code) const {
    throw Error(code, file_ + ":" + std::to_string(line_), what, remedy);
}

double NcModes::length(double word) const {
    if (unit_ == 0)
        refuse("no code says what the unit of the numbers is",
               "write " + post_.code(NcCode::mm) + " or " + post_.code(NcCode::inch) + " at the start",
               ErrorCode::missing_key);
    return word * unit_;
}

/// The length of the tool counts from here on.
void NcModes::call_length(NcCode code, const NcLine& line) {
    if (!post_.word(NcWord::length).empty()) {
        if (!line.has(NcWord::length))
            refuse("a tool length is called without a number",
                   "write " + post_.word(NcWord::length) + " and the tool's number", ErrorCode::missing_key);
        if (!tool_ || line[NcWord::length] != double(*tool_))
            refuse("the length of tool " + format_number(line[NcWord::length])
                       + " is called, and another one is in the spindle",
                   "call its own");
    }
    if (post_.word(NcWord::edge).empty()) length_ = true;
    if (!length_)
        refuse("the tip is to be led and the tool's length is not called", "call its edge before it",
               ErrorCode::missing_key);
    if (code != NcCode::length_on && plane_)
        refuse("the tip is led in a tilted plane", "switch the plane off before it");
    if (code != NcCode::length_on) tcp_ = code == NcCode::tcp ? Tcp::axes : Tcp::vectors;
}

void NcModes::one_code(NcCode code, const NcLine& line) {
    switch (code) {
    case NcCode::mm:
        unit_ = 1;
        break;
    case NcCode::inch:
        unit_ = mm_per_inch;
        break;
    case NcCode::absolute:
        absolute_ = true;
        incremental_ = false;
        break;
    case NcCode::incremental:
        incremental_ = true;
        break;
    case NcCode::per_minute:
    case NcCode::inverse_time:
        if (!inverse_known_ || inverse_ != (code == NcCode::inverse_time)) feed_.reset();
        inverse_ = code == NcCode::inverse_time;
        inverse_known_ = true;
        break;
    case NcCode::length_on:
    case NcCode::tcp:
    case NcCode::tcp_vectors:
        call_length(code, line);
        break;
    case NcCode::length_off:
        if (!counts_length_) length_ = false;
        tcp_ = Tcp::off;
        break;
    case NcCode::tcp_switch:
        if (!length_)
            refuse("the tip is to be led and the tool's length is not called", "call it before",
                   ErrorCode::missing_key);
        if (plane_) refuse("the tip is led in a tilted plane", "switch the plane off before it");
        tcp_ = Tcp::axes;
        break;
    case NcCode::tcp_off:
        tcp_ = Tcp::off;
        break;
    case NcCode::plane_axes:
        if (!plane_) refuse("the axes turn to a tilted plane, and there is none", "define it before");
        turn_now_ = true;
        break;
    case NcCode::spindle_on:
        spindle_ = true;
        break;
    case NcCode::spindle_off:
        spindle_ = !post_.has(NcCode::spindle_on);
        break;
    case NcCode::tool_change:
        if (!prepared_)
            refuse("a tool is changed and none was named", "write the tool's number before it",
                   ErrorCode::missing_key);
        change_tool();
        break;
    case NcCode::plane_xy:
        arc_normal_ = 2;
        break;
    case NcCode::plane_xz:
        arc_normal_ = 1;
        break;
    case NcCode::plane_yz:
        arc_normal_ = 0;
        break;
    case NcCode::arc_centre:
        centre_now_ = true;
        break;
    case NcCode::turns_clockwise:
    case NcCode::turns_anticlockwise:
        if (turns_ != NcCode::none) refuse("an arc has two directions", "keep one");
        turns_ = code;
        break;
    case NcCode::home:
        home_now_ = true;
        break;
    case NcCode::rapid_block:
        rapid_now_ = true;
        break;
    case NcCode::spindle_axis:
        if (!line.has(NcWord::tool)) refuse("an axis has no number", "write its place behind it");
        break;
    case NcCode::end:
        ended_ = true;
        break;
    default:
        break;
    }
}

/// True for a code that says how the block moves.
bool NcModes::motion_code(NcCode code) {
    switch (code) {
    case NcCode::straight:
    case NcCode::straight_vectors:
        motion_ = NcCode::feed;
        vectors_now_ = code == NcCode::straight_vectors;
        return true;
    case NcCode::rapid:
    case NcCode::feed:
    case NcCode::arc_clockwise:
    case NcCode::arc_anticlockwise:
    case NcCode::arc:
        motion_ = code;
        return true;
    default:
        return false;
    }
}

void NcModes::codes(const NcLine& line) {
    bool moves = false;
    if (blocks_say_) motion_ = NcCode::none;
    for (const NcCode code : line.codes) {
        if (!motion_code(code)) {
            one_code(code, line);
            continue;
        }
        if (moves) refuse("two kinds of motion in one block", "keep one of them");
        moves = true;
    }
    if (motion_ == NcCode::arc) {
        if (turns_ == NcCode::none)
            refuse("an arc has no direction",
                   "write " + post_.code(NcCode::turns_clockwise) + " or "
                       + post_.code(NcCode::turns_anticlockwise),
                   ErrorCode::missing_key);
        motion_ = turns_ == NcCode::turns_clockwise ? NcCode::arc_clockwise : NcCode::arc_anticlockwise;
    } else if (turns_ != NcCode::none) {
        refuse("a direction is given without an arc", "leave it out");
    }
    if (vectors_now_ && tcp_ != Tcp::vectors)
        refuse("the tool axis is told as a vector, and nothing leads the tip", "switch that on before it",
               ErrorCode::missing_key);
    if (rapid_now_ && motion_ == NcCode::none)
        refuse("a rapid without a motion", "write " + post_.code(NcCode::straight) + " before it",
               ErrorCode::missing_key);
    if (rapid_now_ && motion_ != NcCode::feed) refuse("an arc is no rapid", "give it a feed");
    if (rapid_now_) motion_ = NcCode::rapid;
    for (const NcCode leads : {NcCode::tcp, NcCode::tcp_switch, NcCode::tcp_vectors, NcCode::tcp_off})
        if (post_.drops_wcs && line.has_code(leads)) wcs_ = false;
    if (!line.wcs.empty()) choose_wcs(line.wcs);
}

void NcModes::choose_wcs(std::string_view name) {
    if (wanted_wcs_.empty())
        refuse("the work coordinate system is " + printable(name) + ", and the project names none",
               "name it in the project, as `wcs`");
    if (name != wanted_wcs_)
        refuse("the work coordinate system is " + printable(name) + ", and the part stands in "
                   + printable(wanted_wcs_),
               "choose the setup's");
    wcs_ = true;
}

/// Lines that choose work coordinates together stand one below the other.
void NcModes::wcs_lines(const NcLine& line) {
    if (line.wcs_line != next_wcs_line_ && (line.wcs_line >= 0 || next_wcs_line_ > 0))
        refuse("the choice of a work coordinate system is not whole", "write all of its lines",
               ErrorCode::missing_key);
    if (line.wcs_line < 0) return;
    if (line.wcs_number) named_wcs_ = std::to_string(*line.wcs_number);
    next_wcs_line_ = (next_wcs_line_ + 1) % int(post_.wcs_lines.size());
    if (next_wcs_line_ == 0) choose_wcs(named_wcs_);
}

/// A tilted plane that begins or ends.
void NcModes::planes(const NcLine& line) {
    if (line.plane_off) {
        plane_.reset();
        if (tcp_ == Tcp::plane) tcp_ = Tcp::off;
    }
    if (line.plane) {
        if (tcp_ != Tcp::off)
            refuse("a plane is tilted while the tip is led, or in another one", "switch that off");
        plane_ = TiltedPlane{radians((*line.plane)[0]), radians((*line.plane)[1])};
        turn_now_ = post_.plane_turns;
        turned_ = false;
    }
}

void NcModes::change_tool() {
    if (plane_) refuse("the tool is changed in a tilted plane", "switch the plane off before it");
    tool_ = prepared_;
    change_now_ = true;
    length_ = counts_length_;
    tcp_ = Tcp::off;
}

void NcModes::values(const NcLine& line) {
    if (line.has(NcWord::feed)) {
        if (!(line[NcWord::feed] > 0)) refuse("the feed is not above 0", "give a feed");
        feed_ = line[NcWord::feed];
    } else if (inverse_) {
        feed_.reset();
    }
    if (line.has(NcWord::speed)) {
        if (!(line[NcWord::speed] > 0)) refuse("the spindle speed is not above 0", "give a speed");
        speed_ = true;
    }
    if (line.has(NcWord::edge)) length_ = line[NcWord::edge] != 0;
    if (line.has(NcWord::tool)) {
        const double number = line[NcWord::tool];
        if (number != std::round(number) || number < 0 || number > 1e9)
            refuse("there is no tool " + format_number(number), "number tools from 1");
        prepared_ = long(number);
        if (!post_.has(NcCode::tool_change)) change_tool();
    }
}

void NcModes::check_motion() const {
    if (motion_ == NcCode::none)
        refuse("a place is given and no kind of motion",
               post_.has(NcCode::straight)
                   ? "write " + post_.code(NcCode::straight)
                   : "write " + post_.code(NcCode::rapid) + " or " + post_.code(NcCode::feed),
               ErrorCode::missing_key);
    if (!absolute_ || incremental_)
        refuse("places are not told from the origin",
               "write " + post_.code(NcCode::absolute) + " at the start", ErrorCode::missing_key);
    if (!wanted_wcs_.empty() && !wcs_)
        refuse("no work coordinate system is chosen", "write " + wanted_wcs_, ErrorCode::missing_key);
    if (plane_ && !turned_)
        refuse("a plane is tilted, and the rotary axes have not turned to it",
               "write " + post_.code(NcCode::plane_axes), ErrorCode::missing_key);
    if (plane_ && !length_)
        refuse("the tool moves in a tilted plane, and its length is not called", "call it",
               ErrorCode::missing_key);
    if (!tool_) refuse("no tool is in the spindle", "name it first", ErrorCode::missing_key);
    if (motion_ == NcCode::rapid) return;
    if (!feed_)
        refuse(inverse_ ? "a block of its own time has no time" : "there is no feed",
               "write " + post_.word(NcWord::feed), ErrorCode::missing_key);
    if (!inverse_known_)
        refuse("nothing says what the feed is per",
               "write " + post_.code(NcCode::per_minute) + " at the start", ErrorCode::missing_key);
    if (!spindle_)
        refuse("it cuts while the spindle stands", "write " + post_.code(NcCode::spindle_on),
               ErrorCode::missing_key);
    if (!speed_)
        refuse("it cuts, and no speed of the spindle is given", "write " + post_.word(NcWord::speed),
               ErrorCode::missing_key);
}

double NcModes::feed_unit() const {
    return unit_ == mm_per_inch ? unit_ * post_.inch_feed : unit_;
}

void NcModes::block(const NcLine& line, long number) {
    line_ = number;
    home_now_ = change_now_ = rapid_now_ = vectors_now_ = centre_now_ = false;
    turns_ = NcCode::none;
    turn_now_ = false;
    planes(line);
    wcs_lines(line);
    // "T1 M6": the number belongs to the change in the same block.
    const bool values_first = line.has(NcWord::tool);
    if (values_first) values(line);
    codes(line);
    if (!values_first) values(line);
    if (turn_now_) {
        turned_ = true;
        tcp_ = Tcp::plane;
    }
}

} // namespace facetmill
