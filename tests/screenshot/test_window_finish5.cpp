// The form of a 5-axis operation as a user goes through it: wrong entries and what is said under them, units,
// a long name, a small window, dark colours.
#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/five_axis/finish5.h"
#include "core/strategy/global_local/global_local.h"
#include "tests/screenshot/window_support.h"
#include "ui/operation_list.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QToolButton>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

class TestWindowFinish5 : public QObject, public WindowFixture {
    Q_OBJECT

    bool open_form() {
        if (!open_part()) return false;
        for (QAction* a : w().tree().add_operation_menu()->actions())
            if (a->text().contains(QStringLiteral("5"))) a->trigger();
        if (w().document().operation_count() != 2) return false;
        w().tree().select({TreeNode::Kind::operation, 1});
        auto* advanced = w().properties().findChild<QToolButton*>(QStringLiteral("advanced"));
        if (!advanced->isChecked()) advanced->click();
        return wait_until_settled(w());
    }
    const Finish5Settings& settings() {
        return dynamic_cast<const Finish5&>(w().document().operation(1)).settings();
    }
    QLabel* count(const char* key) { return w().properties().findChild<QLabel*>(QLatin1String(key)); }
    /// All of its text can be read.
    static bool is_whole(const QLabel* label) {
        return label->width() >= label->fontMetrics().horizontalAdvance(label->text());
    }
    QToolButton* clear(const char* key) {
        return w().properties().findChild<QToolButton*>(QStringLiteral("clear_") + QLatin1String(key));
    }
    void scroll_to(const char* name) {
        auto* area = w().properties().findChild<QScrollArea*>();
        area->ensureWidgetVisible(field(w(), name), 0, 80);
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void good_entries_arrive() {
        QVERIFY(open_form());
        shot(w(), QStringLiteral("finish5-form"));
        enter(w(), "grid_degrees", QStringLiteral("6"));
        QCOMPARE(settings().grid_step, radians(6));
        enter(w(), "lead_limits1", QStringLiteral("60"));
        QCOMPARE(settings().lead_limits[1], radians(60));
        enter(w(), "yaw_limits0", QStringLiteral("-20"));
        QCOMPARE(settings().yaw_limits[0], radians(-20));
        enter(w(), "stepover", QStringLiteral("0.1"));
        QCOMPARE(settings().stepover.number, 0.1 * mm_per_inch);
        enter(w(), "holder_clearance", QStringLiteral("2 mm"));
        QCOMPARE(settings().holder_clearance, 2.0);
        auto* posture = w().properties().findChild<QComboBox*>(QStringLiteral("posture"));
        posture->setFocus();
        QTest::keyClick(posture, Qt::Key_Home);
        QVERIFY(settings().posture == Finish5Settings::PostureChoice::cm2);
        // In the other unit the same values; angles stay what they are.
        ui::set_unit(w(), LengthUnit::mm);
        QCOMPARE(field(w(), "stepover")->text(), QStringLiteral("2.54"));
        QCOMPARE(field(w(), "grid_degrees")->text(), QStringLiteral("6"));
        QCOMPARE(settings().stepover.number, 0.1 * mm_per_inch);
    }

    void wrong_entries_are_told_where_they_stand() {
        QVERIFY(open_form());
        const auto refuse = [&](const char* name, const char* key, const char* entry, const char* says) {
            enter(w(), name, QString::fromLatin1(entry));
            const QString error = error_under(w(), key);
            return error.contains(QString::fromUtf8(says)) ? QString()
                                                           : QStringLiteral("%1: %2").arg(name, error);
        };
        QCOMPARE(refuse("lead_limits0", "lead_limits", "60", "below"), QString());
        QCOMPARE(refuse("yaw_limits1", "yaw_limits", "200", "180"), QString());
        QCOMPARE(refuse("grid_degrees", "grid_degrees", "0", "0.25"), QString());
        QCOMPARE(refuse("stepover", "stepover", "wide", "adaptive"), QString());
        QCOMPARE(refuse("normal_limit", "normal_limit", "", "enter a number"), QString());
        QCOMPARE(refuse("turn_limit", "turn_limit", "0,5", "0.5"), QString());
        QCOMPARE(refuse("holder_clearance", "holder_clearance", "-1", "0 to"), QString());
        shot(w(), QStringLiteral("finish5-errors"));
        scroll_to("holder_clearance");
        shot(w(), QStringLiteral("finish5-errors-below"));
        QCOMPARE(settings().lead_limits[0], 0.0);
        // Nothing is planned with them.
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(1), OperationState::not_planned);
        w().set_theme(Theme::dark);
        w().resize(800, 600);
        QVERIFY(wait_until_settled(w()));
        scroll_to("lead_limits0");
        shot(w(), QStringLiteral("finish5-errors-small-dark"));
        w().set_theme(Theme::light);
    }

