// Arcs in posted programs: what stands for a run of motions, how controls are told, and that it reads back.
#include "core/output/post/arc.h"
#include "tests/support/error_code.h"
#include "tests/support/rs274.h"
#include "tests/support/test_runner.h"
#include "tests/unit/output/posted_parts.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Points = std::vector<Vec3>;

double distance_to_line(const Vec3& p, const Points& line) {
    double least = infinity;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 step = line[i] - line[i - 1], off = p - line[i - 1];
        const double square = step.squaredNorm();
        const double t = square > 0 ? std::clamp(off.dot(step) / square, 0.0, 1.0) : 0;
        least = std::min(least, (off - t * step).norm());
    }
    return least;
}

Points arc_points(const PlaneArc& arc, int count) {
    Points all;
    for (int k = 0; k <= count; ++k)
        all.push_back(arc.at(double(k) / count));
    return all;
}

Points tips(const ClSection& s) {
    Points all;
    for (const Motion& m : s.motions.motions)
        all.push_back(m.to.tip);
    return all;
}

/// linuxcnc with arcs by their radius.
std::string radius_post() {
    std::string text = find_post("linuxcnc").source;
    const auto change = [&](const std::string& from, const std::string& to) {
        if (text.find(from) == std::string::npos) qFatal("the test's text is not there: %s", from.c_str());
        text.replace(text.find(from), from.size(), to);
    };
    change(R"("kind": "centre")", R"("kind": "radius")");
    change(R"("i": "I")", R"("radius": "R", "i": "I")");
    return text;
}

Post arc_post(const std::string& name) {
    return name == "radius" ? parse_post(radius_post(), "radius.json") : find_post(name);
}

/// What was read back is on the planned route, and the planned places are on what was read back.
void check_route(const Points& run, const ClSection& section, const PostSetup& setup, double digit) {
    const Points planned = tips(section);
    for (const Vec3& p : run)
        QVERIFY2(distance_to_line(p, planned) < setup.arc_bulge + 2 * digit,
                 qPrintable(QString::number(distance_to_line(p, planned))));
    for (const Motion& m : section.motions.motions)
        if (m.kind != MotionKind::rapid)
            QVERIFY2(distance_to_line(m.to.tip, run) < setup.tip_tolerance + 2 * digit + 0.0005,
                     qPrintable(QString::number(distance_to_line(m.to.tip, run))));
}

} // namespace

class TestPostArcs : public QObject {
    Q_OBJECT
private slots:
    /// Both ways of telling an arc, against what turning is: the ends, the radius all along, and the side on
    /// which the centre lies while it runs.
    void arcs_are_what_controls_make_of_them() {
        std::mt19937_64 rng(3);
        std::uniform_real_distribution<double> any(-1, 1);
        for (int n = 0; n < 20000; ++n) {
            const int normal = int(rng() % 3), u = (normal + 1) % 3, v = (normal + 2) % 3;
            const double radius = std::pow(10, 2 + 3 * any(rng)), begin = pi * any(rng);
            double by = 2 * pi * any(rng);
            if (n % 10 == 0) by = by > 0 ? 2 * pi : -2 * pi;
            if (std::abs(by) < 1e-3) continue;
            const bool clockwise = by < 0;
            const Vec3 centre = 100 * Vec3(any(rng), any(rng), any(rng));
            const auto place = [&](double a, double up) {
                Vec3 p = centre;
                p[u] += radius * std::cos(a);
                p[v] += radius * std::sin(a);
                p[normal] += up;
                return p;
            };
            const Vec3 from = place(begin, 0);
            Vec3 to = place(begin + by, 5);
            if (n % 10 == 0) to[u] = from[u], to[v] = from[v];
            const PlaneArc arc = arc_about(from, to, centre, normal, clockwise);
            QVERIFY(std::abs(arc.angle - by) < 1e-6);
            QCOMPARE(arc.at(0), from);
            QCOMPARE(arc.at(1), to);
            for (const double t : {0.1, 0.37, 0.5, 0.93})
                QVERIFY((arc.at(t) - place(begin + t * by, 5 * t)).norm() < 1e-6 * (1 + radius));
            QVERIFY(std::abs(arc.length() - std::hypot(radius * by, 5)) < 1e-6 * (1 + radius));
            if (n % 10 == 0) {
                QVERIFY(!arc_with_radius(from, to, radius, normal, clockwise, 0));
                continue;
            }
            // Near half a turn and a whole one a radius does not say where the centre is.
            const double half = std::abs(std::remainder(by, pi));
            if (half < 0.1) continue;
            const auto same =
                arc_with_radius(from, to, std::abs(by) < pi ? radius : -radius, normal, clockwise, 1e-9);
            QVERIFY(same.has_value());
            QVERIFY((same->at(0.4) - arc.at(0.4)).norm() < 1e-5 * (1 + radius));
            QVERIFY(!arc_with_radius(from, to, 0.4 * (to - from)[u], normal, clockwise, 0)
                    || std::abs((to - from)[v]) < std::abs((to - from)[u]));
        }
    }

