// The stretch of a line in a swept tool, against a search that knows the cutter's profile only.
#include "core/verify/sweep.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <functional>
#include <random>

using namespace facetmill;
using facetmill::test::trials;

namespace {

/// Smallest value of a convex function, and where.
std::pair<double, double> lowest(const std::function<double(double)>& f, double a, double b) {
    constexpr double golden = 0.6180339887498949;
    double x = b - golden * (b - a), y = a + golden * (b - a), fx = f(x), fy = f(y);
    for (int i = 0; i < 90; ++i) {
        if (fx <= fy) {
            b = y;
            y = x;
            fy = fx;
            x = b - golden * (b - a);
            fx = f(x);
        } else {
            a = x;
            x = y;
            fx = fy;
            y = a + golden * (b - a);
            fy = f(y);
        }
    }
    return fx <= fy ? std::pair{fx, x} : std::pair{fy, y};
}

double zero(const std::function<double(double)>& f, double inside, double outside) {
    for (int i = 0; i < 100; ++i) {
        const double m = 0.5 * (inside + outside);
        (f(m) <= 0 ? inside : outside) = m;
    }
    return inside;
}

/// How far a point is outside the body, <= 0 inside; convex, or nearly so.
double outside(const CutterProfile& body, const Vec3& q) {
    const double height = std::max(-q.z(), q.z() - body.height());
    const double z = std::clamp(q.z(), 0.0, body.height());
    // Below the tip the radius falls on, steeply, and so it does above the top.
    return std::max(height, std::hypot(q.x(), q.y()) - body.radius_at(z) + 1e4 * std::max(height, 0.0));
}

struct Case {
    CutterProfile profile;
    StraightMove move;
    Vec3 p, u;
};

Stretch reference(const Case& k) {
    const Mat3 frame = to_tool_frame(k.move.axis);
    const Vec3 route = k.move.to - k.move.from;
    const double far = 500;
    const auto at = [&](double t, double s) {
        return outside(k.profile, frame * (k.p + t * k.u - k.move.from - s * route));
    };
    const auto nearest = [&](double s) { return lowest([&](double t) { return at(t, s); }, -far, far); };
    const auto depth = [&](double s) { return nearest(s).first; };
    const auto [least, where] = lowest(depth, 0, 1);
    if (least > 0) return {};
    const double first = depth(0) <= 0 ? 0 : zero(depth, where, 0),
                 last = depth(1) <= 0 ? 1 : zero(depth, where, 1);
    const auto end = [&](double s, double to) {
        return zero([&](double t) { return at(t, s); }, nearest(s).second, to);
    };
    Stretch r;
    r.lo = lowest([&](double s) { return end(s, -far); }, first, last).first;
    r.hi = -lowest([&](double s) { return -end(s, far); }, first, last).first;
    return r;
}

const std::vector<AptCutter>& cutters() {
    static const std::vector<AptCutter> all = {
        AptCutter::ball(10, 30),
        AptCutter::flat(10, 30),
        AptCutter::bull(10, 2, 30),
        AptCutter::cone(12, radians(35)),
        AptCutter::tapered_ball(2, radians(8), 25),
        AptCutter::from_shape(10, 1.5, radians(10), radians(5), 20),
        AptCutter::from_shape(16, 3, radians(20), radians(-12), 15),
        AptCutter::from_shape(8, 0, radians(59), 0, 25),
        AptCutter::ball(10, 3),
        // A bullet: the arc's centre lies beyond the axis.
        AptCutter::from_shape(10, 0.9 * AptCutter::largest_corner_radius(10, radians(40), radians(3)),
                              radians(40), radians(3), 18),
    };
    return all;
}

/// The n-th line near a moving tool, of a kind that random_lines_data names.
Case random_case(int kind, int n, std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> share(0, 1);
    const auto unit = [&] { return Vec3(normal(random), normal(random), normal(random)).normalized(); };
    const std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    Case k{CutterProfile(cutters()[std::size_t(n) % cutters().size()]), {}, {}, {}};
    k.move.axis = kind == 1 || kind == 2 ? Vec3(Vec3::UnitZ()) : kind == 6 ? Vec3(Vec3::UnitX()) : unit();
    k.move.from = 20 * unit();
    k.move.to = k.move.from + 15 * share(random) * unit();
    k.u = n % 2 && kind > 0 ? axes[std::size_t(n / 2) % 3] : unit();
    if (kind == 2) k.move.to.z() = k.move.from.z();
    if (kind == 3) k.move.to = k.move.from;
    if (kind == 4) k.move.to = k.move.from + 7 * k.u;
    if (kind == 5) k.u = k.move.axis.cross(unit()).normalized();
    if (kind == 7) {
        const double off = std::pow(10, -4 - 9 * share(random));
        k.u = Vec3(k.move.axis + off * unit()).normalized();
        k.move.to = k.move.from + 9 * Vec3(k.move.axis + 0.5 * off * unit()).normalized();
    }
    // A line through some place of the tool on its way.
    const double z = k.profile.height() * share(random);
    const Vec3 on = k.move.from + share(random) * (k.move.to - k.move.from) + z * k.move.axis;
    k.p = on + 1.1 * k.profile.max_radius() * std::sqrt(share(random)) * unit() - 10 * share(random) * k.u;
    return k;
}

} // namespace

