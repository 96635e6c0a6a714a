// Paths in colours and in charts: what can be chosen, and that chart, tool, playback and steps go together.
#include "core/job/planner.h"
#include "tests/screenshot/window_support.h"
#include "ui/cspace_controller.h"
#include "ui/cspace_panel.h"
#include "ui/elided_label.h"
#include "ui/inspection_controller.h"
#include "ui/inspection_panel.h"
#include "ui/layer_bar.h"
#include "ui/plot_view.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QStandardItemModel>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <set>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

class TestWindowInspection : public QObject, public WindowFixture {
    Q_OBJECT

    InspectionController& charts() { return w().inspection(); }
    PlotView* plot() { return charts().panel()->plot(); }
    QComboBox* colors() { return w().layers().quantity_box(); }
    QDockWidget* dock() { return w().findChild<QDockWidget*>(QStringLiteral("chart_dock")); }
    bool open_charts() {
        dock()->toggleViewAction()->trigger();
        return wait_until_settled(w()) && dock()->isVisible();
    }
    bool offered(PathQuantity q) {
        return qobject_cast<QStandardItemModel*>(colors()->model())->item(int(q))->isEnabled();
    }
    QString why_not(PathQuantity q) {
        return qobject_cast<QStandardItemModel*>(colors()->model())->item(int(q))->toolTip();
    }
    const std::vector<Motion>& motions() { return w().document().result(0)->program.motions.motions; }
    Vec3 tip() { return w().viewport().scene().tool().pose()->tip; }
    void click(double x) {
        QTest::mouseClick(plot(), Qt::LeftButton, {},
                          plot()->place_of(x, plot()->view().center().y()).toPoint());
    }
    void wheel(int steps, Qt::KeyboardModifiers modifiers = {}) {
        const QPointF at = QRectF(plot()->rect()).center();
        QWheelEvent event(at, plot()->mapToGlobal(at), {}, QPoint(0, 120 * steps), {}, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(plot(), &event);
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void nothing_without_a_plan() {
        for (std::size_t q = 1; q < path_quantities; ++q) {
            QVERIFY(!offered(PathQuantity(q)));
            QVERIFY(!why_not(PathQuantity(q)).isEmpty());
        }
        QVERIFY(offered(PathQuantity::kind));
        QVERIFY(open_charts());
        QVERIFY(plot()->empty());
        QVERIFY(plot()->empty_text().contains(QStringLiteral("Plan")));
        QVERIFY(!charts().panel()->findChild<QToolButton*>(QStringLiteral("chart_table"))->isEnabled());
        shot(w(), QStringLiteral("charts-none"));
    }

    void three_axes() {
        QVERIFY(open_and_plan());
        QVERIFY(open_charts());
        QVERIFY(plot()->empty());
        QVERIFY(plot()->empty_text().contains(QStringLiteral("three axes")));
        shot(w(), QStringLiteral("charts-three-axes"));
        for (const PathQuantity q : {PathQuantity::tilt, PathQuantity::cusp}) {
            QVERIFY(!offered(q));
            QVERIFY(!why_not(q).isEmpty());
        }
        const QImage plain = view_picture(w());
        for (const PathQuantity q : {PathQuantity::lead, PathQuantity::elapsed, PathQuantity::motion_time,
                                     PathQuantity::joint_rate}) {
            QVERIFY(offered(q));
            colors()->setCurrentIndex(int(q));
            QVERIFY(wait_until_settled(w()));
            QVERIFY2(changed_pixels(plain, view_picture(w())) > 500, qPrintable(colors()->currentText()));
        }
        colors()->setCurrentIndex(0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().layers().findChild<QWidget*>(QStringLiteral("path_scale"))->isHidden());
        QVERIFY(changed_pixels(plain, view_picture(w())) < 20);
    }

    void the_path_in_colors() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        const QImage plain = view_picture(w());
        // By keys, as a user without a mouse.
        colors()->setFocus();
        for (int q = 1; q < int(path_quantities); ++q) {
            QVERIFY2(offered(PathQuantity(q)), qPrintable(colors()->itemText(q)));
            QTest::keyClick(colors(), Qt::Key_Down);
            QCOMPARE(colors()->currentIndex(), q);
            QVERIFY(wait_until_settled(w()));
            QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
            QVERIFY2(changed_pixels(plain, view_picture(w())) > 1000, qPrintable(colors()->currentText()));
            QVERIFY(w().layers().findChild<QWidget*>(QStringLiteral("path_scale"))->isVisible());
            shot(w(), QStringLiteral("path-by-%1").arg(q));
        }
        // With the next plan the colours are there again; in another unit too.
        w().document().change(QStringLiteral("Feed"),
                              [](Project& p) { p.operations[0]->common().feed *= 2; });
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(plain, view_picture(w())) > 1000);
        colors()->setCurrentIndex(int(PathQuantity::feed));
        QVERIFY(wait_until_settled(w()));
        const QImage inches = view_picture(w());
        ui::set_unit(w(), LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(inches, view_picture(w())) > 50); // the legend
        w().layers().set_shown(ViewLayer::cuts, false);
        QVERIFY(changed_pixels(inches, view_picture(w())) > 1000);
    }

