// How parts lie, and placements that are moved on.
#include "core/setup/lying.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Vec3 vec(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// A point of the file where a placement puts it, by its description alone.
Vec3 place(const Placement& at, Vec3 p) {
    if (at.mirror != Mirror::none) p[int(at.mirror) - 1] *= -1;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double c = std::cos(at.rotate[std::size_t(axis)]), s = std::sin(at.rotate[std::size_t(axis)]);
        const double pu = c * p[u] - s * p[v];
        p[v] = s * p[u] + c * p[v];
        p[u] = pu;
    }
    return p + vec(at.translate);
}

/// Upright, of radius 10, with 48 sides.
Mesh disc_of(double height) {
    Mesh mesh;
    constexpr Index sides = 48;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(0, 0, height)};
    for (Index k = 0; k < sides; ++k)
        for (const double z : {0.0, height})
            mesh.vertices.emplace_back(10 * std::cos(2 * pi * k / sides), 10 * std::sin(2 * pi * k / sides),
                                       z);
    for (Index k = 0; k < sides; ++k) {
        const Index a = 2 + 2 * k, b = 2 + 2 * ((k + 1) % sides);
        for (const Facet& f :
             {Facet{0, b, a}, Facet{1, a + 1, b + 1}, Facet{a, b, b + 1}, Facet{a, b + 1, a + 1}})
            mesh.facets.push_back(f);
    }
    return mesh;
}

/// The facets of several meshes.
Mesh together(const std::vector<Mesh>& parts) {
    Mesh all;
    for (const Mesh& m : parts) {
        const auto first = Index(all.vertices.size());
        all.vertices.insert(all.vertices.end(), m.vertices.begin(), m.vertices.end());
        for (const Facet& f : m.facets)
            all.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
    }
    return all;
}

Mesh turned_by(Mesh m, const Mat3& turn) {
    for (Vec3& v : m.vertices)
        v = turn * v;
    return m;
}

std::vector<LyingFace> best(const Mesh& mesh) {
    return lying_faces(mesh, LyingOrder::best, Progress());
}

} // namespace

class TestLying : public QObject {
    Q_OBJECT
private slots:
    void a_block_lies_on_six_faces() {
        const auto faces = best(box(Vec3(0, 0, 0), Vec3(60, 30, 10)));
        QCOMPARE(faces.size(), std::size_t(6));
        // Lying well already, it stays.
        QVERIFY((faces[0].down + Vec3::UnitZ()).norm() < 1e-12);
        QVERIFY(std::abs(faces[0].contact_area - 1800) < 1e-9);
        QVERIFY(std::abs(faces[0].support_area - 1800) < 1e-9);
        QVERIFY(std::abs(faces[0].height - 10) < 1e-12);
        QVERIFY(std::abs(faces[0].tips_at - std::atan2(15, 5)) < 1e-12);
        QCOMPARE(faces[0].facing_down, 0.0);
        QVERIFY(std::abs(faces.back().support_area - 300) < 1e-9);
        for (const LyingFace& f : faces) {
            Vec3 turn = Vec3::Zero();
            for (std::size_t i = 0; i < f.outline.size(); ++i)
                turn += f.outline[i].cross(f.outline[(i + 1) % f.outline.size()]);
            QVERIFY(turn.dot(f.down) > 0);
        }
    }

    /// A tray: its open side has the larger outline, its back lies flat and hides nothing from above.
    void a_tray_lies_on_its_back() {
        const Mat3 side = quarter_turn(0, 1);
        const Mesh tray =
            turned_by(together({box(Vec3(0, 0, 0), Vec3(50, 40, 2)), box(Vec3(0, 0, 2), Vec3(2, 40, 20)),
                                box(Vec3(48, 0, 2), Vec3(50, 40, 20)), box(Vec3(2, 0, 2), Vec3(48, 2, 20)),
                                box(Vec3(2, 38, 2), Vec3(48, 40, 20))}),
                      side);
        for (const LyingOrder order : {LyingOrder::best, LyingOrder::largest}) {
            const LyingFace first = lying_faces(tray, order, Progress()).front();
            QVERIFY((first.down - side * -Vec3::UnitZ()).norm() < 1e-9);
            const Box3 lying = turned_box(tray, turn_to_lie(first.down));
            QVERIFY(std::abs(lying.size().z() - 20) < 1e-9);
        }
    }

