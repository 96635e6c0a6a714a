// Fixtures in the window: added from a menu, edited in a form, drawn, kept off by what is planned, watched by
// the verification; each change a step of the history.
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/part_meshes.h"
#include "ui/fixture_list.h"
#include "ui/message_bar.h"
#include "ui/parameter_form.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>
#include <QTreeWidget>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

class TestWindowFixtures : public QObject, private WindowFixture {
    Q_OBJECT

    const Project& project() { return w().document().project(); }
    QTreeWidgetItem* item(std::size_t i) { return w().tree().item({TreeNode::Kind::fixture, i}); }
    QAction* add(const char* name) {
        for (QAction* a : w().tree().add_fixture_menu()->actions())
            if (a->objectName() == QLatin1String(name)) return a;
        qFatal("there is no such fixture to add");
    }
    void add_and_wait(const char* name) {
        add(name)->trigger();
        QVERIFY(wait_until_settled(w()));
    }

private slots:
    void init() {
        QVERIFY(show_window());
        folder_ = scratch_folder(QStringLiteral("fixtures"));
        save_stl(box(Vec3(0, 0, 0), Vec3(40, 30, 12)), (folder_ + "/block.stl").toStdString(), LengthUnit::mm,
                 {});
        QFile file(folder_ + "/job.facetmill");
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({ "facetmill": 1, "units": "mm", "part": { "file": "block.stl" },
            "stock": { "kind": "box", "margin": [1, 1, 1] },
            "tools": [ { "number": 1, "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_length": 30 } ],
            "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.2 } ] })");
        file.close();
        w().open_file(file.fileName());
        QVERIFY(wait_until_settled(w()));
    }
    void cleanup() { close_window(); }

    void they_are_added_edited_and_removed() {
        const std::string before = project_to_json(project());
        const Box3 bare = w().viewport().scene().bounds();
        const QImage alone = view_picture(w());
        add_and_wait("fixture_vice");
        QCOMPARE(project().fixtures.size(), std::size_t(2));
        QCOMPARE(item(0)->text(0), QStringLiteral("Front jaw"));
        QVERIFY(w().tree().selected() == (TreeNode{TreeNode::Kind::fixture, 0}));
        // Against the stock's sides, drawn with it.
        const StockSpec& stock = project().stock;
        const Fixture& jaw = project().fixtures[0];
        QVERIFY(std::abs(jaw.translate[1] + 0.5 * jaw.size[1] + stock.margin[1]) < 1e-2);
        const Box3 held = w().viewport().scene().bounds();
        const Vec2 corner = w().viewport().scene().camera().display_of(held.lo);
        QVERIFY(corner.x() > 0 && corner.y() > 0); // in sight
        QVERIFY(held.lo.y() < bare.lo.y() - 1 && held.hi.y() > bare.hi.y() + 1);
        QVERIFY(changed_pixels(alone, view_picture(w())) > 1000);
        shot(w(), QStringLiteral("fixtures-vice"));
        // The form has the keys of its kind.
        auto* form = w().properties().form();
        QVERIFY(form->findChild<QWidget*>(QStringLiteral("clearance")));
        QVERIFY(!form->findChild<QWidget*>(QStringLiteral("diameter")));
        enter(w(), "clearance", QStringLiteral("0"));
        QVERIFY(!error_under(w(), "clearance").isEmpty());
        enter(w(), "clearance", QStringLiteral("3"));
        QCOMPARE(project().fixtures[0].clearance, 3.0);
        enter(w(), "name", QStringLiteral("Rear jaw"));
        QVERIFY(!error_under(w(), "name").isEmpty());
        enter(w(), "name", QStringLiteral("Fixed jaw"));
        QCOMPARE(item(0)->text(0), QStringLiteral("Fixed jaw"));
        auto* kind = form->findChild<QComboBox*>(QStringLiteral("kind"));
        kind->setCurrentIndex(kind->findText(QStringLiteral("cylinder")));
        emit kind->activated(kind->currentIndex());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(form->findChild<QWidget*>(QStringLiteral("diameter")));
        shot(w(), QStringLiteral("fixtures-cylinder"));
        w().tree().duplicate_action()->trigger();
        QCOMPARE(project().fixtures.size(), std::size_t(3));
        QCOMPARE(project().fixtures[1].name, std::string("Fixed jaw 2"));
        w().tree().select({TreeNode::Kind::fixture, 1});
        w().tree().remove_action()->trigger();
        QCOMPARE(project().fixtures.size(), std::size_t(2));
        for (int n = 0; n < 6; ++n)
            w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(project_to_json(project()), before);
        QVERIFY((w().viewport().scene().bounds().hi - bare.hi).norm() < 1e-6);
    }

    /// Four round the part, at its bottom, as one step of the history; the plan goes round them.
    void tabs_stand_round_the_part() {
        const std::string before = project_to_json(project());
        w().document().change(QStringLiteral("Edit"), [](Project& p) { p.stock.margin = {20, 20, 0}; });
        QVERIFY(wait_until_settled(w()));
        add_and_wait("fixture_tabs");
        QCOMPARE(project().fixtures.size(), std::size_t(4));
        QVERIFY(w().tree().selected() == (TreeNode{TreeNode::Kind::fixture, 0}));
        for (const Fixture& tab : project().fixtures) {
            QVERIFY(tab.kind == Fixture::Kind::tab);
            QVERIFY(std::abs(tab.translate[2] - w().document().part()->box.lo.z()) < 1e-3);
        }
        auto* form = w().properties().form();
        QVERIFY(!form->findChild<QWidget*>(QStringLiteral("clearance")));
        auto* shape = form->findChild<QComboBox*>(QStringLiteral("shape"));
        QVERIFY(shape);
        shape->setCurrentIndex(shape->findText(QStringLiteral("triangular")));
        emit shape->activated(shape->currentIndex());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(project().fixtures[0].shape == Fixture::TabShape::triangular);
        w().verify(); // plans first
        QVERIFY(wait_until_settled(w()));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY(w().verification().model().verification().collisions.empty());
        w().tree().select({TreeNode::Kind::fixture, 1});
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("fixtures-tabs"));
        for (int n = 0; n < 3; ++n)
            w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(project_to_json(project()), before);
    }

