// APT, written strictly.
//
// Rounding. Coordinates carry six decimals of the file's unit. In a 3-axis program x and y go to the nearest
// digit and z goes up to the next, so that rounding never lowers the tool: what is left is the shift in x and
// y, at most half a digit, which costs half a digit times the slope. In a multi-axis program all three go to
// the nearest digit, and the axis carries eight decimals (1e-8 rad; six would move a holder 100 mm up by 1e-4
// mm).
#include "core/base/tolerances.h"
#include "core/output/apt.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <initializer_list>

namespace facetmill {

namespace {

constexpr std::size_t line_limit = 72;
constexpr std::size_t buffer_limit = std::size_t(1) << 16;
constexpr std::size_t motions_per_check = 4096;

constexpr int coordinate_decimals = 6, axis_decimals = 8;

/// Text for a comment, a name or a title: ASCII, no '$' (it would start a continuation), one line.
std::string plain_text(std::string_view text, std::size_t limit) {
    std::string out;
    for (std::size_t i = 0; i < text.size() && out.size() < limit; ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if ((c & 0xC0) == 0x80) continue; // one '?' per UTF-8 character
        out += c < 0x20 || c >= 0x7F ? '?' : c == '$' ? 'S' : char(c);
    }
    while (!out.empty() && out.back() == ' ')
        out.pop_back();
    return out;
}

/// An integer number of 10^-decimals as decimal text.
void append_digits(std::string& out, long long digits, int decimals) {
    if (digits < 0) {
        out += '-';
        digits = -digits;
    }
    char text[24];
    const auto end = std::to_chars(text, text + sizeof text, digits).ptr;
    const std::size_t n = std::size_t(end - text), places = std::size_t(decimals);
    if (n > places) {
        out.append(text, n - places);
    } else {
        out += '0';
    }
    out += '.';
    if (n < places) out.append(places - n, '0');
    out.append(n > places ? end - decimals : text, std::min(n, places));
}

double power_of_ten(int n) {
    return n == 8 ? 1e8 : 1e6;
}

std::string number(double value, int decimals = coordinate_decimals) {
    std::string out;
    append_digits(out, std::llround(value * power_of_ten(decimals)), decimals);
    return out;
}

/// Collects statements into lines of at most 72 characters.
class Lines {
public:
    explicit Lines(OutputFile& file) : file_(file) {}

