#include "core/setup/tool.h"

#include "core/base/tolerances.h"
#include "core/cutter/refuse.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

using tolerance::largest_tool;
constexpr double steepest_angle = tolerance::steepest_tool_angle;
/// As operations may have them.
constexpr double largest_spindle = 1e6, largest_feed = 1e6;
constexpr double max_flutes = 1000;

/// The tool's key for a letter of the cutter.
std::string key_of(const std::string& letter) {
    if (letter == "d") return "diameter";
    if (letter == "r") return "corner_radius";
    if (letter == "alpha") return "bottom_angle";
    if (letter == "beta") return "taper_angle";
    if (letter == "h") return "flute_length";
    return letter;
}

} // namespace

const ParameterTable<HolderSection>& holder_parameters() {
    static const auto table = [] {
        ParameterTable<HolderSection> t;
        const auto add = [&](double HolderSection::*member, const char* key, const char* label,
                             const char* help, const char* required) {
            t.add(member, {.key = key,
                           .label = label,
                           .help = help,
                           .quantity = Quantity::length,
                           .minimum = 0,
                           .maximum = largest_tool,
                           .open_minimum = true,
                           .stage = Stage::cutter,
                           .required = required});
        };
        add(&HolderSection::diameter, "diameter", "Diameter", "Diameter of the section.",
            "give the section's diameter");
        add(&HolderSection::length, "length", "Length", "Length of the section along the axis.",
            "give the section's length");
        return t;
    }();
    return table;
}

const ParameterTable<CuttingData>& cutting_parameters() {
    static const auto table = [] {
        using Q = Quantity;
        ParameterTable<CuttingData> t;
        const auto add_text = [&](std::string CuttingData::*member, const char* key, const char* label,
                                  const char* help) {
            t.add(member, {.key = key,
                           .label = label,
                           .help = help,
                           .kind = ParameterKind::text,
                           .stage = Stage::advice});
        };
        const auto add = [&](double CuttingData::*member, const char* key, const char* label,
                             const char* help, Q quantity, double maximum) {
            t.add(member, {.key = key,
                           .label = label,
                           .help = help,
                           .quantity = quantity,
                           .minimum = 0,
                           .maximum = maximum,
                           .stage = Stage::advice});
        };
        add_text(&CuttingData::name, "name", "Name", "What it is called.");
        add_text(&CuttingData::material, "material", "Material", "What is cut.");
        add(&CuttingData::spindle, "spindle", "Spindle", "Turns of the tool; 0 where nobody says.",
            Q::rotation, largest_spindle);
        add(&CuttingData::feed, "feed", "Feed", "Of cuts; 0: from spindle, chip load and flutes.", Q::feed,
            largest_feed);
        add(&CuttingData::plunge_feed, "plunge_feed", "Plunge feed", "Into the material; 0: half the feed.",
            Q::feed, largest_feed);
        add(&CuttingData::chip_load, "chip_load", "Chip load",
            "What every edge takes in a turn; 0 where nobody says.", Q::length, largest_tool);
        add(&CuttingData::stepover, "stepover", "Step-over", "Between passes; 0 where nobody says.",
            Q::length, largest_tool);
        add(&CuttingData::depth, "depth", "Depth", "Of layers; 0 where nobody says.", Q::length,
            largest_tool);
        return t;
    }();
    return table;
}

/// What stands above the cutter, and how it is run.
static void add_lists(ParameterTable<Tool>& t) {
    using K = ParameterKind;
    using Q = Quantity;
    constexpr Stage stage = Stage::cutter;
    t.add_records(&Tool::holder, holder_list,
                  {.label = "Holder",
                   .help = "The cylinders that the holder is made of, from the shank upward.",
                   .stage = stage,
                   .nouns = {"section", "sections"},
                   .written_empty = true});
    t.add(&Tool::flutes, {.key = "flutes",
                          .label = "Flutes",
                          .help = "Cutting edges; 0 where nobody says. Feeds are worked out from a chip "
                                  "load by it.",
                          .kind = K::integer,
                          .quantity = Q::count,
                          .minimum = 0,
                          .maximum = max_flutes,
                          .stage = Stage::advice,
                          .default_unwritten = true});
    t.add_records(&Tool::cutting, cutting_list,
                  {.label = "Feeds and speeds",
                   .help = "How the tool is run, by material. Operations take it over when they take "
                           "the tool.",
                   .stage = Stage::advice,
                   .nouns = {"material", "materials"}});
}

