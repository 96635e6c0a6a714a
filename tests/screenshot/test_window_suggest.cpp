// Suggestions of operations: looked for, explained, made by a click, taken back by undo.
#include "tests/screenshot/window_support.h"
#include "ui/controllers.h"
#include "ui/project_tree.h"
#include "ui/suggest_controller.h"
#include "ui/suggest_dialog.h"
#include "ui/theme.h"

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
        // It is the one that is chosen now.
        const auto node = w().tree().selected();
        QVERIFY(node && node->kind == TreeNode::Kind::operation);
        QVERIFY(page().status().contains(
            QString::fromStdString(w().document().operation(node->index).common().name)));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().operation_count(), before);
        // Another project value, other suggestions.
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        enter(w(), "tolerance", QStringLiteral("0.06"));
        QVERIFY2(page().status().contains(QStringLiteral("changed")), qPrintable(page().status()));
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
