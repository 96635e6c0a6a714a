// Families of lines in the plane, one beside the other, and how many of them the tolerance asks for: whole
// lines, and pieces of further ones between them where they lie too far apart. Millimetres, part coordinates.
//
// Lines are told by w, places on them by t from 0 to 1, the same for all: places of neighbours with the same
// t lie opposite each other. Between two lines the cutter is let down in places (gap_judge.h); over the
// ranges of t over which too much would stay pieces of one or two lines more lie between, and between these
// in turn. So lines thin out where the family is narrow. At last the surface itself is asked (uncut.h), and
// what was overlooked gets pieces of its own.
#pragma once

#include "core/strategy/curves/gap_judge.h"

#include <atomic>
#include <optional>

namespace facetmill {

class LineFamily {
public:
    virtual ~LineFamily() = default;
    virtual Vec2 at(double t, double w) const = 0;
    struct Place {
        double t = 0, w = 0;
    };
    /// Which line goes over a place, and where; none where none does.
    virtual std::optional<Place> where(const Vec2& p) const = 0;
};

struct FamilyLine {
    double w = 0;
    bool whole = true; ///< else pieces of it
    std::vector<Pass> passes;
};

class FamilyPlanner {
public:
    /// `beside`: lines go on so far beyond where there is something to cut, since neighbours may end later.
    FamilyPlanner(const CurveJob& job, const LineFamily& family, double beside)
        : job_(job), family_(family), judge_(job), beside_(beside) {}

    /// What of a line over ranges of t has something to cut.
    FamilyLine line(double w, std::span<const Interval> ranges, const Progress& progress) const;
    FamilyLine whole_line(double w, const Progress& progress) const;
    /// Ranges of t, of those given, over which two lines leave too much.
    std::vector<Interval> left_between(const FamilyLine& a, const FamilyLine& b,
                                       std::span<const Interval> ranges, const Progress& progress) const;
    /// Lines that `lines`, in the order of w, need between them, put in. `around`: the last has the first as
    /// its neighbour, with a w that is larger by 1.
    void fill(std::vector<FamilyLine>& lines, bool around, const Progress& progress);
    /// Pieces of lines where those there are leave too much of a surface though a tip would reach it.
    void fill_overlooked(std::vector<FamilyLine>& lines, bool around, const Mesh& surface,
                         const Progress& progress);

    /// Lines beside places that no step serves.
    int unsatisfied() const { return unsatisfied_; }

private:
    void insert(const FamilyLine& a, const FamilyLine& b, const std::vector<Interval>& left,
                std::vector<FamilyLine>& out, const Progress& progress);
    /// Lines that divide what is between two in so many parts, over ranges of t, and what they leave.
    struct Divided {
        std::vector<FamilyLine> lines;
        std::vector<std::vector<Interval>> left;
        double share = 0; ///< of the ranges, over all parts
    };
    Divided divided(const FamilyLine& a, const FamilyLine& b, const std::vector<Interval>& left, int parts,
                    const Progress& progress) const;
    PlanLine places(double w, const Interval& t) const;
    double width(double w0, double w1, std::span<const Interval> ranges) const;
    /// t for a length on a line.
    double t_of(double length, double w) const;
    double smallest() const { return std::max(2 * job_.chord, smallest_share * job_.level_step()); }
    static constexpr double smallest_share = 0.02;

    const CurveJob& job_;
    const LineFamily& family_;
    GapJudge judge_;
    double beside_;
    std::atomic<int> unsatisfied_ = 0;
};

/// Appends the passes of lines, each line a drive plane of its own.
void take_passes(std::vector<FamilyLine> lines, StrategyResult& result);

/// A plan of a family's passes, which are in `result`, as CurveFinish leaves it. Throws Error(empty_result),
/// with `what_to_check` as the advice, where there are none.
StrategyResult finished(const CurveJob& job, const FamilyPlanner& planner, StrategyResult result,
                        const char* what_to_check, const Progress& progress);

} // namespace facetmill
