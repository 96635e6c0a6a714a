// Steep and shallow: one finishing operation that divides the part by slope. What is steeper than the divide
// is cut by levels (waterline.h), what is less steep by parallel passes (finish3.h) or by those of constant
// scallop (scallop.h), what is as steep as the divide, within the overlap, by both. An upright tool, any
// generalized cutter.
//
// Each of the two keeps the tolerance on its own facets: cusps of levels grow where the surface becomes
// level, those of parallel passes where it is steep across them, so that each has the surface on which its
// passes lie far apart. Levels are cut first, from above down; then the stock that they leave is what the
// passes over the rest meet. What stays uncut is asked of all passes together.
//
// Tolerances, shank and holder, stock, and what is air are as in finish3.h.
#pragma once

#include "core/strategy/finish3/finish3.h"
#include "core/strategy/scallop/scallop.h"
#include "core/strategy/waterline/waterline.h"

namespace facetmill {

struct SteepShallowSettings : OperationCommon {
    enum class Shallow { parallel, scallop };

    SteepShallowSettings() { name = "Steep and shallow"; }
    double divide = radians(40);            ///< slope from level
    double overlap = radians(5);            ///< both cut slopes that are so near to the divide
    Shallow shallow_by = Shallow::parallel; ///< passes over what is not steep
    NumberOrWord stepdown{0, "adaptive"}, stepover{0, "adaptive"}; ///< mm
    NumberOrWord max_stepdown{0, "auto"};                          ///< mm; auto: the cutter's diameter
    Finish3Settings::Pattern pattern = Finish3Settings::Pattern::zigzag;
    NumberOrWord chord_tolerance{0, "auto"}; ///< mm; auto: see chord_budget
    double normal_limit = radians(5);
    double holder_clearance = 0; ///< mm, kept between shank or holder and the part
    double tilt_limit = 0; ///< largest inclination of the axis where shank or holder would touch, radians
    bool rest_only = false;

    /// The slopes that levels cut, and those that passes cut.
    Interval steep() const { return {std::max(0.0, divide - overlap), 0.5 * pi}; }
    Interval shallow() const { return {0, std::min(0.5 * pi, divide + overlap)}; }
};

const ParameterTable<SteepShallowSettings>& steep_shallow_parameters();
/// The passes over what is not steep, where those are of constant scallop.
ScallopSettings shallow_scallop(const SteepShallowSettings& settings);

class SteepShallow : public OperationWith<SteepShallowSettings, steep_shallow_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "steep_shallow"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<SteepShallow>(settings_); }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    bool reads_stock() const override { return true; }
    double holder_clearance() const override { return settings_.holder_clearance; }

    /// Where only one of the two has something to cut, that is the plan, and a warning says so. Throws
    /// Error(empty_result) where neither has, and what the plans of both throw else.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
