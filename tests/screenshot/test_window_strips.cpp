// Clean-up in the window: the list of strips, switching them, choosing them in the list and in the view, and
// how the previous tool stands over them.
#include "core/job/planner.h"
#include "core/mesh/mesh_io.h"
#include "core/strategy/cleanup/cleanup.h"
#include "tests/screenshot/window_support.h"
#include "ui/controllers.h"
#include "ui/elided_label.h"
#include "ui/parameter_form.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/strip_controller.h"
#include "ui/strip_panel.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QSlider>
#include <QTest>
#include <QTreeWidget>
#include <QUndoStack>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

namespace {

/// Radius of the previous ball, and where the two grooves run along X; mm.
constexpr double previous_radius = 6, groove_y = 12;

/// Two level grooves with flanks of 45 degrees.
Mesh grooves() {
    Mesh m;
    const int columns = 10, rows = 24;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double x = -20 + 4.0 * i, y = -24 + 2.0 * j;
            m.vertices.emplace_back(x, y, std::abs(std::abs(y) - groove_y));
        }
    const auto at = [&](int i, int j) { return Index(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            m.facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            m.facets.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return m;
}

Tool ball(long number, double diameter) {
    Tool t;
    t.number = number;
    t.name = "Ball " + std::to_string(int(diameter));
    t.diameter = t.shank_diameter = diameter;
    t.corner_radius = 0.5 * diameter;
    t.flute_length = 30;
    return t;
}

} // namespace

class TestWindowStrips : public QObject, public WindowFixture {
    Q_OBJECT

