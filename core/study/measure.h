// What a candidate of a study is weighed by. Values stand as files have them: lengths in the project's units,
// times in seconds, shares from 0 to 1. Less is better of every one.
//
// Loads and wear compare candidates of one study: one part, one material. What a spindle or an edge stands,
// nothing here knows.
//
// peak_load: the largest volume cut in a time, of stretches of the path as long as the cutter is wide
// (core/verify/cutting_load.h). The power that cutting takes is that times the specific cutting force of the
// material (Kienzle 1952).
//
// wear: of the tool of which it is the most, the volume that it cuts over z d^2: z its edges (two where it
// does not say), d the largest diameter of its cutting part. What rubs off a surface is as the force times
// the way (Archard 1953), which for an edge is the energy of cutting, and that as the volume; it is shared by
// the edges, and by as much of them as the cutter is wide. This is no tool life: cutting speed, which decides
// it (Taylor 1907), feed, material, coating and coolant are no part of it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// How closely a candidate has been looked at: planned; planned and judged on few places; planned and judged
/// as `facetmill-cli simulate` does.
enum class Rung { estimate, coarse, fine };
inline constexpr std::array<Rung, 3> all_rungs = {Rung::estimate, Rung::coarse, Rung::fine};

/// "estimate", "coarse", "fine".
std::string_view rung_name(Rung rung);
/// Throws Error(usage) whose place is `place`.
Rung rung_named(std::string_view name, const std::string& place);

enum class Measure {
    machining_time, ///< s, of all programs, without tool changes
    cut_length,
    rapid_length,
    tool_changes, ///< how often a tool is taken up, in all setups
    cusp_max,     ///< as planned, of operations that leave no more on purpose than the last
    gouge_max,
    excess_max,
    excess_p99,
    excess_p95,
    uncut_share,
    peak_load, ///< cubed units a minute
    wear,      ///< as a length
};
inline constexpr std::size_t measure_count = 12;

std::string_view measure_name(Measure measure);
/// Throws Error(unknown_key) whose place is `place`.
Measure measure_named(std::string_view name, const std::string& place);
/// The first rung that tells it.
Rung known_from(Measure measure);
/// Is it a length, in the project's units?
bool is_length(Measure measure);
/// "s", "in", "mm^3/min"; empty for numbers and shares. `units`: of the project.
std::string measure_unit(Measure measure, std::string_view units);

class Measures {
public:
    std::optional<double>& operator[](Measure m) { return values_[std::size_t(m)]; }
    const std::optional<double>& operator[](Measure m) const { return values_[std::size_t(m)]; }
    bool operator==(const Measures&) const = default;

private:
    std::array<std::optional<double>, measure_count> values_;
};

/// All, in the order of tables.
const std::vector<Measure>& all_measures();

} // namespace facetmill
