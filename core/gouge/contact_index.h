// Spatial index over a mesh for lifts of cutters with any axis. Built once, queried from any thread.
#pragma once

#include "core/base/progress.h"
#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"

#include <memory>
#include <span>

namespace facetmill {

/// The facets of a mesh as the kernels of this room ask for them.
class ContactIndex {
public:
    /// Takes at most 100 bytes of memory a facet, the mesh not counted, and 100 MB more where many are long
    /// and lie askew: those are listed in pieces. Throws Error(non_finite) for corners
    /// that are not finite or beyond tolerance::largest_coordinate.
    ContactIndex(MeshPtr mesh, const Progress& progress);
    ~ContactIndex();
    ContactIndex(const ContactIndex&) = delete;
    ContactIndex& operator=(const ContactIndex&) = delete;

    const Mesh& mesh() const { return *mesh_; }
    MeshPtr mesh_ptr() const { return mesh_; }

    /// Bytes held, the mesh not counted.
    std::size_t memory() const;

    struct Impl;
    const Impl& impl() const { return *impl_; }

private:
    MeshPtr mesh_;
    std::unique_ptr<Impl> impl_;
};

using ContactIndexPtr = std::shared_ptr<const ContactIndex>;

} // namespace facetmill
