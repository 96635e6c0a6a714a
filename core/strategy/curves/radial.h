// Radial and spiral: passes from a centre outward like the spokes of a wheel, and one that winds about it. An
// upright tool, any generalized cutter.
//
// What is cut is what of the part lies between two radii of the centre, seen from above; the tip goes as far
// beyond as touching the border takes. Spokes are as close together as the tolerance asks at their outer
// ends, and every second, third ... begins only where the others lie too far apart (line_family.h), so that
// they do not crowd about the centre. The turns of a spiral are as far apart as most of them allows; over the
// rest arcs lie between.
#pragma once

#include "core/strategy/curves/curve_job.h"

namespace facetmill {

struct RadialCommon : CurveCommon {
    std::array<double, 3> center{0, 0, 0}; ///< seen from above: z says nothing
    bool center_of_part = true;            ///< the middle of the part's box instead
    double from_radius = 0;                ///< mm
    NumberOrWord to_radius{0, "auto"};     ///< mm; auto: to the part's farthest place
};

struct RadialSettings : RadialCommon {
    RadialSettings() { name = "Radial"; }
};
struct SpiralSettings : RadialCommon {
    SpiralSettings() { name = "Spiral"; }
};

const ParameterTable<RadialSettings>& radial_parameters();
const ParameterTable<SpiralSettings>& spiral_parameters();

class Radial : public OperationWith<RadialSettings, radial_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "radial"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Radial>(settings_); }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    bool reads_stock() const override { return true; }
    double holder_clearance() const override { return settings_.holder_clearance; }

    /// Throws Error(out_of_range) where the radii have nothing between them, Error(empty_result) where
    /// nothing of the part lies there, Error(limit_exceeded) for more passes than a plan may have, and what
    /// finish3 does of part, tool and tolerance.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

class Spiral : public OperationWith<SpiralSettings, spiral_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "spiral"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Spiral>(settings_); }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    bool reads_stock() const override { return true; }
    double holder_clearance() const override { return settings_.holder_clearance; }

    /// Throws what Radial::plan does.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
