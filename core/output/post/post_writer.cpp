#include "core/output/post/post_writer.h"

#include "core/base/tolerances.h"
#include "core/output/motion_time.h"
#include "core/output/post/arc.h"
#include "core/output/post/joint_route.h"
#include "core/output/post/post_blocks.h"
#include "core/output/post/tilted_plane.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t motions_per_check = 2048;
/// Motions that are looked through for arcs at a time: an arc stands for no more.
constexpr std::size_t longest_run = 4096;
constexpr double largest_angle_by_radius = 0.9 * pi;
/// Less inclined, the digits of a plane's angles say little of where it leans; radians.
constexpr double min_tilt = 0.02;
/// What axes may differ that lean one way: a mesh in single precision has no flatter face. A micrometre on
/// 100 mm of tool; the tip is told as it is. Radians.
constexpr double one_way = 1e-5;
/// What its axes turn meanwhile is no other way to stand; radians.
constexpr double same_stand = 0.01;
/// An axis that moves less prints nothing; mm, radians.
constexpr double moves_linear = 0.002, moves_rotary = 1e-5;
constexpr std::array<NcWord, 3> linear_words = {NcWord::x, NcWord::y, NcWord::z};
constexpr std::array<NcWord, 3> vector_words = {NcWord::i, NcWord::j, NcWord::k};

/// Any of X, Y, Z goes so fast.
double rapid_mm_per_min(const Machine& machine) {
    return 60 * machine.rapid_mm_per_s.minCoeff();
}

/// Arcs for runs of motions of one feed, through places as they are printed in a frame: each at the first
/// motion that it stands for. Empty where there are to be none at all.
std::vector<std::optional<ArcRun>> found_arcs(const ClSection& s, const Mat3& frame, const Post& post,
                                              const PostSetup& setup, const PostBlocks& blocks) {
    const auto& motions = s.motions.motions;
    std::vector<std::optional<ArcRun>> arcs;
    if (!setup.arcs || post.arcs == Post::Arcs::none) return arcs;
    ArcLimits limits{.off = setup.tip_tolerance,
                     .bulge = setup.arc_bulge,
                     .smallest_radius = post.smallest_radius,
                     .largest_radius = post.largest_radius,
                     .normals = post.arc_planes,
                     .helix = post.helix};
    // Near half a turn a radius says little of where the centre is.
    if (post.arcs == Post::Arcs::radius) limits.largest_angle = largest_angle_by_radius;
    arcs.resize(motions.size());
    std::vector<Vec3> points;
    for (std::size_t i = 1; i < motions.size();) {
        points.clear();
        std::size_t end = i;
        while (end < motions.size() && motions[end].kind != MotionKind::rapid && s.feed(end) == s.feed(i)
               && end - i < longest_run)
            ++end;
        for (std::size_t k = i - 1; k < end; ++k) {
            Vec3 p = frame.transpose() * motions[k].to.tip;
            for (std::size_t w = 0; w < 3; ++w)
                p[int(w)] = blocks.printed(linear_words[w], p[int(w)]);
            points.push_back(p);
        }
        if (end == i) end = i + 1;
        for (std::size_t k = i; k < end;) {
            auto run = arc_run(std::span(points).subspan(std::min(k - i, points.size() - 1)), limits);
            const std::size_t stands_for = run ? run->motions : 1;
            arcs[k] = std::move(run);
            k += stands_for;
        }
        i = end;
    }
    return arcs;
}

/// No motion of a section goes higher.
double safe_height(const ClSection& s) {
    double safe = s.motions.clearance_z;
    for (const Motion& m : s.motions.motions)
        safe = std::max(safe, m.to.tip.z());
    return safe;
}

/// Seconds from where the tool was, up as the post has it, to where it comes down again.
double seconds_above(const ClSection& s, const Joints& from, const Joints& to, const Post& post,
                     const PostSetup& setup) {
    const Kinematics kinematics(setup.machine, s.gauge_length, setup.part_origin);
    const bool to_safe_height = std::any_of(post.retract.begin(), post.retract.end(), [](const auto& line) {
        return line.find("{safe}") != std::string::npos;
    });
    const double height = to_safe_height
                              ? safe_height(s) + setup.part_origin.z() + s.gauge_length
                              : travel_top(setup.machine, std::max(from.linear.z(), to.linear.z()));
    return seconds_over(kinematics, from, to, height);
}

