// A little roof, its project and a study of that, as files: each candidate takes some hundredths of a second.
#pragma once

#include "tests/golden/run_cli.h"

namespace facetmill::test {

inline constexpr const char* study_part = R"(solid roof
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 20 0 0 vertex 20 10 4 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 20 10 4 vertex 0 10 4 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 10 4 vertex 20 10 4 vertex 10 20 0 endloop endfacet
endsolid roof
)";

inline constexpr const char* study_project_text =
    R"({ "facetmill": 1, "units": "mm", "part": { "file": "roof.stl" },
    "stock": { "kind": "box", "margin": [4, 4, 1] },
    "tools": [ { "number": 1, "diameter": 10, "corner_radius": 5, "flute_length": 20, "shank_length": 20 },
               { "number": 2, "diameter": 8, "corner_radius": 4, "flute_length": 20, "shank_length": 20 } ],
    "operations": [ { "kind": "finish3", "name": "Fine", "tool": 2, "tolerance": 0.5, "direction": "y" } ] })";

inline constexpr const char* study_text =
    R"({ "study": 1, "project": "job.facetmill", "want": ["machining_time", "excess_max"],
    "vary": [ { "path": "operations[Fine].direction", "values": ["x", "y"] },
              { "path": "operations[Fine].tool", "values": "tools" },
              { "path": "operations[Fine].tolerance", "values": [0.3, 0.5] } ],
    "limits": { "excess_p95": 0.5 } })";

/// roof.stl, job.facetmill, study.json.
inline void fill_with_study(const Sandbox& s) {
    s.write("roof.stl", study_part);
    s.write("job.facetmill", study_project_text);
    s.write("study.json", study_text);
}

} // namespace facetmill::test
