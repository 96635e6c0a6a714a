#include "core/study/measure.h"

#include "core/base/error.h"
#include "core/base/parameter.h"

namespace facetmill {

namespace {

constexpr std::array<std::string_view, 3> rung_names = {"estimate", "coarse", "fine"};

struct MeasureInfo {
    std::string_view name;
    Rung from;
    bool length;
};
/// In the order of Measure.
constexpr std::array<MeasureInfo, measure_count> measure_infos = {{
    {"machining_time", Rung::estimate, false},
    {"cut_length", Rung::estimate, true},
    {"rapid_length", Rung::estimate, true},
    {"tool_changes", Rung::estimate, false},
    {"cusp_max", Rung::estimate, true},
    {"gouge_max", Rung::coarse, true},
    {"excess_max", Rung::coarse, true},
    {"excess_p99", Rung::coarse, true},
    {"excess_p95", Rung::coarse, true},
    {"uncut_share", Rung::coarse, false},
    {"peak_load", Rung::coarse, false},
    {"wear", Rung::coarse, true},
}};

} // namespace

std::string_view rung_name(Rung rung) {
    return rung_names.at(std::size_t(rung));
}

Rung rung_named(std::string_view name, const std::string& place) {
    for (const Rung rung : all_rungs)
        if (rung_name(rung) == name) return rung;
    throw Error(ErrorCode::usage, place, "'" + printable(name) + "' is no rung of a study",
                "give estimate, coarse or fine");
}

std::string_view measure_name(Measure measure) {
    return measure_infos.at(std::size_t(measure)).name;
}

Measure measure_named(std::string_view name, const std::string& place) {
    std::vector<std::string> known;
    std::string list;
    for (const Measure m : all_measures()) {
        if (measure_name(m) == name) return m;
        known.emplace_back(measure_name(m));
        list += (list.empty() ? "" : ", ") + known.back();
    }
    const std::string near = nearest_name(name, known);
    throw Error(ErrorCode::unknown_key, place, "nothing is measured that is called '" + printable(name) + "'",
                near.empty() ? "measured are: " + list : "did you mean '" + near + "'?");
}

Rung known_from(Measure measure) {
    return measure_infos.at(std::size_t(measure)).from;
}

bool is_length(Measure measure) {
    return measure_infos.at(std::size_t(measure)).length;
}

std::string measure_unit(Measure measure, std::string_view units) {
    if (is_length(measure)) return std::string(units);
    if (measure == Measure::machining_time) return "s";
    return measure == Measure::peak_load ? std::string(units) + "^3/min" : "";
}

const std::vector<Measure>& all_measures() {
    static const std::vector<Measure> all = [] {
        std::vector<Measure> list;
        for (std::size_t i = 0; i < measure_count; ++i)
            list.push_back(Measure(i));
        return list;
    }();
    return all;
}

} // namespace facetmill
