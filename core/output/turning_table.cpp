#include "core/output/turning_table.h"

#include "core/base/tolerances.h"

#include <cmath>
#include <cstdio>

namespace facetmill {

namespace {

constexpr std::size_t motions_per_check = 4096;
constexpr double full_turn = 360;

} // namespace

std::vector<TurningTableRange> turning_table_ranges(const ClProgram& program, const StrategyResult& path) {
    const auto& motions = program.motions.motions;
    std::vector<TurningTableRange> ranges;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (motions[i].pass == no_index) continue;
        const int layer = path.passes[motions[i].pass].layer;
        if (!ranges.empty() && ranges.back().pass == layer) continue;
        TurningTableRange range{layer, 0, motions.size()};
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

void write_turning_table(const ClProgram& program, const TurnedPath& turned, const TurningTableRange& range,
                         AngleWinding winding, OutputFile& file, const Progress& progress) {
    if (!program.motions.turning)
        throw Error(ErrorCode::internal, "program '" + printable(program.operation_name) + "'",
                    "has no turning axis", "report this");
    const double per = mm_per(program.unit);
    const Vec3 &d = turned.axis.direction, &zero = turned.zero, side = d.cross(zero);
    std::string text =
        "# " + printable(program.part_name, 200) + ", " + printable(program.operation_name, 200);
    if (range.pass >= 0) text += ", pass " + std::to_string(range.pass + 1);
    text += "\n# turning angle (degrees), Y along the axis, X from the axis ("
            + std::string(unit_name(program.unit)) + "), tool tip\n";
    double angle = 0;
    bool first = true;
    char line[96];
    for (std::size_t i = range.first; i < range.last; ++i) {
        if (i % motions_per_check == 0) progress.check();
        const CutterLocation& at = program.motions.motions[i].to;
        const Vec3 tip = at.tip - turned.axis.point;
        const double here = degrees(std::atan2(at.axis.dot(side), at.axis.dot(zero)));
        if (winding == AngleWinding::unwound) {
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

} // namespace facetmill
