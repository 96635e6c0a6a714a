// Rework regions in the window: the dialog with its strips in the view, edits by hand and their undo, and
// both programs of a global-local operation in verification, playback and files.
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/window_support.h"
#include "ui/layer_bar.h"
#include "ui/parameter_form.h"
#include "ui/plot_view.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/region_controller.h"
#include "ui/region_dialog.h"
#include "ui/report_view.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

namespace {

/// A sheet over 52 x 24 mm with two dents that a flat end of 8 mm enters at a large lead only; the left one
/// is the deeper one.
Mesh two_dents() {
    Mesh mesh;
    constexpr int nx = 52, ny = 24;
    const auto dent = [](double x, double y, double depth) {
        return -depth * std::exp(-(x * x + y * y) / 16);
    };
    for (int k = 0; k <= ny; ++k)
        for (int i = 0; i <= nx; ++i) {
            const double x = i - nx / 2, y = k - ny / 2;
            mesh.vertices.emplace_back(x, y, dent(x + 12, y, 1.1) + dent(x - 12, y, 0.8));
        }
    const auto at = [](int i, int k) { return Index(k * (nx + 1) + i); };
    for (int k = 0; k < ny; ++k)
        for (int i = 0; i < nx; ++i) {
            mesh.facets.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.facets.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return mesh;
}

Tool tool(long number, const char* name, double diameter, double corner) {
    Tool t;
    t.number = number;
    t.name = name;
    t.diameter = t.shank_diameter = diameter;
    t.corner_radius = corner;
    t.flute_length = 25;
    t.shank_length = 20;
    return t;
}

} // namespace

class TestWindowRegions : public QObject, public WindowFixture {
    Q_OBJECT

    RegionController& controller() { return w().regions(); }
    RegionDialog& dialog() { return *controller().dialog(); }
    const std::vector<ReworkRegion>& regions() { return controller().found()->found.regions.regions; }
    const GlobalLocalSettings& edits() { return *w().document().operation(0).rework(); }
    double area() {
        double sum = 0;
        for (const ReworkRegion& r : regions())
            sum += r.strip.area;
        return sum;
    }
    QLineEdit* region_field(const char* name) {
        return dialog().form()->findChild<QLineEdit*>(QLatin1String(name));
    }
    void enter_region(const char* name, const QString& words) {
        dialog().activateWindow();
        type_over(region_field(name), words);
        QTest::keyClick(region_field(name), Qt::Key_Return);
    }
    void switch_region(int row, bool on) {
        dialog()
            .regions()
            .table()
            ->item(row, RegionPage::name_column)
            ->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    }

