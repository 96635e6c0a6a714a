// The side feed over turned profiles: cusps against a section through the axis looked at place by place, and
// feeds that change slowly and keep their limits, against every pair of places.
#include "core/strategy/lathe/lathe_feed.h"
#include "tests/property/shapes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <functional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Profile = std::function<double(double)>;

/// A part about X from 0 to `length` with this radius at an angle and place.
Mesh lopsided_part(const std::function<double(double, double)>& radius, double length, int along, int sides) {
    Mesh m;
    for (int i = 0; i <= along; ++i)
        for (int k = 0; k < sides; ++k) {
            const double x = length * i / along, angle = 2 * pi * k / sides, r = radius(angle, x);
            m.vertices.emplace_back(x, r * std::cos(angle), r * std::sin(angle));
        }
    const auto at = [&](int i, int k) { return Index(i * sides + k % sides); };
    for (int i = 0; i < along; ++i)
        for (int k = 0; k < sides; ++k) {
            m.facets.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
            m.facets.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
        }
    return m;
}

Mesh turned_part(const Profile& profile, double length, int along, int sides) {
    return lopsided_part([&](double, double x) { return profile(x); }, length, along, sides);
}

/// A profile that a ball of radius 3 can follow: its hollows are rounder.
Profile random_profile(Random& rng) {
    const double a = uniform(rng, 0.3, 0.9), b = uniform(rng, 0.2, 0.45), c = uniform(rng, 0, 2 * pi),
                 slope = uniform(rng, -0.15, 0.15);
    return [=](double x) { return 20 + a * std::sin(b * x + c) + slope * x; };
}

/// Section through the axis: a ball's centre above the profile, and what two balls leave over its places.
struct Section {
    Profile profile;
    double length, r;
    static constexpr double fine = 0.004;

    /// Height of the centre of a ball that comes down at x.
    double center(double x) const {
        double height = -infinity;
        for (double q = std::max(0.0, x - r); q <= std::min(length, x + r); q += fine)
            height = std::max(height, profile(q) + std::sqrt(std::max(r * r - (q - x) * (q - x), 0.0)));
        return height;
    }
    /// Largest height over the profile, along its normal, that balls at a and b leave between them.
    double cusp(double a, double b) const {
        const Vec2 first(a, center(a)), second(b, center(b));
        double most = 0;
        for (double q = a; q <= b; q += 2 * fine) {
            const double rise = (profile(q + 1e-5) - profile(q - 1e-5)) / 2e-5;
            const Vec2 p(q, profile(q)), n = Vec2(-rise, 1).normalized();
            double left = infinity;
            for (const Vec2& center : {first, second}) {
                const Vec2 e = p - center;
                const double f = e.dot(n), root = f * f - (e.squaredNorm() - r * r);
                if (root >= 0) left = std::min(left, std::max(-f - std::sqrt(root), 0.0));
            }
            // What no tip between the two touches does not count.
            if (q - r * rise / std::hypot(1, rise) < a || q - r * rise / std::hypot(1, rise) > b) continue;
            most = std::max(most, left);
        }
        return most;
    }
};

struct Feed {
    PlanContext context;
    LatheField field;
    SideFeed feed;

    Feed(const Mesh& part, double diameter, double from, double to, double cusp, double allowance = 0,
         bool across_turns = true)
        : context(context_of(part, ball_tool(diameter))), field({}, context, allowance, Progress()),
          feed(field, across_turns, from, to, cusp, Progress()) {}
};

} // namespace

class TestLatheFeed : public QObject {
    Q_OBJECT
private slots:
    /// On a cone with half angle w a ball's cusp at the feed f is that of f / cos w along the flank.
    void cusps_on_a_cone() {
        const double slope = 0.4, r = 3, advance = 1.2;
        const Mesh part = turned_part([&](double x) { return 15 + slope * x; }, 20, 1, 720);
        const Feed f(part, 2 * r, 4, 16, 0.05);
        const double along = advance * std::hypot(1, slope),
                     exact = r - std::sqrt(r * r - 0.25 * along * along);
        const double found = f.feed.cusp_of(advance, Progress());
        QVERIFY2(std::abs(found - exact) < 0.06 * exact,
                 qPrintable(QString("%1 of %2").arg(found).arg(exact)));
    }

    /// What is to stay on the part is no cusp.
    void an_allowance_is_no_cusp() {
        const double r = 3, advance = 1.1, exact = r - std::sqrt(r * r - 0.25 * advance * advance);
        for (const double allowance : {0.0, 0.4, 1.5}) {
            const Feed f(turned_part([](double) { return 15.0; }, 20, 1, 720), 2 * r, 4, 16, 0.05, allowance);
            const double found = f.feed.cusp_of(advance, Progress());
            QVERIFY2(std::abs(found - exact) < 0.02 * exact,
                     qPrintable(QString("%1 of %2 over %3").arg(found).arg(exact).arg(allowance)));
        }
    }

