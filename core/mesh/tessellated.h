// What `facetmill-step`, the program that reads STEP and IGES files, hands to core. It is a program of its
// own so that the geometry library it is built with can neither crash the workbench nor keep its memory, and
// a cancel ends it at once.
//
//     facetmill-step --format step|iges --chord MM --angle DEGREES [--memory MB] INPUT OUTPUT
//
// On its standard output stand lines of text: "progress F LABEL" with F from 0 to 1; at the end, with exit
// status 1, "error CODE", "what TEXT" and "remedy TEXT", CODE as in `code_name`. OUTPUT is the first line
// `tessellated_magic`, lines "key value" in any order, an empty line, and then, little endian,
//     vertices × 3 doubles    x, y, z, millimetres; facets beside each other name the same vertices
//     facets × 3 uint32       vertices, counter-clockwise seen from outside
//     facets × 1 uint32       number of the face of the file that the facet lies on, from 0
// Keys: vertices, facets, faces (how many numbers of faces there are), unit (the file's name of its unit),
// mm_per_unit, out, in, chord, solids, loose_faces, missing_faces, sewn (0 or 1), part_count, part (a name;
// once for each).
#pragma once

#include <cstddef>
#include <string_view>

namespace facetmill::detail {

inline constexpr std::string_view tessellated_magic = "facetmill-tessellation 1";
/// Names of parts that are handed over, at most.
inline constexpr std::size_t max_part_names = 1000;
/// Facets that the program makes, at most.
inline constexpr std::size_t max_tessellated_facets = 50'000'000;

} // namespace facetmill::detail
