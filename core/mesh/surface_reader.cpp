#include "core/mesh/surface_reader.h"

#include "core/base/child_process.h"
#include "core/base/tolerances.h"
#include "core/mesh/mesh_format.h"
#include "core/mesh/tessellated.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>

namespace facetmill::detail {

namespace {

constexpr const char* reader_name = "facetmill-step";
/// Cancelling is heard after this (ms).
constexpr int poll_milliseconds = 20;
/// Bytes at the end of a file in which its last line is looked for.
constexpr std::size_t end_bytes = 4096;

bool sniff_step(std::string_view bytes) {
    return bytes.substr(0, 1024).find("ISO-10303-21") != std::string_view::npos;
}

/// Lines of 80 columns, the first ones of section S.
bool sniff_iges(std::string_view bytes) {
    return bytes.size() > 80 && bytes[72] == 'S' && bytes.substr(73, 7).find('1') != std::string_view::npos
           && is_text(bytes.substr(0, 80));
}

std::vector<std::filesystem::path> reader_places() {
    if (const char* named = std::getenv("FACETMILL_STEP"); named && *named) return {named};
    return program_places(reader_name);
}

std::unique_ptr<ChildProcess> start_reader(const MeshSource& source, const std::string& format,
                                           const SurfaceLimits& limits, const MemoryFile& input,
                                           const MemoryFile& output) {
    const auto number = [](double v) { return format_number(v, 17); };
    const std::vector<std::string> arguments = {"--format",
                                                format,
                                                "--chord",
                                                number(source.reading.chord),
                                                "--angle",
                                                number(degrees(source.reading.chord_angle)),
                                                "--memory",
                                                number(limits.memory_mb),
                                                std::string(ChildProcess::input_path),
                                                std::string(ChildProcess::output_path)};
    for (const auto& place : reader_places())
        try {
            return std::make_unique<ChildProcess>(place, arguments, input, output);
        } catch (const Error& e) {
            if (e.code() != ErrorCode::not_found) throw e.within(source.name);
        }
    throw Error(ErrorCode::not_found, source.name,
                std::string("the program that reads such files, ") + reader_name + ", is not here",
                "install all of Facetmill, or build it with OpenCASCADE; or export the part as STL");
}

/// What the program says: progress goes on to ours, the lines of an error are kept.
class Listener {
public:
    explicit Listener(const Progress& progress) : progress_(progress) {}

    /// Takes whole lines out of `text`.
    void hear(std::string& text) {
        for (std::size_t end; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1))
            line(std::string_view(text).substr(0, end));
        if (text.size() > max_line) text.clear();
    }
    const std::map<std::string, std::string, std::less<>>& said() const { return said_; }

private:
    static constexpr std::size_t max_line = 1u << 16;

    void line(std::string_view line) {
        const std::size_t space = line.find(' ');
        const std::string_view key = line.substr(0, space),
                               rest = space == std::string_view::npos ? "" : line.substr(space + 1);
        if (key != "progress") {
            if (said_.size() < 16) said_[std::string(key)] = printable(rest, 400);
            return;
        }
        const std::size_t end = rest.find(' ');
        double fraction = 0;
        if (read_number(rest.substr(0, end), fraction) != NumberForm::number) return;
        const double from = std::clamp(fraction, 0.0, 1.0);
        progress_.part(from, from, end == std::string_view::npos ? "" : printable(rest.substr(end + 1)))
            .set(0);
    }