/// The tool leans one way all along, and enough for a tilted plane.
bool leans_one_way(const ClSection& s) {
    const auto& motions = s.motions.motions;
    const Vec3& axis = motions.front().to.axis;
    return plane_across(axis).about_x >= min_tilt
           && std::all_of(motions.begin(), motions.end(),
                          [&](const Motion& m) { return (m.to.axis - axis).norm() <= one_way; });
}

/// The tilted plane of a section whose tool leans one way all along, held by the rotary axes where they are:
/// as its angles are printed. None where the control has no such planes.
std::optional<TiltedPlane> plane_of(const ClSection& s, const MachineMotion& found, const Post& post) {
    if (!post.has_planes() || !leans_one_way(s)) return std::nullopt;
    for (std::size_t i = 0; i < found.motions.size(); ++i)
        if (std::abs(found.motions[i].at.rotary[0] - found.motions.front().at.rotary[0]) > same_stand
            || std::abs(found.motions[i].at.rotary[1] - found.motions.front().at.rotary[1]) > same_stand)
            return std::nullopt;
    TiltedPlane plane = plane_across(s.motions.motions.front().to.axis);
    for (double* angle : {&plane.about_z, &plane.about_x})
        *angle = radians(nc_value(nc_digits(degrees(*angle), post.angle_decimals), post.angle_decimals));
    return plane;
}

/// What the words of templates stand for in a section.
TemplateValues template_values(const ClSection& s, const ClProgram& program, const Post& post,
                               const PostSetup& setup, const std::string& wcs,
                               const std::optional<TiltedPlane>& plane) {
    TemplateValues v;
    if (plane) {
        const auto angle = [&](double radians) {
            std::string text;
            const std::int64_t digits = nc_digits(degrees(radians), post.angle_decimals);
            if (post.plus && digits >= 0) text += '+';
            append_number(text, digits, post.angle_decimals, post);
            return text;
        };
        v["plane_z"] = angle(plane->about_z);
        v["plane_x"] = angle(plane->about_x);
    }
    v["part"] = nc_text(program.part_name, post.max_comment);
    v["operation"] = nc_text(s.operation_name, post.max_comment);
    v["tool_name"] = nc_text(s.tool_name, post.max_comment);
    v["program"] = std::to_string(setup.program_number);
    v["tool"] = std::to_string(s.tool_number);
    v["speed"] = std::to_string(std::llround(std::max(s.spindle_rpm, 1.0)));
    v["wcs"] = wcs;
    v["coolant"] = post.coolant[std::size_t(s.coolant)];
    const bool inch = program.unit == LengthUnit::inch;
    v["units"] = post.code(inch ? NcCode::inch : NcCode::mm);
    const int decimals = inch ? post.inch_decimals : post.mm_decimals;
    const double per = mm_per(program.unit);
    append_number(v["blend"], std::max<std::int64_t>(1, nc_digits(setup.tip_tolerance / per, decimals)),
                  decimals, post);
    append_number(v["safe"], nc_digits(safe_height(s) / per, decimals), decimals, post);
    const int feed_digits = post.feed_digits(program.unit);
    append_number(v["rapid"], nc_digits(rapid_mm_per_min(setup.machine) / per, feed_digits), feed_digits,
                  post);
    return v;
}

class PostWriter {
public:
    PostWriter(const ClProgram& program, const Post& post, const PostSetup& setup)
        : program_(program), post_(post), setup_(setup), wcs_(setup.wcs),
          blocks_(post, program.unit, rapid_mm_per_min(setup.machine)) {
        if (wcs_.empty()) wcs_ = post.default_wcs();
    }

