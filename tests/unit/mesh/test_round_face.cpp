// Holes and bosses found from a facet: tubes of known sizes in any pose, made rough, opened and bent.
#include "core/mesh/round_face.h"
#include "core/mesh/sample.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A tube about Z from 0 to `height`: a hole of radius `inner` in a boss of radius `outer`. `part` of a full
/// circle; walls in `rows`; the outer one bulges out by `bulge` in the middle.
struct Tube {
    double inner = 4, outer = 10, height = 12, part = 1, bulge = 0;
    Index sides = 48, rows = 6;

    Mesh mesh() const {
        Mesh m;
        const Index ring = part < 1 ? sides + 1 : sides;
        const auto at = [&](int wall, Index row, Index k) {
            return Index(wall) * (rows + 1) * ring + row * ring + k % ring;
        };
        for (const int wall : {0, 1})
            for (Index row = 0; row <= rows; ++row)
                for (Index k = 0; k < ring; ++k) {
                    const double z = height * row / rows, angle = 2 * pi * part * k / sides;
                    const double share = 2.0 * row / rows - 1;
                    const double r = wall == 0 ? inner : outer + bulge * (1 - share * share);
                    m.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
                }
        const auto quad = [&](Index a, Index b, Index c, Index d) {
            m.facets.push_back({a, b, c});
            m.facets.push_back({a, c, d});
        };
        for (Index k = 0; k < sides; ++k) {
            for (Index row = 0; row < rows; ++row) {
                quad(at(1, row, k), at(1, row, k + 1), at(1, row + 1, k + 1), at(1, row + 1, k));
                quad(at(0, row, k + 1), at(0, row, k), at(0, row + 1, k), at(0, row + 1, k + 1));
            }
            quad(at(0, rows, k), at(1, rows, k), at(1, rows, k + 1), at(0, rows, k + 1));
            quad(at(1, 0, k), at(0, 0, k), at(0, 0, k + 1), at(1, 0, k + 1));
        }
        return m;
    }
};

Mat3 random_turn(std::mt19937& random) {
    std::normal_distribution<double> gauss;
    return Eigen::Quaterniond(gauss(random), gauss(random), gauss(random), gauss(random))
        .normalized()
        .toRotationMatrix();
}

enum class Side { inner, outer, top, bottom };
/// A facet of a tube that stands about Z.
Index facet_on(const Mesh& tube, const Tube& t, Side side, std::size_t which) {
    std::vector<Index> all;
    for (Index f = 0; f < tube.facet_count(); ++f) {
        const Vec3 n = tube.facet_normal(f), p = tube.corner(f, 0);
        const bool flat = std::abs(n.z()) > 0.9;
        const double r = p.head<2>().norm(), between = 0.5 * (t.inner + t.outer);
        if (side == Side::top      ? flat && n.z() > 0
            : side == Side::bottom ? flat && n.z() < 0
                                   : !flat && (side == Side::inner) == (r < between))
            all.push_back(f);
    }
    return all[which % all.size()];
}

} // namespace

