// How one hole of a scan is filled: as the recipe's steps for all holes say, or by a step of its own.
#pragma once

#include "core/repair/holes.h"
#include "core/repair/recipe.h"

#include <functional>
#include <vector>

namespace facetmill::ui {

class ScanPanel;

enum class HoleChoice { as_all, smooth, flat, left };

/// What a recipe says of hole `h` by itself.
HoleChoice hole_choice(const std::vector<Hole>& holes, const std::vector<RepairStep>& recipe, std::size_t h);
/// The recipe with that choice, and no other of that hole: a step before the first one that fills holes.
std::vector<RepairStep> with_hole_choice(const std::vector<Hole>& holes, std::vector<RepairStep> recipe,
                                         std::size_t h, HoleChoice choice);
/// A context menu of the choices on each hole of the panel's list. `holes`: of the scan as it is; null:
/// nothing can be chosen now. `recipe` must live as long as the panel is used.
void offer_hole_choices(ScanPanel& panel, const std::function<const std::vector<Hole>*()>& holes,
                        const std::vector<RepairStep>& recipe,
                        const std::function<void(const std::vector<RepairStep>&)>& change);

} // namespace facetmill::ui