    PostedProgram run(const Progress& progress);

private:
    [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const {
        throw Error(ErrorCode::out_of_range, "post '" + printable(post_.name) + "'", what, remedy);
    }
    bool told_as_joints(const ClSection& s) const {
        // Led by its tip a tool would run on chords where it is to run round a turning axis.
        return !s.multi_axis || post_.multi_axis == Post::MultiAxis::joints || s.motions.turning;
    }
    void check() const;
    void check_section(const ClSection& s) const;
    TemplateValues values(const ClSection& s) const {
        return template_values(s, program_, post_, setup_, wcs_, plane_);
    }
    void begin(const TemplateValues& v);
    void section(const ClSection& s, bool first, bool change, const Progress& progress);
    void upright(const ClSection& s, const Progress& progress);
    void arc(const ClSection& s, const ArcRun& run, const Joints& at, std::size_t last);
    void several_axes(const ClSection& s, const Progress& progress);
    void check_findings(const ClSection& s, const MachineMotion& found) const;
    void pieces(const ClSection& s, const Kinematics& kinematics, const MachineMotion& found, std::size_t i);
    void rewind(const ClSection& s, const Kinematics& kinematics, const JointMotion& motion, std::size_t i);
    void stop_leading(const ClSection& s);
    void come_again(const ClSection& s, const Joints& from, const Joints& at, const CutterLocation& location);
    double length_out(const CutterLocation& from) const;
    void place(const ClSection& s, const Joints& at, const CutterLocation& location);
    void start(const ClSection& s, const Joints& at, const CutterLocation& location);
    bool as_feed(const Joints& from, const Joints& to) const;
    double go(bool rapid, const Joints& from, const Joints& to, double seconds, double length, double feed);

    const ClProgram& program_;
    const Post& post_;
    const PostSetup& setup_;
    std::string wcs_;
    PostBlocks blocks_;
    PostedProgram posted_;
    Vec3 zero_ = Vec3::Zero();             ///< of X, Y, Z with the tool of the section
    std::vector<NcWord> rotary_;           ///< of the machine's axes
    std::optional<TiltedPlane> plane_;     ///< that the section is told in, as it is printed
    bool joints_ = true, inverse_ = false; ///< how the section is told
    double pending_ = 0;                   ///< seconds of motions that print as none
    Joints now_;
    std::optional<Joints> before_; ///< where the section before ended, with the same tool
    std::vector<RoutePlace> places_;
};

void PostWriter::check() const {
    check_writable(program_);
    check_wcs(post_, wcs_);
    check_program_number(post_, setup_.program_number);
    for (const auto& s : program_.sections)
        check_section(*s);
    if (!post_.changes_tools)
        for (std::size_t i = 1; i < program_.sections.size(); ++i)
            if (!same_tool(*program_.sections[i - 1], *program_.sections[i]))
                refuse("the control cannot change tools, and the program has several",
                       "write one program for each operation: \"programs\": \"each\"");
}

void PostWriter::check_section(const ClSection& s) const {
    const std::string name = "operation '" + printable(s.operation_name) + "'";
    check_tool_number(post_, s.tool_number, s.operation_name);
    double most = s.motion_feeds.empty() ? s.feed_mm_per_min : 0;
    for (const double f : s.motion_feeds)
        most = std::max(most, f);
    check_feed(post_, setup_.machine, most, s.operation_name);
    if (!s.multi_axis) return;
    check_inclined(post_, s.operation_name);
    if (setup_.machine.rotary.empty())
        refuse(name + " inclines the tool, and " + printable(setup_.machine.label) + " has no rotary axis",
               "choose the machine that it runs on");
    if (told_as_joints(s)) check_turning(post_, s.operation_name);
    for (const RotaryAxis& axis : setup_.machine.rotary)
        if (post_.word(rotary_word(axis)).empty())
            refuse("the control has no word for the axis " + axis.name, "add it to the words of the post");
}

/// A rapid as it is printed: does it have to be told as a motion at feed?
bool PostWriter::as_feed(const Joints& from, const Joints& to) const {
    int changes = 0, axes = 0;
    for (std::size_t i = 0; i <= std::size_t(NcWord::k); ++i)
        changes += blocks_.changes(NcWord(i));
    // One word of a led tip can move all axes.
    for (int k = 0; k < setup_.machine.joints(); ++k)
        axes += std::abs(to[k] - from[k]) > (k < 3 ? moves_linear : moves_rotary);
    if (!post_.straight_rapids && axes > 1) return true;
    return changes > 1 && (to.linear.z() < from.linear.z() || !post_.straight_rapids);
}

/// Writes the words that were set. `length` is the tip's. The seconds that it takes, which a control may make
/// longer.
double PostWriter::go(bool rapid, const Joints& from, const Joints& to, double seconds, double length,
                      double feed) {
    if (!blocks_.moves()) {
        if (!rapid) pending_ += seconds;
        return seconds;
    }
    if (rapid && !as_feed(from, to)) {
        blocks_.rapid();
        return seconds;
    }
    if (inverse_) {
        const double shortest = post_.max_inverse_time > 0 ? 60 / post_.max_inverse_time : 1e-6;
        const double told = std::max(seconds + pending_, shortest), before = pending_;
        blocks_.feed_for(told);
        pending_ = 0;
        return std::max(seconds, told - before);
    }
    // What moves no tip counts by its angle.
    if (!(length > tolerance::smallest_chord))
        length = degrees(std::abs(to.rotary[0] - from.rotary[0]) + std::abs(to.rotary[1] - from.rotary[1]))
                 * mm_per(program_.unit);
    blocks_.feed_per_minute(rapid && seconds > 0 ? 60 * length / seconds : feed);
    return seconds;
}

void PostWriter::place(const ClSection& s, const Joints& at, const CutterLocation& location) {
    const bool in_plane = plane_ && !joints_;
    const bool vectors =
        s.multi_axis && post_.multi_axis == Post::MultiAxis::vectors && !joints_ && !in_plane;
    const Vec3 words = joints_    ? Vec3(at.linear - zero_)
                       : in_plane ? Vec3(plane_->frame().transpose() * location.tip)
                                  : location.tip;
    for (std::size_t k = 0; k < 3; ++k)
        blocks_.set(linear_words[k], words[int(k)]);
    for (std::size_t k = 0; k < 3 && vectors; ++k)
        blocks_.set(vector_words[k], location.axis[int(k)]);
    for (std::size_t r = 0; r < rotary_.size() && !vectors && !in_plane; ++r)
        blocks_.set(rotary_[r], at.rotary[r]);
    posted_.reach.add(at.linear);
    for (std::size_t r = 0; r < setup_.machine.rotary.size(); ++r) {
        Travel& turns = posted_.turns[r];
        turns = {std::min(turns.lo, at.rotary[r]), std::max(turns.hi, at.rotary[r])};
    }
}

/// From the top down to the section's first place.
void PostWriter::start(const ClSection& s, const Joints& at, const CutterLocation& location) {
    const Vec3 words = at.linear - zero_;
    for (std::size_t r = 0; r < rotary_.size(); ++r)
        blocks_.set(rotary_[r], at.rotary[r]);
    if (blocks_.moves()) blocks_.rapid();
    blocks_.set(NcWord::x, words.x());
    blocks_.set(NcWord::y, words.y());
    blocks_.rapid();
    const bool tcp = !told_as_joints(s);
    if (tcp) blocks_.lines(plane_ ? post_.plane_on : post_.tcp_on, values(s));
    joints_ = !tcp;
    blocks_.before_next(!tcp     ? post_.approach
                        : plane_ ? post_.plane_approach
                                 : post_.tcp_approach,
                        values(s));
    place(s, at, location);
    // The rotary axes stand there already.
    for (const NcWord w : vector_words)
        if (tcp && !post_.vector_at_start) blocks_.leave_out(w);
    if (blocks_.moves()) blocks_.rapid();
    // Without a Z to go down by there is no block to take the approach.
    blocks_.before_next("", {});
}

/// An arc in place of the motions up to `last`.
void PostWriter::arc(const ClSection& s, const ArcRun& run, const Joints& at, std::size_t last) {
    place(s, at, s.motions.motions[last].to);
    blocks_.arc(run.arc, s.feed(last));
    posted_.seconds += 60 * run.arc.length() / s.feed(last);
    ++posted_.arcs;
}

void PostWriter::upright(const ClSection& s, const Progress& progress) {
    const auto& motions = s.motions.motions;
    const Machine& machine = setup_.machine;
    const std::vector<double> seconds =
        motion_seconds(s, machine, {.part_origin = setup_.part_origin}, progress.part(0, 0.3));
    Box3 box;
    for (const Motion& m : motions)
        box.add(m.to.tip + zero_);
    for (int k = 0; k < 3; ++k)
        if (const Travel& t = machine.travel[std::size_t(k)];
            !t.contains(box.lo[k], tolerance::smallest_chord)
            || !t.contains(box.hi[k], tolerance::smallest_chord))
            refuse("operation '" + printable(s.operation_name) + "': " + machine.axis_name(k)
                       + " would go from " + length_text(box.lo[k], program_.unit) + " to "
                       + length_text(box.hi[k], program_.unit)
                       + " of the machine, and its travel ends before",
                   "move the part, or choose a shorter tool");
    blocks_.feed_mode(false);
    inverse_ = false;
    Joints at;
    at.linear = motions.front().to.tip + zero_;
    if (before_) posted_.seconds += seconds_above(s, *before_, at, post_, setup_);
    start(s, at, motions.front().to);
    const auto arcs = found_arcs(s, Mat3::Identity(), post_, setup_, blocks_);
    for (std::size_t i = 1; i < motions.size(); ++i) {
        if (i % motions_per_check == 0) progress.part(0.3, 1).set(double(i) / double(motions.size()));
        if (i < arcs.size() && arcs[i]) {
            const ArcRun& run = *arcs[i];
            i += run.motions - 1;
            at.linear = motions[i].to.tip + zero_;
            arc(s, run, at, i);
            continue;
        }
        const Motion& m = motions[i];
        const Joints from{motions[i - 1].to.tip + zero_, {}};
        at.linear = m.to.tip + zero_;
        place(s, at, m.to);
        posted_.seconds += go(m.kind == MotionKind::rapid, from, at, seconds[i],
                              (at.linear - from.linear).norm(), s.feed(i));
    }
    blocks_.usual_plane();
    before_ = at;
}

void PostWriter::check_findings(const ClSection& s, const MachineMotion& found) const {
    for (const MotionFinding& f : found.findings)
        if (f.kind != MotionFinding::Kind::swing)
            refuse("operation '" + printable(s.operation_name) + "', "
                       + finding_text(f, setup_.machine, program_.unit),
                   "move the part, or change the operation's limits");
}

/// Motion i in the pieces that the control needs.
void PostWriter::pieces(const ClSection& s, const Kinematics& kinematics, const MachineMotion& found,
                        std::size_t i) {
    const Motion &from = s.motions.motions[i - 1], &m = s.motions.motions[i];
    const bool rapid = m.kind == MotionKind::rapid;
    StrayLimit limit{setup_.tip_tolerance, post_.axis_tolerance};
    if (!joints_) limit.tip = infinity; // the control sees to it
    places_.clear();
    const JointMotion motion{from.to, m.to, now_, found.motions[i].at};
    if (post_.multi_axis == Post::MultiAxis::vectors && !joints_)
        places_.push_back({1, motion.to_joints, motion.to});
    else if (const bool on_course = now_.rotary == found.motions[i - 1].at.rotary;
             !lead_motion(kinematics, motion, on_course, s.motions.turning, limit, places_))
        return rewind(s, kinematics, motion, i);
    const Vec3 step = m.to.tip - from.to.tip;
    const double feed_seconds = rapid ? 0 : step.norm() / s.feed(i) * 60;
    Joints last = motion.from_joints;
    double t = 0;
    for (const RoutePlace& p : places_) {
        const double share = p.t - t;
        const double seconds = std::max(share * feed_seconds, kinematics.time(last, p.at));
        place(s, p.at, p.location);
        posted_.seconds += go(rapid, last, p.at, seconds, share * step.norm(), s.feed(i));
        last = p.at;
        t = p.t;
    }
    now_ = last;
}

/// How far the tool goes along its axis until it is clear of part and stock.
double PostWriter::length_out(const CutterLocation& from) const {
    if (setup_.keep_clear.empty()) return setup_.clearance;
    double nearest = infinity;
    for (int k = 0; k < 3; ++k) {
        const double a = from.axis[k];
        if (std::abs(a) < tolerance::level_angle) continue;
        const double side =
            a > 0 ? setup_.keep_clear.hi[k] + setup_.clearance : setup_.keep_clear.lo[k] - setup_.clearance;
        nearest = std::min(nearest, (side - from.tip[k]) / a);
    }
    return std::max(nearest, 0.0);
}

/// The program tells joints again.
void PostWriter::stop_leading(const ClSection& s) {
    blocks_.lines(plane_ ? post_.plane_off : post_.tcp_off, values(s));
    joints_ = true;
}

/// Up, and down again to a place that is held otherwise.
void PostWriter::come_again(const ClSection& s, const Joints& from, const Joints& at,
                            const CutterLocation& location) {
    posted_.seconds += seconds_above(s, from, at, post_, setup_);
    const bool tcp = !told_as_joints(s);
    if (tcp) stop_leading(s);
    blocks_.lines(post_.retract, values(s));
    blocks_.feed_mode(inverse_);
    start(s, at, location);
    if (tcp) blocks_.feed_mode(false);
}

void PostWriter::rewind(const ClSection& s, const Kinematics& kinematics, const JointMotion& motion,
                        std::size_t i) {
    ++posted_.rewinds;
    now_ = motion.to_joints;
    const bool rapid = s.motions.motions[i].kind == MotionKind::rapid;
    if (rapid) {
        come_again(s, motion.from_joints, motion.to_joints, motion.to);
        return;
    }
    const auto refuse_it = [&] {
        refuse(
            "operation '" + printable(s.operation_name) + "', motion " + std::to_string(i + 1)
                + ": the machine would have to rewind its rotary axes while it cuts, and there is no room to",
            "change the operation's limits, or the part's place on the machine");
    };
    const double out = length_out(motion.from);
    const CutterLocation clear{motion.from.tip + out * motion.from.axis, motion.from.axis};
    const auto again = kinematics.nearest({motion.from.tip, motion.from.axis}, motion.to_joints);
    const auto clear_again = kinematics.nearest({clear.tip, clear.axis}, motion.to_joints);
    const auto clear_before = kinematics.nearest({clear.tip, clear.axis}, motion.from_joints);
    places_.clear();
    const StrayLimit limit{joints_ ? setup_.tip_tolerance : infinity, post_.axis_tolerance};
    if (!again || !clear_again || !clear_before || s.motions.turning
        || !lead_motion(kinematics, {motion.from, motion.to, *again, motion.to_joints}, true, {}, limit,
                        places_))
        refuse_it();
    const auto feed = [&](const Joints& from, const Joints& to, const CutterLocation& at, double length) {
        place(s, to, at);
        const double seconds = std::max(length / s.feed(i) * 60, kinematics.time(from, to));
        posted_.seconds += go(false, from, to, seconds, length, s.feed(i));
    };
    feed(motion.from_joints, *clear_before, clear, out);
    come_again(s, *clear_before, *clear_again, clear);
    feed(*clear_again, *again, motion.from, out);
    Joints last = *again;
    double t = 0;
    for (const RoutePlace& p : places_) {
        feed(last, p.at, p.location, (p.t - t) * (motion.to.tip - motion.from.tip).norm());
        last = p.at;
        t = p.t;
    }
    now_ = last;
}

void PostWriter::several_axes(const ClSection& s, const Progress& progress) {
    const auto& motions = s.motions.motions;
    const MachineMotion found =
        machine_motion(s, setup_.machine, {.part_origin = setup_.part_origin}, progress.part(0, 0.6));
    check_findings(s, found);
    const Kinematics kinematics(setup_.machine, s.gauge_length, setup_.part_origin);
    inverse_ = told_as_joints(s);
    plane_ = told_as_joints(s) ? std::nullopt : plane_of(s, found, post_);
    posted_.planes += plane_.has_value();
    blocks_.feed_mode(inverse_);
    now_ = found.motions.front().at;
    if (before_) posted_.seconds += seconds_above(s, *before_, now_, post_, setup_);
    start(s, now_, motions.front().to);
    if (!told_as_joints(s)) blocks_.feed_mode(false);
    const Progress rest = progress.part(0.6, 1);
    std::vector<std::optional<ArcRun>> arcs;
    if (plane_) arcs = found_arcs(s, plane_->frame(), post_, setup_, blocks_);
    for (std::size_t i = 1; i < motions.size(); ++i) {
        if (i % motions_per_check == 0) rest.set(double(i) / double(motions.size()));
        if (i < arcs.size() && arcs[i]) {
            const ArcRun& run = *arcs[i];
            i += run.motions - 1;
            now_ = found.motions[i].at;
            arc(s, run, now_, i);
            continue;
        }
        pieces(s, kinematics, found, i);
    }
    blocks_.usual_plane();
    if (!told_as_joints(s)) stop_leading(s);
    joints_ = true;
    blocks_.feed_mode(false);
    inverse_ = false;
    plane_.reset();
    before_ = now_;
}

/// The program's first lines. A program that was broken off may have left the control leading the tip, or a
/// plane tilted: with that even the way up would be another one.
void PostWriter::begin(const TemplateValues& v) {
    blocks_.lines(post_.start, v);
    if (!wcs_.empty()) blocks_.lines(post_.wcs_lines, v);
    if (setup_.machine.rotary.empty()) return;
    blocks_.lines(post_.tcp_off, v);
    if (std::any_of(program_.sections.begin(), program_.sections.end(),
                    [](const auto& s) { return s->multi_axis && leans_one_way(*s); }))
        blocks_.lines(post_.plane_off, v);
}

void PostWriter::section(const ClSection& s, bool first, bool change, const Progress& progress) {
    const TemplateValues v = values(s);
    zero_ = setup_.part_origin + Vec3(0, 0, s.gauge_length);
    rotary_.clear();
    for (const RotaryAxis& axis : setup_.machine.rotary)
        if (const NcWord word = rotary_word(axis); !post_.word(word).empty()) rotary_.push_back(word);
    if (first) begin(v);
    posted_.first_lines.push_back(blocks_.lines_written() + 1);
    blocks_.lines(post_.retract, v);
    if (change) {
        before_.reset();
        blocks_.lines(post_.tool_change, v);
        posted_.tools.push_back(s.tool_number);
    }
    blocks_.lines(post_.operation, v);
    joints_ = true;
    pending_ = 0;
    posted_.tcp = posted_.tcp || !told_as_joints(s);
    if (s.multi_axis)
        several_axes(s, progress);
    else
        upright(s, progress);
}

PostedProgram PostWriter::run(const Progress& progress) {
    check();
    const double n = double(program_.sections.size());
    for (std::size_t i = 0; i < program_.sections.size(); ++i) {
        const ClSection& s = *program_.sections[i];
        const bool first = i == 0, change = first || !same_tool(*program_.sections[i - 1], s);
        section(s, first, change, progress.part(double(i) / n, double(i + 1) / n));
    }
    const TemplateValues v = values(*program_.sections.back());
    blocks_.lines(post_.retract, v);
    blocks_.lines(post_.end, v);
    posted_.blocks = blocks_.blocks();
    posted_.text = std::move(blocks_.text());
    return std::move(posted_);
}

[[noreturn]] void refuse(const Post& post, const std::string& what, const std::string& remedy) {
    throw Error(ErrorCode::out_of_range, "post '" + printable(post.name) + "'", what, remedy);
}

} // namespace

