// Maps of passes that flow from edge to edge, over surfaces where they are known: between two parallels of a
// ball they are parallels, between two circles circles, over a pipe its straight lines.
#include "core/strategy/five_axis/flow_map.h"
#include "core/strategy/surface/slice.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr int columns = 48, rows = 32;

/// A sheet over s and t from 0 to 1; s along the passes.
Mesh sheet_of(const std::function<Vec3(double s, double t)>& at) {
    Mesh mesh;
    for (int i = 0; i <= columns; ++i)
        for (int k = 0; k <= rows; ++k)
            mesh.vertices.push_back(at(double(i) / columns, double(k) / rows));
    const auto index = [](int i, int k) { return Index(i * (rows + 1) + k); };
    for (int i = 0; i < columns; ++i)
        for (int k = 0; k < rows; ++k) {
            mesh.facets.push_back({index(i, k), index(i + 1, k), index(i + 1, k + 1)});
            mesh.facets.push_back({index(i, k), index(i + 1, k + 1), index(i, k + 1)});
        }
    return mesh;
}

Vec3 ring_sector(double s, double t) {
    const double radius = 20 + 30 * t, angle = radians(130 - 80 * s);
    return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

Vec3 twisted(double s, double t) {
    const double half = 16 - 9 * s, turn = radians(40 * s - 10), y = (2 * t - 1) * half;
    return {60 * s, y * std::cos(turn) + 6 * std::sin(1.2 * s), y * std::sin(turn) - 0.012 * y * y};
}

double largest_error(const Mesh& mesh, const std::vector<double>& value,
                     const std::function<double(const Vec3&)>& expected) {
    double most = 0;
    for (std::size_t i = 0; i < value.size(); ++i)
        most = std::max(most, std::abs(value[i] - expected(mesh.vertices[i])));
    return most;
}

} // namespace

class TestFlowMap : public QObject {
    Q_OBJECT
private slots:
    void passes_are_the_known_ones_data() {
        QTest::addColumn<int>("which");
        QTest::newRow("level") << 0;
        QTest::newRow("pipe") << 1;
        QTest::newRow("between circles") << 2;
        QTest::newRow("between parallels") << 3;
    }
    void passes_are_the_known_ones() {
        QFETCH(int, which);
        constexpr double radius = 25;
        const double half = radians(55);
        const auto at = [&](double s, double t) -> Vec3 {
            const double across = half * (2 * t - 1), along = half * (2 * s - 1);
            if (which == 0) return {40 * s, 30 * t, 0.1 * 30 * t};
            if (which == 1) return {40 * s, radius * std::sin(across), radius * std::cos(across)};
            if (which == 2) return ring_sector(s, t);
            return {radius * std::sin(along) * std::cos(across), radius * std::sin(across),
                    radius * std::cos(along) * std::cos(across)};
        };
        const auto expected = [&](const Vec3& p) {
            if (which == 0) return p.y() * std::hypot(1.0, 0.1);
            if (which == 1) return radius * (std::atan2(p.y(), p.z()) + half);
            if (which == 2) return p.norm() - 20;
            return radius * (std::asin(p.y() / radius) + half);
        };
        const Mesh mesh = sheet_of(at);
        const PassMap map = flow_map(mesh, DriveFrame(0), 5, Progress());
        const double size = expected(at(0.5, 1)), error = largest_error(mesh, map.v, expected);
        QVERIFY2(error <= 0.02 * size, qPrintable(QString("%1 of %2").arg(error).arg(size)));
        QVERIFY2(map.flattest_v > 0.9, qPrintable(QString::number(map.flattest_v)));
        for (const double u : map.u)
            QVERIFY(u >= 0 && u <= map.u_hi);
        for (std::size_t f = 0; f < mesh.facet_count(); ++f)
            for (int k = 1; k < 3; ++k) {
                const Vec3 edge = mesh.corner(f, k) - mesh.corner(f, 0);
                const double grown = map.v[mesh.facets[f][std::size_t(k)]] - map.v[mesh.facets[f][0]];
                QVERIFY(std::abs(map.gradients[f].dot(edge) - grown) < 1e-9 * size);
            }
        const double along = largest_error(mesh, map.u, [](const Vec3& p) { return p.x(); });
        if (which < 2) QVERIFY2(along < 0.2, qPrintable(QString::number(along)));
        // The other way the winding says nothing.
        Mesh turned = mesh;
        for (Facet& facet : turned.facets)
            std::swap(facet[1], facet[2]);
        const PassMap again = flow_map(turned, DriveFrame(0), 5, Progress());
        for (std::size_t i = 0; i < map.v.size(); ++i)
            QVERIFY(std::abs(again.v[i] - map.v[i]) < 1e-6 * size);
    }