    void text(std::string_view line) {
        buffer_.append(line.substr(0, line_limit));
        buffer_ += '\n';
        if (buffer_.size() >= buffer_limit) flush();
    }
    void statement(std::string_view word, std::initializer_list<std::string_view> fields) {
        begin(word);
        std::size_t i = 0;
        for (std::string_view f : fields)
            field(f, ++i == fields.size());
    }
    void begin(std::string_view word) {
        buffer_.append(word);
        buffer_ += '/';
        column_ = word.size() + 1;
    }
    void field(std::string_view f, bool last) {
        // After the field come ',' and perhaps '$', or nothing when it is the last.
        if (column_ + f.size() + (last ? 0 : 2) > line_limit) {
            buffer_ += "$\n    ";
            column_ = 4;
        }
        buffer_.append(f);
        column_ += f.size() + 1;
        if (!last) {
            buffer_ += ',';
            return;
        }
        buffer_ += '\n';
        if (buffer_.size() >= buffer_limit) flush();
    }
    void flush() {
        file_.write(buffer_);
        buffer_.clear();
    }

private:
    OutputFile& file_;
    std::string buffer_;
    std::size_t column_ = 0;
};

std::string place(const ClProgram& p) {
    return "program '" + printable(p.operation_name) + "'";
}

void check_positive(double value, const ClProgram& p, const char* what) {
    if (!std::isfinite(value))
        throw Error(ErrorCode::non_finite, place(p), std::string("the ") + what + " is not a finite number",
                    "set the " + std::string(what));
    if (!(value * power_of_ten(coordinate_decimals) >= 1.0) || value > tolerance::largest_program_coordinate)
        throw Error(ErrorCode::out_of_range, place(p),
                    std::string("the ") + what + " " + format_number(value) + " cannot be written",
                    "change it");
}

void check_motions(const ClProgram& p) {
    bool cuts = false;
    for (std::size_t i = 0; i < p.motions.motions.size(); ++i) {
        const Motion& m = p.motions.motions[i];
        cuts = cuts || m.kind != MotionKind::rapid;
        const auto where = [&] { return place(p) + ": motion " + std::to_string(i + 1); };
        if (!m.to.tip.allFinite() || !m.to.axis.allFinite())
            throw Error(ErrorCode::non_finite, where(), "a coordinate is not a finite number",
                        "plan again; report the project");
        if (m.to.tip.cwiseAbs().maxCoeff() > tolerance::largest_program_coordinate)
            throw Error(ErrorCode::coordinate_range, where(), "a coordinate is too large",
                        "check the part's units");
        const Vec3 off =
            p.multi_axis ? Vec3(m.to.axis * (m.to.axis.norm() - 1.0)) : Vec3(m.to.axis - Vec3::UnitZ());
        if (!(off.norm() <= tolerance::unit_axis))
            throw Error(ErrorCode::internal, where(),
                        p.multi_axis ? "the tool axis has not length 1"
                                     : "the tool axis of a 3-axis program is not +Z",
                        "plan again; report the project");
    }
    if (!cuts)
        throw Error(ErrorCode::empty_result, place(p), "there is no motion that cuts",
                    "check part, tool and tolerance");
}

} // namespace

void write_apt(const ClProgram& p, OutputFile& file, const Progress& progress) {
    check_motions(p);
    const double per = mm_per(p.unit);
    const double feed = p.feed_mm_per_min / per;
    check_positive(feed, p, "feed");
    check_positive(p.spindle_rpm, p, "spindle speed");
    const AptCutter& c = p.cutter;
    for (double v : {c.d, c.r, c.e, c.f, c.alpha, c.beta, c.h})
        if (!std::isfinite(v) || std::abs(v) > tolerance::largest_program_coordinate)
            throw Error(ErrorCode::non_finite, place(p), "a dimension of the cutter is not a usable number",
                        "check the tool");

    const bool inch = p.unit == LengthUnit::inch;
    const std::string tool = std::to_string(p.tool_number);
    Lines out(file);
    out.text("$$ -----------------------------------------------------------------");
    out.text("$$ FACETMILL CL FILE, TOOL TIP IN PART COORDINATES");
    out.text("$$ OPERATION NAME : " + plain_text(p.operation_name, 52));
    out.text("$$ -----------------------------------------------------------------");
    out.text("PARTNO " + plain_text(p.part_name, 65));
    out.text(inch ? "UNITS/INCHES" : "UNITS/MM");
    out.statement("CUTTER", {number(c.d / per), number(c.r / per), number(c.e / per), number(c.f / per),
                             number(degrees(c.alpha)), number(degrees(c.beta)), number(c.h / per)});
    if (p.multi_axis)
        out.text("MULTAX/ON");
    else
        out.statement("TLAXIS", {number(0), number(0), number(1)});
    if (!p.tool_name.empty()) out.text("TPRINT/" + plain_text(p.tool_name, 65));
    out.text("LOADTL/" + tool);
    out.statement("SPINDL", {number(p.spindle_rpm), "RPM", "CLW"});
    out.text("COOLNT/ON");
    out.statement("FEDRAT", {number(feed), inch ? "IPM" : "MMPM"});

    const auto& motions = p.motions.motions;
    const double scale = power_of_ten(coordinate_decimals);
    std::string field;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (i % motions_per_check == 0) progress.set(double(i) / double(motions.size()));
        const Motion& m = motions[i];
        if (m.kind == MotionKind::rapid) out.text("RAPID");
        out.begin("GOTO");
        for (int k = 0; k < 3; ++k) {
            const double v = m.to.tip[k] / per * scale;
            const bool up = k == 2 && !p.multi_axis;
            field.clear();
            append_digits(field, up ? (long long)(std::ceil(v - tolerance::cl_digit_noise)) : std::llround(v),
                          coordinate_decimals);
            out.field(field, k == 2 && !p.multi_axis);
        }
        for (int k = 0; p.multi_axis && k < 3; ++k)
            out.field(number(m.to.axis[k], axis_decimals), k == 2);
    }
    out.text("COOLNT/OFF");
    out.text("SPINDL/OFF");
    out.text("END");
    out.text("FINI");
    out.flush();
    progress.set(1.0);
}

} // namespace facetmill
