// Suggestions of operations: looked for, explained, made by a click, taken back by undo; and what is advised
// about a verification that failed.
#include "core/job/project.h"
#include "core/verify/verify.h"
#include "tests/screenshot/window_support.h"
#include "ui/controllers.h"
#include "ui/project_tree.h"
#include "ui/suggest_controller.h"
#include "ui/suggest_dialog.h"
#include "ui/theme.h"
#include "ui/verdict_advice.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QUndoStack>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

class TestWindowSuggest : public QObject, public WindowFixture {
    Q_OBJECT

    SuggestDialog& page() { return *w().controllers().suggest().dialog(); }
    QString words() {
        QString all;
        for (const QLabel* label : page().findChildren<QLabel*>())
            all += label->text() + QLatin1Char('\n');
        return all;
    }
    /// Coarse, so that planning takes moments.
    bool open_coarse() {
        if (!open_part()) return false;
        w().tree().select({TreeNode::Kind::operation, 0});
        if (!wait_until_settled(w())) return false;
        enter(w(), "tolerance", QStringLiteral("0.05"));
        return wait_until_settled(w());
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { leave_as_found(); }

    void three_are_suggested_and_made_by_a_click() {
        QVERIFY(open_coarse());
        action(w(), "suggest")->trigger();
        QVERIFY(page().isVisible());
        QVERIFY(page().stop_button()->isEnabled());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(page().card_count(), std::size_t(3));
        QVERIFY2(words().contains(QStringLiteral("The quickest of these")), qPrintable(words()));
        QVERIFY2(words().contains(QStringLiteral("of the surface")), qPrintable(words()));
        shot(page(), QStringLiteral("suggest"));
        const std::size_t before = w().document().operation_count();
        page().add_button(0)->click();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().operation_count(), before + 1);
        // What would cut the same is not cut twice.
        QVERIFY(w().document().is_off(0));
        QVERIFY2(page().status().contains(QStringLiteral("in place of Finish")), qPrintable(page().status()));
        // It is the one that is chosen now.
        const auto node = w().tree().selected();
        QVERIFY(node && node->kind == TreeNode::Kind::operation);
        QVERIFY(page().status().contains(
            QString::fromStdString(w().document().operation(node->index).common().name)));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().operation_count(), before);
        QVERIFY(!w().document().is_off(0));
        // Another project value, other suggestions.
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        enter(w(), "tolerance", QStringLiteral("0.06"));
        QVERIFY2(page().status().contains(QStringLiteral("changed")), qPrintable(page().status()));
    }

    /// Where the tool does not come down through the stock the form says so before anything is planned, and
    /// roughing is added with what is suggested, in one step.
    void deep_stock_is_roughed_first() {
        QVERIFY(open_coarse());
        auto& d = w().document();
        auto* hint = w().findChild<QLabel*>(QStringLiteral("properties_hint"));
        QVERIFY2(!hint->text().contains(QStringLiteral("Add Rough")), qPrintable(hint->text()));
        d.change(QStringLiteral("Shorter"), [](Project& p) { p.tools.front().flute_length = 0.5; });
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(hint->text().startsWith(QStringLiteral("Add Rough before it: the stock stands up to")),
                 qPrintable(hint->text()));
        shot(w(), QStringLiteral("suggest-rough-hint"));
        action(w(), "suggest")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(words().contains(QStringLiteral("Rough goes before it")), qPrintable(words()));
        shot(page(), QStringLiteral("suggest-rough"));
        const int steps = d.undo_stack().count();
        page().add_button(0)->click();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(d.undo_stack().count(), steps + 1);
        QCOMPARE(d.operation_count(), std::size_t(3));
        QCOMPARE(std::string(d.operation(0).kind()), std::string("rough"));
        QVERIFY(d.is_off(1) && !d.is_off(2));
        QVERIFY2(!hint->text().contains(QStringLiteral("Add Rough")), qPrintable(hint->text()));
        d.undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(d.operation_count(), std::size_t(1));
        QVERIFY(!d.is_off(0));
    }

    /// What failed comes with a word of what to do: about what was touched first, then about most of what
    /// stays.
    void a_failure_says_what_to_do() {
        Project project;
        project.operations.push_back(make_operation("finish3"));
        const auto says = [&project](const Verification& v, const char* word, const std::string& add = {}) {
            const ui::VerdictAdvice advice = ui::verdict_advice(v, project);
            return advice.text.contains(QLatin1String(word)) && advice.add == add
                   && ui::advised_button(advice).isEmpty() == add.empty();
        };
        const auto nothing = [&project](const Verification& v) {
            const ui::VerdictAdvice advice = ui::verdict_advice(v, project);
            return advice.text.isEmpty() && advice.add.empty();
        };
        Verification v;
        v.used.uncut_limit = 0.02;
        QVERIFY(nothing(v));
        v.uncut_share = 0.307;
        UncutReason small, grooves, unseen;
        small.why = UncutReason::Why::held;
        small.area = 1;
        grooves.why = UncutReason::Why::no_tool;
        grooves.area = 2;
        unseen.why = UncutReason::Why::not_seen; // no part of the verdict
        unseen.area = 3;
        v.uncut = {small, grooves, unseen};
        QVERIFY(says(v, "add Clean-up", "cleanup"));
        v.uncut[1].why = UncutReason::Why::stock;
        QVERIFY(says(v, "add Rough", "rough"));
        v.uncut_share = 0.01; // allowed
        QVERIFY(nothing(v));
        Collision shank;
        shank.kind = Collision::Kind::shank;
        v.collisions = {shank};
        QVERIFY(says(v, "add Rough", "rough"));
        // What is there already is not to be added once more, unless it is switched off.
        project.operations.push_back(make_operation("rough"));
        QVERIFY(says(v, "longer flutes"));
        project.operations.back()->common().off = true;
        QVERIFY(says(v, "add Rough", "rough"));
        v.collisions[0].fixture = "Clamp";
        QVERIFY(says(v, "fixture"));
        v.collisions.clear();
        v.uncut_share = 0.307;
        v.uncut[1].why = UncutReason::Why::no_tool;
        project.operations.push_back(make_operation("cleanup"));
        QVERIFY(says(v, "smaller tool in Clean-up"));
    }

    void looking_can_be_stopped() {
        QVERIFY(open_part());
        action(w(), "suggest")->trigger();
        page().stop_button()->click();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(page().card_count(), std::size_t(0));
        QVERIFY2(page().status().contains(QStringLiteral("Stopped")), qPrintable(page().status()));
        QVERIFY(page().again_button()->isEnabled());
        QVERIFY(!w().document().undo_stack().canUndo());
    }

    void it_fits_a_small_dark_screen() {
        QVERIFY(open_coarse());
        w().set_theme(Theme::dark);
        action(w(), "suggest")->trigger();
        QVERIFY(wait_until_settled(w()));
        page().resize(480, 400);
        QVERIFY(wait_until_settled(w()));
        shot(page(), QStringLiteral("suggest-dark"));
        QVERIFY(page().width() <= 800 && page().height() <= 600);
        QCOMPARE(page().card_count(), std::size_t(3));
    }
};

FACETMILL_TEST(TestWindowSuggest)
#include "test_window_suggest.moc"