    /// Over a blade that tapers and twists every pass is one line, from one end to the other, and the
    /// outermost run along its edges. Neither value changes faster than a length.
    void a_blade_has_passes_from_end_to_end() {
        const Mesh mesh = sheet_of(twisted);
        const PassMap map = flow_map(mesh, DriveFrame(0), 5, Progress());
        const auto geometry = compute_geometry(mesh, Progress());
        const MeshSlicer slicer(mesh, *geometry, DriveFrame(0), Progress(), &map);
        QVERIFY(slicer.lo() == 0 && slicer.hi() > 13);
        std::size_t steep = 0;
        for (const Vec3& gradient : map.gradients)
            steep += gradient.norm() > 1 + 1e-9;
        QVERIFY2(double(steep) <= 0.05 * double(map.gradients.size()), qPrintable(QString::number(steep)));
        for (int k = 1; k < 20; ++k) {
            const auto chains = slicer.slice(slicer.hi() * k / 20);
            QCOMPARE(chains.size(), std::size_t(1));
            QVERIFY(!chains[0].closed);
            const auto& points = chains[0].points;
            QVERIFY(points.front().u < 1e-6 && points.back().u > map.u_hi * (1 - 1e-6));
            QVERIFY(points.front().point.x() < 1e-6 && points.back().point.x() > 60 - 1e-6);
            for (std::size_t i = 1; i < points.size(); ++i)
                QVERIFY(points[i].u > points[i - 1].u);
        }
        const auto first = slicer.slice(0.002 * slicer.hi());
        for (const SlicePoint& p : first.at(0).points)
            QVERIFY((p.point - twisted(p.point.x() / 60, 0)).norm() < 0.2);
    }

    void pieces_stand_apart_and_what_has_no_border_goes_by_planes() {
        Mesh mesh = sheet_of(ring_sector);
        const std::size_t own = mesh.vertices.size();
        for (std::size_t i = 0; i < own; ++i)
            mesh.vertices.push_back(mesh.vertices[i] + Vec3(0, 200, 0));
        for (std::size_t f = 0; f < std::size_t(2 * columns * rows); ++f) {
            Facet facet = mesh.facets[f];
            for (Index& i : facet)
                i += Index(own);
            mesh.facets.push_back(facet);
        }
        const PassMap map = flow_map(mesh, DriveFrame(0), 7, Progress());
        double first_hi = 0, second_lo = infinity;
        for (std::size_t i = 0; i < own; ++i) {
            first_hi = std::max(first_hi, map.v[i]);
            second_lo = std::min(second_lo, map.v[own + i]);
        }
        QVERIFY(std::abs(second_lo - first_hi - 7) < 1e-9);
        Mesh closed;
        closed.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
        closed.facets = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
        const PassMap planes = flow_map(closed, DriveFrame(0), 7, Progress());
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(std::abs(planes.v[i] - closed.vertices[i].y()) < 1e-12
                    && std::abs(planes.u[i] - closed.vertices[i].x()) < 1e-12);
    }
};

FACETMILL_TEST(TestFlowMap)

#include "test_flow_map.moc"