    /// A sheet has no inside: it lies as its outside faces up.
    void open_and_dirty_meshes() {
        Mesh sheet = height_field([](double x, double y) { return 0.02 * (x * x + y * y); }, Vec2(-20, -15),
                                  Vec2(20, 15), 12, 9);
        QVERIFY(best(sheet).front().down.z() < -0.99);
        sheet = turned_by(sheet, quarter_turn(1, 1));
        QVERIFY(best(sheet).front().down.x() < -0.99);
        // Needles, doubled facets, a vertex that nothing uses.
        Mesh dirty = box(Vec3(0, 0, 0), Vec3(60, 30, 10));
        dirty.facets.push_back(dirty.facets.front());
        dirty.vertices.emplace_back(30, 15, 10);
        dirty.vertices.emplace_back(31, 15, 10 + 1e-13);
        dirty.vertices.emplace_back(900, 900, 900);
        dirty.facets.push_back({8, 9, 8});
        dirty.facets.push_back({0, 9, 8});
        const auto faces = best(dirty);
        QVERIFY(std::abs(faces.front().height - 10) < 1e-9);
        QVERIFY((turned_box(dirty, Mat3::Identity()).size() - Vec3(60, 30, 10)).norm() < 1e-9);
    }

    void meshes_that_are_no_body() {
        Mesh two;
        two.vertices = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0), Vec3(10, 10, 0)};
        two.facets = {{0, 1, 2}, {1, 3, 2}};
        auto faces = best(two);
        QCOMPARE(faces.size(), std::size_t(2));
        QVERIFY(std::abs(faces[0].contact_area - 100) < 1e-9);
        QCOMPARE(faces[0].down, Vec3(-Vec3::UnitZ()));
        two.vertices[3].z() = 10; // hinged
        QVERIFY(!best(two).empty());
        Mesh needle;
        needle.vertices = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(20, 0, 1e-12)};
        needle.facets = {{0, 1, 2}};
        QCOMPARE(code_of([&] { best(needle); }), std::string("empty_result"));
    }

    /// Mass decides: a narrow foot carries no leaning tower, and the faces told are those it stays on.
    void what_falls_is_left_out() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> u(-1, 1);
        for (int trial = 0; trial < 20; ++trial) {
            Mesh m = dome(20, 6);
            const Mat3 turn = Eigen::Quaterniond(u(random), u(random), u(random), u(random))
                                  .normalized()
                                  .toRotationMatrix();
            m = turned_by(m, turn);
            const auto faces = best(m);
            QVERIFY((faces.front().down + turn * Vec3::UnitZ()).norm() < 1e-6);
            for (const LyingFace& f : faces)
                QVERIFY(f.tips_at > 0);
            const Box3 box = turned_box(m, turn_to_lie(faces.front().down));
            QVERIFY(std::abs(box.size().z() - 20) < 1e-6);
        }
        // A slanted pillar: on its foot it would fall.
        Mesh pillar = box(Vec3(0, 0, 0), Vec3(10, 10, 40));
        for (Vec3& v : pillar.vertices)
            v.x() += v.z();
        for (const LyingFace& f : best(pillar))
            QVERIFY(std::abs(f.down.z()) < 0.99);
    }

    void placements_move_on() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> u(-3, 3);
        for (int trial = 0; trial < 200; ++trial) {
            Placement from;
            from.mirror = Mirror(trial % 4);
            for (std::size_t k = 0; k < 3; ++k) {
                from.rotate[k] = trial % 3 == 0 ? 0.5 * pi * std::round(u(random)) : u(random);
                from.translate[k] = 40 * u(random);
            }
            const Vec3 p(u(random), u(random), u(random)), about(9 * u(random), 3, u(random));
            const Mat3 turn = trial % 2 ? quarter_turn(trial % 3, trial % 4)
                                        : turn_to_lie(Vec3(u(random), u(random), u(random)).normalized());
            const Vec3 was = place(from, p);
            QVERIFY((place(turned(from, turn, about), p) - (turn * (was - about) + about)).norm() < 1e-8);
            QVERIFY((place(moved(from, about), p) - (was + about)).norm() < 1e-8);
            const int axis = trial % 3;
            Vec3 image = was;
            image[axis] = 2 * about.y() - image[axis];
            QVERIFY((place(mirrored(from, axis, about.y()), p) - image).norm() < 1e-8);
            QVERIFY((rotation_of(angles_of(turn)) - turn).norm() < 1e-9);
        }
        const Placement quarter = turned({}, quarter_turn(0, 1), Vec3::Zero());
        QCOMPARE(degrees(quarter.rotate[0]), 90.0);
        QCOMPARE(quarter.rotate[1], 0.0);
    }

    void laying_keeps_the_middle_and_drops() {
        const Mesh block = box(Vec3(100, 50, -7), Vec3(160, 80, 3));
        const Placement at = laid({}, block, quarter_turn(1, 1));
        Box3 now;
        for (const Vec3& v : block.vertices)
            now.add(place(at, v));
        QVERIFY(std::abs(now.lo.z()) < 1e-8);
        QVERIFY((now.center().head<2>() - block.box().center().head<2>()).norm() < 1e-8);
        QVERIFY((now.size() - Vec3(10, 30, 60)).norm() < 1e-8);
    }

    void laying_leaves_whole_degrees() {
        const Mesh block = box(Vec3(0, 0, 0), Vec3(60, 40, 20));
        // As the normal of a facet comes out of a file of single precision.
        const Vec3 crooked = Vec3(3e-8, 1, -5e-8).normalized();
        const Placement at = laid({}, block, turn_to_lie(crooked));
        for (const double angle : at.rotate)
            QCOMPARE(degrees(angle), std::round(degrees(angle)));
        double lowest = 1e9;
        for (const Vec3& v : block.vertices)
            lowest = std::min(lowest, place(at, v).z());
        QVERIFY(std::abs(lowest) < 1e-8);
        // What is crooked by more stays so.
        const Placement tilted = laid({}, block, turn_to_lie(Vec3(1e-3, 1, 0).normalized()));
        bool whole = true;
        for (const double angle : tilted.rotate)
            whole = whole && degrees(angle) == std::round(degrees(angle));
        QVERIFY(!whole);
    }

    /// The axes of what has been turned at random come back, by the smallest turn of the four that bring
    /// them.
    void principal_axes_come_back() {
        std::mt19937 random(7);
        std::normal_distribution<double> gauss;
        const Mesh block = box(Vec3(-30, -10, -4), Vec3(30, 10, 4));
        for (int k = 0; k < 200; ++k) {
            const Mat3 crooked =
                Eigen::Quaterniond(gauss(random), gauss(random), gauss(random), gauss(random))
                    .normalized()
                    .toRotationMatrix();
            Mesh turned = block;
            for (Vec3& v : turned.vertices)
                v = crooked * v + Vec3(100, -7, 55);
            const Mat3 turn = turn_to_principal(turned);
            QVERIFY((turned_box(turned, turn).size() - Vec3(60, 20, 8)).norm() < 1e-9);
            QVERIFY(std::abs(turn.determinant() - 1) < 1e-9);
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY(turn.trace() >= (quarter_turn(axis, 2) * turn).trace() - 1e-9);
        }
        // An L, whose axes are no sides of it: against the covariance of places drawn from its surface.
        const Mesh l = together({box(Vec3(0, 0, 0), Vec3(40, 8, 5)), box(Vec3(0, 8, 0), Vec3(8, 25, 5))});
        std::vector<double> area;
        for (std::size_t f = 0; f < l.facet_count(); ++f)
            area.push_back(l.facet_cross(f).norm());
        std::discrete_distribution<std::size_t> facet(area.begin(), area.end());
        std::uniform_real_distribution<double> share(0, 1);
        Vec3 sum = Vec3::Zero();
        Mat3 squares = Mat3::Zero();
        constexpr int places = 400'000;
        for (int k = 0; k < places; ++k) {
            const std::size_t f = facet(random);
            double a = share(random), b = share(random);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            const Vec3 p = l.corner(f, 0) + a * (l.corner(f, 1) - l.corner(f, 0))
                           + b * (l.corner(f, 2) - l.corner(f, 0));
            sum += p;
            squares += p * p.transpose();
        }
        const Mat3 covariance = squares / places - sum / places * (sum / places).transpose();
        const Mat3 turn = turn_to_principal(l), along = turn * covariance * turn.transpose();
        QVERIFY(along(0, 0) > along(1, 1) && along(1, 1) > along(2, 2));
        for (const auto& [i, k] : {std::pair{0, 1}, {0, 2}, {1, 2}})
            QVERIFY(std::abs(along(i, k)) < 0.01 * along(0, 0));
    }

    /// What is round has one axis, which alone is brought along; a cube has none.
    void round_parts_have_one_principal_axis() {
        const Mat3 crooked =
            Eigen::AngleAxisd(radians(20), Vec3(0.3, 1, 0.2).normalized()).toRotationMatrix();
        for (const double height : {100.0, 4.0}) {
            Mesh round = disc_of(height);
            for (Vec3& v : round.vertices)
                v = crooked * v;
            const Mat3 turn = turn_to_principal(round);
            const Vec3 axis = turn * crooked * Vec3::UnitZ();
            QVERIFY(std::abs(std::abs(axis[height > 50 ? 0 : 2]) - 1) < 1e-6);
            if (height < 50) QVERIFY(std::acos((turn.trace() - 1) / 2) < radians(20) + 1e-6);
        }
        QCOMPARE(code_of([] { turn_to_principal(box(Vec3(0, 0, 0), Vec3(5, 5, 5))); }),
                 std::string("out_of_range"));
        QCOMPARE(code_of([] { turn_to_principal(Mesh()); }), std::string("out_of_range"));
    }

    void edges_points_and_squares() {
        for (const double degree : {10.0, 80.0, 100.0, 190.0, 350.0}) {
            const Vec3 edge(std::cos(radians(degree)), std::sin(radians(degree)), 0.3);
            const Mat3 turn = turn_along_x(edge);
            QVERIFY(std::abs((turn * edge).y()) < 1e-12);
            QVERIFY(turn(0, 0) > -1e-12); // no more than a quarter
            const Mesh crooked = turned(box(Vec3(-30, -10, 0), Vec3(30, 10, 5)), radians(degree));
            const Box3 square = turned_box(crooked, turn_to_square(crooked));
            QVERIFY((square.size() - Vec3(60, 20, 5)).norm() < 1e-9);
        }
        QCOMPARE(code_of([] { turn_along_x(Vec3(0.001, 0, 1)); }), std::string("out_of_range"));
        const Vec3 a(0, 0, 1), b(5, 0, 1), c(0, 5, 1);
        QCOMPARE(down_through(a, b, c, Vec3(0, 0, 0)), Vec3(Vec3::UnitZ()));
        QCOMPARE(down_through(a, c, b, Vec3(0, 0, 9)), Vec3(-Vec3::UnitZ()));
        QCOMPARE(code_of([&] { down_through(a, b, a, Vec3::Zero()); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { down_through(a, b, c, Vec3(1, 1, 1)); }), std::string("out_of_range"));
        QCOMPARE(turn_to_lie(-Vec3::UnitZ()), Mat3(Mat3::Identity()));
        QCOMPARE(turn_to_lie(Vec3::UnitZ()), quarter_turn(0, 2));
    }
};

FACETMILL_TEST(TestLying)
#include "test_lying.moc"