    /// What is kept by hand elsewhere has a row that counts it and clears it.
    void a_list_is_counted_and_cleared() {
        QVERIFY(open_form());
        const char* const key = manual_posture_list.key;
        QVERIFY(count(key) && clear(key));
        QCOMPARE(count(key)->text(), QStringLiteral("none"));
        QVERIFY(!clear(key)->isEnabled());
        const std::vector<ManualPosture> kept{
            {{1, 2, 3}, 0.2, 0}, {{25.4, 2, 3}, 0.1, -0.3}, {{1, 12, 3}, 0, 0}};
        w().document().change(QStringLiteral("Keep"),
                              [&](Project& p) { manual_posture_list.set(*p.operations[1], kept); });
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(count(key)->text(), QStringLiteral("3 kept postures"));
        // All of it can be read, and no default stands beside it.
        QVERIFY(is_whole(count(key)));
        QVERIFY(
            !w().properties().findChild<QToolButton*>(QStringLiteral("reset_manual_postures"))->isVisible());
        w().properties().findChild<QScrollArea*>()->ensureWidgetVisible(clear(key), 0, 40);
        shot(w(), QStringLiteral("finish5-list"));

        // Saved and read again they are there.
        const QString path = scratch_folder(QStringLiteral("list")) + QStringLiteral("/p.facetmill");
        QVERIFY(w().files().save_to(path));
        const std::vector<ManualPosture> read =
            manual_posture_list.of(*load_project(path.toStdString()).operations[1]);
        QCOMPARE(read.size(), kept.size());
        for (std::size_t i = 0; i < kept.size(); ++i)
            QVERIFY(std::abs(read[i].lead - kept[i].lead) < 1e-12
                    && std::abs(read[i].point[0] - kept[i].point[0]) < 1e-9);

        QTest::mouseClick(clear(key), Qt::LeftButton);
        QVERIFY(settings().manual_postures.empty());
        QCOMPARE(count(key)->text(), QStringLiteral("none"));
        QVERIFY(!clear(key)->isEnabled());
        QCOMPARE(w().document().undo_stack().undoText(), QStringLiteral("Clear kept postures"));
        w().document().undo_stack().undo();
        QVERIFY(settings().manual_postures == kept);
        QCOMPARE(count(key)->text(), QStringLiteral("3 kept postures"));
        QVERIFY(clear(key)->isEnabled());
        // By the keyboard as well.
        clear(key)->setFocus();
        QTest::keyClick(clear(key), Qt::Key_Space);
        QVERIFY(settings().manual_postures.empty());
        w().document().undo_stack().undo();
        QVERIFY(!w().document().modified());
        w().open_file(path);
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::operation, 1});
        QCOMPARE(count(key)->text(), QStringLiteral("3 kept postures"));
    }

    void every_list_has_a_row() {
        QVERIFY(open_form());
        for (const char* kind : {"cleanup", "global_local"})
            w().document().add_operation(kind);
        ui::move_operation(w().document(), 2, 1); // it was put before clean-up
        w().document().change(QStringLiteral("Edit"), [](Project& p) {
            p.operations[2]->set(switched_off_key, std::string("Valley 1, Valley 3"));
            region_edit_list.set(*p.operations[3], {{{1, 2, 3}, false, 0}});
            boundary_drag_list.set(*p.operations[3], {{{1, 2, 3}, {2, 2, 3}}, {{1, 3, 3}, {1, 2, 3}}});
        });
        w().tree().select({TreeNode::Kind::operation, 2});
        QCOMPARE(count(switched_off_key)->text(), QStringLiteral("2 strips"));
        QVERIFY(wait_until_settled(w()));
        w().properties().findChild<QScrollArea*>()->ensureWidgetVisible(clear(switched_off_key), 0, 40);
        QVERIFY(is_whole(count(switched_off_key)));
        shot(w(), QStringLiteral("cleanup-list"));
        QTest::mouseClick(clear(switched_off_key), Qt::LeftButton);
        QCOMPARE(std::get<std::string>(w().document().operation(2).get(switched_off_key)), std::string());
        w().document().undo_stack().undo();
        QCOMPARE(count(switched_off_key)->text(), QStringLiteral("2 strips"));

        w().tree().select({TreeNode::Kind::operation, 3});
        QCOMPARE(count(region_edit_list.key)->text(), QStringLiteral("1 edited region"));
        QCOMPARE(count(boundary_drag_list.key)->text(), QStringLiteral("2 dragged points"));
        w().resize(800, 600);
        QVERIFY(wait_until_settled(w()));
        w().properties().findChild<QScrollArea*>()->ensureWidgetVisible(clear(boundary_drag_list.key), 0, 40);
        QVERIFY(is_whole(count(region_edit_list.key)) && is_whole(count(boundary_drag_list.key)));
        shot(w(), QStringLiteral("global-local-lists-small"));
        QTest::mouseClick(clear(region_edit_list.key), Qt::LeftButton);
        const GlobalLocalSettings& edited = *w().document().operation(3).rework();
        QVERIFY(edited.region_edits.empty() && edited.boundary_drags.size() == 2);
        // A new operation of the kind starts without them.
        w().document().add_operation("global_local");
        QVERIFY(w().document().operation(4).rework()->boundary_drags.empty());
    }

    void a_long_name_in_a_small_window() {
        QVERIFY(open_form());
        enter(w(), "name",
              QStringLiteral("Finishing of the upper blade surface between leading edge and root"));
        w().resize(800, 600);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().width() <= 800);
        // Nothing stands beyond the form's edge.
        auto* area = w().properties().findChild<QScrollArea*>();
        QVERIFY2(area->widget()->width() <= area->viewport()->width(),
                 qPrintable(
                     QStringLiteral("%1 > %2").arg(area->widget()->width()).arg(area->viewport()->width())));
        for (const char* name : {"lead_limits0", "lead_limits1", "yaw_limits1"})
            QVERIFY2(field(w(), name)->width() >= 36, name);
        shot(w(), QStringLiteral("finish5-small"));
        w().set_theme(Theme::dark);
        shot(w(), QStringLiteral("finish5-small-dark"));
        w().set_theme(Theme::light);
    }
};

FACETMILL_TEST(TestWindowFinish5)
#include "test_window_finish5.moc"
