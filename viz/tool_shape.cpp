#include "viz/tool_shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace facetmill {

namespace {

constexpr int around = 96;         // facets on a turn
constexpr double arc_step = 0.06;  // radians of an arc of the profile
constexpr double same_step = 1e-6; // mm: steps of one cone

/// A stretch of the outline with its outward normals: smooth inside, a corner at either end.
struct Stretch {
    std::vector<Vec2> points, normals; // (rho, z)
};

Stretch line(const Vec2& a, const Vec2& b) {
    const Vec2 along = (b - a).normalized();
    const Vec2 out(along.y(), -along.x()); // to the right of a profile that runs outward and upward
    return {{a, b}, {out, out}};
}

Stretch arc(const ProfilePiece& piece) {
    const auto angle_of = [&](const Vec2& p) {
        return std::atan2(p.y() - piece.center.y(), p.x() - piece.center.x());
    };
    const double from = angle_of(piece.from), to = angle_of(piece.to);
    const int steps = std::max(1, int(std::ceil(std::abs(to - from) / arc_step)));
    Stretch s;
    for (int i = 0; i <= steps; ++i) {
        const double t = from + (to - from) * i / steps;
        const Vec2 out(std::cos(t), std::sin(t));
        s.points.push_back(i == 0       ? piece.from
                           : i == steps ? piece.to
                                        : Vec2(piece.center + piece.radius * out));
        s.normals.push_back(out);
    }
    return s;
}

void turn(const Stretch& s, RevolvedShape& shape) {
    const auto base = std::int32_t(shape.points.size() / 3);
    for (std::size_t i = 0; i < s.points.size(); ++i)
        for (int k = 0; k < around; ++k) {
            const double t = 2.0 * pi * k / around, c = std::cos(t), sn = std::sin(t);
            const Vec2 &p = s.points[i], &n = s.normals[i];
            shape.points.insert(shape.points.end(), {float(p.x() * c), float(p.x() * sn), float(p.y())});
            shape.normals.insert(shape.normals.end(), {float(n.x() * c), float(n.x() * sn), float(n.y())});
        }
    for (std::int32_t i = 0; i + 1 < std::int32_t(s.points.size()); ++i)
        for (std::int32_t k = 0; k < around; ++k) {
            const std::int32_t a = base + i * around + k, b = base + i * around + (k + 1) % around;
            const std::int32_t c = a + around, d = b + around;
            if (s.points[std::size_t(i)].x() > 0.0) shape.triangles.insert(shape.triangles.end(), {a, b, d});
            if (s.points[std::size_t(i) + 1].x() > 0.0)
                shape.triangles.insert(shape.triangles.end(), {a, d, c});
        }
}

/// A circle of the outline's corner at the vertices of row 0 or the last row of the stretch added last.
void ring(const Stretch& s, bool at_end, RevolvedShape& shape) {
    const auto rows = std::int32_t(s.points.size());
    const auto base = std::int32_t(shape.points.size() / 3) - (at_end ? 1 : rows) * around;
    for (std::int32_t k = 0; k < around; ++k)
        shape.rings.insert(shape.rings.end(), {base + k, base + (k + 1) % around});
}

/// Turns the whole outline; rings stand where it bends by more than 20 degrees.
RevolvedShape revolve(const std::vector<Stretch>& outline) {
    RevolvedShape shape;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        turn(outline[i], shape);
        const bool last = i + 1 == outline.size();
        const double bend = last ? -1.0 : outline[i].normals.back().dot(outline[i + 1].normals.front());
        if (bend < std::cos(radians(20)) && outline[i].points.back().x() > 0.0) ring(outline[i], true, shape);
    }
    return shape;
}

void add_cylinder(std::vector<Stretch>& outline, double radius, double bottom, double top) {
    outline.push_back(line({0.0, bottom}, {radius, bottom}));
    outline.push_back(line({radius, bottom}, {radius, top}));
    outline.push_back(line({radius, top}, {0.0, top}));
}

/// How many of the sections from `first` are steps of one cone: equally long, and each as much wider, or
/// narrower, than the one before.
std::size_t steps_of_cone(const std::vector<HolderSection>& sections, std::size_t first) {
    constexpr double largest_step = 1; // mm, of the radius
    std::size_t end = first + 1;
    while (end < sections.size()) {
        const double grow = sections[first + 1].diameter - sections[first].diameter;
        const bool goes_on =
            std::abs(sections[end].length - sections[first].length) <= same_step
            && std::abs(sections[end].diameter - sections[end - 1].diameter - grow) <= same_step;
        if (!goes_on || std::abs(grow) / 2 > largest_step + same_step || std::abs(grow) <= same_step) break;
        ++end;
    }
    return end - first;
}

