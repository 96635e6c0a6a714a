// Paths in colours: the values behind them against closed forms and the machine model, their scale, and that
// the colours are to be found in the picture.
#include "core/job/planner.h"
#include "core/output/motion_time.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "tests/screenshot/scene_parts.h"
#include "tests/support/picture_compare.h"
#include "tests/support/test_runner.h"
#include "viz/offscreen.h"
#include "viz/overlay.h"
#include "viz/palette.h"
#include "viz/path_tint.h"
#include "viz/render_picture.h"
#include "viz/round_ticks.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double feed = 600; // mm/min

/// Passes over the hill; with five axes the tool leans to and fro along each of them.
std::shared_ptr<const OperationResult> hill_operation(int passes, int points, bool five_axes) {
    const PathSource source = hill_path(passes, points, 6);
    auto result = std::make_shared<OperationResult>();
    result->name = "Hill";
    result->path = *source.contacts;
    ClSection& program = result->program;
    program.motions = *source.motions;
    program.feed_mm_per_min = feed;
    program.multi_axis = five_axes;
    program.part_box = {{0, 0, 0}, {hill_length, hill_width, 20}};
    program.gauge_length = 80;
    if (five_axes)
        for (Motion& m : program.motions.motions)
            m.to.axis = Vec3(0.4 * std::sin(m.to.tip.x() / 8), 0.2, 1).normalized();
    return result;
}

std::vector<PathFiguresPtr> figures_of(const std::shared_ptr<const OperationResult>& result,
                                       const char* machine) {
    return {path_figures(result, find_machine(machine), {})};
}

std::size_t count_tinted(const Picture& p, const Rgb& c, int within) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < p.rgb.size(); i += 3)
        n += std::abs(p.rgb[i] - 255 * c.r) <= within && std::abs(p.rgb[i + 1] - 255 * c.g) <= within
             && std::abs(p.rgb[i + 2] - 255 * c.b) <= within;
    return n;
}

std::size_t cuts(const OperationResult& result) {
    const auto& motions = result.program.motions.motions;
    return std::size_t(std::count_if(motions.begin(), motions.end(),
                                     [](const Motion& m) { return m.kind == MotionKind::cut; }));
}

} // namespace

class TestPathTint : public QObject {
    Q_OBJECT

    OffscreenWindow window_;

private slots:
    void ticks_are_round() {
        QCOMPARE(round_step(1, 5), 0.2);
        QCOMPARE(round_step(0.9, 3), 0.5);
        QCOMPARE(round_step(7300, 8), 1000.0);
        QCOMPARE(round_step(0, 5), 1.0);
        const auto ticks = round_ticks(-0.25, 0.61, 5);
        QCOMPARE(ticks.size(), std::size_t(5));
        QCOMPARE(ticks.front(), -0.2);
        QCOMPARE(ticks[1], 0.0);
        for (int i = 1; i < 400; ++i) {
            const double lo = -50.0 + 0.37 * i, hi = lo + std::pow(1.06, i - 200);
            const auto all = round_ticks(lo, hi, 6);
            QVERIFY(all.size() <= 7);
            for (const double v : all)
                QVERIFY(v >= lo - 1e-5 * (hi - lo) && v <= hi + 1e-5 * (hi - lo));
        }
    }

    void figures_are_those_of_the_machine() {
        for (const char* machine : {"tarus-tpi-2000", "trunnion-bc", "generic-4-axis-a", "generic-3-axis"}) {
            const bool five = find_machine(machine).rotary.size() == 2;
            const auto result = hill_operation(9, 40, five);
            const auto figures = figures_of(result, machine);
            const PathFigures& f = *figures.front();
            const MachineMotion run = machine_motion(result->program, find_machine(machine));
            const auto& motions = result->program.motions.motions;
            QCOMPARE(f.motions(), motions.size());
            QVERIFY(std::abs(f.elapsed.back() - run.time_seconds) < 1e-9 * run.time_seconds);
            double length = 0;
            for (std::size_t m = 1; m < motions.size(); ++m) {
                length += (motions[m].to.tip - motions[m - 1].to.tip).norm();
                QVERIFY(std::abs(f.length[m] - length) <= 1e-9 * length);
                if (motions[m].kind != MotionKind::rapid && std::isfinite(f.feed[m]))
                    QVERIFY(f.feed[m] <= feed * (1 + 1e-9));
                if (std::isfinite(f.joint_rate[m])) QVERIFY(f.joint_rate[m] <= 1 + 1e-9);
            }
            std::size_t turns = 0;
            for (std::size_t r = 0; r < 2; ++r) {
                QCOMPARE(f.reversals[r].size(),
                         r < find_machine(machine).rotary.size() ? run.reversals[3 + r] : std::size_t(0));
                QVERIFY(std::is_sorted(f.reversals[r].begin(), f.reversals[r].end()));
                turns += f.reversals[r].size();
                for (const std::size_t m : f.reversals[r]) {
                    // There it is farther out than on either side.
                    std::size_t after = m + 1, before = m - 1;
                    while (std::abs(f.rotary[r][after] - f.rotary[r][m]) < 1e-6)
                        ++after;
                    while (std::abs(f.rotary[r][before] - f.rotary[r][m]) < 1e-6)
                        --before;
                    QVERIFY((f.rotary[r][after] > f.rotary[r][m]) == (f.rotary[r][before] > f.rotary[r][m]));
                }
            }
            QCOMPARE(turns > 0, five);
        }
    }

