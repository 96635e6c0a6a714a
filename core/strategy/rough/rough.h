// Roughing layer by layer with a vertical tool axis (Lu 3.4), with any generalized cutter.
//
// On a layer at height z the tip may stand wherever the axial lift of the cutter over the part plus allowance
// is not above z (rough_reach.h). Lu ends his lines where they meet a surface made by moving every vertex
// along its normal; that surface is only as good as the normals at creases, and it crosses itself in
// hollows. The lift needs no such surface: it is exact. The vertex-offset surface can be had as an option, to
// compare; what it cuts beyond the allowance is looked for and reported.
//
// Each layer is cut along parallel lines, one step-over apart, and then along the borders of what is free, so
// that walls parallel to the lines keep no more than others, and along floors of valleys into which it just
// fits (rough_valley.h). Lines follow each other in one go where the line between their ends is free,
// straight or along the border. Where a layer leaves a floor that no deeper layer cuts away, lines may stand
// closer (layer depth from the tolerance).
//
// The stock as it stands is known as a height field (stock_field.h): what is air is passed over; tools enter
// from outside, where nothing stands, or by a ramp or a helix; what shank or holder would hit is left out and
// reported.
#pragma once

#include "core/strategy/plan/operation.h"

namespace facetmill {

struct RoughSettings : OperationCommon {
    enum class Pattern { zigzag, oneway };
    enum class Entry { automatic, ramp, helix, plunge };
    enum class Offset { contact, vertices };

    RoughSettings() {
        name = "Rough";
        tolerance = 1;
        allowance = 0.5;
    }
    NumberOrWord depth{0, "from_tolerance"}; ///< mm
    NumberOrWord stepover{0, "auto"};        ///< mm; auto: 0.95 of the diameter (Lu's c)
    Pattern pattern = Pattern::zigzag;
    Entry entry = Entry::automatic;
    double ramp_angle = radians(3);
    Offset offset = Offset::contact;
    /// What tips keep from the exact surface, in diameters. Safe at any size, since places are looked at so
    /// close together that the cutter dips by less than this between them (RoughReach::spacing): a smaller
    /// one costs time, a larger one leaves more. No parameter: tests halve and double it.
    double margin_share = 2e-3;
    /// The size of the stock's cells, in diameters of the cutter. What stands only between the centres of
    /// cells is not seen as work: they are small beside the cutter. What must not be touched is never below a
    /// cell's top. No parameter: tests halve and double it.
    double cell_share = 0.02;
};

const ParameterTable<RoughSettings>& rough_parameters();

class Rough : public OperationWith<RoughSettings, rough_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "rough"; }
    Purpose purpose() const override { return Purpose::roughing; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Rough>(settings_); }
    bool keeps_axis() const override { return true; }
    Linking linking() const override { return Linking::over_stock; }
    bool reads_stock() const override { return true; }
    bool has_layer_preview() const override { return three_axis(); }
    LayerPreview preview_layers(const PlanContext& context, const Progress& progress) const override;

    /// The passes are level, one or more a layer, but for those along floors of valleys between two layers,
    /// which count with the one above; in machining order, which is not that of layers. `Pass::layer` counts
    /// the `layers` of the result, those that are cut. `cusp_max` is what stays above the allowance wherever
    /// the cutter can go: what the layers leave on the slopes that the part has, or what the planned passes
    /// were found to leave, whichever is more.
    ///
    /// Throws Error(out_of_range) for an undercut cutter, a depth that is no length above 0 or longer than
    /// the flutes, a step-over wider than the cutter, tessellation tolerances that use up the tolerance;
    /// Error(empty_result) where the part has no facets or nothing of the stock can be cut, with the reason;
    /// Error(limit_exceeded) for parts that ask for more than 20 million places or 100 000 layers.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
