// Turning parts in the window: the unrolled path beside the view, playback that turns the part, an axis
// through picked points.
#include "core/strategy/lathe/lathe_finish.h"
#include "tests/screenshot/window_support.h"
#include "ui/layer_bar.h"
#include "ui/message_bar.h"
#include "ui/parameter_form.h"
#include "ui/playback_bar.h"
#include "ui/playback_controller.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/unrolled_controller.h"
#include "ui/unrolled_view.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"
#include "viz/palette.h"
#include "viz/path_tint.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>
#include <climits>
#include <cmath>
#include <tuple>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

class TestWindowLathe : public QObject, public WindowFixture {
    Q_OBJECT

    UnrolledView* view() { return w().unrolled().view(); }
    QDockWidget* dock() { return w().findChild<QDockWidget*>(QStringLiteral("unrolled_dock")); }
    std::shared_ptr<const OperationResult> finish() { return w().document().result(0); }
    const std::vector<Motion>& motions() { return finish()->program.motions.motions; }
    LatheCommon settings() { return *w().document().operation(0).turning(); }

    /// Jasra's square prism, 50 mm square and 40 mm long about X, with coarse finishing alone.
    bool open_prism() {
        w().new_from_sample("square-prism");
        if (!wait_until_settled(w()) || !w().document().part_is_current()) return false;
        w().document().remove_operation(0);
        w().document().change(QStringLiteral("coarse"), [](Project& p) {
            p.operations[0]->common().tolerance = 0.5;
            p.operations[0]->set("points_per_turn", ParameterValue(72.0));
            p.operations[0]->set("side_feed", ParameterValue(4.0));
        });
        w().tree().select({TreeNode::Kind::operation, 0});
        return wait_until_settled(w());
    }
    bool plan_prism() {
        if (!open_prism()) return false;
        w().plan();
        return wait_until_settled(w()) && w().document().state(0) == OperationState::planned;
    }

    double angle_of(const CutterLocation& at) {
        const TurnedPath& t = *finish()->path.as<TurnedPath>();
        const double angle =
            degrees(std::atan2(at.axis.dot(t.axis.direction.cross(t.zero)), at.axis.dot(t.zero)));
        return angle < 0 ? angle + 360 : angle;
    }
    CutterLocation tool() { return *w().viewport().scene().tool().pose(); }

