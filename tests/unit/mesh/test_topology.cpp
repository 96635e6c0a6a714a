// Half-edge connectivity: every facet is in the structure or counted, whatever the mesh is like.
#include "core/mesh/topology.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/shapes.h"

#include <QTest>

#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Everything a half-edge structure promises, checked from outside; empty when it holds.
std::string fault(const Mesh& source, const Topology& t) {
    const HalfedgeMesh& m = t.mesh;
    if (t.facet_of.size() != m.n_faces() || t.facet_of.size() + t.left_out != source.facet_count())
        return "facets got lost";
    if (t.vertex_of.size() != m.n_vertices() || t.vertex_of.size() < source.vertices.size())
        return "vertices got lost";
    for (std::size_t v = 0; v < t.vertex_of.size(); ++v) {
        if (v < source.vertices.size() && t.vertex_of[v] != v) return "vertex numbers changed";
        const auto p = m.point(OpenMesh::VertexHandle(int(v)));
        if (Vec3(p[0], p[1], p[2]) != source.vertices[t.vertex_of[v]]) return "a vertex moved";
    }
    if (!std::is_sorted(t.facet_of.begin(), t.facet_of.end())
        || std::adjacent_find(t.facet_of.begin(), t.facet_of.end()) != t.facet_of.end())
        return "facets are not in their order";
    for (const auto f : m.faces()) {
        Facet corners{};
        std::size_t k = 0;
        for (const auto v : m.fv_range(f)) {
            if (k == 3) return "a face with more than three corners";
            corners[k++] = t.vertex_of[std::size_t(v.idx())];
        }
        if (k != 3 || corners != source.facets[t.facet_of[std::size_t(f.idx())]])
            return "a face has other corners";
    }
    std::size_t border = 0, border_by_loops = 0;
    for (const auto h : m.halfedges()) {
        const auto next = m.next_halfedge_handle(h);
        if (!next.is_valid() || m.from_vertex_handle(next) != m.to_vertex_handle(h)
            || m.face_handle(next) != m.face_handle(h))
            return "a half-edge goes on somewhere else";
        border += m.is_boundary(h);
        if (m.is_boundary(h) && m.is_boundary(m.opposite_halfedge_handle(h))) return "an edge without faces";
    }
    std::set<int> seen;
    for (const auto h : m.halfedges())
        if (m.is_boundary(h))
            for (HalfedgeMesh::HalfedgeHandle at = h; seen.insert(at.idx()).second;
                 at = m.next_halfedge_handle(at))
                ++border_by_loops;
    if (border != border_by_loops) return "border loops do not hold every border half-edge once";
    std::vector<std::size_t> corners_at(m.n_vertices(), 0);
    for (const auto f : m.faces())
        for (const auto v : m.fv_range(f))
            ++corners_at[std::size_t(v.idx())];
    for (const auto v : m.vertices()) {
        std::size_t around = 0, open = 0;
        for (const auto h : m.voh_range(v)) {
            around += !m.is_boundary(h);
            open += m.is_boundary(h);
            if (around + open > m.n_halfedges()) return "a vertex is circled for ever";
        }
        if (around != corners_at[std::size_t(v.idx())]) return "a vertex does not reach all its faces";
        if (open > 1) return "a vertex with several fans";
        if (open == 1 && !m.is_boundary(v)) return "a border vertex does not know it";
    }
    return {};
}

#define VERIFY_SOUND(mesh, topology)                                                                         \
    do {                                                                                                     \
        const std::string found = fault(mesh, topology);                                                     \
        QVERIFY2(found.empty(), found.c_str());                                                              \
    } while (false)

} // namespace

class TestTopology : public QObject {
    Q_OBJECT
private slots:

    void cube_is_closed() {
        const Mesh cube = cube_mesh();
        const auto t = build_topology(cube, {});
        VERIFY_SOUND(cube, *t);
        QCOMPARE(t->left_out, std::size_t(0));
        QCOMPARE(t->mesh.n_vertices(), std::size_t(8));
        QCOMPARE(t->mesh.n_edges(), std::size_t(18));
        QCOMPARE(t->mesh.n_faces(), std::size_t(12));
        for (const auto h : t->mesh.halfedges())
            QVERIFY(!t->mesh.is_boundary(h));
    }

    void sheet_has_one_border() {
        const Mesh sheet =
            grid_mesh(7, 5, false, false, 0.0, [](double a, double b) { return Vec3(a, b, 0.0); });
        const auto t = build_topology(sheet, {});
        VERIFY_SOUND(sheet, *t);
        QCOMPARE(t->left_out, std::size_t(0));
        std::size_t border = 0;
        HalfedgeMesh::HalfedgeHandle first;
        for (const auto h : t->mesh.halfedges())
            if (t->mesh.is_boundary(h)) {
                ++border;
                first = h;
            }
        QCOMPARE(border, std::size_t(24));
        std::size_t loop = 0;
        auto h = first;
        do {
            h = t->mesh.next_halfedge_handle(h);
            ++loop;
        } while (h != first && loop < 100);
        QCOMPARE(loop, border);
    }

    void any_order_of_facets() {
        // Patches that meet only later are what an incremental construction stumbles over.
        std::mt19937 rng(3);
        Mesh mesh = sphere_mesh(1.0, 3);
        for (int round = 0; round < 20; ++round) {
            std::shuffle(mesh.facets.begin(), mesh.facets.end(), rng);
            const auto t = build_topology(mesh, {});
            VERIFY_SOUND(mesh, *t);
            QCOMPARE(t->left_out, std::size_t(0));
            QCOMPARE(t->vertex_of.size(), mesh.vertices.size());
        }
    }

