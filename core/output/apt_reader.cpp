// APT, read tolerantly: what other systems write around the path is read over and listed, but a word that
// moves the tool in a way this reader does not know, or moves the coordinates, is an error: a wrong path is
// worse than none.
#include "core/base/tolerances.h"
#include "core/output/apt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

namespace facetmill {

namespace {

constexpr std::size_t lines_per_check = 4096;
constexpr std::size_t max_ignored = 1000;
constexpr std::size_t max_fields = 16;

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view s) {
    while (!s.empty() && is_blank(s.front()))
        s.remove_prefix(1);
    while (!s.empty() && is_blank(s.back()))
        s.remove_suffix(1);
    return s;
}

char upper(char c) {
    return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
}

std::string upper(std::string_view s) {
    std::string out(s);
    for (char& c : out)
        c = upper(c);
    return out;
}

bool starts_with_word(std::string_view line, std::string_view word) {
    if (line.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (upper(line[i]) != word[i]) return false;
    return line.size() == word.size() || !std::isalnum(static_cast<unsigned char>(line[word.size()]));
}

/// The rest of these is text, in which '$' and '/' mean nothing.
constexpr std::array<std::string_view, 7> text_words = {"PARTNO", "PPRINT", "TPRINT", "INSERT",
                                                        "LETTER", "REMARK", "NOTE"};

/// Words that move the tool along more than a straight line, move the coordinates, or run the program out of
/// order.
constexpr std::array<std::string_view, 57> refused_words = {
    "ARC",    "ARCSLP", "AUTOPS", "CALL",   "CIRCLE",  "COPY",   "CURVE",  "CYLNDR", "DNTCUT", "DO",
    "GCONIC", "HELIX",  "IF",     "INCLUD", "INCLUDE", "INDEX",  "INDIRP", "INDIRV", "INTERP", "JUMPTO",
    "LCONIC", "LINE",   "LOOPND", "LOOPST", "MACRO",   "MATRIX", "MOVARC", "NOPS",   "NURBS",  "OFFSET",
    "ORIGIN", "PATERN", "PLANE",  "POCKET", "POINT",   "PSIS",   "READ",   "REFSYS", "ROTABL", "ROTATE",
    "ROTHED", "SCULPT", "SPLINE", "TERMAC", "THICK",   "TLLFT",  "TLOFPS", "TLON",   "TLONPS", "TLRGT",
    "TRACUT", "TRANS",  "TRANTO", "UNTIL",  "VECTOR",  "WHILE",  "ZSURF"};
static_assert(std::is_sorted(refused_words.begin(), refused_words.end()));

class Reader {
public:
    Reader(std::string_view bytes, std::string name, LengthUnit unit)
        : bytes_(bytes), name_(std::move(name)), unit_(unit) {
        result_.program.unit = unit;
    }

    AptReadResult run(const Progress& progress);

private:
    [[noreturn]] void fail(ErrorCode code, const std::string& what, const std::string& remedy) const {
        throw Error(code, name_ + ":" + std::to_string(statement_line_), what, remedy);
    }
    [[noreturn]] void syntax(const std::string& what, const std::string& remedy) const {
        fail(ErrorCode::syntax, what, remedy);
    }

    void check_encoding();
    bool next_line(std::string_view& line);
    void line(std::string_view line);
    void statement(std::string_view text);
    void comment(std::string_view text);
    void dispatch(const std::string& word, std::string_view arguments);

    void split(std::string_view arguments);
    double field_number(std::size_t i, const std::string& word) const;
    Vec3 lengths(std::size_t first, const std::string& word);
    Vec3 axis_fields(std::size_t first, const std::string& word) const;
    double scale() {
        lengths_seen_ = true;
        return mm_per(unit_);
    }

    void ignore(const std::string& word);
    void units();
    void cutter();
    void load_tool(const std::string& word);
    void feed();
    void spindle();
    void move_to(const Vec3& tip, const Vec3& axis, bool rapid);
    void finish();

    std::string_view bytes_;
    std::string name_;
    LengthUnit unit_;
    std::size_t at_ = 0;
    long line_number_ = 0, statement_line_ = 1;
    std::string pending_; ///< a statement that '$' continues
    bool continues_ = false, complete_last_line_ = true;

    AptReadResult result_;
    std::vector<std::string_view> fields_;
    std::unordered_map<std::string, bool> ignored_;
    Vec3 axis_ = Vec3::UnitZ();
    bool rapid_ = false, ended_ = false, fini_ = false, lengths_seen_ = false, cut_ = false;
    std::optional<double> feed_per_turn_;
    bool feed_seen_ = false, spindle_seen_ = false;
};

void Reader::check_encoding() {
    const auto starts = [&](std::string_view bom) { return bytes_.substr(0, bom.size()) == bom; };
    if (starts("\xFF\xFE") || starts("\xFE\xFF")
        || bytes_.substr(0, 4096).find('\0') != std::string_view::npos)
        fail(ErrorCode::encoding, "the file is not plain text (UTF-16 or binary)",
             "save it as ASCII or UTF-8");
    if (starts("\xEF\xBB\xBF")) at_ = 3;
}

bool Reader::next_line(std::string_view& line) {
    if (at_ >= bytes_.size()) return false;
    const std::size_t end = bytes_.find_first_of("\r\n", at_);
    ++line_number_;
    complete_last_line_ = end != std::string_view::npos;
    line = bytes_.substr(at_, complete_last_line_ ? end - at_ : std::string_view::npos);
    at_ = complete_last_line_ ? end + 1 : bytes_.size();
    if (complete_last_line_ && bytes_[end] == '\r' && at_ < bytes_.size() && bytes_[at_] == '\n') ++at_;
    return true;
}

void Reader::line(std::string_view text) {
    if (!continues_) statement_line_ = line_number_;
    const std::string_view body = trimmed(text);
    const auto joined = [&](std::string_view part) -> std::string_view {
        if (!continues_) return part;
        pending_.append(part);
        return pending_;
    };
    const bool literal =
        continues_ ? false : std::any_of(text_words.begin(), text_words.end(), [&](std::string_view w) {
            return starts_with_word(body, w);
        });
    // '$$' starts a comment; a single '$' ends the line and continues the statement. In a text only a last
    // '$' does.
    std::size_t dollar = literal ? std::string_view::npos : body.find('$');
    if (literal && !body.empty() && body.back() == '$' && !body.ends_with("$$")) dollar = body.size() - 1;
    if (dollar == std::string_view::npos) {
        statement(joined(body));
    } else if (dollar + 1 < body.size() && body[dollar + 1] == '$') {
        comment(body.substr(dollar + 2));
        const std::string_view before = trimmed(body.substr(0, dollar));
        if (continues_ && before.empty()) return; // a comment between the lines of a statement
        statement(joined(before));
    } else {
        if (!continues_) pending_.clear();
        pending_.append(body.substr(0, dollar));
        continues_ = true;
        return;
    }
    pending_.clear();
    continues_ = false;
}

void Reader::comment(std::string_view text) {
    constexpr std::string_view key = "OPERATION NAME";
    text = trimmed(text);
    if (!result_.program.motions.motions.empty() || !starts_with_word(text, key)) return;
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos)
        result_.program.operation_name = printable(trimmed(text.substr(colon + 1)), 200);
}

void Reader::statement(std::string_view text) {
    text = trimmed(text);
    if (text.empty()) return;
    if (fini_) syntax("there are statements after FINI", "split the file: one program each");
    std::size_t n = 0;
    const auto measure_word = [&] {
        for (n = 0; n < text.size() && std::isalnum(static_cast<unsigned char>(text[n]));)
            ++n;
    };
    measure_word();
    while (n > 0 && n < text.size() && text[n] == ')') { // a label
        text = trimmed(text.substr(n + 1));
        measure_word();
    }
    if (text.empty()) return;
    const std::string word = upper(text.substr(0, n));
    for (std::string_view w : text_words) {
        if (word != w) continue;
        std::string_view rest = text.substr(n);
        if (!rest.empty() && rest.front() == '/') rest.remove_prefix(1);
        rest = trimmed(rest);
        if (w == "PARTNO")
            result_.program.part_name = printable(rest, 200);
        else if (w == "TPRINT")
            result_.program.tool_name = printable(rest, 200);
        else
            ignore(word);
        return;
    }
    const std::string_view rest = trimmed(text.substr(n));
    if (rest.find('=') != std::string_view::npos)
        fail(ErrorCode::unsupported_format, "'" + printable(text, 30) + "' defines geometry or a variable",
             "process the program to plain GOTO statements first");
    if (word.empty() || (word[0] >= '0' && word[0] <= '9')) {
        if (std::any_of(text.begin(), text.end(),
                        [](char c) { return std::isalnum(static_cast<unsigned char>(c)); }))
            syntax("'" + printable(text, 30) + "' is not a statement", "check the file");
        ignore(printable(text, 20)); // "....." where a listing leaves lines out
        return;
    }
    dispatch(word, rest);
}

void Reader::split(std::string_view arguments) {
    fields_.clear();
    if (arguments.empty()) return;
    if (arguments.front() != '/' && arguments.front() != ',')
        syntax("'" + printable(arguments, 30) + "' stands where values should", "write WORD/values");
    arguments = trimmed(arguments.substr(1));
    if (arguments.empty()) return;
    for (;;) {
        const std::size_t comma = arguments.find(',');
        if (fields_.size() == max_fields) syntax("the statement has too many values", "check the file");
        fields_.push_back(trimmed(arguments.substr(0, comma)));
        if (comma == std::string_view::npos) return;
        arguments.remove_prefix(comma + 1);
    }
}

double Reader::field_number(std::size_t i, const std::string& word) const {
    double v = 0;
    if (!parse_number(fields_[i], v))
        syntax("value " + std::to_string(i + 1) + " of " + word + ", '" + printable(fields_[i], 30)
                   + "', is not a number",
               "write decimal numbers");
    return v;
}

Vec3 Reader::lengths(std::size_t first, const std::string& word) {
    Vec3 v;
    for (std::size_t k = 0; k < 3; ++k)
        v[Eigen::Index(k)] = field_number(first + k, word) * scale();
    if (!(v.cwiseAbs().maxCoeff() <= tolerance::largest_program_coordinate))
        fail(ErrorCode::coordinate_range, "a coordinate of " + word + " is too large",
             "check the file and its units");
    return v;
}

Vec3 Reader::axis_fields(std::size_t first, const std::string& word) const {
    Vec3 v;
    for (std::size_t k = 0; k < 3; ++k)
        v[Eigen::Index(k)] = field_number(first + k, word);
    const double largest = v.cwiseAbs().maxCoeff();
    if (!(largest > 0)) syntax("the tool axis of " + word + " is zero", "give i, j, k");
    if (v.head<2>().isZero(0) && v.z() > 0) return Vec3::UnitZ();
    return (v / largest).normalized();
}

void Reader::ignore(const std::string& word) {
    if (ignored_.size() >= max_ignored || !ignored_.emplace(word, true).second) return;
    result_.ignored.push_back(word + " (line " + std::to_string(statement_line_) + ")");
}

void Reader::units() {
    if (fields_.size() != 1) syntax("UNITS names no unit", "write UNITS/MM or UNITS/INCHES");
    const std::string word = upper(fields_[0]);
    LengthUnit unit;
    if (word == "MM" || word == "MMS" || word == "MILLIMETERS" || word == "MILLIMETRES") {
        unit = LengthUnit::mm;
    } else if (word == "INCHES" || word == "INCH" || word == "IN") {
        unit = LengthUnit::inch;
    } else {
        fail(ErrorCode::unsupported_format, "unknown unit '" + printable(fields_[0], 20) + "'",
             "only UNITS/MM and UNITS/INCHES are read");
    }
    if (unit != unit_ && lengths_seen_)
        syntax("UNITS changes after lengths were given", "put UNITS before CUTTER and the first GOTO");
    unit_ = result_.program.unit = unit;
}

void Reader::cutter() {
    if (fields_.size() != 1 && fields_.size() != 2 && fields_.size() != 7)
        syntax("CUTTER has " + std::to_string(fields_.size()) + " values",
               "write CUTTER/d,r,e,f,alpha,beta,h");
    std::array<double, 7> v{};
    for (std::size_t i = 0; i < fields_.size(); ++i)
        v[i] = field_number(i, "CUTTER") * (i == 4 || i == 5 ? pi / 180 : scale());
    AptCutter c;
    try {
        if (fields_.size() == 7)
            c = {v[0], v[1], v[2], v[3], v[4], v[5], v[6]};
        else
            c = AptCutter::from_shape(v[0], v[1], 0, 0, unlimited_height);
        CutterProfile{c};
    } catch (const Error& e) {
        fail(ErrorCode::out_of_range, "CUTTER is not a convex cutter: " + e.message(), e.remedy());
    }
    const AptCutter& old = result_.program.cutter;
    const bool same = c.d == old.d && c.r == old.r && c.e == old.e && c.f == old.f && c.alpha == old.alpha
                      && c.beta == old.beta && c.h == old.h;
    if (result_.had_cutter && !same && !result_.program.motions.motions.empty())
        fail(ErrorCode::unsupported_format, "the cutter changes within the program",
             "split the file: one tool each");
    result_.program.cutter = c;
    result_.had_cutter = true;
}

void Reader::load_tool(const std::string& word) {
    if (fields_.empty()) syntax(word + " names no tool", "write " + word + "/number");
    double n = 0;
    if (!parse_number(fields_[0], n)) { // a name: the path does not depend on it
        ignore(word + "/" + printable(fields_[0], 20));
        return;
    }
    if (n != std::floor(n) || n < 0 || n > 1e9)
        syntax("'" + printable(fields_[0], 20) + "' is not a tool number", "write a whole number");
    if (result_.had_tool && long(n) != result_.program.tool_number
        && !result_.program.motions.motions.empty())
        fail(ErrorCode::unsupported_format, "the tool changes within the program",
             "split the file: one tool each");
    result_.program.tool_number = long(n);
    result_.had_tool = true;
}

void Reader::feed() {
    std::optional<double> value;
    double per = mm_per(unit_);
    bool per_turn = false;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const std::string word = upper(fields_[i]);
        if (word == "IPM" || word == "IPR") {
            per = mm_per_inch;
            per_turn = word == "IPR";
        } else if (word == "MMPM" || word == "MPPM" || word == "MMPR") { // MPPM: as Lu's sample has it
            per = 1;
            per_turn = word == "MMPR";
        } else if (word == "PERMIN" || word == "PERREV") {
            per_turn = word == "PERREV";
        } else if (!value) {
            value = field_number(i, "FEDRAT");
        } else {
            ignore("FEDRAT/" + printable(word, 20));
        }
    }
    if (!value) {
        ignore("FEDRAT without a value");
        return;
    }
    if (!(*value > 0) || *value * per > tolerance::largest_program_coordinate)
        fail(ErrorCode::out_of_range, "the feed " + format_number(*value) + " is out of range",
             "give a positive feed");
    if (cut_ && feed_seen_) {
        // A program has one feed here: the first that cuts. Later ones change times, not the path.
        if (per_turn != feed_per_turn_.has_value()
            || (per_turn ? *feed_per_turn_ : result_.program.feed_mm_per_min) != *value * per)
            ignore("change of FEDRAT");
        return;
    }
    feed_seen_ = true;
    feed_per_turn_.reset();
    if (per_turn)
        feed_per_turn_ = *value * per;
    else
        result_.program.feed_mm_per_min = *value * per;
}