class TestRoundFace : public QObject {
    Q_OBJECT
private slots:
    /// Any wall facet of any tube, wherever it stands; the end that is told is the upper one.
    void walls_are_found_anywhere() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> size(0.2, 30);
        for (int k = 0; k < 120; ++k) {
            Tube tube;
            tube.inner = size(random);
            tube.outer = tube.inner * (1.2 + size(random) / 10);
            tube.height = size(random);
            tube.sides = std::array<Index, 4>{8, 24, 48, 150}[std::size_t(k) % 4];
            tube.rows = std::array<Index, 3>{1, 5, 12}[std::size_t(k) % 3];
            Mesh mesh = tube.mesh();
            const bool inner = k % 2 == 0;
            const Index f = facet_on(mesh, tube, inner ? Side::inner : Side::outer, random());
            const Mat3 turn = k % 5 == 0 ? Mat3(Mat3::Identity()) : random_turn(random);
            const Vec3 move(100, -50, 20);
            for (Vec3& v : mesh.vertices)
                v = turn * v + move;
            const RoundFace face = round_face(mesh, f, mesh.corner(f, 0), {});
            QCOMPARE(face.hole, inner);
            const double radius = inner ? tube.inner : tube.outer;
            QVERIFY2(std::abs(face.radius - radius) < 1e-6 * radius,
                     qPrintable(QString("%1 for %2, case %3").arg(face.radius).arg(radius).arg(k)));
            QVERIFY(face.uneven < 1e-6 * radius);
            QVERIFY(std::abs(face.around - 2 * pi) < 1e-9);
            QVERIFY(std::abs(face.depth - tube.height) < 1e-6 * (tube.height + radius));
            const Vec3 axis = turn * Vec3::UnitZ(), ends[2] = {move, turn * Vec3(0, 0, tube.height) + move};
            const Vec3& upper = ends[0].z() > ends[1].z() ? ends[0] : ends[1];
            QVERIFY2((face.center - upper).norm() < 1e-5 * (radius + tube.height),
                     qPrintable(QString::number((face.center - upper).norm())));
            QVERIFY(std::abs(std::abs(face.axis.dot(axis)) - 1) < 1e-9 && face.axis.z() > 0);
            QCOMPARE(face.facets.size(), std::size_t(2 * tube.sides * tube.rows));
        }
    }

    /// On the flat face beside a hole: of its two rims the one that is nearer.
    void rims_are_found_by_the_nearer_one() {
        const Tube tube;
        const Mesh mesh = tube.mesh();
        for (const Side side : {Side::top, Side::bottom}) {
            const Index f = facet_on(mesh, tube, side, 5);
            const double z = side == Side::top ? tube.height : 0;
            for (const bool inner : {true, false}) {
                const Vec3 near((inner ? 4.5 : 9.5) * std::cos(1), (inner ? 4.5 : 9.5) * std::sin(1), z);
                const RoundFace face = round_face(mesh, f, near, {});
                QCOMPARE(face.hole, inner);
                QVERIFY(std::abs(face.radius - (inner ? 4 : 10)) < 1e-9);
                QVERIFY((face.center - Vec3(0, 0, z)).norm() < 1e-9);
                QVERIFY(face.depth == 0 && face.axis.z() * (z > 0 ? 1 : -1) > 0.999);
            }
        }
    }

    /// Lying, the end nearer to the click is told.
    void a_level_axis_has_the_nearer_end() {
        const Tube tube;
        Mesh mesh = tube.mesh();
        const Index f = facet_on(mesh, tube, Side::inner, 9);
        for (Vec3& v : mesh.vertices)
            v = Vec3(v.z(), v.x(), v.y());
        for (const double near : {1.0, 11.0}) {
            const RoundFace face = round_face(mesh, f, Vec3(near, 4, 0), {});
            QVERIFY((face.center - Vec3(near < 6 ? 0 : 12, 0, 0)).norm() < 1e-8);
            QVERIFY(face.axis.x() * (near < 6 ? -1 : 1) > 0.999);
        }
    }

    /// As a scan has it: corners off by a hundredth of the radius at random.
    void rough_walls_have_their_axis() {
        std::mt19937 random(11);
        std::normal_distribution<double> noise(0, 0.02);
        for (int k = 0; k < 20; ++k) {
            Tube tube;
            tube.sides = 60;
            tube.rows = 14;
            Mesh mesh = tube.mesh();
            const Index f = facet_on(mesh, tube, Side::outer, random());
            for (Vec3& v : mesh.vertices)
                v += Vec3(noise(random), noise(random), noise(random));
            const RoundFace face = round_face(mesh, f, mesh.corner(f, 0), {});
            QVERIFY(!face.hole);
            QVERIFY2(std::abs(face.radius - 10) < 0.01, qPrintable(QString::number(face.radius)));
            QVERIFY(face.center.head<2>().norm() < 0.02);
            QVERIFY(face.axis.z() > 0.99999 && face.uneven > 0.02 && face.uneven < 0.15);
        }
    }

    void parts_of_a_circle() {
        for (const auto& [part, found] : {std::pair{0.5, true}, {0.4, true}, {0.25, false}}) {
            Tube tube;
            tube.part = part;
            const Mesh mesh = tube.mesh();
            const Index f = facet_on(mesh, tube, Side::inner, 40);
            if (!found) {
                QCOMPARE(code_of([&] { round_face(mesh, f, mesh.corner(f, 0), {}); }),
                         std::string("out_of_range"));
                continue;
            }
            const RoundFace face = round_face(mesh, f, mesh.corner(f, 0), {});
            QVERIFY(std::abs(face.radius - 4) < 1e-6 && std::abs(face.around - 2 * pi * part) < 1e-6);
        }
    }

    /// What is no wall is refused: a square hole, a ball, a bulging drum, a block.
    void others_are_refused() {
        const auto refused = [](const Mesh& mesh, Index f) {
            return code_of([&] { round_face(mesh, f, mesh.corner(f, 0), {}); }) == "out_of_range";
        };
        Tube square;
        square.sides = 4;
        const Mesh four = square.mesh();
        QVERIFY(refused(four, facet_on(four, square, Side::inner, 3)));
        Tube drum;
        drum.rows = 24;
        drum.bulge = 2;
        const Mesh bent = drum.mesh();
        for (const std::size_t which : {100U, 700U, 1500U})
            QVERIFY(refused(bent, facet_on(bent, drum, Side::outer, which)));
        const Mesh block = box(Vec3(0, 0, 0), Vec3(5, 7, 9));
        for (Index f = 0; f < 12; ++f)
            QVERIFY(refused(block, f));
        Mesh ball;
        constexpr Index n = 40;
        for (Index i = 0; i <= n; ++i)
            for (Index k = 0; k < 2 * n; ++k) {
                const double a = pi * i / n, b = pi * k / n;
                ball.vertices.emplace_back(7 * std::sin(a) * std::cos(b), 7 * std::sin(a) * std::sin(b),
                                           7 * std::cos(a));
            }
        for (Index i = 0; i < n; ++i)
            for (Index k = 0; k < 2 * n; ++k) {
                const Index a = i * 2 * n + k, b = i * 2 * n + (k + 1) % (2 * n);
                ball.facets.push_back({a, a + 2 * n, b + 2 * n});
                ball.facets.push_back({a, b + 2 * n, b});
            }
        for (const Index f : {n * 2 * n, n * n / 2 * 2, 3 * n * n})
            QVERIFY(refused(ball, f));
    }
};

FACETMILL_TEST(TestRoundFace)
#include "test_round_face.moc"