const ParameterTable<Tool>& tool_parameters() {
    static const ParameterTable<Tool> table = [] {
        using K = ParameterKind;
        using Q = Quantity;
        constexpr Stage stage = Stage::cutter;
        ParameterTable<Tool> t;
        t.add(&Tool::number, {.key = "number",
                              .label = "Number",
                              .help = "Place in the magazine; operations name the tool by it.",
                              .kind = K::integer,
                              .quantity = Q::count,
                              .minimum = 1,
                              .maximum = largest_tool_number,
                              .stage = Stage::output,
                              .required = "give the tool a number"});
        t.add(&Tool::name, {.key = "name",
                            .label = "Name",
                            .help = "What the setup sheet calls the tool.",
                            .kind = K::text,
                            .stage = Stage::output});
        t.add(&Tool::diameter,
              {.key = "diameter",
               .label = "Diameter",
               .help = "Cutting diameter. With a taper angle: where bottom and side line meet, below "
                       "the corner rounding.",
               .quantity = Q::length,
               .minimum = 0,
               .maximum = largest_tool,
               .open_minimum = true,
               .stage = stage,
               .required = "give the tool's diameter"});
        t.add(&Tool::corner_radius, {.key = "corner_radius",
                                     .label = "Corner radius",
                                     .help = "0 for a sharp corner; half the diameter for a ball end.",
                                     .quantity = Q::length,
                                     .minimum = 0,
                                     .maximum = largest_tool,
                                     .stage = stage});
        t.add(&Tool::bottom_angle,
              {.key = "bottom_angle",
               .label = "Bottom angle",
               .help = "From a radial line through the tip up to the bottom: 0 for a flat bottom; a "
                       "cone of half angle w has 90° less w.",
               .quantity = Q::angle,
               .minimum = 0,
               .maximum = steepest_angle,
               .stage = stage,
               .advanced = true});
        t.add(&Tool::taper_angle,
              {.key = "taper_angle",
               .label = "Taper angle",
               .help = "From the axis to the side: positive when the tool widens upward, negative for a "
                       "dovetail.",
               .quantity = Q::angle,
               .minimum = -steepest_angle,
               .maximum = steepest_angle,
               .stage = stage,
               .advanced = true});
        t.add(&Tool::flute_length, {.key = "flute_length",
                                    .label = "Flute length",
                                    .help = "Height of the cutting part above the tip.",
                                    .quantity = Q::length,
                                    .minimum = 0,
                                    .maximum = largest_tool,
                                    .open_minimum = true,
                                    .stage = stage});
        t.add(&Tool::shank_diameter, {.key = "shank_diameter",
                                      .label = "Shank diameter",
                                      .help = "Of the plain part between flutes and holder.",
                                      .quantity = Q::length,
                                      .minimum = 0,
                                      .maximum = largest_tool,
                                      .open_minimum = true,
                                      .stage = stage});
        t.add(&Tool::shank_length, {.key = "shank_length",
                                    .label = "Shank length",
                                    .help = "Of the plain part that is out of the holder.",
                                    .quantity = Q::length,
                                    .minimum = 0,
                                    .maximum = largest_tool,
                                    .stage = stage});
        add_lists(t);
        return t;
    }();
    return table;
}

AptCutter Tool::cutter() const {
    try {
        return AptCutter::from_shape(diameter, corner_radius, bottom_angle, taper_angle, flute_length);
    } catch (const Error& e) {
        throw Error(e.code(), key_of(e.where()), e.message(), e.remedy());
    }
}

std::string Tool::shape_name() const {
    AptCutter c;
    try {
        c = cutter();
    } catch (const Error&) {
        return "Invalid";
    }
    const double same = tolerance::same_shape * c.d;
    const double touch = c.e + c.r * std::sin(c.alpha); // where the corner circle leaves the bottom line
    const bool sharp = c.r <= same, ball = !sharp && touch <= same;
    const bool flat = c.alpha <= tolerance::same_shape;
    if (c.beta < -tolerance::same_shape) return ball ? "Lollipop" : "Dovetail";
    const bool tapered = c.beta > tolerance::same_shape;
    if (ball) return tapered ? "Tapered ball" : "Ball end";
    if (!sharp && flat) return tapered ? "Tapered bull nose" : "Bull nose";
    if (!sharp) return tapered ? "Tapered cone-bottom bull nose" : "Cone-bottom bull nose";
    if (flat) return tapered ? "Tapered flat" : "Flat end";
    if (tapered) return "Tapered drill point";
    return c.h <= 0.5 * c.d * std::tan(c.alpha) + same ? "Cone" : "Drill point";
}

void check_tool(const Tool& tool) {
    for (const auto& entry : tool_parameters().entries())
        entry.info.check(entry.get(tool));
    CutterProfile{tool.cutter()};
    if (!tool.holder.empty() && tool.holder.front().diameter < tool.shank_diameter)
        refuse("holder[0].diameter",
               "the holder of " + mm(tool.holder.front().diameter) + " cannot hold a shank of "
                   + mm(tool.shank_diameter),
               "enter a smaller shank diameter or a larger holder");
}

const Tool* find_tool(const std::vector<Tool>& tools, long number) {
    const auto found = std::ranges::find(tools, number, &Tool::number);
    return found != tools.end() ? &*found : nullptr;
}

long free_tool_number(const std::vector<Tool>& tools) {
    long number = 1;
    while (find_tool(tools, number))
        ++number;
    return number;
}

} // namespace facetmill
