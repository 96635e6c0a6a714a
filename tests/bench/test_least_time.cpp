// The least time that two tools take, on shapes whose widest strips are known.
#include "tests/bench/least_time.h"
#include "tests/property/shapes.h"
#include "tests/support/cancel_at.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double ball = 3;

Finish5Settings settings() {
    Finish5Settings s;
    s.tolerance = 0.05;
    s.feed = 600;
    s.lead_limits = {0, radians(5)};
    s.posture = Finish5Settings::PostureChoice::cm2;
    return s;
}

/// What stays of the tolerance for the cusp: a twentieth of it is the chords'.
constexpr double cusp = 0.95 * 0.05;

LeastTime min_of(const Mesh& mesh) {
    return least_time(context_of(mesh, flat_tool(10)), settings(), ball, Progress());
}

double relative(double is, double wanted) {
    return std::abs(is / wanted - 1);
}

} // namespace

class TestLeastTime : public QObject {
    Q_OBJECT
private slots:
    void a_plane_takes_the_whole_diameter() {
        const LeastTime t =
            min_of(height_field([](double, double) { return 0.0; }, Vec2(-20, -15), Vec2(20, 15), 8, 6));
        QVERIFY(relative(t.area, 1200) < 1e-9);
        QVERIFY2(t.seconds >= 12 && t.seconds < 12.5, qPrintable(QString::number(t.seconds)));
        QVERIFY2(t.straight_seconds >= t.seconds && t.straight_seconds < 1.05 * t.seconds,
                 qPrintable(QString::number(t.straight_seconds / t.seconds)));
        QCOMPARE(t.ball_area, 0.0);
        const double alone = 120 / (2 * std::sqrt(2 * cusp * 0.5 * ball));
        QVERIFY2(relative(t.ball_alone_seconds, alone) < 1e-6,
                 qPrintable(QString::number(t.ball_alone_seconds)));
    }

    /// Round about X: along X strips are 2 sqrt(2 h R), across they are as wide as the cutter's chord allows.
    void a_round_part_is_travelled_across_its_axis() {
        const double round = 60;
        const LeastTime t =
            min_of(height_field([=](double, double y) { return std::sqrt(round * round - y * y); },
                                Vec2(-20, -15), Vec2(20, 15), 8, 240));
        QVERIFY2(std::abs(degrees(t.direction) - 90) < 1, qPrintable(QString::number(degrees(t.direction))));
        // The edge of the disc is within the cusp over sqrt(2 h R) behind the line that it touches along.
        const double behind = std::sqrt(2 * cusp * round),
                     chord = 2 * std::sqrt(25 - (5 - behind) * (5 - behind));
        const double across = t.area / 10 / chord, along = t.area / 10 / (2 * behind);
        QVERIFY2(relative(t.straight_seconds, across) < 0.1,
                 qPrintable(QString::number(t.straight_seconds / across)));
        QVERIFY(t.straight_seconds < 0.8 * along);
        QVERIFY(t.seconds <= t.straight_seconds * (1 + 1e-9) && t.seconds > 0.9 * across);
    }

    /// A trough between level shoulders, tighter than the disc. Going down into it with a small lead the disc
    /// cuts its walls within little more than a millimetre of the shoulders.
    void where_the_disc_does_not_fit_the_ball_cuts() {
        const double hollow = 4, half = 3.5, top = hollow - std::sqrt(hollow * hollow - half * half);
        const LeastTime t = min_of(height_field(
            [=](double, double y) {
                return std::abs(y) < half ? hollow - std::sqrt(hollow * hollow - y * y) : top;
            },
            Vec2(-20, -14), Vec2(20, 14), 8, 224));
        // Each contact speaks for a quarter of the radius.
        const double arc = 2 * hollow * std::asin(half / hollow), edge = 1.25 + 1.25;
        QVERIFY2(t.ball_area < 1.01 * 40 * arc && t.ball_area > 40 * (arc - 2 * edge),
                 qPrintable(QString::number(t.ball_area / 40)));
        // The ball's strip is widest where it follows the trough.
        const double strip = std::sqrt(8 * cusp / (2 / ball - 1 / hollow));
        QVERIFY2(relative(t.ball_seconds, t.ball_area / 10 / strip) < 0.05,
                 qPrintable(QString::number(t.ball_seconds * strip * 10 / t.ball_area)));
        QVERIFY(t.ball_seconds < t.seconds && t.seconds < t.ball_alone_seconds);
    }

    void cancelling_leaves_nothing() {
        const Mesh mesh = height_field([](double x, double y) { return -0.01 * (x * x + y * y); },
                                       Vec2(-20, -15), Vec2(20, 15), 40, 30);
        for (const double when : {0.0, 0.3, 0.7}) {
            Job job;
            QVERIFY(cancelled_at(job, when, [&](const Progress& p) {
                least_time(context_of(mesh, flat_tool(10)), settings(), ball, p);
            }));
        }
    }
};

FACETMILL_TEST(TestLeastTime)
#include "test_least_time.moc"
