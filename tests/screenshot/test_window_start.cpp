// How a stranger begins: the page of an empty window, preferences, templates of jobs.
#include "core/base/parallel.h"
#include "core/job/project.h"
#include "tests/screenshot/window_support.h"
#include "ui/controllers.h"
#include "ui/measure_controller.h"
#include "ui/message_bar.h"
#include "ui/own_folders.h"
#include "ui/preferences_dialog.h"
#include "ui/project_tree.h"
#include "ui/recent_pictures.h"
#include "ui/settings.h"
#include "ui/settings_file.h"
#include "ui/templates.h"
#include "ui/text.h"
#include "ui/tool_library_dialog.h"
#include "ui/view_menu.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

class TestWindowStart : public QObject, public WindowFixture {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> data_; ///< the user's own folder
    QByteArray data_before_;

    QListWidget* list(const char* name) { return w().findChild<QListWidget*>(QString::fromLatin1(name)); }
    QWidget* start_page() { return w().findChild<QWidget*>(QStringLiteral("start_hint")); }
    static void choose(QComboBox* box, const QString& value) {
        box->setCurrentIndex(box->findData(value));
        emit box->activated(box->currentIndex());
    }

private slots:
    void init() {
        ui::SettingsFile::own().clear();
        data_ = std::make_unique<QTemporaryDir>();
        data_before_ = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", data_->path().toUtf8());
        QVERIFY(show_window());
    }
    void cleanup() {
        close_window();
        data_before_.isEmpty() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", data_before_);
    }
    void cleanupTestCase() { ui::SettingsFile::own().clear(); }

