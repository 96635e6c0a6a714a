// Postures kept by hand: every method takes them where they are free, and says so where they are not.
#include "core/strategy/five_axis/finish5.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "tests/property/shapes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Choice = Finish5Settings::PostureChoice;

/// A hollow, its tool and machine. A ball leaves the same however it leans; a bull nose does not.
PlanContext context(Tool tool) {
    const Mesh part = height_field([](double x, double y) { return 0.012 * (x * x + y * y); }, Vec2(-10, -7),
                                   Vec2(10, 7), 16, 12);
    tool.flute_length = 15;
    tool.shank_diameter = 5;
    PlanContext c = context_of(part, tool);
    c.machine = find_machine("tarus-tpi-2000");
    return c;
}

Finish5Settings settings_with(Choice choice) {
    Finish5Settings s;
    s.tolerance = 0.1;
    s.direction = {0, "x"};
    s.posture = choice;
    s.grid_step = radians(6);
    return s;
}

std::array<double, 3> numbers(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

std::size_t nearest(const FiveAxisRecord& record, const Vec3& place) {
    const auto away = [&](const auto& p) { return (p.place.surface - place).norm(); };
    const auto it = std::min_element(record.points.begin(), record.points.end(),
                                     [&](const auto& a, const auto& b) { return away(a) < away(b); });
    return std::size_t(it - record.points.begin());
}

bool says(const StrategyResult& result, const std::string& what) {
    return std::any_of(result.warnings.begin(), result.warnings.end(),
                       [&](const std::string& w) { return w.find(what) != std::string::npos; });
}

/// A free posture that is not near the planned one and on no node; by default beyond the yaw limits of these
/// tests.
std::optional<PostureValue> free_posture(const std::shared_ptr<const FiveAxisRecord>& record,
                                         std::size_t index, double max_yaw = 80.7) {
    const FiveAxisStudy study(record, Progress());
    const auto point = study.point(index, Progress());
    const Vec3 planned =
        posture_axis(point.place.frame, point.planned.posture.lead, point.planned.posture.yaw);
    for (double yaw = max_yaw; yaw > 10; yaw -= 3)
        for (double lead = 30.3; lead > 5; --lead)
            for (const double side : {-1.0, 1.0}) {
                const PostureValue p{radians(lead), radians(side * yaw), 0};
                const Vec3 axis = posture_axis(point.place.frame, p.lead, p.yaw);
                if (axis.dot(planned) < std::cos(radians(5)) && axis.dot(planned) > std::cos(radians(12))
                    && study.reason(point, p.lead, p.yaw).block == PostureBlock::free)
                    return p;
            }
    return std::nullopt;
}

std::vector<double> tips(const StrategyResult& result) {
    std::vector<double> all;
    for (const Pass& pass : result.passes)
        for (const CutterLocation& cl : pass.cl)
            all.insert(all.end(), cl.tip.data(), cl.tip.data() + 3);
    return all;
}

} // namespace

class TestManualPosture : public QObject {
    Q_OBJECT
private slots:
    void every_method_takes_it_data() {
        QTest::addColumn<int>("choice");
        if (!under_sanitizer) { // what the third does holds what these do
            QTest::newRow("cm2") << 0;
            QTest::newRow("local") << 1;
        }
        QTest::newRow("global") << 2;
    }
    void every_method_takes_it() {
        QFETCH(int, choice);
        const PlanContext c = context(ball_tool(5));
        Finish5Settings s = settings_with(Choice(choice));
        // The limits are for what the program chooses.
        s.yaw_limits = {radians(-6), radians(6)};
        const StrategyResult without = Finish5(s).plan(c, Progress());
        const FiveAxisRecord& record = *without.five_axis();
        const std::size_t middle = nearest(record, Vec3(0.4, 0.6, 0));
        const Vec3 place = record.points[middle].place.surface;
        const auto wish = free_posture(without.five_axis(), middle);
        QVERIFY(wish.has_value());
        const double lead = wish->lead, yaw = wish->yaw;
        s.manual_postures = {{numbers(place), lead, yaw}};
        const StrategyResult with = Finish5(s).plan(c, Progress());
        const FiveAxisRecord& kept = *with.five_axis();
        QCOMPARE(kept.points.size(), record.points.size());
        const FiveAxisRecord::Point& now = kept.points[middle];
        QVERIFY(now.place.kept.has_value());
        QVERIFY(now.choice.free);
        QCOMPARE(now.choice.posture.lead, lead);
        QCOMPARE(now.choice.posture.yaw, yaw);
        QCOMPARE(std::count_if(kept.points.begin(), kept.points.end(),
                               [](const auto& p) { return p.place.kept.has_value(); }),
                 1);
        QVERIFY(!says(with, "kept"));
        // It is in the path, and the way there and back turns as little at once as elsewhere.
        const Vec3 axis = posture_axis(now.place.frame, lead, yaw);
        bool found = false;
        for (const Pass& pass : with.passes)
            for (std::size_t i = 0; i < pass.cl.size(); ++i) {
                found |= (pass.cl[i].axis - axis).norm() < 1e-12 && (pass.cc[i].point - place).norm() < 1e-12;
                if (i > 0) QVERIFY(pass.cl[i].axis.dot(pass.cl[i - 1].axis) >= std::cos(s.turn_limit + 1e-6));
            }
        QVERIFY(found);
        // Studied again it is what all methods choose there.
        const FiveAxisStudy study(with.five_axis(), Progress());
        for (const ChosenPosture& chosen : study.point(middle, Progress()).chosen) {
            QVERIFY(chosen.free);
            QCOMPARE(chosen.posture.lead, lead);
            QCOMPARE(chosen.posture.yaw, yaw);
        }
    }

