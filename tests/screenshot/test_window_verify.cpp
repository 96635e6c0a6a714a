// Verification and playback in the window: F6 to the badges, what makes them stale, and a stock that is cut
// while one watches.
#include "core/job/program_files.h"
#include "core/output/motion_time.h"
#include "tests/screenshot/window_support.h"
#include "ui/camera_flight.h"
#include "ui/first_steps.h"
#include "ui/html_label.h"
#include "ui/icons.h"
#include "ui/layer_bar.h"
#include "ui/operation_list.h"
#include "ui/playback_bar.h"
#include "ui/project_tree.h"
#include "ui/report_view.h"
#include "ui/text.h"
#include "ui/verdict_advice.h"
#include "ui/verification_controller.h"
#include "ui/verification_panel.h"
#include "ui/viewport.h"
#include "ui/workspaces.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>
#include <map>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

namespace {

constexpr auto operation_kind = TreeNode::Kind::operation;

/// One patch of StockPlayback's surface at least is another than before.
bool stock_changed(const std::vector<std::shared_ptr<const StockPatch>>& a,
                   const std::vector<std::shared_ptr<const StockPatch>>& b) {
    return a != b;
}

/// An operation that cuts `deeper` below the surface in the middle of its longest pass, as planned otherwise.
std::shared_ptr<const OperationResult> with_gouge(const OperationResult& from, double deeper) {
    auto bad = std::make_shared<OperationResult>(from);
    std::map<std::size_t, std::vector<Motion*>> cuts; // of each pass
    for (Motion& m : bad->program.motions.motions)
        if (m.kind == MotionKind::cut) cuts[m.pass].push_back(&m);
    const auto longest = std::max_element(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) {
        return a.second.size() < b.second.size();
    });
    longest->second[longest->second.size() / 2]->to.tip.z() -= deeper;
    return bad;
}

} // namespace

class TestWindowVerify : public QObject, public WindowFixture {
    Q_OBJECT

    VerificationController& controller() { return w().verification(); }
    PlaybackController& playback() { return controller().playback(); }
    PlaybackBar& bar() { return *controller().bar(); }
    QTreeWidgetItem* badge_row(std::size_t i = 0) { return w().tree().item({operation_kind, i}); }
    QString badge(std::size_t i = 0) { return badge_row(i)->data(1, Qt::AccessibleTextRole).toString(); }
    bool verify() {
        w().verify();
        return wait_until_settled(w()) && controller().model().any();
    }
    /// Puts a path that gouges in the place of the planned one.
    void plant_gouge(double deeper) {
        auto& d = w().document();
        d.take({{d.operation_id(0),
                 with_gouge(*d.result(0), deeper),
                 {},
                 Document::fingerprint(d.project(), 0)}});
    }

