// Heights of the layers of roughing (Lu 3.4.2), and what they leave standing. Millimetres, radians.
//
// Layers e apart over a plane of slope a leave steps. Lu 3.10 takes the highest place left to lie where two
// neighbouring balls, touching the plane e / sin a apart, meet:
//
//     d = R - sqrt(R^2 - (e / (2 sin a))^2)                                                            (3.10)
//
// That is of whole balls; above its centre a ball end is a cylinder and leaves less. And it holds only while
// the lower ball reaches the upper one below its level, e <= 2 R sin^2 a. On flatter slopes the floor of the
// upper layer ends in a corner at the lower ball's side,
//
//     d = R + cos a (e - R) - sin a sqrt(2 R e - e^2),
//
// which goes to e, where 3.10 has no root at all; and between drive lines the floor itself is higher than the
// layer, by the height of the cutter at half the step-over, which 3.10 leaves out (Lu says so of the lowest
// layer; it is so wherever a floor stays, on every layer). `layer_excess` holds all of it for every convex
// cutter: it finds the place where the upper floor, or the upper cutter's side, meets the lower cutter's.
#pragma once

#include "core/base/progress.h"
#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"

#include <optional>
#include <vector>

namespace facetmill {

/// Height along the normal that layers `depth` apart leave above a plane that makes `slope` with the level:
/// on each layer the cutter runs along the plane and, on lines `stepover` apart, over the rest. 0 <= slope <=
/// pi/2.
double layer_excess(const CutterProfile& cutter, double depth, double stepover, double slope);

/// The largest depth, at most `most`, whose layers leave no more than `excess` (3.11 put right); 0 where the
/// step-over alone leaves more.
double layer_depth(const CutterProfile& cutter, double excess, double stepover, double slope, double most);

struct LayerInput {
    const Mesh* mesh = nullptr;
    const CutterProfile* cutter = nullptr;
    double allowance = 0;    ///< what is to stay along the normal
    double margin = 0;       ///< tips keep that much higher yet
    double top = 0, low = 0; ///< highest place of the stock; lowest tip
    double stepover = 0;     ///< between lines where a floor stays
    /// Layers are this far apart; or, where it is none, as far as `excess` allows, at most `deepest`.
    std::optional<double> depth;
    double excess = 0, deepest = 0;
};

struct Layers {
    std::vector<double> heights; ///< the tip's, from the top down; the last is `low`
    double depth_min = 0, depth_max = 0;
    double excess = 0;            ///< the most that they leave on slopes the part has
    std::size_t level_places = 0; ///< layers put at level places of the part
};

/// Heights of layers: at level places that are large for the cutter, at the lowest tip, and evenly, or as the
/// local slopes ask for, between. Throws Error(limit_exceeded) beyond 100 000 layers.
Layers layer_heights(const LayerInput& input, const Progress& progress);

} // namespace facetmill