void add_cone(std::vector<Stretch>& outline, const HolderPiece& piece, double bottom) {
    const Vec2 low(piece.lower / 2, bottom), high(piece.upper / 2, bottom + piece.length);
    if (low.x() > 0) outline.push_back(line({0.0, low.y()}, low));
    outline.push_back(line(low, high));
    if (high.x() > 0) outline.push_back(line(high, {0.0, high.y()}));
}

} // namespace

std::vector<HolderPiece> holder_pieces(const std::vector<HolderSection>& all) {
    std::vector<HolderSection> sections;
    std::copy_if(all.begin(), all.end(), std::back_inserter(sections),
                 [](const HolderSection& s) { return s.diameter > 0 && s.length > 0; });
    std::vector<HolderPiece> pieces;
    constexpr std::size_t min_steps = 3; // fewer may be anything
    for (std::size_t i = 0; i < sections.size();) {
        const HolderSection& s = sections[i];
        const std::size_t steps = steps_of_cone(sections, i);
        if (steps < min_steps) {
            pieces.push_back({s.diameter, s.diameter, s.length});
            ++i;
            continue;
        }
        // Each step is as wide as the cone at its wider end, and the widest may have become one with a
        // cylinder beside it.
        const double grow = sections[i + 1].diameter - s.diameter, step = s.length;
        const double last = sections[i + steps - 1].diameter;
        HolderPiece cone{s.diameter, last, double(steps) * step};
        const auto takes_from = [&](double diameter, double length, double wanted) {
            return std::abs(diameter - wanted) <= same_step && length > step + same_step;
        };
        if (grow > 0) {
            cone.lower = std::max(0.0, s.diameter - grow);
            if (i + steps < sections.size()
                && takes_from(sections[i + steps].diameter, sections[i + steps].length, last + grow)) {
                sections[i + steps].length -= step;
                cone.upper += grow;
                cone.length += step;
            }
        } else {
            cone.upper = std::max(0.0, last + grow);
            if (!pieces.empty() && pieces.back().lower == pieces.back().upper
                && takes_from(pieces.back().upper, pieces.back().length, s.diameter - grow)) {
                pieces.back().length -= step;
                cone.lower -= grow;
                cone.length += step;
            }
        }
        pieces.push_back(cone);
        i += steps;
    }
    return pieces;
}

ToolShape make_tool_shape(const Tool& tool) {
    const CutterProfile profile(tool.cutter());
    ToolShape shape;
    std::vector<Stretch> outline;
    for (const ProfilePiece& piece : profile.pieces())
        if ((piece.to - piece.from).norm() > 0.0)
            outline.push_back(piece.kind == ProfilePiece::Kind::arc ? arc(piece)
                                                                    : line(piece.from, piece.to));
    const double top_radius = profile.radius_at(profile.height());
    if (top_radius > 0.0) outline.push_back(line({top_radius, profile.height()}, {0.0, profile.height()}));
    shape.cutter = revolve(outline);
    shape.length = profile.height();
    shape.radius = profile.max_radius();

    if (tool.shank_diameter > 0.0 && tool.shank_length > 0.0) {
        outline.clear();
        add_cylinder(outline, tool.shank_diameter / 2, shape.length, shape.length + tool.shank_length);
        shape.shank = revolve(outline);
        shape.length += tool.shank_length;
        shape.radius = std::max(shape.radius, tool.shank_diameter / 2);
    }
    outline.clear();
    for (const HolderPiece& piece : holder_pieces(tool.holder)) {
        add_cone(outline, piece, shape.length);
        shape.length += piece.length;
        shape.radius = std::max({shape.radius, piece.lower / 2, piece.upper / 2});
    }
    shape.holder = revolve(outline);
    return shape;
}

RevolvedShape make_arrow(double shaft_radius, double head_radius, double head, double length) {
    const double neck = length - head;
    return revolve({line({0, 0}, {shaft_radius, 0}), line({shaft_radius, 0}, {shaft_radius, neck}),
                    line({shaft_radius, neck}, {head_radius, neck}), line({head_radius, neck}, {0, length})});
}

} // namespace facetmill