    void the_cursor_and_the_tool_go_together() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        QVERIFY(open_charts());
        QVERIFY(!plot()->empty());
        const PlotContent& content = plot()->content();
        QCOMPARE(content.x.size(), motions().size());
        QCOMPARE(content.series.size(), std::size_t(2));
        QVERIFY(content.series[0].name.startsWith(QChar('C'))
                && content.series[1].name.startsWith(QChar('A')));
        const auto run = w().document().result(0)->machine_run;
        QCOMPARE(content.series[0].marks.size(), run->reversals[3]);
        QCOMPARE(content.series[1].marks.size(), run->reversals[4]);
        QCOMPARE(content.series[1].high_limit, 110.0);
        QVERIFY(plot()->cursor().has_value());
        shot(w(), QStringLiteral("charts-axes"));

        // A click in the chart moves the tool, and a drag.
        const double end = content.x.back();
        click(0.5 * end);
        const double at = *plot()->cursor();
        QVERIFY(std::abs(at - 0.5 * end) < 0.05 * end);
        const auto motion =
            std::size_t(std::lower_bound(content.x.begin(), content.x.end(), at) - content.x.begin());
        QVERIFY((tip() - motions()[motion].to.tip).norm() < 1e-9);
        const QPoint from = plot()->place_of(0.5 * end, plot()->view().center().y()).toPoint();
        QTest::mousePress(plot(), Qt::LeftButton, {}, from);
        QTest::mouseMove(plot(), from + QPoint(40, 0));
        QTest::mouseRelease(plot(), Qt::LeftButton, {}, from + QPoint(40, 0));
        QVERIFY(*plot()->cursor() > at);
        QVERIFY((tip() - motions()[motion].to.tip).norm() > 1e-3);
        const QString readout = charts().panel()->readout()->text();
        QVERIFY(readout.contains(QStringLiteral("GOTO")) && readout.contains(QStringLiteral("C ")));
        // In a small window it leaves out the time, then the length, and no word from within.
        ui::ElidedLabel* label = charts().panel()->readout();
        const QString least = readout.section(QStringLiteral("   "), 0, 0) + QStringLiteral("   ")
                              + readout.section(QStringLiteral("   "), 3);
        label->setFixedWidth(label->fontMetrics().horizontalAdvance(least) + 10);
        QCOMPARE(label->shown_text(), least);
        label->setMinimumWidth(0);
        label->setMaximumWidth(QWIDGETSIZE_MAX);

        // Steps from the chart and in the view move both.
        const double before = *plot()->cursor();
        QTest::keyClick(plot(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(*plot()->cursor() > before);
        w().cspace().step(-30, 0);
        QVERIFY(*plot()->cursor() < before);
        QVERIFY(wait_until_settled(w()));
        // A pick of a path in the view.
        Scene& scene = w().viewport().scene();
        const Motion& picked = motions()[motions().size() / 4];
        const Vec2 pixel = scene.camera().display_of(picked.to.tip) / w().viewport().devicePixelRatioF();
        const double was = *plot()->cursor();
        QTest::mouseClick(&w().viewport(), Qt::LeftButton, {}, QPoint(int(pixel.x()), int(pixel.y())));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(*plot()->cursor() != was);

        // Over time: the same place.
        const Vec3 here = tip();
        charts().panel()->chart_box()->setCurrentIndex(int(Chart::rotary_over_time));
        QVERIFY(plot()->content().x_label.startsWith(QStringLiteral("Time")));
        QVERIFY(plot()->cursor().has_value());
        QVERIFY((tip() - here).norm() < 1e-12);

        // Playback carries the cursor along.
        QTest::keyClick(&w(), Qt::Key_Period);
        QVERIFY(w().verification().engaged());
        w().verification().playback().go_to(double(motions().size() / 2) + 0.5);
        const double middle =
            0.5 * (plot()->content().x[motions().size() / 2 - 1] + plot()->content().x[motions().size() / 2]);
        QVERIFY(std::abs(*plot()->cursor() - middle) <= plot()->content().x.back() * 1e-3 + 1e-9
                || *plot()->cursor() > plot()->content().x[motions().size() / 2 - 1]);
        click(0.2 * plot()->content().x.back());
        QVERIFY(w().verification().playback().position() < double(motions().size()) / 2);
    }

    void zoom_and_move() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        QVERIFY(open_charts());
        const QRectF whole = plot()->view();
        wheel(4);
        QVERIFY(plot()->view().width() < 0.5 * whole.width());
        QCOMPARE(plot()->view().height(), whole.height());
        shot(w(), QStringLiteral("charts-zoomed"));
        const QPoint middle = plot()->rect().center();
        const double left = plot()->view().left();
        QTest::mousePress(plot(), Qt::RightButton, {}, middle);
        QTest::mouseMove(plot(), middle + QPoint(-60, 0));
        QTest::mouseRelease(plot(), Qt::RightButton, {}, middle + QPoint(-60, 0));
        QVERIFY(plot()->view().left() > left);
        QVERIFY(plot()->view().right() <= whole.right() + 1e-9);
        wheel(3, Qt::ControlModifier);
        QVERIFY(plot()->view().height() < whole.height());
        // The cursor is followed when it leaves.
        charts().place_shown(0, motions().size() - 1, 1);
        QVERIFY(plot()->view().right() >= *plot()->cursor() - 1e-9 * whole.width());
        QTest::mouseDClick(plot(), Qt::LeftButton, {}, middle);
        QCOMPARE(plot()->view(), whole);
        wheel(-4);
        QCOMPARE(plot()->view(), whole);
        wheel(2);
        QTest::keyClick(plot(), Qt::Key_Home);
        QCOMPARE(plot()->view(), whole);
    }

