// APT, read tolerantly: what other systems write around the path is read over and listed, but a word that
// moves the tool in a way this reader does not know, or moves the coordinates, is an error: a wrong path is
// worse than none.
#include "core/base/tolerances.h"
#include "core/output/apt.h"
#include "core/output/apt_sections.h"
#include "core/output/apt_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace facetmill {

namespace {

using namespace detail;

constexpr std::size_t apt_lines_per_check = 4096;
constexpr std::size_t max_ignored = 1000;
constexpr std::size_t max_fields = 16;

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
        : text_(bytes, std::move(name)), unit_(unit),
          sections_([this](const std::string& what, long line) { ignore(what, line); }) {
        result_.program.unit = unit;
    }

    AptReadResult run(const Progress& progress);

private:
    [[noreturn]] void fail(ErrorCode code, const std::string& what, const std::string& remedy) const {
        text_.fail(code, what, remedy);
    }
    [[noreturn]] void syntax(const std::string& what, const std::string& remedy) const {
        fail(ErrorCode::syntax, what, remedy);
    }

    void statement(std::string_view text);
    void text_statement(const std::string& word, std::string_view rest);
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

    void ignore(const std::string& word) { ignore(word, text_.statement_line()); }
    void ignore(const std::string& word, long line);
    void go_to(const std::string& word);
    void go_delta();
    void units();
    void cutter();
    void load_tool(const std::string& word);
    void feed();
    void spindle();
    void coolant();
    void move_to(const Vec3& tip, bool rapid);
    void finish();

    AptText text_;
    LengthUnit unit_;
    AptSections sections_;

    AptReadResult result_;
    std::vector<std::string_view> fields_;
    std::unordered_map<std::string, bool> ignored_;
    Vec3 axis_ = Vec3::UnitZ();
    bool rapid_ = false, ended_ = false, fini_ = false, lengths_seen_ = false;
};

void Reader::comment(std::string_view text) {
    constexpr std::string_view key = "OPERATION NAME";
    text = trimmed(text);
    if (!starts_with_word(text, key)) return;
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos) sections_.operation(printable(trimmed(text.substr(colon + 1)), 200));
}

void Reader::text_statement(const std::string& word, std::string_view rest) {
    if (!rest.empty() && rest.front() == '/') rest.remove_prefix(1);
    rest = trimmed(rest);
    if (word == "PARTNO")
        result_.program.part_name = printable(rest, 200);
    else if (word == "TPRINT")
        sections_.tool_name(printable(rest, 200));
    else
        ignore(word);
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
    if (is_text_word(word)) return text_statement(word, text.substr(n));
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

void Reader::ignore(const std::string& word, long line) {
    if (ignored_.size() >= max_ignored || !ignored_.emplace(word, true).second) return;
    result_.ignored.push_back(word + " (line " + std::to_string(line) + ")");
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
    sections_.cutter(c);
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
    sections_.tool_number(long(n));
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
    sections_.feed({*value * per, per_turn});
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
        sections_.spindle(v, text_.statement_line());
        return;
    }
}

void Reader::coolant() {
    static constexpr std::array<std::pair<std::string_view, Coolant>, 4> words = {
        {{"OFF", Coolant::off}, {"ON", Coolant::on}, {"MIST", Coolant::mist}, {"FLOOD", Coolant::flood}}};
    const std::string word = fields_.empty() ? std::string() : upper(fields_[0]);
    for (const auto& [name, coolant] : words)
        if (word == name) return sections_.coolant(coolant, text_.statement_line());
    ignore("COOLNT/" + printable(word, 20));
}

void Reader::move_to(const Vec3& tip, bool rapid) {
    if (ended_) syntax("there is motion after END", "split the file: one program each");
    sections_.move(tip, axis_, rapid, text_.statement_line());
    rapid_ = false;
}

void Reader::go_to(const std::string& word) {
    if (fields_.size() != 3 && fields_.size() != 6)
        syntax(word + " has " + std::to_string(fields_.size()) + " values",
               "write " + word + "/x,y,z or " + word + "/x,y,z,i,j,k");
    const Vec3 tip = lengths(0, word);
    if (fields_.size() == 6) axis_ = axis_fields(3, word);
    move_to(tip, rapid_ || word == "FROM");
}

void Reader::go_delta() {
    const CutterLocation* from = sections_.position();
    if (!from) syntax("GODLTA has no place to start from", "put GOTO or FROM before it");
    Vec3 step;
    if (fields_.size() == 1)
        step = axis_ * (field_number(0, "GODLTA") * scale());
    else if (fields_.size() == 3)
        step = lengths(0, "GODLTA");
    else
        syntax("GODLTA has " + std::to_string(fields_.size()) + " values",
               "write GODLTA/dx,dy,dz or GODLTA/d");
    const Vec3 tip = from->tip + step;
    if (!(tip.cwiseAbs().maxCoeff() <= tolerance::largest_program_coordinate))
        fail(ErrorCode::coordinate_range, "GODLTA leaves the range of coordinates",
             "check the file and its units");
    move_to(tip, rapid_);
}

void Reader::dispatch(const std::string& word, std::string_view arguments) {
    if (word == "GOTO" || word == "FROM") {
        split(arguments);
        go_to(word);
    } else if (word == "GODLTA") {
        split(arguments);
        go_delta();
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
    } else if (word == "COOLNT") {
        split(arguments);
        coolant();
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
    text_.end();
    if (!ended_) {
        // Without FINI a cut at a line's end cannot be told from a file that never had one; within a line it
        // can.
        if (!text_.complete_last_line())
            fail(ErrorCode::truncated, "the file ends within a line, without FINI or END",
                 "export it again, or end it with FINI");
        ignore("no FINI or END: the file may be cut short");
    }
    if (!sections_.cuts())
        throw Error(ErrorCode::empty_result, text_.name(), "there is no motion at feed in the file",
                    "check that it is an APT CL file");
    sections_.finish(result_, text_.statement_line());
}

AptReadResult Reader::run(const Progress& progress) {
    AptLine line;
    while (text_.next(line)) {
        if (text_.line_number() % long(apt_lines_per_check) == 0) progress.set(text_.fraction());
        if (!line.comment.empty()) comment(line.comment);
        statement(line.statement);
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
