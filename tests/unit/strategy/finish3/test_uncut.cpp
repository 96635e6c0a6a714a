// Nothing stays uncut in silence: hollows, gaps between passes, places under the part.
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/finish3/uncut.h"
#include "tests/property/shapes.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A V along x with the bottom at y = 0: `slope` up to both sides, level beyond 8 mm.
Mesh groove(double slope) {
    return height_field([=](double, double y) { return slope * std::min(std::abs(y), 8.0); }, Vec2(-20, -15),
                        Vec2(20, 15), 4, 30);
}

struct Checked {
    PlanContext context;
    Finish3Settings settings;
    StrategyResult path;
    double allowed = 0;

    Checked(const Mesh& mesh, const Tool& tool, double step = 0) : context(context_of(mesh, tool)) {
        settings.direction = {0, "x"};
        if (step > 0) settings.stepover = {step, ""};
        path = Finish3(settings).plan(context, Progress());
        allowed = 1.1 * settings.tolerance;
    }
    UncutReport report(const Progress& progress = {}) const {
        const CutterProfile profile(context.tool.cutter());
        const CutterCover cover(profile, 0.125 * settings.tolerance);
        const AxialLift lift(context.contact, profile);
        UncutInput input;
        input.mesh = context.part.get();
        input.contact = context.contact;
        input.lift = &lift;
        input.cover = &cover;
        input.allowed = allowed;
        input.top = context.part_box.hi.z();
        input.passes = path.passes;
        return find_uncut(input, progress);
    }
    std::string warning(const std::string& word) const {
        for (const auto& w : path.warnings)
            if (w.find(word) != std::string::npos) return w;
        return {};
    }
};

} // namespace

class TestUncut : public QObject {
    Q_OBJECT
private slots:
    void a_groove_narrower_than_the_ball_is_reported() {
        // A ball of radius r in a right angle touches the flanks at the distance r from the bottom.
        const double r = 3;
        const Checked c(groove(1), ball_tool(2 * r));
        const UncutReport report = c.report();
        QVERIFY(report.covered.area == 0);
        QVERIFY2(report.passed_by.area == 0, qPrintable(QString("%1 high at %2 %3, %4 mm^2")
                                                            .arg(report.passed_by.height)
                                                            .arg(report.passed_by.at.x())
                                                            .arg(report.passed_by.at.y())
                                                            .arg(report.passed_by.area)));
        // Up to where the ball that sits in the groove leaves what is allowed, on both flanks; a little more,
        // because the passes' own cusps come on top.
        const double area = 2 * 40 * (r - std::sqrt(2 * r * c.allowed - c.allowed * c.allowed));
        QVERIFY2(report.out_of_reach.area > 0.95 * area && report.out_of_reach.area < 1.2 * area,
                 qPrintable(QString::number(report.out_of_reach.area)));
        // Under the ball's middle, which is as far from both flanks; samples lie a little beside.
        const double from_flanks = r * (1 - std::sqrt(0.5));
        QVERIFY(std::abs(report.out_of_reach.at.y()) < 1.2 * from_flanks * std::sqrt(0.5));
        QVERIFY2(report.out_of_reach.height > 0.8 * from_flanks
                     && report.out_of_reach.height <= 1.02 * from_flanks,
                 qPrintable(QString::number(report.out_of_reach.height)));
        const std::string w = c.warning("too large for hollows");
        QVERIFY(w.find("smaller tool") != std::string::npos && w.find(" mm") != std::string::npos);
    }

    void what_stands_is_measured_from_all_of_the_part() {
        // A slot 20 deep that the ball does not enter: however deep it is, nothing in it is farther than half
        // its width from a wall.
        const double half = 1.25;
        const Checked c(height_field([](double, double y) { return std::abs(y) < 1.1 ? -20.0 : 0.0; },
                                     Vec2(-20, -15), Vec2(20, 15), 4, 120),
                        ball_tool(6));
        const UncutPlaces slot = c.report().out_of_reach;
        QVERIFY(slot.area > 40 * 2);
        QVERIFY2(slot.height > 0.5 * half && slot.height <= 1.05 * half,
                 qPrintable(QString::number(slot.height)));
    }

    void a_part_that_the_cutter_fits_is_silent() {
        for (const Mesh& mesh :
             {groove(0.05),
              height_field([](double, double) { return 3.0; }, Vec2(-20, -15), Vec2(20, 15), 4, 3),
              height_field([](double x, double y) { return 0.01 * (x * x - y * y); }, Vec2(-20, -15),
                           Vec2(20, 15), 40, 30),
              box(Vec3(-20, -15, 0), Vec3(20, 15, 8)), dome(20, 24)}) {
            const Checked c(mesh, ball_tool(6));
            const UncutReport report = c.report();
            QVERIFY(report.samples >= 12);
            for (const UncutPlaces& p : {report.out_of_reach, report.passed_by, report.covered})
                QVERIFY2(p.area == 0,
                         qPrintable(QString("%1 at %2 %3").arg(p.height).arg(p.at.x()).arg(p.at.y())));
            QVERIFY2(c.path.warnings.empty() || c.path.warnings[0].find("stock") != std::string::npos,
                     c.path.warnings.empty() ? "" : c.path.warnings[0].c_str());
        }
    }