    /// A click chooses a fixture, a drag moves it level under the pointer, with Ctrl upright.
    void one_is_dragged() {
        add_and_wait("fixture_box");
        w().viewport().set_view(StandardView::top);
        w().viewport().fit();
        QVERIFY(wait_until_settled(w()));
        auto& scene = w().viewport().scene();
        const double ratio = w().viewport().devicePixelRatioF();
        const auto pixel = [&](const Vec3& p) {
            const Vec2 at = scene.camera().display_of(p) / ratio;
            return QPoint(int(std::lround(at.x())), int(std::lround(at.y())));
        };
        const auto place = [&] {
            const auto& t = project().fixtures[0].translate;
            return Vec3(t[0], t[1], t[2]);
        };
        const Vec3 was = place(), top = was + Vec3(0, 0, project().fixtures[0].size[2]);
        w().tree().select({TreeNode::Kind::part, 0});
        QTest::mouseClick(&w().viewport(), Qt::LeftButton, {}, pixel(top));
        QVERIFY(w().tree().selected() == (TreeNode{TreeNode::Kind::fixture, 0}));
        const auto drag = [&](const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys) {
            QTest::mousePress(&w().viewport(), Qt::LeftButton, keys, from);
            for (int k = 1; k <= 4; ++k) {
                const QPointF at = QPointF(from) + 0.25 * k * QPointF(to - from);
                QMouseEvent move(QEvent::MouseMove, at, w().viewport().mapToGlobal(at), Qt::NoButton,
                                 Qt::LeftButton, keys);
                QApplication::sendEvent(&w().viewport(), &move);
            }
            QTest::mouseRelease(&w().viewport(), Qt::LeftButton, keys, to);
        };
        const double slack = 2 * scene.camera().pixel_size() * ratio + 0.1;
        const Vec3 by(6, -9, 0);
        drag(pixel(top), pixel(top + by), {});
        QVERIFY(wait_until_settled(w()));
        QVERIFY2((place() - was - by).norm() < slack,
                 qPrintable(QString::number((place() - was - by).norm())));
        QVERIFY(std::abs(place().x() * 10 - std::round(place().x() * 10)) < 1e-9); // a tenth
        shot(w(), QStringLiteral("fixtures-dragged"));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QVERIFY((place() - was).norm() < 1e-12);
        // From the front it goes along X and Z; with Ctrl along Z alone.
        w().viewport().set_view(StandardView::front);
        QVERIFY(wait_until_settled(w()));
        const Vec3 front =
            was + Vec3(0, -0.5 * project().fixtures[0].size[1], 0.5 * project().fixtures[0].size[2]);
        drag(pixel(front), pixel(front + Vec3(5, 0, 4)), Qt::ControlModifier);
        QVERIFY(wait_until_settled(w()));
        QVERIFY((place() - was - Vec3(0, 0, 4)).norm() < slack);
        // Beside it the view turns, and nothing moves.
        const Vec3 there = place();
        drag(QPoint(20, 20), QPoint(60, 60), {});
        QVERIFY((place() - there).norm() < 1e-12);
    }

