// The common parameters of all operations, described once for every settings struct derived from
// OperationCommon.
#pragma once

namespace facetmill {

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
    table.add(member(&S::clearance), {.key = "clearance",
                                      .label = "Clearance",
                                      .help = "Height of rapid moves above the highest of part and stock.",
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
}

} // namespace facetmill