    void the_step_over_along_the_part() {
        QVERIFY(open_and_plan());
        QVERIFY(open_charts());
        charts().panel()->chart_box()->setCurrentIndex(int(Chart::stepover));
        QVERIFY(!plot()->empty());
        const StrategyResult& path = w().document().result(0)->path;
        const PlotContent& content = plot()->content();
        // Partial passes are among them: nearer to their neighbours than whole ones are to each other.
        std::set<int> drives;
        for (const Pass& pass : path.passes)
            drives.insert(pass.drive);
        QVERIFY(drives.size() >= std::size_t(path.drive_planes));
        QCOMPARE(content.x.size(), 2 * (drives.size() - 1));
        const auto [least, most] =
            std::minmax_element(content.series[0].y.begin(), content.series[0].y.end());
        QVERIFY(*least > 0);
        QVERIFY(*least < path.stepover_min / mm_per_inch + 1e-9);
        QVERIFY(*most < path.stepover_max / mm_per_inch + 1e-9);
        QVERIFY(content.y_label.contains(QStringLiteral("(in)")));
        shot(w(), QStringLiteral("charts-stepover"));
        // A click leads to the pass; arrow keys to the next one.
        click(content.x[content.x.size() / 2]);
        const double v = *plot()->cursor();
        QVERIFY(std::abs(v - content.x[content.x.size() / 2]) < 1e-9);
        QVERIFY(charts().panel()->readout()->text().startsWith(QStringLiteral("Pass")));
        QTest::keyClick(plot(), Qt::Key_Right);
        QVERIFY(*plot()->cursor() > v);
        QTest::keyClick(plot(), Qt::Key_Left);
        QVERIFY(std::abs(*plot()->cursor() - v) < 1e-9);
    }

    void exports() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        QVERIFY(open_charts());
        const QString folder = scratch_folder(QStringLiteral("charts"));
        const auto table = [&](const char* name) {
            const QString path = folder + QLatin1String(name);
            charts().save_table(path);
            QFile file(path);
            if (!wait_until_settled(w()) || !file.open(QIODevice::ReadOnly)) return QList<QByteArray>();
            return file.readAll().trimmed().split('\n');
        };
        const auto axes = table("/axes.csv");
        QCOMPARE(std::size_t(axes.size()), motions().size() + 1);
        QCOMPARE(axes.front(), QByteArray("goto,kind,way_in,time_s,C_deg,C_turns_back,A_deg,A_turns_back"));
        const auto last = axes.back().split(',');
        QVERIFY(std::abs(last[3].toDouble() - w().document().result(0)->totals.time_seconds) < 1e-4);
        charts().save_picture(folder + QStringLiteral("/axes.png"));
        QVERIFY(wait_until_settled(w()));
        const QImage picture(folder + QStringLiteral("/axes.png"));
        QCOMPARE(picture.size(), QSize(1600, 900));
        picture.save(QStringLiteral(FACETMILL_PICTURE_OUT "/charts-export.png")); // to be looked at
        charts().panel()->chart_box()->setCurrentIndex(int(Chart::stepover));
        const auto steps = table("/steps.csv");
        QCOMPARE(int(steps.size()), w().document().result(0)->path.drive_planes + 1);
        QCOMPARE(steps.front(), QByteArray("pass,place_in,stepover_to_next_in"));
        charts().save_picture(folder + QStringLiteral("/steps.png"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().last_failure().isEmpty() && QFile::exists(folder + QStringLiteral("/steps.png")));
        charts().save_picture(folder + QStringLiteral("/no/axes.png"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().last_failure().isEmpty());
    }

    void a_small_dark_window() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        w().set_theme(Theme::dark);
        colors()->setCurrentIndex(int(PathQuantity::lead));
        QVERIFY(open_charts());
        w().resize(800, 600);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("charts-small"));
        QVERIFY(w().width() <= 800);
        QVERIFY(w().viewport().height() >= 150);
        QVERIFY(plot()->height() >= 100);
        w().set_theme(Theme::light);
    }
};

FACETMILL_TEST(TestWindowInspection)
#include "test_window_inspection.moc"
