// Programs for tests of posts, and the ways of looking at what came of them.
#pragma once

#include "core/base/strict_json.h"
#include "core/output/motion_time.h"
#include "core/output/post/nc_reader.h"
#include "core/output/post/post_writer.h"

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace facetmill::test {

inline std::string changed_text(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the test's text is not there: " + from);
    return text.replace(at, from.size(), to);
}

/// A post of one's own: LinuxCNC's with other text.
inline std::string linuxcnc_with(const std::string& from, const std::string& to) {
    return changed_text(find_post("linuxcnc").source, from, to);
}

inline ClSection plain_section(const std::string& name, long tool, bool several_axes) {
    ClSection s;
    s.operation_name = name;
    s.tool_number = tool;
    s.tool_name = "Ball 6";
    s.cutter = AptCutter::ball(6, 30);
    s.gauge_length = 80 + double(tool);
    s.feed_mm_per_min = 1200;
    s.spindle_rpm = 8000;
    s.multi_axis = several_axes;
    s.part_box.add(Vec3(-30, -20, -10));
    s.part_box.add(Vec3(30, 20, 5));
    return s;
}

inline void add_motion(ClSection& s, MotionKind kind, const Vec3& tip, const Vec3& axis = Vec3::UnitZ()) {
    s.motions.motions.push_back({kind, {tip, axis.normalized()}});
}

/// Rows of cuts with rapids between, at places with more digits than are printed.
inline ClSection upright_section(const std::string& name, long tool, unsigned seed = 1) {
    ClSection s = plain_section(name, tool, false);
    std::mt19937_64 rng(seed);
    std::uniform_real_distribution<double> z(-3, 3), y(-20, 20);
    s.motions.clearance_z = 12;
    for (int row = 0; row < 6; ++row) {
        const double at = y(rng);
        add_motion(s, MotionKind::rapid, Vec3(-25, at, 12));
        add_motion(s, MotionKind::approach, Vec3(-25, at, z(rng)));
        for (int i = 0; i < 20; ++i)
            add_motion(s, MotionKind::cut, Vec3(-25 + 2.34567891 * (i + 1), at + 0.001 * i, z(rng)));
        add_motion(s, MotionKind::retract, Vec3(s.motions.motions.back().to.tip.x(), at, 12));
    }
    return s;
}

/// Rows over a dome, the tool leaning outward and over it; `lean`: at the middle, radians.
inline ClSection leaning_section(const std::string& name, long tool, double lean = 0.2) {
    ClSection s = plain_section(name, tool, true);
    s.motions.clearance_z = 30;
    const auto axis = [&](double x, double y) { return Vec3(lean + 0.015 * x, 0.02 * y, 1); };
    bool back = false;
    for (double y = -15; y <= 15; y += 7.5) {
        const double x0 = back ? 25 : -25;
        add_motion(s, MotionKind::rapid, Vec3(x0, y, 30), axis(x0, y));
        add_motion(s, MotionKind::approach, Vec3(x0, y, 0), axis(x0, y));
        for (double t = 5; t <= 50; t += 5) {
            const double x = back ? 25 - t : -25 + t;
            add_motion(s, MotionKind::cut, Vec3(x, y, 3 - 0.005 * (x * x + y * y)), axis(x, y));
        }
        add_motion(s, MotionKind::retract, Vec3(-x0, y, 30), axis(-x0, y));
        back = !back;
    }
    return s;
}

/// The same motions across an axis instead of +Z.
inline ClSection tilted_section(const ClSection& upright, const Vec3& axis, double scale = 1) {
    ClSection s = plain_section(upright.operation_name, upright.tool_number, true);
    const Vec3 z = axis.normalized(), x = Vec3(z.y(), -z.x(), 0).normalized(), y = z.cross(x);
    for (const Motion& m : upright.motions.motions)
        add_motion(s, m.kind, scale * (m.to.tip.x() * x + m.to.tip.y() * y + m.to.tip.z() * z), axis);
    return s;
}
/// Rows across one axis, as work on an inclined face has them.
inline ClSection indexed_section(const std::string& name, long tool, const Vec3& axis) {
    return tilted_section(upright_section(name, tool), axis, 0.7);
}

/// Whole circles both ways round, a helix, arcs in all three planes, a wave and straight rows, in steps of a
/// few degrees.
inline ClSection round_section(const std::string& name, long tool) {
    ClSection s = plain_section(name, tool, false);
    s.motions.clearance_z = 12;
    const auto run = [&](const auto& place, double angle, int steps) {
        const Vec3 first = place(0.0);
        add_motion(s, MotionKind::rapid, Vec3(first.x(), first.y(), 12));
        add_motion(s, MotionKind::approach, first);
        for (int i = 1; i <= steps; ++i)
            add_motion(s, MotionKind::cut, place(angle * i / steps));
        const Vec3 last = s.motions.motions.back().to.tip;
        add_motion(s, MotionKind::retract, Vec3(last.x(), last.y(), 12));
    };
    const auto circle = [](double r, double a, double z) {
        return Vec3(r * std::cos(a), r * std::sin(a), z);
    };
    run([&](double a) { return circle(12, a, -1); }, 2 * pi, 120);
    run([&](double a) { return circle(9, a + 1, -1); }, -2 * pi, 100);
    run([&](double a) { return circle(5, a, 0.3 * a); }, -4 * pi, 200);
    run([&](double a) { return Vec3(15 * std::sin(a), 7.5, 3 - 15 * std::cos(a)); }, 0.8 * pi, 60);
    run([&](double a) { return Vec3(15 * std::sin(a), 7.5, 15 * std::cos(a) - 18); }, -0.8 * pi, 60);
    run([&](double a) { return Vec3(-7.5, 15 * std::sin(a), 3 - 15 * std::cos(a)); }, 0.8 * pi, 60);
    run([&](double a) { return Vec3(-7.5, 15 * std::sin(a), 15 * std::cos(a) - 18); }, -0.8 * pi, 60);
    run([](double a) { return Vec3(a - 20, 3, 2 * std::sin(0.3 * a)); }, 40, 160);
    run([](double a) { return Vec3(a - 20, 0.5 * a, -2); }, 40, 10);
    return s;
}

inline ClProgram joined_program(const std::vector<ClSection>& sections, LengthUnit unit = LengthUnit::mm) {
    ClProgram p;
    p.part_name = "part";
    p.unit = unit;
    for (const ClSection& s : sections)
        p.sections.push_back(std::make_shared<const ClSection>(s));
    return p;
}

inline PostSetup setup_for(const ClProgram& program, const std::string& machine) {
    PostSetup setup;
    setup.machine = find_machine(machine);
    setup.part_origin = program_part_origin(*program.sections.front(), setup.machine);
    setup.tip_tolerance = 0.005;
    return setup;
}

inline NcSetup reading(const ClProgram& program, const PostSetup& post) {
    NcSetup setup;
    setup.machine = post.machine;
    setup.part_origin = post.part_origin;
    setup.wcs = post.wcs;
    for (const auto& s : program.sections)
        setup.tools[s->tool_number] = {s->tool_name, s->cutter, s->gauge_length};
    return setup;
}

/// Nearest distance of a point to the straight motions of a section.
inline double distance_to_route(const Vec3& p, const ClSection& s) {
    double least = infinity;
    const auto& m = s.motions.motions;
    for (std::size_t i = 1; i < m.size(); ++i) {
        const Vec3 step = m[i].to.tip - m[i - 1].to.tip, off = p - m[i - 1].to.tip;
        const double square = step.squaredNorm();
        const double t = square > 0 ? std::clamp(off.dot(step) / square, 0.0, 1.0) : 0;
        least = std::min(least, (off - t * step).norm());
    }
    return least;
}

} // namespace facetmill::test
