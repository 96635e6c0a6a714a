// The coarse ground and the tips over it against closed forms and the exact lift.
#include "core/strategy/preview/coarse_tips.h"

#include "core/gouge/axial_lift.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

std::shared_ptr<const CoarseGround> ground_of(const Mesh& mesh, int cells = 100,
                                              const Mat3& turn = Mat3::Identity()) {
    return std::make_shared<const CoarseGround>(mesh, mesh.facet_count(), turn, cells, Progress());
}

Mesh waves(int n) {
    return height_field([](double x, double y) { return 2 * std::sin(0.4 * x) * std::cos(0.3 * y); },
                        Vec2(-15, -12), Vec2(15, 12), n, n);
}

} // namespace

class TestCoarseGround : public QObject {
    Q_OBJECT
private slots:
    void heights_are_those_of_the_facets_over_the_middles_of_cells() {
        // Few large facets, and many in every cell.
        for (const int n : {6, 400}) {
            const Mesh mesh = waves(n);
            const auto ground = ground_of(mesh);
            const ContactIndexPtr index =
                std::make_shared<ContactIndex>(std::make_shared<Mesh>(mesh), Progress());
            const AxialLift needle(index, CutterProfile(AptCutter::flat(1e-4, 50)));
            for (std::size_t i = 0; i < ground->grid().size(); i += 7) {
                const Vec2 p = ground->grid().middle(i);
                QVERIFY2(std::abs(double(ground->height()[i]) - needle.tip_z(p.x(), p.y())) < 1e-3,
                         qPrintable(QString("n %1 cell %2: %3 %4")
                                        .arg(n)
                                        .arg(i)
                                        .arg(double(ground->height()[i]))
                                        .arg(needle.tip_z(p.x(), p.y()))));
            }
        }
    }

    void walls_have_no_height_of_their_own_and_are_known_by_what_lies_lowest() {
        const Mesh block = box(Vec3(0, 0, -5), Vec3(20, 10, 3));
        const auto ground = ground_of(block, 40);
        QCOMPARE(ground->grid().columns, 40);
        QCOMPARE(ground->grid().rows, 20);
        for (std::size_t i = 0; i < ground->grid().size(); ++i) {
            QCOMPARE(ground->height()[i], 3.0f);
            QVERIFY(ground->on_part(i));
        }
        QCOMPARE(ground->lowest()[0], -5.0f);
        QCOMPARE(ground->bottom(), -5.0);
    }

    void a_part_that_is_turned_is_seen_along_the_axis() {
        // A block lying on its side: x becomes z.
        Mat3 turn;
        turn << 0, 0, -1, 0, 1, 0, 1, 0, 0;
        const auto ground = ground_of(box(Vec3(0, 0, -5), Vec3(20, 10, 3)), 40, turn);
        QCOMPARE(ground->top(), 20.0);
        QCOMPARE(ground->height()[0], 20.0f);
        QCOMPARE(ground->grid().rows, 40);
    }