void Reader::spindle() {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const std::string word = upper(fields_[i]);
        if (word == "SFM" || word == "SMM") { // surface speed: not the number of turns
            ignore("SPINDL/" + word);
            return;
        }
    }
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        double v = 0;
        if (!parse_number(fields_[i], v)) continue; // ON, OFF, RPM, CLW, CCLW, RANGE ...
        if (!(v >= 0) || v > 1e7)
            fail(ErrorCode::out_of_range, "the spindle speed is out of range", "give turns per minute");
        if (v == 0) return;
        if (cut_ && spindle_seen_) {
            if (v != result_.program.spindle_rpm) ignore("change of SPINDL");
            return;
        }
        result_.program.spindle_rpm = v;
        spindle_seen_ = true;
        return;
    }
}

void Reader::move_to(const Vec3& tip, const Vec3& axis, bool rapid) {
    if (ended_) syntax("there is motion after END", "split the file: one program each");
    auto& motions = result_.program.motions.motions;
    // The first motion comes from nobody knows where, whatever the file calls it (see ToolMotions).
    const bool first = motions.empty();
    motions.push_back({.kind = rapid || first ? MotionKind::rapid : MotionKind::cut, .to = {tip, axis}});
    cut_ = cut_ || motions.back().kind == MotionKind::cut;
    result_.program.multi_axis = result_.program.multi_axis || axis != Vec3::UnitZ();
    rapid_ = false;
}

