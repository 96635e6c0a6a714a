// facetmill-cli drop: axial lifts at given points.
#include "app/cli_commands.h"
#include "app/cli_mesh.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/base/strict_json.h"
#include "core/gouge/axial_lift.h"
#include "core/mesh/mesh_io.h"

#include <charconv>
#include <cmath>

namespace facetmill::cli {

namespace {

constexpr std::size_t points_per_chunk = std::size_t(1) << 16;
constexpr std::size_t max_points = 200'000'000;
constexpr int decimals = 9;
constexpr double per_digit = 1e9;

struct Grid {
    std::size_t nx = 0, ny = 0;
};

Grid parse_grid(const std::string& text) {
    const auto bad = [&](const std::string& what) {
        throw Error(ErrorCode::usage, "--grid", "'" + printable(text) + "' " + what,
                    "write NXxNY, as in 500x500");
    };
    const std::size_t x = text.find_first_of("xX");
    if (x == std::string::npos) bad("is not a grid");
    Grid grid;
    const auto count = [&](std::string_view digits, std::size_t& n) {
        const auto r = std::from_chars(digits.data(), digits.data() + digits.size(), n);
        if (digits.empty() || r.ec != std::errc() || r.ptr != digits.data() + digits.size())
            bad("is not a grid");
    };
    count(std::string_view(text).substr(0, x), grid.nx);
    count(std::string_view(text).substr(x + 1), grid.ny);
    if (grid.nx == 0 || grid.ny == 0) bad("has no points");
    if (grid.nx > max_points || grid.ny > max_points / grid.nx) bad("has too many points");
    return grid;
}

/// To the digit that is printed, so that the lift is taken exactly where its line says.
double rounded(double v) {
    return std::round(v * per_digit) / per_digit;
}

double grid_coordinate(double low, double high, std::size_t i, std::size_t n) {
    return n == 1 ? (low + high) / 2 : low + (high - low) * (double(i) / double(n - 1));
}

/// "x y" per line; blank lines and lines that start with '#' are read over, as is what follows the two
/// numbers.
std::vector<Vec2> read_points(const std::string& path, double largest, const Progress& progress) {
    const InputFile file(path);
    std::string_view text = file.bytes();
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::vector<Vec2> points;
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r'; };
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = text.substr(at, end - at);
        at = end + 1;
        if (++number % 4096 == 0) progress.set(double(at) / double(text.size()));
        const auto where = [&] { return printable(path, 400) + ":" + std::to_string(number); };
        double v[2] = {0, 0};
        std::size_t fields = 0;
        while (!line.empty()) {
            if (blank(line.front())) {
                line.remove_prefix(1);
                continue;
            }
            if (fields == 0 && line.front() == '#') break;
            if (fields == 2)
                throw Error(ErrorCode::syntax, where(), "there are more than two numbers",
                            "write x y on each line");
            std::size_t n = 0;
            while (n < line.size() && !blank(line[n]))
                ++n;
            const std::string_view word = line.substr(0, n);
            line.remove_prefix(n);
            if (!parse_number(word, v[fields]))
                throw Error(ErrorCode::syntax, where(), "'" + printable(word, 30) + "' is not a number",
                            "write x y on each line");
            if (std::abs(v[fields]) > largest)
                throw Error(ErrorCode::coordinate_range, where(),
                            "the coordinate " + printable(word, 30) + " is too large", "check the units");
            ++fields;
        }
        if (fields == 1)
            throw Error(ErrorCode::syntax, where(), "there is only one number", "write x y on each line");
        if (fields == 0) continue;
        if (points.size() == max_points)
            throw Error(ErrorCode::limit_exceeded, where(), "there are too many points", "split the file");
        points.emplace_back(v[0], v[1]);
    }
    if (points.empty())
        throw Error(ErrorCode::empty_result, printable(path, 400), "there are no points",
                    "write x y on each line");
    return points;
}

void append(std::string& out, double v, char end) {
    if (std::isinf(v)) {
        out += v < 0 ? "-inf" : "inf";
    } else {
        char text[400];
        const double shown = v == 0.0 || std::abs(v) * per_digit < 0.5 ? 0.0 : v; // never "-0.000000000"
        out.append(text,
                   std::to_chars(text, text + sizeof text, shown, std::chars_format::fixed, decimals).ptr);
    }
    out += end;
}

AptCutter read_cutter(const std::string& text, double per) {
    try {
        return parse_cutter(text, per);
    } catch (const Error& e) {
        // What cannot be read is wrong usage; a cutter that cannot be is a failure of the job.
        const Error named = e.within("--cutter");
        throw Error(e.code() == ErrorCode::syntax ? ErrorCode::usage : e.code(), named.where(), e.message(),
                    e.remedy());
    }
}

void run_drop(const Arguments& arguments, Session& session) {
    const LengthUnit unit = arguments.unit("--units", LengthUnit::mm);
    const double per = mm_per(unit);
    if (arguments.has("--grid") == arguments.has("--points"))
        throw Error(ErrorCode::usage, "drop", "the points are missing or given twice",
                    "give either --grid or --points");
    Grid grid;
    if (arguments.has("--grid")) grid = parse_grid(arguments.value("--grid"));
    const CutterProfile cutter(read_cutter(arguments.value("--cutter"), per));
    use_threads(arguments);

    refuse_to_overwrite(arguments.operand(0), arguments.value("-o"));
    if (arguments.has("--points")) refuse_to_overwrite(arguments.value("--points"), arguments.value("-o"));
    OutputFile file(arguments.value("-o")); // first, so that a place that cannot be written is told at once
    const Progress progress = session.progress();
    std::vector<Vec2> given;
    if (arguments.has("--points"))
        given =
            read_points(arguments.value("--points"), 1e7 / per, progress.part(0.0, 0.05, "Reading points"));
    const LoadedMesh loaded = load_mesh(arguments.operand(0), asked_reading(arguments),
                                        progress.part(0.05, 0.2, "Reading the part"));
    const auto index =
        std::make_shared<const ContactIndex>(loaded.mesh, progress.part(0.2, 0.35, "Indexing the part"));
    const AxialLift lift(index, cutter);
    const Box3 box = loaded.mesh->box();

    const std::size_t n = given.empty() ? grid.nx * grid.ny : given.size();
    const auto point = [&](std::size_t i) -> Vec2 { // in the file's unit
        if (!given.empty()) return given[i];
        return {grid_coordinate(box.lo.x() / per, box.hi.x() / per, i % grid.nx, grid.nx),
                grid_coordinate(box.lo.y() / per, box.hi.y() / per, i / grid.nx, grid.ny)};
    };
    std::vector<Vec2> shown, points;
    std::vector<double> heights;
    std::string text;
    std::size_t contacts = 0;
    double lowest = infinity, highest = -infinity;
    for (std::size_t begin = 0; begin < n; begin += points_per_chunk) {
        const std::size_t count = std::min(points_per_chunk, n - begin);
        shown.resize(count);
        points.resize(count);
        heights.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 p = point(begin + i);
            shown[i] = {rounded(p.x()), rounded(p.y())};
            points[i] = shown[i] * per;
        }
        const double from = 0.35 + 0.65 * double(begin) / double(n),
                     to = 0.35 + 0.65 * double(begin + count) / double(n);
        lift.tip_z(points, heights, progress.part(from, to, "Dropping the cutter"));
        text.clear();
        for (std::size_t i = 0; i < count; ++i) {
            const double z = heights[i] / per;
            append(text, shown[i].x(), ' ');
            append(text, shown[i].y(), ' ');
            append(text, z, '\n');
            if (!std::isfinite(z)) continue;
            ++contacts;
            lowest = std::min(lowest, z);
            highest = std::max(highest, z);
        }
        progress.check();
        file.write(text);
    }
    progress.check();
    file.close_stream();

