#include "app/step/tessellation.h"

#include "app/step/deviation.h"
#include "core/base/error.h"
#include "core/mesh/tessellated.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <OSD_Parallel.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>

namespace facetmill::step {

namespace {

/// How often the mesher is asked at most.
constexpr int max_tries = 2;
/// What it is asked for the second time, as a share of what would just do, and of what it was asked for at
/// least: facets grow as this shrinks.
constexpr double finer_share = 0.8, finest_share = 0.25;
/// A distance of an edge from its chords that exceeds that of the surfaces by less is the same.
constexpr double same_distance = 1.01;

/// Nodes of all faces, joined where faces share an edge or a vertex.
class SharedNodes {
public:
    explicit SharedNodes(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t root(std::uint32_t n) {
        while (parent_[n] != n)
            n = parent_[n] = parent_[parent_[n]];
        return n;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

struct MeshedFace {
    const PlacedFace* placed = nullptr;
    opencascade::handle<Poly_Triangulation> facets;
    TopLoc_Location at;
    std::uint32_t first_node = 0;
};

class Tessellator {
public:
    Tessellator(const SurfaceFile& file, double chord, StepProgress& progress)
        : file_(file), chord_(chord), progress_(progress) {}

    void mesh(double chord, double angle, const Message_ProgressRange& range) {
        IMeshTools_Parameters parameters;
        parameters.Deflection = chord;
        parameters.Angle = angle;
        parameters.InParallel = Standard_True;
        BRepTools::Clean(file_.shape);
        BRepMesh_IncrementalMesh(file_.shape, parameters, range);
        collect();
        measure();
    }
    double larger_deviation() const { return std::max(made_.out, made_.in); }

    Tessellation finish() {
        share_nodes();
        take_facets();
        return std::move(made_);
    }

private:
    void collect();
    void measure();
    void share_nodes();
    void share_edge(const MeshedFace& face, const TopoDS_Edge& edge);
    void take_facets();
    void turn_bodies();

    const SurfaceFile& file_;
    double chord_; ///< that is wanted
    StepProgress& progress_;
    std::vector<MeshedFace> faces_;
    std::size_t nodes_ = 0;
    SharedNodes shared_{0};
    TopTools_IndexedMapOfShape edges_, vertices_;
    std::vector<std::vector<std::uint32_t>> nodes_of_edge_;
    std::vector<std::uint32_t> node_of_vertex_;
    std::vector<Deviation> deviation_of_body_;
    std::vector<std::size_t> body_of_facet_;
    Tessellation made_;
};

void Tessellator::collect() {
    faces_.clear();
    nodes_ = 0;
    made_.missing_faces = 0;
    std::size_t facets = 0;
    for (const PlacedFace& placed : file_.faces) {
        MeshedFace face{&placed, {}, {}, std::uint32_t(nodes_)};
        face.facets = BRep_Tool::Triangulation(placed.face, face.at);
        if (face.facets.IsNull() || face.facets->NbTriangles() == 0) {
            ++made_.missing_faces;
            continue;
        }
        nodes_ += std::size_t(face.facets->NbNodes());
        facets += std::size_t(face.facets->NbTriangles());
        if (facets > detail::max_tessellated_facets)
            throw Error(ErrorCode::limit_exceeded, "",
                        "it takes more than " + std::to_string(detail::max_tessellated_facets)
                            + " facets at this chord tolerance",
                        "allow a larger one");
        faces_.push_back(face);
    }
    if (faces_.empty())
        throw Error(ErrorCode::no_facets, "", "none of its surfaces could be tessellated",
                    "export the part again, or as STL");
}

void Tessellator::measure() {
    progress_.stretch(0.85, 0.95, "Measuring the deviation");
    deviation_of_body_.assign(file_.bodies + 1, {});
    // Copies of a face have the same triangulation, and the same deviation.
    std::map<std::pair<const void*, int>, std::size_t> first;
    std::vector<const MeshedFace*> measured;
    std::vector<std::size_t> like;
    for (const MeshedFace& face : faces_) {
        const auto key =
            std::make_pair(static_cast<const void*>(face.facets.get()), int(face.placed->face.Orientation()));
        const auto [found, is_new] = first.emplace(key, measured.size());
        if (is_new) measured.push_back(&face);
        like.push_back(found->second);
    }
    std::vector<Deviation> found(measured.size());
    std::atomic<std::size_t> done{0};
    std::mutex telling;
    OSD_Parallel::For(0, int(measured.size()), [&](int i) {
        const MeshedFace& face = *measured[std::size_t(i)];
        found[std::size_t(i)] = face_deviation(face.placed->face, *face.facets, face.at, chord_);
        const std::size_t now = ++done;
        if (const std::unique_lock lock(telling, std::try_to_lock); lock)
            progress_.set(double(now) / double(measured.size()));
    });
    for (std::size_t f = 0; f < faces_.size(); ++f)
        deviation_of_body_[faces_[f].placed->body].add(found[like[f]]);
    edges_.Clear();
    for (const MeshedFace& face : faces_) {
        Deviation& body = deviation_of_body_[face.placed->body];
        for (TopExp_Explorer e(face.placed->face, TopAbs_EDGE); e.More(); e.Next()) {
            const int known_before = edges_.Extent();
            if (edges_.Add(e.Current()) <= known_before) continue;
            const double d = edge_deviation(TopoDS::Edge(e.Current()), face.facets, face.at);
            if (d > same_distance * body.larger()) body.add({d, d});
        }
    }
    made_.out = made_.in = 0;
    for (const Deviation& body : deviation_of_body_) {
        made_.out = std::max(made_.out, body.out);
        made_.in = std::max(made_.in, body.in);
    }
}

void Tessellator::share_edge(const MeshedFace& face, const TopoDS_Edge& edge) {
    const auto polygon = BRep_Tool::PolygonOnTriangulation(edge, face.facets, face.at);
    if (polygon.IsNull()) return;
    std::vector<std::uint32_t> nodes;
    for (int i = 1; i <= polygon->NbNodes(); ++i)
        nodes.push_back(face.first_node + std::uint32_t(polygon->Node(i) - 1));
    if (BRep_Tool::Degenerated(edge)) // all at one place
        for (const std::uint32_t n : nodes)
            shared_.join(nodes.front(), n);
    const int index = edges_.Add(edge);
    nodes_of_edge_.resize(std::size_t(edges_.Extent()));
    std::vector<std::uint32_t>& before = nodes_of_edge_[std::size_t(index - 1)];
    if (before.empty()) before = nodes;
    if (before.size() == nodes.size())
        for (std::size_t i = 0; i < nodes.size(); ++i)
            shared_.join(before[i], nodes[i]);
    TopoDS_Vertex first, last;
    TopExp::Vertices(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), first, last);
    for (const auto& [vertex, node] : {std::pair(first, nodes.front()), std::pair(last, nodes.back())}) {
        if (vertex.IsNull()) continue;
        const int at = vertices_.Add(vertex);
        if (std::size_t(at) > node_of_vertex_.size()) node_of_vertex_.push_back(node);
        shared_.join(node_of_vertex_[std::size_t(at - 1)], node);
    }
}

void Tessellator::share_nodes() {
    shared_ = SharedNodes(nodes_);
    edges_.Clear();
    for (const MeshedFace& face : faces_)
        for (TopExp_Explorer e(face.placed->face, TopAbs_EDGE); e.More(); e.Next())
            share_edge(face, TopoDS::Edge(e.Current()));
}

void Tessellator::take_facets() {
    constexpr auto none = std::uint32_t(-1);
    std::vector<std::uint32_t> number(nodes_, none);
    for (const MeshedFace& face : faces_) {
        const gp_Trsf place = face.at.Transformation();
        const bool reversed = face.placed->face.Orientation() == TopAbs_REVERSED;
        for (int t = 1; t <= face.facets->NbTriangles(); ++t) {
            std::array<int, 3> n{};
            face.facets->Triangle(t).Get(n[0], n[1], n[2]);
            if (reversed) std::swap(n[1], n[2]);
            std::array<std::uint32_t, 3> facet{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t root = shared_.root(face.first_node + std::uint32_t(n[k] - 1));
                if (number[root] == none) {
                    number[root] = std::uint32_t(made_.vertices.size());
                    const gp_Pnt p = face.facets->Node(n[k]).Transformed(place);
                    made_.vertices.push_back({p.X(), p.Y(), p.Z()});
                }
                facet[k] = number[root];
            }
            if (facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0]) continue; // at a pole
            made_.facets.push_back(facet);
            made_.face_of.push_back(std::uint32_t(face.placed->number));
            body_of_facet_.push_back(face.placed->body);
        }
    }
    turn_bodies();
}

/// Bodies whose facets all face inward are turned; deviations go along.
void Tessellator::turn_bodies() {
    std::vector<double> volume(file_.bodies + 1, 0);
    for (std::size_t f = 0; f < made_.facets.size(); ++f) {
        const auto& [a, b, c] = made_.facets[f];
        const auto &p = made_.vertices[a], &q = made_.vertices[b], &r = made_.vertices[c];
        volume[body_of_facet_[f]] += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2])
                                     + p[2] * (q[0] * r[1] - q[1] * r[0]);
    }
    volume[file_.bodies] = 0; // what is loose has no inside
    for (std::size_t f = 0; f < made_.facets.size(); ++f)
        if (volume[body_of_facet_[f]] < 0) std::swap(made_.facets[f][1], made_.facets[f][2]);
    Deviation all;
    for (std::size_t b = 0; b < volume.size(); ++b) {
        const Deviation& d = deviation_of_body_[b];
        all.add(b == file_.bodies ? Deviation{d.larger(), d.larger()} : volume[b] < 0 ? d.turned() : d);
    }
    made_.out = all.out;
    made_.in = all.in;
}

} // namespace

Tessellation tessellate(const SurfaceFile& file, double chord, double angle, StepProgress& progress) {
    Tessellator tessellator(file, chord, progress);
    double asked = chord;
    for (int i = 1;; ++i) {
        tessellator.mesh(asked, angle, progress.stretch(0.6, 0.85, "Tessellating"));
        const double found = tessellator.larger_deviation();
        if (found <= chord || i == max_tries) break;
        asked *= std::max(finer_share * chord / found, finest_share);
    }
    progress.stretch(0.95, 1, "Joining facets");
    Tessellation made = tessellator.finish();
    made.chord = asked;
    return made;
}

} // namespace facetmill::step
