// Maps of passes in rings, over surfaces where they are known: about a tube and a cone they are circles,
// about a thimble too, down to its end; about a blade that tapers and twists each is one ring.
#include "core/strategy/five_axis/ring_map.h"
#include "core/strategy/surface/surface_lines.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr int ring_columns = 60, ring_rows = 40;

/// A tube over a round (s from 0 to 1, anticlockwise) and t from 0 to 1, upward, wound outward.
Mesh tube_of(const std::function<Vec3(double s, double t)>& at) {
    Mesh mesh;
    for (int i = 0; i < ring_columns; ++i)
        for (int k = 0; k <= ring_rows; ++k)
            mesh.vertices.push_back(at(double(i) / ring_columns, double(k) / ring_rows));
    const auto index = [](int i, int k) { return Index(i % ring_columns * (ring_rows + 1) + k); };
    for (int i = 0; i < ring_columns; ++i)
        for (int k = 0; k < ring_rows; ++k) {
            mesh.facets.push_back({index(i, k), index(i + 1, k), index(i + 1, k + 1)});
            mesh.facets.push_back({index(i, k), index(i + 1, k + 1), index(i, k + 1)});
        }
    return mesh;
}

Vec3 round_place(double radius, double s, double z) {
    const double angle = 2 * pi * s;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// Closed at the top by a vertex.
Mesh capped(Mesh mesh, const Vec3& top) {
    const auto end = Index(mesh.vertices.size());
    mesh.vertices.push_back(top);
    for (int i = 0; i < ring_columns; ++i)
        mesh.facets.push_back({Index(i * (ring_rows + 1) + ring_rows),
                               Index((i + 1) % ring_columns * (ring_rows + 1) + ring_rows), end});
    return mesh;
}

constexpr double thimble_radius = 8, thimble_wall = 20;

/// A wall with half a ball on it.
Mesh thimble() {
    const double length = thimble_wall + 0.5 * pi * thimble_radius;
    return capped(tube_of([&](double s, double t) -> Vec3 {
                      const double along = 0.985 * t * length;
                      if (along < thimble_wall) return round_place(thimble_radius, s, along);
                      const double angle = (along - thimble_wall) / thimble_radius;
                      return round_place(thimble_radius * std::cos(angle), s,
                                         thimble_wall + thimble_radius * std::sin(angle));
                  }),
                  Vec3(0, 0, thimble_wall + thimble_radius));
}

Mesh ring_blade() {
    return tube_of([](double s, double t) -> Vec3 {
        const double turn = radians(35 * t), wide = 15 - 7 * t, thick = 3 - 1.5 * t, angle = 2 * pi * s;
        const double x = wide * std::cos(angle), y = thick * std::sin(angle) + 0.01 * x * x;
        return {x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn), 40 * t};
    });
}

DerivedMesh derived(const Mesh& mesh) {
    DerivedMesh made;
    made.mesh = mesh;
    made.kept = mesh.vertices.size();
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        made.facet_of.push_back(Index(f));
    return made;
}

} // namespace