    void values_are_what_they_say() {
        const auto result = hill_operation(9, 40, false);
        const auto figures = figures_of(result, "generic-3-axis");
        const auto of = [&](PathQuantity q, LengthUnit unit = LengthUnit::mm) {
            return prepare_tinted_path(figures, q, unit, {});
        };
        const auto cut = std::size_t(MotionKind::cut), rapid = std::size_t(MotionKind::rapid);
        QVERIFY(!of(PathQuantity::kind));
        QVERIFY(!of(PathQuantity::tilt)); // upright everywhere
        QVERIFY(!of(PathQuantity::cusp)); // not kept
        QVERIFY(!path_quantity_missing(PathQuantity::tilt, *result).empty());
        QVERIFY(!path_quantity_missing(PathQuantity::cusp, *result).empty());
        for (const PathQuantity q : {PathQuantity::lead, PathQuantity::feed, PathQuantity::motion_time,
                                     PathQuantity::elapsed, PathQuantity::joint_rate}) {
            QVERIFY(path_quantity_missing(q, *result).empty());
            const auto path = of(q);
            QVERIFY(path && path->low < path->high && !path->unit.empty());
            const TintedPath::Lines& lines = path->lines[cut];
            QCOMPARE(lines.values.size(), 2 * cuts(*result));
            QCOMPARE(lines.points.size(), 3 * lines.values.size());
            QCOMPARE(lines.rgba.size(), 4 * lines.values.size());
            QVERIFY(path->lines[rapid].empty());
            QCOMPARE(path->lines[std::size_t(MotionKind::link)].empty(), q == PathQuantity::lead);
            QVERIFY(!path->bar().title.empty());
            QVERIFY(path->bar().marks.front().first == 0 && path->bar().marks.back().first == 1);
        }
        // Lead: the slope of the hill, as the axis is upright.
        const auto lead = of(PathQuantity::lead);
        const auto& motions = result->program.motions.motions;
        std::size_t i = 0;
        for (const Motion& m : motions) {
            if (m.kind != MotionKind::cut) continue;
            const Vec3& n = result->path.passes[m.pass].cc[m.point].normal;
            QVERIFY(std::abs(double(lead->lines[cut].values[2 * i + 1]) - degrees(std::acos(n.z()))) < 1e-3);
            ++i;
        }
        // Feed: all of it, in the unit asked for.
        const auto reached = of(PathQuantity::feed);
        for (const float v : reached->lines[cut].values)
            QVERIFY(std::abs(v - feed) < 1e-3 * feed);
        const auto inches = of(PathQuantity::feed, LengthUnit::inch);
        QCOMPARE(inches->unit, std::string("in/min"));
        QVERIFY(std::abs(double(inches->lines[cut].values[0]) - feed / 25.4) < 1e-3);
        // Time grows along the path, and is the whole one at its end.
        const auto elapsed = of(PathQuantity::elapsed);
        const auto& times = elapsed->lines[cut].values;
        QVERIFY(std::is_sorted(times.begin(), times.end()));
        QCOMPARE(elapsed->unit, std::string("s"));
        QVERIFY(double(times.back()) <= figures.front()->elapsed.back() * (1 + 1e-6));
        // With five axes there is a tilt.
        const auto five = hill_operation(5, 40, true);
        const auto tilt =
            prepare_tinted_path(figures_of(five, "tarus-tpi-2000"), PathQuantity::tilt, LengthUnit::mm, {});
        QVERIFY(tilt);
        i = 0;
        for (const Motion& m : five->program.motions.motions)
            if (m.kind == MotionKind::cut)
                QVERIFY(
                    std::abs(double(tilt->lines[cut].values[2 * i++ + 1]) - degrees(std::acos(m.to.axis.z())))
                    < 1e-3);
    }

