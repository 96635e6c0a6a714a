#include "core/output/cl_program.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"

#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// Programs carry six decimals: a feed that is 0 with them is none.
constexpr double program_digits = 1e6;

std::array<double, 7> values(const AptCutter& c) {
    return {c.d, c.r, c.e, c.f, c.alpha, c.beta, c.h};
}

std::string place(const ClSection& p) {
    return "program '" + printable(p.operation_name) + "'";
}

void check_positive(double value, const ClSection& p, const char* what) {
    if (!std::isfinite(value))
        throw Error(ErrorCode::non_finite, place(p), std::string("the ") + what + " is not a finite number",
                    "set the " + std::string(what));
    if (!(value * program_digits >= 1.0) || value > tolerance::largest_program_coordinate)
        throw Error(ErrorCode::out_of_range, place(p),
                    std::string("the ") + what + " " + format_number(value) + " cannot be written",
                    "change it");
}

void check_motions(const ClSection& p) {
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

void check_section(const ClSection& s, LengthUnit unit) {
    check_motions(s);
    const double per = mm_per(unit);
    check_positive(s.feed_mm_per_min / per, s, "feed");
    if (!s.motion_feeds.empty() && s.motion_feeds.size() != s.motions.motions.size())
        throw Error(ErrorCode::internal, place(s), "has feeds of some motions only", "report this");
    for (const double feed : s.motion_feeds)
        check_positive(feed / per, s, "feed");
    check_positive(s.spindle_rpm, s, "spindle speed");
    for (const double v : values(s.cutter))
        if (!std::isfinite(v) || std::abs(v) > tolerance::largest_program_coordinate)
            throw Error(ErrorCode::non_finite, place(s), "a dimension of the cutter is not a usable number",
                        "check the tool");
}

} // namespace

bool same_tool(const ClSection& a, const ClSection& b) {
    return a.tool_number == b.tool_number && values(a.cutter) == values(b.cutter);
}

void check_writable(const ClProgram& program) {
    if (program.sections.empty())
        throw Error(ErrorCode::empty_result, "program '" + printable(program.part_name) + "'",
                    "there is no operation in it", "plan at least one");
    for (std::size_t i = 0; i < program.sections.size(); ++i) {
        const ClSection& s = *program.sections[i];
        check_section(s, program.unit);
        for (std::size_t k = 0; k < i; ++k)
            if (s.tool_number == program.sections[k]->tool_number && !same_tool(s, *program.sections[k]))
                throw Error(ErrorCode::out_of_range, place(s),
                            "tool " + std::to_string(s.tool_number) + " is another cutter in "
                                + place(*program.sections[k]),
                            "give each tool a number of its own");
    }
}

} // namespace facetmill