    /// A sheet with dents and a global-local operation on it, selected.
    bool open_dents() {
        const QString folder = scratch_folder(QStringLiteral("dents"));
        save_stl(two_dents(), (folder + QStringLiteral("/dents.stl")).toStdString(), LengthUnit::mm, {});
        w().open_file(folder + QStringLiteral("/dents.stl"), LengthUnit::mm);
        if (!wait_until_settled(w())) return false;
        w().document().change(QStringLiteral("Tools"), [](Project& p) {
            p.machine = "tarus-tpi-2000";
            p.tools = {tool(1, "Flat", 8, 0), tool(7, "Ball", 3, 1.5)};
            p.operations.front()->common().tool = 1;
        });
        w().document().add_operation("global_local");
        w().document().remove_operation(0);
        w().document().change(QStringLiteral("Values"), [](Project& p) {
            Operation& o = *p.operations.front();
            o.common().name = "GL";
            o.common().tool = 1;
            o.common().tolerance = 0.1;
            o.set("rework_tool", 7L);
            o.set("direction", 0.0);
            o.set("lead_limit", radians(6));
            o.set("raise_lead_limit", false);
            o.set("rework_offset", 1.0);
            o.set("posture", std::string("cm2"));
        });
        w().tree().select({TreeNode::Kind::operation, 0});
        return wait_until_settled(w()) && w().document().part_is_current();
    }
    bool open_dialog() {
        auto* button = w().properties().findChild<QPushButton*>(QStringLiteral("edit_regions"));
        if (!button || !button->isVisible()) return false;
        button->click();
        return wait_until_settled(w()) && dialog().isVisible();
    }
    /// Window and dialog as they stand over each other.
    void shot_both(const QString& name) {
        QTest::qWait(80);
        (void)QTest::qWaitFor([this] { return w().viewport().finished(); }, patience_ms);
        QImage image = w().grab().toImage().convertToFormat(QImage::Format_RGB32);
        QPainter p(&image);
        p.drawPixmap(dialog().pos() - w().pos(), dialog().grab());
        p.end();
        QDir().mkpath(QStringLiteral(FACETMILL_PICTURE_OUT));
        image.save(QStringLiteral(FACETMILL_PICTURE_OUT "/%1.png").arg(name));
    }
    /// A handle of a strip that can be taken hold of, farthest to one side, and its place in the view.
    std::optional<std::pair<Vec3, QPoint>> handle_of(std::size_t strip, const Vec3& side) {
        std::optional<std::pair<Vec3, QPoint>> best;
        const StripDisplay& display = *controller().shown();
        const auto& handles = display.strips[strip].handles;
        const double ratio = w().viewport().devicePixelRatioF();
        for (std::size_t i = 0; i + 2 < handles.size(); i += 3) {
            const Vec3 p =
                display.center + Vec3(double(handles[i]), double(handles[i + 1]), double(handles[i + 2]));
            const Vec2 at = w().viewport().scene().camera().display_of(p);
            const auto taken = w().viewport().scene().strips().pick_handle(at.x(), at.y(), 2);
            if (!taken || (*taken - p).norm() > 1e-3) continue;
            if (best && side.dot(p) <= side.dot(best->first)) continue;
            best = {p, QPoint(int(std::lround(at.x() / ratio)), int(std::lround(at.y() / ratio)))};
        }
        return best;
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() {
        w().set_theme(Theme::light);
        close_window();
    }

    void opened_from_the_form_only_where_it_belongs() {
        QVERIFY(open_dents());
        auto* button = w().properties().findChild<QPushButton*>(QStringLiteral("edit_regions"));
        QVERIFY(button && button->isVisible());
        w().document().add_operation("finish3");
        w().tree().select({TreeNode::Kind::operation, 1});
        QVERIFY(!button->isVisible());
        controller().open(1);
        QVERIFY(!dialog().isVisible());
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(open_dialog());
        QVERIFY(dialog().windowTitle().contains(QStringLiteral("Settings of Rework Region")));
        w().document().remove_operation(0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!dialog().isVisible());
        QVERIFY(!controller().shown());
    }

    void strips_follow_the_limit() {
        QVERIFY(open_dents());
        const QImage bare = view_picture(w());
        QVERIFY(open_dialog());
        QVERIFY2(dialog().problem().isEmpty(), qPrintable(dialog().problem()));
        QCOMPARE(regions().size(), std::size_t(2));
        QCOMPARE(dialog().regions().table()->rowCount(), 2);
        const QImage strips = view_picture(w());
        QVERIFY(changed_pixels(bare, strips) > 2000);
        QVERIFY(dialog().regions().table()->item(0, RegionPage::reason_column)->text().contains("lead"));
        QCOMPARE(dialog().regions().table()->item(0, RegionPage::tool_column)->text(), QStringLiteral("T7"));
        shot_both(QStringLiteral("regions"));
        // The form takes no more room than its fields.
        const auto* scroll = dialog().findChild<QScrollArea*>();
        const auto* fold = dialog().form()->findChild<QWidget*>(QStringLiteral("advanced"));
        const int end = fold->mapTo(dialog().form(), QPoint(0, fold->height())).y();
        QVERIFY2(std::abs(scroll->viewport()->height() - std::max(end, scroll->minimumHeight())) < 6,
                 qPrintable(QString("%1 for %2").arg(scroll->viewport()->height()).arg(end)));
        const double before = area();

        // Tried while it is typed; a step of the history when it is done.
        const int steps = w().document().undo_stack().index();
        dialog().activateWindow();
        type_over(region_field("lead_limit"), QStringLiteral("9"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(area() < before);
        QCOMPARE(w().document().undo_stack().index(), steps);
        QVERIFY(changed_pixels(strips, view_picture(w())) > 300);
        QTest::keyClick(region_field("lead_limit"), Qt::Key_Return);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().undo_stack().index(), steps + 1);
        QVERIFY(std::abs(std::get<double>(w().document().operation(0).get("lead_limit")) - radians(9))
                < 1e-12);
        // The window answers meanwhile: the newest of quick changes counts.
        const double at_nine = area();
        for (const char* limit : {"12", "7", "3"})
            enter_region("lead_limit", QLatin1String(limit));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(area() > at_nine);
        QVERIFY(std::abs(std::get<double>(w().document().operation(0).get("lead_limit")) - radians(3))
                < 1e-12);
        action(w(), "undo")->trigger();
        action(w(), "undo")->trigger();
        action(w(), "undo")->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(area(), at_nine);
        QCOMPARE(region_field("lead_limit")->text(), QStringLiteral("9"));
        // The layer hides them, closing takes them away: nothing is planned.
        w().layers().set_shown(ViewLayer::regions, false);
        QVERIFY(changed_pixels(bare, view_picture(w())) < 100);
        w().layers().set_shown(ViewLayer::regions, true);
        dialog().close();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!controller().shown());
        QVERIFY(changed_pixels(bare, view_picture(w())) < 100);
    }

    void edits_by_hand_are_undone_and_saved() {
        QVERIFY(open_dents());
        QVERIFY(open_dialog());
        const double whole = area();
        switch_region(1, false);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(edits().region_edits.size(), std::size_t(1));
        QVERIFY(regions()[0].strip.enabled && !regions()[1].strip.enabled);
        QVERIFY(dialog().status().contains(QStringLiteral("1 switched off")));
        switch_region(1, true);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(edits().region_edits.empty()); // as it was: nothing is left of it
        switch_region(1, false);
        QVERIFY(wait_until_settled(w()));

        // Grown by the button, then by hand.
        dialog().choose(std::size_t(0));
        const double first = regions()[0].strip.area;
        dialog().findChild<QToolButton*>(QStringLiteral("grow"))->click();
        dialog().findChild<QToolButton*>(QStringLiteral("grow"))->click();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(regions()[0].strip.area > first);
        QCOMPARE(regions()[0].grow, 0.5);
        dialog().regions().table()->item(0, RegionPage::grow_column)->setText(QStringLiteral("wide"));
        QVERIFY2(dialog().problem().contains(QStringLiteral("wide")), qPrintable(dialog().problem()));
        dialog().regions().table()->item(0, RegionPage::grow_column)->setText(QStringLiteral("-0.5"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(dialog().problem().isEmpty());
        QVERIFY(regions()[0].strip.area < first);
        QCOMPARE(edits().region_edits.size(), std::size_t(2));

        // A boundary point is dragged outward in the view.
        w().viewport().set_view(StandardView::top);
        dialog().move(w().pos() + QPoint(900, 120));
        QVERIFY(wait_until_settled(w()));
        const auto handle = handle_of(0, -Vec3::UnitX());
        QVERIFY(handle);
        const double shrunk = regions()[0].strip.area;
        const QPoint to = handle->second - QPoint(40, 0);
        QTest::mousePress(&w().viewport(), Qt::LeftButton, {}, handle->second);
        for (int i = 1; i <= 4; ++i)
            QTest::mouseMove(&w().viewport(), handle->second + (to - handle->second) * i / 4);
        QVERIFY(QTest::qWaitFor([this] { return !controller().busy(); }, patience_ms));
        const double tried = regions()[0].strip.area;
        QVERIFY(tried > shrunk); // before it is let go
        QVERIFY(edits().boundary_drags.empty());
        shot_both(QStringLiteral("regions-dragging"));
        QTest::mouseRelease(&w().viewport(), Qt::LeftButton, {}, to);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(edits().boundary_drags.size(), std::size_t(1));
        QCOMPARE(regions()[0].strip.area, tried);
        const BoundaryDrag drag = edits().boundary_drags[0];
        QVERIFY((Vec3(drag.from[0], drag.from[1], drag.from[2]) - handle->first).norm() < 1e-4);
        QVERIFY(drag.to[0] < drag.from[0]);
        shot_both(QStringLiteral("regions-edited"));

        action(w(), "undo")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(edits().boundary_drags.empty());
        QCOMPARE(regions()[0].strip.area, shrunk);
        action(w(), "redo")->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(regions()[0].strip.area, tried);

        // Kept in the file.
        const QString path = scratch_folder(QStringLiteral("saved")) + QStringLiteral("/job.facetmill");
        QVERIFY(w().files().save_to(path));
        QVERIFY(wait_until_settled(w()));
        const auto kept = edits().region_edits;
        const auto dragged = edits().boundary_drags;
        w().open_file(path);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!dialog().isVisible());
        // To the digits of a file.
        const auto near = [](const std::array<double, 3>& p, const std::array<double, 3>& q) {
            return (Vec3(p[0], p[1], p[2]) - Vec3(q[0], q[1], q[2])).norm() < 1e-6;
        };
        QCOMPARE(edits().region_edits.size(), kept.size());
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const RegionEdit& loaded = edits().region_edits[i];
            QVERIFY(near(loaded.place, kept[i].place) && loaded.enabled == kept[i].enabled
                    && std::abs(loaded.grow - kept[i].grow) < 1e-9);
        }
        QCOMPARE(edits().boundary_drags.size(), dragged.size());
        QVERIFY(near(edits().boundary_drags[0].from, dragged[0].from)
                && near(edits().boundary_drags[0].to, dragged[0].to));
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(open_dialog());
        QCOMPARE(regions().size(), std::size_t(2));
        QVERIFY(std::abs(regions()[0].strip.area - tried) < 1e-6 * tried);
        QVERIFY(!regions()[1].strip.enabled);
        QCOMPARE(dialog().regions().table()->item(1, RegionPage::name_column)->checkState(), Qt::Unchecked);

        dialog().findChild<QPushButton*>(QStringLiteral("drop_edits"))->click();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(edits().region_edits.empty() && edits().boundary_drags.empty());
        QVERIFY(std::abs(area() - whole) < 1e-6 * whole);
        QVERIFY(!dialog().findChild<QPushButton*>(QStringLiteral("drop_edits"))->isEnabled());
    }

    void what_grew_together_is_switched_as_one() {
        QVERIFY(open_dents());
        QVERIFY(open_dialog());
        dialog().regions().table()->item(0, RegionPage::grow_column)->setText(QStringLiteral("12"));
        QVERIFY(wait_until_settled(w()));
        dialog()
            .regions()
            .table()
            ->item(int(regions().size()) - 1, RegionPage::grow_column)
            ->setText(QStringLiteral("12"));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(regions().size(), std::size_t(1));
        switch_region(0, false);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!regions()[0].strip.enabled);
        switch_region(0, true);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(regions()[0].strip.enabled);
    }

