#include "core/strategy/plan/shared_parameters.h"

#include "core/base/tolerances.h"
#include "core/setup/tool.h"

namespace facetmill {

ParameterInfo chord_tolerance_parameter(const std::string& what) {
    return length_or_word_parameter(
        {.key = "chord_tolerance",
         .label = "Chord tolerance",
         .help = what
                 + "; the deepest gouge that the verification lets pass. auto is a twentieth of the "
                   "tolerance, but at most 0.01 mm (0.0004 in). At most half the tolerance is used.",
         .words = {"auto"},
         .advanced = true});
}

ParameterInfo holder_clearance_parameter() {
    return {.key = "holder_clearance",
            .label = "Holder clearance",
            .help = "Distance that shank and holder keep from the part.",
            .kind = ParameterKind::number,
            .quantity = Quantity::length,
            .minimum = 0,
            .maximum = 1000,
            .advanced = true};
}

ParameterInfo tilt_limit_parameter() {
    return {.key = "tilt_limit",
            .label = "Tilt limit",
            .help = "Largest inclination of the tool axis, used where shank or holder would touch the part. "
                    "0 keeps the tool upright; above 0 the program is one of five axes.",
            .kind = ParameterKind::number,
            .quantity = Quantity::angle,
            .minimum = 0,
            .maximum = 75 * pi / 180};
}

ParameterInfo pattern_parameter(const std::string& help) {
    return {.key = "pattern", .label = "Pattern", .help = help, .words = {"zigzag", "oneway"}};
}

ParameterInfo normal_limit_parameter(const std::string& more) {
    return {.key = "normal_limit",
            .label = "Normal limit",
            .help = "Largest turn of the surface normal between neighbouring points of a pass" + more + ".",
            .kind = ParameterKind::number,
            .quantity = Quantity::angle,
            .minimum = radians(0.1),
            .maximum = 0.5 * pi,
            .advanced = true};
}

ParameterInfo stepdown_parameter() {
    return length_or_word_parameter({.key = "stepdown",
                                     .label = "Step-down",
                                     .help = "Height between neighbouring levels: adaptive is everywhere "
                                             "the largest that the tolerance allows; a length is kept "
                                             "whatever cusps it leaves.",
                                     .words = {"adaptive"}});
}

ParameterInfo max_stepdown_parameter() {
    return length_or_word_parameter({.key = "max_stepdown",
                                     .label = "Largest step-down",
                                     .help = "The adaptive step-down is no larger than this. auto is the "
                                             "cutter's diameter.",
                                     .words = {"auto"},
                                     .advanced = true});
}

ParameterInfo stepover_parameter() {
    return length_or_word_parameter({.key = "stepover",
                                     .label = "Step-over",
                                     .help = "Distance between neighbouring drive planes: adaptive is "
                                             "everywhere the largest that the tolerance allows; a length "
                                             "is kept whatever cusps it leaves.",
                                     .words = {"adaptive"}});
}

ParameterInfo rest_only_parameter() {
    return {.key = "rest_only",
            .label = "Rest only",
            .help = "Cuts only where more than the tolerance stands of the stock, as raw "
                    "material and the operations before left it.",
            .kind = ParameterKind::boolean};
}

ParameterInfo length_or_word_parameter(ParameterInfo info, double largest) {
    info.kind = ParameterKind::number_or_word;
    info.quantity = Quantity::length;
    info.minimum = 0;
    info.maximum = largest;
    info.open_minimum = true;
    return info;
}

ParameterInfo feed_or_auto_parameter(ParameterInfo info) {
    info.kind = ParameterKind::number_or_word;
    info.quantity = Quantity::feed;
    info.minimum = 0;
    info.maximum = 1e6;
    info.open_minimum = true;
    info.words = {"auto"};
    info.stage = Stage::output;
    info.advanced = true;
    return info;
}

ParameterInfo travel_parameter(ParameterInfo info) {
    info.kind = ParameterKind::number_or_word;
    info.quantity = Quantity::angle;
    info.minimum = -2 * pi;
    info.maximum = 2 * pi;
    info.words = {"auto", "x", "y"};
    return info;
}

ParameterInfo further_tool_parameter(ParameterInfo info, long smallest) {
    info.kind = ParameterKind::integer;
    info.quantity = Quantity::count;
    info.minimum = double(smallest);
    info.maximum = largest_tool_number;
    return info;
}

ParameterInfo place_parameter(ParameterInfo info) {
    info.kind = ParameterKind::triple;
    info.quantity = Quantity::length;
    info.minimum = -tolerance::largest_coordinate;
    info.maximum = tolerance::largest_coordinate;
    return info;
}

} // namespace facetmill