    /// Between lines along a cylinder two balls, seen along it, are circles whose middles are an angle apart.
    void lengthwise_lines_on_a_cylinder() {
        const double radius = 12, r = 3, cusp = 0.05;
        for (const double allowance : {0.0, 0.4}) {
            Feed f(turned_part([](double) { return 12.0; }, 20, 1, 1440), 2 * r, 4, 16, cusp, allowance,
                   false);
            const double out = radius + allowance + r;
            const auto left = [&](double angle) {
                const double half = 0.5 * angle, aside = out * std::sin(half);
                return out * std::cos(half) - std::sqrt(r * r - aside * aside) - radius - allowance;
            };
            for (const double angle : {0.06, 0.1}) {
                const double found = f.feed.cusp_of(angle, Progress());
                QVERIFY2(std::abs(found - left(angle)) < 0.04 * left(angle),
                         qPrintable(QString("%1 of %2").arg(found).arg(left(angle))));
            }
            f.feed.measure(Progress());
            for (double a = 0; a < 6.2; a += 0.1) {
                const double leaves = left(f.feed.allowed(a));
                QVERIFY2(leaves < 1.04 * cusp && leaves > 0.9 * cusp, qPrintable(QString::number(leaves)));
            }
            // A limit just behind the closing line shortens the last advances, which pass over it.
            SideFeed limited = f.feed;
            const double tight = 0.3 * f.feed.allowed(0), at = 0.5 * tight;
            const std::vector<FeedLimit> limits{{at, tight}};
            limited.limit(limits);
            for (const double a : {0.0, at, 2 * pi - 0.5 * tight + 1e-6, 2 * pi - 1e-6})
                QVERIFY2(std::abs(limited.allowed(a) - tight) < 1e-9, qPrintable(QString::number(a)));
            QVERIFY(std::abs(limited.allowed(3) - f.feed.allowed(3)) < 1e-9);
        }
    }

    void cusps_of_random_profiles_against_a_section() {
        Random rng(14);
        const double length = 24, r = 3, from = 5, to = 19;
        for (int trial = 0; trial < trials(4, 4); ++trial) {
            const Profile profile = random_profile(rng);
            const Feed f(turned_part(profile, length, 600, 180), 2 * r, from, to, 0.05);
            const Section section{profile, length, r};
            const double advance = uniform(rng, 0.8, 1.8);
            double exact = 0;
            const auto n = std::size_t(std::ceil((to - from) / (0.5 * advance)));
            for (std::size_t k = 0; k < n; ++k) {
                const double a = from + (to - from) * double(k) / double(n);
                if (a + advance <= to) exact = std::max(exact, section.cusp(a, a + advance));
            }
            const double found = f.feed.cusp_of(advance, Progress());
            QVERIFY2(std::abs(found - exact) < 0.08 * exact,
                     qPrintable(QString("%1 of %2").arg(found).arg(exact)));
        }
    }

    /// What is allowed leaves the cusp, and hardly less.
    void allowed_feeds_leave_the_cusp() {
        Random rng(6);
        const double length = 24, r = 3, from = 5, to = 19, cusp = 0.05;
        for (int trial = 0; trial < trials(3, 3); ++trial) {
            const Profile profile = random_profile(rng);
            Feed f(turned_part(profile, length, 600, 180), 2 * r, from, to, cusp);
            f.feed.measure(Progress());
            QCOMPARE(f.feed.unsatisfied(), 0.0);
            const Section section{profile, length, r};
            double highest = 0;
            for (double a = from; a + 2 < to; a += 0.37) {
                const double left = section.cusp(a, a + f.feed.allowed(a));
                QVERIFY2(left <= 1.08 * cusp, qPrintable(QString("%1 at %2").arg(left).arg(a)));
                highest = std::max(highest, left);
            }
            QVERIFY2(highest > 0.85 * cusp, qPrintable(QString::number(highest)));
        }
    }

    /// Waves on one side of a part shorten the feed as much wherever that side is.
    void feeds_suit_the_worst_angle() {
        const double length = 16, from = 4, to = 12;
        std::vector<double> shortest;
        for (const double turn : {0.0, 2.0, 4.0}) {
            Feed f(lopsided_part(
                       [&](double angle, double x) {
                           const double side = std::max(0.0, std::cos(angle - turn));
                           return 15 + 0.9 * side * side * std::sin(0.6 * x);
                       },
                       length, 240, 120),
                   6, from, to, 0.05);
            f.feed.measure(Progress());
            double least = infinity;
            for (double a = from; a + 1.5 < to; a += 0.02)
                least = std::min(least, f.feed.allowed(a));
            shortest.push_back(least);
        }
        Feed plain(turned_part([](double) { return 15.0; }, length, 1, 720), 6, from, to, 0.05);
        plain.feed.measure(Progress());
        for (const double least : shortest)
            QVERIFY2(least < 0.9 * plain.feed.allowed(from) && std::abs(least - shortest[0]) < 0.03 * least,
                     qPrintable(QString("%1, %2, %3 of %4")
                                    .arg(shortest[0])
                                    .arg(shortest[1])
                                    .arg(shortest[2])
                                    .arg(plain.feed.allowed(from))));
    }