    void the_trade_off_is_charted() {
        QVERIFY(open_dents());
        QVERIFY(open_dialog());
        dialog().tabs()->setCurrentIndex(1);
        QVERIFY(!dialog().advice().plot()->empty());
        const PlotContent time = dialog().advice().plot()->content();
        QCOMPARE(time.series.size(), std::size_t(3));
        QVERIFY(time.x.size() > 5);
        for (std::size_t i = 0; i < time.x.size(); ++i)
            QVERIFY(std::abs(time.series[0].y[i] + time.series[1].y[i] - time.series[2].y[i]) < 1e-9);
        QVERIFY(std::abs(*dialog().advice().plot()->cursor() - 6) < 1e-9);
        QVERIFY(dialog().advice().suggested());
        shot_both(QStringLiteral("regions-chart"));
        for (const int quantity : {1, 2}) {
            dialog().advice().quantity_box()->setCurrentIndex(quantity);
            QVERIFY(!dialog().advice().plot()->empty());
        }
        // Less to rework with more lead.
        const auto& share = dialog().advice().plot()->content().series[0].y;
        QVERIFY(std::is_sorted(share.rbegin(), share.rend()) && share.front() > share.back());
        dialog().advice().axis_box()->setCurrentIndex(1);
        QVERIFY(dialog().advice().plot()->content().x_label.contains(QStringLiteral("diameter")));
        dialog().advice().axis_box()->setCurrentIndex(0);
        dialog().advice().quantity_box()->setCurrentIndex(0);
        // A drag in the chart is one step.
        const int steps = w().document().undo_stack().index();
        PlotView* plot = dialog().advice().plot();
        const auto at = [&](double x) { return plot->place_of(x, plot->view().center().y()).toPoint(); };
        QTest::mousePress(plot, Qt::LeftButton, {}, at(8));
        QTest::mouseMove(plot, at(10));
        QTest::mouseMove(plot, at(12));
        QTest::mouseRelease(plot, Qt::LeftButton, {}, at(12));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().undo_stack().index(), steps + 1);
        const double lead = degrees(std::get<double>(w().document().operation(0).get("lead_limit")));
        QVERIFY2(std::abs(lead - 12) < 0.5, qPrintable(QString::number(lead)));
        // The suggestion is taken by a button.
        dialog().advice().use_suggested()->click();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(std::get<double>(w().document().operation(0).get("lead_limit")),
                 *dialog().advice().suggested());
        QVERIFY(!dialog().advice().use_suggested()->isEnabled());
    }

