// The common parameters of all operations, described once for every settings struct derived from
// OperationCommon.
#pragma once

namespace facetmill {

/// Those that say where on the part an operation cuts.
template <class S>
void add_bounds_parameters(ParameterTable<S>& table) {
    using K = ParameterKind;
    const auto member = []<class T>(T OperationCommon::*m) -> T S::* { return m; };
    table.add(member(&S::boundary), {.key = "boundary",
                                     .label = "Boundary",
                                     .help = "Name of a boundary of the setup: the operation cuts within it. "
                                             "Empty: everywhere.",
                                     .kind = K::text,
                                     .default_unwritten = true});
    table.add_choice(member(&S::contain),
                     {.key = "contain",
                      .label = "Kept within",
                      .help = "What the boundary keeps within: the place where the cutter touches the part, "
                              "the tip, or all of the cutter. Roughing keeps the tip or the cutter within.",
                      .words = {"contact", "tip", "tool"},
                      .default_unwritten = true});
    table.add(member(&S::avoid), {.key = "avoid",
                                  .label = "Avoid",
                                  .help = "Name of a boundary whose facets the tool keeps off. Empty: none.",
                                  .kind = K::text,
                                  .default_unwritten = true});
    table.add(member(&S::avoid_distance), {.key = "avoid_distance",
                                           .label = "Avoid by",
                                           .help = "How far cutter, shank and holder keep from these facets.",
                                           .kind = K::number,
                                           .quantity = Quantity::length,
                                           .minimum = 0,
                                           .maximum = 1000,
                                           .open_minimum = true,
                                           .default_unwritten = true});
}

template <class S>
void add_tool_axis_parameter(ParameterTable<S>& table) {
    const auto member = []<class T>(T OperationCommon::*m) -> T S::* { return m; };
    table.add(member(&S::tool_axis),
              {.key = "tool_axis",
               .label = "Tool axis",
               .help =
                   "Direction from the tip to the spindle in the setup's coordinates, kept all along; "
                   "0, 0, 1 is upright. With another one the operation is planned as seen along it, X and Y "
                   "turned with it the shortest way, and keeps above the bottom of the stock.",
               .kind = ParameterKind::triple,
               .minimum = -1e6,
               .maximum = 1e6,
               .default_unwritten = true});
}

template <class S>
void add_off_parameter(ParameterTable<S>& table) {
    const auto member = []<class T>(T OperationCommon::*m) -> T S::* { return m; };
    table.add(member(&S::off), {.key = "off",
                                .label = "Off",
                                .help = "Switched off: the operation is left out of plan, verification and "
                                        "programs, as if it were not there.",
                                .kind = ParameterKind::boolean,
                                .stage = Stage::output,
                                .default_unwritten = true});
}

template <class S>
void add_common_parameters(ParameterTable<S>& table, Workholding holding) {
    using K = ParameterKind;
    // &S::name is a member pointer of OperationCommon; the table wants one of S.
    const auto member = []<class T>(T OperationCommon::*m) -> T S::* { return m; };
    table.add(member(&S::name), {.key = "name",
                                 .label = "Name",
                                 .help = "Name of the operation; also names its output file.",
                                 .kind = K::text,
                                 .stage = Stage::output});
    add_off_parameter(table);
    table.add(member(&S::tool), {.key = "tool",
                                 .label = "Tool",
                                 .help = "Number of the tool in the tool list.",
                                 .kind = K::integer,
                                 .quantity = Quantity::count,
                                 .minimum = 1,
                                 .maximum = largest_tool_number,
                                 .stage = Stage::cutter,
                                 .required = "give the number of a tool"});
    table.add(
        member(&S::tolerance),
        {.key = "tolerance",
         .label = "Tolerance",
         .help = "Machining tolerance: the largest cusp that may be left. Gouges are not allowed at all.",
         .kind = K::number,
         .quantity = Quantity::length,
         .minimum = 0,
         .maximum = 1000,
         .open_minimum = true});
    table.add(member(&S::allowance), {.key = "allowance",
                                      .label = "Allowance",
                                      .help = "Stock left on the part for a later operation. 0 cuts to size.",
                                      .kind = K::number,
                                      .quantity = Quantity::length,
                                      .minimum = 0,
                                      .maximum = 1000,
                                      .stage = Stage::contact});
    table.add(member(&S::feed), {.key = "feed",
                                 .label = "Feed",
                                 .help = "Speed of cutting motion.",
                                 .kind = K::number,
                                 .quantity = Quantity::feed,
                                 .minimum = 0,
                                 .maximum = 1e6,
                                 .open_minimum = true,
                                 .stage = Stage::output});
    table.add(
        member(&S::ramp_feed),
        feed_or_auto_parameter({.key = "ramp_feed",
                                .label = "Ramp feed",
                                .help = "Speed of motion into the material: down to a pass, along ramps and "
                                        "helices. auto is half the feed."}));
    table.add(member(&S::link_feed),
              feed_or_auto_parameter(
                  {.key = "link_feed",
                   .label = "Link feed",
                   .help = "Speed of motion between passes that is no rapid: over the surface and "
                           "away from it. auto is the feed."}));
    table.add(member(&S::spindle), {.key = "spindle",
                                    .label = "Spindle",
                                    .help = "Spindle speed.",
                                    .kind = K::number,
                                    .quantity = Quantity::rotation,
                                    .minimum = 0,
                                    .maximum = 1e6,
                                    .open_minimum = true,
                                    .stage = Stage::output});
    table.add(member(&S::clearance),
              {.key = "clearance",
               .label = "Clearance",
               .help = "Height of level rapid moves above part and stock on their way; to the first "
                       "pass and from the last, above the highest of them.",
               .kind = K::number,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1e4,
               .open_minimum = true,
               .stage = Stage::link});
    if (holding == Workholding::on_table)
        table.add(member(&S::below_bottom),
                  {.key = "below_bottom",
                   .label = "Below the bottom",
                   .help = "How far the cutter may go below the bottom of the stock, where something holds "
                           "it. With 0 steep surface near the bottom keeps what only a lower tip would cut.",
                   .kind = K::number,
                   .quantity = Quantity::length,
                   .minimum = 0,
                   .maximum = 1000});
    table.add(member(&S::direction),
              travel_parameter({.key = "direction",
                                .label = "Direction",
                                .help = "Direction of travel: auto picks x or y by the "
                                        "change of normals, 3-axis finishing the other one "
                                        "where that travels or leaves less; a number is an angle "
                                        "from X."}));
    add_bounds_parameters(table);
}

} // namespace facetmill
