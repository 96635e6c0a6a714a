// The scan room: what is wrong with a mesh, a recipe for it, tried and seen before and after, taken over,
// undone, saved, and carried out again when the file changes.
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/part_meshes.h"
#include "ui/controllers.h"
#include "ui/message_bar.h"
#include "ui/parameter_form.h"
#include "ui/project_files.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/repair_button.h"
#include "ui/report_view.h"
#include "ui/scan_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRadioButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>
#include <filesystem>

using namespace facetmill;
using namespace facetmill::test;
using Kind = RepairStep::Kind;

namespace {

/// A block of 24 x 18 x 8 mm in squares of 1 mm, its top rough by 0.03 mm and without 3 x 3 squares, its
/// bottom without 2 x 2, with `more` another hole in the top; one facet faces inward, and a loose sheet of 2
/// x 2 mm lies above it.
Mesh rough_block(bool more = false) {
    Mesh mesh;
    static constexpr int size[3] = {24, 18, 8};
    const auto rough = [](Vec3 p) {
        const bool inside = p.x() > 0 && p.x() < size[0] && p.y() > 0 && p.y() < size[1];
        if (p.z() == size[2] && inside) p.z() += 0.03 * std::sin(7 * p.x() + 11 * p.y());
        return p;
    };
    const auto square = [&](const Vec3& a, const Vec3& u, const Vec3& v) {
        const auto first = Index(mesh.vertices.size());
        for (const Vec3& p : {a, Vec3(a + u), Vec3(a + v), Vec3(a + u + v)})
            mesh.vertices.push_back(rough(p));
        mesh.facets.push_back({first, first + 1, first + 2});
        mesh.facets.push_back({first + 2, first + 1, first + 3});
    };
    const auto gone = [&](const Vec3& a) {
        const auto within = [&](double x, double y, double n) {
            return a.x() >= x && a.x() < x + n && a.y() >= y && a.y() < y + n;
        };
        return (a.z() == size[2] && (within(5, 6, 3) || (more && within(15, 8, 2))))
               || (a.z() == 0 && within(12, 9, 2));
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int along = (axis + 1) % 3, up = (axis + 2) % 3;
        const Vec3 u = Vec3::Unit(along), v = Vec3::Unit(up);
        for (int i = 0; i < size[along]; ++i)
            for (int j = 0; j < size[up]; ++j) {
                const Vec3 low = i * u + j * v, high = low + size[axis] * Vec3::Unit(axis);
                if (axis != 2 || !gone(low)) square(low, v, u);
                if (axis != 2 || !gone(high)) square(high, u, v);
            }
    }
    std::swap(mesh.facets[1][1], mesh.facets[1][2]);
    for (int i = 0; i < 4; ++i)
        square(Vec3(20 + i % 2, 2 + i / 2, 12), Vec3::UnitX(), Vec3::UnitY());
    return mesh;
}

QString write_scan(const QString& folder, bool more = false) {
    const QString path = folder + QStringLiteral("/a scan with rather a long name of many words.stl");
    save_stl(rough_block(more), path.toStdString(), LengthUnit::mm, {});
    return path;
}

} // namespace

class TestWindowScanRoom : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() {
        folder_ = scratch_folder(QStringLiteral("scan_room"));
        QVERIFY(show_window());
        w().open_file(write_scan(folder_), LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
    }
    void cleanup() { close_window(); }

