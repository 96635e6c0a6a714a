// Hollows of a field: where the touch jumps from one flank to the other. Millimetres.
#pragma once

#include "core/strategy/scallop/scallop_field.h"

namespace facetmill {

struct FieldHollow {
    ScallopField::Touch touch; ///< of the middle of the cutter between the two touched points
    double depth = 0;          ///< of the corner between the flanks, from there
};

/// The hollow that is crossed from a place to one beside it, where it is at least so deep: nothing else of
/// the cutter cuts there.
std::optional<FieldHollow> field_hollow(const ScallopField& field, std::size_t place,
                                        const CutterCover& cover, double deep);

} // namespace facetmill
