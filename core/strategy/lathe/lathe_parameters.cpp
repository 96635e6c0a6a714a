// What the parameters of LatheCommon are, and what they do.
#include "core/strategy/lathe/lathe.h"
#include "core/strategy/plan/shared_parameters.h"

#include <algorithm>

namespace facetmill {

namespace {

ParameterInfo axis_point(const char* key, const char* label, const char* help) {
    return {.key = key,
            .label = label,
            .help = help,
            .kind = ParameterKind::triple,
            .quantity = Quantity::length,
            .minimum = -1e6,
            .maximum = 1e6};
}

/// Where along the axis the path begins or ends.
ParameterInfo end_of_path(const char* key, const char* label, const char* help) {
    return {.key = key,
            .label = label,
            .help = help,
            .kind = ParameterKind::number_or_word,
            .quantity = Quantity::length,
            .minimum = -1e6,
            .maximum = 1e6,
            .words = {"auto"},
            .advanced = true};
}

/// What holds the stock at one of its ends.
ParameterInfo holding(const char* key, const char* label, const char* help) {
    return {.key = key,
            .label = label,
            .help = help,
            .kind = ParameterKind::pair,
            .quantity = Quantity::length,
            .minimum = 0,
            .maximum = 1e5};
}

std::vector<ParameterInfo> axis_parameters() {
    return {
        {.key = "axis",
         .label = "Axis",
         .help = "What the part turns about: a direction of the part, or a line through two points.",
         .words = {"x", "y", "z", "points"}},
        {.key = "axis_through",
         .label = "Axis through",
         .help = "Where an axis along x, y or z runs: through the part's origin or through the middle "
                 "of its box.",
         .words = {"origin", "middle"}},
        axis_point("axis_from", "Axis from", "First point of an axis through two points."),
        axis_point("axis_to", "Axis to", "Second point of an axis through two points."),
    };
}

std::vector<ParameterInfo> course_parameters() {
    return {
        {.key = "pattern",
         .label = "Pattern",
         .help = "Course of the tool: one helix, rings with steps between them, or lengthwise lines "
                 "to and fro with turns between them.",
         .words = {"helix", "rings", "lengthwise"}},
        {.key = "points_per_turn",
         .label = "Points per turn",
         .help = "Even steps of the turning angle; more points are put in where the part asks for them. "
                 "auto takes as few as the chord tolerance allows. Of lengthwise lines: lines per turn.",
         .kind = ParameterKind::number_or_word,
         .quantity = Quantity::count,
         .minimum = 3,
         .maximum = 1e6,
         .words = {"auto"}},
        length_or_word_parameter(
            {.key = "side_feed",
             .label = "Side feed",
             .help = "Advance along the axis in a turn: adaptive is everywhere the largest that leaves no "
                     "cusp above the tolerance; a length is kept whatever it leaves. Of lengthwise lines: "
                     "their distance at the part's largest radius.",
             .words = {"adaptive"}}),
        end_of_path("start", "Start",
                    "Where along the axis the path begins, from the axis' point; auto: where the part does, "
                    "and as far before it as rounded ends ask for."),
        end_of_path("stop", "Stop", "Where along the axis the path ends."),
    };
}

std::vector<ParameterInfo> tool_parameters() {
    return {
        {.key = "offset",
         .label = "Off centre",
         .help = "How far beside the centre line the cutter runs, so that a "
                 "ball does not cut with its tip.",
         .kind = ParameterKind::number,
         .quantity = Quantity::length,
         .minimum = -1000,
         .maximum = 1000,
         .advanced = true},
        {.key = "tilt",
         .label = "Tilt",
         .help = "How far the cutter leans along the axis, away from square to "
                 "it.",
         .kind = ParameterKind::number,
         .quantity = Quantity::angle,
         .minimum = radians(-60),
         .maximum = radians(60),
         .advanced = true},
        {.key = "core_radius",
         .label = "Core radius",
         .help = "The tip comes no nearer to the axis than this: nothing is cut off, and holes through the "
                 "axis are not entered deeper.",
         .kind = ParameterKind::number,
         .quantity = Quantity::length,
         .minimum = 0,
         .maximum = 1e6},
        holding("chuck", "Chuck",
                "Length that the chuck holds, from the stock's low end, and its diameter: no part of the "
                "tool comes nearer than the clearance. Length 0: none."),
        holding("tailstock", "Tailstock", "The same of what holds the stock's high end."),
        chord_tolerance_parameter("How far motions may run beside the exact path, to either side"),
        holder_clearance_parameter(),
        {.key = "winding",
         .label = "Winding",
         .help = "Turning angles in the table of positions: unwound they grow turn after turn, modulo "
                 "they stay within 0 to 360 degrees.",
         .words = {"unwound", "modulo"},
         .stage = Stage::output,
         .advanced = true},
    };
}

std::vector<ParameterInfo> described() {
    std::vector<ParameterInfo> all;
    for (const std::vector<ParameterInfo>& part : {axis_parameters(), course_parameters(), tool_parameters()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

} // namespace

const ParameterInfo& lathe_parameter(std::string_view key) {
    static const std::vector<ParameterInfo> all = described();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const ParameterInfo& info) { return info.key == key; });
    if (found == all.end())
        throw Error(ErrorCode::internal, std::string(key), "is no parameter of a turning part",
                    "report this");
    return *found;
}

} // namespace facetmill
