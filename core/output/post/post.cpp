#include "core/output/post/post.h"

#include "core/base/catalogue.h"
#include "core/base/strict_json.h"
#include "core/base/tolerances.h"
#include "core/base/vec.h"
#include "core/output/post/nc_text.h"
#include "core/output/post/post_files.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace facetmill {

using namespace strict;

namespace {

constexpr long newest_post = 1;
constexpr std::size_t longest_line = 200, max_lines = 40;

const std::vector<std::pair<std::string, NcCode>>& code_words() {
    static const std::vector<std::pair<std::string, NcCode>> all = {
        {"none", NcCode::none},
        {"rapid", NcCode::rapid},
        {"feed", NcCode::feed},
        {"arc_clockwise", NcCode::arc_clockwise},
        {"arc_anticlockwise", NcCode::arc_anticlockwise},
        {"arc", NcCode::arc},
        {"turns_clockwise", NcCode::turns_clockwise},
        {"turns_anticlockwise", NcCode::turns_anticlockwise},
        {"arc_centre", NcCode::arc_centre},
        {"plane_xy", NcCode::plane_xy},
        {"plane_xz", NcCode::plane_xz},
        {"plane_yz", NcCode::plane_yz},
        {"straight", NcCode::straight},
        {"straight_vectors", NcCode::straight_vectors},
        {"rapid_block", NcCode::rapid_block},
        {"mm", NcCode::mm},
        {"inch", NcCode::inch},
        {"absolute", NcCode::absolute},
        {"incremental", NcCode::incremental},
        {"per_minute", NcCode::per_minute},
        {"inverse_time", NcCode::inverse_time},
        {"length_on", NcCode::length_on},
        {"length_off", NcCode::length_off},
        {"machine", NcCode::machine},
        {"home", NcCode::home},
        {"spindle_axis", NcCode::spindle_axis},
        {"tool_change", NcCode::tool_change},
        {"spindle_on", NcCode::spindle_on},
        {"spindle_off", NcCode::spindle_off},
        {"tcp", NcCode::tcp},
        {"tcp_switch", NcCode::tcp_switch},
        {"tcp_vectors", NcCode::tcp_vectors},
        {"tcp_off", NcCode::tcp_off},
        {"plane_axes", NcCode::plane_axes},
        {"end", NcCode::end},
    };
    return all;
}

const std::vector<std::string>& word_keys() {
    static const std::vector<std::string> keys = {
        "x",        "y",        "z",        "a",      "b",    "c",     "i",    "j",      "k",
        "centre_x", "centre_y", "centre_z", "radius", "feed", "speed", "tool", "length", "edge"};
    return keys;
}

/// One object of the file; `finish` refuses the keys nobody asked for.
class PostReader {
public:
    PostReader(const Json& object, std::string place) : object_(object), place_(std::move(place)) {
        expect_object(object_, place_);
    }
    std::string at(const std::string& key) const { return member(place_, key); }
    const Json* find(const std::string& key) {
        known_.push_back(key);
        const auto it = object_.find(key);
        return it == object_.end() ? nullptr : &*it;
    }
    const Json& need(const std::string& key, const std::string& remedy) {
        known_.push_back(key);
        return require(object_, place_, key, remedy);
    }
    [[noreturn]] void refuse(const std::string& key, const std::string& what,
                             const std::string& remedy) const {
        throw Error(ErrorCode::out_of_range, at(key), what, remedy);
    }
    void text(const std::string& key, std::string& to, std::size_t longest = longest_line) {
        if (const Json* v = find(key)) to = read_text(*v, at(key));
        if (to.size() > longest) refuse(key, "the text is too long", "shorten it");
    }
    void integer(const std::string& key, long lo, long hi, long& to) {
        const Json* v = find(key);
        if (!v) return;
        if (!v->is_number_integer()) wrong_type(at(key), *v, "a whole number");
        const double d = v->get<double>();
        if (!(d >= double(lo) && d <= double(hi)))
            refuse(key, "the number is not from " + std::to_string(lo) + " to " + std::to_string(hi),
                   "change it");
        to = long(d);
    }
    void integer(const std::string& key, int lo, int hi, int& to) {
        long v = to;
        integer(key, long(lo), long(hi), v);
        to = int(v);
    }
    void number(const std::string& key, double lo, double hi, double& to) {
        const Json* v = find(key);
        if (!v) return;
        if (!v->is_number()) wrong_type(at(key), *v, "a number");
        to = v->get<double>();
        if (!(to >= lo && to <= hi))
            refuse(key, "the number is not from " + format_number(lo) + " to " + format_number(hi),
                   "change it");
    }
    void boolean(const std::string& key, bool& to) {
        const Json* v = find(key);
        if (!v) return;
        if (!v->is_boolean()) wrong_type(at(key), *v, "true or false");
        to = v->get<bool>();
    }
    std::vector<std::string> list(const std::string& key) {
        std::vector<std::string> all;
        if (const Json* v = find(key)) {
            expect_list(*v, at(key));
            for (std::size_t i = 0; i < v->size(); ++i)
                all.push_back(read_text((*v)[i], element(at(key), i)));
        }
        return all;
    }
    void finish() const {
        for (auto it = object_.begin(); it != object_.end(); ++it)
            if (std::find(known_.begin(), known_.end(), it.key()) == known_.end())
                unknown_key(it.key(), place_, known_);
    }

private:
    const Json& object_;
    std::string place_;
    std::vector<std::string> known_;
};

/// The words in the braces of a line are known, and no brace stands alone.
void check_template(const std::string& line, const std::string& place) {
    if (line.size() > longest_line)
        throw Error(ErrorCode::out_of_range, place, "the line is too long", "shorten it");
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '}')
            throw Error(ErrorCode::out_of_range, place, "a '}' stands without '{'", "write {word}");
        if (line[i] != '{') continue;
        const std::size_t close = line.find('}', i);
        if (close == std::string::npos)
            throw Error(ErrorCode::out_of_range, place, "a '{' is not closed", "write {word}");
        const std::string word = line.substr(i + 1, close - i - 1);
        const auto& known = post_template_words();
        if (std::find(known.begin(), known.end(), word) == known.end())
            throw Error(ErrorCode::out_of_range, place, "there is no word {" + printable(word) + "}",
                        "known words: " + listed(known));
        i = close;
    }
}

