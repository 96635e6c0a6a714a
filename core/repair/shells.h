// The shells of a mesh: facets joined by edges, also by those of more than two facets.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/repair/recipe.h"

#include <vector>

namespace facetmill {

struct Shell {
    std::size_t facets = 0;
    double area = 0; ///< mm^2
    Box3 box;
};

/// In the order of their first facets.
struct Shells {
    std::vector<Shell> all;
    std::vector<Index> of_facet;
};

Shells shells_of(const Mesh& mesh, const Progress& progress);

/// For each shell whether a step of kind `pieces` takes it away.
std::vector<char> pieces_that_go(const Shells& shells, const RepairStep& step);

} // namespace facetmill
