#include "core/output/post/nc_reader.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/output/post/arc.h"
#include "core/output/post/joint_route.h"
#include "core/output/post/nc_line.h"
#include "core/output/post/nc_modes.h"
#include "core/output/post/nc_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace facetmill {

namespace {

constexpr std::size_t lines_per_check = 4096;
/// What the last digit of a program may miss of a travel, mm and radians.
constexpr double travel_slack = 1e-3, rotary_slack = 1e-5;
/// A rotary axis without an end turns no further in one block: a point that was lost makes millions of turns.
/// A part that turns is wound back after a whole helix.
constexpr double max_turns = 100, max_turns_of_part = 10'000;
/// What an axis of a rapid may go beside the others though they do not arrive together: what digits do.
constexpr double apart_linear = 0.01, apart_rotary = 1e-4;
/// What the radius of an arc may differ between its ends; mm. More is refused by controls, too.
constexpr double radius_slack = 0.005;
constexpr double max_arc_pieces = 1e5;
/// How far rotary axes may turn when they are sent to a tilted plane: which way to hold it the control
/// chooses, so they must stand there already, but for their last digit.
constexpr double plane_slack = 1e-4;

/// Words that mean nothing here, and axes that the machine has not.
void check_words(const NcLine& line, const NcModes& modes, const Post& post, const Machine& machine,
                 bool vectors) {
    const bool arc = modes.motion() == NcCode::arc_clockwise || modes.motion() == NcCode::arc_anticlockwise;
    for (const NcWord w : {NcWord::a, NcWord::b, NcWord::c}) {
        bool there = !line.has(w);
        for (std::size_t r = 0; r < machine.rotary.size(); ++r)
            there = there || rotary_word(machine.rotary[r]) == w;
        if (!there) modes.refuse("the machine has no axis " + post.word(w), "choose the machine it runs on");
    }
    for (std::size_t w = std::size_t(NcWord::i); w <= std::size_t(NcWord::radius); ++w) {
        if (!line.has(NcWord(w)) || arc) continue;
        if (w > std::size_t(NcWord::k))
            modes.refuse("the centre or radius of an arc is given without one", "leave it out");
        if (!vectors) modes.refuse("a tool axis is given as a vector, and no code says so", "leave it out");
    }
}

/// The axes that are known to stand somewhere stand within their travel.
void check_axes(const Joints& to, const std::array<bool, 5>& known, const Machine& m, const NcModes& modes) {
    for (int k = 0; k < m.joints(); ++k) {
        const double slack = k < 3 ? travel_slack : rotary_slack;
        if (!known[std::size_t(k)] || m.joint_travel(k).contains(to[k], slack)) continue;
        const double unit = k < 3 ? 1 : radians(1);
        const Travel& t = m.joint_travel(k);
        modes.refuse(m.axis_name(k) + " would stand at " + format_number(to[k] / unit)
                         + ", and its travel is " + format_number(t.lo / unit) + " to "
                         + format_number(t.hi / unit),
                     "check the part's place and the program");
    }
}

void check_turns(const Joints& from, const Joints& to, const NcSetup& setup, const NcModes& modes) {
    const double most = setup.turning ? max_turns_of_part : max_turns;
    for (std::size_t r = 0; r < setup.machine.rotary.size(); ++r) {
        const double turns = std::abs(to.rotary[r] - from.rotary[r]) / (2 * pi);
        if (turns > most)
            modes.refuse(setup.machine.axis_name(int(3 + r)) + " makes " + format_number(turns, 3)
                             + " turns in one block, and " + format_number(most) + " are the most",
                         "check the number for a point that was lost");
    }
}

/// Where the rotary axes hold a tool axis, if they stand there already but for the last digit.
std::optional<Joints> held_here(const Kinematics& kinematics, const Vec3& axis, const Joints& at) {
    const Kinematics::Solutions solutions = kinematics.inverse({Vec3::Zero(), axis}, at);
    for (int k = 0; k < solutions.count; ++k) {
        Joints to = at;
        double farthest = 0;
        for (std::size_t r = 0; r < std::size_t(kinematics.rotary_axes()); ++r) {
            const double by = std::remainder(solutions.at[std::size_t(k)].rotary[r] - at.rotary[r], 2 * pi);
            to.rotary[r] += by;
            farthest = std::max(farthest, std::abs(by));
        }
        if (farthest <= plane_slack) return to;
    }
    return std::nullopt;
}

using Pole = std::array<std::optional<double>, 3>;

/// The arc of a block, in the joints of the machine, or in a tilted plane.
PlaneArc arc_of(const NcLine& line, const NcModes& modes, const Post& post, const Pole& pole,
                const Vec3& from, const Vec3& to) {
    if (line.read_over)
        modes.refuse("an arc has a word that is read over", "it may say how often it turns: leave it out");
    const bool clockwise = modes.motion() == NcCode::arc_clockwise;
    const int normal = modes.arc_normal();
    const int axes[] = {(normal + 1) % 3, (normal + 2) % 3};
    Vec3 centre = from;
    bool by_centre = false;
    for (const int k : axes) {
        if (const NcWord word = post.centre_word(k); line.has(word)) {
            centre[k] += modes.length(line[word]);
            by_centre = true;
        }
        if (post.arcs == Post::Arcs::pole) {
            if (!pole[std::size_t(k)])
                modes.refuse("an arc has no centre", "give it in a block before", ErrorCode::missing_key);
            centre[k] = *pole[std::size_t(k)];
            by_centre = true;
        }
    }
    if (line.has(post.centre_word(normal)))
        modes.refuse("the centre of an arc has a part across its plane", "leave it out");
    if (line.has(NcWord::radius) == by_centre)
        modes.refuse(by_centre ? "an arc has a centre and a radius" : "an arc has neither centre nor radius",
                     "give one of them");
    if (by_centre) return arc_about(from, to, centre, normal, clockwise);
    const auto arc =
        arc_with_radius(from, to, modes.length(line[NcWord::radius]), normal, clockwise, radius_slack);
    if (!arc) modes.refuse("no arc of this radius leads there", "check its end and its radius");
    return *arc;
}

void check_radius(const PlaneArc& arc, const NcModes& modes) {
    const double radius = arc.radius();
    if (!(radius > tolerance::smallest_chord))
        modes.refuse("an arc has no radius", "write a straight motion");
    if (std::abs(radius - arc.radius_at_end()) > radius_slack)
        modes.refuse("an arc begins " + format_number(radius, 6) + " mm from its centre and ends "
                         + format_number(arc.radius_at_end(), 6) + " mm from it",
                     "check its end and its centre");
}

/// Axes that go to the end of their travel, or to a place of the machine's own.
void check_home(const NcLine& line, const NcModes& modes, const Post& post) {
    for (const NcWord w : {NcWord::a, NcWord::b, NcWord::c})
        if (line.has(w)) modes.refuse("a rotary axis goes home", "leave it where it is");
    if (!modes.goes_home() && line.has(NcWord::z) && line[NcWord::z] != 0)
        modes.refuse("a place of the machine's own is not known here", "retract to 0 of the machine");
    for (std::size_t k = 0; k < 3 && modes.goes_home(); ++k) {
        if (!line.has(NcWord(k))) continue;
        if (!modes.incremental())
            modes.refuse("an axis calls at a place of the part on its way home",
                         post.has(NcCode::incremental)
                             ? "write " + post.code(NcCode::incremental) + " before it"
                             : "retract otherwise");
        if (line.value[k] != 0) modes.refuse("the tool goes elsewhere before it goes home", "write 0");
    }
}

/// Rapids whose axes arrive one after the other leave the line, whoever leads the tip.
void check_together(const NcModes& modes, const Joints& from, const Joints& to) {
    int axes = 0;
    for (int k = 0; k < 3; ++k)
        axes += std::abs(to.linear[k] - from.linear[k]) > apart_linear;
    // How an axis is held that is told as a vector, the control chooses.
    for (std::size_t r = 0; r < 2; ++r)
        axes +=
            modes.tcp() != NcModes::Tcp::vectors && std::abs(to.rotary[r] - from.rotary[r]) > apart_rotary;
    if (axes > 1)
        modes.refuse("a rapid moves several axes, and they do not arrive together",
                     "move them one by one, or at feed");
}

class NcRun {
public:
    NcRun(const std::string& file, const Post& post, const NcSetup& setup)
        : post_(post), setup_(setup), modes_(file, post, setup.wcs),
          kinematics_(setup.machine, 0, setup.part_origin) {
        // An axis that the program cannot name stands at 0.
        for (std::size_t r = 0; r < rotary_known_.size(); ++r)
            rotary_known_[r] = r >= setup.machine.rotary.size() || post.word(rotary(r)).empty();
    }

