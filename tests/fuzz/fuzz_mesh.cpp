// The mesh readers, by the ending of a name: FUZZ_NAME is "a.stl", "a.png" and so on.
#include "core/mesh/mesh_io.h"
#include "tests/fuzz/fuzz.h"

using namespace facetmill;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::reads([&] {
        const LoadedMesh loaded = read_mesh(fuzz::text_of(data, size), FUZZ_NAME, LengthUnit::mm, Progress());
        for (const auto& facet : loaded.mesh->facets)
            for (const Index v : facet)
                if (v >= loaded.mesh->vertices.size())
                    fuzz::found("a facet names a vertex that is not there");
    });
    return 0;
}