    void a_gap_between_passes_is_found() {
        Checked c(height_field([](double, double) { return 3.0; }, Vec2(-20, -15), Vec2(20, 15), 4, 3),
                  ball_tool(6), 1);
        QVERIFY(c.report().passed_by.area == 0);
        // Without the passes between y = 2 and 6: from 1.5 to 6.5 nothing goes over.
        std::erase_if(c.path.passes, [](const Pass& p) { return p.offset > 2 && p.offset < 6; });
        const UncutReport report = c.report();
        QVERIFY(report.out_of_reach.area == 0);
        const double reach = std::sqrt(2 * 3 * c.allowed - c.allowed * c.allowed);
        QVERIFY2(std::abs(report.passed_by.area - 40 * (5 - 2 * reach)) < 0.1 * 40 * 5,
                 qPrintable(QString::number(report.passed_by.area)));
        QVERIFY(std::abs(report.passed_by.at.y() - 4) < 0.3);
        QVERIFY2(std::abs(report.passed_by.height - (3 - std::sqrt(9 - 2.5 * 2.5))) < 0.05,
                 qPrintable(QString::number(report.passed_by.height)));
        // Nothing at all over half of the part.
        std::erase_if(c.path.passes, [](const Pass& p) { return p.offset > 0; });
        QVERIFY(c.report().passed_by.area > 0.4 * 1200);
    }

    /// A flat end reaches the floor beside a wall with its rim, wherever its middle has to stand.
    void a_flat_bottom_reaches_with_its_rim() {
        Checked c(step(0, 5), flat_tool(6));
        QVERIFY(c.report().out_of_reach.area == 0);
        // As if the passes kept 2 mm off the wall: a tip straight over that floor is held up by it.
        std::erase_if(c.path.passes, [](const Pass& p) { return p.offset < 5; });
        for (Pass& pass : c.path.passes)
            for (CutterLocation& at : pass.cl)
                at.tip.y() = std::max(at.tip.y(), 5.0);
        const UncutReport report = c.report();
        QVERIFY2(report.out_of_reach.area < 0.02 * report.passed_by.area,
                 qPrintable(QString("%1 of %2").arg(report.out_of_reach.area).arg(report.passed_by.area)));
        QVERIFY(report.passed_by.area > 80);
    }

    void what_the_part_covers_is_told_where_the_outside_is_known() {
        // A table with a foot: its foot faces up under the plate.
        Mesh m = box(Vec3(-10, -10, 10), Vec3(10, 10, 12));
        const Mesh foot = box(Vec3(-12, -12, 0), Vec3(12, 12, 2));
        for (const Facet& f : foot.facets)
            m.facets.push_back({f[0] + 8, f[1] + 8, f[2] + 8});
        m.vertices.insert(m.vertices.end(), foot.vertices.begin(), foot.vertices.end());
        const Checked c(m, ball_tool(6), 1);
        const UncutReport report = c.report();
        QVERIFY2(std::abs(report.covered.area - 400) < 10, qPrintable(QString::number(report.covered.area)));
        QVERIFY(std::abs(report.covered.at.z() - 2) < 1e-9);
        QVERIFY(!c.warning("under the part").empty());
        // Beside the plate's edge the ball does not come down to the foot.
        QVERIFY(report.out_of_reach.area > 0);
        // The same sheets without a bottom: nothing tells what is out.
        Mesh open = m;
        open.facets.erase(open.facets.begin(), open.facets.begin() + 2);
        QVERIFY(Checked(open, ball_tool(6), 1).report().covered.area == 0);
        // Turned inside out it is the same part.
        for (Facet& f : m.facets)
            std::swap(f[0], f[1]);
        QVERIFY(std::abs(Checked(m, ball_tool(6), 1).report().covered.area - 400) < 10);
    }

    void threads_and_cancelling() {
        const Checked c(groove(1), ball_tool(6));
        Job job;
        job.cancel();
        bool cancelled = false;
        try {
            c.report(Progress(job));
        } catch (const Cancelled&) {
            cancelled = true;
        }
        QVERIFY(cancelled);
        const UncutReport a = c.report(), b = c.report();
        QVERIFY(a.out_of_reach.area == b.out_of_reach.area && a.out_of_reach.at == b.out_of_reach.at);
    }

    void an_inch_project_is_warned_in_inches() {
        PlanContext context = context_of(groove(1), ball_tool(6));
        context.unit = LengthUnit::inch;
        context.tool.flute_length = 4;
        context.tool.shank_diameter = 12;
        Finish3Settings s;
        s.stepover = {2, ""};
        const StrategyResult r = Finish3(s).plan(context, Progress());
        QVERIFY(r.warnings.size() >= 3); // step-over, hollows, shank
        for (const auto& w : r.warnings)
            QVERIFY2(w.find(" in") != std::string::npos && w.find(" mm") == std::string::npos, w.c_str());
        QVERIFY(r.warnings[0].find("0.07874 in") != std::string::npos);
        context.tessellation_tolerance = {1, 1};
        try {
            Finish3(s).plan(context, Progress());
            QFAIL("no error");
        } catch (const Error& e) {
            QVERIFY2(e.message().find("(outward 0.03937 in, inward 0.03937 in)") != std::string::npos,
                     e.what());
        }
    }
};

FACETMILL_TEST(TestUncut)
#include "test_uncut.moc"