void read_numbers(PostReader& file, Post& post) {
    const Json* object = file.find("numbers");
    if (!object) return;
    PostReader r(*object, "numbers");
    r.integer("mm_decimals", 1, 6, post.mm_decimals);
    r.integer("inch_decimals", 1, 7, post.inch_decimals);
    r.integer("angle_decimals", 1, 7, post.angle_decimals);
    r.integer("vector_decimals", 4, 9, post.vector_decimals);
    r.integer("feed_decimals", 0, 4, post.feed_decimals);
    // An inch is 25 mm, and its feeds have as many digits fewer.
    post.inch_feed_decimals = post.feed_decimals + 1;
    r.integer("inch_feed_decimals", 0, 6, post.inch_feed_decimals);
    r.boolean("trailing_zeros", post.trailing_zeros);
    r.boolean("point", post.point);
    r.boolean("plus", post.plus);
    r.number("inch_feed", 0.001, 1000, post.inch_feed);
    r.finish();
}

void read_comments(PostReader& file, Post& post) {
    const Json* object = file.find("comment");
    if (!object) return;
    PostReader r(*object, "comment");
    r.text("open", post.comment_open, 2);
    r.text("close", post.comment_close, 2);
    long longest = long(post.max_comment);
    r.integer("length", 8, 200, longest);
    post.max_comment = std::size_t(longest);
    r.text("also", post.comment_also, 2);
    r.finish();
    if (post.comment_open != "(" && post.comment_open != ";")
        r.refuse("open", "comments begin with ( or ;", "write one of them");
    if (post.comment_close != (post.comment_open == "(" ? ")" : ""))
        r.refuse("close", "what begins with ( ends with ), what begins with ; with the line",
                 "mend it, or leave it out");
    if (!post.comment_also.empty() && post.comment_also != (post.comment_open == "(" ? ";" : "("))
        r.refuse("also", "this is no other kind of comment",
                 "write the other one of ( and ;, or leave it out");
}

void read_block_numbers(PostReader& file, Post& post) {
    const Json* object = file.find("block_numbers");
    if (!object) return;
    PostReader r(*object, "block_numbers");
    post.numbers_blocks = true;
    post.block_letter = "N";
    r.text("letter", post.block_letter, 1);
    if (!post.block_letter.empty() && !is_nc_word(post.block_letter))
        r.refuse("letter", "this is no letter", "write one letter, or nothing");
    r.integer("first", 0L, 99999L, post.block_first);
    r.integer("step", 1L, 1000L, post.block_step);
    r.integer("last", 99L, 99999999L, post.block_last);
    r.finish();
}