    void wheel(QPointF at, int steps) {
        QWheelEvent event(at, view()->mapToGlobal(at), {}, QPoint(0, 120 * steps), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(view(), &event);
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() {
        w().set_theme(Theme::light);
        close_window();
    }

    void nothing_to_unroll_says_why() {
        QVERIFY(!dock()->isVisible());
        dock()->toggleViewAction()->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(view()->isVisible() && !view()->path());
        QVERIFY2(view()->empty_text().contains(QStringLiteral("Plan an operation")),
                 qPrintable(view()->empty_text()));
        QVERIFY(!w().findChild<QToolButton*>(QStringLiteral("unrolled_picture"))->isEnabled());
        const QImage nothing = view()->grab().toImage();
        // A click and the wheel do no harm.
        QTest::mouseClick(view(), Qt::LeftButton, {}, view()->rect().center());
        wheel(view()->rect().center(), 3);
        // With three axes there is a path, but nothing that turns.
        QVERIFY(open_and_plan());
        QVERIFY(!view()->path());
        QVERIFY2(view()->empty_text().contains(QStringLiteral("No operation turns the part")),
                 qPrintable(view()->empty_text()));
        QVERIFY(changed_pixels(nothing, view()->grab().toImage()) > 50);
        shot(w(), QStringLiteral("unrolled-empty"));
    }

    void a_plan_brings_it_colored_by_depth() {
        QVERIFY(plan_prism());
        QVERIFY(dock()->isVisible() && view()->path());
        const UnrolledPath& path = *view()->path();
        QCOMPARE(path.unit, std::string("mm"));
        QCOMPARE(path.operation, finish());
        // Round stock about the prism's corners: the sides' middles lie 10.36 below, and what margin there
        // is.
        const double stock = finish()->path.as<TurnedPath>()->stock_radius;
        QVERIFY(std::abs(path.high - (stock - 25)) < 0.51);
        QVERIFY(std::abs(path.low - (stock - 25 * std::sqrt(2.0))) < 0.51);
        const QImage picture = view()->grab().toImage();
        const auto seen = [&](double along, double angle) {
            const QPointF at = view()->place_of(along, angle);
            return picture.pixelColor(int(at.x()), int(at.y()));
        };
        const auto is = [&](double along, double angle, double depth) {
            const Rgb c = path_tint_color(unrolled_share(path, depth));
            const QColor there = seen(along, angle);
            return std::abs(there.redF() - float(c.r)) + std::abs(there.greenF() - float(c.g))
                       + std::abs(there.blueF() - float(c.b))
                   < 0.1F;
        };
        for (const double side : {93.0, 183.0, 273.0}) // beside the grid lines
            QVERIFY2(is(17.3, side, stock - 25), qPrintable(seen(17.3, side).name()));
        for (const double corner : {45.0, 135.0, 225.0, 315.0})
            QVERIFY2(is(17.3, corner, stock - 25 * std::sqrt(2.0)), qPrintable(seen(17.3, corner).name()));
        shot(w(), QStringLiteral("unrolled-light"));
        // The legend and the lengths follow the unit.
        ui::set_unit(w(), LengthUnit::inch);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(view()->path()->unit, std::string("in"));
        QVERIFY(std::abs(view()->path()->high - path_high_inches(stock)) < 0.51 / mm_per_inch);
        QVERIFY(changed_pixels(picture, view()->grab().toImage()) > 100);
        shot(w(), QStringLiteral("unrolled-inches"));
        ui::set_unit(w(), LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        w().set_theme(Theme::dark);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("unrolled-dark"));
        // A picture of its own.
        const QString file = scratch_folder(QStringLiteral("unrolled")) + QStringLiteral("/unrolled.png");
        w().unrolled().save_picture(file);
        QVERIFY(wait_until_settled(w()));
        const QImage saved(file);
        QVERIFY(saved.width() >= 1000 && saved.pixelColor(2, 2) == Qt::white);
        saved.save(QStringLiteral(FACETMILL_PICTURE_OUT "/unrolled-export.png"));
    }

    /// The stock that the part needs as it turns, from its extents.
    void the_report_says_what_stock_it_takes() {
        QVERIFY(plan_prism());
        const auto* report = w().findChild<QTextBrowser*>(QStringLiteral("report"));
        QVERIFY(report);
        const QString said = report->toPlainText();
        QVERIFY2(said.contains(QStringLiteral("Smallest stock"))
                     && said.contains(QStringLiteral("Ø 70.71 × 40 mm")),
                 qPrintable(said));
        QVERIFY(said.contains(QStringLiteral("Side feed"))
                && said.contains(QStringLiteral("Stock turns in")));
        QVERIFY(!said.contains(QStringLiteral("from X")) && !said.contains(QStringLiteral("Out of reach")));
        // A longer part is not the one that was planned: its length stands beside no figure of that.
        w().document().change(QStringLiteral("Longer"), [](Project& p) { p.part.scale = 1.5; });
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().part_is_current() && w().document().state(0) == OperationState::stale);
        const QString stale = report->toPlainText();
        QVERIFY2(stale.contains(QStringLiteral("Ø 70.71 mm")) && !stale.contains(QStringLiteral(" × ")),
                 qPrintable(stale));
    }

    /// Slips in the form say so beside their field and change nothing; those that only planning can find
    /// fail with their reason.
    void bad_input_is_told() {
        QVERIFY(open_prism());
        const LatheCommon before = settings();
        for (const auto& [key, value, says, good] :
             {std::tuple("side_feed", "0", "above 0", "4"), std::tuple("points_per_turn", "2", "3", "72"),
              std::tuple("core_radius", "-1", "0", "0")}) {
            enter(w(), key, QString::fromUtf8(value));
            const QString said = error_under(w(), key);
            QVERIFY2(said.contains(QString::fromUtf8(says)), qPrintable(QString(key) + ": " + said));
            QVERIFY(settings().side_feed == before.side_feed
                    && settings().points_per_turn == before.points_per_turn
                    && settings().core_radius == before.core_radius);
            shot(w(), QStringLiteral("lathe-bad-") + QLatin1String(key));
            enter(w(), key, QString::fromUtf8(good));
            QCOMPARE(error_under(w(), key), QString());
        }
        const auto fails = [&](const char* key, const ParameterValue& value, const char* says) {
            w().document().change(QStringLiteral("bad"), [&](Project& p) {
                p.operations[0] = make_operation("lathe_finish");
                p.operations[0]->common().tolerance = 0.5;
                p.operations[0]->set(key, value);
            });
            w().plan();
            if (!wait_until_settled(w())) return false;
            return w().document().state(0) == OperationState::failed
                   && w().message_bar().message().contains(QString::fromUtf8(says));
        };
        QVERIFY2(fails("allowance", 40.0, "nothing of the stock stands above"),
                 qPrintable(w().message_bar().message()));
        QVERIFY2(fails("points_per_turn", 72.5, "whole number"), qPrintable(w().message_bar().message()));
        QVERIFY2(fails("chuck", std::array<double, 2>{80, 100}, "no room"),
                 qPrintable(w().message_bar().message()));
        // The part beside its axis.
        w().document().change(QStringLiteral("beside"), [&](Project& p) {
            p.operations[0] = make_operation("lathe_finish");
            p.operations[0]->set("axis", std::string("points"));
            p.operations[0]->set("axis_from", std::array<double, 3>{0, 60, 0});
            p.operations[0]->set("axis_to", std::array<double, 3>{40, 60, 0});
        });
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("35 mm beside the part")),
                 qPrintable(w().message_bar().message()));
        QVERIFY(!view()->path());
        shot(w(), QStringLiteral("lathe-beside"));
    }

    void a_click_here_and_a_click_there_mean_the_same() {
        QVERIFY(plan_prism());
        const UnrolledPath& path = *view()->path();
        for (const auto& [along, angle] :
             {std::pair(12.0, 60.0), std::pair(31.0, 200.0), std::pair(20.0, 359.0)}) {
            const QPoint at = view()->place_of(along, angle).toPoint();
            QTest::mouseClick(view(), Qt::LeftButton, {}, at);
            QVERIFY(wait_until_settled(w()));
            QVERIFY(view()->motion().has_value());
            const std::size_t motion = *view()->motion();
            QCOMPARE(tool().tip, motions()[motion].to.tip);
            QCOMPARE(tool().axis, motions()[motion].to.axis);
            // None is nearer in pixels, by more than what the picker calls alike.
            const auto pixels = [&](const UnrolledPath::Place& p) {
                const QRectF in = view()->frame();
                const QPointF by = view()->place_of(double(p.along), double(p.angle)) - at;
                const double y = std::remainder(by.y(), in.height());
                return std::hypot(by.x(), y);
            };
            const double away = pixels(*unrolled_place(path, motion));
            for (const UnrolledPath::Place& p : path.places)
                QVERIFY(pixels(p) >= away - 1);
            QVERIFY(std::abs(std::remainder(angle_of(tool()) - angle, 360.0)) < 5);
            QVERIFY(std::abs(tool().tip.x() - along) < 4);
        }
        // In the view: a place of the path that is seen from above.
        w().viewport().set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        std::size_t wanted = 0;
        double nearest = infinity;
        for (std::size_t i = 0; i < motions().size(); ++i)
            if (motions()[i].kind == MotionKind::cut && motions()[i].to.axis.z() > 0.999)
                if (const double off = std::abs(motions()[i].to.tip.x() - 22); off < nearest) {
                    nearest = off;
                    wanted = i;
                }
        QVERIFY(nearest < 4);
        const QImage before = view()->grab().toImage();
        const Vec2 pixel = w().viewport().scene().camera().display_of(motions()[wanted].to.tip)
                           / w().viewport().devicePixelRatioF();
        QTest::mouseClick(&w().viewport(), Qt::LeftButton, {},
                          QPoint(int(std::lround(pixel.x())), int(std::lround(pixel.y()))));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(view()->motion().has_value());
        const Motion& at = motions()[*view()->motion()];
        QCOMPARE(at.to.tip, tool().tip);
        QVERIFY2((at.to.tip - motions()[wanted].to.tip).norm() < 3,
                 qPrintable(QString::number((at.to.tip - motions()[wanted].to.tip).norm())));
        QVERIFY(changed_pixels(before, view()->grab().toImage()) > 20); // its mark
        // Steps along the path.
        const std::size_t here = *view()->motion();
        view()->setFocus();
        QTest::keyClick(view(), Qt::Key_Right);
        QCOMPARE(*view()->motion(), here + 1);
        QTest::keyClick(view(), Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(*view()->motion(), here - 9);
        QCOMPARE(tool().tip, motions()[here - 9].to.tip);
        // A drag takes the tool along.
        QTest::mousePress(view(), Qt::LeftButton, {}, view()->place_of(10, 120).toPoint());
        const Vec3 from = tool().tip;
        QTest::mouseMove(view(), view()->place_of(30, 240).toPoint());
        QTest::mouseRelease(view(), Qt::LeftButton, {}, view()->place_of(30, 240).toPoint());
        QVERIFY((tool().tip - from).norm() > 10);
    }

    void wheel_and_drag_zoom_and_move() {
        QVERIFY(plan_prism());
        const UnrolledWindow all = view()->window();
        QCOMPARE(all, unrolled_whole(*view()->path()));
        const QImage whole = view()->grab().toImage();
        const QPointF about = view()->place_of(15, 250);
        wheel(about, 6);
        const UnrolledWindow near = view()->window();
        QVERIFY(near.to - near.from < 0.3 * (all.to - all.from) && near.high - near.low < 0.3 * 360);
        const QPointF now = view()->place_of(15, 250);
        QVERIFY(std::hypot(now.x() - about.x(), now.y() - about.y()) < 1); // the pointer's place stays
        QVERIFY(changed_pixels(whole, view()->grab().toImage()) > 200);
        shot(w(), QStringLiteral("unrolled-zoomed"));
        // A click counts where it is seen.
        QTest::mouseClick(view(), Qt::LeftButton, {}, view()->place_of(15, 250).toPoint());
        QVERIFY(std::abs(angle_of(tool()) - 250) < 5);
        const QPoint middle = view()->rect().center();
        QTest::mousePress(view(), Qt::RightButton, {}, middle);
        QTest::mouseMove(view(), middle + QPoint(-40, -30));
        QTest::mouseRelease(view(), Qt::RightButton, {}, middle + QPoint(-40, -30));
        QVERIFY(view()->window().from > near.from && view()->window().low < near.low);
        // It never leaves what there is, and follows the tool.
        wheel(about, -40);
        QCOMPARE(view()->window(), all);
        wheel(about, 60);
        QVERIFY(view()->window().high - view()->window().low >= 0.36 - 1e-9);
        QVERIFY(!view()->grab().toImage().isNull());
        w().unrolled().place_shown(0, motions().size() / 2, 1);
        const auto place = unrolled_place(*view()->path(), motions().size() / 2);
        QVERIFY(place.has_value());
        QVERIFY(view()->window().from <= double(place->along) && view()->window().to >= double(place->along));
        QTest::mouseDClick(view(), Qt::LeftButton, {}, middle);
        QCOMPARE(view()->window(), all);
        wheel(about, 3);
        QTest::keyClick(view(), Qt::Key_Home);
        QCOMPARE(view()->window(), all);
        wheel(about, 3);
        QTest::mouseClick(w().findChild<QToolButton*>(QStringLiteral("unrolled_all")), Qt::LeftButton);
        QCOMPARE(view()->window(), all);
    }

    /// On the screen the tool stands still and the part turns under it.
    void playback_turns_the_part() {
        QVERIFY(plan_prism());
        QTest::keyClick(&w(), Qt::Key_Period);
        QVERIFY(w().verification().engaged());
        QVERIFY(!w().verification().bar()->turns_part());
        QTest::mouseClick(w().verification().bar()->button("play_turn"), Qt::LeftButton);
        QVERIFY(w().verification().bar()->turns_part());
        PlaybackController& playback = w().verification().playback();
        std::vector<std::size_t> cuts;
        for (std::size_t i = 0; i < motions().size(); ++i)
            if (motions()[i].kind == MotionKind::cut) cuts.push_back(i);
        playback.go_to(double(cuts[cuts.size() / 2]) + 1);
        QVERIFY(wait_until_settled(w()));
        const auto on_screen = [&] { // the tool's axis in the camera's frame
            const CameraPlace place = w().viewport().scene().camera().place();
            const Vec3 right = place.up.cross(place.toward_eye);
            const Vec3 axis = tool().axis;
            return Vec3(axis.dot(right), axis.dot(place.up), axis.dot(place.toward_eye));
        };
        const Vec3 before = on_screen(), eye = w().viewport().scene().camera().place().toward_eye;
        const QImage picture = view_picture(w());
        const double angle = angle_of(tool());
        const auto turned =
            std::find_if(cuts.begin() + long(cuts.size() / 2), cuts.end(), [&](std::size_t i) {
                return std::abs(std::remainder(angle_of(motions()[i].to) - angle, 360.0)) > 30;
            });
        QVERIFY(turned != cuts.end());
        playback.go_to(double(*turned) + 1);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(std::abs(std::remainder(angle_of(tool()) - angle, 360.0)) > 20);
        QVERIFY2((on_screen() - before).norm() < 1e-6,
                 qPrintable(QString::number((on_screen() - before).norm())));
        QVERIFY((w().viewport().scene().camera().place().toward_eye - eye).norm() > 0.3);
        QVERIFY(changed_pixels(picture, view_picture(w())) > 500);
        // The mark goes along.
        QCOMPARE(*view()->motion(), *turned);
        shot(w(), QStringLiteral("unrolled-playback"));
        // A click while it is played back takes the playback there.
        QTest::mouseClick(view(), Qt::LeftButton, {}, view()->place_of(8, 100).toPoint());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(std::abs(tool().tip.x() - 8) < 4);
        QVERIFY(std::abs(playback.position() - double(*view()->motion())) <= 1);
    }

    void a_small_window() {
        QVERIFY(plan_prism());
        for (const Theme theme : {Theme::light, Theme::dark}) {
            w().set_theme(theme);
            w().resize(800, 600);
            QVERIFY(wait_until_settled(w()));
            QVERIFY2(w().width() <= 800 && w().height() <= 600,
                     qPrintable(QString("%1 x %2").arg(w().width()).arg(w().height())));
            dock()->raise();
            QVERIFY(wait_until_settled(w()));
            QVERIFY(view()->isVisible());
            const QRectF in = view()->frame();
            QVERIFY(QRectF(view()->rect()).contains(in) && in.width() > 60 && in.height() > 60);
            shot(w(), theme == Theme::dark ? QStringLiteral("unrolled-small-dark")
                                           : QStringLiteral("unrolled-small-light"));
            QVERIFY(w().viewport().width() > 300); // the view keeps room
        }
        w().resize(1280, 800);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("unrolled-wide-again"));
    }

    /// Titles of the axes and of the legend are whole in any size that a dock may have.
    void titles_are_whole_in_a_narrow_view() {
        QVERIFY(plan_prism());
        UnrolledView narrow;
        narrow.set_path(view()->path());
        const QFontMetricsF fm(narrow.font());
        for (const QSize& size : {narrow.minimumSizeHint(), QSize(230, 320), QSize(420, 180)}) {
            QVERIFY(size.width() >= narrow.minimumSizeHint().width());
            narrow.resize(size);
            const QRectF in = narrow.frame();
            QVERIFY(in.width() >= 60 && in.height() >= 60 && QRectF(narrow.rect()).contains(in));
            const QImage image = narrow.grab().toImage().convertToFormat(QImage::Format_RGB32);
            const QRgb ground = image.pixel(1, 1);
            // From the first to the last ink in a part of the picture, to the right or (upright) up.
            const auto ink = [&](const QRect& part, bool upright) {
                int first = INT_MAX, last = INT_MIN;
                for (int y = part.top(); y <= part.bottom(); ++y)
                    for (int x = part.left(); x <= part.right(); ++x)
                        if (image.pixel(x, y) != ground) {
                            first = std::min(first, upright ? y : x);
                            last = std::max(last, upright ? y : x);
                        }
                return double(last) - double(first);
            };
            const int line = int(fm.height()), bottom = size.height() - 8;
            const auto is_whole = [&](double length, const char* title) {
                const double whole = fm.horizontalAdvance(QString::fromUtf8(title));
                return length > whole - 6 && length < whole + 6;
            };
            const double across = ink(QRect(0, bottom - line + 1, size.width(), line), false);
            QVERIFY2(is_whole(across, "Along the axis (mm)"), qPrintable(QString::number(across)));
            const double up = ink(QRect(8, 0, line, bottom - line), true);
            QVERIFY2(is_whole(up, "Turning angle"), qPrintable(QString::number(up)));
            // Its upper half: beside the lower one are labels of the topmost ticks.
            const double legend = ink(QRect(0, 0, size.width(), int(in.top()) - line / 2 - 2), false);
            QVERIFY2(is_whole(legend, "Depth (mm)"), qPrintable(QString::number(legend)));
            // Numbers beside the legend end before the view does.
            const int right = size.width() - 4;
            QVERIFY(ink(QRect(right, 0, 4, size.height()), false) < 0);
            image.save(QStringLiteral(FACETMILL_PICTURE_OUT "/unrolled-narrow-%1x%2.png")
                           .arg(size.width())
                           .arg(size.height()));
        }
    }

    void the_axis_through_two_picked_points() {
        QVERIFY(open_prism());
        const auto button = [&](const char* key) {
            return w().properties().form()->findChild<QToolButton*>(QStringLiteral("pick_")
                                                                    + QLatin1String(key));
        };
        QVERIFY(!button("axis_from")); // an axis along X needs no points
        auto* axis = w().properties().form()->findChild<QComboBox*>(QStringLiteral("axis"));
        axis->setFocus();
        QTest::keyClick(axis, Qt::Key_End);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(settings().axis, LatheCommon::Axis::points);
        QVERIFY(button("axis_from") && button("axis_from")->isVisible());
        QVERIFY(!field(w(), "axis_through"));
        QVERIFY(button("axis_to")->isVisible());
        shot(w(), QStringLiteral("axis-points"));

        Viewport& viewport = w().viewport();
        const auto click_at = [&](const Vec3& p, Qt::KeyboardModifiers modifiers) {
            const Vec2 pixel = viewport.scene().camera().display_of(p) / viewport.devicePixelRatioF();
            QTest::mouseClick(&viewport, Qt::LeftButton, modifiers,
                              QPoint(int(std::lround(pixel.x())), int(std::lround(pixel.y()))));
        };
        const auto far = [](const std::array<double, 3>& a, const Vec3& b) {
            return (Vec3(a[0], a[1], a[2]) - b).norm();
        };
        // A corner of the end at x = 0, given roughly.
        viewport.set_view(StandardView::left);
        QVERIFY(wait_until_settled(w()));
        QTest::mouseClick(button("axis_from"), Qt::LeftButton);
        QVERIFY(w().message_bar().message().contains(QStringLiteral("axis from")));
        QVERIFY(button("axis_from")->isChecked());
        QCOMPARE(viewport.cursor().shape(), Qt::CrossCursor);
        shot(w(), QStringLiteral("axis-picking"));
        click_at(Vec3(0, 24.6, 24.6), {});
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(far(settings().axis_from, Vec3(0, 25, 25)) < 1e-4,
                 qPrintable(QString("%1 %2 %3")
                                .arg(settings().axis_from[0])
                                .arg(settings().axis_from[1])
                                .arg(settings().axis_from[2])));
        QVERIFY(!button("axis_from")->isChecked());
        QVERIFY(viewport.cursor().shape() != Qt::CrossCursor);
        // The middle of that end, from anywhere on it; one step of the history each.
        QTest::mouseClick(button("axis_from"), Qt::LeftButton);
        click_at(Vec3(0, 9, -11), Qt::ControlModifier);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(far(settings().axis_from, Vec3(0, 0, 0)) < 1e-4);
        action(w(), "undo")->trigger();
        QVERIFY(far(settings().axis_from, Vec3(0, 25, 25)) < 1e-4);
        action(w(), "redo")->trigger();
        // Beside the part it stays on; Esc leaves it; then a click is a click.
        QTest::mouseClick(button("axis_to"), Qt::LeftButton);
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, QPoint(4, viewport.height() / 2));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("beside the part")));
        QTest::keyClick(&w(), Qt::Key_Escape);
        QVERIFY(!button("axis_to")->isChecked());
        const LatheCommon before = settings();
        click_at(Vec3(0, 5, 5), {});
        QCOMPARE(settings().axis_to, before.axis_to);
        // The other end.
        viewport.set_view(StandardView::right);
        QVERIFY(wait_until_settled(w()));
        QTest::mouseClick(button("axis_to"), Qt::LeftButton);
        click_at(Vec3(40, -7, 3), Qt::ControlModifier);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(far(settings().axis_to, Vec3(40, 0, 0)) < 1e-4);
        shot(w(), QStringLiteral("axis-picked"));
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().document().state(0) == OperationState::planned, qPrintable(w().last_failure()));
        QVERIFY((finish()->path.as<TurnedPath>()->axis.direction - Vec3::UnitX()).norm() < 1e-6);
        // To look at something else ends it.
        QTest::mouseClick(button("axis_to"), Qt::LeftButton);
        w().tree().select({TreeNode::Kind::part, 0});
        QVERIFY(viewport.cursor().shape() != Qt::CrossCursor);
    }

private:
    static double path_high_inches(double stock) { return (stock - 25) / mm_per_inch; }
};

FACETMILL_TEST(TestWindowLathe)
#include "test_window_lathe.moc"
