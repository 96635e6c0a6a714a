// The step-over of tilted cutters against closed forms, and against a search for what is left between passes
// that knows nothing of widths: a flat end holds a point of the surface raised by the tolerance where the
// point is above the end's plane and no farther from the axis than the radius.
#include "core/strategy/five_axis/partial_passes.h"
#include "core/strategy/five_axis/pass_placement.h"
#include "core/strategy/five_axis/strip_width.h"
#include "core/strategy/five_axis/tilted_stepover.h"
#include "tests/property/shapes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double radius = 3, tolerance_mm = 0.05;

using Surface = std::function<double(double, double)>;

/// Travel along X, so that u is x and v is y. With the posture cm2 no yaw is tried.
Finish5Settings settings(double lead_lo, double lead_hi) {
    Finish5Settings s;
    s.tolerance = tolerance_mm;
    s.direction = {0, "x"};
    s.posture = Finish5Settings::PostureChoice::cm2;
    s.lead_limits = {radians(lead_lo), radians(lead_hi)};
    return s;
}

/// A sheet from -half to half, with the step-over of a tool over it.
struct Bench {
    Surface f;
    PlanContext context;
    std::optional<FiveAxisField> field;
    std::optional<TiltedStepOver> stepover;

    Bench(Surface surface, const Vec2& half, const Tool& tool, const Finish5Settings& s, double leave = 0)
        : f(std::move(surface)),
          context(context_of(height_field(f, -half, half, int(4 * half.x()), int(16 * half.y())), tool)) {
        context.machine = find_machine("tarus-tpi-2000");
        field.emplace(context, s, Progress());
        stepover.emplace(*field, leave);
    }
    long plane(double v) const { return std::lround((v - field->lines().lo()) / field->lines().spacing()); }
    EstimatedPass pass(double v) const { return stepover->estimate(plane(v), 1, Progress()); }
    /// What widths are measured with: what may stay without what motions may run beside.
    double raise() const { return field->cusp() - field->chord(); }

    Vec3 raised(double x, double y, double by) const {
        const double h = 1e-5;
        const Vec3 normal(-(f(x + h, y) - f(x - h, y)) / (2 * h), -(f(x, y + h) - f(x, y - h)) / (2 * h), 1);
        return Vec3(x, y, f(x, y)) + by * normal.normalized();
    }

    /// Whether the flat end holds a point somewhere along a pass: its poses from contact to contact.
    bool holds(const EstimatedPass& pass, const Vec3& point) const {
        constexpr int parts = 60;
        for (const auto& contacts : pass.contacts) {
            std::optional<ToolPose> last;
            for (const EstimatedContact& c : contacts) {
                const ToolPose pose = posture_pose(field->cutter(), c.place.frame, c.posture);
                for (int k = last ? 1 : parts; k <= parts; ++k) {
                    const double t = double(k) / parts;
                    const Vec3 tip = last ? Vec3(last->tip + t * (pose.tip - last->tip)) : pose.tip;
                    const Vec3 axis =
                        last ? Vec3(last->axis + t * (pose.axis - last->axis)).normalized() : pose.axis;
                    const Vec3 from = point - tip;
                    const double z = from.dot(axis);
                    if (z >= 0 && (from - z * axis).norm() <= radius) return true;
                }
                last = pose;
            }
        }
        return false;
    }
    /// How many of some points of the line x = `x` between two v no pass holds; raised by all that may stay.
    int left_between(const std::vector<const EstimatedPass*>& passes, double x, double v0, double v1) const {
        constexpr int looks = 40;
        int left = 0;
        for (int i = 0; i <= looks; ++i) {
            const Vec3 point = raised(x, v0 + (v1 - v0) * i / looks, field->cusp());
            left += std::none_of(passes.begin(), passes.end(),
                                 [&](const EstimatedPass* p) { return holds(*p, point); });
        }
        return left;
    }
};

double level(double, double) {
    return 0;
}

