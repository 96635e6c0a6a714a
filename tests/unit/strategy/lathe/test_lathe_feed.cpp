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

/// A part about X from 0 to `length` with this radius.
Mesh turned_part(const Profile& profile, double length, int along, int sides) {
    Mesh m;
    for (int i = 0; i <= along; ++i)
        for (int k = 0; k < sides; ++k) {
            const double x = length * i / along, angle = 2 * pi * k / sides, r = profile(x);
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

    Feed(const Mesh& part, double diameter, double from, double to, double cusp)
        : context(context_of(part, ball_tool(diameter))), field({}, context, 0, Progress()),
          feed(field, true, from, to, cusp, Progress()) {}
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

    /// No advance that passes over a limit's place is longer, and none is shorter than the limits ask for.
    void random_limits_against_every_place() {
        Random rng(31);
        const Mesh part = turned_part([](double) { return 15.0; }, 30, 30, 360);
        Feed plain(part, 6, 2, 28, 0.05);
        plain.feed.measure(Progress());
        for (int trial = 0; trial < trials(20, 5); ++trial) {
            SideFeed feed = plain.feed;
            std::vector<FeedLimit> limits;
            for (int k = whole(rng, 1, 5); k-- > 0;)
                limits.push_back({uniform(rng, 2, 28), uniform(rng, 0.05, 1.2)});
            feed.limit(limits);
            for (double a = 2; a < 28; a += 0.01) {
                const double here = feed.allowed(a);
                double floor = plain.feed.allowed(a);
                for (const FeedLimit& l : limits) {
                    QVERIFY(!(a <= l.at && a + here >= l.at) || here <= l.advance + 1e-9);
                    // A limit is felt from where an advance of its length comes to its place, and from there
                    // to either side it wears off by half of the way.
                    const double off = std::max({l.at - l.advance - a, a - l.at, 0.0});
                    floor = std::min(floor, l.advance + 0.5 * off);
                }
                QVERIFY2(here >= 0.9 * floor, // feeds run straight between places that were looked at
                         qPrintable(QString("%1 < %2 at %3").arg(here).arg(floor).arg(a)));
                QVERIFY(std::abs(feed.allowed(a + 0.01) - here) <= 0.5 * 0.01 + 1e-12);
            }
        }
    }
};

FACETMILL_TEST(TestLatheFeed)
#include "test_lathe_feed.moc"