    /// Where planning came to other regions than the dialog finds, it says so and has the figures of both.
    void figures_before_and_after_planning_are_told_apart() {
        QVERIFY(open_dents());
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        auto& d = w().document();
        const auto result = d.result(0);
        auto other = std::make_shared<OperationResult>(*result);
        auto path = *result->path.as<GlobalLocalPath>();
        auto rework = std::make_shared<ReworkPlan>(*path.rework);
        rework->regions.area = 0.125 * rework->regions.part_area;
        path.rework = rework;
        other->path.detail = path;
        const std::string fingerprint = Document::fingerprint(d.project(), 0);
        d.take({{d.operation_id(0), other, {}, fingerprint}});
        QVERIFY(wait_until_settled(w()) && open_dialog());
        const QString both = dialog().status().replace(QChar::Nbsp, QChar(' '));
        const int found = dialog().regions().table()->rowCount();
        QVERIFY2(both.startsWith(QStringLiteral("Before planning: %1 region").arg(found)), qPrintable(both));
        const QString planned = QStringLiteral("%1, 12 %").arg(rework->regions.regions.size()); // two digits
        QVERIFY2(both.contains(planned), qPrintable(both));
        // The report has those of the plan alone.
        QVERIFY2(w().report().toPlainText().contains(planned + QStringLiteral(" of the surface")),
                 qPrintable(w().report().toPlainText()));
        // As they were found, one figure is enough.
        rework = std::make_shared<ReworkPlan>(*rework);
        rework->regions = controller().found()->found.regions;
        path.rework = rework;
        other = std::make_shared<OperationResult>(*result);
        other->path.detail = path;
        d.take({{d.operation_id(0), other, {}, fingerprint}});
        QVERIFY(wait_until_settled(w()));
        dialog().close();
        QVERIFY(open_dialog());
        QVERIFY2(!dialog().status().contains(QStringLiteral("planning")), qPrintable(dialog().status()));
    }