    void block(const NcLine& line, long number);
    NcProgram finish();
    bool ended() const { return modes_.ended(); }

private:
    using Tcp = NcModes::Tcp;

    [[noreturn]] void refuse(const std::string& what, const std::string& remedy,
                             ErrorCode code = ErrorCode::out_of_range) const {
        modes_.refuse(what, remedy, code);
    }
    /// This block is a rapid whose axes do not arrive together.
    bool apart() const { return !post_.straight_rapids && modes_.motion() == NcCode::rapid; }
    Mat3 frame() const { return tcp() == Tcp::plane ? modes_.plane().frame() : Mat3(Mat3::Identity()); }
    Tcp tcp() const { return by_joints_ ? Tcp::off : modes_.tcp(); }
    NcWord rotary(std::size_t r) const { return rotary_word(setup_.machine.rotary[r]); }
    void take_tool(long number);
    void go_home(const NcLine& line);
    void motion(const NcLine& line);
    void turn_to_plane();
    void arc(const NcLine& line, const Joints& to);
    void run_arc(const PlaneArc& arc, const Mat3& frame);
    void take_centre(const NcLine& line);
    Joints joint_target(const NcLine& line) const;
    Joints tcp_target(const NcLine& line) const;
    void check_travel(const Joints& to) const {
        check_axes(to,
                   {linear_known_[0], linear_known_[1], linear_known_[2], rotary_known_[0], rotary_known_[1]},
                   setup_.machine, modes_);
    }
    void come_down(const Joints& to);
    void trace(const Joints& to, bool rapid);
    void straight(const Joints& to, const CutterLocation& location, bool rapid);
    double seconds_for(const Joints& to, const CutterLocation& end, bool rapid) const;
    void add(const CutterLocation& to, const Joints& at, bool rapid, double feed);
    void close_section();

