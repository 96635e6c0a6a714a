// The grid of the cutter's places about a band, and searches that start from it, against places asked one by
// one.
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/cleanup/tip_grid.h"
#include "tests/support/test_runner.h"
#include "tests/unit/strategy/cleanup/cutter_over.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A valley along Y between walls that lean, with waves.
Mesh wavy_valley() {
    return height_field(
        [](double x, double y) { return 1.6 * std::abs(x) + 0.2 * std::sin(2 * x) * std::cos(1.1 * y); },
        Vec2(-8, -6), Vec2(8, 6), 64, 48);
}

/// The facets of a mesh about the middle, as the band.
RestBand band_about_middle(const Mesh& mesh, double within) {
    RestBand band;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        const std::array<Vec3, 3> t{mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)};
        if (std::abs(t[0].x()) < within && std::abs(t[0].y()) < within) band.band.push_back(t);
    }
    return band;
}

} // namespace

class TestTipGrid : public QObject {
    Q_OBJECT
private slots:
    void nearest_is_the_best_of_all_places_data() {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("corner");
        QTest::newRow("ball") << 1.0 << 1.0;
        QTest::newRow("bull") << 1.2 << 0.4;
        QTest::newRow("flat") << 0.8 << 0.0;
    }
    void nearest_is_the_best_of_all_places() {
        QFETCH(double, radius);
        QFETCH(double, corner);
        const Mesh part = wavy_valley();
        Tool tool = ball_tool(2 * radius);
        tool.corner_radius = corner;
        const CutterOver cutter(part, tool);
        const RestBand band = band_about_middle(part, 2);
        const RestBand* const bands[] = {&band};
        const TipGrid tips(cutter.lift, cutter.cover, part.box(), bands, Progress());
        std::size_t asked = 0;
        for (const auto& t : band.band) {
            const Vec3 p = (t[0] + t[1] + t[2]) / 3;
            if (++asked % 7 != 0) continue;
            QVERIFY(tips.is_about(p));
            // All places of the same grid that come near enough, one by one.
            const double within = 0.3 * radius;
            const auto found = tips.nearest(p, within);
            const auto left = [&](const Vec2& at) {
                return cutter.cover.distance(p - Vec3(at.x(), at.y(), cutter.lift.tip_z(at.x(), at.y())));
            };
            double least = within;
            const Vec2 start = found.value_or(p.head<2>());
            const int reach = int(3 * radius / tips.spacing());
            for (int i = -reach; found && i <= reach; ++i)
                for (int j = -reach; j <= reach; ++j)
                    least = std::min(least, left(start + tips.spacing() * Vec2(i, j)));
            if (found)
                QVERIFY2(left(*found) <= least + 1e-4, qPrintable(QString::number(left(*found) - least)));
            // Half as near none comes, or one that does.
            if (const auto nearer = tips.nearest(p, 0.5 * within))
                QVERIFY(left(*nearer) < 0.5 * within + 1e-4);
        }
        QVERIFY(asked > 200);
        QVERIFY(!tips.is_about(Vec3(7.5, 5.5, 0)));
        QVERIFY(!tips.nearest(Vec3(0, 0, -10), 1));
    }

    /// The search from the grid comes as near as the search from the place that the normal asks for does, all
    /// in all, and gives up only where nothing comes near enough.
    void search_is_no_worse_from_the_grid() {
        const Mesh part = wavy_valley();
        const CutterOver ball(part, ball_tool(2));
        const RestBand band = band_about_middle(part, 3);
        const RestBand* const bands[] = {&band};
        const TipGrid tips(ball.lift, ball.cover, part.box(), bands, Progress());
        const ValleyInput without = ball.valleys(0.05);
        ValleyInput with = without;
        with.tips = &tips;
        const double enough = 0.01, finest = 0.005;
        int touched = 0, not_touched = 0;
        double all_old = 0, all_now = 0, worst = 0, short_of = 0;
        for (const auto& t : band.band) {
            const Vec3 p = (t[0] + t[1] + t[2]) / 3, n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
            LiftHint hint;
            const RestSample from = nearest_touch(without, p, n, hint);
            const RestSample old = nearest_about(without, from, enough, finest, hint);
            const RestSample now = nearest_about(with, from, enough, finest, hint);
            all_old += std::max(old.gap, enough);
            all_now += std::max(now.gap, enough);
            worst = std::max(worst, now.gap - std::max(old.gap, enough));
            QVERIFY(std::abs(ball.cover.distance(p - now.tip) - now.gap) < 1e-12);
            QVERIFY(now.tip.z() >= ball.lift.tip_z(now.tip.x(), now.tip.y()) - 1e-9);
            (old.gap > enough ? not_touched : touched)++;
            // Asked for less than there can be, it says so; for more, it finds it.
            if (old.gap > 0.05) QVERIFY(nearest_about(with, from, enough, finest, hint, 0.02).gap > 0.02);
            if (now.gap > enough)
                short_of = std::max(short_of,
                                    nearest_about(with, from, enough, finest, hint, now.gap).gap - now.gap);
        }
        // Either may end on a ridge beside the other's place.
        QVERIFY2(all_now <= 1.01 * all_old, qPrintable(QString("%1, was %2").arg(all_now).arg(all_old)));
        QVERIFY2(worst < 0.05, qPrintable(QString::number(worst)));
        QVERIFY2(short_of <= finest, qPrintable(QString::number(short_of)));
        QVERIFY(touched > 50 && not_touched > 50);
    }

    void other_cutters_have_no_grid() {
        const Mesh part = wavy_valley();
        Tool cone = ball_tool(2);
        cone.taper_angle = 0.1;
        const CutterOver cutter(part, cone);
        const RestBand band = band_about_middle(part, 2);
        const RestBand* const bands[] = {&band};
        const TipGrid tips(cutter.lift, cutter.cover, part.box(), bands, Progress());
        QVERIFY(!tips.is_about(Vec3::Zero()));
        QVERIFY(!tips.nearest(Vec3::Zero(), 1));
    }
};

FACETMILL_TEST(TestTipGrid)
#include "test_tip_grid.moc"
