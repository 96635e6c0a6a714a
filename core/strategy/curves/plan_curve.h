// Curves in the plane, looked at from above: by their length, beside one another, made of loose edges.
// Millimetres, part coordinates.
#pragma once

#include "core/mesh/box_tree.h"
#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/plan_region.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

using PlanLine = std::vector<Vec2>;

/// Edges that share their ends as curves; closed ones run counter-clockwise.
std::vector<PlanCurve> joined_loops(std::span<const PlanEdge> edges);

/// Twice the area that a closed curve goes round counter-clockwise, mm^2; below 0 the other way.
double turned_area(const PlanCurve& curve);
/// The curve run the other way.
PlanCurve reversed(PlanCurve curve);
/// Curves as a tool follows them: closed ones counter-clockwise, or, where asked for `open`, none closed;
/// without those that lead nowhere.
std::vector<PlanCurve> ready_to_follow(std::vector<PlanCurve> curves, bool open);

/// A curve by its length from its first point. Equal points one after the other are one.
class CurveCourse {
public:
    explicit CurveCourse(const PlanCurve& curve);

    double length() const { return arc_.back(); }
    bool closed() const { return closed_; }
    /// The place at a length; beyond its ends that of the end, round and round on a closed one.
    Vec2 at(double s) const;
    /// Unit direction there, of the piece behind it.
    Vec2 direction(double s) const;
    /// The piece from one length to a larger one, corners between included.
    PlanLine stretch(double s0, double s1) const;
    /// Corners and, of a closed one, the first once more at the end.
    const PlanLine& line() const { return line_; }
    /// Length up to each of them.
    const std::vector<double>& arc() const { return arc_; }

private:
    std::size_t piece(double s) const;
    double around(double s) const;

    PlanLine line_;
    std::vector<double> arc_;
    bool closed_;
};

/// How far places are from a line.
class LineDistance {
public:
    LineDistance(const PlanLine& line, const Progress& progress);
    struct Near {
        double distance = infinity;
        std::size_t piece = 0; ///< of the line
        double t = 0;          ///< along it, from 0 to 1
    };
    Near near(const Vec2& p) const;

private:
    const PlanLine& line_;
    BoxTree tree_;
};

/// The longest of some.
PlanCurve longest_of(const std::vector<PlanCurve>& curves);
/// A closed curve that begins at its corner nearest to p.
PlanCurve begun_near(PlanCurve curve, const Vec2& p);
/// The two halves of a closed curve, between where it reaches farthest against a direction and along it; both
/// run along.
std::array<PlanCurve, 2> halves_of(const PlanCurve& outline, const Vec2& along);

/// What runs `left` to the left of a curve (to the right below 0), nowhere nearer to it: pieces of one that
/// bends more sharply than that. Round corners to `detail`. None where nothing of it is left.
std::vector<PlanCurve> curves_beside(const PlanCurve& curve, double left, double detail,
                                     const Progress& progress);

/// The first place at which two lines cross or touch; none where they do not.
std::optional<Vec2> crossing_of(const PlanLine& a, const PlanLine& b, const Progress& progress);

} // namespace facetmill