    const Post& post_;
    const NcSetup& setup_;
    NcModes modes_;
    Kinematics kinematics_; ///< with the tool that is in the spindle
    double gauge_ = 0;
    bool has_tool_ = false;
    NcProgram program_;

    // Where the machine stands.
    Joints at_;
    std::array<bool, 3> linear_known_{};
    std::array<bool, 2> rotary_known_{};
    bool up_ = false;               ///< Z is at the top of its travel
    std::vector<Joints> up_places_; ///< places up there since the last one below
    std::optional<Joints> left_;    ///< where the tool went up from
    Pole pole_;                     ///< of arcs whose centre has a block of its own; as places are told
    double arc_share_ = 1;          ///< of a block's time, that its piece of an arc takes
    bool by_joints_ = false;        ///< on the way up or down: whoever leads the tip elsewhere

    ClSection section_;
    std::vector<std::uint32_t> section_lines_;
    std::vector<Joints> section_joints_;
    bool chooses_ = false; ///< the control, how to hold the axes of the section
    std::vector<RoutePlace> places_;
};

void NcRun::take_tool(long number) {
    // Where the number itself changes the tool, that of the tool in the spindle changes nothing.
    if (has_tool_ && !post_.has(NcCode::tool_change) && number == section_.tool_number) return;
    if (has_tool_ && !up_ && post_.changes_tools)
        refuse("the tool is changed where it stands, and not up", "retract before it");
    const auto found = setup_.tools.find(number);
    if (found == setup_.tools.end())
        refuse("the project has no tool " + std::to_string(number), "add it to the project's tools",
               ErrorCode::missing_reference);
    close_section();
    has_tool_ = true;
    gauge_ = found->second.gauge_length;
    kinematics_ = Kinematics(setup_.machine, gauge_, setup_.part_origin);
    section_ = {};
    section_.tool_number = number;
    section_.tool_name = found->second.name;
    section_.cutter = found->second.cutter;
    section_.gauge_length = gauge_;
    section_.operation_name = "tool " + std::to_string(number);
    section_.multi_axis = !setup_.machine.rotary.empty();
    section_.motions.turning = setup_.turning;
    linear_known_ = {};
    left_.reset();
    up_places_.clear();
}

/// The rotary axes to where the tool stands on the tilted plane.
void NcRun::turn_to_plane() {
    if (!up_) refuse("rotary axes turn to a tilted plane while the tool is down", "retract before it");
    if (!rotary_known_[0] || !rotary_known_[1])
        refuse("the control chooses how to hold the tilted plane",
               "bring the rotary axes to where it is held before it", ErrorCode::missing_key);
    const auto held = held_here(kinematics_, modes_.plane().axis(), at_);
    if (!held)
        refuse("the rotary axes do not stand where the tilted plane is held",
               "bring them there before it, so that the control has nothing to choose");
    at_ = *held;
    up_places_.push_back(at_);
}

/// Axes to the end of their travel: Z up; X and Y are not known there.
void NcRun::go_home(const NcLine& line) {
    const auto given = [&](std::size_t k) { return line.has(NcWord(k)); };
    if (tcp() != Tcp::off)
        refuse("an axis goes home while the tip is led or in a tilted plane", "switch that off before it");
    check_home(line, modes_, post_);
    if (given(2)) {
        if (given(0) || given(1))
            refuse("the tool goes up and aside at the same time", "send Z home first, alone");
        if (!up_ && linear_known_[0] && linear_known_[1] && linear_known_[2]) left_ = at_;
        up_ = true;
        linear_known_[2] = false;
        up_places_.clear();
        return;
    }
    if (!up_) refuse("X or Y go home while the tool is down", "send Z home first");
    for (std::size_t k = 0; k < 2; ++k)
        if (given(k)) linear_known_[k] = false;
}

Joints NcRun::joint_target(const NcLine& line) const {
    Joints to = at_;
    for (std::size_t k = 0; k < 3; ++k)
        if (line.has(NcWord(k)))
            to.linear[int(k)] = modes_.length(line.value[k]) + setup_.part_origin[int(k)]
                                + (k == 2 && modes_.length_counts() ? gauge_ : 0);
    for (std::size_t r = 0; r < setup_.machine.rotary.size(); ++r)
        if (line.has(rotary(r))) to.rotary[r] = radians(line[rotary(r)]);
    return to;
}

Joints NcRun::tcp_target(const NcLine& line) const {
    const bool placed = linear_known_[0] && linear_known_[1] && (linear_known_[2] || up_) && rotary_known_[0]
                        && rotary_known_[1];
    const bool all = line.has(NcWord::x) && line.has(NcWord::y) && line.has(NcWord::z);
    if (!placed || (up_ && !all))
        refuse("the tool is led by its tip from a place that is not known",
               "bring rotary axes, X and Y to the start first, and give X, Y and Z", ErrorCode::missing_key);
    const ToolPose now = kinematics_.forward(at_);
    const Mat3 frame = this->frame();
    Vec3 words = frame.transpose() * now.tip;
    for (std::size_t k = 0; k < 3; ++k)
        if (line.has(NcWord(k))) words[int(k)] = modes_.length(line.value[k]);
    const Vec3 tip = frame * words;
    Joints to = at_;
    if (tcp() == Tcp::vectors) {
        Vec3 axis(0, 0, 0);
        bool given = false;
        for (std::size_t k = 0; k < 3; ++k)
            if (line.has(NcWord(std::size_t(NcWord::i) + k))) {
                axis[int(k)] = line.value[std::size_t(NcWord::i) + k];
                given = true;
            }
        if (given && !(axis.norm() > tolerance::level_angle))
            refuse("the tool axis has no length", "give I, J and K");
        const Vec3 unit = given ? Vec3(axis.normalized()) : now.axis;
        const auto held = kinematics_.nearest({tip, unit}, at_);
        if (!held) refuse("the machine cannot hold this place", "check the program and the machine");
        return *held;
    }
    for (std::size_t r = 0; r < setup_.machine.rotary.size(); ++r)
        if (line.has(rotary(r))) {
            if (tcp() == Tcp::plane)
                refuse("a rotary axis turns in a tilted plane", "switch the plane off first");
            to.rotary[r] = radians(line[rotary(r)]);
        }
    to.linear = kinematics_.linear(tip, to);
    return to;
}

void NcRun::add(const CutterLocation& to, const Joints& at, bool rapid, double feed) {
    section_.motions.motions.push_back({rapid ? MotionKind::rapid : MotionKind::cut, to});
    section_.motion_feeds.push_back(feed);
    section_lines_.push_back(std::uint32_t(modes_.line_number()));
    section_joints_.push_back(at);
    chooses_ = chooses_ || tcp() == Tcp::vectors;
}

/// The tool from where it stands to `to` while the joints move evenly.
void NcRun::trace(const Joints& to, bool rapid) {
    const ToolPose end = kinematics_.forward(to);
    straight(to, {end.tip, end.axis}, rapid);
}

double NcRun::seconds_for(const Joints& to, const CutterLocation& end, bool rapid) const {
    const double joints = kinematics_.time(at_, to);
    if (rapid) return joints;
    if (modes_.inverse_time()) return std::max(joints, 60 * arc_share_ / modes_.feed());
    // Where no tip moves the feed is that of the axes, in degrees.
    double distance = tcp() == Tcp::off ? (to.linear - at_.linear).norm()
                                        : (end.tip - section_.motions.motions.back().to.tip).norm();
    if (distance > tolerance::smallest_chord)
        return std::max(joints, 60 * distance / (modes_.feed() * modes_.feed_unit()));
    distance = std::abs(to.rotary[0] - at_.rotary[0]) + std::abs(to.rotary[1] - at_.rotary[1]);
    return std::max(joints, 60 * degrees(distance) / modes_.feed());
}

void NcRun::straight(const Joints& to, const CutterLocation& location, bool rapid) {
    check_turns(at_, to, setup_, modes_);
    const CutterLocation from = section_.motions.motions.back().to;
    const double step = (location.tip - from.tip).norm();
    const double seconds = seconds_for(to, location, rapid);
    const double feed = rapid                   ? 1
                        : modes_.inverse_time() ? std::max(60 * step / std::max(seconds, 1e-9), 1e-3)
                                                : modes_.feed() * modes_.feed_unit();
    places_.clear();
    const JointMotion motion{from, location, at_, to};
    const StrayLimit limit{tcp() == Tcp::off ? setup_.tip_tolerance : infinity, setup_.axis_tolerance};
    if (tcp() == Tcp::vectors)
        places_.push_back({1, to, location});
    else
        trace_motion(kinematics_, motion, section_.motions.turning, limit, places_);
    for (const RoutePlace& p : places_) {
        CutterLocation at = p.location;
        // The control keeps the tip on its line.
        if (tcp() != Tcp::off) at.tip = from.tip + p.t * (location.tip - from.tip);
        add(at, p.at, rapid, feed);
    }
    // Coming from nobody knows where counts for nothing; over the top does.
    if (!up_ || left_) program_.seconds += seconds;
    program_.reach.add(to.linear);
}

/// From the top to the first place below, and before that whatever happened since the tool went up.
void NcRun::come_down(const Joints& to) {
    const double high =
        travel_top(setup_.machine, std::max(to.linear.z(), left_ ? left_->linear.z() : to.linear.z()));
    by_joints_ = true;
    const auto visit = [&](const Joints& place, bool rapid) {
        if (section_.motions.motions.empty()) {
            const ToolPose pose = kinematics_.forward(place);
            add({pose.tip, pose.axis}, place, true, 1);
        } else {
            trace(place, rapid);
        }
        at_ = place;
    };
    if (left_ && !section_.motions.motions.empty()) {
        at_ = *left_;
        Joints above = *left_;
        above.linear.z() = high;
        visit(above, true);
        for (Joints place : up_places_) {
            place.linear.z() = high;
            visit(place, true);
        }
    }
    Joints above = at_;
    if (!up_places_.empty()) above = up_places_.back();
    above.linear.z() = high;
    visit(above, true);
    if (apart()) check_together(modes_, above, to);
    visit(to, modes_.motion() == NcCode::rapid);
    by_joints_ = false;
    up_ = false;
    left_.reset();
    up_places_.clear();
}

/// A block that gives the centre of arcs, in the words of places.
void NcRun::take_centre(const NcLine& line) {
    for (std::size_t k = 0; k < 3; ++k)
        if (line.has(NcWord(k))) pole_[k] = modes_.length(line.value[k]);
}

/// The arc in straight pieces that are as near to it as places are told; of a tilted plane in its frame.
void NcRun::run_arc(const PlaneArc& arc, const Mat3& frame) {
    const double radius = std::max(arc.radius(), arc.radius_at_end());
    const double flat = std::min(1.0, setup_.tip_tolerance / radius);
    const double pieces =
        std::clamp(std::ceil(0.5 * std::abs(arc.angle) / std::acos(1 - flat)), 1.0, max_arc_pieces);
    Joints place = at_;
    for (double k = 1; k <= pieces; ++k) {
        place.linear = arc.at(k / pieces);
        if (tcp() == Tcp::plane) place.linear = kinematics_.linear(frame * place.linear, at_);
        check_travel(place);
        arc_share_ = 1 / pieces;
        trace(place, false);
        at_ = place;
    }
    arc_share_ = 1;
}

void NcRun::arc(const NcLine& line, const Joints& to) {
    for (std::size_t r = 0; r < setup_.machine.rotary.size(); ++r)
        if (line.has(rotary(r))) refuse("an arc turns a rotary axis", "turn it in a block of its own");
    const bool in_plane = tcp() == Tcp::plane;
    if (tcp() != Tcp::off && !in_plane) refuse("the tip is led on an arc", "write straight motions");
    if (up_ || !linear_known_[2]) refuse("the tool comes down on an arc", "come down straight");
    const Mat3 frame = this->frame();
    Vec3 begin = at_.linear, end = to.linear;
    Pole pole = pole_;
    if (in_plane) {
        begin = frame.transpose() * kinematics_.forward(at_).tip;
        end = frame.transpose() * kinematics_.forward(to).tip;
        // A whole turn ends where it began.
        for (int k = 0; k < 3; ++k)
            if (std::abs(end[k] - begin[k]) < tolerance::smallest_chord) end[k] = begin[k];
    } else {
        for (std::size_t k = 0; k < 3; ++k)
            if (pole[k]) *pole[k] += setup_.part_origin[int(k)];
    }
    const PlaneArc arc = arc_of(line, modes_, post_, pole, begin, end);
    check_radius(arc, modes_);
    run_arc(arc, frame);
}

void NcRun::motion(const NcLine& line) {
    constexpr unsigned vector_bits = 7u << 6;
    const bool arcs =
        modes_.motion() == NcCode::arc_clockwise || modes_.motion() == NcCode::arc_anticlockwise;
    unsigned arc_bits = 0;
    for (std::size_t w = std::size_t(NcWord::i); w <= std::size_t(NcWord::radius); ++w)
        arc_bits |= 1u << w;
    check_words(line, modes_, post_, setup_.machine, tcp() == Tcp::vectors);
    const unsigned given =
        line.given
        & (NcLine::axis_bits | (tcp() == Tcp::vectors ? vector_bits : 0u) | (arcs ? arc_bits : 0u));
    if (given == 0) return;
    if (modes_.gives_centre()) return take_centre(line);
    ++program_.blocks;
    if (modes_.goes_home() || line.has_code(NcCode::machine)) return go_home(line);
    const bool level = (given & ~4u) != 0, all_before = linear_known_[0] && linear_known_[1]
                                                        && rotary_known_[0] && rotary_known_[1]
                                                        && linear_known_[2];
    modes_.check_motion();
    if (level && !up_ && !linear_known_[2])
        refuse("the tool moves aside, and nothing says how high it is", "retract Z first");
    const bool tip = tcp() != Tcp::off;
    const Joints to = tip ? tcp_target(line) : joint_target(line);
    const bool lowers = tip ? up_ : line.has(NcWord::z);
    if (arcs) {
        if (!all_before) refuse("an arc begins at a place that is not known", "go there straight first");
        check_travel(to);
        return arc(line, to);
    }
    for (std::size_t k = 0; k < 3; ++k)
        linear_known_[k] = linear_known_[k] || line.has(NcWord(k)) || (tip && lowers);
    for (std::size_t r = 0; r < setup_.machine.rotary.size(); ++r)
        rotary_known_[r] = rotary_known_[r] || line.has(rotary(r));
    check_travel(to);
    const bool placed = linear_known_[0] && linear_known_[1] && rotary_known_[0] && rotary_known_[1];
    if (up_ && !lowers) {
        at_ = to;
        up_places_.push_back(to);
        return;
    }
    if (up_) {
        if (!placed)
            refuse("the tool comes down and nothing says where an axis stands",
                   "bring rotary axes, X and Y to the start first", ErrorCode::missing_key);
        come_down(to);
    } else if (!all_before) {
        // The first height, or the first place at a known height.
        if (placed && linear_known_[2]) {
            const ToolPose pose = kinematics_.forward(to);
            add({pose.tip, pose.axis}, to, true, 1);
        }
    } else {
        if (apart()) check_together(modes_, at_, to);
        trace(to, modes_.motion() == NcCode::rapid);
    }
    at_ = to;
}

void NcRun::block(const NcLine& line, long number) {
    modes_.block(line, number);
    if (modes_.changes_tool()) take_tool(*modes_.tool());
    if (modes_.turns_to_plane()) turn_to_plane();
    motion(line);
}

void NcRun::close_section() {
    if (section_.motions.motions.empty()) return;
    if (up_ && left_) {
        at_ = *left_;
        left_.reset();
        Joints above = at_;
        above.linear.z() = travel_top(setup_.machine, at_.linear.z());
        by_joints_ = true;
        trace(above, true);
        by_joints_ = false;
    }
    for (std::size_t i = 0; i < section_.motions.motions.size(); ++i)
        if (section_.motions.motions[i].kind != MotionKind::rapid)
            section_.feed_mm_per_min = std::max(section_.motion_feeds[i], 1e-3);
    program_.sections.push_back(std::make_shared<const ClSection>(std::move(section_)));
    program_.lines.push_back(std::move(section_lines_));
    if (chooses_) section_joints_.clear();
    program_.joints.push_back(std::move(section_joints_));
    section_ = {};
    section_lines_.clear();
    section_joints_.clear();
    chooses_ = false;
}

NcProgram NcRun::finish() {
    if (!ended())
        refuse("the program has no end", "it may be cut short: write it anew", ErrorCode::truncated);
    close_section();
    const auto cuts = [](const auto& s) {
        return std::any_of(s->motions.motions.begin(), s->motions.motions.end(),
                           [](const Motion& m) { return m.kind != MotionKind::rapid; });
    };
    if (std::none_of(program_.sections.begin(), program_.sections.end(), cuts))
        refuse("nothing is cut", "check the program", ErrorCode::empty_result);
    return std::move(program_);
}

} // namespace

