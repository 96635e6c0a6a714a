// What assistive technology is told of widgets that draw for themselves: they are graphics with a name, not
// panels without content.
#pragma once

namespace facetmill::ui {

/// For the whole program; more than once does no harm.
void tell_graphics();

} // namespace facetmill::ui