void read_words(PostReader& file, Post& post) {
    PostReader r(file.need("words", "write the letters: { \"x\": \"X\", ... }"), "words");
    const auto& keys = word_keys();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        std::string& word = post.words[i];
        r.text(keys[i], word, 4);
        if (!word.empty() && !is_nc_word(word))
            r.refuse(keys[i], "'" + printable(word) + "' is no word",
                     "write letters, or letters and digits that end with '='");
        for (std::size_t k = 0; k < i && !word.empty(); ++k)
            if (post.words[k] == word)
                r.refuse(keys[i], "'" + word + "' has two meanings", "give each its own");
    }
    if (!post.word(NcWord::edge).empty() && !post.word(NcWord::length).empty())
        r.refuse("edge", "the length of a tool is called by an edge or by a number, not by both", "keep one");
    post.ignored_words = r.list("ignored");
    for (std::size_t i = 0; i < post.ignored_words.size(); ++i) {
        const std::string& word = post.ignored_words[i];
        if (!is_nc_word(word) || std::find(post.words.begin(), post.words.end(), word) != post.words.end())
            throw Error(ErrorCode::out_of_range, element("words.ignored", i),
                        "'" + printable(word) + "' is no word, or has a meaning", "leave it out");
    }
    r.finish();
    for (const NcWord w : {NcWord::x, NcWord::y, NcWord::z, NcWord::feed})
        if (post.word(w).empty())
            throw Error(ErrorCode::missing_key, "words", "X, Y, Z or the feed has no word", "write it");
}

void read_codes(PostReader& file, Post& post) {
    const Json& object = file.need("codes", "write what the codes mean: { \"G0\": \"rapid\", ... }");
    expect_object(object, "codes");
    std::vector<std::string> known;
    for (const auto& [word, code] : code_words())
        known.push_back(word);
    for (auto it = object.begin(); it != object.end(); ++it) {
        const std::string place = member("codes", it.key()), word = read_text(it.value(), place);
        if (!is_nc_code(it.key()))
            throw Error(ErrorCode::out_of_range, place, "this is no code", "write it as G1, G43.4 or TRAORI");
        const auto found = std::find(known.begin(), known.end(), word);
        if (found == known.end())
            throw Error(ErrorCode::out_of_range, place, "'" + printable(word) + "' is no meaning of a code",
                        "known meanings: " + listed(known));
        post.codes[it.key()] = code_words()[std::size_t(found - known.begin())].second;
    }
    // A control has modal kinds of motion, or says in each block which it is.
    const bool modal = !post.has(NcCode::straight);
    for (const NcCode c : {modal ? NcCode::rapid : NcCode::rapid_block,
                           modal ? NcCode::feed : NcCode::straight, NcCode::mm, NcCode::inch, NcCode::end})
        if (!post.has(c))
            throw Error(ErrorCode::missing_key, "codes", "no code means '" + known[std::size_t(c)] + "'",
                        "write it");
}

void read_lines(PostReader& object, const char* key, const std::string& place, std::vector<std::string>& to) {
    to = object.list(key);
    if (to.size() > max_lines) object.refuse(key, "there are too many lines", "leave some out");
    for (std::size_t i = 0; i < to.size(); ++i)
        check_template(to[i], element(place, i));
}

/// Work coordinates that have numbers.
void read_wcs_lines(const Json& object, Post& post) {
    PostReader r(object, "wcs");
    read_lines(r, "on", "wcs.on", post.wcs_lines);
    post.wcs_last = 1;
    r.integer("first", 0L, 99999999L, post.wcs_first);
    r.integer("last", post.wcs_first, 99999999L, post.wcs_last);
    r.finish();
    const auto tells = [](const std::string& line) { return line.find("{wcs}") != std::string::npos; };
    if (std::count_if(post.wcs_lines.begin(), post.wcs_lines.end(), tells) != 1)
        r.refuse("on", "not one line has the word {wcs}", "write it once");
    for (std::size_t i = 0; i < post.wcs_lines.size(); ++i)
        if (std::count(post.wcs_lines.begin(), post.wcs_lines.end(), post.wcs_lines[i]) > 1
            || post.wcs_lines[i].find('{') != post.wcs_lines[i].find("{wcs}"))
            throw Error(ErrorCode::out_of_range, element("wcs.on", i),
                        "the line occurs twice, or has other words than {wcs}", "change it");
}

