// The form of a 5-axis operation as a user goes through it: wrong entries and what is said under them, units,
// a long name, a small window, dark colours.
#include "core/strategy/five_axis/finish5.h"
#include "tests/screenshot/window_support.h"
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
        w().set_unit(LengthUnit::mm);
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
