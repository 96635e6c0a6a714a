// What an operation begins with that a user adds to a project.
#pragma once

#include "core/job/project.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace facetmill {

struct NewOperation {
    std::unique_ptr<Operation> operation; ///< its name is that of its kind's default
    std::size_t place = 0;                ///< in the project's operations: roughing, finishing, clean-up
    std::optional<Tool> tool;             ///< to be added to the list, which has none that would do
};

/// What is known of a new operation beforehand; nothing: it is chosen as new_operation says.
struct OperationWish {
    std::optional<long> tool;          ///< that it cuts with
    std::optional<long> previous_tool; ///< after which it cleans up
    /// Surface that is steeper than this, radians from level: of a kind with two limits of slope.
    std::optional<double> steeper = {};
};

/// Like the last operation of its kind, but for lists that were made by hand; of another kind: feeds and
/// clearance of its neighbour (feeds as its tool says where that is another one), and tool, tolerance and
/// depth as its purpose asks for. Roughing takes the largest tool with a flat to its end, or a new one
/// where the list has none (usual_roughing_tool; turning, the largest), and layers of a quarter of its
/// diameter, no deeper than its flutes; clean-up the next smaller one than finishing before it has, or a new
/// one that is sold of half that. What is wished comes before all of that. Throws Error(out_of_range) for an
/// unknown kind, Error(missing_reference) for a wished tool that the list has not.
NewOperation new_operation(std::string_view kind, const Project& project, const OperationWish& wish = {});

} // namespace facetmill