    const Progress& progress_;
    std::map<std::string, std::string, std::less<>> said_;
};

ErrorCode code_of(std::string_view word) {
    for (int i = 0; i <= int(ErrorCode::internal); ++i)
        if (code_name(ErrorCode(i)) == word) return ErrorCode(i);
    return ErrorCode::internal;
}

/// Follows the program to its end.
void attend(ChildProcess& child, const MeshSource& source, const SurfaceLimits& limits,
            const Progress& progress) {
    using Clock = std::chrono::steady_clock;
    const std::string remedy = "export the part again, or as STL";
    Listener listener(progress);
    std::string text;
    for (auto last = Clock::now();;) {
        progress.check(); // the child is ended on the way out
        const std::size_t before = text.size();
        const bool more = child.read(text, poll_milliseconds);
        if (text.size() != before) last = Clock::now();
        listener.hear(text);
        if (!more) break;
        if (std::chrono::duration<double>(Clock::now() - last).count() > limits.silent_seconds)
            throw Error(ErrorCode::internal, source.name,
                        std::string(reader_name) + " has said nothing for "
                            + format_number(limits.silent_seconds, 3) + " s and was stopped",
                        remedy);
    }
    const int status = child.wait();
    if (status == 0) return;
    const auto& said = listener.said();
    const auto word = [&](std::string_view key) {
        const auto found = said.find(key);
        return found == said.end() ? std::string() : found->second;
    };
    if (status == 1 && said.count("what"))
        throw Error(code_of(word("error")), source.name, word("what"), word("remedy"));
    throw Error(ErrorCode::internal, source.name,
                std::string(reader_name)
                    + (status < 0 ? " crashed at it (signal " + std::to_string(-status) + ")"
                                  : " failed at it (status " + std::to_string(status) + ")"),
                remedy);
}

/// The lines at the head of what the program wrote.
class ResultHead {
public:
    ResultHead(std::string_view bytes, const std::string& name) : name_(name) {
        const std::size_t end = bytes.find("\n\n");
        if (end == std::string_view::npos || !bytes.starts_with(std::string(tessellated_magic) + "\n"))
            fail();
        size_ = end + 2;
        TextCursor cursor{bytes.substr(0, end + 1), tessellated_magic.size() + 1};
        while (!cursor.at_end()) {
            const std::size_t begin = cursor.position;
            cursor.to_line_end();
            const std::string_view line = cursor.text.substr(begin, cursor.position - begin);
            cursor.skip_line_end();
            const std::size_t space = std::min(line.find(' '), line.size());
            const std::string value = printable(line.substr(std::min(space + 1, line.size())), 200);
            if (line.substr(0, space) == "part")
                parts_.push_back(value);
            else
                values_[std::string(line.substr(0, space))] = value;
        }
    }