void read_wcs(PostReader& file, Post& post) {
    file.boolean("wcs_optional", post.wcs_optional);
    if (const Json* numbers = file.find("wcs"); numbers && numbers->is_object())
        return read_wcs_lines(*numbers, post);
    post.wcs = file.list("wcs");
    for (std::size_t i = 0; i < post.wcs.size(); ++i) {
        if (!is_nc_code(post.wcs[i]) || post.codes.contains(post.wcs[i]))
            throw Error(ErrorCode::out_of_range, element("wcs", i),
                        "this is no code, or it has another meaning", "write it as G54");
        post.codes[post.wcs[i]] = NcCode::wcs;
    }
}

void read_planes(PostReader& file, Post& post) {
    const Json* object = file.find("plane");
    if (!object) return;
    PostReader r(*object, "plane");
    read_lines(r, "on", "plane.on", post.plane_on);
    read_lines(r, "off", "plane.off", post.plane_off);
    r.text("approach", post.plane_approach);
    check_template(post.plane_approach, "plane.approach");
    r.boolean("turns", post.plane_turns);
    r.finish();
    const auto tells = [](const std::string& line) {
        return line.find("{plane_z}") != std::string::npos && line.find("{plane_x}") != std::string::npos;
    };
    if (std::count_if(post.plane_on.begin(), post.plane_on.end(), tells) != 1)
        r.refuse("on", "not one line has the words {plane_z} and {plane_x}", "write both in one line");
    if (post.plane_off.empty()) r.refuse("off", "nothing ends the tilted plane", "write the lines");
    if (post.multi_axis == Post::MultiAxis::none || post.multi_axis == Post::MultiAxis::joints)
        r.refuse("on", "tilted planes are for controls that know the kinematics",
                 "set multi_axis to tcp or vectors");
    if (!post.plane_turns && !post.has(NcCode::plane_axes))
        r.refuse("turns", "nothing turns the rotary axes: no code means 'plane_axes'",
                 "add one, or write true");
}

void read_templates(PostReader& file, Post& post) {
    const auto lines = [&](const char* key, std::vector<std::string>& to) { read_lines(file, key, key, to); };
    lines("start", post.start);
    lines("tool_change", post.tool_change);
    lines("operation", post.operation);
    lines("retract", post.retract);
    lines("tcp_on", post.tcp_on);
    lines("tcp_off", post.tcp_off);
    lines("end", post.end);
    file.text("approach", post.approach);
    check_template(post.approach, "approach");
    file.text("tcp_approach", post.tcp_approach);
    check_template(post.tcp_approach, "tcp_approach");
    if (post.retract.empty())
        throw Error(ErrorCode::missing_key, "retract", "nothing takes the tool up", "write the lines");
    if (const Json* object = file.find("coolant")) {
        PostReader r(*object, "coolant");
        const char* const keys[] = {"off", "on", "mist", "flood"};
        for (std::size_t i = 0; i < 4; ++i)
            r.text(keys[i], post.coolant[i]);
        r.finish();
    }
}

void read_multi_axis(PostReader& file, Post& post) {
    const Json* object = file.find("multi_axis");
    if (!object) return;
    PostReader r(*object, "multi_axis");
    static const std::vector<std::string> kinds = {"none", "joints", "tcp", "vectors"};
    std::string kind;
    r.text("kind", kind);
    const auto found = std::find(kinds.begin(), kinds.end(), kind);
    if (found == kinds.end()) r.refuse("kind", "there is no such kind", "write one of: " + listed(kinds));
    post.multi_axis = Post::MultiAxis(found - kinds.begin());
    double degrees = 0.1;
    r.number("axis_degrees", 0.001, 2, degrees);
    r.boolean("vector_at_start", post.vector_at_start);
    r.boolean("drops_wcs", post.drops_wcs);
    post.axis_tolerance = radians(degrees);
    r.finish();
    const auto needs = [&](NcCode code, const char* name) {
        if (!post.has(code))
            r.refuse("kind", std::string("no code means '") + name + "'", "add one to codes");
    };
    if (post.multi_axis == Post::MultiAxis::joints) needs(NcCode::inverse_time, "inverse_time");
    if (post.multi_axis == Post::MultiAxis::tcp && !post.has(NcCode::tcp_switch)) needs(NcCode::tcp, "tcp");
    if (post.multi_axis == Post::MultiAxis::vectors) {
        needs(NcCode::tcp_vectors, "tcp_vectors");
        for (const NcWord w : {NcWord::i, NcWord::j, NcWord::k})
            if (post.word(w).empty()) r.refuse("kind", "the vector has no words", "add i, j and k to words");
    }
    if (post.has(NcCode::inverse_time)) needs(NcCode::per_minute, "per_minute");
    if (post.multi_axis == Post::MultiAxis::vectors && post.has(NcCode::straight))
        needs(NcCode::straight_vectors, "straight_vectors");
}