NcProgram read_nc(std::string_view text, const std::string& file, const Post& post, const NcSetup& setup,
                  const Progress& progress) {
    const NcLineReader reader(post);
    NcRun run(file, post, setup);
    NcLine line;
    long number = 0;
    bool begins = true;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view one = text.substr(at, end - at);
        if (!one.empty() && one.back() == '\r') one.remove_suffix(1);
        at = end + 1;
        if (std::size_t(++number) % lines_per_check == 0) progress.set(double(at) / double(text.size()));
        if (run.ended()) break;
        if (one.empty()) continue;
        const bool first = std::exchange(begins, false);
        if (one == "%" && first) continue;
        if (one == "%")
            throw Error(ErrorCode::truncated, file + ":" + std::to_string(number),
                        "the tape ends here, and the program is not at its end",
                        "write '%' first and last alone");
        if (one.size() > post.max_block)
            throw Error(ErrorCode::syntax, file + ":" + std::to_string(number),
                        "the block has more than " + std::to_string(post.max_block) + " characters",
                        "the control would not read it");
        if (const auto odd =
                std::find_if(one.begin(), one.end(), [](unsigned char c) { return c < 9 || c > 126; });
            odd != one.end())
            throw Error(ErrorCode::encoding, file + ":" + std::to_string(number),
                        "a character is not plain text", "write ASCII");
        reader.read(one, line, file, number);
        run.block(line, number);
    }
    return run.finish();
}

} // namespace facetmill
