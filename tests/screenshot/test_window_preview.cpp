// Passes of the chosen operation in the view before they are planned.
#include "tests/screenshot/window_support.h"
#include "ui/layer_bar.h"
#include "ui/project_tree.h"
#include "ui/theme.h"
#include "ui/viewport.h"
#include "ui/workspaces.h"

#include <QCheckBox>
#include <QMenu>
#include <QTest>
#include <QUndoStack>

#include <map>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

class TestWindowPreview : public QObject, public WindowFixture {
    Q_OBJECT

    /// What the legend says, as one line.
    QString label() {
        return QString::fromStdString(w().viewport().scene().preview().label())
            .replace(QLatin1Char('\n'), QLatin1Char(' '));
    }
    bool shown() { return !w().viewport().scene().preview().empty(); }
    /// Chooses an operation of a kind that is new.
    bool add(const char* kind) {
        const std::size_t at = w().document().add_operation(kind);
        w().tree().select({TreeNode::Kind::operation, at});
        return wait_until_settled(w());
    }

private slots:
    void init() {
        QVERIFY(show_window());
        show_previews(true);
    }
    void cleanup() { leave_as_found(); }

    void passes_are_seen_until_they_are_planned() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::part, 0});
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!shown());
        const QImage without = view_picture(w());
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        QVERIFY(shown());
        QVERIFY2(label().contains(QStringLiteral("not planned, not checked")), qPrintable(label()));
        const QImage seen = view_picture(w());
        QVERIFY(changed_pixels(without, seen) > 1000);
        shot(w(), QStringLiteral("preview-finish3"));
        // A value more, other lines; undone, the same again.
        const QString said = label();
        enter(w(), "stepover", QStringLiteral("0.3"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(label() != said, qPrintable(label()));
        QVERIFY(changed_pixels(seen, view_picture(w())) > 1000);
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(label(), said);
        QVERIFY(changed_pixels(seen, view_picture(w())) < 200);
        // Planned, it is gone; changed once more, it is back.
        enter(w(), "tolerance", QStringLiteral("0.02"));
        action(w(), "plan")->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(!shown());
        QCOMPARE(label(), QString());
        enter(w(), "tolerance", QStringLiteral("0.03"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(shown());
    }

    void every_kind_that_suits_the_part_has_one() {
        QVERIFY(open_part());
        for (const char* kind : {"rough", "waterline", "steep_shallow", "scallop", "radial", "spiral",
                                 "morph", "along_curve", "finish5", "global_local"}) {
            QVERIFY(add(kind));
            QVERIFY2(shown(), qPrintable(QString::fromLatin1(kind) + QStringLiteral(": ") + label()));
            shot(w(), QStringLiteral("preview-") + QString::fromLatin1(kind));
        }
    }

    void what_cannot_be_is_said() {
        QVERIFY(open_part());
        QVERIFY(add("morph"));
        w().document().change(QStringLiteral("Boundary"), [](Project& p) {
            Boundary middle;
            middle.name = "Middle";
            middle.kind = Boundary::Kind::curve;
            middle.curve = {{{0, 0, 0}}, {{30, 0, 0}}, {{30, 20, 0}}};
            p.boundaries = {middle};
            for (auto& o : p.operations)
                if (o->kind() == "morph") o->set("first_curve", std::string("Middle"));
        });
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!shown());
        QVERIFY2(label().contains(QStringLiteral("nly one of its two curves")), qPrintable(label()));
        shot(w(), QStringLiteral("preview-refused"));
    }

    void the_switch_takes_it_away_and_other_workspaces_have_none() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        const QImage seen = view_picture(w());
        QCheckBox* box = w().layers().box(ViewLayer::preview);
        QVERIFY(box->isChecked());
        box->setChecked(false);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!shown());
        QVERIFY(changed_pixels(seen, view_picture(w())) > 1000);
        box->setChecked(true);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(shown());
        w().workspaces().enter(Workspace::verify);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!shown());
    }

    void changes_come_faster_than_previews() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        for (int k = 1; k <= 20; ++k)
            w().document().change(QStringLiteral("Step-over"),
                                  [k](Project& p) { p.operations.at(0)->set("stepover", 1.0 + 0.1 * k); });
        QVERIFY(wait_until_settled(w()));
        const QString last = label();
        QVERIFY(shown());
        w().document().change(QStringLiteral("Step-over"),
                              [](Project& p) { p.operations.at(0)->set("stepover", 9.0); });
        QVERIFY(wait_until_settled(w()));
        QVERIFY(label() != last);
        w().document().change(QStringLiteral("Step-over"),
                              [](Project& p) { p.operations.at(0)->set("stepover", 3.0); });
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(label(), last);
    }

    void the_menu_shows_operations_on_the_part() {
        QVERIFY(open_part());
        QMenu* menu = w().tree().add_operation_menu();
        const auto pictures = [&] {
            std::map<QString, QImage> all;
            for (const QAction* entry : menu->actions())
                if (!entry->data().toString().isEmpty())
                    all[entry->data().toString()] = entry->icon().pixmap(QSize(72, 39)).toImage();
            return all;
        };
        const auto drawings = pictures();
        QCOMPARE(drawings.size(), operation_kinds().size());
        menu->popup(w().mapToGlobal(QPoint(20, 60)));
        QVERIFY(wait_until_settled(w()));
        shot(*menu, QStringLiteral("preview-menu"));
        menu->hide();
        const auto now = pictures();
        for (const char* kind : {"finish3", "waterline", "spiral", "finish5"})
            QVERIFY2(changed_pixels(drawings.at(kind), now.at(kind)) > 100, kind);
        // Opened again for the same project it has them at once; in another palette they are drawn anew.
        menu->popup(w().mapToGlobal(QPoint(20, 60)));
        menu->hide();
        QVERIFY(pictures() == now);
        w().set_theme(Theme::dark);
        menu->popup(w().mapToGlobal(QPoint(20, 60)));
        QVERIFY(wait_until_settled(w()));
        shot(*menu, QStringLiteral("preview-menu-dark"));
        menu->hide();
        QVERIFY(changed_pixels(now.at("finish3"), pictures().at("finish3")) > 100);
    }

    void it_fits_a_small_dark_window() {
        QVERIFY(open_part());
        w().set_theme(Theme::dark);
        w().resize(800, 600);
        QVERIFY(add("spiral"));
        QVERIFY(shown());
        shot(w(), QStringLiteral("preview-dark"));
    }
};

FACETMILL_TEST(TestWindowPreview)
#include "test_window_preview.moc"