void Reader::dispatch(const std::string& word, std::string_view arguments) {
    auto& motions = result_.program.motions.motions;
    if (word == "GOTO" || word == "FROM") {
        split(arguments);
        if (fields_.size() != 3 && fields_.size() != 6)
            syntax(word + " has " + std::to_string(fields_.size()) + " values",
                   "write " + word + "/x,y,z or " + word + "/x,y,z,i,j,k");
        const Vec3 tip = lengths(0, word);
        if (fields_.size() == 6) axis_ = axis_fields(3, word);
        move_to(tip, axis_, rapid_ || word == "FROM");
    } else if (word == "GODLTA") {
        split(arguments);
        if (motions.empty()) syntax("GODLTA has no place to start from", "put GOTO or FROM before it");
        Vec3 step;
        if (fields_.size() == 1)
            step = axis_ * (field_number(0, word) * scale());
        else if (fields_.size() == 3)
            step = lengths(0, word);
        else
            syntax("GODLTA has " + std::to_string(fields_.size()) + " values",
                   "write GODLTA/dx,dy,dz or GODLTA/d");
        const Vec3 tip = motions.back().to.tip + step;
        if (!(tip.cwiseAbs().maxCoeff() <= tolerance::largest_program_coordinate))
            fail(ErrorCode::coordinate_range, "GODLTA leaves the range of coordinates",
                 "check the file and its units");
        move_to(tip, axis_, rapid_);
    } else if (word == "RAPID") {
        rapid_ = true;
    } else if (word == "TLAXIS") {
        split(arguments);
        if (fields_.size() != 3) syntax("TLAXIS has not three values", "write TLAXIS/i,j,k");
        axis_ = axis_fields(0, word);
    } else if (word == "MULTAX") {
        // i, j, k stand on the GOTO statements themselves or do not: nothing to remember.
    } else if (word == "UNITS") {
        split(arguments);
        units();
    } else if (word == "CUTTER") {
        split(arguments);
        cutter();
    } else if (word == "LOADTL" || word == "TOOLNO") {
        split(arguments);
        load_tool(word);
    } else if (word == "FEDRAT") {
        split(arguments);
        feed();
    } else if (word == "SPINDL") {
        split(arguments);
        spindle();
    } else if (word == "END") {
        ended_ = true;
    } else if (word == "FINI") {
        ended_ = fini_ = true;
    } else if (word == "CUTCOM" || word == "CYCLE") {
        split(arguments);
        if (!fields_.empty() && upper(fields_[0]) != "OFF")
            fail(ErrorCode::unsupported_format, word + "/" + printable(fields_[0], 20) + " changes the path",
                 "only " + word + "/OFF is read; output plain GOTO statements");
        ignore(word);
    } else if (std::binary_search(refused_words.begin(), refused_words.end(), word)
               || word.starts_with("GO")) {
        fail(ErrorCode::unsupported_format,
             "the word " + printable(word, 20) + " is not read: it changes the path",
             "output straight GOTO statements (no arcs, cycles or transformations)");
    } else {
        ignore(printable(word, 20));
    }
}