    /// Places on circles and off them by up to twice what is allowed, in planes and climbing: whatever is
    /// found keeps to the limits, looked at point by point, and what lies on a circle is found whole.
    void runs_keep_to_their_limits() {
        std::mt19937_64 rng(11);
        std::uniform_real_distribution<double> any(-1, 1);
        ArcLimits limits{.off = 0.002, .bulge = 0.006};
        std::size_t whole = 0, some = 0;
        for (int n = 0; n < 3000; ++n) {
            const int normal = int(rng() % 3), u = (normal + 1) % 3, v = (normal + 2) % 3;
            const double radius = std::pow(10, 1 + 1.7 * any(rng)), begin = pi * any(rng);
            const double most = std::min(0.9 * pi, 100 / radius),
                         by = most * (0.5 + 0.5 * any(rng)) * (n % 2 ? 1 : -1);
            const double step = 1.9 * std::acos(1 - std::min(0.5, 0.9 * limits.bulge / radius));
            const int steps = std::max(4, int(std::ceil(std::abs(by) / step)));
            const double noise = n % 3 == 0 ? 0 : 2 * limits.off * (0.5 + 0.5 * any(rng)),
                         climb = n % 4 == 0 ? 0 : 2 * any(rng);
            if (steps > 400 || std::abs(by) * radius < 0.2) continue;
            Points points;
            for (int k = 0; k <= steps; ++k) {
                const double t = double(k) / steps, r = radius + noise * any(rng);
                Vec3 p;
                p[u] = r * std::cos(begin + t * by);
                p[v] = r * std::sin(begin + t * by);
                p[normal] = t * climb + (n % 5 == 0 ? noise * any(rng) : 0);
                points.push_back(p);
            }
            const auto run = arc_run(points, limits);
            if (noise == 0) {
                QVERIFY2(run && run->motions + 1 == points.size(),
                         qPrintable(QString("%1: %2").arg(n).arg(run ? run->motions : 0)));
                ++whole;
            }
            if (!run) continue;
            some += noise > 0;
            const Points line(points.begin(), points.begin() + long(run->motions) + 1);
            QCOMPARE(run->arc.from, line.front());
            QCOMPARE(run->arc.to, line.back());
            for (const Vec3& p : arc_points(run->arc, int(5 * run->motions)))
                QVERIFY2(distance_to_line(p, line) < limits.bulge + 1e-4,
                         qPrintable(QString::number(distance_to_line(p, line))));
            const Points round = arc_points(run->arc, int(std::min(4000.0, 40 * double(run->motions))));
            for (const Vec3& p : line)
                QVERIFY2(distance_to_line(p, round) < limits.off + 1e-4,
                         qPrintable(QString::number(distance_to_line(p, round))));
        }
        QVERIFY2(whole > 300 && some > 300, qPrintable(QString("%1 %2").arg(whole).arg(some)));
    }

    void what_is_no_arc_stays_straight() {
        const ArcLimits limits{.off = 0.002, .bulge = 0.004, .smallest_radius = 0.5, .largest_radius = 500};
        const auto of = [&](const std::function<Vec3(double)>& place, double from, double to, int steps) {
            Points points;
            for (int k = 0; k <= steps; ++k)
                points.push_back(place(from + (to - from) * k / steps));
            return arc_run(points, limits);
        };
        const auto circle = [](double r) {
            return [r](double a) { return Vec3(r * std::cos(a), r * std::sin(a), 0); };
        };
        QVERIFY(of(circle(10), 0, 1, 40));
        QVERIFY(!of(circle(10), 0, 1, 2));      // two motions
        QVERIFY(!of(circle(10), 0, 1, 4));      // the arc would bulge
        QVERIFY(!of(circle(0.4), 0, 2, 40));    // too small
        QVERIFY(!of(circle(600), 0, 0.05, 40)); // too large
        QVERIFY(!of([](double a) { return Vec3(a, 2 * a, 0.5 * a); }, 0, 10, 20));
        QVERIFY(!of([](double) { return Vec3(1, 2, 3); }, 0, 1, 8));
        QVERIFY(
            !of([](double a) { return Vec3(a, std::fmod(std::round(a), 2) * 0.02, 0); }, 0, 8, 8)); // zigzag
        QVERIFY(!of([](double a) { return Vec3(std::cos(a), std::sin(2 * a), 0); }, 0, 2 * pi, 8));
        // There and back on the same circle: only the first way.
        const auto run = of([&](double a) { return circle(10)(a < 1 ? a : 2 - a); }, 0, 2, 80);
        QVERIFY(run && run->motions <= 41);
        // No more than half a turn each.
        const auto half = of(circle(10), 0, 2 * pi, 160);
        QVERIFY(half && half->motions <= 80 && half->motions > 60);
    }