    void a_part_without_extent_is_refused() {
        Mesh wall;
        wall.vertices = {Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, 2)};
        wall.facets = {{0, 1, 2}};
        QCOMPARE(code_of([&] { ground_of(wall); }), std::string(code_name(ErrorCode::empty_result)));
    }

    void fixtures_are_told_from_the_part() {
        Mesh both = box(Vec3(0, 0, 0), Vec3(20, 20, 2));
        const std::size_t own = both.facet_count();
        append_mesh(both, box(Vec3(0, 0, 2), Vec3(5, 20, 6)));
        const CoarseGround ground(both, own, Mat3::Identity(), 20, Progress());
        QVERIFY(!ground.on_part(ground.grid().index(2, 10)));
        QVERIFY(ground.on_part(ground.grid().index(10, 10)));
        QCOMPARE(ground.top(), 2.0);
        const auto shared = std::make_shared<const CoarseGround>(ground);
        const CoarseTips tips(shared, CutterProfile(AptCutter::ball(2, 20)), 0, Progress());
        const auto on = [&](double x, double y) {
            return tips.on_surface(tips.grid().index(tips.grid().column(x), tips.grid().row(y)));
        };
        QVERIFY(!on(2.5, 10));
        QVERIFY(on(12.5, 10));
    }

    void tips_are_the_exact_ones_within_a_cell_data() {
        QTest::addColumn<int>("tool");
        for (std::size_t k = 0; k < tools_of_every_shape().size(); ++k)
            QTest::addRow("%s", tools_of_every_shape()[k].name) << int(k);
    }
    /// Somewhere within a cell of the place, a little more for what a cell rises.
    void tips_are_the_exact_ones_within_a_cell() {
        QFETCH(int, tool);
        const CutterProfile cutter(tools_of_every_shape()[std::size_t(tool)].tool.cutter());
        for (const Mesh& mesh : {waves(60), step(-4, 3)}) {
            const auto ground = ground_of(mesh, 160);
            const CoarseTips tips(ground, cutter, 0.3, Progress());
            const ContactIndexPtr index =
                std::make_shared<ContactIndex>(std::make_shared<Mesh>(mesh), Progress());
            const AxialLift exact(index, cutter, 0.3);
            std::size_t seen = 0;
            for (std::size_t i = 0; i < tips.grid().size(); i += 13) {
                if (!tips.on_surface(i)) continue;
                ++seen;
                const Vec2 p = tips.grid().middle(i);
                double low = infinity, high = -infinity;
                for (int dy = -2; dy <= 2; ++dy)
                    for (int dx = -2; dx <= 2; ++dx) {
                        const Vec2 q = p + tips.spacing() * Vec2(dx, dy);
                        const double z = exact.tip_z(q.x(), q.y());
                        low = std::min(low, z);
                        high = std::max(high, z);
                    }
                const double z = double(tips.z(i));
                QVERIFY2(z >= low - tips.spacing() && z <= high + tips.spacing(),
                         qPrintable(QString("at %1 %2: %3, exact %4 to %5")
                                        .arg(p.x())
                                        .arg(p.y())
                                        .arg(z)
                                        .arg(low)
                                        .arg(high)));
            }
            QVERIFY(seen > 100);
        }
    }

    void large_cutters_double_the_cells() {
        const auto ground = ground_of(waves(60), 240);
        const CoarseTips small(ground, CutterProfile(AptCutter::ball(2, 20)), 0, Progress()),
            large(ground, CutterProfile(AptCutter::ball(24, 40)), 0, Progress());
        QCOMPARE(small.spacing(), ground->grid().cell);
        QVERIFY(large.spacing() >= 2 * ground->grid().cell);
        // As high as the highest of four.
        const CoarseGround half = ground->halved();
        for (int y = 0; y < half.grid().rows; ++y)
            for (int x = 0; x < half.grid().columns; ++x) {
                float most = nothing_there;
                for (int k = 0; k < 4; ++k)
                    if (ground->grid().has(2 * x + k % 2, 2 * y + k / 2))
                        most = std::max(most,
                                        ground->height()[ground->grid().index(2 * x + k % 2, 2 * y + k / 2)]);
                QCOMPARE(half.height()[half.grid().index(x, y)], most);
            }
    }

    void distances_from_cells() {
        CoarseGrid grid;
        grid.cell = 0.5;
        grid.columns = 21;
        grid.rows = 11;
        std::vector<char> set(grid.size(), 0);
        set[grid.index(10, 5)] = 1;
        const std::vector<float> d = distance_from(set, grid);
        for (int y = 0; y < grid.rows; ++y)
            for (int x = 0; x < grid.columns; ++x) {
                const double exact = 0.5 * std::hypot(x - 10, y - 5);
                const double found = double(d[grid.index(x, y)]);
                QVERIFY(found >= exact - 1e-6 && found <= 1.09 * exact + 1e-6);
            }
    }

    void what_a_tool_leaves_of_a_groove() {
        // A groove 4 mm wide and 6 mm deep: a ball of 10 mm sinks 5 - sqrt(25 - 4) into it.
        Mesh mesh = height_field([](double x, double) { return std::abs(x) < 2 ? -6.0 : 0.0; },
                                 Vec2(-10, -10), Vec2(10, 10), 200, 4);
        const auto ground = ground_of(mesh, 200);
        const CoarseTips tips(ground, CutterProfile(AptCutter::ball(10, 40)), 0, Progress());
        const std::vector<float> left = tips.left_heights(Progress());
        const CoarseGrid& grid = tips.ground().grid();
        const double expected = -(5 - std::sqrt(25.0 - 4));
        const float middle = left[grid.index(grid.columns / 2, grid.rows / 2)];
        QVERIFY2(std::abs(double(middle) - expected) < 0.15, qPrintable(QString::number(double(middle))));
        QVERIFY(std::abs(double(left[grid.index(2, grid.rows / 2)])) < 0.02);
    }

    void making_it_can_be_cancelled() {
        const Mesh mesh = waves(300);
        Job job;
        QVERIFY(cancelled_at(job, 0.5, [&](const Progress& p) {
            CoarseGround(mesh, mesh.facet_count(), Mat3::Identity(), 200, p);
        }));
    }
};

FACETMILL_TEST(TestCoarseGround)
#include "test_coarse_ground.moc"
