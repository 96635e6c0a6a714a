#include "tests/bench/scalar/facet_duties.h"

#include "core/gouge/contact_blocks.h"
#include "core/gouge/facet_duties.h"
#include "tests/bench/scalar/contact_blocks.h"

namespace facetmill::scalar {

std::vector<std::uint8_t> facet_duties(const Mesh& mesh, const Progress& progress) {
    const std::vector<std::uint8_t> core = facetmill::facet_duties(mesh, progress);
    std::vector<std::uint8_t> duties(core.size(), 0), kept(mesh.vertices.size(), 0);
    for (std::size_t f = 0; f < core.size(); ++f) {
        if (core[f] & facetmill::duty_plane) duties[f] = duty_plane;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!(core[f] & (facetmill::duty_edge << k))) continue;
            duties[f] |= std::uint8_t(duty_edge << k);
            kept[mesh.facets[f][k]] = kept[mesh.facets[f][(k + 1) % 3]] = 1;
        }
    }
    for (std::size_t f = 0; f < core.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint8_t& keep = kept[mesh.facets[f][k]];
            if (keep) duties[f] |= std::uint8_t(duty_vertex << k);
            keep = 0; // the first facet that has it owns it
        }
    return duties;
}

} // namespace facetmill::scalar