/// Codes and words that arcs told in this way need.
void check_arcs(const PostReader& r, const Post& post) {
    const auto needs = [&](NcCode code, const char* name) {
        if (!post.has(code))
            r.refuse("kind", std::string("no code means '") + name + "'", "add one to codes");
    };
    if (post.arcs == Post::Arcs::pole) {
        needs(NcCode::arc, "arc");
        needs(NcCode::arc_centre, "arc_centre");
        needs(NcCode::turns_clockwise, "turns_clockwise");
        needs(NcCode::turns_anticlockwise, "turns_anticlockwise");
        if (post.helix || post.arc_planes != std::array<bool, 3>{false, false, true})
            r.refuse("kind", "arcs about a centre of their own block are told in XY and do not climb",
                     "write \"planes\": [\"xy\"] and \"helix\": false");
        return;
    }
    needs(NcCode::arc_clockwise, "arc_clockwise");
    needs(NcCode::arc_anticlockwise, "arc_anticlockwise");
    const bool several = post.arc_planes[0] || post.arc_planes[1];
    if (several || post.has(NcCode::plane_xy)) needs(NcCode::plane_xy, "plane_xy");
    if (post.arc_planes[1]) needs(NcCode::plane_xz, "plane_xz");
    if (post.arc_planes[0]) needs(NcCode::plane_yz, "plane_yz");
    if (post.arcs == Post::Arcs::radius && post.word(NcWord::radius).empty())
        r.refuse("kind", "the radius has no word", "add radius to words");
    for (int axis = 0; axis < 3 && post.arcs == Post::Arcs::centre; ++axis)
        if (post.word(post.centre_word(axis)).empty())
            r.refuse("kind", "the centre has no words", "add i, j and k to words, or centre_x and so on");
}

void read_arcs(PostReader& file, Post& post) {
    const Json* object = file.find("arcs");
    if (!object) return;
    PostReader r(*object, "arcs");
    static const std::vector<std::string> kinds = {"none", "centre", "radius", "pole"};
    std::string kind;
    r.text("kind", kind);
    const auto found = std::find(kinds.begin(), kinds.end(), kind);
    if (found == kinds.end()) r.refuse("kind", "there is no such kind", "write one of: " + listed(kinds));
    post.arcs = Post::Arcs(found - kinds.begin());
    static const std::vector<std::string> planes = {"yz", "xz", "xy"};
    const std::vector<std::string> wanted = r.list("planes");
    if (!wanted.empty()) post.arc_planes = {};
    for (const std::string& plane : wanted) {
        const auto one = std::find(planes.begin(), planes.end(), plane);
        if (one == planes.end())
            r.refuse("planes", "there is no such plane", "write some of: " + listed(planes));
        post.arc_planes[std::size_t(one - planes.begin())] = true;
    }
    r.boolean("helix", post.helix);
    r.number("smallest_radius", 0.001, 1e5, post.smallest_radius);
    r.number("largest_radius", 0.001, 1e5, post.largest_radius);
    r.finish();
    if (post.arcs != Post::Arcs::none) check_arcs(r, post);
}