    /// A plan made before is out of date; the new one keeps off, and the verdict names the clamp as the
    /// reason of what stays.
    void plans_keep_off_and_the_verdict_says_why() {
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), ui::OperationState::planned);
        const double cut = w().document().result(0)->totals.cut_length;
        add_and_wait("fixture_clamp");
        QCOMPARE(w().document().state(0), ui::OperationState::stale);
        QTest::keyClick(&w(), Qt::Key_F6); // plans first
        QVERIFY(wait_until_settled(w()));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY(w().document().result(0)->totals.cut_length < cut);
        const Verification& v = w().verification().model().verification();
        QVERIFY(v.collisions.empty());
        QVERIFY(std::any_of(v.uncut.begin(), v.uncut.end(),
                            [](const UncutReason& r) { return r.why == UncutReason::Why::fixture; }));
        shot(w(), QStringLiteral("fixtures-verified"));
        // Over the whole part: nothing can be planned, and that is said.
        w().document().change(QStringLiteral("Grow"), [](Project& p) {
            p.fixtures[0].size = {80, 80, 10};
            p.fixtures[0].translate[0] = 20;
        });
        QVERIFY(wait_until_settled(w()));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), ui::OperationState::failed);
        QVERIFY2(w().document().failure(0).contains(QStringLiteral("Clamp")),
                 qPrintable(w().document().failure(0)));
    }

    void a_mesh_from_a_file() {
        save_stl(box(Vec3(45, 0, 0), Vec3(60, 30, 8)), (folder_ + "/stop.stl").toStdString(), LengthUnit::mm,
                 {});
        save_stl(height_field([](double, double) { return 0.0; }, Vec2(0, 0), Vec2(9, 9), 2, 2),
                 (folder_ + "/open.stl").toStdString(), LengthUnit::mm, {});
        bool asked = false;
        answer_file_dialog(asked, folder_ + "/stop.stl");
        add_and_wait("fixture_mesh");
        QVERIFY(asked);
        QCOMPARE(project().fixtures.size(), std::size_t(1));
        QCOMPARE(item(0)->text(0), QStringLiteral("stop"));
        QVERIFY(std::abs(w().viewport().scene().bounds().hi.x() - 60) < 1e-3);
        answer_file_dialog(asked = false); // cancelled
        add_and_wait("fixture_mesh");
        QVERIFY(asked);
        QCOMPARE(project().fixtures.size(), std::size_t(1));
        // One that is not closed: said, and the part is seen all the same.
        ui::set_fixture_file(w().document(), 0, (folder_ + "/open.stl").toStdString());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().part());
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("not closed")),
                 qPrintable(w().message_bar().message()));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().state(0) != ui::OperationState::planned);
    }

private:
    QString folder_;
};

FACETMILL_TEST(TestWindowFixtures)
#include "test_window_fixtures.moc"