    void neighbors_follow_when_all_is_chosen_together() {
        const PlanContext c = context(ball_tool(5));
        Finish5Settings s = settings_with(Choice::global);
        s.turn_limit = radians(4);
        const auto before = Finish5(s).plan(c, Progress()).five_axis();
        const std::size_t middle = nearest(*before, Vec3(0.4, 0.6, 0));
        // Within the yaw limits: farther out it would have no neighbours to follow it by so little a turn.
        const auto wish = free_posture(before, middle, 44.7);
        QVERIFY(wish.has_value());
        const auto axis = [](const FiveAxisRecord::Point& p) {
            return posture_axis(p.place.frame, p.choice.posture.lead, p.choice.posture.yaw);
        };
        s.manual_postures = {{numbers(before->points[middle].place.surface), wish->lead, wish->yaw}};
        const auto after = Finish5(s).plan(c, Progress()).five_axis();
        const Vec3 kept = axis(after->points[middle]);
        // Where they stood, they were too far from it.
        QVERIFY(axis(before->points[middle - 1]).dot(kept) < std::cos(s.turn_limit));
        for (const std::size_t i : {middle - 1, middle + 1}) {
            QVERIFY(after->points[i].choice.free);
            QVERIFY(axis(after->points[i]).dot(kept) >= std::cos(s.turn_limit + 1e-9));
        }
    }

    void one_that_is_not_free_is_told() {
        const PlanContext c = context(bull_tool(5, 1));
        for (const Choice choice : {Choice::cm2, Choice::local, Choice::global}) {
            if (under_sanitizer && choice != Choice::global) continue;
            Finish5Settings s = settings_with(choice);
            const StrategyResult without = Finish5(s).plan(c, Progress());
            const auto& at = without.five_axis()->points[nearest(*without.five_axis(), Vec3(0.4, 0.6, 0))];
            s.manual_postures = {{numbers(at.place.surface), radians(88), 0}};
            const StrategyResult with = Finish5(s).plan(c, Progress());
            QVERIFY(says(with, "the posture kept for the point "
                                   + length_text(at.place.surface.x(), LengthUnit::mm)));
            QVERIFY(says(with, "not free"));
            QCOMPARE(with.warnings.size(), without.warnings.size() + 1);
            QCOMPARE(tips(with), tips(without));
        }
    }

    void it_goes_with_its_place() {
        const PlanContext c = context(bull_tool(5, 1));
        Finish5Settings s = settings_with(Choice::cm2);
        const StrategyResult without = Finish5(s).plan(c, Progress());
        const auto& at = without.five_axis()->points[nearest(*without.five_axis(), Vec3(0.4, 0.6, 0))];
        s.manual_postures = {{numbers(at.place.surface), radians(20), radians(10)}};
        // Other passes: the nearest contact point takes it.
        s.tolerance = 0.08;
        const StrategyResult moved = Finish5(s).plan(c, Progress());
        const auto& points = moved.five_axis()->points;
        const auto kept = std::find_if(points.begin(), points.end(),
                                       [](const auto& p) { return p.place.kept.has_value(); });
        QVERIFY(kept != points.end());
        QVERIFY((kept->place.surface - at.place.surface).norm() < 0.5 * c.tool.diameter);
        // Two for one point, and one beside the part.
        s.manual_postures.push_back(s.manual_postures.front());
        s.manual_postures.push_back({{500, 0, 0}, radians(20), 0});
        const StrategyResult crowded = Finish5(s).plan(c, Progress());
        QVERIFY(says(crowded, "another one is kept"));
        QVERIFY(says(crowded, "the point 500 mm, 0 mm, 0 mm is not used: no pass"));
        QCOMPARE(tips(crowded), tips(moved));
    }
};

FACETMILL_TEST(TestManualPosture)
#include "test_manual_posture.moc"
