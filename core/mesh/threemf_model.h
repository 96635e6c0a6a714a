// What a 3MF file holds: objects, each a mesh or put together from others, and the items on its build plate.
// Core specification 1.3 and the production extension (models in several files). Internal to the room.
#pragma once

#include "core/mesh/mesh_reader.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace facetmill::detail {

/// Rows of a point times this: x' = x m[0] + y m[3] + z m[6] + m[9].
struct Transform3mf {
    std::array<double, 12> m{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    bool operator==(const Transform3mf&) const = default;
    Vec3 of(const Vec3& p) const {
        return {p.x() * m[0] + p.y() * m[3] + p.z() * m[6] + m[9],
                p.x() * m[1] + p.y() * m[4] + p.z() * m[7] + m[10],
                p.x() * m[2] + p.y() * m[5] + p.z() * m[8] + m[11]};
    }
    double determinant() const {
        return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6])
               + m[2] * (m[3] * m[7] - m[4] * m[6]);
    }
    /// First this, then `outer`.
    Transform3mf then(const Transform3mf& outer) const;
};

/// The file in the archive, in small letters without a slash before it, and the object's number in it.
using Id3mf = std::pair<std::string, std::uint32_t>;

struct Use3mf {
    Id3mf object;
    Transform3mf transform;
    std::string part_number; ///< of an item on the plate
};

struct Object3mf {
    std::string name;
    bool of_model = true; ///< not a support, a modifier or the like
    bool has_slices = false;
    std::vector<Vec3> vertices;
    std::vector<Facet> facets;
    std::vector<Use3mf> components;
};

struct Model3mf {
    std::string root; ///< the file with the build plate
    LengthUnit unit = LengthUnit::mm;
    double factor = 1; ///< of the file's numbers, to that unit
    std::map<Id3mf, Object3mf> objects;
    std::vector<Use3mf> items; ///< on the build plate
};

/// All of it. Throws Error as load_mesh says.
Model3mf read_model_3mf(const MeshSource& source, const Progress& progress);

} // namespace facetmill::detail