    StripController& controller() { return w().controllers().strips(); }
    QTreeWidget* list() { return controller().panel()->list(); }
    QDockWidget* dock() { return w().findChild<QDockWidget*>(QStringLiteral("strips_dock")); }
    QString readout() { return controller().panel()->readout()->text(); }
    QTreeWidgetItem* row(const char* name) {
        const auto found = list()->findItems(QLatin1String(name), Qt::MatchExactly);
        return found.isEmpty() ? nullptr : found.front();
    }
    const StrategyResult& path() { return w().document().result(0)->path; }
    bool open_grooves() {
        const QString file = scratch_folder(QStringLiteral("grooves")) + QStringLiteral("/grooves.stl");
        save_stl(grooves(), file.toStdString(), LengthUnit::mm, {});
        w().open_file(file, LengthUnit::mm);
        if (!wait_until_settled(w())) return false;
        w().document().add_operation("cleanup");
        w().document().remove_operation(0);
        w().document().change(QStringLiteral("Tools"), [](Project& p) {
            p.tools = {ball(1, 2 * previous_radius), ball(2, 4)};
            p.operations[0]->common().tool = 2;
            p.operations[0]->common().tolerance = 0.1;
            p.operations[0]->set("previous_tool", ParameterValue(1l));
        });
        return wait_until_settled(w());
    }
    bool plan() {
        w().plan();
        return wait_until_settled(w()) && w().document().state(0) == OperationState::planned;
    }
    bool open_and_plan() { return open_grooves() && plan(); }
    /// In the middle of the groove at y.
    bool click_groove(double y) {
        Viewport& view = w().viewport();
        const Vec2 at = view.scene().camera().display_of(Vec3(3, y, 0)) / view.devicePixelRatioF();
        QTest::mouseClick(&view, Qt::LeftButton, {},
                          QPoint(int(std::lround(at.x())), int(std::lround(at.y()))));
        return wait_until_settled(w());
    }
    /// The ball that is drawn stands on both flanks of the groove at y.
    bool stands_over(double y) {
        const Scene& scene = w().viewport().scene();
        const auto& pose = scene.tool().pose();
        if (!pose || scene.marks().touches().size() != 2) return false;
        const Vec3 center = pose->tip + Vec3(0, 0, previous_radius);
        if (std::abs(center.y() - y) > 1e-3) return false;
        for (const Vec3& p : scene.marks().touches())
            if (std::abs((p - center).norm() - previous_radius) > 1e-3
                || std::abs(p.z() - std::abs(std::abs(p.y()) - groove_y)) > 1e-3)
                return false;
        return (scene.marks().touches()[0].y() - y) * (scene.marks().touches()[1].y() - y) < 0;
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void it_says_why_there_is_nothing() {
        QVERIFY(open_part());
        dock()->show();
        dock()->raise();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(controller().panel()->empty_text().contains(QStringLiteral("add a clean-up")),
                 qPrintable(controller().panel()->empty_text()));
        QVERIFY(!list()->isVisible());
        shot(w(), QStringLiteral("strips-empty"));
        close_window();
        QVERIFY(show_window());
        QVERIFY(open_grooves());
        QVERIFY2(controller().panel()->empty_text().contains(QStringLiteral("Plan")),
                 qPrintable(controller().panel()->empty_text()));
        // A tolerance at which nothing is left says so in its place.
        w().document().change(QStringLiteral("tolerance"),
                              [](Project& p) { p.operations[0]->common().tolerance = 5; });
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(controller().panel()->empty_text().contains(QStringLiteral("leaves nowhere")),
                 qPrintable(controller().panel()->empty_text()));
        QVERIFY(!w().viewport().scene().has(Layer::strips));
    }

    void a_plan_lists_its_strips() {
        QVERIFY2(open_and_plan(), qPrintable(w().last_failure()));
        QVERIFY(dock()->isVisible());
        QCOMPARE(path().strips.size(), std::size_t(2));
        QCOMPARE(list()->topLevelItemCount(), 2);
        for (std::size_t i = 0; i < 2; ++i) {
            const Strip& strip = path().strips[i];
            QTreeWidgetItem* item = row(strip.name.c_str());
            QVERIFY(item);
            QCOMPARE(item->checkState(0), Qt::Checked);
            QCOMPARE(item->text(1), QStringLiteral("Two contacts"));
            // Both flanks up to where the tolerance is left: 2 (R - sqrt((R + t)^2 - R^2)).
            const double wide =
                2
                * (previous_radius
                   - std::sqrt(std::pow(previous_radius + 0.1, 2) - previous_radius * previous_radius));
            QVERIFY2(std::abs(item->text(2).toDouble() - wide) < 0.2, qPrintable(item->text(2)));
            QVERIFY2(std::abs(item->text(3).toDouble() - 40) < 1, qPrintable(item->text(3)));
            QVERIFY2(item->text(4).contains(QStringLiteral("both flanks")), qPrintable(item->text(4)));
        }
        // Type, width and length are there to read, whatever the list is sorted by.
        for (const int sorted : {3, 0}) {
            list()->sortByColumn(sorted, Qt::AscendingOrder);
            QVERIFY2(list()->columnViewportPosition(4) <= list()->viewport()->width(),
                     qPrintable(QString::number(list()->columnViewportPosition(4))));
        }
        QVERIFY(w().viewport().scene().has(Layer::strips));
        QVERIFY2(controller().panel()->note()->text().contains(QStringLiteral("2 strips")),
                 qPrintable(controller().panel()->note()->text()));
        // Lengths go with the unit.
        ui::set_unit(w(), LengthUnit::inch);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(std::abs(row("Valley 1")->text(3).toDouble() - 40 / 25.4) < 0.05);
        QVERIFY(list()->headerItem()->text(3).contains(QStringLiteral("in")));
        ui::set_unit(w(), LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("strips"));
    }

    void switching_one_off_is_a_step_of_the_history() {
        QVERIFY2(open_and_plan(), qPrintable(w().last_failure()));
        const std::size_t passes = path().passes.size();
        const QImage both = view_picture(w());
        // By the keyboard, as a user may.
        list()->setFocus();
        list()->setCurrentItem(row("Valley 2"));
        QVERIFY(wait_until_settled(w()));
        QTest::keyClick(list(), Qt::Key_Space);
        QVERIFY(wait_until_settled(w()));
        const auto off = [&] {
            return std::get<std::string>(w().document().operation(0).get(switched_off_key));
        };
        QCOMPARE(off(), std::string("Valley 2"));
        QCOMPARE(row("Valley 2")->checkState(0), Qt::Unchecked);
        QCOMPARE(w().document().state(0), OperationState::stale);
        QVERIFY2(controller().panel()->note()->text().contains(QStringLiteral("out of date")),
                 qPrintable(controller().panel()->note()->text()));
        QVERIFY(changed_pixels(both, view_picture(w())) > 200);
        shot(w(), QStringLiteral("strips-switched-off"));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(off(), std::string());
        QCOMPARE(row("Valley 2")->checkState(0), Qt::Checked);
        QCOMPARE(w().document().state(0), OperationState::planned);
        w().document().undo_stack().redo();
        QVERIFY(plan());
        QCOMPARE(row("Valley 2")->checkState(0), Qt::Unchecked);
        QVERIFY(path().passes.size() < passes && !path().passes.empty());
        for (const Pass& pass : path().passes)
            for (const CutterLocation& c : pass.cl)
                QVERIFY((c.tip.y() > 0) == (path().strips[0].centers[0][0].y() > 0));
        row("Valley 2")->setCheckState(0, Qt::Checked);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(off(), std::string());
    }

    void the_previous_tool_is_chosen_by_its_name() {
        QVERIFY(open_grooves());
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        auto* tools = w().properties().form()->findChild<QComboBox*>(QStringLiteral("previous_tool"));
        QVERIFY(tools != nullptr);
        QCOMPARE(tools->count(), 2);
        QVERIFY2(tools->currentText().startsWith(QStringLiteral("T1 ")), qPrintable(tools->currentText()));
    }

    void a_strip_chosen_in_the_list_is_flown_to_and_shows_the_previous_tool() {
        QVERIFY2(open_and_plan(), qPrintable(w().last_failure()));
        const Scene& scene = w().viewport().scene();
        const CameraPlace before = scene.camera().place();
        QVERIFY(scene.marks().touches().empty());
        const double y = path().strips[1].centers[0][0].y();
        const QRect cell = list()->visualItemRect(row("Valley 2"));
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, cell.center() + QPoint(20, 0));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(controller().chosen(), std::optional<std::size_t>(1));
        const CameraPlace after = scene.camera().place();
        QVERIFY(std::abs(after.target.y() - y) < 1 && std::abs(before.target.y() - y) > 5);
        QVERIFY(stands_over(y));
        QVERIFY2(readout().startsWith(QStringLiteral("Tool 1 touches")), qPrintable(readout()));
        shot(w(), QStringLiteral("strips-touch"));
        // Along the strip.
        const double x = scene.tool().pose()->tip.x();
        QSlider* place = controller().panel()->place();
        place->setValue(place->maximum() / 8);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(stands_over(y) && std::abs(scene.tool().pose()->tip.x() - x) > 5);
        // Without it the operation's own tool is back, at its path.
        controller().panel()->touch_box()->setChecked(false);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(scene.marks().touches().empty());
        QVERIFY(scene.tool().pose() && !stands_over(y));
        controller().panel()->touch_box()->setChecked(true);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(stands_over(y));
        // Stepping along the path takes the tool.
        QTest::keyClick(&w(), Qt::Key_Right);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(scene.marks().touches().empty());
    }

