// Stock that stands too high above a part for what finishes it: known before anything is planned.
#include "core/job/unroughed_stock.h"

#include "core/job/new_operation.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A step of 20 mm, a quarter of it low, with a wall of half as much surface as what is level, in a block
/// 2 mm higher; a ball of 6 with flutes of 10.
struct StepJob {
    PreparedPart part;
    Project project;

    StepJob() {
        part.mesh = std::make_shared<Mesh>(height_field([](double x, double) { return x < 10 ? 0.0 : 20.0; },
                                                        Vec2(0, 0), Vec2(40, 40), 400, 4));
        part.box = part.mesh->box();
        project = default_project("step.stl", LengthUnit::mm, part.box);
        project.stock.margin = {2, 2, 2};
        Tool& tool = project.tools.front();
        tool.diameter = tool.shank_diameter = 6;
        tool.flute_length = 10;
        tool.shank_length = 30;
    }
    std::optional<UnroughedStock> found() const {
        return unroughed_stock(project, part, *project.operations.front());
    }
};

} // namespace

class TestUnroughedStock : public QObject {
    Q_OBJECT
private slots:
    void the_share_that_is_too_deep_is_measured() {
        const StepJob job;
        const auto found = job.found();
        QVERIFY(found);
        QCOMPARE(found->highest, 22.0);
        QCOMPARE(found->reach, 10.0);
        // The low quarter, and the lower half of the wall.
        QVERIFY2(std::abs(found->share - 1.0 / 3) < 0.01, qPrintable(QString::number(found->share)));
    }

    void facets_are_walked_once_for_a_part_a_stock_and_a_reach() {
        StepJob job;
        UnroughedLook look;
        const auto found = [&] { return look.of(job.project, job.part, *job.project.operations.front()); };
        const double share = found()->share;
        auto mesh = std::make_shared<Mesh>(*job.part.mesh);
        job.part.mesh = mesh;
        QCOMPARE(found()->share, share);
        for (Vec3& v : mesh->vertices) // nothing that is asked for: it would be seen
            if (v.z() > 1) v.z() = 0.5;
        QCOMPARE(found()->share, share);
        job.project.stock.margin = {2, 2, 3};
        QVERIFY(found()->share > 0.9);
        QCOMPARE(found()->highest, 23.0);
        for (Vec3& v : mesh->vertices)
            v.z() *= 40;
        QVERIFY(found()->share > 0.9);
        job.project.tools.front().flute_length = 9;
        QVERIFY(found()->share < 0.5);
        QCOMPARE(found()->reach, 9.0);
    }

    void flutes_that_reach_or_a_slim_shank_need_no_roughing() {
        StepJob job;
        job.project.tools.front().flute_length = 22;
        QVERIFY(!job.found());
        job.project.tools.front().flute_length = 10;
        job.project.tools.front().shank_diameter = 5;
        QVERIFY(!job.found());
        job.project.tools.front().shank_length = 5; // then its holder comes down
        QVERIFY(job.found());
    }

    void roughing_answers_it_unless_it_is_switched_off() {
        StepJob job;
        job.project.operations.push_back(new_operation("rough", job.project).operation);
        QVERIFY(!job.found());
        job.project.operations.back()->common().off = true;
        QVERIFY(job.found());
    }

    void what_is_not_known_or_may_stay_is_not_told() {
        StepJob job;
        job.project.limits.uncut_limit = 0.4;
        QVERIFY(!job.found());
        job.project.limits.uncut_limit = 0.02;
        job.project.stock.kind = StockSpec::Kind::rest;
        QVERIFY(!job.found());
        job.project.stock.kind = StockSpec::Kind::box;
        job.project.operations.front() = new_operation("rough", job.project).operation;
        job.project.operations.front()->common().off = true;
        QVERIFY(!job.found()); // that is no finishing
    }
};

FACETMILL_TEST(TestUnroughedStock)
#include "test_unroughed_stock.moc"