void Reader::finish() {
    statement_line_ = std::max(line_number_, 1L);
    if (continues_) fail(ErrorCode::truncated, "the file ends within a statement", "export it again");
    if (!ended_) {
        // Without FINI a cut at a line's end cannot be told from a file that never had one; within a line it
        // can.
        if (!complete_last_line_)
            fail(ErrorCode::truncated, "the file ends within a line, without FINI or END",
                 "export it again, or end it with FINI");
        ignore("no FINI or END: the file may be cut short");
    }
    ClProgram& p = result_.program;
    if (!cut_)
        throw Error(ErrorCode::empty_result, name_, "there is no motion at feed in the file",
                    "check that it is an APT CL file");
    if (feed_per_turn_) {
        if (spindle_seen_)
            p.feed_mm_per_min = *feed_per_turn_ * p.spindle_rpm;
        else
            ignore("feed per turn without SPINDL");
    }
    double top = -infinity;
    for (const Motion& m : p.motions.motions)
        top = std::max(top, m.to.tip.z());
    p.motions.clearance_z = top;
}

AptReadResult Reader::run(const Progress& progress) {
    check_encoding();
    std::string_view text;
    while (next_line(text)) {
        if (line_number_ % long(lines_per_check) == 0) progress.set(double(at_) / double(bytes_.size()));
        line(text);
    }
    finish();
    progress.set(1.0);
    return std::move(result_);
}

} // namespace

AptReadResult parse_apt(std::string_view text, const std::string& name, LengthUnit default_unit,
                        const Progress& progress) {
    return Reader(text, name, default_unit).run(progress);
}

AptReadResult read_apt(const std::filesystem::path& path, LengthUnit default_unit, const Progress& progress) {
    const InputFile file(path);
    return parse_apt(file.bytes(), printable(path.string(), 400), default_unit, progress);
}

} // namespace facetmill
