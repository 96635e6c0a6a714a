// What the window says in two places is one thing: figures of a plan that is out of date, the point at which
// playback, charts and configuration space stand, and what an empty view says while something is on its way.
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/part_meshes.h"
#include "ui/cspace_controller.h"
#include "ui/layer_bar.h"
#include "ui/parameter_form.h"
#include "ui/playback_bar.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/report_view.h"
#include "ui/verification_controller.h"
#include "ui/verification_panel.h"
#include "ui/viewport.h"

#include <QAction>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <set>

using namespace facetmill;
using namespace facetmill::test;
using ui::OperationState;
using ui::TreeNode;

class TestWindowAgreement : public QObject, private WindowFixture {
    Q_OBJECT

    QStringList report_lines() { return w().report().toPlainText().split(QChar('\n'), Qt::SkipEmptyParts); }
    ui::PlaybackController& playback() { return w().verification().playback(); }
    const std::vector<Motion>& motions() { return w().document().result(0)->program.motions.motions; }
    Vec3 tip() { return w().viewport().scene().tool().pose()->tip; }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void old_figures_stand_alone() {
        QVERIFY(open_and_plan());
        w().verify();
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::operation, 0});
        const QStringList before = report_lines();
        const QString judged = w().verification().panel()->figures_text();
        QVERIFY(before.contains(QStringLiteral("0.02 in")) && !judged.isEmpty());
        enter(w(), "tolerance", QStringLiteral("0.07"));
        enter(w(), "feed", QStringLiteral("33"));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::stale);
        // Nothing new but that they are old; nothing of what is only set.
        const QStringList after = report_lines();
        const std::set<QString> known(before.begin(), before.end());
        QStringList added;
        for (const QString& line : after)
            if (!known.count(line)) added << line;
        QCOMPARE(added.size(), 1);
        QVERIFY2(added.front().startsWith(QStringLiteral("Out of date")), qPrintable(added.front()));
        QVERIFY2(!after.contains(QStringLiteral("Tolerance")), qPrintable(after.join(QChar('\n'))));
        // Nor in the table of all operations, which adds up what is planned alone.
        w().tree().select({TreeNode::Kind::operations, 0});
        QVERIFY2(report_lines().filter(QStringLiteral("Out of date")).size() == 1
                     && !report_lines().contains(QStringLiteral("Total")),
                 qPrintable(report_lines().join(QChar('\n'))));
        QCOMPARE(w().verification().panel()->figures_text(), judged);
        QVERIFY(w().verification().panel()->verdict_line().startsWith(QStringLiteral("Out of date")));
        // Nor is anything of it played back or written.
        QVERIFY(!playback().loaded() && !w().document().complete_plan());
        w().plan();
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(report_lines().contains(QStringLiteral("0.07 in")));
    }

    /// What stands in the middle of the view until there is something to see.
    void an_empty_view_says_what_is_on_its_way() {
        const QString folder = scratch_folder(QStringLiteral("big"));
        const QString path = folder + QStringLiteral("/big.stl");
        save_stl(height_field([](double x, double y) { return std::sin(x / 7) * std::cos(y / 8); },
                              Vec2(0, 0), Vec2(60, 40), 300, 300),
                 path.toStdString(), LengthUnit::mm, {});
        std::set<std::string> said;
        const auto watch = [&] {
            QElapsedTimer timer;
            timer.start();
            for (int idle = 0; idle < 5 && timer.elapsed() < patience_ms; idle = w().busy() ? 0 : idle + 1) {
                QTest::qWait(2);
                said.insert(w().viewport().scene().shown_empty_text());
            }
        };
        w().open_file(path, LengthUnit::mm);
        watch();
        QVERIFY(w().document().part_is_current());
        QVERIFY2(said.size() == 1 && said.begin()->empty(),
                 said.rbegin()->c_str()); // the start page was there
        QVERIFY(w().files().save_to(folder + QStringLiteral("/job.facetmill")));
        close_window();
        QVERIFY(show_window());
        said.clear();
        w().open_file(folder + QStringLiteral("/job.facetmill"));
        watch();
        QVERIFY(w().document().part_is_current());
        said.erase("");
        QVERIFY2(said.size() == 1 && *said.begin() == "Reading big.stl\u2026",
                 said.empty() ? "" : said.rbegin()->c_str());
    }

    /// All that there is can be switched off: then the view says so, and is not just empty.
    void a_view_that_is_switched_off_says_so() {
        QVERIFY(open_and_plan());
        const Scene& scene = w().viewport().scene();
        QVERIFY(scene.shown_empty_text().empty());
        w().layers().set_shown_set({});
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(scene.shown_empty_text(), std::string("All of it is switched off below the view"));
        shot(w(), QStringLiteral("agreement-switched-off"));
        for (const ui::ViewLayer one : {ui::ViewLayer::part, ui::ViewLayer::cuts, ui::ViewLayer::stock}) {
            w().layers().set_shown_set({one});
            QVERIFY(wait_until_settled(w()));
            QVERIFY(scene.shown_empty_text().empty());
        }
    }

    void playback_goes_on_from_where_the_tool_was_put() {
        QVERIFY(open_and_plan());
        QCOMPARE(playback().target(), 0.0); // a path that has just come is played from its start
        // A click on the path in the view.
        Scene& scene = w().viewport().scene();
        const std::size_t middle = motions().size() / 2;
        const Vec2 pixel =
            scene.camera().display_of(motions()[middle].to.tip) / w().viewport().devicePixelRatioF();
        QTest::mouseClick(&w().viewport(), Qt::LeftButton, {}, QPoint(int(pixel.x()), int(pixel.y())));
        QVERIFY(wait_until_settled(w()));
        const Vec3 picked = tip();
        QVERIFY(!w().verification().engaged());
        const double at = playback().target();
        QVERIFY(at > 1);
        QVERIFY((playback().tool().tip - picked).norm() < 1e-9);
        QCOMPARE(w().verification().bar()->goto_box()->value(), int(playback().track().place(at).motion) + 1);
        QTest::keyClick(&w(), Qt::Key_Period);
        QVERIFY(w().verification().engaged());
        QCOMPARE(playback().target(), std::floor(at) + 1);
        QVERIFY(wait_until_settled(w()));
        QVERIFY((tip() - playback().tool().tip).norm() < 1e-9);
        // Once more to the start, where it is let go.
        w().verification().bar()->button("play_start")->click();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(playback().target(), 0.0);
    }

    void the_configuration_space_goes_where_playback_rests() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        w().findChild<QDockWidget*>(QStringLiteral("cspace_dock"))->raise();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().cspace().point().has_value());
        const std::size_t first = *w().cspace().point();
        // Steps of the configuration space: playback goes along.
        const auto record = w().document().result(0)->path.five_axis();
        std::size_t free = first + 7;
        while (!record->points[free].choice.free)
            ++free; // what is left to clean-up has no tool
        w().cspace().step(int(free - first), 0);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(*w().cspace().point(), free);
        // Not every contact has a motion of its own: the nearest cut is meant.
        double nearest = infinity;
        for (const Motion& m : motions())
            if (m.kind == MotionKind::cut) nearest = std::min(nearest, (m.to.tip - tip()).norm());
        QCOMPARE((playback().tool().tip - tip()).norm(), nearest);
        // A slider that is let go.
        const auto is_there = [&] {
            const Vec3 surface = record->points[*w().cspace().point()].place.surface;
            const auto cut = playback().track().place(playback().position()).motion;
            const double reach = w().document().project().tools.front().diameter;
            return (motions()[cut].to.tip - surface).norm() < reach;
        };
        std::size_t far = motions().size() / 2;
        while (motions()[far].kind != MotionKind::cut)
            ++far;
        playback().go_to({0, far});
        QVERIFY(wait_until_settled(w()));
        QVERIFY(*w().cspace().point() != free);
        QVERIFY(is_there());
        QVERIFY(w().cspace().shown() && w().cspace().shown()->index == *w().cspace().point());
        QTest::keyClick(&w(), Qt::Key_Comma);
        QVERIFY(wait_until_settled(w()) && is_there());
        // While it stands there, a posture that is tried stays on the screen.
        do
            w().cspace().step(1, 0);
        while (!w().viewport().scene().tool().pose());
        QVERIFY(wait_until_settled(w()));
        const Vec3 stepped = tip();
        QTest::qWait(300);
        QVERIFY((tip() - stepped).norm() < 1e-12);
        QVERIFY(is_there());
    }
};

FACETMILL_TEST(TestWindowAgreement)
#include "test_window_agreement.moc"
