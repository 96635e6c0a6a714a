// Meshes of files in their places: of the part, its stock, its fixtures.
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/mesh/mesh.h"
#include "core/setup/placement.h"

#include <filesystem>
#include <string>

namespace facetmill {

/// The numbers that place a mesh, of part, stock and fixtures alike.
struct MeshPlace {
    LengthUnit unit = LengthUnit::mm;
    double scale = 1;
    Placement placement;

    /// `Spec`: of the part, its stock, or a fixture.
    template <class Spec>
    static MeshPlace of(const Spec& spec) {
        return {spec.unit, spec.scale, placement_of(spec)};
    }
};

/// The mesh itself where nothing moves it.
MeshPtr placed(const MeshPtr& mesh, const MeshPlace& place, const Progress& progress);
/// Another text for another mesh.
std::string mesh_key(const std::filesystem::path& path, const MeshPlace& place);
/// Throws Error(coordinate_range) for coordinates that nothing is worked out with; `what`: "part".
void check_coordinates(const Box3& box, const std::string& what);
/// The closed mesh of a stock or a fixture (`what`). Throws Error(files, out_of_range, coordinate_range).
MeshPtr load_solid(const std::filesystem::path& path, const MeshPlace& place, const std::string& what,
                   const Progress& progress);

} // namespace facetmill
