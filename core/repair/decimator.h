// One run of decimation: edges go in the order of the error that they leave, as long as the vertices that
// went stay near. What a run did can be done again but for some places. Internal to the room.
#pragma once

#include "core/repair/deviation.h"
#include "core/repair/quadric.h"
#include "core/repair/sheet_edit.h"

#include <array>
#include <memory>
#include <queue>
#include <vector>

namespace facetmill::detail {

/// What a run did: the edges that went, in order, and those that could not.
struct DecimationLog {
    struct Collapse {
        Vec3 to;
        Index from, into; ///< vertices of the half-edges; `into` stays, and moves to `to`
    };
    std::vector<Collapse> collapses;
    std::vector<std::uint32_t>
        refused; ///< per edge: 1 + the stamp with which it could not go; 0: it was not asked
};

class Decimator {
public:
    /// `held`: vertices of the mesh that stay where they are. Mesh and surface must outlive this.
    Decimator(const Mesh& mesh, const DeviationIndex& surface, const std::vector<char>& held,
              const Progress& progress);

    /// Does again what another run did, but for collapses of the vertices that are held only now, and for
    /// what followed from them there.
    void repeat(const DecimationLog& log, const std::vector<char>& held_now, const Progress& progress);
    /// Until `least` facets are left, or no edge can go within the bound.
    void run(double bound, std::size_t least, const Progress& progress);

    std::shared_ptr<Mesh> result(const Progress& progress) const { return sheets_.mesh(progress); }
    std::size_t left_out() const { return sheets_.left_out(); }
    DecimationLog take_log() { return std::move(log_); }

private:
    using Vertex = SheetEdit::Vertex;
    using Edge = SheetEdit::Edge;
    using Halfedge = SheetEdit::Halfedge;
    using Face = SheetEdit::Face;
    struct Candidate {
        double cost;
        std::uint32_t edge, stamp;
        bool operator<(const Candidate& other) const {
            return cost > other.cost || (cost == other.cost && edge > other.edge);
        }
    };
    struct Point {
        Index point;      ///< vertex of the source
        std::size_t face; ///< of `fresh_`
    };

    static std::size_t id(OpenMesh::BaseHandle h) { return std::size_t(h.idx()); }
    std::uint32_t stamp_of(Edge e) const;
    void measure(const Progress& progress);
    bool target(Vertex u, Vertex v, Vec3& to, double& cost) const;
    void offer(Edge e);
    bool try_collapse(Halfedge h);
    void collapse(Halfedge h, const Vec3& to);
    bool collect(Vertex u, Vertex v, const Vec3& to);
    bool place_points(Vertex u, Vertex v);
    bool stays_near(const Vec3& to) const;
    bool is_changed(Vertex v) const;
    Vec3 source_place(Index v) const;

    const Mesh& mesh_;
    const DeviationIndex& surface_;
    SheetEdit sheets_;
    HalfedgeMesh& half_;
    Vec3 origin_;
    double bound2_ = 0;
    std::size_t left_; ///< facets in sheets
    std::vector<Quadric> quadrics_;
    std::vector<std::uint32_t> stamps_; ///< per vertex: 0 until it moves, and more after each move
    std::priority_queue<Candidate> queue_;
    std::vector<Index> first_, next_; ///< the vertices that went, in lists by face
    std::vector<Face> fresh_, gone_;
    std::vector<std::array<Vec3, 3>> corners_; ///< of `fresh_`
    std::vector<Point> points_;
    DecimationLog log_;
    std::vector<char> changed_; ///< per vertex: it is not as in the run that was repeated; empty: none was
};

} // namespace facetmill::detail