    /// That the mesh has flaws is said as it is opened, and the room is one click away.
    void flaws_are_told_and_found() {
        const QString said = w().message_bar().message();
        QVERIFY2(said.contains(QStringLiteral("loose pieces")) && said.contains(QStringLiteral("holes"))
                     && said.contains(QStringLiteral("facets that face the wrong side")),
                 qPrintable(said));
        QVERIFY(!dock()->isVisible());
        shot(w(), QStringLiteral("scan-told"));
        QTest::mouseClick(w().message_bar().findChild<QPushButton*>(), Qt::LeftButton);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(dock()->isVisible() && w().message_bar().message().isEmpty());
        QCOMPARE(found(QStringLiteral("Pieces")), QStringLiteral("2"));
        QCOMPARE(found(QStringLiteral("Holes")), QStringLiteral("3")); // the rim of the loose sheet is one
        QCOMPARE(found(QStringLiteral("Against neighbours")), QStringLiteral("3"));
        QCOMPARE(found(QStringLiteral("Crossings")), QStringLiteral("0"));
        QVERIFY(w().viewport().scene().repair().has_holes());
        QVERIFY(button("scan_suggest")->isEnabled() && !button("scan_preview")->isEnabled());
        QVERIFY(!button("scan_apply")->isEnabled());
        shot(w(), QStringLiteral("scan-survey"));
        // A hole that is chosen is flown to and marked.
        const double height = w().viewport().scene().camera().place().height;
        QTreeWidgetItem* hole = line(QStringLiteral("Holes"))->child(0);
        QVERIFY2(hole->text(0).startsWith(QStringLiteral("Ø 4.2")), qPrintable(hole->text(0)));
        line(QStringLiteral("Holes"))->setExpanded(true);
        panel().survey()->setCurrentItem(hole);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().viewport().scene().repair().has_chosen());
        const CameraPlace place = w().viewport().scene().camera().place();
        QVERIFY(place.height < 0.9 * height);
        QVERIFY((place.target - Vec3(6.5, 7.5, 8)).norm() < 0.2);
        shot(w(), QStringLiteral("scan-hole"));
        // Away with it where the panel is not seen.
        dock()->hide();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().viewport().scene().repair().has_holes()
                && !w().viewport().scene().repair().has_chosen());
    }

    /// From the suggestion to the project and back.
    void suggested_tried_applied_undone() {
        open_room();
        press("scan_suggest");
        QCOMPARE(kinds(), (std::vector<Kind>{Kind::pieces, Kind::turn, Kind::holes}));
        QVERIFY(!w().document().undo_stack().canUndo());
        QVERIFY(button("scan_apply")->isEnabled());
        const MeshReport before = w().document().part()->report;
        press("scan_preview");
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(scan().trial() && scan().trial()->failure.isEmpty(), qPrintable(scan().trial()->failure));
        const RepairDisplayPtr display = shown();
        QVERIFY(display && display->added && display->removed);
        QCOMPARE(display->largest, 0.0);
        QVERIFY(w().viewport().scene().repair().after());
        QVERIFY(scan().trial()->after->report.watertight);
        QCOMPARE(after(QStringLiteral("Holes")), QStringLiteral("0"));
        QCOMPARE(after(QStringLiteral("Pieces")), QStringLiteral("1"));
        QVERIFY2(text("scan_summary").startsWith(QStringLiteral("Nothing moved;"))
                     && text("scan_summary").endsWith(QStringLiteral("watertight.")),
                 qPrintable(text("scan_summary")));
        QVERIFY2(step_text(0).contains(QStringLiteral("1 piece gone")), qPrintable(step_text(0)));
        QVERIFY2(step_text(2).contains(QStringLiteral("2 holes filled,")), qPrintable(step_text(2)));
        QVERIFY(!w().document().undo_stack().canUndo()); // nothing of that is in the project
        const QImage filled = view_picture(w());
        shot(w(), QStringLiteral("scan-after"));
        radio("scan_before")->click();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().viewport().scene().repair().after());
        QVERIFY(changed_pixels(filled, view_picture(w())) > 1000);
        shot(w(), QStringLiteral("scan-before"));

        press("scan_apply");
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().undo_stack().undoText(), QStringLiteral("Repair part"));
        QCOMPARE(w().document().undo_stack().count(), 1);
        QVERIFY(!shown());
        QVERIFY(w().document().part()->report.watertight);
        QVERIFY(w().document().part()->mesh == scan().trial()->after->mesh); // not carried out once more
        QCOMPARE(w().document().part()->repairs.size(), std::size_t(3));
        QVERIFY(!button("scan_apply")->isEnabled());
        w().tree().select({ui::TreeNode::Kind::part, 0});
        QCOMPARE(w().properties().repair_button()->text(), QStringLiteral("Scan room: 3 steps…"));
        QVERIFY(w().report().toPlainText().contains(QStringLiteral("2 holes filled")));
        shot(w(), QStringLiteral("scan-applied"));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().part()->report.open_edges, before.open_edges);
        QVERIFY(scan().recipe().empty());
        w().document().undo_stack().redo();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().part()->report.watertight);
        QCOMPARE(kinds().size(), std::size_t(3));
    }

    /// How far it moves is seen in colours, stays within the bound, and steps that stand are not done again.
    void displacement_is_seen() {
        open_room();
        press("scan_suggest");
        press("scan_preview");
        QVERIFY(wait_until_settled(w()));
        const ui::TriedStepPtr first = scan().trial()->step(0);
        QVERIFY(first);
        panel().steps()->setCurrentRow(2);
        add("add_smooth");
        QCOMPARE(scan().recipe().back().kind, Kind::smooth);
        type_over(field("bound"), QStringLiteral("0.01 + 0.04"));
        QTest::keyClick(field("bound"), Qt::Key_Return);
        QCOMPARE(scan().recipe().back().bound, 0.05);
        QVERIFY(text("scan_summary").contains(QStringLiteral("not the one of the preview")));
        press("scan_preview");
        QVERIFY(wait_until_settled(w()));
        QVERIFY(scan().trial()->step(0) == first);
        const RepairDisplayPtr display = shown();
        QVERIFY(display && display->largest > 0.005 && display->largest <= 0.05);
        const double told = scan().trial()->step(3)->report.displacement;
        QVERIFY(told >= display->largest - 1e-6 && told <= 0.05);
        QVERIFY(display->scale.high >= display->largest);
        shot(w(), QStringLiteral("scan-smooth"));
        w().set_theme(ui::Theme::dark);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("scan-smooth-dark"));
        radio("scan_before")->click();
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("scan-before-dark"));
        w().set_theme(ui::Theme::light);
        // Cancel leaves all as it was.
        press("scan_reset");
        QVERIFY(wait_until_settled(w()));
        QVERIFY(scan().recipe().empty() && !shown() && !w().document().undo_stack().canUndo());
    }

    /// Steps are switched off, moved and taken away; what becomes of each hole follows what is typed.
    void the_recipe_is_edited() {
        open_room();
        add("add_holes");
        const auto fate = [&](int hole) { return line(QStringLiteral("Holes"))->child(hole)->text(2); };
        type_over(field("size"), QStringLiteral("3"));
        QTRY_COMPARE_WITH_TIMEOUT(fate(2), QStringLiteral("filled"), patience_ms);
        QCOMPARE(fate(0), QStringLiteral("left"));
        type_over(field("size"), QStringLiteral("4.5"));
        QTRY_COMPARE_WITH_TIMEOUT(fate(0), QStringLiteral("filled"), patience_ms);
        add("add_pieces");
        QVERIFY(kinds() == (std::vector<Kind>{Kind::holes, Kind::pieces}));
        tool("scan_up")->click();
        QVERIFY(kinds() == (std::vector<Kind>{Kind::pieces, Kind::holes}));
        // What cannot be carried out is said, and nothing is offered.
        panel().steps()->setCurrentRow(0);
        type_over(field("size"), QStringLiteral("0"));
        QTest::keyClick(field("size"), Qt::Key_Return);
        QVERIFY(!button("scan_preview")->isEnabled() && !button("scan_apply")->isEnabled());
        QVERIFY2(text("scan_remark").contains(QStringLiteral("no limit")), qPrintable(text("scan_remark")));
        shot(w(), QStringLiteral("scan-wrong"));
        type_over(field("size"), QStringLiteral("4"));
        QTest::keyClick(field("size"), Qt::Key_Return);
        QVERIFY(button("scan_preview")->isEnabled());
        panel().steps()->item(0)->setCheckState(Qt::Unchecked);
        QVERIFY(scan().recipe()[0].off);
        press("scan_preview");
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(scan().trial()->steps.size(), std::size_t(1));
        QCOMPARE(after(QStringLiteral("Pieces")), QStringLiteral("2"));
        QVERIFY(step_text(0).endsWith(QStringLiteral("off")));
        QVERIFY(activate(w()));
        panel().steps()->setFocus();
        QTest::keyClick(panel().steps(), Qt::Key_Delete);
        QCOMPARE(kinds().size(), std::size_t(1));
        // A recipe that leaves nothing says which step it is, and changes nothing.
        add("add_pieces");
        type_over(field("size"), QStringLiteral("1000"));
        QTest::keyClick(field("size"), Qt::Key_Return);
        press("scan_preview");
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(text("scan_summary"), QStringLiteral("Step 2 could not be carried out."));
        QVERIFY(!button("scan_apply")->isEnabled());
        QVERIFY2(step_text(1).contains(QStringLiteral("leaves no facet")), qPrintable(step_text(1)));
        QVERIFY(!shown() && !w().document().undo_stack().canUndo());
        shot(w(), QStringLiteral("scan-failed"));
    }

    /// Each hole is filled as it is chosen, by the mouse or by keys.
    void a_hole_is_chosen_by_itself() {
        open_room();
        add("add_holes");
        type_over(field("size"), QStringLiteral("0"));
        QTest::keyClick(field("size"), Qt::Key_Return);
        line(QStringLiteral("Holes"))->setExpanded(true);
        const auto fate = [&](int hole) { return line(QStringLiteral("Holes"))->child(hole)->text(2); };
        const auto choose = [&](int hole, const char* choice, bool picture = false) {
            panel().survey()->setCurrentItem(line(QStringLiteral("Holes"))->child(hole));
            emit panel().survey()->customContextMenuRequested({});
            auto* menu = panel().findChild<QMenu*>(QStringLiteral("hole_choices"));
            QVERIFY(menu && menu->isVisible());
            if (picture) shot(*menu, QStringLiteral("scan-hole-choices"));
            menu->findChild<QAction*>(QLatin1String(choice))->trigger();
            menu->close();
            delete menu;
            QVERIFY(wait_until_settled(w()));
        };
        // The largest is that of the top; the rim of the loose sheet, which no patch fits, is as large as
        // that below.
        const auto& holes = scan().scan()->survey.holes.holes;
        QCOMPARE(holes.size(), std::size_t(3));
        const int below = holes[1].center.z() < 1 ? 1 : 2;
        choose(0, "hole_left", true);
        QVERIFY(kinds() == (std::vector<Kind>{Kind::hole, Kind::holes}));
        QVERIFY(scan().recipe()[0].fill == RepairStep::Fill::left);
        QCOMPARE(fate(0), QStringLiteral("left"));
        QCOMPARE(fate(below), QStringLiteral("filled"));
        choose(below, "hole_flat");
        QCOMPARE(kinds().size(), std::size_t(3));
        press("scan_preview");
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(step_text(0).contains(QStringLiteral("One hole, left open"))
                     && step_text(0).contains(QStringLiteral("1 hole left as asked")),
                 qPrintable(step_text(0)));
        QVERIFY2(step_text(1).contains(QStringLiteral("1 hole filled")), qPrintable(step_text(1)));
        QVERIFY2(step_text(2).contains(QStringLiteral("1 hole left as asked")), qPrintable(step_text(2)));
        QCOMPARE(after(QStringLiteral("Holes")), QStringLiteral("2"));
        shot(w(), QStringLiteral("scan-hole-chosen"));
        choose(0, "hole_as_all");
        QVERIFY(kinds() == (std::vector<Kind>{Kind::hole, Kind::holes}));
        QCOMPARE(fate(0), QStringLiteral("filled"));
        choose(below, "hole_smooth");
        QCOMPARE(kinds().size(), std::size_t(2));
    }

    /// Another scan is asked for; without one there is no step.
    void a_scan_to_join_is_asked_for() {
        open_room();
        bool asked = false;
        answer_file_dialog(asked);
        add("add_join");
        QVERIFY(asked && scan().recipe().empty());
        // The same block, half its length on.
        Mesh other = rough_block();
        for (Vec3& v : other.vertices)
            v.x() += 12;
        const QString file = folder_ + QStringLiteral("/other.stl");
        save_stl(other, file.toStdString(), LengthUnit::mm, {});
        asked = false;
        answer_file_dialog(asked, file);
        add("add_join");
        QVERIFY(asked && scan().recipe().size() == 1 && scan().recipe()[0].kind == Kind::join);
        QVERIFY(std::filesystem::equivalent(scan().recipe()[0].file, file.toStdString()));
        QVERIFY2(step_text(0).contains(QStringLiteral("other.stl")), qPrintable(step_text(0)));
        press("scan_preview");
        QVERIFY(wait_until_settled(w()));
        QVERIFY(scan().trial());
        shot(w(), QStringLiteral("scan-join"));
    }

    void a_preview_that_is_stopped_leaves_nothing() {
        open_room();
        press("scan_suggest");
        press("scan_preview");
        QVERIFY(scan().busy() && button("scan_stop")->isVisible() && !button("scan_preview")->isEnabled());
        press("scan_stop");
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!scan().trial() && !shown() && !button("scan_stop")->isVisible());
        QVERIFY(button("scan_preview")->isEnabled() && !w().document().undo_stack().canUndo());
        // By the key as well.
        press("scan_preview");
        QVERIFY(activate(w()));
        w().viewport().setFocus();
        QTest::keyClick(&w().viewport(), Qt::Key_Escape);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!scan().trial());
        press("scan_preview");
        QVERIFY(wait_until_settled(w()));
        QVERIFY(shown());
    }

    /// The recipe is the project's: it runs when the project is opened, and when the file has changed.
    void it_runs_again_when_the_file_changes() {
        open_room();
        press("scan_suggest");
        press("scan_apply");
        QVERIFY(wait_until_settled(w()));
        const QString project = folder_ + QStringLiteral("/scan.facetmill");
        QVERIFY(w().files().save_to(project));
        close_window();
        QVERIFY(show_window());
        w().open_file(project);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(filled(), std::size_t(2));
        open_room();
        QCOMPARE(kinds(), (std::vector<Kind>{Kind::pieces, Kind::turn, Kind::holes}));
        QVERIFY2(step_text(2).contains(QStringLiteral("2 holes filled")), qPrintable(step_text(2)));
        QCOMPARE(text("scan_summary"), QStringLiteral("This recipe is in the project."));
        shot(w(), QStringLiteral("scan-reopened"));
        write_scan(folder_, true);
        QTRY_COMPARE_WITH_TIMEOUT(filled(), std::size_t(3), patience_ms);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().part()->report.watertight);
        QCOMPARE(found(QStringLiteral("Holes")), QStringLiteral("4"));
        QVERIFY2(step_text(2).contains(QStringLiteral("3 holes filled")), qPrintable(step_text(2)));
    }

    void it_has_room_in_a_small_window() {
        w().resize(800, 600);
        open_room();
        press("scan_suggest");
        press("scan_preview");
        QVERIFY(wait_until_settled(w()));
        for (const char* name : {"scan_preview", "scan_apply", "scan_reset"})
            QVERIFY2(button(name)->isVisible()
                         && panel().rect().contains(
                             button(name)->mapTo(&panel(), button(name)->rect().bottomRight())),
                     name);
        QVERIFY(w().width() <= 800 && w().height() <= 600);
        shot(w(), QStringLiteral("scan-small"));
    }