/// Where a function that is above 0 at 0 comes down to 0 first.
double root(const std::function<double(double)>& f, double hi) {
    double lo = 0;
    for (int i = 0; i < 60; ++i)
        (f(0.5 * (lo + hi)) >= 0 ? lo : hi) = 0.5 * (lo + hi);
    return lo;
}

/// How high above the end of a flat cutter a point beside the contact lies at best, along the axis, on a part
/// that is the same all along the travel: `y` across the travel, `z` along the normal.
double flat_margin(double lead, double y, double z) {
    const double square = radius * radius - y * y;
    return square < 0 ? -1 : z / std::cos(lead) + std::tan(lead) * (std::sqrt(square) - radius);
}
/// The same for a ball, whatever its lead; not a height, but of its sign.
double ball_margin(double y, double z) {
    return radius * radius - y * y - (z - radius) * (z - radius);
}

} // namespace

class TestTiltedStepOver : public QObject {
    Q_OBJECT
private slots:
    void widths_are_those_of_closed_forms_data() {
        QTest::addColumn<bool>("ball");
        QTest::addColumn<double>("lead");
        QTest::addColumn<double>("hollow"); // of the part across the travel, 1/mm
        for (const double hollow : {0.0, -1.0 / 20, -1.0 / 60, 1.0 / 40}) {
            const auto row = [&](bool ball, double lead) {
                QTest::addRow("%s, lead %g, hollow %.3f", ball ? "ball" : "flat", lead, hollow)
                    << ball << lead << hollow;
            };
            row(false, 5);
            row(false, 20);
            row(true, 0);
            row(true, 30);
        }
    }
    /// A plane and cylinders about the travel. The width is a lattice plane at most 0.95 of the closed form
    /// away, and short of it by no more than the looks are coarse.
    void widths_are_those_of_closed_forms() {
        QFETCH(bool, ball);
        QFETCH(double, lead);
        QFETCH(double, hollow);
        const Surface f = [=](double, double y) {
            if (hollow == 0) return 0.0;
            const double r = 1 / std::abs(hollow);
            return (hollow > 0 ? 1 : -1) * (r - std::sqrt(r * r - y * y));
        };
        const Bench bench(f, Vec2(8, 7), ball ? ball_tool(2 * radius) : flat_tool(2 * radius),
                          settings(lead, lead));
        const double angle = radians(lead), r = hollow == 0 ? 0 : 1 / hollow, tau = bench.raise();
        const auto margin = [&](double v) {
            // The surface at v, raised along its normal.
            const double y = hollow == 0 ? v : v * (1 - tau / r);
            const double z =
                hollow == 0 ? tau : r - std::copysign(std::sqrt(r * r - v * v), r) * (1 - tau / r);
            return ball ? ball_margin(y, z) : flat_margin(angle, y, z);
        };
        const double wide = std::min(root(margin, radius), StripWidth::max_width(*bench.field));
        const double spacing = bench.field->lines().spacing();
        const double look = double(StripWidth::planes_apart(*bench.field)) * spacing;
        const EstimatedPass pass = bench.pass(0);
        int seen = 0;
        for (const auto& contacts : pass.contacts)
            for (const EstimatedContact& c : contacts) {
                if (std::abs(c.place.u) > 4) continue;
                ++seen;
                QVERIFY(c.usable && !c.left);
                QCOMPARE(c.posture.lead, angle);
                for (const double width : {c.width_lo, c.width_hi})
                    QVERIFY2(width <= StripWidth::used_width * wide * (1 + 1e-3) + 1e-9
                                 && width >= StripWidth::used_width * (wide - look) - spacing,
                             qPrintable(QString("%1 of %2").arg(width).arg(wide)));
            }
        QVERIFY(seen >= 5);
    }

