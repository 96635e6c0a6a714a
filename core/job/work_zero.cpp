#include "core/job/work_zero.h"

#include "core/job/planner.h"
#include "core/job/posting.h"
#include "core/job/stock_solid.h"

namespace facetmill {

namespace {

using From = ProgramSpec::ZeroFrom;

Vec3 vector_of(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// -1 to 1, as the form has it.
std::string level_text(double at) {
    if (at == -1) return "bottom";
    if (at == 0) return "middle height";
    if (at == 1) return "top";
    return format_number(50 * (at + 1), 4) + " % of";
}

std::string side_text(double at, const std::string& axis) {
    if (at == -1) return "low " + axis;
    if (at == 0) return "middle of " + axis;
    if (at == 1) return "high " + axis;
    return format_number(50 * (at + 1), 4) + " % of " + axis;
}

} // namespace

Vec3 work_zero(const ProgramSpec& spec, const Box3& part, const Box3& stock) {
    Vec3 typed = vector_of(spec.zero);
    if (spec.zero_from == From::origin) return typed;
    const Box3& box = spec.zero_from == From::stock ? stock : part;
    if (box.empty())
        throw Error(ErrorCode::missing_reference, "zero_from",
                    spec.zero_from == From::stock ? "the stock is not there" : "the part is not there",
                    "put the zero elsewhere, or mend the file");
    return box.center() + 0.5 * vector_of(spec.zero_place).cwiseProduct(box.size()) + typed;
}

Vec3 work_zero(const Project& project, const PreparedPart& part) {
    const bool asks = project.programs.zero_from == From::stock;
    return work_zero(project.programs, part.box, asks ? stock_solid(project.stock, part).box : Box3());
}

std::string work_zero_name(const Project& project) {
    if (!project.programs.wcs.empty()) return project.programs.wcs;
    if (project.programs.post.empty()) return "zero";
    try {
        const Post post = project_post(project, project.programs.post);
        if (const std::string wcs = post.default_wcs(); !wcs.empty()) return wcs;
    } catch (const Error&) {
        // Told where programs are posted.
    }
    return "zero";
}

std::string work_zero_text(const ProgramSpec& spec, LengthUnit unit) {
    std::string text = "the part's origin";
    if (spec.zero_from != From::origin) {
        const std::string z = level_text(spec.zero_place[2]), x = side_text(spec.zero_place[0], "X"),
                          y = side_text(spec.zero_place[1], "Y");
        text = spec.zero_from == From::stock ? "the stock's " + z + ", " + x + ", " + y
                                             : "the part's " + z + ", " + x + ", " + y;
    }
    if (spec.zero == std::array<double, 3>{0, 0, 0}) return text;
    text += " + (";
    for (std::size_t k = 0; k < 3; ++k)
        text += (k > 0 ? ", " : "") + format_number(spec.zero[k] / mm_per(unit), 6);
    return text + ") " + std::string(unit_name(unit));
}

ClSection moved_section(const ClSection& section, const Vec3& by) {
    ClSection moved = section;
    if (!moved.part_box.empty()) {
        moved.part_box.lo += by;
        moved.part_box.hi += by;
    }
    for (Motion& m : moved.motions.motions)
        m.to.tip += by;
    moved.motions.clearance_z += by.z();
    if (moved.motions.turning) moved.motions.turning->point += by;
    return moved;
}

} // namespace facetmill