    Json out;
    out["file"] = printable(arguments.value("-o"), 400);
    out["units"] = std::string(unit_name(unit));
    out["points"] = n;
    out["contacts"] = contacts;
    if (contacts > 0) {
        out["z_min"] = json_number(lowest, "drop");
        out["z_max"] = json_number(highest, "drop");
    }
    session.print(pretty_json(out));
    file.commit();
}

} // namespace

Command drop_command() {
    return {
        .name = "drop",
        .operands = {"PART"},
        .summary =
            "Lowers a cutter onto a part at given points and writes 'x y z' of the tip, 9 decimals a number.",
        .help = "SHAPE: ball:D, flat:D, bull:D,r, cone:D,half_angle_deg, apt:d,r,e,f,alpha,beta,h (lengths "
                "in --units,\n"
                "angles in degrees). A grid spans the part's box, both ends included, x running fastest; a "
                "points file\n"
                "has 'x y' on each line ('#' starts a comment). The lift is exact for the x and y that are "
                "printed. A\n"
                "cutter that meets nothing has z = -inf.",
        .options = with_reading_options(
            {{.name = "--cutter", .value = "SHAPE", .help = "the cutter", .required = true},
             {.name = "--grid", .value = "NXxNY", .help = "points on a grid over the part"},
             {.name = "--points", .value = "FILE", .help = "points from a file, or:"},
             {.name = "--units",
              .value = "UNIT",
              .help = "unit of all numbers: mm, cm, m, in, ft (default: mm)"},
             threads_option(),
             {.name = "-o", .value = "FILE", .help = "the file to write", .required = true}}),
        .run = run_drop};
}

} // namespace facetmill::cli