    /// What is asked before programs are exported: title and buttons, by name. Cancelled.
    QStringList asked_at_export() {
        QString title;
        QStringList buttons;
        QTimer::singleShot(50, qApp, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box) return;
            title = box->windowTitle();
            for (const QAbstractButton* b : box->buttons())
                buttons << b->text().remove(QChar('&'));
            box->reject();
        });
        action(w(), "export")->trigger();
        buttons.sort();
        return QStringList{title} + buttons;
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void nothing_is_there_at_first() {
        QVERIFY(!action(w(), "verify")->isEnabled());
        QVERIFY(bar().isHidden());
        QVERIFY(open_part());
        QVERIFY(action(w(), "verify")->isEnabled());
        QCOMPARE(controller().panel()->verdict_line(), QStringLiteral("Not verified"));
        QVERIFY(!controller().doubt().isEmpty());
        QVERIFY(w().tree().tree()->isColumnHidden(1));
        QVERIFY(bar().isHidden()); // nothing is planned
        w().findChild<QDockWidget*>(QStringLiteral("verification_dock"))->raise();
        shot(w(), QStringLiteral("verify-empty"));
    }

    void f6_plans_and_verifies() {
        QVERIFY(open_part());
        w().tree().select({operation_kind, 0});
        enter(w(), "tolerance", QStringLiteral("0.02"));
        QTest::keyClick(&w(), Qt::Key_F6);
        QVERIFY(w().job().running());
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        const VerificationModel& model = controller().model();
        QVERIFY(model.current());
        QCOMPARE(model.verdict(), ui::Verdict::verified);
        QCOMPARE(badge(), QStringLiteral("Verified"));
        QVERIFY(!w().tree().tree()->isColumnHidden(1));
        QVERIFY(!badge_row()->icon(1).isNull());
        QVERIFY(badge_row()->toolTip(1).contains(QStringLiteral("no gouge")));
        QVERIFY(controller().doubt().isEmpty());
        QVERIFY(w().viewport().scene().has(Layer::deviation));
        QVERIFY(controller().panel()->figures_text().contains(QStringLiteral("Deepest gouge")));
        // The table of slopes says what its lengths are in.
        QVERIFY2(controller().panel()->figures_text().contains(QStringLiteral("Uncut\n\nin\nin\nin\n")),
                 qPrintable(controller().panel()->figures_text()));
        QVERIFY(controller().panel()->histogram()->histogram()->total > 0);
        QVERIFY(w().message_bar().message().contains(QStringLiteral("no gouge")));
        // The part has its colours in the view, no path lies over them, and it loses them with the layer.
        QCOMPARE(w().workspaces().current(), Workspace::verify);
        QVERIFY(!w().layers().shown(ViewLayer::cuts) && !w().layers().shown(ViewLayer::rapids));
        const QImage colored = view_picture(w());
        shot(w(), QStringLiteral("verified"));
        w().layers().set_shown(ViewLayer::deviation, false);
        QVERIFY(changed_pixels(colored, view_picture(w())) > 5000);
        w().layers().set_shown(ViewLayer::deviation, true);
        QVERIFY(wait_until_settled(w()));
        // The path is where it belongs, and what is switched here stays here.
        w().layers().set_shown(ViewLayer::edges, true);
        w().workspaces().enter(Workspace::plan);
        QVERIFY(w().layers().shown(ViewLayer::cuts) && w().layers().shown(ViewLayer::rapids));
        QVERIFY(!w().layers().shown(ViewLayer::deviation) && !w().layers().shown(ViewLayer::edges));
        w().workspaces().enter(Workspace::verify);
        QVERIFY(!w().layers().shown(ViewLayer::cuts) && w().layers().shown(ViewLayer::edges));
        w().layers().set_shown(ViewLayer::edges, false);
        w().set_theme(Theme::dark);
        shot(w(), QStringLiteral("verified-dark"));
        w().set_theme(Theme::light);
    }

    void a_gouge_fails_and_is_found() {
        QVERIFY(open_and_plan());
        plant_gouge(1.5);
        QVERIFY(verify());
        const VerificationModel& model = controller().model();
        QCOMPARE(model.verdict(), ui::Verdict::failed);
        QVERIFY(std::abs(model.verification().figures.gouge_max - 1.5) < 0.5);
        QCOMPARE(badge(), QStringLiteral("Failed verification"));
        QVERIFY(controller().panel()->verdict_line().startsWith(QStringLiteral("Failed: gouges up to 0.0")));
        QVERIFY(controller().doubt().contains(QStringLiteral("failed")));

        // What failed is not called unverified, and to verify it again is not offered.
        QCOMPARE(asked_at_export(), (QStringList{QStringLiteral("Export programs that failed?"),
                                                 QStringLiteral("Cancel"), QStringLiteral("Export anyway")}));

        // The deepest one leads to its place and to the motion that made it.
        auto* list = controller().panel()->findings();
        QVERIFY(list->topLevelItemCount() > 0);
        QTreeWidgetItem* first = list->topLevelItem(0);
        QCOMPARE(first->text(0), QStringLiteral("Gouge"));
        const Finding& f = model.findings().front();
        QVERIFY(f.by.known());
        const CameraPlace before = w().viewport().scene().camera().place();
        w().findChild<QDockWidget*>(QStringLiteral("verification_dock"))->raise();
        QTest::qWait(20);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(first).center());
        QVERIFY(wait_until_settled(w()));
        const CameraPlace after = w().viewport().scene().camera().place();
        QVERIFY((after.target - f.place).norm() < 1e-6);
        QVERIFY(after.height < before.height);
        QCOMPARE(playback().target(), playback().track().position_of(f.by));
        QCOMPARE(bar().goto_box()->value(), int(f.by.motion + 1));
        QCOMPARE(playback().tool().tip,
                 w().document().result(0)->program.motions.motions[f.by.motion].to.tip);
        QVERIFY(w().viewport().scene().has(Layer::tool) && w().viewport().scene().has(Layer::marker));
        shot(w(), QStringLiteral("verify-finding"));
        // Sorted by depth the deepest is last.
        list->sortByColumn(1, Qt::AscendingOrder);
        double last = -1;
        for (int i = 0; i < list->topLevelItemCount(); ++i) {
            const double depth = list->topLevelItem(i)->text(1).toDouble();
            QVERIFY(depth >= last);
            last = depth;
        }
        list->sortByColumn(2, Qt::DescendingOrder);
        shot(*controller().panel(), QStringLiteral("verify-panel"));
    }

    /// A path that ends half-way leaves half of the part: failed with the reason, until the user allows it.
    void what_stays_uncut_fails_until_it_is_allowed() {
        QVERIFY(open_and_plan());
        const auto* steps = w().findChild<ui::FirstSteps*>();
        auto& d = w().document();
        auto half = std::make_shared<OperationResult>(*d.result(0));
        auto& motions = half->program.motions.motions;
        motions.resize(motions.size() / 2);
        const auto take_half = [&] {
            d.take({{d.operation_id(0), half, {}, Document::fingerprint(d.project(), 0)}});
            return verify();
        };
        QVERIFY(take_half());
        const VerificationModel& model = controller().model();
        QCOMPARE(model.verdict(), ui::Verdict::failed);
        QVERIFY(!steps->done(ui::FirstSteps::Step::judge)); // what was found is looked at first
        QVERIFY(!model.verification().gouged() && model.verification().uncut_share > 0.3);
        QVERIFY2(controller().panel()->verdict_line().contains(QStringLiteral("left uncut")),
                 qPrintable(controller().panel()->verdict_line()));
        QVERIFY(controller().panel()->figures_text().contains(QStringLiteral("fits but does not go there")));
        QVERIFY(badge_row()->toolTip(1).contains(QStringLiteral("left uncut")));
        // With a word of what to do, in the message and in the panel.
        const QString advice = ui::verdict_advice(model.verification(), d.project()).text;
        QVERIFY2(!advice.isEmpty() && w().message_bar().message().endsWith(advice),
                 qPrintable(w().message_bar().message()));
        const auto notes = controller().panel()->findChildren<QLabel*>();
        QVERIFY(
            std::any_of(notes.begin(), notes.end(), [&](const QLabel* l) { return l->text() == advice; }));
        w().findChild<QDockWidget*>(QStringLiteral("verification_dock"))->raise();
        shot(w(), QStringLiteral("verify-uncut"));
        // The limit is a node of the project, undone as any edit.
        w().tree().select({TreeNode::Kind::limits, 0});
        shot(w(), QStringLiteral("verify-limits"));
        enter(w(), "uncut_limit", QStringLiteral("0.9"));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(d.project().limits.uncut_limit, 0.9);
        QCOMPARE(model.verdict(), ui::Verdict::stale);
        QVERIFY(verify());
        QCOMPARE(model.verdict(), ui::Verdict::verified);
        QVERIFY(steps->done(ui::FirstSteps::Step::judge));
        d.undo_stack().undo();
        QCOMPARE(d.project().limits.uncut_limit, 0.02);
        QCOMPARE(model.verdict(), ui::Verdict::stale);
    }

    void an_edit_makes_it_stale() {
        QVERIFY(open_and_plan());
        QVERIFY(verify());
        QVERIFY(controller().model().current());
        enter(w(), "feed", QStringLiteral("77"));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(controller().model().verdict(), ui::Verdict::stale);
        QCOMPARE(badge(), QStringLiteral("Verification out of date"));
        QCOMPARE(controller().panel()->verdict_line(), QStringLiteral("Out of date"));
        QVERIFY(controller().doubt().contains(QStringLiteral("since the project was changed")));
        QVERIFY(bar().isHidden()); // there is nothing true to be played back
        w().findChild<QDockWidget*>(QStringLiteral("verification_dock"))->raise();
        shot(w(), QStringLiteral("verify-stale"));
        // Back as it was, the verdict holds again.
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(controller().model().current());
        QCOMPARE(badge(), QStringLiteral("Verified"));
        QVERIFY(!bar().isHidden());
        // Another operation in the plan: what was judged is no longer the plan.
        ui::duplicate_operation(w().document(), 0);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(badge(0), QStringLiteral("Verification out of date"));
        QCOMPARE(badge(1), QStringLiteral("Not verified"));
        // A new project has none of it.
        w().document().clear();
        QVERIFY(!controller().model().any());
        QVERIFY(!w().viewport().scene().has(Layer::deviation));
    }

    void cancel_leaves_the_old_verdict() {
        QVERIFY(open_and_plan());
        w().verify();
        QVERIFY(w().job().running());
        QTest::keyClick(&w(), Qt::Key_Escape);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!controller().model().any());
        QCOMPARE(controller().model().verdict(), ui::Verdict::none);
        QVERIFY(w().last_failure().isEmpty());
        QVERIFY(verify());
        w().verify();
        w().cancel();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(controller().model().current());
    }

    void the_range_is_edited() {
        QVERIFY(open_and_plan());
        QVERIFY(verify());
        const DeviationScale first = w().viewport().scene().deviation().scale();
        const QImage before = view_picture(w());
        auto* range = controller().panel()->range();
        w().findChild<QDockWidget*>(QStringLiteral("verification_dock"))->raise();
        QTest::qWait(20);
        type_over(range->high(), QStringLiteral("0.5"));
        QTest::keyClick(range->high(), Qt::Key_Return);
        const DeviationScale wide = w().viewport().scene().deviation().scale();
        QVERIFY(std::abs(wide.high - 12.7) < 1e-9); // inches
        QVERIFY(std::abs(wide.low - first.low) < 1e-3);
        QCOMPARE(controller().panel()->histogram()->histogram()->scale.high, wide.high);
        QVERIFY(changed_pixels(before, view_picture(w())) > 200);
        QTest::mouseClick(range->findChild<QToolButton*>(QStringLiteral("range_reset")), Qt::LeftButton);
        QCOMPARE(w().viewport().scene().deviation().scale().high, first.high);
        // In the other unit the same lengths.
        ui::set_unit(w(), LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(std::abs(range->high()->value() - first.high) < 1e-4);
    }

    void playing_cuts_the_stock() {
        QVERIFY(open_and_plan());
        QVERIFY(!bar().isVisible());
        QVERIFY(!w().layers().shown(ViewLayer::stock));
        bar().speed_box()->setCurrentIndex(bar().speed_box()->findData(-100.0));
        QCOMPARE(playback().speed(), (PlaybackSpeed{PlaybackSpeed::Unit::motions_per_second, 100}));
        w().viewport().setFocus();
        QTest::keyClick(&w().viewport(), Qt::Key_Space);
        QVERIFY(playback().playing());
        QCOMPARE(w().workspaces().current(), Workspace::simulate); // it is what one wants to see
        QVERIFY(w().layers().shown(ViewLayer::stock) && bar().isVisible());
        QVERIFY(QTest::qWaitFor([this] { return playback().position() > 20; }, patience_ms));
        const auto half = playback().stock();
        QVERIFY(!half.empty());
        QVERIFY(QTest::qWaitFor([&] { return stock_changed(half, playback().stock()); }, patience_ms));
        QVERIFY(QTest::qWaitFor([this] { return bar().slider()->value() > 20; }, patience_ms));
        QTest::keyClick(&w().viewport(), Qt::Key_Space);
        QVERIFY(!playback().playing());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(playback().position(), playback().target());
        const double at = playback().target();
        QTest::qWait(100);
        QCOMPARE(playback().target(), at);
        // To its end it stops by itself.
        playback().go_to(double(playback().track().motion_count()) - 3);
        playback().play();
        QVERIFY(QTest::qWaitFor([this] { return !playback().playing(); }, patience_ms));
        QCOMPARE(playback().target(), double(playback().track().motion_count()));
        // It does not play where it is not seen.
        playback().go_to(0);
        playback().play();
        QTest::mouseClick(w().workspaces().button(Workspace::plan), Qt::LeftButton);
        QVERIFY(!playback().playing());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().workspaces().current(), Workspace::plan);
    }

    void steps_scrubbing_and_goto() {
        QVERIFY(open_and_plan());
        QTest::keyClick(&w(), Qt::Key_F10);
        QCOMPARE(w().workspaces().current(), Workspace::simulate);
        const auto& motions = w().document().result(0)->program.motions.motions;
        QTest::mouseClick(bar().button("play_forward"), Qt::LeftButton);
        QCOMPARE(playback().target(), 1.0);
        w().viewport().setFocus();
        QTest::keyClick(&w().viewport(), Qt::Key_Period);
        QTest::keyClick(&w().viewport(), Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(playback().target(), 12.0);
        QTest::keyClick(&w().viewport(), Qt::Key_Comma);
        QCOMPARE(playback().target(), 11.0);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(playback().position(), 11.0);
        QCOMPARE(playback().tool().tip, motions[10].to.tip);
        QCOMPARE(bar().goto_box()->value(), 11);
        QCOMPARE(bar().slider()->value(), 11);

        type_over(bar().goto_box(), QStringLiteral("40"));
        QTest::keyClick(bar().goto_box(), Qt::Key_Return);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(playback().position(), 40.0);
        QCOMPARE(playback().tool().tip, motions[39].to.tip);
        const auto at_40 = playback().stock();

        bar().slider()->setValue(int(motions.size()));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(playback().position(), double(motions.size()));
        const QImage cut = view_picture(w());
        shot(w(), QStringLiteral("playback-end"));
        QVERIFY(stock_changed(at_40, playback().stock()));
        QTest::mouseClick(bar().button("play_start"), Qt::LeftButton);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(playback().position(), 0.0);
        QVERIFY(changed_pixels(cut, view_picture(w())) > 3000); // whole again
        bar().slider()->setValue(int(motions.size() / 2));
        QVERIFY(wait_until_settled(w()));
        QTRY_VERIFY_WITH_TIMEOUT(!playback().fine_stock().empty(), patience_ms);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("playback-half"));
        // Hidden, the stock does not follow; the tool does.
        w().layers().set_shown(ViewLayer::stock, false);
        QVERIFY(!playback().follow());
        bar().slider()->setValue(5);
        QCOMPARE(playback().tool().tip, motions[4].to.tip);
        QVERIFY(playback().stock().empty());
        QVERIFY(!w().layers().shown(ViewLayer::stock)); // as the user wants it
    }

    /// Layouts ask for heights again and again.
    void figures_are_laid_out_once_for_a_width() {
        QVERIFY(open_and_plan() && verify());
        auto* figures = w().findChild<HtmlLabel*>(QStringLiteral("figures"));
        QVERIFY(figures && !figures->text().isEmpty());
        QLabel plain;
        plain.setTextFormat(Qt::RichText);
        plain.setWordWrap(true);
        plain.setTextInteractionFlags(figures->textInteractionFlags());
        plain.setFont(figures->font());
        plain.setText(figures->text());
        const std::vector<int> widths{140, 180, 260};
        for (const int width : widths)
            QCOMPARE(figures->heightForWidth(width), plain.heightForWidth(width));
        const int measured = figures->times_measured();
        for (const int width : widths)
            QCOMPARE(figures->heightForWidth(width), plain.heightForWidth(width));
        QCOMPARE(figures->times_measured(), measured);
        const QString words = figures->text() + QStringLiteral("<p>One more.</p>");
        figures->setText(words);
        plain.setText(words);
        QCOMPARE(figures->heightForWidth(180), plain.heightForWidth(180));
        QVERIFY(figures->times_measured() > measured);
        QFont large = figures->font();
        large.setPointSizeF(2 * large.pointSizeF());
        figures->setFont(large);
        plain.setFont(large);
        QCOMPARE(figures->heightForWidth(180), plain.heightForWidth(180));
    }

    void the_report_is_laid_out_when_it_says_something_else() {
        QVERIFY(open_and_plan());
        int times = 0;
        connect(&w().report(), &QTextBrowser::textChanged, this, [&] { ++times; });
        emit w().document().states_changed();
        emit w().document().part_changed();
        QCOMPARE(times, 0);
        const LengthUnit other = w().document().unit() == LengthUnit::mm ? LengthUnit::inch : LengthUnit::mm;
        w().document().change(QStringLiteral("unit"), [&](Project& p) { p.unit = other; });
        QVERIFY(times > 0);
        QVERIFY(w().report().toPlainText().contains(QChar(' ') + text(unit_name(other))));
    }

    /// As in the report, where an operation's time counts them.
    void machining_time_counts_accelerations() {
        QVERIFY(open_and_plan());
        auto& d = w().document();
        auto slow = std::make_shared<OperationResult>(*d.result(0));
        const std::size_t i = d.add_operation("finish5");
        d.change(QStringLiteral("accelerations"), [&](Project& p) {
            p.machine = "trunnion-ac"; // whose axes take time for it
            p.operations[i]->set("accelerations", ParameterValue(true));
            p.operations[0]->common().off = true;
        });
        const Machine machine = project_machine(d.project());
        const double without = motion_totals(slow->program, machine).time_seconds;
        slow->totals = motion_totals(slow->program, machine, {.accelerations = true});
        d.take({{d.operation_id(i), slow, {}, Document::fingerprint(d.project(), i)}});
        QVERIFY(wait_until_settled(w()));
        const PlaybackTrack& track = playback().track();
        QVERIFY(slow->totals.time_seconds > without + 1e-3);
        QCOMPARE(track.seconds(), slow->totals.time_seconds);
        QVERIFY(std::abs(track.time_at(double(track.motion_count())) - track.seconds()) < 1e-6);
    }

    void machining_time_runs_as_the_machine() {
        QVERIFY(open_and_plan());
        const PlaybackTrack& track = playback().track();
        QCOMPARE(track.seconds(), w().document().result(0)->totals.time_seconds);
        // Followed motion by motion.
        QVERIFY(std::abs(track.time_at(double(track.motion_count())) - track.seconds()) < 1e-6);
        for (const double t : {0.0, 0.3, 0.77}) {
            const double p = track.position_at(t * track.seconds());
            QVERIFY(std::abs(track.time_at(p) - t * track.seconds()) < 1e-6 * track.seconds());
        }
        QCOMPARE(track.position_at(track.seconds() + 1), double(track.motion_count()));
        QCOMPARE(track.place(0).motion, std::size_t(0));
        QCOMPARE(track.place(1).motion, std::size_t(0));
        QCOMPARE(track.place(1.01).motion, std::size_t(1));
        QCOMPARE(track.place(1e9).motion, track.motion_count() - 1);
        QVERIFY(bar().time_text().contains(QChar('/')));
        // Hours are read whole in a small window, too.
        w().document().change(QStringLiteral("feed"),
                              [](Project& p) { p.operations[0]->common().feed /= 100; });
        w().plan();
        QVERIFY(wait_until_settled(w()));
        w().workspaces().enter(Workspace::simulate);
        w().resize(800, 600);
        QTest::qWait(50);
        const auto* time = bar().findChild<QLabel*>(QStringLiteral("play_time"));
        QVERIFY2(time->text().count(QChar(':')) >= 3, qPrintable(time->text()));
        QVERIFY(time->width() >= time->fontMetrics().horizontalAdvance(time->text()));
        QVERIFY(time->geometry().right() < bar().speed_box()->geometry().left());
    }

    void two_operations_and_a_click_on_the_path() {
        QVERIFY(open_part());
        w().tree().select({operation_kind, 0});
        enter(w(), "tolerance", QStringLiteral("0.02"));
        ui::duplicate_operation(w().document(), 0);
        w().document().change(QStringLiteral("name"), [](Project& p) {
            p.operations[1]->common().name =
                "Second finish with a name as long as nobody should give, but somebody does all the same";
        });
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(playback().track().operation_count(), std::size_t(2));
        bar().operation_box()->setCurrentIndex(1);
        emit bar().operation_box()->activated(1);
        QVERIFY(wait_until_settled(w()));
        const std::size_t n = playback().track().motions_of(0);
        QCOMPARE(playback().target(), double(n + 1));
        QCOMPARE(bar().goto_box()->value(), 1);
        // The end of the first is still the first's.
        playback().go_to(double(n));
        QCOMPARE(playback().track().place(playback().target()), (MotionPlace{0, n - 1}));
        QCOMPARE(bar().goto_box()->value(), int(n));
        QVERIFY(verify());
        QCOMPARE(badge(1), QStringLiteral("Verified"));
        w().resize(1000, 650);
        playback().go_to(double(n + n / 2));
        QVERIFY(wait_until_settled(w()));
        w().findChild<QDockWidget*>(QStringLiteral("verification_dock"))->raise();
        shot(w(), QStringLiteral("verify-small"));
        w().set_theme(Theme::dark);
        w().layers().set_shown(ViewLayer::stock, false);
        shot(w(), QStringLiteral("verify-small-dark"));
        w().set_theme(Theme::light);
    }

    /// Each verdict has a question of its own; verifying is offered where it would tell something new.
    void export_is_doubted_in_words_of_the_verdict() {
        const QString cancel = QStringLiteral("Cancel"), anyway = QStringLiteral("Export anyway");
        QVERIFY(open_and_plan());
        QCOMPARE(asked_at_export(), (QStringList{QStringLiteral("Export unverified programs?"), cancel,
                                                 anyway, QStringLiteral("Verify")}));
        QVERIFY(verify());
        auto outcome = std::make_shared<VerificationOutcome>(controller().model().outcome());
        auto unclear = std::make_shared<facetmill::Verification>(*outcome->verification);
        unclear->not_judged = "too little of the part is seen";
        outcome->verification = unclear;
        controller().model().take(outcome);
        QCOMPARE(controller().model().verdict(), ui::Verdict::not_judged);
        QCOMPARE(asked_at_export(),
                 (QStringList{QStringLiteral("Export programs that cannot be judged?"), cancel, anyway}));
        w().tree().select({operation_kind, 0});
        enter(w(), "feed", QStringLiteral("31"));
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(controller().model().verdict(), ui::Verdict::stale);
        QCOMPARE(asked_at_export(),
                 (QStringList{QStringLiteral("Export programs that were verified as they no longer are?"),
                              cancel, anyway, QStringLiteral("Verify again")}));
    }

    /// Where it is known before the stock is cut that nothing can be verified, nobody waits for that.
    void what_cannot_be_judged_is_not_begun() {
        QVERIFY(open_and_plan());
        w().document().change(QStringLiteral("Lax"), [](Project& p) { p.limits.gouge_limit = {25, {}}; });
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!controller().model().any());
        const QString message = w().message_bar().message();
        QVERIFY2(message.contains(QStringLiteral("not begun"))
                     && message.contains(QStringLiteral("allow at")),
                 qPrintable(message));
        QTest::mouseClick(w().message_bar().findChild<QPushButton*>(QStringLiteral("message_button")),
                          Qt::LeftButton);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(controller().model().verdict(), ui::Verdict::not_judged);
    }

    /// What asks for nearer places than there are names the operation with the narrowest tool.
    void a_tool_too_fine_to_be_judged_is_named() {
        QVERIFY(open_and_plan());
        facetmill::Verification v;
        v.not_judged = "places looked at are 2 mm apart, and a cutter has a radius of 1 mm: a resolution and "
                       "a spacing of at most 0.5 mm would do";
        QCOMPARE(ui::verdict_advice(v, w().document().project()).text,
                 QStringLiteral("What to do: a larger tool in Finish."));
        v.not_judged = "another reason";
        QVERIFY(ui::verdict_advice(v, w().document().project()).text.isEmpty());
    }

    void a_verdict_in_the_bar_goes_with_its_worth() {
        QVERIFY(open_and_plan());
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("no gouge")));
        w().document().change(QStringLiteral("Finer"),
                              [](Project& p) { p.operations.front()->common().tolerance /= 2; });
        QVERIFY2(w().message_bar().message().isEmpty(), qPrintable(w().message_bar().message()));
    }

    void export_is_doubted() {
        QVERIFY(open_and_plan());
        const QString folder = scratch_folder(QStringLiteral("export"));
        w().exports().save_programs(folder);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(QDir(folder).exists(QStringLiteral("report.json")));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("has not been verified")),
                 qPrintable(w().message_bar().message()));
        bool asked = false;
        answer_next(QMessageBox::Cancel, asked);
        action(w(), "export")->trigger();
        QVERIFY(asked);
        QVERIFY(!w().job().running());
        QVERIFY(verify());
        w().exports().save_programs(folder);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().message_bar().message().startsWith(QStringLiteral("Wrote 2 file")));
        QVERIFY(!w().message_bar().message().contains(QStringLiteral("verif")));
    }

    /// Those of the control first: the machine runs them.
    void the_dialog_names_all_that_is_written() {
        QVERIFY(open_and_plan());
        for (const auto files : {ProgramSpec::Files::each, ProgramSpec::Files::one}) {
            w().document().change(QStringLiteral("Control"), [&](Project& p) {
                p.programs.post = "linuxcnc";
                p.programs.files = files;
            });
            QVERIFY(verify());
            const QString folder = scratch_folder(QStringLiteral("named"));
            action(w(), "export")->trigger();
            auto* line = w().findChild<QLineEdit*>(QStringLiteral("export_folder"));
            QVERIFY(line);
            QString told;
            QStringList named;
            for (auto* label : line->window()->findChildren<QLabel*>())
                if (label->text().startsWith(QStringLiteral("The programs and their report"))) {
                    told = label->text();
                    named = label->toolTip().split(QChar('\n'));
                }
            const QString own = files == ProgramSpec::Files::one
                                    ? ui::text(joined_program_name(w().document().project(), ".ngc"))
                                    : QStringLiteral("01-Finish.ngc");
            QVERIFY2(told.contains(own + QStringLiteral(", 01-Finish.apt")), qPrintable(told));
            line->selectAll();
            QTest::keyClicks(line, folder);
            QTest::keyClick(line, Qt::Key_Return);
            QVERIFY(wait_until_settled(w()));
            named.sort();
            QCOMPARE(named, QDir(folder).entryList(QDir::Files, QDir::Name));
            QTRY_VERIFY_WITH_TIMEOUT(!w().findChild<QLineEdit*>(QStringLiteral("export_folder")),
                                     patience_ms);
        }
    }

    /// Into the folder that is typed, which need not be there, and not into the one above it.
    void programs_go_where_the_dialog_says() {
        QVERIFY(open_and_plan() && verify());
        const QString folder = scratch_folder(QStringLiteral("where"));
        const auto dialog = [&]() -> QDialog* {
            for (auto* one : w().findChildren<QDialog*>(QStringLiteral("export_dialog")))
                if (one->isVisible()) return one;
            return nullptr;
        };
        const auto said = [&] {
            return dialog()->findChild<QLabel*>(QStringLiteral("export_trouble"))->text();
        };
        action(w(), "export")->trigger();
        QVERIFY(dialog());
        auto* line = dialog()->findChild<QLineEdit*>(QStringLiteral("export_folder"));
        auto* button = dialog()->findChild<QPushButton*>(QStringLiteral("export"));
        line->setText(QStringLiteral("typed"));
        QVERIFY(!button->isEnabled() && said().contains(QStringLiteral("whole path")));
        line->setText(folder);
        QVERIFY(button->isEnabled() && said().isEmpty()
                && dialog()->findChild<QLabel*>(QStringLiteral("export_trouble"))->isHidden()); // no gap
        line->selectAll();
        QTest::keyClicks(line, folder + QStringLiteral("/job/typed"));
        QCOMPARE(said(), QStringLiteral("The folder is made."));
        shot(w(), QStringLiteral("window-export"));
        shot(*dialog(), QStringLiteral("dialog-export"));
        QTest::keyClick(line, Qt::Key_Return);
        QVERIFY(wait_until_settled(w()));
        QTRY_VERIFY_WITH_TIMEOUT(!dialog(), patience_ms);
        QCOMPARE(QDir(folder + QStringLiteral("/job/typed")).entryList(QDir::Files).size(), 2);
        QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot),
                 QStringList(QStringLiteral("job")));
        QVERIFY(w().message_bar().message().contains(folder + QStringLiteral("/job/typed")));
        auto* open = w().message_bar().findChild<QPushButton*>();
        QVERIFY(open && open->isVisible() && open->text() == QStringLiteral("Open folder"));

        // What is there is told, and which of it is replaced.
        QVERIFY(QFile::copy(folder + QStringLiteral("/job/typed/01-Finish.apt"),
                            folder + QStringLiteral("/job/typed/09-Old.apt")));
        action(w(), "export")->trigger();
        QVERIFY(dialog());
        QCOMPARE(dialog()->findChild<QLineEdit*>(QStringLiteral("export_folder"))->text(),
                 folder + QStringLiteral("/job/typed"));
        QCOMPARE(said(),
                 QStringLiteral(
                     "Replaced there: 01-Finish.apt and report.json. Of earlier jobs there: 09-Old.apt."));
        dialog()->resize(560, 200);
        shot(*dialog(), QStringLiteral("dialog-export-over"));
        dialog()->reject();
        QVERIFY(wait_until_settled(w()));
    }

    /// With a control the posted program is judged and exported, and what is found lies in the plan's
    /// motions.
    void the_posted_program_is_judged() {
        QVERIFY(open_and_plan());
        w().tree().select({ui::TreeNode::Kind::machine, 0});
        w().document().change(QStringLiteral("Control"), [](Project& p) { p.programs.post = "grbl"; });
        enter(w(), "wcs", QStringLiteral("G55"));
        QCOMPARE(w().document().project().programs.wcs, std::string("G55"));
        QVERIFY(verify());
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        const QString verdict = controller().panel()->verdict_line();
        QVERIFY2(verdict.startsWith(QStringLiteral("Verified: the posted program, ")), qPrintable(verdict));
        w().findChild<QDockWidget*>(QStringLiteral("verification_dock"))->raise();
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("verify-posted"));
        const QString folder = scratch_folder(QStringLiteral("posted"));
        w().exports().save_programs(folder);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(QDir(folder).exists(QStringLiteral("01-Finish.nc")));
        // Posted otherwise, nobody knows.
        enter(w(), "wcs", QStringLiteral("G56"));
        QCOMPARE(controller().model().verdict(), ui::Verdict::stale);
        plant_gouge(0.5);
        QVERIFY(verify());
        QVERIFY(
            controller().panel()->verdict_line().startsWith(QStringLiteral("Failed: the posted program")));
        const auto& motions = w().document().result(0)->program.motions.motions;
        for (const ui::Finding& f : controller().model().findings())
            if (f.kind == ui::Finding::Kind::gouge)
                QVERIFY((motions[f.by.motion].to.tip - f.place).norm() < 30);
        // What the control cannot do is told, and nothing judged.
        enter(w(), "wcs", QStringLiteral("G99"));
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().contains(QStringLiteral("G99")), qPrintable(w().last_failure()));
    }

    void the_setup_sheet_wants_a_verdict() {
        const QString file = scratch_folder(QStringLiteral("sheet")) + QStringLiteral("/part.html");
        const auto refused = [&](const char* why) {
            w().message_bar().dismiss();
            action(w(), "setup_sheet")->trigger(); // says why not instead of asking for a name
            w().exports().save_sheet(file);
            return wait_until_settled(w()) && w().message_bar().message().contains(QLatin1String(why))
                   && !QFileInfo::exists(file);
        };
        QVERIFY(open_and_plan());
        QVERIFY(refused("Press Verify"));
        QVERIFY(verify());
        w().exports().save_sheet(file);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().message_bar().message().startsWith(QStringLiteral("Wrote ")));
        QFile sheet(file);
        QVERIFY(sheet.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(sheet.readAll());
        QVERIFY(text.contains(QStringLiteral("Verified: no gouge, no collision.")));
        QVERIFY(text.contains(QStringLiteral("01-Finish.apt")));
        const QString mark = QStringLiteral("data:image/png;base64,");
        const auto at = text.indexOf(mark) + mark.size();
        QImage picture;
        QVERIFY(picture.loadFromData(
            QByteArray::fromBase64(text.mid(at, text.indexOf(QChar('"'), at) - at).toLatin1())));
        QVERIFY(picture.width() > 300 && picture.height() > 200);
        sheet.close();
        QVERIFY(sheet.remove());
        w().exports().save_sheet(QStringLiteral("/nowhere/at/all.html"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().contains(QStringLiteral("/nowhere/at/all.html")),
                 qPrintable(w().last_failure()));
        // A sheet of what was is none of what is.
        enter(w(), "feed", QStringLiteral("77"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(refused("Press Plan"));
    }
};

FACETMILL_TEST(TestWindowVerify)
#include "test_window_verify.moc"