    void third_facet_on_an_edge_is_left_out() {
        Mesh mesh;
        mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
        mesh.facets = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
        const auto t = build_topology(mesh, {});
        VERIFY_SOUND(mesh, *t);
        QCOMPARE(t->left_out, std::size_t(1));
        QCOMPARE(t->facet_of, (std::vector<Index>{0, 1}));
    }

    void cubes_that_share_a_vertex_get_two() {
        const Mesh mesh = welded(cube_mesh(), cube_mesh(1.0, Vec3::Ones()));
        QCOMPARE(mesh.vertices.size(), std::size_t(15));
        const auto t = build_topology(mesh, {});
        VERIFY_SOUND(mesh, *t);
        QCOMPARE(t->left_out, std::size_t(0));
        QCOMPARE(t->vertex_of.size(), std::size_t(16));
        QCOMPARE(t->vertex_of.back(), Index(7));
    }

    void cubes_that_share_an_edge() {
        const Mesh mesh = welded(cube_mesh(), cube_mesh(1.0, Vec3(1, 1, 0)));
        QCOMPARE(mesh.vertices.size(), std::size_t(14));
        const auto t = build_topology(mesh, {});
        VERIFY_SOUND(mesh, *t);
        // The edge holds one facet each way; the two of the second cube that would run along it again are
        // left out.
        QCOMPARE(t->left_out, std::size_t(2));
        QVERIFY(t->facet_of[11] == 11);
    }

    void facet_wound_against_its_neighbors_is_left_out() {
        Mesh mesh = cube_mesh();
        std::swap(mesh.facets[5][1], mesh.facets[5][2]);
        const auto t = build_topology(mesh, {});
        VERIFY_SOUND(mesh, *t);
        QVERIFY(t->left_out >= 1 && t->left_out <= 3);
        Mesh all_inside_out = cube_mesh();
        for (Facet& f : all_inside_out.facets)
            std::swap(f[1], f[2]);
        QCOMPARE(build_topology(all_inside_out, {})->left_out, std::size_t(0));
    }

    void odd_facets() {
        Mesh mesh = cube_mesh();
        mesh.facets.push_back({0, 0, 1});      // an edge
        mesh.facets.push_back({3, 3, 3});      // a point
        mesh.facets.push_back(mesh.facets[4]); // a duplicate
        mesh.vertices.push_back({9, 9, 9});    // nobody's vertex
        const auto t = build_topology(mesh, {});
        VERIFY_SOUND(mesh, *t);
        QCOMPARE(t->left_out, std::size_t(3));
        QVERIFY(t->mesh.is_isolated(OpenMesh::VertexHandle(8)));

        Mesh pillow; // both sides of a triangle
        pillow.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        pillow.facets = {{0, 1, 2}, {0, 2, 1}};
        const auto p = build_topology(pillow, {});
        VERIFY_SOUND(pillow, *p);
        QCOMPARE(p->left_out, std::size_t(0));

        const auto empty = build_topology(Mesh{}, {});
        QCOMPARE(empty->mesh.n_faces(), std::size_t(0));
    }

    void random_facets_are_in_or_counted() {
        std::mt19937 rng(11);
        for (int round = 0; round < 300; ++round) {
            Mesh mesh;
            const Index vertices = 3 + Index(rng() % 9);
            for (Index v = 0; v < vertices; ++v)
                mesh.vertices.push_back(Vec3(double(rng() % 100), double(rng() % 100), double(rng() % 100)));
            const std::size_t facets = rng() % 30;
            for (std::size_t f = 0; f < facets; ++f)
                mesh.facets.push_back(
                    {Index(rng() % vertices), Index(rng() % vertices), Index(rng() % vertices)});
            const auto t = build_topology(mesh, {});
            VERIFY_SOUND(mesh, *t);
            // Nothing is left out without need: a facet outside runs along a direction that is in use, or is
            // no facet.
            std::set<std::pair<Index, Index>> used;
            for (const Index f : t->facet_of)
                for (std::size_t k = 0; k < 3; ++k)
                    QVERIFY(used.insert({mesh.facets[f][k], mesh.facets[f][(k + 1) % 3]}).second);
            for (Index f = 0; f < mesh.facet_count(); ++f) {
                if (std::binary_search(t->facet_of.begin(), t->facet_of.end(), f)) continue;
                const Facet& g = mesh.facets[f];
                bool needed = g[0] == g[1] || g[1] == g[2] || g[2] == g[0];
                for (std::size_t k = 0; k < 3; ++k)
                    needed = needed || used.contains({g[k], g[(k + 1) % 3]});
                QVERIFY(needed);
            }
        }
    }

    void vertex_of_high_valence_is_linear() {
        // A search round the hub for every facet would take minutes here, so this only ends if there is none.
        Mesh mesh;
        const Index n = 200'000;
        mesh.vertices.push_back(Vec3::Zero());
        for (Index i = 0; i < n; ++i)
            mesh.vertices.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0.0});
        for (Index i = 0; i < n; ++i)
            mesh.facets.push_back({0, 1 + i, 1 + (i + 1) % n});
        const auto t = build_topology(mesh, {});
        QCOMPARE(t->left_out, std::size_t(0));
        QCOMPARE(t->mesh.n_edges(), std::size_t(2 * n));
        QCOMPARE(t->mesh.valence(OpenMesh::VertexHandle(0)), n);
    }

    void cancel_ends_it() {
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(build_topology(cube_mesh(), Progress(job)), Cancelled);
    }
};

FACETMILL_TEST(TestTopology)
#include "test_topology.moc"
