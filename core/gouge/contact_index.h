// Spatial index over a mesh for lifts along +Z. Built once, queried from any thread.
#pragma once

#include "core/base/progress.h"
#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"

#include <memory>
#include <span>

namespace facetmill {

class ContactIndex {
public:
    /// Vertex coordinates must be finite. Cancellation within 20 ms. Memory at most 100 bytes a facet.
    ContactIndex(MeshPtr mesh, const Progress& progress);
    ~ContactIndex();
    ContactIndex(const ContactIndex&) = delete;
    ContactIndex& operator=(const ContactIndex&) = delete;

    const Mesh& mesh() const { return *mesh_; }
    MeshPtr mesh_ptr() const { return mesh_; }

    struct Impl;
    const Impl& impl() const { return *impl_; }

private:
    MeshPtr mesh_;
    std::unique_ptr<Impl> impl_;
};

using ContactIndexPtr = std::shared_ptr<const ContactIndex>;

} // namespace facetmill