Post read_post(const Json& json, std::string_view text) {
    PostReader file(json, "");
    const Json& version = file.need("facetmill_post", "write 1: the version of the file");
    if (!version.is_number_integer()) wrong_type("facetmill_post", version, "the version, 1");
    if (version.get<double>() > double(newest_post))
        throw Error(ErrorCode::newer_version, "facetmill_post", "the file is for a newer Facetmill",
                    "update Facetmill");
    if (version.get<double>() < 1) file.refuse("facetmill_post", "there is no such version", "write 1");
    Post post;
    post.source = std::string(text);
    post.label = read_text(file.need("label", "name the control as people call it"), "label");
    file.text("description", post.description, 2000);
    post.extension = read_text(file.need("extension", "write it with the dot: .ngc"), "extension");
    const bool plain = post.extension.size() >= 2 && post.extension.size() <= 8 && post.extension[0] == '.'
                       && std::all_of(post.extension.begin() + 1, post.extension.end(),
                                      [](unsigned char c) { return c < 128 && std::isalnum(c); });
    if (!plain || post.extension == ".apt" || post.extension == ".json")
        file.refuse("extension", "this is no extension of a program", "write a dot and letters, as .ngc");
    std::string ends = "lf";
    file.text("line_end", ends);
    if (ends != "lf" && ends != "crlf") file.refuse("line_end", "there is no such end", "write lf or crlf");
    if (ends == "crlf") post.line_end = "\r\n";
    bool blanks = true;
    file.boolean("blanks", blanks);
    if (!blanks) post.separator.clear();
    long longest = long(post.max_block);
    file.integer("block_length", 40, 1000, longest);
    post.max_block = std::size_t(longest);
    file.boolean("modal", post.modal);
    file.boolean("straight_rapids", post.straight_rapids);
    file.boolean("rapid_feed", post.rapid_feed);
    file.number("largest_feed", 0, 1e6, post.max_feed);
    file.number("largest_inverse_time", 0, 1e9, post.max_inverse_time);
    file.integer("largest_tool", 1L, 99999999L, post.max_tool);
    file.integer("largest_program", 1L, 99999999L, post.max_program);
    read_numbers(file, post);
    read_comments(file, post);
    read_block_numbers(file, post);
    read_words(file, post);
    read_codes(file, post);
    read_wcs(file, post);
    post.changes_tools = post.has(NcCode::tool_change);
    file.boolean("changes_tools", post.changes_tools);
    read_templates(file, post);
    read_multi_axis(file, post);
    read_planes(file, post);
    read_arcs(file, post);
    file.finish();
    return post;
}

} // namespace

const std::string& Post::code(NcCode what) const {
    static const std::string nothing;
    for (const auto& [text, meaning] : codes)
        if (meaning == what) return text;
    return nothing;
}

NcWord Post::centre_word(int axis) const {
    const NcWord own = NcWord(std::size_t(NcWord::centre_x) + std::size_t(axis));
    return word(own).empty() ? NcWord(std::size_t(NcWord::i) + std::size_t(axis)) : own;
}

bool Post::knows_wcs(std::string_view wanted) const {
    if (wcs_lines.empty()) return std::find(wcs.begin(), wcs.end(), wanted) != wcs.end();
    long number = 0;
    const auto read = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    return read.ec == std::errc() && number >= wcs_first && number <= wcs_last
           && std::to_string(number) == wanted;
}

std::string Post::default_wcs() const {
    if (wcs_optional) return {};
    if (!wcs_lines.empty()) return std::to_string(wcs_first);
    return wcs.empty() ? std::string() : wcs.front();
}

bool Post::tells(std::string_view template_word) const {
    const std::string word = "{" + std::string(template_word) + "}";
    const auto in = [&](const std::string& line) { return line.find(word) != std::string::npos; };
    for (const auto* lines : {&start, &tool_change, &operation, &retract, &tcp_on, &tcp_off, &plane_on, &end})
        if (std::any_of(lines->begin(), lines->end(), in)) return true;
    return in(approach) || in(tcp_approach) || in(plane_approach);
}

std::string Post::known_wcs() const {
    if (wcs_lines.empty()) return listed(wcs);
    return "the numbers from " + std::to_string(wcs_first) + " to " + std::to_string(wcs_last);
}

const std::vector<std::string>& post_template_words() {
    static const std::vector<std::string> words = {"part",  "program", "operation", "tool",   "tool_name",
                                                   "speed", "wcs",     "coolant",   "units",  "blend",
                                                   "safe",  "rapid",   "plane_z",   "plane_x"};
    return words;
}

const std::vector<Post>& posts() {
    static const auto all = built_in<Post>(post_files, parse_post);
    return all;
}

const Post& find_post(std::string_view name) {
    return find_built_in(posts(), name, "post");
}

bool is_post_file(std::string_view name) {
    return name.ends_with(".json");
}

Post parse_post(std::string_view json, const std::string& file) {
    const Json root = parse_strict_json(json, file);
    try {
        return read_post(root, json);
    } catch (const Error& e) {
        throw e.within(file);
    }
}

Post load_post(const std::filesystem::path& path) {
    return load_own<Post>(path, parse_post);
}

} // namespace facetmill
