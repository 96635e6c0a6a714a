// Boundaries in the window: added from a menu, edited in a form, named by operations, painted on the part;
// each change a step of the history.
#include "core/base/usual_value.h"
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "ui/boundary_box.h"
#include "ui/message_bar.h"
#include "ui/parameter_form.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/tool_list.h"
#include "ui/viewport.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>
#include <QTreeWidget>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

class TestWindowBoundaries : public QObject, private WindowFixture {
    Q_OBJECT

    const Project& project() { return w().document().project(); }
    const Boundary& boundary(std::size_t i = 0) { return project().boundaries.at(i); }
    QTreeWidgetItem* item(std::size_t i) { return w().tree().item({TreeNode::Kind::boundary, i}); }
    void add(const char* name) {
        for (QAction* a : w().tree().add_boundary_menu()->actions())
            if (a->objectName() == QLatin1String(name)) a->trigger();
        QVERIFY(wait_until_settled(w()));
    }
    QWidget* row(const char* key) {
        return w().properties().form()->findChild<QWidget*>(QString::fromLatin1(key));
    }
    QString hint() { return w().properties().findChild<QLabel*>(QStringLiteral("properties_hint"))->text(); }
    void pick_in(const char* key, const QString& label) {
        auto* box = qobject_cast<QComboBox*>(row(key));
        QVERIFY2(box, key);
        const int at = box->findText(label);
        QVERIFY2(at >= 0, qPrintable(label));
        box->setCurrentIndex(at);
        emit box->activated(at);
        QVERIFY(wait_until_settled(w()));
    }

    ui::BoundaryBox& box() { return *w().properties().boundary_box(); }
    void press_button(const char* name) {
        auto* button = box().findChild<QAbstractButton*>(QString::fromLatin1(name));
        QVERIFY2(button, name);
        button->click();
        QVERIFY(wait_until_settled(w()));
    }
    void set_number(const char* name, double value) {
        auto* number = box().findChild<QDoubleSpinBox*>(QString::fromLatin1(name));
        QVERIFY2(number, name);
        number->setValue(value);
    }
    static double height(double x, double y) { return 3 + 2 * std::sin(x / 5) * std::cos(y / 6); }
    static Vec3 on_part(double x, double y) { return {x, y, height(x, y)}; }
    QPoint pixel(const Vec3& p) {
        const Vec2 at = w().viewport().scene().camera().display_of(p) / w().viewport().devicePixelRatioF();
        return {int(std::lround(at.x())), int(std::lround(at.y()))};
    }
    void move_to(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys) {
        for (int k = 1; k <= 4; ++k) {
            const QPointF at = QPointF(from) + 0.25 * k * QPointF(to - from);
            QMouseEvent move(QEvent::MouseMove, at, w().viewport().mapToGlobal(at), Qt::NoButton,
                             Qt::LeftButton, keys);
            QApplication::sendEvent(&w().viewport(), &move);
        }
    }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) {
        QTest::mousePress(&w().viewport(), Qt::LeftButton, keys, from);
        move_to(from, to, keys);
        QTest::mouseRelease(&w().viewport(), Qt::LeftButton, keys, to);
        QVERIFY(wait_until_settled(w()));
    }
    void from_above() {
        w().viewport().set_view(StandardView::top);
        w().viewport().fit();
        QVERIFY(wait_until_settled(w()));
    }
    std::vector<Index> painted() {
        return facet_ranges(boundary().facets, std::size_t(boundary().of_facets));
    }
    const Mesh& part() { return *w().document().part()->mesh; }
    Vec3 middle(Index f) { return (part().corner(f, 0) + part().corner(f, 1) + part().corner(f, 2)) / 3; }