    /// The widths of two passes add up to the step, and no more.
    void a_level_step_is_two_widths() {
        const Bench bench(level, Vec2(8, 10), flat_tool(2 * radius), settings(10, 10));
        const EstimatedPass last = bench.pass(-4);
        const auto step = bench.stepover->next(&last, -1, 1.0, Progress());
        QVERIFY(step.satisfied);
        const std::size_t middle = bench.stepover->bins().at(0);
        const double both = last.width_hi[middle] + step.pass.width_lo[middle], gap = step.pass.v - last.v;
        QVERIFY2(gap <= both && gap >= 0.98 * both - 2 * bench.field->lines().spacing(),
                 qPrintable(QString("%1 of %2").arg(gap).arg(both)));
        // Where two strips are as wide, their border is half-way.
        const double border = bench.stepover->border(last, step.pass, middle);
        QVERIFY(std::abs(border - 0.5 * (last.v + step.pass.v)) <= bench.field->lines().spacing());
    }

    void nothing_stays_between_two_passes_data() {
        QTest::addColumn<double>("v");
        for (const double v : {-5.0, -2.5, 0.0, 2.5})
            QTest::addRow("%g", v) << v;
    }
    /// Waves across the travel: round places and hollow ones, widths that differ on either side.
    void nothing_stays_between_two_passes() {
        QFETCH(double, v);
        const Bench bench([](double, double y) { return 1.2 * std::sin(0.35 * y); }, Vec2(8, 12),
                          flat_tool(2 * radius), settings(0, 45));
        const EstimatedPass last = bench.pass(v);
        const auto step = bench.stepover->next(&last, 1, 2.0, Progress());
        QVERIFY(step.satisfied);
        const EstimatedPass& next = step.pass;
        for (const double x : {-2.0, 0.0, 1.7})
            QCOMPARE(bench.left_between({&last, &next}, x, last.v, next.v), 0);
        // One of them is not enough, and so is not both at a larger step: the look sees what is left.
        QVERIFY(bench.left_between({&last}, 0, last.v, next.v) > 0);
        const double gap = next.v - last.v;
        const EstimatedPass far = bench.pass(last.v + 1.35 * gap);
        QVERIFY(!bench.stepover->fits(&last, &far, bench.stepover->bins().all()));
        QVERIFY2(bench.left_between({&last, &far}, 0, last.v, far.v) > 0, qPrintable(QString::number(gap)));
    }

    /// One line tells that a width is no larger, and is right.
    void what_a_width_cannot_exceed_it_does_not() {
        const Bench bench([](double, double y) { return 1.2 * std::sin(0.35 * y); }, Vec2(8, 12),
                          flat_tool(2 * radius), settings(0, 45));
        int told = 0, wider = 0;
        for (const auto& contacts : bench.pass(-1).contacts)
            for (const EstimatedContact& c : contacts) {
                StripWidth width(*bench.field, c.place);
                for (const double lead : {0.0, 0.1, 0.4})
                    for (const double yaw : {-0.5, 0.0, 0.5})
                        for (const double most : {0.2, 0.9, 1.6, 2.5})
                            for (const int side : {-1, 1}) {
                                const auto at = width.standing({lead, yaw, 0.01});
                                const bool may = width.may_exceed(at, side, most);
                                const double is = width(at, side).width;
                                QVERIFY2(may || is <= most,
                                         qPrintable(QString("%1 of %2").arg(is).arg(most)));
                                told += !may;
                                wider += is > most;
                            }
            }
        QVERIFY(told > 100 && wider > 100);
    }

    /// Where contacts are asked first saves time and nothing else.
    void a_step_does_not_depend_on_where_it_is_asked_first() {
        Finish5Settings s = settings(0, 45);
        s.posture = Finish5Settings::PostureChoice::global;
        s.yaw_limits = {radians(-15), radians(15)};
        const Bench bench(
            [](double x, double y) { return std::sin(0.35 * y) * (x > 2 ? 1.5 : 0.6 + 0.1 * x); },
            Vec2(10, 12), flat_tool(2 * radius), s);
        EstimatedPass last = bench.pass(-3);
        last.hardest_u = std::numeric_limits<double>::quiet_NaN();
        const auto step = bench.stepover->next(&last, 1, 3.0, Progress());
        QVERIFY(step.satisfied && !std::isnan(step.pass.hardest_u));
        for (const double u : {-9.0, 0.0, 4.0, step.pass.hardest_u}) {
            last.hardest_u = u;
            const auto same = bench.stepover->next(&last, 1, 3.0, Progress());
            QCOMPARE(same.pass.plane, step.pass.plane);
            QCOMPARE(same.pass.width_lo, step.pass.width_lo);
            QCOMPARE(same.pass.width_hi, step.pass.width_hi);
        }
    }

