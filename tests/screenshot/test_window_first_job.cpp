// Whole first jobs with mouse and keys, from an empty window to posted programs: a relief in millimetres by
// the steps above the view, and a mould in inches that lies on its side.
#include "core/mesh/mesh_io.h"
#include "core/tools/library_file.h"
#include "core/tools/tool_library.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/part_meshes.h"
#include "ui/controllers.h"
#include "ui/first_steps.h"
#include "ui/parameter_form.h"
#include "ui/part_dialog.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/settings.h"
#include "ui/settings_file.h"
#include "ui/text.h"
#include "ui/tool_dialog.h"
#include "ui/tool_library_dialog.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"
#include "ui/workspaces.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;
using ui::FirstSteps;
using ui::TreeNode;

namespace {

/// Gentle hills, 40 x 30 mm, as a scan might be.
Mesh handed_relief() {
    return height_field([](double x, double y) { return 3 + std::sin(x / 7) * std::cos(y / 8); }, Vec2(0, 0),
                        Vec2(40, 30), 40, 30);
}

/// A closed block of 2 x 1.5 x 0.75 in with a bowl in its top, in mm; the bowl faces +Z.
Mesh bowl_block() {
    const double in = mm_per_inch, length = 2 * in, width = 1.5 * in, height = 0.75 * in;
    const int nx = 32, ny = 24;
    Mesh m = height_field(
        [&](double x, double y) {
            const double u = (x - length / 2) / (0.3 * length), v = (y - width / 2) / (0.3 * width);
            return height - 0.25 * in * std::exp(-(u * u + v * v));
        },
        Vec2(0, 0), Vec2(length, width), nx, ny);
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto first = Index(m.vertices.size());
        m.vertices.insert(m.vertices.end(), {a, b, c});
        m.facets.push_back({first, first + 1, first + 2});
    };
    // Walls below the border of the top, as its vertices come in rows.
    const auto top = [&](int i, int j) { return m.vertices[std::size_t(j) * (nx + 1) + std::size_t(i)]; };
    const auto down = [](Vec3 p) {
        p.z() = 0;
        return p;
    };
    const auto wall = [&](const Vec3& a, const Vec3& b) { // seen from outside a is on the left
        add(down(a), down(b), b);
        add(down(a), b, a);
    };
    for (int i = 0; i < nx; ++i) {
        wall(top(i, 0), top(i + 1, 0));
        wall(top(i + 1, ny), top(i, ny));
    }
    for (int j = 0; j < ny; ++j) {
        wall(top(nx, j), top(nx, j + 1));
        wall(top(0, j + 1), top(0, j));
    }
    add({0, 0, 0}, {0, width, 0}, {length, width, 0});
    add({0, 0, 0}, {length, width, 0}, {length, 0, 0});
    return m;
}

/// Tipped over about X: what faced +Z faces -Y.
Mesh on_its_side(Mesh m) {
    for (Vec3& p : m.vertices)
        p = Vec3(p.x(), -p.z(), p.y());
    return m;
}

} // namespace

class TestWindowFirstJob : public QObject, private WindowFixture {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> data_; ///< the user's own folder
    QByteArray data_before_;
    QString folder_;