private:
    ui::ScanController& scan() { return w().controllers().scan(); }
    ui::ScanPanel& panel() { return *scan().panel(); }
    RepairDisplayPtr shown() { return w().viewport().scene().repair().display(); }
    QDockWidget* dock() { return w().findChild<QDockWidget*>(QStringLiteral("scan_dock")); }
    QPushButton* button(const char* name) { return panel().findChild<QPushButton*>(QLatin1String(name)); }
    QToolButton* tool(const char* name) { return panel().findChild<QToolButton*>(QLatin1String(name)); }
    QRadioButton* radio(const char* name) { return panel().findChild<QRadioButton*>(QLatin1String(name)); }
    QLineEdit* field(const char* name) { return panel().form()->findChild<QLineEdit*>(QLatin1String(name)); }
    QString text(const char* name) { return panel().findChild<QLabel*>(QLatin1String(name))->text(); }
    void press(const char* name) { button(name)->click(); }
    void add(const char* name) {
        for (QAction* a : tool("scan_add")->menu()->actions())
            if (a->objectName() == QLatin1String(name)) return a->trigger();
        QFAIL(name);
    }
    void open_room() {
        action(w(), "scan_room")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(panel().isVisible() && scan().scan());
    }
    std::vector<Kind> kinds() {
        std::vector<Kind> all;
        for (const RepairStep& step : scan().recipe())
            all.push_back(step.kind);
        return all;
    }
    QString step_text(int i) { return panel().steps()->item(i)->text(); }
    QTreeWidgetItem* line(const QString& what) {
        const auto lines = panel().survey()->findItems(what, Qt::MatchExactly);
        return lines.isEmpty() ? nullptr : lines.front();
    }
    QString found(const QString& what) { return line(what)->text(ui::ScanPanel::now_column); }
    QString after(const QString& what) { return line(what)->text(ui::ScanPanel::after_column); }
    std::size_t filled() {
        const auto& part = w().document().part();
        if (!part || part->repairs.size() < 3) return 0;
        return part->repairs[2].count("filled");
    }

    QString folder_;
};

FACETMILL_TEST(TestWindowScanRoom)
#include "test_window_scan_room.moc"