    /// Each strip ends within the width that its pass has to that side.
    void borders_lie_within_both_widths() {
        const Bench bench([](double, double y) { return 1.2 * std::sin(0.35 * y); }, Vec2(8, 12),
                          flat_tool(2 * radius), settings(0, 45));
        const EstimatedPass last = bench.pass(1);
        const EstimatedPass next = bench.stepover->next(&last, 1, 2.0, Progress()).pass;
        const auto borders = bench.stepover->borders(last, next);
        const double spacing = bench.field->lines().spacing();
        QCOMPARE(borders.size(), bench.stepover->bins().count());
        for (std::size_t i = 0; i < borders.size(); ++i) {
            QVERIFY(borders[i] - last.v <= last.width_hi[i] + 1e-9);
            QVERIFY(next.v - borders[i] <= next.width_lo[i] + spacing + 1e-9);
        }
    }

    /// Strips narrower than what is left to others ask for nothing: the next pass is as far as any may be.
    void what_is_left_to_others_asks_for_nothing() {
        const Surface ridge = [](double, double y) { return -std::sqrt(100 + 4 * y * y); };
        const Tool tool = flat_tool(2 * radius);
        const Bench all(ridge, Vec2(8, 8), tool, settings(10, 10)),
            left(ridge, Vec2(8, 8), tool, settings(10, 10), 100);
        const EstimatedPass a = all.pass(-3), b = left.pass(-3);
        const auto near = all.stepover->next(&a, 1, 1.0, Progress()),
                   far = left.stepover->next(&b, 1, 1.0, Progress());
        QVERIFY(near.satisfied && far.satisfied);
        QVERIFY(far.pass.v - b.v > 1.5 * (near.pass.v - a.v));
        for (const auto& contacts : b.contacts)
            for (const EstimatedContact& c : contacts)
                QVERIFY(c.left);
    }

    /// Partial passes over a hump on a plain: they stand at the hump, strips follow each other without a gap,
    /// and nothing is left.
    void partial_passes_fill_the_gap() {
        const double from = 20;
        const Bench bench(
            [=](double x, double y) { return 1.5 * std::exp(-(std::pow(x + from, 2) + y * y) / 20); },
            Vec2(32, 9), flat_tool(2 * radius), settings(0, 45));
        const TravelBins& bins = bench.stepover->bins();
        PartialPasses partial(*bench.stepover, true);
        const EstimatedPass last = bench.pass(-2);
        const PassGap gap = partial.next(last, 2.4, Progress());
        QVERIFY(gap.satisfied && gap.next && !gap.partial.empty());
        QCOMPARE(gap.next->travel, -1);
        for (const PartialPass& p : gap.partial) {
            QVERIFY(p.pass.v > last.v && p.pass.v < gap.next->v);
            QVERIFY2(bins.begin(p.bins.last + 1) < 0, "it stands where the hump is not");
        }
        int looked = 0;
        for (std::size_t i = bins.at(-28); i <= bins.at(28); ++i) {
            std::vector<const EstimatedPass*> here{&last};
            double end = gap.border_lo[i];
            for (const PartialPass& p : gap.partial) {
                if (i < p.bins.first || i > p.bins.last) {
                    QVERIFY(p.border_lo[i] == p.pass.v && p.border_hi[i] == p.pass.v);
                    continue;
                }
                QCOMPARE(p.border_lo[i], end);
                QVERIFY(p.border_hi[i] >= p.pass.v);
                end = p.border_hi[i];
                here.push_back(&p.pass);
            }
            QCOMPARE(gap.border_hi[i], end);
            here.push_back(&*gap.next);
            const double x = bins.begin(i) + 0.5 * bins.width();
            QCOMPARE(bench.left_between(here, x, last.v, gap.next->v), 0);
            if (here.size() > 2)
                looked += bench.left_between({&last, &*gap.next}, x, last.v, gap.next->v) > 0;
        }
        QVERIFY(looked > 0); // without the partial ones something is left
    }