class TestRingMap : public QObject {
    Q_OBJECT
private slots:
    void rings_are_the_known_ones_data() {
        QTest::addColumn<int>("which");
        QTest::newRow("tube") << 0;
        QTest::newRow("cone") << 1;
        QTest::newRow("washer") << 2;
        QTest::newRow("thimble") << 3;
    }
    void rings_are_the_known_ones() {
        QFETCH(int, which);
        const Mesh mesh = which == 3 ? thimble() : tube_of([&](double s, double t) {
            if (which == 0) return round_place(10, s, 30 * t);
            if (which == 1) return round_place(16 - 8 * t, s, 24 * t);
            return round_place(30 - 18 * t, s, 0);
        });
        const auto from_top = [&](const Vec3& p) {
            const double out = std::hypot(p.x(), p.y());
            if (which == 0) return 30 - p.z();
            if (which == 1) return std::hypot(8, 24) * (1 - p.z() / 24);
            if (which == 2) return 30 - out;
            const double up = p.z() - thimble_wall;
            return up > 0 ? thimble_radius * std::atan2(out, up) : thimble_radius * 0.5 * pi - up;
        };
        QVERIFY(goes_round(mesh, Progress()));
        DerivedMesh piece = derived(mesh);
        const PassMap map = ring_map(piece, Progress());
        QCOMPARE(piece.mesh.vertices.size(), map.v.size());
        QCOMPARE(piece.mesh.facet_count(), map.gradients.size());
        // Of a washer either border may be the higher one.
        double most = 0, forth = 0, back = 0, size = 0;
        std::vector<char> used(map.v.size(), 0);
        for (const Facet& facet : piece.mesh.facets)
            for (const Index i : facet)
                used[i] = 1;
        for (std::size_t i = 0; i < map.v.size(); ++i)
            if (used[i]) size = std::max(size, from_top(piece.mesh.vertices[i]));
        for (std::size_t i = 0; i < map.v.size(); ++i) {
            if (!used[i]) continue;
            const double expected = from_top(piece.mesh.vertices[i]);
            forth = std::max(forth, std::abs(map.v[i] - expected));
            back = std::max(back, std::abs(map.v[i] - (size - expected)));
            QVERIFY(map.u[i] >= 0 && map.u[i] < map.period);
        }
        most = which == 2 ? std::min(forth, back) : forth;
        // Facets of a thimble are not alike: no more than a length does v change over nearly all of them.
        QVERIFY2(most <= (which == 3 ? 0.05 : 0.02) * size,
                 qPrintable(QString("%1 of %2").arg(most).arg(size)));
        QVERIFY2(map.flattest_v > 0.9, qPrintable(QString::number(map.flattest_v)));
        QCOMPARE(map.u_hi, 2 * map.period);
        // A round is about as long as the shortest of the rings but for a fiftieth of the surface.
        if (which == 0) QVERIFY(std::abs(map.period - 2 * pi * 10) < 0.02 * map.period);
        if (which == 1)
            QVERIFY2(map.period > 2 * pi * 8 && map.period < 2 * pi * 9.5,
                     qPrintable(QString::number(map.period)));
        // u goes round evenly: by the angle, one way.
        for (const Facet& facet : piece.mesh.facets)
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 &p = piece.mesh.vertices[facet[k]], &q = piece.mesh.vertices[facet[(k + 1) % 3]];
                if (std::hypot(p.x(), p.y()) < 2 || std::hypot(q.x(), q.y()) < 2) continue;
                const double turned =
                    std::remainder(std::atan2(q.y(), q.x()) - std::atan2(p.y(), p.x()), 2 * pi);
                const double grown = std::remainder(map.u[facet[(k + 1) % 3]] - map.u[facet[k]], map.period)
                                     * 2 * pi / map.period;
                // From outside v grows to the right of u: downward, going anticlockwise as seen from above.
                if (which != 2)
                    QVERIFY2(std::abs(grown - turned) < 0.02,
                             qPrintable(QString("%1 %2").arg(grown).arg(turned)));
                if (which == 2) QVERIFY(std::abs(std::abs(grown) - std::abs(turned)) < 0.02);
            }
    }

    void what_does_not_go_round_is_told() {
        const auto sheet = [](const std::function<Vec3(double s, double t)>& at) {
            Mesh mesh = tube_of(at);
            std::erase_if(mesh.facets, [](const Facet& f) {
                const Index column = Index((ring_columns - 1) * (ring_rows + 1));
                return std::max({f[0], f[1], f[2]}) >= column
                       && std::min({f[0], f[1], f[2]}) <= Index(ring_rows);
            });
            return mesh;
        };
        // One border, and not bulging.
        QVERIFY(!goes_round(sheet([](double s, double t) { return Vec3(30 * s, 0, 20 * t); }), Progress()));
        QVERIFY(!goes_round(sheet([](double s, double t) { return round_place(10, 0.7 * s, 20 * t); }),
                            Progress()));
        // A shallow dome does not go round, one that is a ball but for its foot does.
        const auto ball = [](double least) {
            return capped(tube_of([=](double s, double t) {
                              const double up = least + (radians(88) - least) * t;
                              return round_place(10 * std::cos(up), s, 10 * std::sin(up));
                          }),
                          Vec3(0, 0, 10));
        };
        QVERIFY(!goes_round(ball(radians(50)), Progress()));
        QVERIFY(goes_round(ball(radians(-50)), Progress()));
        // Closed all about there is nothing that rings could begin at.
        Mesh closed = ball(radians(-88));
        const auto foot = Index(closed.vertices.size());
        closed.vertices.push_back(Vec3(0, 0, -10));
        for (int i = 0; i < ring_columns; ++i)
            closed.facets.push_back(
                {Index((i + 1) % ring_columns * (ring_rows + 1)), Index(i * (ring_rows + 1)), foot});
        QVERIFY(!goes_round(closed, Progress()));
        // A limb that rings lie along instead of about: nowhere near as close together as on the trunk.
        Mesh limbed = tube_of([](double s, double t) { return round_place(10, s, 60 * t); });
        std::erase_if(limbed.facets, [](const Facet& f) {
            for (const Index i : f)
                if (i / (ring_rows + 1) < 12 || i / (ring_rows + 1) > 24 || i % (ring_rows + 1) < 16
                    || i % (ring_rows + 1) > 22)
                    return false;
            return true;
        });
        std::vector<std::pair<Index, Index>> brink;
        for (Index i = 12; i < 24; ++i)
            brink.emplace_back(i * (ring_rows + 1) + 16, (i + 1) * (ring_rows + 1) + 16);
        for (Index k = 16; k < 22; ++k)
            brink.emplace_back(24 * (ring_rows + 1) + k, 24 * (ring_rows + 1) + k + 1);
        for (Index i = 24; i > 12; --i)
            brink.emplace_back(i * (ring_rows + 1) + 22, (i - 1) * (ring_rows + 1) + 22);
        for (Index k = 22; k > 16; --k)
            brink.emplace_back(12 * (ring_rows + 1) + k, 12 * (ring_rows + 1) + k - 1);
        std::vector<std::vector<Index>> ring(brink.size());
        for (std::size_t i = 0; i < brink.size(); ++i)
            for (int step = 0; step <= 20; ++step) {
                const Vec3 p = limbed.vertices[brink[i].first];
                if (step == 0)
                    ring[i].push_back(brink[i].first);
                else {
                    ring[i].push_back(Index(limbed.vertices.size()));
                    limbed.vertices.push_back(p + 2.0 * step * Vec3(0, 1, 0));
                }
            }
        for (std::size_t i = 0; i < ring.size(); ++i)
            for (std::size_t step = 0; step < 20; ++step) {
                const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
                limbed.facets.push_back({a[step], b[step], b[step + 1]});
                limbed.facets.push_back({a[step], b[step + 1], a[step + 1]});
            }
        QVERIFY(!goes_round(limbed, Progress()));
    }

    /// About a blade that tapers and twists every pass is one line, which goes on over its own beginning, and
    /// none of them has an end.
    void lines_go_round_a_blade() {
        DerivedMesh piece = derived(ring_blade());
        const PassMap map = ring_map(piece, Progress());
        const Mesh& mesh = piece.mesh;
        const auto geometry = compute_geometry(mesh, Progress());
        SurfaceSlice::Options options;
        options.extension = 4;
        options.longest = 0.5;
        options.steepest_u = map.steepest_u;
        options.period = map.period;
        options.overlap = 3;
        options.as_wound = true;
        const SurfaceLines lines(mesh, *geometry, DriveFrame(0), 0.1, options, Progress(), Mat3::Identity(),
                                 &map);
        QVERIFY(lines.hi() > 30);
        for (double v = 0.5; v < lines.hi() - 0.2; v += 1.7) {
            const auto found = lines.lines(v);
            QCOMPARE(found.size(), std::size_t(1));
            const SurfaceLine& line = found.front();
            QVERIFY(line.goes_on[0] && line.goes_on[1]);
            QCOMPARE(line.points.front().u, 0.0);
            const auto round = std::find_if(line.points.begin(), line.points.end(), [&](const SlicePoint& p) {
                return p.u >= map.period * (1 - 1e-12);
            });
            QVERIFY(round != line.points.end());
            QVERIFY((round->point - line.points.front().point).norm() < 1e-9);
            const double after = line.length() - line.arc[std::size_t(round - line.points.begin())];
            QVERIFY2(after >= 3 && after < 6, qPrintable(QString::number(after)));
            for (std::size_t i = 1; i < line.points.size(); ++i)
                QVERIFY(line.points[i].u > line.points[i - 1].u);
            // Where a line lies over its own beginning it is the same.
            const double last = line.points.back().u - map.period;
            const auto again = std::find_if(line.points.begin(), line.points.end(),
                                            [&](const SlicePoint& p) { return p.u >= last - 1e-9; });
            QVERIFY((again->point - line.points.back().point).norm() < 1e-9);

            const auto slice = lines.slice(lines.beyond(v, 0));
            QVERIFY(slice->ends().empty());
            QVERIFY(slice->covers(0, 0.1) && slice->covers(map.period - 0.1, map.period));
            QVERIFY(!slice->covers(map.period + 0.1, map.period + 1));
            // At the cut a line is there before and after.
            const SlicePoint& start = line.points.front();
            std::vector<Vec3> raised;
            QVERIFY(slice->near(start.point, start.normal, 0, 3, 0, raised));
            for (const Vec3& end : {raised.front(), raised.back()})
                QVERIFY2((end - start.point).norm() > 1,
                         qPrintable(QString::number((end - start.point).norm())));
            QVERIFY((raised.front() - raised.back()).norm() > 2);
            // Not at an edge of the blade, where it is round: on one of its faces.
            QVERIFY2(start.normal.dot(line.at(2).normal) > std::cos(radians(15)),
                     qPrintable(QString::number(v)));
        }
    }

    /// A hole in the wall makes lines open; one across the beginning of a round is at both ends of it.
    void a_hole_opens_lines() {
        const Mesh whole = tube_of([](double s, double t) { return round_place(10, s, 30 * t); });
        for (int first = 0; first < ring_columns; first += 7) {
            Mesh mesh = whole;
            std::erase_if(mesh.facets, [&](const Facet& f) {
                for (const Index i : f) {
                    const int column = (int(i) / (ring_rows + 1) - first + ring_columns) % ring_columns,
                              row = int(i) % (ring_rows + 1);
                    if (column > 6 || row < 18 || row > 22) return false;
                }
                return true;
            });
            QVERIFY(mesh.facet_count() == whole.facet_count() - 2 * 6 * 4);
            QVERIFY(goes_round(mesh, Progress()));
            DerivedMesh piece = derived(mesh);
            const PassMap map = ring_map(piece, Progress());
            const auto geometry = compute_geometry(piece.mesh, Progress());
            SurfaceSlice::Options options;
            options.period = map.period;
            options.overlap = 3;
            options.as_wound = true;
            options.steepest_u = map.steepest_u;
            const SurfaceLines lines(piece.mesh, *geometry, DriveFrame(0), 0.1, options, Progress(),
                                     Mat3::Identity(), &map);
            const auto found = lines.lines(15);
            double length = 0;
            std::size_t free_ends = 0;
            for (const SurfaceLine& line : found) {
                QVERIFY(line.points.back().u > line.points.front().u);
                QVERIFY(line.points.front().u >= -1e-9 && line.points.back().u <= map.period + 3 + 1e-9);
                length += line.length();
                free_ends += std::size_t(!line.goes_on[0]) + std::size_t(!line.goes_on[1]);
            }
            // Beyond a round they go on by 3 of u, which changes by a little less than a length.
            const double gap = 2 * pi * 10 * 6 / ring_columns, round = 2 * pi * 10;
            QVERIFY2(length > round - gap - 0.5 && length < round - gap + 4,
                     qPrintable(QString("%1 of %2").arg(length).arg(round - gap)));
            QVERIFY(free_ends >= 2);
        }
    }
};

FACETMILL_TEST(TestRingMap)
#include "test_ring_map.moc"