void check_wcs(const Post& post, const std::string& wcs) {
    if (wcs.empty() || post.knows_wcs(wcs)) return;
    const std::string known = post.known_wcs();
    refuse(post, "the control has no work coordinate system '" + printable(wcs) + "'",
           known.empty() ? "leave `wcs` out" : "use one of: " + known);
}

void check_program_number(const Post& post, long number) {
    if (number < 1 || number > post.max_program)
        refuse(post,
               "the program number " + std::to_string(number) + " is not from 1 to "
                   + std::to_string(post.max_program),
               "choose another program number");
}

void check_tool_number(const Post& post, long number, const std::string& operation) {
    if (number > post.max_tool)
        refuse(post,
               "operation '" + printable(operation) + "' has tool " + std::to_string(number)
                   + ", and the control numbers them to " + std::to_string(post.max_tool),
               "give the tool a smaller number");
}

void check_inclined(const Post& post, const std::string& operation) {
    if (post.multi_axis == Post::MultiAxis::none)
        refuse(post,
               "operation '" + printable(operation) + "' inclines the tool, and the control has three axes",
               "choose another post");
}

void check_turning(const Post& post, const std::string& operation) {
    if (!post.has(NcCode::inverse_time))
        refuse(post,
               "operation '" + printable(operation)
                   + "' turns the part, and the control has no inverse time feed",
               "choose another post");
}

void check_feed(const Post& post, const Machine& machine, double mm_per_min, const std::string& operation) {
    const double limit = post.max_feed > 0 ? post.max_feed : 60 * machine.rapid_mm_per_s.maxCoeff();
    if (mm_per_min > limit * (1 + tolerance::figure_rounding))
        refuse(post,
               "operation '" + printable(operation) + "' has a feed of " + format_number(mm_per_min)
                   + " mm/min, and the machine goes " + format_number(limit) + " at most",
               "lower the feed");
}

PostedProgram post_program(const ClProgram& program, const Post& post, const PostSetup& setup,
                           const Progress& progress) {
    return PostWriter(program, post, setup).run(progress);
}

} // namespace facetmill
