// Passes of clean-up, less what of them takes nothing away. A valley's passes are planned as wide and as long
// as its band is anywhere: many of them run over surface that is finished. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/strip_passes.h"

#include <span>

namespace facetmill {

/// Leaves of the bands' passes what works: where they come within the cusp of a place of the bands, or, where
/// none does, about as near as any and nearer than the cutter before by more than the cusp. With the overlap
/// before and after, gaps that are short against the cutter bridged, and with leads where passes were cut
/// off.
void keep_working(const StripCutting& with, std::span<const BandCut> bands, const Progress& progress);

} // namespace facetmill
