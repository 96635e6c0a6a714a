// What a candidate of a study is weighed by. Values stand as files have them: lengths in the project's units,
// times in seconds, shares from 0 to 1. Less is better of every one.
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
};
inline constexpr std::size_t measure_count = 10;

std::string_view measure_name(Measure measure);
/// Throws Error(unknown_key) whose place is `place`.
Measure measure_named(std::string_view name, const std::string& place);
/// The first rung that tells it.
Rung known_from(Measure measure);
/// Is it a length, in the project's units?
bool is_length(Measure measure);

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
