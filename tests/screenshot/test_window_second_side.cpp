// A whole job with two sides, as a user does it: a mesh that lies on its side is laid down, gets its zero and
// a vice, is planned and verified, turned over, and verified as one. The pictures are those of the README.
#include "core/mesh/mesh_io.h"
#include "core/setup/lying.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/part_meshes.h"
#include "ui/parameter_form.h"
#include "ui/plan_runner.h"
#include "ui/project_files.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <Eigen/Geometry>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

class TestWindowSecondSide : public QObject, private WindowFixture {
    Q_OBJECT

    const Project& project() { return w().document().project(); }
    void trigger(const QMenu* menu, const char* name) {
        for (QAction* a : menu->actions())
            if (a->objectName() == QLatin1String(name)) {
                a->trigger();
                QVERIFY(wait_until_settled(w()));
                return;
            }
        QFAIL(name);
    }
    void press(const char* name) {
        w().findChild<QAbstractButton*>(QLatin1String(name))->click();
        QVERIFY(wait_until_settled(w()));
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void from_a_mesh_to_a_verified_second_side() {
        const QString folder = scratch_folder(QStringLiteral("second-side"));
        Mesh block = HollowedBlock::mesh();
        const Mat3 crooked = Eigen::AngleAxisd(radians(25), Vec3::UnitZ()) * quarter_turn(1, 1);
        for (Vec3& v : block.vertices)
            v = crooked * v;
        save_stl(block, (folder + "/block.stl").toStdString(), LengthUnit::mm, {});

        w().open_file(folder + "/block.stl", LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        auto* faces = w().findChild<QTreeWidget*>(QStringLiteral("place_faces"));
        QVERIFY(faces->topLevelItemCount() > 3);
        faces->setCurrentItem(faces->topLevelItem(0));
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("side-1-opened"));

        press("place_lay");
        press("place_square");
        press("place_centre");
        w().viewport().set_view(StandardView::iso);
        QVERIFY(wait_until_settled(w()));
        const Box3 part = w().document().part()->box;
        QVERIFY((part.size() - HollowedBlock::size()).norm() < 1e-3 && std::abs(part.lo.z()) < 1e-6);
        shot(w(), QStringLiteral("side-2-laid"));

        auto* of = w().findChild<QComboBox*>(QStringLiteral("zero_of"));
        QCOMPARE(of->currentIndex(), 0); // the stock
        press("zero_0");
        w().tree().select({TreeNode::Kind::stock, 0});
        w().document().change(QStringLiteral("Edit stock"), [](Project& p) { p.stock.margin = {0, 0, 1}; });
        QVERIFY(wait_until_settled(w()));
        QVERIFY(project().programs.zero_from == ProgramSpec::ZeroFrom::stock);
        shot(w(), QStringLiteral("side-3-zero"));
        w().findChild<QDockWidget*>(QStringLiteral("place_dock"))->hide();
        w().findChild<QDockWidget*>(QStringLiteral("report_dock"))->raise();

        trigger(w().tree().add_fixture_menu(), "fixture_vice");
        QCOMPARE(project().fixtures.size(), std::size_t(2));
        w().viewport().fit();
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("side-4-held"));

        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.05"));
        QTest::keyClick(&w(), Qt::Key_F6); // plans first
        QVERIFY(wait_until_settled(w()));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        const ui::VerificationModel& model = w().verification().model();
        QVERIFY2(model.verdict() == ui::Verdict::verified, qPrintable(model.failure_text()));
        shot(w(), QStringLiteral("side-5-verified"));

        trigger(w().tree().add_setup_menu(), "setup_about_x");
        trigger(w().tree().add_fixture_menu(), "fixture_vice");
        w().document().add_operation("finish3");
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.05"));
        QTest::keyClick(&w(), Qt::Key_F6, Qt::ShiftModifier);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY2(model.verdict() == ui::Verdict::verified, qPrintable(model.failure_text()));
        QVERIFY(model.covers_all());
        QCOMPARE(model.outcome().setups.size(), std::size_t(2));
        w().viewport().set_view(StandardView::iso);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("side-6-both"));
        QVERIFY(w().files().save_to(folder + "/job.facetmill"));
    }
};

FACETMILL_TEST(TestWindowSecondSide)
#include "test_window_second_side.moc"
