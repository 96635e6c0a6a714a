// APT, written strictly.
//
// Rounding. Coordinates carry six decimals of the file's unit. In a 3-axis program x and y go to the nearest
// digit and z goes up to the next, so that rounding never lowers the tool: what is left is the shift in x and
// y, at most half a digit, which costs half a digit times the slope. In a multi-axis program all three go to
// the nearest digit, and the axis carries eight decimals (1e-8 rad; six would move a holder 100 mm up by 1e-4
// mm).
#include "core/base/latin.h"
#include "core/base/tolerances.h"
#include "core/output/apt.h"
#include "core/output/program_writer.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <initializer_list>

namespace facetmill {

namespace {

constexpr std::size_t line_limit = 72;
constexpr std::size_t buffer_limit = std::size_t(1) << 16;
constexpr std::size_t apt_motions_per_check = 4096;

constexpr int coordinate_decimals = 6, axis_decimals = 8;

/// Text for a comment, a name or a title: ASCII, no '$' (it would start a continuation), one line.
std::string plain_text(std::string_view name, std::size_t limit) {
    const std::string text = without_marks(name);
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

std::string_view coolant_word(Coolant coolant) {
    switch (coolant) {
    case Coolant::off:
        return "OFF";
    case Coolant::on:
        return "ON";
    case Coolant::mist:
        return "MIST";
    case Coolant::flood:
        return "FLOOD";
    }
    return "OFF";
}

void write_cutter(Lines& out, const AptCutter& c, double per) {
    out.statement("CUTTER", {number(c.d / per), number(c.r / per), number(c.e / per), number(c.f / per),
                             number(degrees(c.alpha)), number(degrees(c.beta)), number(c.h / per)});
}

/// What stands before the motions of a section, and ends the one `before` it (null: this one is the first).
void write_head(Lines& out, const ClProgram& program, const ClSection& s, const ClSection* before) {
    const double per = mm_per(program.unit);
    const bool inch = program.unit == LengthUnit::inch;
    const bool load = !before || !same_tool(*before, s);
    if (before) {
        out.text("COOLNT/OFF");
        out.text("SPINDL/OFF");
    }
    out.text("$$ -----------------------------------------------------------------");
    if (!before) out.text("$$ FACETMILL CL FILE, TOOL TIP IN PART COORDINATES");
    out.text("$$ OPERATION NAME : " + plain_text(s.operation_name, 52));
    out.text("$$ -----------------------------------------------------------------");
    if (!before) {
        out.text("PARTNO " + plain_text(program.part_name, 65));
        out.text(inch ? "UNITS/INCHES" : "UNITS/MM");
    }
    if (load) write_cutter(out, s.cutter, per);
    if (s.multi_axis) {
        out.text("MULTAX/ON");
    } else {
        if (before && before->multi_axis) out.text("MULTAX/OFF");
        out.statement("TLAXIS", {number(0), number(0), number(1)});
    }
    if (load) {
        if (!s.tool_name.empty()) out.text("TPRINT/" + plain_text(s.tool_name, 65));
        out.text("LOADTL/" + std::to_string(s.tool_number));
    }
    out.statement("SPINDL", {number(s.spindle_rpm), "RPM", "CLW"});
    out.statement("COOLNT", {coolant_word(s.coolant)});
}

void write_motions(Lines& out, const ClSection& s, LengthUnit unit, const Progress& progress) {
    const double per = mm_per(unit);
    const std::string_view feed_word = unit == LengthUnit::inch ? "IPM" : "MMPM";
    std::string feed = number(s.feed_mm_per_min / per);
    out.statement("FEDRAT", {feed, feed_word});

    const auto& motions = s.motions.motions;
    const double scale = power_of_ten(coordinate_decimals);
    std::string field;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (i % apt_motions_per_check == 0) progress.set(double(i) / double(motions.size()));
        const Motion& m = motions[i];
        if (m.kind == MotionKind::rapid) {
            out.text("RAPID");
        } else if (!s.motion_feeds.empty()) {
            field = number(s.feed(i) / per);
            if (field != feed) out.statement("FEDRAT", {field, feed_word});
            feed = field;
        }
        out.begin("GOTO");
        for (int k = 0; k < 3; ++k) {
            const double v = m.to.tip[k] / per * scale;
            const bool up = k == 2 && !s.multi_axis;
            field.clear();
            append_digits(field, up ? (long long)(std::ceil(v - tolerance::cl_digit_noise)) : std::llround(v),
                          coordinate_decimals);
            out.field(field, k == 2 && !s.multi_axis);
        }
        for (int k = 0; s.multi_axis && k < 3; ++k)
            out.field(number(m.to.axis[k], axis_decimals), k == 2);
    }
}

} // namespace

void write_apt(const ClProgram& program, OutputFile& file, const Progress& progress) {
    check_writable(program);
    Lines out(file);
    const ClSection* before = nullptr;
    const double n = double(program.sections.size());
    for (std::size_t i = 0; i < program.sections.size(); ++i) {
        const ClSection& section = *program.sections[i];
        write_head(out, program, section, before);
        write_motions(out, section, program.unit, progress.part(double(i) / n, double(i + 1) / n));
        before = &section;
    }
    out.text("COOLNT/OFF");
    out.text("SPINDL/OFF");
    out.text("END");
    out.text("FINI");
    out.flush();
    progress.set(1.0);
}

const ProgramWriter& apt_writer() {
    return program_writer("apt");
}

namespace {

const ProgramWriterRegistration
    apt_registration({.name = "apt",
                      .label = "APT",
                      .extension = ".apt",
                      .files = [](const ClProgram&) { return std::vector<std::string>{""}; },
                      .write = [](const ClProgram& program, std::size_t, OutputFile& file,
                                  const Progress& progress) { write_apt(program, file, progress); }});

} // namespace

} // namespace facetmill