    void a_sample_is_begun_from_its_picture() {
        QVERIFY(start_page()->isVisible());
        QListWidget* samples = list("sample_list");
        QVERIFY(samples->isVisible() && samples->count() > 8);
        for (int i = 0; i < samples->count(); ++i)
            QVERIFY2(!samples->item(i)->icon().isNull() && !samples->item(i)->toolTip().isEmpty(),
                     qPrintable(samples->item(i)->text()));
        QVERIFY(!list("recent_list")->isVisible()); // nothing is recent yet
        samples->setCurrentRow(1);
        QTest::keyClick(samples, Qt::Key_Return);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().has_part() && !start_page()->isVisible());
        QCOMPARE(w().document().name(), QStringLiteral("convex"));
    }

    void recent_files_have_pictures() {
        const QString path = write_mesh(scratch_folder(QStringLiteral("recent")));
        w().open_file(path, LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        QTRY_VERIFY_WITH_TIMEOUT(!ui::recent_picture(path).isNull(), patience_ms);
        QCOMPARE(ui::recent_picture(path).size(), QSize(ui::recent_picture_width, ui::recent_picture_height));
        ui::settings::add_recent_file(QDir::tempPath()
                                      + QStringLiteral("/gone away since then, a long name.stl"));
        action(w(), "new")->trigger();
        QVERIFY(start_page()->isVisible());
        QListWidget* recent = list("recent_list");
        QVERIFY(recent->isVisible());
        QCOMPARE(recent->count(), 2);
        QVERIFY(!(recent->item(0)->flags() & Qt::ItemIsEnabled)); // it is not there
        QCOMPARE(recent->item(1)->toolTip(), path);
        shot(w(), QStringLiteral("start-recent"));
        recent->setCurrentRow(1);
        QTest::keyClick(recent, Qt::Key_Return);
        QVERIFY(w().findChild<QDialog*>() || wait_until_settled(w())); // the unit is asked for
        w().resize(800, 600);
        shot(w(), QStringLiteral("start-small"));
    }

    void a_small_window_has_words_and_buttons() {
        w().resize(800, 600);
        QApplication::processEvents();
        QVERIFY(start_page()->isVisible() && !list("sample_list")->isVisible());
        QVERIFY(w().viewport().rect().contains(start_page()->geometry()));
        shot(w(), QStringLiteral("start-800x600"));
    }

    void new_projects_are_for_the_users_machine() {
        auto* machine = start_page()->findChild<QComboBox*>(QStringLiteral("usual_machine"));
        choose(machine, QStringLiteral("trunnion-ac"));
        choose(start_page()->findChild<QComboBox*>(QStringLiteral("usual_post")), QStringLiteral("haas"));
        choose(start_page()->findChild<QComboBox*>(QStringLiteral("usual_unit")), QStringLiteral("in"));
        // In inches, unasked.
        w().open_file(write_mesh(scratch_folder(QStringLiteral("usual"))));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().has_part());
        QVERIFY(w().document().unit() == LengthUnit::inch);
        QCOMPARE(w().document().project().machine, std::string("trunnion-ac"));
        QCOMPARE(w().document().project().programs.post, std::string("haas"));
        // A turned sample keeps the machine that turns it.
        action(w(), "sample_cylinder")->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().project().machine, std::string("lathe-mill"));
    }

    void preferences() {
        action(w(), "preferences")->trigger();
        auto* dialog = w().findChild<ui::PreferencesDialog*>();
        QVERIFY(dialog);
        auto* style = dialog->findChild<QComboBox*>(QStringLiteral("navigation_style"));
        for (int i = style->count() - 1; i >= 0; --i) {
            style->setCurrentIndex(i);
            QCOMPARE(ui::navigation_words(ui::NavigationStyle(i)).size(), 3);
        }
        style->setCurrentIndex(3);
        dialog->findChild<QComboBox*>(QStringLiteral("orbit"))->setCurrentIndex(1);
        dialog->findChild<QComboBox*>(QStringLiteral("colours"))->setCurrentIndex(2);
        dialog->findChild<QSpinBox*>(QStringLiteral("autosave"))->setValue(90);
        dialog->findChild<QSpinBox*>(QStringLiteral("threads"))->setValue(1);
        choose(dialog->findChild<QComboBox*>(QStringLiteral("usual_machine")), QStringLiteral("trunnion-bc"));
        shot(*dialog, QStringLiteral("dialog-preferences"));
        dialog->accept();
        QCOMPARE(ui::settings::navigation(),
                 (ui::Navigation{ui::NavigationStyle::blender, ui::Orbit::trackball}));
        QVERIFY(w().theme() == ui::Theme::dark);
        QCOMPARE(ui::settings::autosave_interval(), std::chrono::seconds(90));
        QCOMPARE(thread_count(), 1);
        // The page shows the same machine.
        QCOMPARE(
            start_page()->findChild<QComboBox*>(QStringLiteral("usual_machine"))->currentData().toString(),
            QStringLiteral("trunnion-bc"));
        shot(w(), QStringLiteral("start-dark"));
        action(w(), "preferences")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(w().findChild<ui::PreferencesDialog*>()
                                     && w().findChild<ui::PreferencesDialog*>() != dialog,
                                 patience_ms);
        dialog = w().findChild<ui::PreferencesDialog*>();
        QCOMPARE(dialog->findChild<QSpinBox*>(QStringLiteral("threads"))->value(), 1);
        dialog->findChild<QSpinBox*>(QStringLiteral("threads"))->setValue(0);
        shot(*dialog, QStringLiteral("dialog-preferences-dark"));
        dialog->reject();
        QCOMPARE(ui::settings::threads(), 1); // nothing was taken
        ui::SettingsFile::own().clear();
        ui::take_preferences(w());
        QVERIFY(thread_count() > 1 || QThread::idealThreadCount() == 1);
    }

    /// Where libraries and templates lie is the user's to say; a folder that cannot be is refused as typed.
    void a_folder_of_ones_own() {
        const QString own = scratch_folder(QStringLiteral("own")) + QStringLiteral("/cam");
        QCOMPARE(ui::own_folder(), ui::usual_own_folder());
        action(w(), "preferences")->trigger();
        QPointer<ui::PreferencesDialog> dialog = w().findChild<ui::PreferencesDialog*>();
        QVERIFY(dialog && activate(*dialog));
        auto* line = dialog->findChild<QLineEdit*>(QStringLiteral("own_folder"));
        auto* trouble = dialog->findChild<QLabel*>(QStringLiteral("folder_trouble"));
        auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        QCOMPARE(line->placeholderText(), ui::path_text(ui::usual_own_folder()));
        const QString file = write_mesh(scratch_folder(QStringLiteral("own-file")));
        for (const QString& wrong : {QStringLiteral("cam"), file}) {
            type_over(line, wrong);
            QVERIFY2(!ok->isEnabled() && trouble->isVisible() && !trouble->text().isEmpty(),
                     qPrintable(wrong));
        }
        shot(*dialog, QStringLiteral("dialog-preferences-folder"));
        type_over(line, own + QStringLiteral("/"));
        QVERIFY(ok->isEnabled() && !trouble->isVisible());
        QTest::mouseClick(ok, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!dialog || !dialog->isVisible(), patience_ms);
        QCOMPARE(ui::own_folder(), ui::path_of(own));

        // Both are kept there from now on, and found there.
        QVERIFY(open_part());
        w().templates().save(QStringLiteral("kept"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(QFile::exists(own + QStringLiteral("/templates/kept.fmtemplate")));
        w().tree().tool_library_action()->trigger();
        QPointer<ui::ToolLibraryDialog> library;
        QTRY_VERIFY_WITH_TIMEOUT((library = w().findChild<ui::ToolLibraryDialog*>()), patience_ms);
        QTest::mouseClick(library->findChild<QPushButton*>(QStringLiteral("keep")), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(own + QStringLiteral("/tools")).isEmpty(), patience_ms);
        library->close();
        ui::settings::set_own_folder({});
        emit w().templates().menu()->aboutToShow();
        QVERIFY(!w().templates().menu()->actions().front()->isEnabled()); // none is kept in the usual place
    }

    /// A right click offers what can be done with what lies there; everything in it can be undone.
    void what_was_clicked() {
        QVERIFY(open_part());
        auto& view = w().viewport();
        view.set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        const QPoint middle = view.mapToGlobal(view.rect().center()), corner = view.mapToGlobal(QPoint(3, 3));
        auto* views = w().findChild<QMenu*>(QStringLiteral("view_menu"));
        QVERIFY(views);
        ui::ViewMenu menus(w(), *views);
        const auto entry = [](QMenu* menu, const char* name) -> QAction* {
            for (QAction* a : menu->actions())
                if (a->text() == QLatin1String(name)) return a;
            return nullptr;
        };
        QPointer<QMenu> menu = menus.make(corner);
        QVERIFY(!entry(menu, "Lay on this face") && !entry(menu, "Hide part"));
        menu = menus.make(middle);
        QVERIFY(entry(menu, "Lay on this face") && entry(menu, "Hide part"));
        shot(*menu, QStringLiteral("menu-clicked"));
        const int steps = w().document().undo_stack().count();
        entry(menu, "Boundary of this face")->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().undo_stack().count(), steps + 1);
        QCOMPARE(w().document().project().boundaries.size(), std::size_t(1));
        QVERIFY(!w().document().project().boundaries[0].facets.empty());
        w().document().undo_stack().undo();
        QVERIFY(w().document().project().boundaries.empty());
        entry(menu, "Zero here")->trigger();
        QVERIFY(w().document().project().programs.zero_from == ProgramSpec::ZeroFrom::origin);
        const auto& zero = w().document().project().programs.zero;
        const Box3 box = w().document().part()->box;
        for (int k = 0; k < 3; ++k)
            QVERIFY(zero[std::size_t(k)] >= box.lo[k] - 1e-9 && zero[std::size_t(k)] <= box.hi[k] + 1e-9);
        QVERIFY(Vec3(zero.data()).norm() > 1); // not where it was
        entry(menu, "Lay on this face")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().undo_stack().count() > steps);
        entry(menu, "Hide part")->trigger();
        QVERIFY(!w().viewport().scene().visible(Layer::part));
        menu = menus.make(middle);
        QVERIFY(entry(menu, "Show part"));
        entry(menu, "Show part")->trigger();
        QVERIFY(w().viewport().scene().visible(Layer::part));
    }

    /// Two clicks: the distance of two corners of the part, against its vertices.
    void measuring() {
        QVERIFY(open_part());
        auto& view = w().viewport();
        auto& measure = w().controllers().measure();
        view.set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        QTest::keyClick(&w(), Qt::Key_M);
        QVERIFY(measure.active() && action(w(), "measure")->isChecked());
        const Mesh& mesh = *w().document().part()->mesh;
        const auto click = [&](const Vec3& at) {
            const Vec2 p = view.scene().camera().display_of(at);
            QTest::mouseClick(&view, Qt::LeftButton, {},
                              (QPointF(p.x(), p.y()) / view.devicePixelRatioF()).toPoint());
        };
        const Vec3 a = mesh.corner(5 * 48 + 10, 0), b = mesh.corner(18 * 48 + 30, 1); // within the grid
        click(a);
        QVERIFY(!measure.measured());
        click(b);
        const auto m = measure.measured();
        QVERIFY(m.has_value());
        QVERIFY((m->from - a).norm() < 1e-9 && (m->to - b).norm() < 1e-9);
        QVERIFY2(w().message_bar().message().startsWith(QStringLiteral("Distance ")
                                                        + ui::shown_length((a - b).norm(), LengthUnit::inch)),
                 qPrintable(w().message_bar().message()));
        shot(w(), QStringLiteral("start-measuring"));
        // The view still turns, and a third click begins anew.
        const Vec3 sight = view.sight();
        QTest::mousePress(&view, Qt::LeftButton, {}, view.rect().center());
        QMouseEvent event(QEvent::MouseMove, view.rect().center() - QPoint(0, 60),
                          view.mapToGlobal(view.rect().center() - QPoint(0, 60)), Qt::NoButton,
                          Qt::LeftButton, {});
        QApplication::sendEvent(&view, &event);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, view.rect().center() - QPoint(0, 60));
        QVERIFY((view.sight() - sight).norm() > 0.1 && measure.measured());
        click(a);
        QVERIFY(!measure.measured());
        QTest::keyClick(&w(), Qt::Key_Escape);
        QVERIFY(!measure.active() && !action(w(), "measure")->isChecked());
        // A right angle.
        const ui::Measurement right{Vec3(0, 0, 0), Vec3(3, 4, 12), 0.5 * pi};
        QCOMPARE(ui::measurement_text(right, LengthUnit::mm).replace(QChar(0xa0), QChar(' ')),
                 QStringLiteral("Distance 13 mm, X 3 mm, Y 4 mm, Z 12 mm; faces at 90°"));
    }

    /// Every panel is reached by a key, and takes keys then.
    void panels_by_key() {
        QVERIFY(open_part());
        QVERIFY(activate(w()));
        int number = 0;
        for (const char* name :
             {"project_dock", "properties_dock", "report_dock", "verification_dock", "cspace_dock",
              "unrolled_dock", "strips_dock", "place_dock", "log_dock", "chart_dock"}) {
            ++number;
            const auto* dock = w().findChild<QDockWidget*>(QString::fromLatin1(name));
            QTest::keyClick(&w(), Qt::Key(Qt::Key_0 + number % 10), Qt::AltModifier);
            QVERIFY2(dock->isVisible() && !dock->visibleRegion().isEmpty(), name);
            QVERIFY2(dock->isAncestorOf(QApplication::focusWidget()), name);
        }
    }

    /// Ctrl+Z in a field takes back what was typed there, then what was done in the project.
    void undo_from_a_field() {
        QVERIFY(open_part());
        QVERIFY(activate(w()));
        w().tree().select({TreeNode::Kind::operation, 0});
        for (const char* name : {"tolerance", "stepover"}) { // a line, a box with words
            QLineEdit* line = field(w(), name);
            const QString before = line->text();
            enter(w(), name, QStringLiteral("0.03"));
            QCOMPARE(w().document().undo_stack().index(), 1);
            line = field(w(), name);
            line->setFocus();
            QTest::keyClick(line, Qt::Key_End);
            QTest::keyClick(line, Qt::Key_7);
            QCOMPARE(line->text(), QStringLiteral("0.037"));
            QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
            QCOMPARE(line->text(), QStringLiteral("0.03"));
            QCOMPARE(w().document().undo_stack().index(), 1);
            QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
            QVERIFY2(w().document().undo_stack().index() == 0, name);
            QCOMPARE(field(w(), name)->text(), before);
            QTest::keyClick(field(w(), name), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
            QCOMPARE(w().document().undo_stack().index(), 1);
            w().document().undo_stack().undo();
        }
    }

    /// Messages lie over the view, whose picture stays where it is.
    void messages_push_nothing() {
        QVERIFY(open_part());
        const QRect before = w().viewport().geometry();
        w().message_bar().show_message(
            ui::MessageBar::Kind::warning,
            QString(QStringLiteral("A long story that needs several lines. ")).repeated(8));
        QApplication::processEvents();
        QCOMPARE(w().viewport().geometry(), before);
        QVERIFY(w().viewport().rect().contains(w().message_bar().geometry()));
        shot(w(), QStringLiteral("start-message"));
        // A click on it is not one on the part below.
        QSignalSpy picked(&w().viewport(), &ui::Viewport::part_picked),
            missed(&w().viewport(), &ui::Viewport::nothing_picked);
        QTest::mouseClick(w().message_bar().findChild<QLabel*>(), Qt::LeftButton);
        QTest::mouseClick(&w().message_bar(), Qt::LeftButton, {}, QPoint(3, 3));
        QCOMPARE(picked.count() + missed.count(), 0);
        w().resize(700, 600);
        QApplication::processEvents();
        QCOMPARE(w().message_bar().width(), w().viewport().width());
        QVERIFY(w().message_bar().height() >= w().message_bar().heightForWidth(w().message_bar().width()));
    }

    /// Two operations of one project kept, and taken by another part with another unit.
    void a_template() {
        ui::Templates& templates = w().templates();
        QVERIFY(open_part());
        w().document().add_operation("rough");
        const std::size_t kept = w().document().operation_count();
        emit templates.menu()->aboutToShow();
        QVERIFY(!templates.menu()->actions().front()->isEnabled()); // none is kept yet
        templates.save(QStringLiteral("relief in wood"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("2 operations")),
                 qPrintable(w().message_bar().message()));
        QVERIFY_THROWS_EXCEPTION(Error, templates.save(QStringLiteral("../elsewhere")));

        bool asked = false;
        answer_next(QMessageBox::Discard, asked);
        w().open_file(write_mesh(scratch_folder(QStringLiteral("other-part"))), LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        emit templates.menu()->aboutToShow();
        QAction* entry = templates.menu()->actions().front();
        QCOMPARE(entry->text(), QStringLiteral("relief in wood"));
        QVERIFY(entry->isEnabled() && entry->toolTip().contains(QStringLiteral("2 operations")));
        entry->trigger();
        QCOMPARE(w().document().operation_count(), kept);
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("applied")),
                 qPrintable(w().message_bar().message()));
        shot(w(), QStringLiteral("start-template"));
        w().document().undo_stack().undo();
        QCOMPARE(w().document().operation_count(), std::size_t(1));
        // A damaged one cannot be chosen, and says why.
        QFile bad(ui::path_text(ui::own_template_folder() / "a bad one.fmtemplate"));
        QVERIFY(bad.open(QIODevice::WriteOnly));
        bad.write("{\"facetmill\": 1");
        bad.close();
        emit templates.menu()->aboutToShow();
        QVERIFY(!templates.menu()->actions().front()->isEnabled()
                && templates.menu()->actions().front()->toolTip().contains(QStringLiteral("a bad one")));
        templates.apply(ui::path_of(bad.fileName()));
        QVERIFY(w().last_failure().contains(QStringLiteral("cannot be applied")));
    }
};
FACETMILL_TEST(TestWindowStart)

#include "test_window_start.moc"
