#include "core/output/turning_table.h"

#include "core/output/program_writer.h"

#include <cmath>
#include <cstdio>

namespace facetmill {

namespace {

constexpr std::size_t rows_per_check = 4096;
constexpr double full_turn = 360;

/// One table per range: "-pass-01", or nothing for one that is all.
std::vector<std::string> tables(const ClProgram& program) {
    std::vector<std::string> names;
    if (program.sections.size() != 1) return names;
    const ClSection& section = *program.sections.front();
    if (!section.turning || !section.motions.turning) return names;
    for (const ClRange& range : section.turning->ranges) {
        const std::string number = std::to_string(range.pass + 1);
        names.push_back(range.pass < 0 ? "" : "-pass-" + (number.size() < 2 ? "0" + number : number));
    }
    return names;
}

void write_table(const ClProgram& program, std::size_t table, OutputFile& file, const Progress& progress) {
    check_writable(program);
    const ClSection& section = *program.sections.front();
    const ClTurning& turning = *section.turning;
    const ClRange& range = turning.ranges[table];
    const TurningAxis& axis = *section.motions.turning;
    const double per = mm_per(program.unit);
    const Vec3 &d = axis.direction, &zero = turning.zero, side = d.cross(zero);
    std::string text =
        "# " + printable(program.part_name, 200) + ", " + printable(section.operation_name, 200);
    if (range.pass >= 0) text += ", pass " + std::to_string(range.pass + 1);
    text += "\n# turning angle (degrees), Y along the axis, X from the axis ("
            + std::string(unit_name(program.unit)) + "), tool tip\n";
    double angle = 0;
    bool first = true;
    char line[96];
    for (std::size_t i = range.first; i < range.last; ++i) {
        if (i % rows_per_check == 0) progress.check();
        const CutterLocation& at = section.motions.motions[i].to;
        const Vec3 tip = at.tip - axis.point;
        const double here = degrees(std::atan2(at.axis.dot(side), at.axis.dot(zero)));
        if (turning.winding == AngleWinding::unwound) {
            angle = first ? here : angle + std::remainder(here - angle, full_turn);
        } else {
            angle = here < 0 ? here + full_turn : here;
            // What rounds to a whole turn is none.
            if (full_turn - angle < 0.5e-6) angle = 0;
        }
        first = false;
        const Vec3 out = (at.axis - at.axis.dot(d) * d).normalized();
        // No "-0.000000".
        const auto plain = [](double v) { return std::abs(v) < 0.5e-6 ? 0.0 : v; };
        const int n = std::snprintf(line, sizeof line, "%.6f %.6f %.6f\n", plain(angle),
                                    plain(tip.dot(d) / per), plain(tip.dot(out) / per));
        text.append(line, std::size_t(n));
        if (text.size() > (std::size_t(1) << 16)) {
            file.write(text);
            text.clear();
        }
    }
    file.write(text);
    progress.check();
}

const ProgramWriterRegistration turning_table_registration({.name = "turning-table",
                                                            .label = "Turning table",
                                                            .extension = ".txt",
                                                            .files = tables,
                                                            .write = write_table});

} // namespace

std::vector<ClRange> turning_ranges(const ToolMotions& made, const StrategyResult& path) {
    const auto& motions = made.motions;
    std::vector<ClRange> ranges;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (motions[i].pass == no_index) continue;
        const int layer = path.passes[motions[i].pass].layer;
        if (!ranges.empty() && ranges.back().pass == layer) continue;
        ClRange range{layer, 0, motions.size()};
        if (!ranges.empty()) {
            // The pass before ends where its tool is out again: after the retract and the rapid that goes on
            // along the same axis.
            std::size_t out = i;
            while (out > 0 && motions[out - 1].kind != MotionKind::retract)
                --out;
            if (out < i && out > 0 && motions[out].kind == MotionKind::rapid
                && motions[out].to.axis == motions[out - 1].to.axis)
                ++out;
            ranges.back().last = range.first = out;
        }
        ranges.push_back(range);
    }
    return ranges;
}

} // namespace facetmill
