#include "core/repair/sheet_edit.h"

#include "core/mesh/unused_vertices.h"
#include "core/repair/repair_step.h"

namespace facetmill::detail {

SheetEdit::SheetEdit(const Mesh& mesh, const Progress& progress)
    : source_(mesh), topology_(build_topology(mesh, progress)), half_(topology_->mesh),
      held_(topology_->vertex_of.size(), 0) {
    half_.request_vertex_status();
    half_.request_edge_status();
    half_.request_halfedge_status();
    half_.request_face_status();
    const auto& vertex_of = topology_->vertex_of;
    for (std::size_t v = mesh.vertices.size(); v < vertex_of.size(); ++v)
        held_[v] = held_[vertex_of[v]] = 1;
    std::size_t in = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (in < topology_->facet_of.size() && topology_->facet_of[in] == f) {
            ++in;
            continue;
        }
        for (const Index v : mesh.facets[f])
            held_[v] = 1;
    }
    // Of a vertex in several sheets all copies are held.
    for (std::size_t v = mesh.vertices.size(); v < vertex_of.size(); ++v)
        held_[v] = held_[vertex_of[v]];
}

std::array<SheetEdit::Vertex, 3> SheetEdit::corners(Face f) const {
    const Halfedge a = half_.halfedge_handle(f), b = half_.next_halfedge_handle(a);
    return {half_.from_vertex_handle(a), half_.from_vertex_handle(b), half_.to_vertex_handle(b)};
}

std::shared_ptr<Mesh> SheetEdit::mesh(const Progress& progress) const {
    auto result = std::make_shared<Mesh>();
    result->vertices = source_.vertices;
    for (std::size_t v = 0; v < source_.vertices.size(); ++v)
        if (!half_.status(Vertex(int(v))).deleted() && !held_[v]) result->vertices[v] = place(Vertex(int(v)));
    result->facets.reserve(half_.n_faces());
    std::size_t in = 0;
    for (std::size_t f = 0; f < source_.facet_count(); ++f) {
        if (f % 65536 == 0) progress.check();
        const Facet& before = source_.facets[f];
        if (in == topology_->facet_of.size() || topology_->facet_of[in] != f) {
            result->facets.push_back(before);
            continue;
        }
        const Face face{int(in++)};
        if (half_.status(face).deleted()) continue;
        const auto c = corners(face);
        Facet facet{};
        for (std::size_t k = 0; k < 3; ++k)
            facet[k] = topology_->vertex_of[std::size_t(c[k].idx())];
        for (std::size_t turn = 0; turn < 3 && facet != before; ++turn)
            facet = {facet[1], facet[2], facet[0]};
        result->facets.push_back(facet);
    }
    drop_unused_vertices(*result, progress);
    return result;
}

} // namespace facetmill::detail