    FirstSteps& steps() { return *w().findChild<FirstSteps*>(); }
    void click(QWidget* at) {
        QVERIFY(at && at->isVisible() && at->isEnabled());
        QTest::mouseClick(at, Qt::LeftButton);
    }
    void click(const char* name) {
        auto* button = w().findChild<QAbstractButton*>(QLatin1String(name));
        QVERIFY2(button && button->isEnabled() && button->isVisible(), name);
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY2(wait_until_settled(w()), name);
    }
    template <class Dialog>
    Dialog* dialog() {
        Dialog* found = nullptr;
        (void)QTest::qWaitFor([&] { return (found = w().findChild<Dialog*>()) && found->isVisible(); },
                              patience_ms);
        return found;
    }
    /// A line of a menu that is open.
    void click_entry(QMenu* menu, const QString& words) {
        QVERIFY(menu && QTest::qWaitFor([&] { return menu->isVisible(); }, patience_ms));
        for (QAction* a : menu->actions())
            if (a->text().remove(QChar('&')) == words) {
                QVERIFY2(a->isEnabled(), qPrintable(words));
                return QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(a).center());
            }
        QFAIL(qPrintable(words));
    }
    /// A choice of a box, by keys, as one that has the focus takes them.
    void pick(QComboBox* box, const QString& words) {
        QVERIFY(box);
        int at = -1;
        for (int i = 0; i < box->count() && at < 0; ++i)
            if (box->itemText(i).contains(words)) at = i;
        QVERIFY2(at >= 0, qPrintable(words));
        box->setFocus();
        while (box->currentIndex() < at)
            QTest::keyClick(box, Qt::Key_Down);
        while (box->currentIndex() > at)
            QTest::keyClick(box, Qt::Key_Up);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(box->currentIndex(), at);
    }
    QComboBox* form_box(const char* name) {
        return w().properties().form()->findChild<QComboBox*>(QLatin1String(name));
    }
    void add_operation(const QString& words) {
        auto* add = w().tree().findChild<QToolButton*>(QStringLiteral("add"));
        QVERIFY(add);
        QMenu* menu = add->menu();
        menu->popup(add->mapToGlobal(QPoint(0, add->height())));
        click_entry(menu, words);
        QVERIFY(wait_until_settled(w()));
    }
    /// Answers the question for the unit, by the mouse.
    void answer_unit(const QString& words) {
        auto* asked = dialog<ui::PartDialog>();
        QVERIFY(asked);
        for (auto* unit : asked->findChildren<QRadioButton*>())
            if (unit->text().remove(QChar('&')).startsWith(words)) unit->click();
        QTest::mouseClick(asked->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                          Qt::LeftButton);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().part_is_current());
    }
    void plan_and_verify() {
        QVERIFY(activate(w()));
        w().setFocus();
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY(w().document().all_planned());
        QTest::keyClick(&w(), Qt::Key_F6);
        QVERIFY(wait_until_settled(w()));
        const ui::VerificationModel& model = w().verification().model();
        QVERIFY2(model.verdict() == ui::Verdict::verified, qPrintable(model.failure_text()));
    }
    /// Into a folder that is not there yet; what was written.
    QStringList export_programs() {
        QLineEdit* into = nullptr;
        (void)QTest::qWaitFor(
            [&] { return (into = w().findChild<QLineEdit*>(QStringLiteral("export_folder"))); }, patience_ms);
        if (!into) return {};
        type_over(into, folder_ + QStringLiteral("/programs"));
        QTest::mouseClick(into->window()->findChild<QPushButton*>(QStringLiteral("export")), Qt::LeftButton);
        (void)wait_until_settled(w());
        return QDir(folder_ + QStringLiteral("/programs")).entryList(QDir::Files, QDir::Name);
    }
    QString text_of(const QString& name) {
        QFile file(folder_ + QStringLiteral("/programs/") + name);
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }

private slots:
    void init() {
        ui::SettingsFile::own().clear();
        data_ = std::make_unique<QTemporaryDir>();
        data_before_ = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", data_->path().toUtf8());
        folder_ = scratch_folder(QStringLiteral("first"));
        QVERIFY(show_window());
    }
    void cleanup() {
        close_window();
        data_before_.isEmpty() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", data_before_);
    }
    void cleanupTestCase() { ui::SettingsFile::own().clear(); }

    /// By the steps above the view, which tick themselves off.
    void a_relief_in_millimetres() {
        save_stl(handed_relief(), (folder_ + QStringLiteral("/relief.stl")).toStdString(), LengthUnit::mm,
                 {});
        QVERIFY(!steps().isVisible()); // the program itself shows them at its first start
        action(w(), "first_steps")->trigger();
        QVERIFY(steps().isVisible() && steps().next() == 0);
        QTest::qWait(30);
        shot(w(), QStringLiteral("first-0"));

        bool asked = false;
        answer_file_dialog(asked, folder_ + QStringLiteral("/relief.stl"));
        click(steps().button(FirstSteps::Step::open));
        QVERIFY(asked);
        answer_unit(QStringLiteral("Millimetres"));
        QCOMPARE(steps().next(), std::size_t(FirstSteps::Step::place));

        click(steps().button(FirstSteps::Step::place));
        QVERIFY(wait_until_settled(w()));
        auto* dock = w().findChild<QDockWidget*>(QStringLiteral("place_dock"));
        QVERIFY(dock->isVisible());
        click("place_centre");
        click("zero_4");
        QCOMPARE(steps().next(), std::size_t(FirstSteps::Step::operations));
        shot(w(), QStringLiteral("first-2"));
        dock->hide();

        click(steps().button(FirstSteps::Step::operations));
        QVERIFY(w().properties().form()->isVisible());
        enter(w(), "tolerance", QStringLiteral("0.05"));
        QCOMPARE(steps().next(), std::size_t(FirstSteps::Step::judge));
        w().tree().select({TreeNode::Kind::machine, 0});
        pick(form_box("post"), QStringLiteral("Grbl"));

        // What is planned is not judged yet, and undone steps are not taken back.
        click(steps().button(FirstSteps::Step::judge));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().document().all_planned(), qPrintable(w().last_failure()));
        QCOMPARE(steps().next(), std::size_t(FirstSteps::Step::judge));
        click(steps().button(FirstSteps::Step::judge));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().verification().model().verdict() == ui::Verdict::verified,
                 qPrintable(w().verification().model().failure_text()));
        QCOMPARE(steps().next(), std::size_t(FirstSteps::Step::write));
        shot(w(), QStringLiteral("first-4"));

        click(steps().button(FirstSteps::Step::write));
        const QStringList files = export_programs();
        QCOMPARE(files.filter(QStringLiteral(".nc")).size(), 1);
        const QString program = text_of(files.filter(QStringLiteral(".nc")).front());
        QVERIFY2(program.contains(QStringLiteral("G21")) && program.count(QStringLiteral("G1")) > 20,
                 qPrintable(program.left(300)));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral(" files into ")),
                 qPrintable(w().message_bar().message()));
        QCOMPARE(steps().next(), FirstSteps::step_count);
        w().resize(800, 600);
        QTest::qWait(30);
        shot(w(), QStringLiteral("first-5-small"));
        QVERIFY(steps().width() <= 800 && w().viewport().height() > 200);
        click("end_first_steps");
        QVERIFY(!steps().isVisible() && !action(w(), "first_steps")->isChecked());
        // Another project begins anew.
        action(w(), "first_steps")->trigger();
        QCOMPARE(steps().next(), std::size_t(FirstSteps::Step::place));
    }

    /// Laid down by the menu of the face that is clicked; machine by the form, tools from the library.
    void a_mould_in_inches_on_its_side() {
        Tool ball = ball_tool(0.25 * mm_per_inch);
        ball.name = "Ball 1/4";
        Tool flat = ball;
        flat.name = "Flat 3/8";
        flat.diameter = flat.shank_diameter = 0.375 * mm_per_inch;
        flat.corner_radius = 0;
        for (Tool* t : {&ball, &flat}) {
            t->flute_length = 1.0 * mm_per_inch;
            t->shank_length = 1.0 * mm_per_inch;
        }
        (void)keep_library(library_of({ball, flat}, LengthUnit::inch, "shop"), user_library_folder(), "shop");
        save_stl(on_its_side(bowl_block()), (folder_ + QStringLiteral("/mould.stl")).toStdString(),
                 LengthUnit::inch, {});

        bool asked = false;
        answer_file_dialog(asked, folder_ + QStringLiteral("/mould.stl"));
        QTest::keyClick(&w(), Qt::Key_O, Qt::ControlModifier);
        QVERIFY(asked);
        answer_unit(QStringLiteral("Inches"));
        QVERIFY(w().document().unit() == LengthUnit::inch);

        // The bottom of the block is seen from the rear: that face comes down.
        ui::Viewport& view = w().viewport();
        QVERIFY(activate(w()));
        QTest::keyClick(&w(), Qt::Key_4);
        QVERIFY(wait_until_settled(w()));
        const Box3 before = w().document().part()->box;
        QVERIFY(before.size().z() > 1.2 * before.size().y());
        const Vec2 p =
            view.scene().camera().display_of(Vec3(before.center().x(), before.hi.y(), before.center().z()))
            / view.devicePixelRatioF();
        QTest::mouseClick(&view, Qt::RightButton, {}, QPoint(int(p.x()), int(p.y())));
        QMenu* clicked = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((clicked = w().findChild<QMenu*>(QStringLiteral("clicked_menu"))),
                                 patience_ms);
        click_entry(clicked, QStringLiteral("Lay on this face"));
        QVERIFY(wait_until_settled(w()));
        const Box3 laid = w().document().part()->box;
        QVERIFY2(std::abs(laid.size().z() - 0.75 * mm_per_inch) < 0.1,
                 qPrintable(QString::number(laid.size().z())));
        QVERIFY(shows_all(view));
        shot(w(), QStringLiteral("mould-laid"));
        QTest::keyClick(&w(), Qt::Key_0);

        w().tree().select({TreeNode::Kind::machine, 0});
        pick(form_box("machine"), QStringLiteral("rotary table A"));
        pick(form_box("post"), QStringLiteral("LinuxCNC"));
        QVERIFY(!w().document().project().programs.post.empty());

        w().tree().tool_library_action()->trigger();
        auto* library = dialog<ui::ToolLibraryDialog>();
        QVERIFY(library && activate(*library));
        auto* table = library->findChild<QTableWidget*>(QStringLiteral("tools"));
        QCOMPARE(table->rowCount(), 2);
        QTest::keyClicks(library->findChild<QLineEdit*>(QStringLiteral("filter")), QStringLiteral("ball"));
        QCOMPARE(table->rowCount(), 1);
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualItemRect(table->item(0, 1)).center());
        QTest::mouseClick(library->findChild<QPushButton*>(QStringLiteral("add")), Qt::LeftButton);
        type_over(library->findChild<QLineEdit*>(QStringLiteral("filter")), QStringLiteral("flat"));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualItemRect(table->item(0, 1)).center());
        QTest::mouseClick(library->findChild<QPushButton*>(QStringLiteral("add")), Qt::LeftButton);
        QTest::keyClick(library, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(!w().findChild<ui::ToolLibraryDialog*>(), patience_ms);
        QCOMPARE(w().document().project().tools.size(), std::size_t(3));

        w().tree().select({TreeNode::Kind::operation, 0});
        pick(form_box("tool"), QStringLiteral("Ball 1/4"));
        enter(w(), "tolerance", QStringLiteral("0.004"));
        add_operation(QStringLiteral("Rough"));
        QCOMPARE(w().document().operation_count(), std::size_t(2));
        QCOMPARE(w().document().operation(0).kind(), std::string_view("rough"));
        w().tree().select({TreeNode::Kind::operation, 0});
        pick(form_box("tool"), QStringLiteral("Flat 3/8"));
        shot(w(), QStringLiteral("mould-operations"));

        plan_and_verify();
        shot(w(), QStringLiteral("mould-verified"));

        QTest::keyClick(&w(), Qt::Key_F10); // Simulate
        QVERIFY(w().workspaces().current() == ui::Workspace::simulate);
        QTest::keyClick(&w(), Qt::Key_Space);
        QTest::qWait(150);
        QTest::keyClick(&w(), Qt::Key_Space);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("mould-simulated"));

        QTest::keyClick(&w(), Qt::Key_E, Qt::ControlModifier);
        const QStringList files = export_programs();
        QVERIFY2(files.contains(QStringLiteral("report.json")), qPrintable(files.join(QChar(' '))));
        const QStringList programs = files.filter(QStringLiteral(".ngc"));
        QCOMPARE(programs.size(), 2);
        for (const QString& name : programs)
            QVERIFY2(text_of(name).contains(QStringLiteral("G20")), qPrintable(text_of(name).left(200)));
        QVERIFY(w().files().save_to(folder_ + QStringLiteral("/mould.facetmill")));
    }
};

FACETMILL_TEST(TestWindowFirstJob)
#include "test_window_first_job.moc"
