// The parameters of LatheCommon, described once for every settings struct derived from it.
#pragma once

namespace facetmill {

template <class S>
void add_lathe_parameters(ParameterTable<S>& table, const std::string& side_feed_help) {
    using K = ParameterKind;
    const auto member = []<class T>(T LatheCommon::*m) -> T S::* { return m; };
    table.add_choice(
        member(&LatheCommon::axis),
        {.key = "axis",
         .label = "Axis",
         .help = "What the part turns about: a direction of the part, or a line through two points.",
         .words = {"x", "y", "z", "points"}});
    table.add_choice(
        member(&LatheCommon::axis_through),
        {.key = "axis_through",
         .label = "Axis through",
         .help = "Where an axis along x, y or z runs: through the part's origin or through the middle "
                 "of its box.",
         .words = {"origin", "middle"}});
    table.add(member(&LatheCommon::axis_from), {.key = "axis_from",
                                                .label = "Axis from",
                                                .help = "First point of an axis through two points.",
                                                .kind = K::triple,
                                                .quantity = Quantity::length,
                                                .minimum = -1e6,
                                                .maximum = 1e6,
                                                .advanced = true});
    table.add(member(&LatheCommon::axis_to), {.key = "axis_to",
                                              .label = "Axis to",
                                              .help = "Second point of an axis through two points.",
                                              .kind = K::triple,
                                              .quantity = Quantity::length,
                                              .minimum = -1e6,
                                              .maximum = 1e6,
                                              .advanced = true});
    table.add_choice(member(&LatheCommon::pattern),
                     {.key = "pattern",
                      .label = "Pattern",
                      .help =
                          "Course of the tool: one helix, rings with steps between them, or lengthwise lines "
                          "to and fro with turns between them.",
                      .words = {"helix", "rings", "lengthwise"}});
    table.add(member(&LatheCommon::points_per_turn),
              {.key = "points_per_turn",
               .label = "Points per turn",
               .help =
                   "Even steps of the turning angle; more points are put in where the part asks for them. "
                   "auto takes as few as the chord tolerance allows. Of lengthwise lines: lines per turn.",
               .kind = K::number_or_word,
               .quantity = Quantity::count,
               .minimum = 3,
               .maximum = 1e6,
               .words = {"auto"}});
    table.add(member(&LatheCommon::side_feed), {.key = "side_feed",
                                                .label = "Side feed",
                                                .help = side_feed_help,
                                                .kind = K::number_or_word,
                                                .quantity = Quantity::length,
                                                .minimum = 0,
                                                .maximum = 1000,
                                                .open_minimum = true,
                                                .words = {"adaptive"}});
    for (const bool first : {true, false})
        table.add(
            member(first ? &LatheCommon::start : &LatheCommon::stop),
            {.key = first ? "start" : "stop",
             .label = first ? "Start" : "Stop",
             .help = first ? "Where along the axis the path begins, from the axis' point; auto: where the "
                             "part does, and as far before it as rounded ends ask for."
                           : "Where along the axis the path ends.",
             .kind = K::number_or_word,
             .quantity = Quantity::length,
             .minimum = -1e6,
             .maximum = 1e6,
             .words = {"auto"},
             .advanced = true});
    table.add(member(&LatheCommon::offset),
              {.key = "offset",
               .label = "Off centre",
               .help = "How far beside the centre line the cutter runs, so that a "
                       "ball does not cut with its tip.",
               .kind = K::number,
               .quantity = Quantity::length,
               .minimum = -1000,
               .maximum = 1000,
               .advanced = true});
    table.add(member(&LatheCommon::tilt),
              {.key = "tilt",
               .label = "Tilt",
               .help = "How far the cutter leans along the axis, away from square to "
                       "it.",
               .kind = K::number,
               .quantity = Quantity::angle,
               .minimum = radians(-60),
               .maximum = radians(60),
               .advanced = true});
    table.add(member(&LatheCommon::core_radius),
              {.key = "core_radius",
               .label = "Core radius",
               .help =
                   "The tip comes no nearer to the axis than this: nothing is cut off, and holes through the "
                   "axis are not entered deeper.",
               .kind = K::number,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1e6});
    for (const bool first : {true, false})
        table.add(
            member(first ? &LatheCommon::chuck : &LatheCommon::tailstock),
            {.key = first ? "chuck" : "tailstock",
             .label = first ? "Chuck" : "Tailstock",
             .help = first ? "Length that the chuck holds, from the stock's low end, and its diameter: no "
                             "part of the tool comes nearer than the clearance. Length 0: none."
                           : "The same of what holds the stock's high end.",
             .kind = K::pair,
             .quantity = Quantity::length,
             .minimum = 0,
             .maximum = 1e5});
    table.add(
        member(&LatheCommon::chord_tolerance),
        {.key = "chord_tolerance",
         .label = "Chord tolerance",
         .help = "How far motions may run beside the exact path, to either side; auto is a twentieth of the "
                 "tolerance. At most half the tolerance is used.",
         .kind = K::number_or_word,
         .quantity = Quantity::length,
         .minimum = 0,
         .maximum = 1000,
         .open_minimum = true,
         .words = {"auto"},
         .advanced = true});
    table.add(member(&LatheCommon::holder_clearance),
              {.key = "holder_clearance",
               .label = "Holder clearance",
               .help = "Distance that shank and holder keep from the part.",
               .kind = K::number,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1000,
               .advanced = true});
    table.add_choice(
        member(&LatheCommon::winding),
        {.key = "winding",
         .label = "Winding",
         .help = "Turning angles in the table of positions: unwound they grow turn after turn, modulo "
                 "they stay within 0 to 360 degrees.",
         .words = {"unwound", "modulo"},
         .stage = Stage::output,
         .advanced = true});
    table.set_stage("clearance", Stage::strategy); // chuck and tailstock are kept clear by it
}

} // namespace facetmill