private slots:
    void init() {
        QVERIFY(show_window());
        folder_ = scratch_folder(QStringLiteral("boundaries"));
        save_stl(height_field(height, Vec2(0, 0), Vec2(40, 30), 40, 30),
                 (folder_ + "/field.stl").toStdString(), LengthUnit::mm, {});
        QFile file(folder_ + "/job.facetmill");
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({ "facetmill": 1, "units": "mm", "part": { "file": "field.stl" },
            "tools": [ { "number": 1, "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_length": 30 } ],
            "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.2 } ] })");
        file.close();
        w().open_file(file.fileName());
        QVERIFY(wait_until_settled(w()));
    }
    void cleanup() { close_window(); }

    void they_are_added_edited_and_removed() {
        const std::string before = project_to_json(project());
        add("boundary_facets");
        QCOMPARE(item(0)->text(0), QStringLiteral("Painted"));
        QVERIFY(w().tree().selected() == (TreeNode{TreeNode::Kind::boundary, 0}));
        QCOMPARE(boundary().of_facets, 2400L);
        QVERIFY2(hint().startsWith(QStringLiteral("0 of ")), qPrintable(hint()));
        QVERIFY(row("invert") && !row("facets") && !row("of_facets") && !row("slope0") && !row("offset"));
        add("boundary_curve");
        QCOMPARE(boundary(1).curve.size(), std::size_t(4));
        QCOMPARE(hint(), QStringLiteral("4 corners"));
        QVERIFY(row("offset") && !row("curve") && !row("slope0"));
        add("boundary_silhouette");
        add("boundary_slope");
        QVERIFY(row("slope0") && !row("offset"));
        QCOMPARE(project().boundaries.size(), std::size_t(4));
        w().tree().duplicate_action()->trigger();
        QCOMPARE(item(4)->text(0), QStringLiteral("Slope 2"));
        QVERIFY(w().tree().selected() == (TreeNode{TreeNode::Kind::boundary, 4}));
        w().tree().remove_action()->trigger();
        QCOMPARE(project().boundaries.size(), std::size_t(4));
        w().tree().select({TreeNode::Kind::boundary, 3});
        // Another kind: its own keys, and what it needs to be read again.
        pick_in("kind", QStringLiteral("curve"));
        QVERIFY(row("offset") && !row("slope0"));
        QCOMPARE(boundary(3).curve.size(), std::size_t(4));
        pick_in("kind", QStringLiteral("slope"));
        enter(w(), "name", QStringLiteral("Curve"));
        QVERIFY(!error_under(w(), "name").isEmpty());
        enter(w(), "name", QStringLiteral("Steep"));
        QCOMPARE(item(3)->text(0), QStringLiteral("Steep"));
        shot(w(), QStringLiteral("boundaries-slope"));
        check_project(project());
        while (w().document().undo_stack().canUndo())
            w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(project_to_json(project()), before);
    }

    /// Combo boxes in the operation's form; keys that say nothing are not shown; a new name is followed, one
    /// that is in use is not removed.
    void operations_name_them() {
        add("boundary_slope");
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(row("boundary") && row("avoid") && !row("contain") && !row("avoid_distance"));
        pick_in("boundary", QStringLiteral("Slope"));
        QCOMPARE(first_operation(w()).boundary, std::string("Slope"));
        QVERIFY(row("contain") && !row("avoid_distance"));
        add("boundary_facets");
        w().tree().select({TreeNode::Kind::operation, 0});
        pick_in("avoid", QStringLiteral("Painted"));
        QVERIFY(row("contain") && row("avoid_distance"));
        shot(w(), QStringLiteral("boundaries-operation"));
        w().tree().select({TreeNode::Kind::boundary, 0});
        enter(w(), "name", QStringLiteral("Flat"));
        QCOMPARE(first_operation(w()).boundary, std::string("Flat"));
        w().tree().remove_action()->trigger();
        QCOMPARE(project().boundaries.size(), std::size_t(2));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("Finish")),
                 qPrintable(w().message_bar().message()));
        w().tree().select({TreeNode::Kind::operation, 0});
        pick_in("boundary", QStringLiteral("everywhere"));
        QVERIFY(!row("contain"));
        w().tree().select({TreeNode::Kind::boundary, 0});
        w().tree().remove_action()->trigger();
        QCOMPARE(project().boundaries.size(), std::size_t(1));
    }

    /// A smaller tool cuts where a larger one cannot come. The boundary follows its tool, and holds it.
    void what_a_tool_leaves() {
        w().document().change(QStringLiteral("Tools"), [](Project& p) {
            p.tools.push_back(p.tools[0]);
            p.tools[1].number = 2;
            p.tools[1].name = "Large ball";
            p.tools[1].diameter = 40;
            p.tools[1].corner_radius = 20;
        });
        add("boundary_rest");
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY(boundary().kind == Boundary::Kind::rest && boundary().tool == 2);
        QVERIFY(row("more_than") && row("offset") && row("invert") && !row("slope0"));
        QVERIFY(qobject_cast<QComboBox*>(row("tool"))->currentText().contains(QStringLiteral("Large ball")));
        from_above();
        shot(w(), QStringLiteral("boundaries-rest"));
        w().tree().select({TreeNode::Kind::operation, 0});
        pick_in("boundary", QStringLiteral("Rest"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QCOMPARE(w().document().state(0), ui::OperationState::planned);
        const auto result = w().document().result(0);
        QVERIFY(result);
        std::size_t within = 0;
        for (const Pass& pass : result->path.passes)
            for (const auto& cl : pass.cl) {
                // In hollows alone: the ball of 40 comes to all that is higher than the middle.
                QVERIFY2(cl.tip.z() < 3.2, qPrintable(QString::number(cl.tip.z())));
                ++within;
            }
        QVERIFY(within > 20);
        shot(w(), QStringLiteral("boundaries-rest-planned"));
        // Its tool: another shape makes the plan old, another number is followed, and it is not removed.
        Tool narrower = project().tools[1];
        narrower.diameter = 30;
        narrower.corner_radius = 15;
        narrower.number = 9;
        ui::set_tool(w().document(), 1, narrower);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(boundary().tool, 9L);
        QCOMPARE(w().document().state(0), ui::OperationState::stale);
        QCOMPARE(code_of([&] { ui::remove_tool(w().document(), 1); }), std::string("missing_reference"));
        // The ball of 6 leaves nothing here: said where it is chosen.
        w().tree().select({TreeNode::Kind::boundary, 0});
        pick_in("tool", qobject_cast<QComboBox*>(row("tool"))->itemText(0));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("leaves nothing")),
                 qPrintable(w().message_bar().message()));
    }

    /// A plan is out of date when a boundary that it names says something else, not when another one does.
    void plans_go_stale_with_what_they_name() {
        add("boundary_slope");
        add("boundary_silhouette");
        w().tree().select({TreeNode::Kind::operation, 0});
        pick_in("boundary", QStringLiteral("Slope"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QCOMPARE(w().document().state(0), ui::OperationState::planned);
        w().tree().select({TreeNode::Kind::boundary, 1});
        enter(w(), "offset", QStringLiteral("-1"));
        QCOMPARE(w().document().state(0), ui::OperationState::planned);
        w().tree().select({TreeNode::Kind::boundary, 0});
        enter(w(), "slope1", QStringLiteral("20"));
        QCOMPARE(w().document().state(0), ui::OperationState::stale);
    }

    /// Painted on a part that has another number of facets now: said, not guessed.
    void another_part_is_not_painted() {
        add("boundary_facets");
        w().document().change(QStringLiteral("Other part"), [](Project& p) {
            p.boundaries[0].facets = "0-3";
            p.boundaries[0].of_facets = 100;
        });
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(hint().contains(QStringLiteral("paint it anew")), qPrintable(hint()));
    }

    /// A drag paints what the ring touches on its way, with Shift it erases; each is one step of the history.
    void a_brush_paints_and_erases() {
        from_above();
        add("boundary_facets");
        press_button("paint");
        // Of the part's size a round number.
        const double radius = w().findChild<QDoubleSpinBox*>(QStringLiteral("paint_radius"))->value();
        QVERIFY2(radius > 0 && std::abs(radius - round_to_digit(radius)) < 1e-9 * radius,
                 qPrintable(QString::number(radius)));
        set_number("paint_radius", 3);
        const int steps = w().document().undo_stack().count();
        const Vec3 from = on_part(10, 15), to = on_part(30, 15);
        drag(pixel(from), pixel(to));
        QCOMPARE(w().document().undo_stack().count(), steps + 1);
        std::vector<char> in(part().facet_count(), 0);
        const double slack = 2 * w().viewport().scene().camera().pixel_size() + 0.1;
        for (const Index f : painted())
            in[f] = 1;
        for (Index f = 0; f < part().facet_count(); ++f) {
            const Vec3 at = middle(f);
            const Vec2 nearest(std::clamp(at.x(), from.x(), to.x()), from.y());
            const double away = (at.head<2>() - nearest).norm();
            if (in[f]) QVERIFY2(away < 3 + 1.5 + slack, qPrintable(QString::number(away)));
            // The ring is wider than the ball where the part slopes.
            if (away < 1.5 - slack) QVERIFY2(in[f], qPrintable(QString::number(f)));
        }
        const std::size_t all = painted().size();
        QVERIFY2(hint().startsWith(QString::number(all)), qPrintable(hint()));
        shot(w(), QStringLiteral("boundaries-brush"));
        drag(pixel(on_part(20, 12)), pixel(on_part(20, 18)), Qt::ShiftModifier);
        QVERIFY(painted().size() < all && !painted().empty());
        for (const Index f : painted())
            QVERIFY((middle(f) - on_part(20, 15)).norm() > 0.5);
        // The same by the box, with Shift the other way round.
        press_button("paint_erase");
        drag(pixel(on_part(12, 15)), pixel(on_part(13, 15)));
        const std::size_t less = painted().size();
        QVERIFY(less < all);
        drag(pixel(on_part(12, 15)), pixel(on_part(13, 15)), Qt::ShiftModifier);
        QVERIFY(painted().size() > less);
        press_button("paint_erase");
        for (int n = 0; n < 3; ++n)
            w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(painted().size(), all);
        // What comes next goes on from there.
        drag(pixel(on_part(20, 5)), pixel(on_part(22, 5)));
        QVERIFY(painted().size() > all);
        // Beside the part and with Ctrl the view turns, and nothing is painted.
        const std::string before = boundary().facets;
        const Vec3 up = w().viewport().up(); // seen from above: about Z
        drag(pixel(on_part(20, 25)), pixel(on_part(30, 25)), Qt::ControlModifier);
        QVERIFY((w().viewport().up() - up).norm() > 1e-3);
        drag(QPoint(4, 4), QPoint(40, 30));
        QCOMPARE(boundary().facets, before);
        QTest::keyClick(&w().viewport(), Qt::Key_Escape);
        QVERIFY(!box().active() && !w().viewport().tool());
        from_above();
        drag(pixel(on_part(20, 25)), pixel(on_part(30, 25)));
        QCOMPARE(boundary().facets, before);
    }

    void floods_and_boxes() {
        from_above();
        add("boundary_facets");
        press_button("paint");
        press_button("paint_flood");
        set_number("paint_angle", 90);
        QTest::mouseClick(&w().viewport(), Qt::LeftButton, {}, pixel(on_part(20, 15)));
        QCOMPARE(painted().size(), part().facet_count());
        press_button("paint_clear");
        QVERIFY(painted().empty());
        set_number("paint_angle", 2);
        QTest::mouseClick(&w().viewport(), Qt::LeftButton, {}, pixel(on_part(20, 15)));
        QVERIFY(!painted().empty() && painted().size() < part().facet_count());
        press_button("paint_clear");
        press_button("paint_box");
        // Facets wholly within.
        const QPoint a = pixel(on_part(8.5, 8.5)), b = pixel(on_part(20.5, 18.5));
        drag(a, b);
        const QRectF rect = QRectF(a, b).normalized();
        std::vector<Index> expected;
        for (Index f = 0; f < part().facet_count(); ++f) {
            bool in = true;
            for (int k = 0; k < 3; ++k) {
                const Vec2 at = w().viewport().scene().camera().display_of(part().corner(f, k))
                                / w().viewport().devicePixelRatioF();
                in = in && rect.contains(QPointF(at.x(), at.y()));
            }
            if (in) expected.push_back(f);
        }
        QVERIFY(expected.size() > 150);
        QCOMPARE(painted(), expected);
        shot(w(), QStringLiteral("boundaries-box"));
        // From the side most is hidden behind a wave, unless one paints through.
        press_button("paint_clear");
        w().viewport().set_view(StandardView::front);
        w().viewport().fit();
        QVERIFY(wait_until_settled(w()));
        const QRect whole = w().viewport().rect().adjusted(3, 3, -3, -3);
        drag(whole.topLeft(), whole.bottomRight());
        const std::size_t seen = painted().size();
        QVERIFY(seen > 100 && seen < part().facet_count());
        press_button("paint_through");
        drag(whole.topLeft(), whole.bottomRight());
        QCOMPARE(painted().size(), part().facet_count());
        // Esc while they are still looked for: nothing comes after it.
        press_button("paint_clear");
        const int steps = w().document().undo_stack().count();
        QTest::mousePress(&w().viewport(), Qt::LeftButton, {}, whole.topLeft());
        move_to(whole.topLeft(), whole.bottomRight(), {});
        QTest::mouseRelease(&w().viewport(), Qt::LeftButton, {}, whole.bottomRight());
        QTest::keyClick(&w().viewport(), Qt::Key_Escape);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(painted().empty() && w().document().undo_stack().count() == steps);
    }

    void all_at_once() {
        from_above();
        add("boundary_facets");
        press_button("paint");
        set_number("paint_radius", 3);
        drag(pixel(on_part(20, 15)), pixel(on_part(21, 15)));
        const std::vector<Index> first = painted();
        press_button("paint_grow");
        const std::size_t grown = painted().size();
        QVERIFY(grown > first.size());
        press_button("paint_shrink");
        QVERIFY(painted().size() < grown);
        set_number("paint_distance", 5);
        press_button("paint_grow");
        QVERIFY(painted().size() > grown);
        const std::size_t before = painted().size();
        press_button("paint_invert");
        QCOMPARE(painted().size(), part().facet_count() - before);
        press_button("paint_clear");
        QVERIFY(painted().empty());
        for (int n = 0; n < 5; ++n)
            w().document().undo_stack().undo();
        QCOMPARE(painted(), first);
    }

    void a_curve_is_drawn_and_its_corners_dragged() {
        from_above();
        add("boundary_curve");
        press_button("paint");
        const std::string before = project_to_json(project());
        const auto click = [&](double x, double y) {
            QTest::mouseClick(&w().viewport(), Qt::LeftButton, {}, pixel(on_part(x, y)));
        };
        click(10, 10);
        click(30, 10);
        QTest::keyClick(&w().viewport(), Qt::Key_Return); // two are too few
        QCOMPARE(project_to_json(project()), before);
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("three corners")),
                 qPrintable(w().message_bar().message()));
        click(35, 25);
        QTest::keyClick(&w().viewport(), Qt::Key_Backspace);
        click(30, 20);
        click(10, 20);
        QCOMPARE(project_to_json(project()), before); // not closed yet
        QTest::keyClick(&w().viewport(), Qt::Key_Return);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(boundary().curve.size(), std::size_t(4));
        const double slack = 2 * w().viewport().scene().camera().pixel_size() + 1e-3;
        const auto corner = [&](std::size_t i) {
            const auto& at = boundary().curve[i].at;
            return Vec3(at[0], at[1], at[2]);
        };
        QVERIFY((corner(2) - on_part(30, 20)).head<2>().norm() < slack);
        shot(w(), QStringLiteral("boundaries-curve"));
        drag(pixel(corner(2)), pixel(on_part(35, 25)));
        QVERIFY((corner(2) - on_part(35, 25)).head<2>().norm() < 2 * slack);
        w().document().undo_stack().undo();
        QVERIFY((corner(2) - on_part(30, 20)).head<2>().norm() < slack);
        // A double click closes another one; Esc in the middle leaves what was.
        click(5, 5);
        click(15, 5);
        QTest::mouseClick(&w().viewport(), Qt::LeftButton, {}, pixel(on_part(15, 15)));
        QTest::mouseDClick(&w().viewport(), Qt::LeftButton, {}, pixel(on_part(15, 15)));
        QVERIFY(wait_until_settled(w()));
        QVERIFY((corner(0) - on_part(5, 5)).head<2>().norm() < slack);
        const std::string closed = project_to_json(project());
        click(30, 20);
        QTest::keyClick(&w().viewport(), Qt::Key_Escape);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!box().active());
        QCOMPARE(project_to_json(project()), closed);
    }

    /// The chosen boundary's facets are tinted, and those that the chosen operation names, in two colours.
    void they_are_shown() {
        const QImage plain = view_picture(w());
        add("boundary_slope");
        enter(w(), "slope1", QStringLiteral("8"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(plain, view_picture(w())) > 2000);
        add("boundary_curve");
        w().tree().select({TreeNode::Kind::boundary, 1});
        enter(w(), "offset", QStringLiteral("-10"));
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(changed_pixels(plain, view_picture(w())), 0);
        pick_in("boundary", QStringLiteral("Curve"));
        const QImage within = view_picture(w());
        QVERIFY(changed_pixels(plain, within) > 2000);
        pick_in("avoid", QStringLiteral("Slope"));
        QVERIFY(changed_pixels(within, view_picture(w())) > 2000);
        shot(w(), QStringLiteral("boundaries-shown"));
        w().set_theme(ui::Theme::dark);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("boundaries-shown-dark"));
        w().resize(800, 600);
        w().tree().select({TreeNode::Kind::boundary, 1});
        press_button("paint");
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("boundaries-small-dark"));
        w().set_theme(ui::Theme::light);
        add("boundary_facets");
        press_button("paint");
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("boundaries-small"));
        w().tree().select({TreeNode::Kind::part, 0});
        w().resize(1280, 800);
    }

    /// Where a picture takes long, what is painted comes over the one that stands; it is what a picture of
    /// all shows.
    void a_large_part_is_painted_over_its_picture() {
        save_stl(height_field(height, Vec2(0, 0), Vec2(40, 30), 440, 330),
                 (folder_ + "/large.stl").toStdString(), LengthUnit::mm, {});
        w().open_file(folder_ + "/large.stl", LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        from_above();
        add("boundary_facets");
        press_button("paint");
        set_number("paint_radius", 4);
        QVERIFY(wait_until_settled(w()));
        const QImage before = view_picture(w());
        const QPoint from = pixel(on_part(10, 15)), to = pixel(on_part(30, 15));
        QTest::mousePress(&w().viewport(), Qt::LeftButton, {}, from);
        move_to(from, to, {});
        QVERIFY(wait_until_settled(w()));
        const QImage over = w().viewport().picture();
        const int tinted = changed_pixels(before, over);
        QVERIFY2(tinted > 5000, qPrintable(QString::number(tinted)));
        QTest::mouseRelease(&w().viewport(), Qt::LeftButton, {}, to);
        QVERIFY(wait_until_settled(w()));
        // All but the line in the legend, and what smoothing does at the rim.
        const int others = changed_pixels(over, view_picture(w()));
        QVERIFY2(others < tinted / 8, qPrintable(QString("%1 of %2").arg(others).arg(tinted)));
        QVERIFY(painted().size() > 1000);
    }

private:
    QString folder_;
};

FACETMILL_TEST(TestWindowBoundaries)
#include "test_window_boundaries.moc"