    /// A hump, and a pit that the tool does not enter: full passes are farther apart since partial ones serve
    /// the hump, but beside the pit no farther than full passes alone would be.
    void passes_come_near_what_has_no_posture() {
        const Bench bench(
            [](double x, double y) {
                return 1.5 * std::exp(-(std::pow(x + 20, 2) + y * y) / 20)
                       - 2 * std::exp(-(std::pow(x - 15, 2) + std::pow(y + 2, 2)) / 0.5);
            },
            Vec2(32, 9), flat_tool(2 * radius), settings(0, 45));
        const EstimatedPass last = bench.pass(-2);
        const double whole = bench.stepover->next(&last, -1, 2.4, Progress()).pass.v - last.v;
        const PassGap gap = PartialPasses(*bench.stepover, true, 0.1).next(last, 2.4, Progress());
        QVERIFY(gap.satisfied && gap.next && gap.next->v - last.v > 1.2 * whole);
        int looked = 0;
        for (std::size_t i = 0; i < bench.stepover->bins().count(); ++i) {
            if (!last.unfree[i]) continue;
            ++looked;
            double from = last.v;
            for (const PartialPass& p : gap.partial) {
                if (i < p.bins.first || i > p.bins.last) continue;
                QVERIFY2(p.pass.v - from <= whole + 1e-9, qPrintable(QString("%1 of %2, next %3")
                                                                         .arg(p.pass.v - from)
                                                                         .arg(whole)
                                                                         .arg(gap.next->v - last.v)));
                from = p.pass.v;
                // The pit ends where the next pass has postures.
                if (!p.pass.unfree[i]) break;
            }
            QVERIFY2(from > last.v, "no pass comes near the pit");
        }
        QVERIFY(looked > 0);
    }

    /// A step that whole passes are as good for is theirs: partial ones have to save a tenth of the travel.
    void partial_passes_save_a_tenth() {
        const Bench bench([](double x, double) { return 0.002 * x * x; }, Vec2(12, 9), flat_tool(2 * radius),
                          settings(0, 45));
        const EstimatedPass last = bench.pass(-4);
        const auto whole = bench.stepover->next(&last, -1, 2.4, Progress());
        const PassGap gap = PartialPasses(*bench.stepover, true, 0.1).next(last, 2.4, Progress());
        QVERIFY(gap.next && gap.partial.empty());
        QCOMPARE(gap.next->plane, whole.pass.plane);
    }

    /// A placed pass clears what its borders say, begins and ends beyond the part, and goes as it travels.
    void a_placed_pass_takes_its_strip_along() {
        const Bench bench(level, Vec2(8, 10), flat_tool(2 * radius), settings(10, 10));
        const PassEstimator& passes = bench.stepover->passes();
        for (const int travel : {1, -1}) {
            const EstimatedPass pass = bench.stepover->estimate(bench.plane(0), travel, Progress());
            const std::vector<double> lo(passes.bins().count(), pass.v - 1), hi(lo.size(), pass.v + 0.5);
            const auto lines = place_pass(*bench.field, passes, pass, lo, hi);
            QCOMPARE(lines.size(), std::size_t(1));
            const auto& places = lines[0].places;
            QVERIFY(travel * places.front().u <= -8 + 1e-9 && travel * places.back().u > 8);
            for (std::size_t i = 0; i < places.size(); ++i) {
                QVERIFY(i == 0 || travel * (places[i].u - places[i - 1].u) > 0);
                QCOMPARE(places[i].v_lo, pass.v - 1);
                QCOMPARE(places[i].v_hi, pass.v + 0.5);
            }
        }
    }
};

FACETMILL_TEST(TestTiltedStepOver)
#include "test_tilted_stepover.moc"
