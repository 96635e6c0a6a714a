// Passes of an upright tool along curves that are looked at from above: the cutter let down on the part all
// along a line in the plane, exactly, and what every operation of this wing does with such passes. Any
// generalized cutter. Millimetres, part coordinates.
//
// The tip moves over the line and nowhere else; its height is the axial lift of the whole cutter over the
// whole part (lift_line.h), so nothing is gouged whatever the line crosses. Tolerances, shank and holder,
// stock, and what is air are as in finish3.h.
#pragma once

#include "core/strategy/curves/plan_curve.h"
#include "core/strategy/finish3/pass_filter.h"
#include "core/strategy/finish3/uncut.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/operation.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/strategy/surface/lift_line.h"

namespace facetmill {

/// What operations of this wing have beside their own.
struct CurveCommon : OperationCommon {
    enum class Pattern { zigzag, oneway };

    NumberOrWord stepover{0, "adaptive"}; ///< mm
    Pattern pattern = Pattern::zigzag;
    NumberOrWord chord_tolerance{0, "auto"}; ///< mm; auto: see chord_budget
    double holder_clearance = 0;             ///< mm, kept between shank or holder and the part
    double tilt_limit = 0; ///< largest inclination of the axis where shank or holder would touch, radians
    bool rest_only = false;
};

template <class S>
void add_curve_parameters(ParameterTable<S>& table) {
    const auto member = []<class T>(T CurveCommon::*m) -> T S::* { return m; };
    table.add_choice(member(&S::pattern),
                     pattern_parameter("zigzag cuts whichever way is nearer; oneway always in the same "
                                       "direction and returns above the part."));
    table.add(member(&S::chord_tolerance),
              chord_tolerance_parameter("How far straight moves may run beside the exact path, to either "
                                        "side"));
    table.add(member(&S::holder_clearance), holder_clearance_parameter());
    table.add(member(&S::tilt_limit), tilt_limit_parameter());
    table.add(member(&S::rest_only), rest_only_parameter());
}
/// Between neighbouring passes.
ParameterInfo curve_stepover_parameter();
template <class S>
void add_stepover_parameter(ParameterTable<S>& table) {
    table.add(static_cast<NumberOrWord S::*>(&CurveCommon::stepover), curve_stepover_parameter());
}

/// How far apart two passes on a level plane may be that leave no more than `cusp`; no more than the cutter's
/// diameter.
double level_step_of(const CutterCover& cover, double cusp);

/// What a plan is made with.
class CurveJob {
public:
    /// What is given has to live as long as this. Throws what check_plannable and cusp_budget do, and
    /// Error(empty_result) where no facet faces up.
    CurveJob(const CurveCommon& settings, const PlanContext& context, const Progress& progress);

    const CurveCommon& settings;
    const PlanContext& context;
    PlanText text;
    double cusp_allowed; ///< that may stay
    double allowance;    ///< with what the tessellation may lie too low
    double chord;
    CutterProfile profile;
    CutterCover cover;
    AxialLift lift;
    LineTolerance fine;
    ContactDomain domain; ///< u is X and v is Y

    double radius() const { return cover.radius(); }
    /// What two passes may leave, so that with the chord tolerance it is no more than is allowed.
    double gap_cusp() const { return standing_cusp(cusp_allowed, chord); }
    /// The step that leaves that on a level plane, no more than the cutter's diameter.
    double level_step() const { return level_step_; }
    LiftField field() const { return {&lift, domain.lowest_tip()}; }
    /// Where a tip that stands on the part touches it.
    CutterContact contact(const Vec3& tip) const {
        LiftHint none;
        return contact(tip, none);
    }
    CutterContact contact(const Vec3& tip, LiftHint& hint) const;
    /// The same of a tip at (x, y) that is known to touch so.
    CutterContact contact_of(const AxialContact& touched, const Vec3& tip) const;

    /// Whether a tip within `beside` of a place has something to cut.
    bool in_domain(const Vec2& p, double beside) const;
    /// What of a line lies there.
    std::vector<PlanLine> cut_to_domain(const PlanLine& line, double beside, const Progress& progress) const;
    /// The cutter let down along a line, two places at least. Any thread may ask.
    Pass pass(const PlanLine& line, const Progress& progress) const;
    /// Passes along what of a line has something to cut.
    std::vector<Pass> passes(const PlanLine& line, double beside, const Progress& progress) const;
    /// What of a surface is asked whether it stays uncut; it and this must outlive the answer.
    UncutInput uncut_input(const Mesh& surface) const;

private:
    double level_step_;
};

/// What is done with passes when all are planned.
class CurveFinish {
public:
    explicit CurveFinish(const CurveJob& job);

    struct Options {
        const Mesh* covered = nullptr; ///< what of the part is asked whether it stays uncut; null: nothing
        int unsatisfied = 0;           ///< lines beside places that no step serves
        bool keep_order = false;       ///< passes stay in the order in which they are
    };
    /// Leaves out what is not to be cut, asks what stays uncut, puts the passes in order and adds the
    /// warnings. `result` has the passes and what is known of them. Throws Error(empty_result) where nothing
    /// is left.
    void run(StrategyResult& result, const Options& options, const Progress& progress);

private:
    void check_uncut(const StrategyResult& result, const Mesh& covered, const Progress& progress);

    const CurveJob& job_;
    PassFilter filter_;
    UncutReport uncut_;
};

} // namespace facetmill