    void programs_with_arcs_read_back_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<bool>("inch");
        for (const Post& p : posts())
            for (const bool inch : {false, true})
                if (p.arcs != Post::Arcs::none)
                    QTest::addRow("%s %s", p.name.c_str(), inch ? "in" : "mm")
                        << QString::fromStdString(p.name) << inch;
        QTest::newRow("by radius mm") << "radius" << false;
    }
    /// A firmware that runs arcs in coarse pieces is told none, and none is read as one.
    void marlin_has_no_arcs() {
        const Post& control = find_post("marlin");
        const ClProgram program = joined_program({round_section("Round", 1)});
        PostSetup setup = setup_for(program, "generic-3-axis");
        setup.arcs = true;
        const PostedProgram posted = post_program(program, control, setup, {});
        QCOMPARE(posted.arcs, std::size_t(0));
        std::string text = posted.text;
        text.replace(text.find("\nG1 "), 4, "\nG2 I5 ");
        std::string message;
        QVERIFY(code_of([&] { read_nc(text, "p", control, reading(program, setup), {}); }, &message)
                != "none");
        QVERIFY2(message.find("'G2' is no word") != std::string::npos, message.c_str());
    }

    /// Within the limits of the motions planned, both ways, in fewer blocks and in the same time.
    void programs_with_arcs_read_back() {
        QFETCH(QString, post);
        QFETCH(bool, inch);
        const Post control = arc_post(post.toStdString());
        const ClProgram program =
            joined_program({round_section("Round", 1)}, inch ? LengthUnit::inch : LengthUnit::mm);
        PostSetup setup = setup_for(program, "generic-3-axis");
        setup.arc_bulge = 0.01;
        const PostedProgram straight = post_program(program, control, setup, {});
        setup.arcs = true;
        const PostedProgram posted = post_program(program, control, setup, {});
        QVERIFY(posted.arcs >= 4 && posted.arcs < 60);
        QVERIFY(5 * posted.blocks < 4 * straight.blocks);
        const NcProgram read = read_nc(posted.text, "p", control, reading(program, setup), {});
        QCOMPARE(read.blocks, posted.blocks);
        const double digit =
            inch ? 25.4 * std::pow(10, -control.inch_decimals) : std::pow(10, -control.mm_decimals);
        Points run;
        for (const Motion& m : read.sections.front()->motions.motions)
            if (m.kind != MotionKind::rapid) run.push_back(m.to.tip);
        check_route(run, *program.sections.front(), setup, digit);
        if (QTest::currentTestFailed()) return;
        // Three decimals make a wave's short motions longer.
        QVERIFY2(std::abs(read.seconds - posted.seconds) < (digit < 0.001 ? 1e-3 : 2e-3) * posted.seconds,
                 qPrintable(QString("%1 %2").arg(read.seconds).arg(posted.seconds)));
        QVERIFY(std::abs(posted.seconds - straight.seconds) < 2e-3 * posted.seconds);
    }

    void tilted_planes_have_arcs_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<bool>("inch");
        for (const Post& p : posts())
            for (const char* machine : {"trunnion-ac", "head-b-table-c"})
                if (p.has_planes())
                    QTest::addRow("%s %s", p.name.c_str(), machine)
                        << QString::fromStdString(p.name) << QString(machine) << (p.name == "haas");
    }
    /// The same arcs as with three axes, in the plane's own X, Y, Z: every place within the same limits, the
    /// tool across the plane all along, and the same time.
    void tilted_planes_have_arcs() {
        QFETCH(QString, post);
        QFETCH(QString, machine);
        QFETCH(bool, inch);
        const Post& control = find_post(post.toStdString());
        const Vec3 axis = Vec3(-0.3, 0.4, 1).normalized();
        const ClProgram program = joined_program({tilted_section(round_section("Round", 1), axis)},
                                                 inch ? LengthUnit::inch : LengthUnit::mm);
        PostSetup setup = setup_for(program, machine.toStdString());
        setup.arc_bulge = 0.01;
        const PostedProgram straight = post_program(program, control, setup, {});
        setup.arcs = true;
        const PostedProgram posted = post_program(program, control, setup, {});
        QVERIFY(posted.planes == 1 && straight.arcs == 0);
        QVERIFY(posted.arcs >= 4 && 5 * posted.blocks < 4 * straight.blocks);
        const NcProgram read = read_nc(posted.text, "p", control, reading(program, setup), {});
        const double digit =
            inch ? 25.4 * std::pow(10, -control.inch_decimals) : std::pow(10, -control.mm_decimals);
        Points run;
        for (const Motion& m : read.sections.front()->motions.motions)
            if (m.kind != MotionKind::rapid) {
                run.push_back(m.to.tip);
                QVERIFY((m.to.axis - axis).norm() < 3e-6);
            }
        check_route(run, *program.sections.front(), setup, digit);
        if (QTest::currentTestFailed()) return;
        QVERIFY2(std::abs(read.seconds - posted.seconds) < 1e-3 * posted.seconds,
                 qPrintable(QString("%1 %2").arg(read.seconds).arg(posted.seconds)));
        QVERIFY(std::abs(posted.seconds - straight.seconds) < 2e-3 * posted.seconds);
    }

    /// A whole turn, as people write them: no end is given.
    void a_whole_turn_in_a_tilted_plane() {
        const Vec3 axis = Vec3(0, -0.4, 1).normalized();
        ClSection upright = plain_section("One", 1, false);
        add_motion(upright, MotionKind::rapid, Vec3(5, 0, 12));
        add_motion(upright, MotionKind::approach, Vec3(5, 0, 1));
        add_motion(upright, MotionKind::cut, Vec3(5, 0, 0));
        const ClProgram program = joined_program({tilted_section(upright, axis)});
        const PostSetup setup = setup_for(program, "trunnion-ac");
        const Vec3 centre = program.sections.front()->motions.motions.back().to.tip - 5 * Vec3::UnitX();
        for (const bool clockwise : {false, true}) {
            std::string text = post_program(program, find_post("fanuc"), setup, {}).text;
            text.insert(text.rfind("G69") - 5, clockwise ? "G2 I-5. J0. F600.\n" : "G3 I-5. J0. F600.\n");
            const NcProgram read = read_nc(text, "p", find_post("fanuc"), reading(program, setup), {});
            double way = 0, turned = 0;
            const auto& motions = read.sections.front()->motions.motions;
            for (std::size_t i = 1; i < motions.size(); ++i) {
                const Vec3 a = motions[i - 1].to.tip - centre, b = motions[i].to.tip - centre;
                if (motions[i].kind == MotionKind::rapid || std::abs(a.norm() - 5) > 1e-3) continue;
                QVERIFY(std::abs(b.norm() - 5) < 1e-3 && std::abs(b.dot(axis)) < 1e-3);
                way += (b - a).norm();
                turned += a.cross(b).dot(axis);
            }
            QVERIFY2(std::abs(way - 10 * pi) < 0.02, qPrintable(QString::number(way)));
            QCOMPARE(turned < 0, clockwise);
        }
    }

    void feeds_and_inclined_tools_have_none() {
        ClSection fast = round_section("Round", 1);
        for (std::size_t i = 0; i < fast.motions.motions.size(); ++i)
            fast.motion_feeds.push_back(i % 3 == 0 ? 900 : 1000);
        ClSection leaning = round_section("Lean", 1);
        leaning.multi_axis = true;
        for (const ClSection& s : {fast, leaning}) {
            const ClProgram program = joined_program({s});
            PostSetup setup = setup_for(program, "trunnion-ac");
            setup.arcs = true;
            QCOMPARE(post_program(program, find_post("linuxcnc"), setup, {}).arcs, std::size_t(0));
        }
    }

    void arcs_that_are_refused_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<std::string>("block");
        QTest::addColumn<std::string>("says");
        const auto row = [](const char* post, const char* block, const char* says) {
            QTest::addRow("%s: %s", post, block) << post << std::string(block) << std::string(says);
        };
        row("linuxcnc", "G2 X10 Y0", "neither centre nor radius");
        row("linuxcnc", "G2 X10 Y0 I5 K1", "across its plane");
        row("linuxcnc", "G2 X10 Y0.5 I5 J0", "from its centre and ends");
        row("linuxcnc", "G2 X10 Y0 I0 J0", "no radius");
        row("linuxcnc", "G18 G2 X10 Y0 Z0 J5", "across its plane");
        row("linuxcnc", "G1 X10 I5", "given as a vector");
        row("linuxcnc", "G2 X10 Y0 R5", "no word");
        row("linuxcnc", "G2 G3 X10 Y0 I5", "two kinds");
        row("linuxcnc", "G90.1", "G90.1");
        row("linuxcnc", "G2 X90000 Y0 I45000 J0", "its travel is");
        row("linuxcnc", "G2 X10 Y0 Z-4000 I5 J0", "its travel is");
        row("radius", "G2 X10 Y0 R4.9", "no arc of this radius");
        row("radius", "G2 X0 Y0 R5", "no arc of this radius");
        row("radius", "G2 X10 Y0 R5 I5", "a centre and a radius");
        row("linuxcnc", "G2 X10 Y0 I5 P3", "read over");
        row("heidenhain", "C X+10 Y+0 DR-", "no centre");
        row("heidenhain", "C X+10 Y+0", "no direction");
        row("heidenhain", "L X+10 DR-", "without an arc");
        row("heidenhain", "C X+10 Y+0 DR- FMAX", "no rapid");
    }
    /// Behind a first cut that ends in X 0, Y 0.
    void arcs_that_are_refused() {
        QFETCH(QString, post);
        QFETCH(std::string, block);
        QFETCH(std::string, says);
        const Post control = arc_post(post.toStdString());
        ClSection section = plain_section("One", 1, false);
        add_motion(section, MotionKind::rapid, Vec3(-5, 0, 12));
        add_motion(section, MotionKind::approach, Vec3(-5, 0, 0));
        add_motion(section, MotionKind::cut, Vec3(0, 0, 0));
        const ClProgram program = joined_program({section});
        const PostSetup setup = setup_for(program, "trunnion-ac");
        std::string text = post_program(program, control, setup, {}).text;
        const std::string last = post == QStringLiteral("heidenhain") ? "L X+0" : "X0";
        const auto at = text.find('\n', text.rfind(last)) + 1;
        text.insert(at, block + control.line_end);
        std::string message;
        QVERIFY(code_of([&] { read_nc(text, "p", control, reading(program, setup), {}); }, &message)
                != "none");
        QVERIFY2(message.find("p:") == 0 && message.find(says) != std::string::npos, message.c_str());
    }

    /// LinuxCNC's interpreter runs them where they were planned: its own centres and directions.
    void the_interpreter_runs_them_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<bool>("inch");
        for (const char* post : {"linuxcnc", "grbl", "radius"})
            for (const bool inch : {false, true})
                QTest::addRow("%s %s", post, inch ? "in" : "mm") << post << inch;
    }
    void the_interpreter_runs_them() {
        if (rs274_program().isEmpty()) QSKIP("SKIPPED: no rs274 on this machine (Debian: linuxcnc-uspace)");
        QFETCH(QString, post);
        QFETCH(bool, inch);
        const Post control = arc_post(post.toStdString());
        const ClProgram program =
            joined_program({round_section("Round", 1)}, inch ? LengthUnit::inch : LengthUnit::mm);
        PostSetup setup = setup_for(program, "generic-3-axis");
        setup.arcs = true;
        setup.arc_bulge = 0.01;
        const PostedProgram posted = post_program(program, control, setup, {});
        const Interpreted seen = interpret(posted.text, program);
        QVERIFY2(seen.status == 0, seen.message.constData());
        QCOMPARE(seen.arcs, posted.arcs);
        const double unit = mm_per(program.unit), digit = unit * 1e-4;
        const Points planned = tips(*program.sections.front());
        Points run;
        for (const Place& p : seen.places)
            run.push_back(unit * Vec3(p[0], p[1], p[2]));
        // From the first place on; ways up go where nobody planned.
        bool begun = false;
        for (const Vec3& p : run) {
            begun = begun || (p - planned.front()).norm() < 3 * digit;
            if (begun && std::abs(p.z()) < planned.front().z() + 1)
                QVERIFY2(distance_to_line(p, planned) < setup.arc_bulge + 3 * digit,
                         qPrintable(QString::number(distance_to_line(p, planned))));
        }
        for (const Vec3& p : planned)
            QVERIFY2(distance_to_line(p, run) < setup.tip_tolerance + 3 * digit + 0.01,
                     qPrintable(QString::number(distance_to_line(p, run))));
    }
};

FACETMILL_TEST(TestPostArcs)
#include "test_post_arcs.moc"
