// A study: a project, what of it may vary, and what is wanted of it. From a JSON file:
//
//     { "study": 1, "project": "concave.facetmill",
//       "tools": [ { "number": 5, "diameter": 0.75, ... } ],
//       "vary": [ { "path": "operations[Finish].direction", "values": ["x", "y", 45] },
//                 { "path": "operations[Finish].tool", "values": "tools" },
//                 { "path": "operations[Rough].allowance", "from": 0.01, "to": 0.03, "steps": 3 },
//                 { "path": "operations", "values": "orders" },
//                 { "name": "strategy", "choices": [
//                     { "label": "along", "operations[Finish].kind": "finish3" },
//                     { "operations[Finish].kind": "scallop", "operations[Finish].stepover": 0.02 } ] } ],
//       "want": ["machining_time", "excess_max"],
//       "limits": { "excess_max": 0.0025, "cusp_max": "project", "tool_changes": 3 },
//       "samples": 40, "seed": 1, "halving": { "coarse": 0.5, "fine": 0.25 } }
//
// Paths are places of the project's file (project_place.h), values as that file has them, in its units. That
// a candidate is verified, with no gouge, collision or place out of the machine's reach, is always a limit;
// all are judged against the tolerance of the project as it stands, so that a coarser path is none that does
// better.
#pragma once

#include "core/base/strict_json.h"
#include "core/job/project.h"
#include "core/study/measure.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace facetmill {

/// One of the values that something may have.
struct StudyChoice {
    std::string label;                                ///< in tables
    std::vector<std::pair<std::string, Json>> values; ///< places of the project's file, and what is put there
};

struct StudyVariation {
    std::string name;
    std::vector<StudyChoice> choices; ///< at least one
};

struct StudyLimit {
    Measure measure = Measure::machining_time;
    double most = 0;      ///< as files have it; of the project's: how many times that
    bool project = false; ///< what the project as it stands comes to
};

struct Study {
    std::string project;     ///< its file, as written: relative to the study's, or absolute
    std::vector<Json> tools; ///< beside the project's, as files have them
    std::vector<StudyVariation> vary;
    std::vector<Measure> want; ///< the first chooses the winner, all make the front
    std::vector<StudyLimit> limits;
    std::size_t samples = 0; ///< 0: all combinations
    std::uint64_t seed = 1;
    double coarse = 0.5, fine = 0.25; ///< shares of the candidates that are judged so closely

    /// More than this are not enumerated.
    static constexpr std::size_t max_candidates = 20'000;
};

/// Reads a study without a look at its project but for what "tools" and "orders" stand for. Throws
/// Error(syntax, unknown_key, wrong_type, out_of_range, missing_key ...) whose place is "name: vary[0].path";
/// Error(missing_key) where nothing may vary.
Study parse_study(std::string_view json, const std::string& name, const Project& project);
/// The project's file that a study names, as written. Throws likewise.
std::string study_project(std::string_view json, const std::string& name);

} // namespace facetmill