class TestSweep : public QObject {
    Q_OBJECT
private slots:
    void random_lines_data() {
        QTest::addColumn<int>("kind");
        const char* names[] = {"general",    "vertical tool",         "vertical tool, level motion",
                               "no motion",  "line along the motion", "line across the axis",
                               "tool level", "nearly parallel"};
        for (int k = 0; k < 8; ++k)
            QTest::newRow(names[k]) << k;
    }
    void random_lines() {
        QFETCH(int, kind);
        std::mt19937 random(unsigned(100 + kind));
        std::uniform_real_distribution<double> share(0, 1);
        double worst = 0;
        int hit = 0;
        const int lines = trials(400);
        for (int n = 0; n < lines; ++n) {
            const Case k = random_case(kind, n, random);
            const TurnedBody body(k.profile);
            const Stretch got = SweepRays(body, k.move, k.u)(k.p), want = reference(k);
            if (got.empty() || want.empty()) {
                // Grazing lines only may differ.
                const Stretch& other = got.empty() ? want : got;
                QVERIFY2(other.empty() || other.hi - other.lo < 1e-5,
                         qPrintable(QString("case %1: %2 %3 against %4 %5")
                                        .arg(n)
                                        .arg(got.lo)
                                        .arg(got.hi)
                                        .arg(want.lo)
                                        .arg(want.hi)));
                continue;
            }
            ++hit;
            const double off = std::max(std::abs(got.lo - want.lo), std::abs(got.hi - want.hi));
            QVERIFY2(off < 1e-6, qPrintable(QString("case %1: %2 %3 against %4 %5")
                                                .arg(n)
                                                .arg(got.lo, 0, 'g', 12)
                                                .arg(got.hi, 0, 'g', 12)
                                                .arg(want.lo, 0, 'g', 12)
                                                .arg(want.hi, 0, 'g', 12)));
            worst = std::max(worst, off);
            // Within a window the same, or nothing where there is nothing.
            const double low = got.lo + (got.hi - got.lo) * (2 * share(random) - 1);
            const double high = low + (got.hi - got.lo) * share(random);
            const Stretch part = SweepRays(body, k.move, k.u)(k.p, low, high);
            const double from = std::max(got.lo, low), to = std::min(got.hi, high);
            if (!(to - from > 1e-9)) continue;
            QVERIFY2(!part.empty() && std::abs(std::max(part.lo, low) - from) < 1e-9
                         && std::abs(std::min(part.hi, high) - to) < 1e-9,
                     qPrintable(QString("case %1: %2 %3 of %4 %5 within %6 %7")
                                    .arg(n)
                                    .arg(part.lo, 0, 'g', 12)
                                    .arg(part.hi, 0, 'g', 12)
                                    .arg(got.lo, 0, 'g', 12)
                                    .arg(got.hi, 0, 'g', 12)
                                    .arg(low, 0, 'g', 12)
                                    .arg(high, 0, 'g', 12)));
        }
        qInfo("%d of %d lines meet the tool; worst difference %.2g mm", hit, lines, worst);
        QVERIFY(hit > lines / 2);
    }