    /// A shoulder asks for a feed as short as the cusp; towards it feeds shrink by half of the way at most.
    void feeds_change_slowly() {
        const Mesh part = turned_part(
            [](double x) { return x < 12 ? 15.0 : std::min(15 + 40 * (x - 12), 19.0); }, 24, 480, 90);
        Feed f(part, 6, 3, 21, 0.05);
        f.feed.measure(Progress());
        double least = infinity, most = 0;
        for (double a = 3; a < 21; a += 0.01) {
            const double here = f.feed.allowed(a);
            least = std::min(least, here);
            most = std::max(most, here);
            QVERIFY(std::abs(f.feed.allowed(a + 0.01) - here) <= 0.5 * 0.01 + 1e-12);
        }
        QVERIFY2(least < 0.25 * most, qPrintable(QString("%1 of %2").arg(least).arg(most)));
        QVERIFY(least >= f.feed.smallest() && most <= f.feed.largest());
    }

    /// A wall that rises by 4 mm within a thousandth, and a cusp that no feed keeps to there: it is the
    /// smallest one, and that is told.
    void where_no_feed_suffices_it_is_the_smallest() {
        if (under_sanitizer) QSKIP("slow there, and the tests before it call the same");
        Mesh part = turned_part([](double x) { return x <= 12 ? 15.0 : 19.0; }, 24, 24, 90);
        for (Vec3& v : part.vertices)
            if (v.x() == 13) v.x() = 12.001;
        Feed f(part, 6, 3, 21, 0.002);
        f.feed.measure(Progress());
        QVERIFY(f.feed.unsatisfied() > 0 && f.feed.unsatisfied() < 0.1);
        double least = infinity;
        for (double a = 8.5; a < 9.5; a += 0.0001)
            least = std::min(least, f.feed.allowed(a));
        QVERIFY2(least >= f.feed.smallest() && least < 1.05 * f.feed.smallest(),
                 qPrintable(QString("%1 of %2").arg(least).arg(f.feed.smallest())));
    }

    /// No advance that passes over a limit's place is longer, and none is shorter than the limits ask for.
    ///
    /// The longest that limits allow is known: a limit is felt from where an advance of its length comes to
    /// its place, and from there to either side it wears off by half of the way. Feeds are that at the places
    /// that were looked at, ends of limits included, and run straight between these. There every limit is
    /// straight and the least of them is concave, so a feed is never longer, and where two limits meet
    /// between two places it is shorter: by a quarter of the places' distance at most, since the slopes are a
    /// half. Over a cylinder the places are no farther apart than a quarter of the feed.
    void random_limits_against_every_place() {
        Random rng(31);
        const Mesh part = turned_part([](double) { return 15.0; }, 30, 30, 360);
        Feed plain(part, 6, 2, 28, 0.05);
        plain.feed.measure(Progress());
        double widest = 0;
        for (double a = 2; a < 28; a += 0.01)
            widest = std::max(widest, plain.feed.allowed(a));
        const double between = 0.25 * 0.25 * widest;
        double shortest = 0;
        for (int trial = 0; trial < trials(20, 5); ++trial) {
            SideFeed feed = plain.feed;
            std::vector<FeedLimit> limits;
            for (int k = whole(rng, 1, 5); k-- > 0;)
                limits.push_back({uniform(rng, 2, 28), uniform(rng, 0.05, 1.2)});
            feed.limit(limits);
            const auto longest = [&](double a) {
                double most = plain.feed.allowed(a);
                for (const FeedLimit& l : limits)
                    most = std::min(most, l.advance + 0.5 * std::max({l.at - l.advance - a, a - l.at, 0.0}));
                return most;
            };
            for (double a = 2; a < 28; a += 0.01) {
                const double here = feed.allowed(a), most = longest(a);
                for (const FeedLimit& l : limits)
                    QVERIFY(!(a <= l.at && a + here >= l.at) || here <= l.advance + 1e-9);
                QVERIFY2(here <= most + 1e-9,
                         qPrintable(QString("%1 > %2 at %3").arg(here).arg(most).arg(a)));
                QVERIFY2(here >= most - between - 1e-9,
                         qPrintable(QString("%1 < %2 at %3").arg(here).arg(most).arg(a)));
                shortest = std::max(shortest, most - here);
                QVERIFY(std::abs(feed.allowed(a + 0.01) - here) <= 0.5 * 0.01 + 1e-12);
            }
            for (const FeedLimit& l : limits)
                for (const double a : {std::max(l.at - l.advance, 2.0), l.at})
                    QVERIFY2(std::abs(feed.allowed(a) - longest(a)) < 1e-9,
                             qPrintable(QString("%1 at %2").arg(feed.allowed(a)).arg(a)));
        }
        qInfo("shorter than the limits ask for by up to %g of %g mm", shortest, between);
    }
};

FACETMILL_TEST(TestLatheFeed)
#include "test_lathe_feed.moc"