    void single_values_far_off_do_not_take_the_scale() {
        auto result = std::make_shared<OperationResult>(*hill_operation(9, 120, false));
        auto& motions = result->program.motions.motions;
        for (std::size_t m = 1; m < motions.size(); ++m) // one long motion among short ones
            if (motions[m].kind == MotionKind::cut && motions[m].point == 60 && motions[m].pass == 4)
                motions[m].to.tip.z() += 300;
        const auto path = prepare_tinted_path(figures_of(result, "generic-3-axis"), PathQuantity::motion_time,
                                              LengthUnit::mm, {});
        const auto& values = path->lines[std::size_t(MotionKind::cut)].values;
        QVERIFY(*std::max_element(values.begin(), values.end()) > 10);
        QVERIFY(path->high < 5);
        QVERIFY(path->above && path->bar().has_above);
    }

    void colors_get_lighter() {
        double before = -1;
        for (int i = 0; i <= 100; ++i) {
            const Rgb c = path_tint_color(i / 100.0);
            const double lightness = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
            QVERIFY(lightness > before);
            before = lightness;
        }
    }

    void the_picture_has_the_colors() {
        const auto result = hill_operation(15, 60, true);
        const auto figures = figures_of(result, "tarus-tpi-2000");
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 60, hill));
        scene.paths().set(prepare_path_display({path_source(result)}, {}));
        scene.set_visible(Layer::cc, false);
        window_.show(scene, 720, 540);
        scene.set_view(StandardView::iso);
        const Picture plain = window_.render();
        const Rgb blue = colors_of(Palette::light).motions[std::size_t(MotionKind::cut)];
        scene.paths().set_tint(prepare_tinted_path(figures, PathQuantity::tilt, LengthUnit::mm, {}));
        const Picture tinted = window_.render();
        QVERIFY(count_tinted(plain, blue, 30) > 300);
        QVERIFY(count_tinted(tinted, blue, 12) < 60);
        for (const double t : {0.05, 0.3, 0.5, 0.95})
            QVERIFY2(count_tinted(tinted, path_tint_color(t), 20) > 50, qPrintable(QString::number(t)));
        const std::string wrong = check_picture(tinted, "path-tilt", FACETMILL_PICTURE_OUT);
        QVERIFY2(wrong.empty(), wrong.c_str());
        // Hidden with the cuts, legend and all; gone with the next path.
        for (const MotionKind kind :
             {MotionKind::cut, MotionKind::link, MotionKind::approach, MotionKind::retract})
            scene.paths().set_visible(kind, false);
        QVERIFY(count_tinted(window_.render(), path_tint_color(0.95), 20) < 30);
        for (const MotionKind kind :
             {MotionKind::cut, MotionKind::link, MotionKind::approach, MotionKind::retract})
            scene.paths().set_visible(kind, true);
        scene.paths().set_tint(nullptr);
        QCOMPARE(different_pixels(plain, window_.render()), std::size_t(0));
        scene.paths().set_tint(prepare_tinted_path(figures, PathQuantity::feed, LengthUnit::mm, {}));
        scene.paths().set(prepare_path_display({path_source(result)}, {}));
        QCOMPARE(different_pixels(plain, window_.render()), std::size_t(0));
    }

    void what_is_left_and_what_is_kept_is_marked() {
        const auto result = std::make_shared<OperationResult>(*hill_operation(15, 60, true));
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 60, hill));
        scene.paths().set(prepare_path_display({path_source(result)}, {}));
        window_.show(scene, 720, 540);
        scene.set_view(StandardView::iso);
        const Colors& colors = colors_of(Palette::light);
        const Picture plain = window_.render();
        const auto shows = [&](const Rgb& color) { return count_tinted(window_.render(), color, 12); };
        const std::size_t left_before = shows(colors.left), kept_before = shows(colors.kept);

        const auto at = [](double x, double y) { return Vec3(x, y, hill(x, y)); };
        for (int i = 0; i < 12; ++i)
            result->path.cleanup.push_back({at(40 + i, 30), Vec3::UnitZ()});
        result->path.cleanup.push_back({Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0), Vec3::UnitZ()});
        auto record = std::make_shared<FiveAxisRecord>();
        record->points.resize(2);
        record->points[0].place.surface = at(70, 50);
        record->points[0].place.kept = {{0.1, 0.2}};
        record->points[1].place.surface = at(20, 20);
        TiltedPath tilted;
        tilted.record = record;
        result->path.detail = std::move(tilted);
        const auto path = prepare_path_display({path_source(result)}, {});
        QCOMPARE(path->left_points.size(), std::size_t(3 * 12));
        QCOMPARE(path->kept_points.size(), std::size_t(3));
        QVERIFY((Vec3(path->kept_points[0], path->kept_points[1], path->kept_points[2]) + path->center
                 - at(70, 50))
                    .norm()
                < 1e-4);
        scene.paths().set(path);
        QVERIFY(shows(colors.left) > left_before + 100);
        QVERIFY(shows(colors.kept) > kept_before + 20);
        const std::string wrong =
            check_picture(window_.render(), "path-left-and-kept", FACETMILL_PICTURE_OUT);
        QVERIFY2(wrong.empty(), wrong.c_str());
        scene.set_visible(Layer::cc, false);
        QVERIFY(shows(colors.left) > left_before + 100);
        scene.set_visible(Layer::cl, false);
        QVERIFY(shows(colors.left) <= left_before);
        scene.set_visible(Layer::cc, true);
        scene.set_visible(Layer::cl, true);
        scene.paths().set(prepare_path_display({path_source(hill_operation(15, 60, true))}, {}));
        QCOMPARE(different_pixels(plain, window_.render()), std::size_t(0));
    }

    void both_scales_stand_in_the_legend() {
        const auto result = hill_operation(15, 60, false);
        auto surface = std::make_shared<DeviationSurface>();
        for (const auto& [x, y] : {std::pair(0.f, 0.f), {100.f, 0.f}, {100.f, 80.f}}) {
            surface->points.push_back({x, y, 0.0f});
            surface->normals.push_back({0, 0, 1});
            surface->deviation.push_back(x / 1000 - 0.03f);
            surface->flags.push_back(DeviationSurface::counted);
        }
        surface->triangles = {{0, 1, 2}};
        Scene scene;
        scene.paths().set(prepare_path_display({path_source(result)}, {}));
        scene.deviation().set(prepare_deviation_display(surface, DeviationScale{}, {}));
        scene.paths().set_tint(prepare_tinted_path(figures_of(result, "generic-3-axis"), PathQuantity::lead,
                                                   LengthUnit::mm, {}));
        window_.show(scene, 720, 720);
        scene.set_view(StandardView::top);
        const Picture both = window_.render();
        const std::string wrong = check_picture(both, "path-lead-and-deviation", FACETMILL_PICTURE_OUT);
        QVERIFY2(wrong.empty(), wrong.c_str());
    }

    void a_long_path_moves_coarsely() {
        const auto result = hill_operation(60, 1500, false);
        const auto path =
            prepare_tinted_path(figures_of(result, "generic-3-axis"), PathQuantity::lead, LengthUnit::mm, {});
        const auto cut = std::size_t(MotionKind::cut);
        QVERIFY(!path->preview[cut].empty());
        QVERIFY(path->preview[cut].values.size() <= path->lines[cut].values.size() / 2 + 200);
        QCOMPARE(path->preview[cut].values.back(), path->lines[cut].values.back());
        Scene scene;
        scene.paths().set(prepare_path_display({path_source(result)}, {}));
        scene.paths().set_tint(path);
        scene.set_visible(Layer::cc, false);
        QVERIFY(scene.has_preview());
        window_.show(scene, 480, 360);
        scene.set_view(StandardView::top);
        const Picture still = window_.render();
        scene.set_moving(true);
        const Picture moving = window_.render();
        double sum = 0;
        for (std::size_t i = 0; i < still.rgb.size(); ++i)
            sum += std::abs(int(still.rgb[i]) - int(moving.rgb[i]));
        QVERIFY(sum > 0);
        QVERIFY2(sum / double(still.rgb.size()) < 4,
                 qPrintable(QString::number(sum / double(still.rgb.size()))));
        scene.set_moving(false);
        // In steps it is the same picture.
        const std::size_t steps = scene.begin_steps();
        for (std::size_t k = 0; k < steps; ++k) {
            scene.set_step(k);
            const Picture now = window_.render();
            if (k + 1 == steps) QCOMPARE(different_pixels(still, now), std::size_t(0));
        }
        scene.end_steps();
    }
};

FACETMILL_TEST(TestPathTint)
#include "test_path_tint.moc"