    std::size_t size() const { return size_; }
    std::vector<std::string>& parts() { return parts_; }
    std::string text(const std::string& key) const {
        const auto found = values_.find(key);
        return found == values_.end() ? std::string() : found->second;
    }
    double number(const std::string& key) const {
        double value = 0;
        if (read_number(text(key), value) != NumberForm::number || value < 0) fail();
        return value;
    }
    std::size_t count(const std::string& key) const {
        const double value = number(key);
        if (value > 4e9) fail();
        return std::size_t(value);
    }
    [[noreturn]] void fail() const {
        throw Error(ErrorCode::internal, name_, std::string(reader_name) + " handed over something else",
                    "install Facetmill and " + std::string(reader_name) + " of the same version");
    }

private:
    std::string name_;
    std::size_t size_ = 0;
    std::map<std::string, std::string> values_;
    std::vector<std::string> parts_;
};

/// The unit that the file states, where it is one that meshes have; its numbers are taken in millimetres
/// else.
LengthUnit unit_of(double mm) {
    for (const LengthUnit unit : mesh_units)
        if (std::abs(mm_per(unit) / mm - 1) < tolerance::figure_rounding) return unit;
    return LengthUnit::mm;
}

/// What the program says of the file as a whole.
void take_facts(ResultHead& head, const MeshReading& reading, TriangleSoup& soup) {
    soup.unit = unit_of(head.number("mm_per_unit"));
    SurfaceReport report;
    report.unit = head.text("unit");
    report.chord = reading.chord;
    report.chord_angle = reading.chord_angle;
    report.out = head.number("out");
    report.in = head.number("in");
    report.faces = head.count("faces");
    report.solids = head.count("solids");
    report.loose_faces = head.count("loose_faces");
    report.missing_faces = head.count("missing_faces");
    report.part_count = head.count("part_count");
    report.parts = std::move(head.parts());
    if (head.count("sewn") != 0) soup.warnings.insert("surfaces_joined");
    if (report.loose_faces > 0) soup.warnings.insert("loose_surfaces");
    if (report.missing_faces > 0) soup.warnings.insert("surfaces_missing");
    if (report.part_count > 1 || report.solids > 1) soup.warnings.insert("several_bodies");
    if (std::max(report.out, report.in) > reading.chord) soup.warnings.insert("chord_exceeded");
    if (!report.parts.empty()) soup.name = report.parts.front();
    soup.surfaces = std::move(report);
}

TriangleSoup take_result(std::string_view bytes, const MeshSource& source, const Progress& progress) {
    ResultHead head(bytes, source.name);
    TriangleSoup soup;
    take_facts(head, source.reading, soup);
    const std::size_t vertices = head.count("vertices"), facets = head.count("facets");
    const char* at = bytes.data() + head.size();
    if (facets == 0 || facets > max_tessellated_facets
        || bytes.size() - head.size() != vertices * 24 + facets * 16)
        head.fail();
    soup.indexed = true;
    soup.points.resize(vertices);
    const double mm = mm_per(*soup.unit);
    for (std::size_t v = 0; v < vertices; ++v, at += 24) {
        if (v % 65536 == 0) progress.check();
        std::array<double, 3> p{};
        std::memcpy(p.data(), at, sizeof p);
        const Vec3 point(p[0] + 0.0, p[1] + 0.0, p[2] + 0.0); // no negative zeros
        if (!point.allFinite())
            throw Error(ErrorCode::non_finite, source.name, "a surface has a place that is not finite",
                        "export the part again");
        if (point.cwiseAbs().maxCoeff() > tolerance::largest_coordinate)
            throw Error(ErrorCode::coordinate_range, source.name,
                        "a coordinate is larger than " + format_number(tolerance::largest_coordinate) + " mm",
                        "export the part nearer to its origin, and check its unit");
        soup.points[v] = point / mm;
    }
    soup.facets.resize(facets);
    std::memcpy(soup.facets.data(), at, facets * sizeof(Facet));
    at += facets * sizeof(Facet);
    soup.faces.resize(facets);
    std::memcpy(soup.faces.data(), at, facets * sizeof(Index));
    for (std::size_t f = 0; f < facets; ++f) {
        const Facet& corners = soup.facets[f];
        if (std::max({corners[0], corners[1], corners[2]}) >= vertices
            || soup.faces[f] >= soup.surfaces->faces)
            head.fail();
    }
    return soup;
}

bool ends_as_step(std::string_view bytes) {
    return bytes.substr(bytes.size() - std::min(bytes.size(), end_bytes)).find("END-ISO-10303-21")
           != std::string_view::npos;
}

/// The last line is one of section T.
bool ends_as_iges(std::string_view bytes) {
    while (!bytes.empty() && (is_space(bytes.back()) || bytes.back() == '\0' || bytes.back() == '\x1A'))
        bytes.remove_suffix(1);
    const std::size_t end = bytes.find_last_of("\r\n");
    const std::string_view last = end == std::string_view::npos ? bytes : bytes.substr(end + 1);
    return last.size() > 72 && last[72] == 'T';
}

[[noreturn]] void fail_cut(const MeshSource& source, const std::string& what) {
    throw Error(ErrorCode::truncated, source.name, what + " is missing at its end",
                "the file was cut: copy or export it again");
}

void refuse_other(const MeshSource& source, bool is_one, const char* name, const char* label) {
    if (is_one) return;
    const std::string_view what = content_of(source.bytes, name);
    throw Error(ErrorCode::unsupported_format, source.name,
                what.empty() ? std::string("it is not ") + label
                             : "it is " + std::string(what) + ", not " + label,
                "rename or export it again");
}

TriangleSoup read_step_file(const MeshSource& source, const Progress& progress) {
    refuse_other(source, sniff_step(source.bytes), "STEP", "a STEP file");
    if (!ends_as_step(source.bytes)) fail_cut(source, "the line END-ISO-10303-21; of a STEP file");
    TriangleSoup soup = read_surfaces(source, "step", {}, progress);
    soup.format = "STEP";
    return soup;
}

TriangleSoup read_iges_file(const MeshSource& source, const Progress& progress) {
    refuse_other(source, sniff_iges(source.bytes), "IGES", "an IGES file");
    if (!ends_as_iges(source.bytes)) fail_cut(source, "the section T of an IGES file");
    TriangleSoup soup = read_surfaces(source, "iges", {}, progress);
    soup.format = "IGES";
    return soup;
}

} // namespace

TriangleSoup read_surfaces(const MeshSource& source, const std::string& format, const SurfaceLimits& limits,
                           const Progress& progress) {
    progress.check();
    MemoryFile input("facetmill-surfaces"), output("facetmill-facets");
    input.write(source.bytes);
    {
        const auto child = start_reader(source, format, limits, input, output);
        attend(*child, source, limits, progress.part(0, 0.95));
    }
    return take_result(output.bytes(), source, progress.part(0.95, 1));
}

MeshFormat step_format() {
    return {.name = "STEP",
            .label = "a STEP file",
            .extensions = {".step", ".stp"},
            .sniff = sniff_step,
            .read = read_step_file,
            .has_surfaces = true};
}

MeshFormat iges_format() {
    return {.name = "IGES",
            .label = "an IGES file",
            .extensions = {".iges", ".igs"},
            .sniff = sniff_iges,
            .read = read_iges_file,
            .has_surfaces = true};
}

} // namespace facetmill::detail