    void what_cannot_be_is_said_in_place() {
        QVERIFY(open_dents());
        QVERIFY(open_dialog());
        enter_region("lead_limit", QStringLiteral("50"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(dialog().form()->error("lead_limit").contains(QStringLiteral("assumed")),
                 qPrintable(dialog().problem()));
        QCOMPARE(dialog().regions().table()->rowCount(), 0);
        QVERIFY(!controller().shown());
        shot_both(QStringLiteral("regions-error"));
        enter_region("lead_limit", QStringLiteral("-1"));
        QVERIFY(!dialog().form()->error("lead_limit").isEmpty());
        enter_region("lead_limit", QStringLiteral("6"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(dialog().problem().isEmpty(), qPrintable(dialog().problem()));
        QCOMPARE(dialog().regions().table()->rowCount(), 2);
        enter_region("rework_offset", QStringLiteral("500"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(dialog().form()->error("rework_offset").contains(QStringLiteral("larger than the part")));
        enter_region("rework_offset", QStringLiteral("1"));
        enter_region("lead_limit", QStringLiteral("44"));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(dialog().regions().table()->rowCount(), 0);
        shot_both(QStringLiteral("regions-none"));
    }

    void in_the_dark_and_in_a_small_window() {
        QVERIFY(open_dents());
        w().set_theme(Theme::dark);
        QVERIFY(open_dialog());
        switch_region(1, false);
        QVERIFY(wait_until_settled(w()));
        shot_both(QStringLiteral("regions-dark"));
        dialog().tabs()->setCurrentIndex(1);
        shot_both(QStringLiteral("regions-chart-dark"));
        w().resize(800, 600);
        dialog().resize(430, 520);
        dialog().move(w().pos() + QPoint(360, 50));
        QVERIFY(wait_until_settled(w()));
        shot_both(QStringLiteral("regions-chart-800x600"));
        dialog().tabs()->setCurrentIndex(0);
        shot_both(QStringLiteral("regions-800x600"));
    }

    void both_programs_are_verified_played_and_written() {
        QVERIFY(open_dents());
        w().verify(); // plans first
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        const auto result = w().document().result(0);
        QVERIFY(result && result->further.size() == 1);
        const auto rework = result->further.front();
        const VerificationModel& model = w().verification().model();
        QVERIFY(model.any());
        QCOMPARE(model.outcome().programs.size(), std::size_t(2));
        QVERIFY2(model.verdict() == ui::Verdict::verified, qPrintable(model.failure_text()));
        QCOMPARE(model.verdict(0), ui::Verdict::verified);
        QCOMPARE(model.verification().figures.uncut_fraction, 0.0);
        QVERIFY(model.current());
        // Drawn and picked: the strips of the plan, both paths, each with its tool.
        QVERIFY(controller().shown() && controller().shown()->strips.size() == result->path.strips.size());
        shot(w(), QStringLiteral("regions-verified"));
        const PlaybackTrack& track = w().verification().playback().track();
        QCOMPARE(track.operation_count(), std::size_t(2));
        QCOMPARE(track.operation(0).tool->number, 1L);
        QCOMPARE(track.operation(1).tool->number, 7L);
        QCOMPARE(track.motion_count(),
                 result->program.motions.motions.size() + rework->program.motions.motions.size());
        w().tree().select({TreeNode::Kind::stock_after, 0});
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().verification().playback().position(), double(track.motion_count()));
        shot(w(), QStringLiteral("regions-stock-after"));
        QVERIFY(w().report().toPlainText().contains(QStringLiteral("Rework regions")));
        // A gouge of the rework path condemns the operation.
        auto bad = std::make_shared<OperationResult>(*result);
        auto worse = std::make_shared<OperationResult>(*rework);
        for (Motion& m : worse->program.motions.motions)
            if (m.kind == MotionKind::cut) m.to.tip.z() -= 0.5;
        bad->further = {worse};
        auto& d = w().document();
        d.take({{d.operation_id(0), bad, {}, Document::fingerprint(d.project(), 0)}});
        QVERIFY(wait_until_settled(w()));
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(model.verdict(0), ui::Verdict::failed);
        QVERIFY(model.why(0).contains(QStringLiteral("gouges")));
        d.take({{d.operation_id(0), result, {}, Document::fingerprint(d.project(), 0)}});
        QVERIFY(wait_until_settled(w()));
        const QString folder = scratch_folder(QStringLiteral("programs"));
        w().exports().save_programs(folder);
        QVERIFY(wait_until_settled(w()));
        QStringList written = QDir(folder).entryList(QDir::Files);
        written.sort();
        QCOMPARE(written, (QStringList{QStringLiteral("01-GL-rework.apt"), QStringLiteral("01-GL.apt"),
                                       QStringLiteral("report.json")}));
    }
};

FACETMILL_TEST(TestWindowRegions)
#include "test_window_regions.moc"