    void a_click_in_the_view_chooses_the_strip() {
        QVERIFY2(open_and_plan(), qPrintable(w().last_failure()));
        w().viewport().set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        for (const double y : {groove_y, -groove_y, groove_y}) {
            const CameraPlace before = w().viewport().scene().camera().place();
            QVERIFY(click_groove(y));
            QVERIFY(controller().chosen());
            const Strip& strip = path().strips[*controller().chosen()];
            QVERIFY(std::abs(strip.centers[0][0].y() - y) < 0.1);
            QCOMPARE(list()->currentItem()->text(0), text(strip.name));
            QVERIFY(stands_over(y));
            QVERIFY(std::abs(w().viewport().scene().tool().pose()->tip.x() - 3) < 1.2);
            QVERIFY((w().viewport().scene().camera().place().target - before.target).norm() < 1e-9);
        }
        // Between the grooves there is no strip: what was chosen stays, and the place is marked.
        const auto chosen = controller().chosen();
        QVERIFY(click_groove(0.5));
        QCOMPARE(controller().chosen(), chosen);
        // With the list out of sight tool and touches are, too; the strips are seen as any operation's
        // regions.
        dock()->close();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().viewport().scene().has(Layer::strips));
        QVERIFY(w().viewport().scene().marks().touches().empty());
    }

    void a_small_dark_window() {
        QVERIFY2(open_and_plan(), qPrintable(w().last_failure()));
        w().set_theme(Theme::dark);
        w().resize(800, 600);
        QVERIFY(wait_until_settled(w()));
        dock()->raise();
        controller().choose(0, true);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("strips-small-dark"));
        QVERIFY(w().width() <= 800);
        // Names are read whole.
        const int icon = list()->visualItemRect(row("Valley 1")).height() + 2 * list()->iconSize().width();
        QVERIFY2(list()->columnWidth(0)
                     > icon + list()->fontMetrics().horizontalAdvance(QStringLiteral("Valley 2")),
                 qPrintable(QString::number(list()->columnWidth(0))));
        QVERIFY(list()->isVisible() && list()->height() >= 60);
        w().set_theme(Theme::light);
    }

    /// Wherever strips come to lie in a small window, their labels leave the legend to be read.
    void labels_keep_off_the_legend() {
        QVERIFY2(open_and_plan(), qPrintable(w().last_failure()));
        w().resize(800, 600);
        w().viewport().set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        Viewport& view = w().viewport();
        Scene& scene = view.scene();
        const Vec3 anchor(0, groove_y, 0);
        const double per_mm =
            (scene.camera().display_of(Vec3(1, 0, 0)) - scene.camera().display_of(Vec3(0, 0, 0))).norm();
        const double ratio = view.devicePixelRatioF(), wide = view.width() * ratio,
                     high = view.height() * ratio;
        // Well within the legend.
        const QRect legend(int(wide) - int(140 * ratio), int(18 * ratio), int(122 * ratio), int(80 * ratio));
        QImage first;
        for (const double y : {0.5, 0.25, 0.15, 0.08})
            for (const double x : {0.3, 0.5, 0.6, 0.7, 0.8, 0.9}) {
                scene.camera().center_on(anchor + Vec3(0.5 - x, 0, 0) * wide / per_mm
                                         + Vec3(0, y - 0.5, 0) * high / per_mm);
                view.refresh();
                const QImage now = view_picture(w()).copy(legend);
                if (x == 0.7 && y == 0.15) shot(w(), QStringLiteral("strips-legend"));
                if (first.isNull()) first = now;
                QVERIFY2(changed_pixels(first, now) == 0,
                         qPrintable(
                             QString("%1 pixels at (%2, %3)").arg(changed_pixels(first, now)).arg(x).arg(y)));
            }
    }
};

FACETMILL_TEST(TestWindowStrips)
#include "test_window_strips.moc"