    void rows_are_as_their_lines_data() { random_lines_data(); }
    void rows_are_as_their_lines() {
        QFETCH(int, kind);
        std::mt19937 random(unsigned(200 + kind));
        std::normal_distribution<double> normal;
        int hit = 0, lines = 0, left_out = 0;
        for (int n = 0; n < 400; ++n) { // quick enough under a sanitizer
            const Case k = random_case(kind, n, random);
            const TurnedBody body(k.profile);
            const SweepRays swept(body, k.move, k.u);
            Vec3 step = Vec3(normal(random), normal(random), normal(random)).normalized();
            if (n % 3 == 1) step = k.u.unitOrthogonal();
            if (n % 3 == 2) step = Vec3::Unit(n / 3 % 3);
            const int count = 1 + n % SweepRow::lanes;
            const Vec3 p = k.p - 0.5 * count * step;
            const double low = n % 2 ? -infinity : -20, high = n % 2 ? infinity : 20;
            SweepRow::Flags wanted{};
            for (int i = 0; i < count; ++i)
                wanted[std::size_t(i)] = n % 5 != 0 || i % 2 == 0;
            // A stretch that is known, about where the tool comes by.
            std::array<float, SweepRow::lanes> known_lo{}, known_hi{};
            const bool knows = n % 4 == 1;
            for (int i = 0; knows && i < count; ++i) {
                const Stretch one = swept(p + i * step);
                const double from = one.empty() ? 0 : one.lo, to = one.empty() ? 1 : one.hi;
                known_lo[std::size_t(i)] = float(from + 0.1 * normal(random));
                known_hi[std::size_t(i)] = float(to + 0.1 * normal(random));
            }
            SweepRow row;
            row.ask(swept, p, step, count, low, high, wanted, knows ? known_lo.data() : nullptr,
                    knows ? known_hi.data() : nullptr);
            for (int i = 0; i < count; ++i) {
                if (!wanted[std::size_t(i)]) continue;
                const Stretch one = swept(p + i * step);
                Stretch got{row.lo[std::size_t(i)], row.hi[std::size_t(i)]};
                const auto within = [&](const Stretch& s) {
                    return Stretch{std::max(s.lo, low), std::min(s.hi, high)};
                };
                const Stretch a = within(one), b = within(got);
                ++lines;
                if (knows && b.empty() && !a.empty() && a.lo >= known_lo[std::size_t(i)]
                    && a.hi <= known_hi[std::size_t(i)]) {
                    ++left_out;
                    continue;
                }
                hit += a.empty() ? 0 : 1;
                // Lines that graze meet the tool or not by rounding.
                const bool same = a.empty() || b.empty()
                                      ? (a.empty() || a.hi - a.lo < 1e-5) && (b.empty() || b.hi - b.lo < 1e-5)
                                      : std::abs(a.lo - b.lo) < 1e-9 && std::abs(a.hi - b.hi) < 1e-9;
                QVERIFY2(same, qPrintable(QString("case %1, line %2: %3 %4 against %5 %6")
                                              .arg(n)
                                              .arg(i)
                                              .arg(got.lo, 0, 'g', 12)
                                              .arg(got.hi, 0, 'g', 12)
                                              .arg(one.lo, 0, 'g', 12)
                                              .arg(one.hi, 0, 'g', 12)));
            }
        }
        QVERIFY(hit > lines / 5);
        // Where hardly more than the ends is met, the outline tells nothing.
        const bool has_outline = kind != 3 && kind != 4 && kind != 7;
        QVERIFY2(!has_outline || left_out > 5, qPrintable(QString::number(left_out)));
    }

    void lines_through_a_point_are_not_lost() {
        std::mt19937 random(17);
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> share(0, 1);
        const double half = radians(35);
        const TurnedBody body{CutterProfile(AptCutter::cone(12, half))};
        for (int n = 0; n < trials(20000); ++n) {
            // Through the tip, or by a hair beside it, into the cone.
            const double lean = 0.9 * half * share(random), turn = 2 * pi * share(random);
            const Vec3 u(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean));
            const double hair = n % 2 ? 0 : 1e-9;
            const Vec3 p = hair * Vec3(normal(random), normal(random), 0) - 20 * share(random) * u;
            const Stretch s = body.along(p, u);
            const double tip = -p.z() / u.z();
            QVERIFY2(std::abs(s.lo - tip) < 1e-6 && s.hi > s.lo + 5,
                     qPrintable(
                         QString("case %1: %2 to %3, the tip is at %4").arg(n).arg(s.lo).arg(s.hi).arg(tip)));
        }
    }

    void turning_motion_stays_within_its_bound() {
        std::mt19937 random(7);
        std::normal_distribution<double> normal;
        const auto unit = [&] { return Vec3(normal(random), normal(random), normal(random)).normalized(); };
        for (int n = 0; n < 40; ++n) {
            const CutterLocation a{10 * unit(), unit()};
            CutterLocation b{a.tip + 3 * unit(), Vec3(a.axis + 0.3 * unit()).normalized()};
            std::optional<TurningAxis> turning;
            if (n % 2) {
                turning = TurningAxis{unit(), unit()};
                const Eigen::AngleAxisd turn(0.2, turning->direction);
                b = {turning->point + turn * (a.tip - turning->point) + 0.5 * unit(), turn * a.axis};
            }
            const double reach = 30, bound = 0.02;
            std::vector<StraightMove> moves;
            straight_moves(a, b, turning, 0, 1, reach, bound, moves);
            QVERIFY(moves.size() > 1);
            QVERIFY((moves.front().from - a.tip).norm() < 1e-12 && (moves.back().to - b.tip).norm() < 1e-12);
            for (std::size_t i = 0; i < moves.size(); ++i)
                for (int j = 0; j <= 10; ++j) {
                    const double part = 0.1 * j;
                    const CutterLocation there =
                        location_between(a, b, turning, (double(i) + part) / double(moves.size()));
                    const Vec3 tip = moves[i].from + part * (moves[i].to - moves[i].from);
                    // The farthest point of all that turn with the axis.
                    const double off = (there.tip - tip).norm() + reach * (there.axis - moves[i].axis).norm();
                    QVERIFY(off <= bound * 1.01);
                }
        }
    }
};

FACETMILL_TEST(TestSweep)
#include "test_sweep.moc"
