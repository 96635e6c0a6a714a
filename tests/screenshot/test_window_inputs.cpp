// The files that a project names: missing ones are told and located, the part is replaced, and what has
// changed on disk is told in the same words.
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "tests/screenshot/window_support.h"
#include "ui/project_tree.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

using namespace facetmill;
using namespace facetmill::test;
using ui::OperationState;
using ui::TreeNode;

class TestWindowInputs : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    /// All of the project is there but what was moved; one file is shown, the others are found beside it.
    void missing_files_are_located() {
        const QString root = scratch_folder(QStringLiteral("moved")), saved = make_project(root);
        QVERIFY(!saved.isEmpty() && move_files(root));
        const QByteArray text_before = bytes_of(saved);
        open(saved);
        QVERIFY2(says("surface.stl") && says("It was looked for in " + root + "/job. "), qPrintable(said()));
        QVERIFY2(says("stock's file “raw.stl”") && says("machine's file “own.json”"), qPrintable(said()));
        QVERIFY(button().isVisible());
        QCOMPARE(w().message_bar().findChild<QWidget*>(QStringLiteral("message_text"))->isVisible(), true);
        QVERIFY(w().last_failure().contains(QStringLiteral("surface.stl")));
        QCOMPARE(w().document().operation_count(), std::size_t(1));
        QCOMPARE(first_operation(w()).tolerance, 0.02 * 25.4);
        QVERIFY(!w().document().part() && !w().document().modified());
        shot(w(), QStringLiteral("inputs-missing"));
        w().resize(800, 600);
        shot(w(), QStringLiteral("inputs-missing-small"));
        w().resize(1280, 800);
        QVERIFY(w().files().save()); // keeps what was there
        QCOMPARE(bytes_of(saved), text_before);
        w().plan(); // says it again, with the button
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(says("surface.stl") && button().isVisible(), qPrintable(said()));
        QVERIFY(w().document().state(0) != OperationState::planned);

        bool asked = false;
        answer_file_dialog(asked); // Cancel
        QTest::mouseClick(&button(), Qt::LeftButton);
        QVERIFY(asked && !w().document().modified() && button().isVisible());

        asked = false;
        answer_file_dialog(asked, root + QStringLiteral("/elsewhere/surface.stl"));
        QTest::mouseClick(&button(), Qt::LeftButton);
        QVERIFY(asked && wait_until_settled(w()));
        const Project& project = w().document().project();
        QCOMPARE(project.part.file, std::string("../elsewhere/surface.stl"));
        QCOMPARE(project.stock.file, std::string("../elsewhere/raw.stl"));
        QCOMPARE(project.machine, std::string("../elsewhere/own.json"));
        QVERIFY(w().document().part_is_current() && w().document().has_stock());
        QVERIFY2(says("Found the part's file “surface.stl” in " + root + "/elsewhere.")
                     && says("Found there too: the stock's file “raw.stl”, the machine's file “own.json”"),
                 qPrintable(said()));
        QVERIFY(!button().isVisible() && w().last_failure().isEmpty());
        shot(w(), QStringLiteral("inputs-located"));
        QVERIFY(plan());

        // One step.
        QCOMPARE(w().document().undo_stack().index(), 1);
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(project.part.file, std::string("surface.stl"));
        QCOMPARE(project.machine, std::string("own.json"));
        QVERIFY2(says("surface.stl") && button().isVisible(), qPrintable(said()));
        QVERIFY(w().viewport().scene().has(Layer::part)); // what was read stays in sight
        w().document().undo_stack().redo();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().part_is_current());
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(said().isEmpty());
        QVERIFY(w().files().save());
        open(saved);
        QVERIFY(w().document().part_is_current() && w().last_failure().isEmpty());
    }

    /// Without its part a project can be looked at, edited, undone and saved elsewhere.
    void a_project_without_its_part() {
        const QString root = scratch_folder(QStringLiteral("without")), saved = make_project(root);
        QVERIFY(!saved.isEmpty() && move_files(root) && open(saved));
        QVERIFY(!w().document().part());
        w().document().add_operation("finish5");
        w().document().add_operation("global_local");
        for (const auto kind : {TreeNode::Kind::part, TreeNode::Kind::stock, TreeNode::Kind::tool})
            w().tree().select({kind, 0});
        for (std::size_t i = 0; i < w().document().operation_count(); ++i)
            w().tree().select({TreeNode::Kind::operation, i});
        w().show_place();
        ui::set_unit(w(), LengthUnit::mm);
        w().document().change(QStringLiteral("Turn"), [](Project& p) { p.part.rotate = {0, 0, 1}; });
        QVERIFY(wait_until_settled(w()));
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(says("surface.stl") && button().isVisible(), qPrintable(said()));
        w().document().undo_stack().setIndex(0);
        w().document().undo_stack().redo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().operation_count(), std::size_t(2));
        QVERIFY(QDir().mkpath(root + QStringLiteral("/copy")));
        QVERIFY(w().files().save_to(root + QStringLiteral("/copy/p.facetmill")));
        QCOMPARE(w().document().project().part.file, std::string("../job/surface.stl"));
        QCOMPARE(w().document().project().stock.file, std::string("../job/raw.stl"));
        QCOMPARE(w().document().project().machine, std::string("../job/own.json"));
        // Put back, it is there, all of it.
        for (const char* name : {"surface.stl", "raw.stl", "own.json"})
            QVERIFY(QFile::rename(root + QStringLiteral("/elsewhere/") + QLatin1String(name),
                                  root + QStringLiteral("/job/") + QLatin1String(name)));
        QTRY_VERIFY_WITH_TIMEOUT(w().document().part_is_current() && w().document().has_stock(), patience_ms);
        QVERIFY(wait_until_settled(w()));
        QTRY_VERIFY2_WITH_TIMEOUT(said().isEmpty(), qPrintable(said()), patience_ms);
    }

    /// One file after the other, where they lie apart; and what cannot be read is not taken.
    void they_are_located_one_by_one() {
        const QString root = scratch_folder(QStringLiteral("apart")), saved = make_project(root);
        QVERIFY(!saved.isEmpty());
        w().document().change(QStringLiteral("Own post"),
                              [](Project& p) { p.programs.post = "own-post.json"; });
        QVERIFY(w().files().save());
        for (const char* name : {"/stock", "/others"})
            QVERIFY(QDir().mkpath(root + QLatin1String(name)));
        QVERIFY(
            QFile::rename(root + QStringLiteral("/job/raw.stl"), root + QStringLiteral("/stock/block.stl")));
        QVERIFY(
            QFile::rename(root + QStringLiteral("/job/own.json"), root + QStringLiteral("/others/own.json")));
        open(saved);
        QVERIFY(w().document().part_is_current()); // the part itself is there
        QVERIFY2(says("The stock's file “raw.stl” is missing") && says("own.json") && says("own-post.json"),
                 qPrintable(said()));
        QVERIFY(w().last_failure().isEmpty());
        QVERIFY(!w().document().has_stock());

        QVERIFY(locate(write_bad(root + QStringLiteral("/others/bad.stl"))));
        QCOMPARE(w().document().project().stock.file, std::string("raw.stl"));
        QVERIFY2(says("bad.stl") && button().isVisible(), qPrintable(said()));
        QVERIFY(locate(root + QStringLiteral("/stock/block.stl")));
        QCOMPARE(w().document().project().stock.file, std::string("../stock/block.stl"));
        QVERIFY(w().document().has_stock());
        QVERIFY2(says("Found the stock's file “block.stl”") && says("machine's file “own.json” is missing"),
                 qPrintable(said()));
        QVERIFY(locate(write_bad(root + QStringLiteral("/others/bad.json"))));
        QCOMPARE(w().document().project().machine, std::string("own.json"));
        QVERIFY2(says("bad.json") && button().isVisible(), qPrintable(said()));
        QVERIFY(locate(root + QStringLiteral("/others/own.json")));
        QCOMPARE(w().document().project().machine, std::string("../others/own.json"));
        QVERIFY2(says("post's file “own-post.json” is missing") && !says("Missing too"), qPrintable(said()));
        QVERIFY(QFile::copy(QString::fromStdString(data_path("../resources/posts/grbl.json")),
                            root + QStringLiteral("/others/grbl-2.json")));
        QVERIFY(locate(root + QStringLiteral("/others/grbl-2.json")));
        QCOMPARE(w().document().project().programs.post, std::string("../others/grbl-2.json"));
        QVERIFY(!button().isVisible() && !action(w(), "locate")->isEnabled());
        QCOMPARE(w().document().undo_stack().index(), 3);
    }

    /// While the window is open; the file comes back by itself, before or after it was ever read.
    void files_that_go_and_come_back() {
        const QString root = scratch_folder(QStringLiteral("gone")), saved = make_project(root);
        QVERIFY(!saved.isEmpty() && plan());
        const QString part = root + QStringLiteral("/job/surface.stl"), away = part + QStringLiteral(".away");
        QVERIFY(QFile::rename(part, away));
        QTRY_VERIFY2_WITH_TIMEOUT(says("surface.stl") && button().isVisible(), qPrintable(said()),
                                  patience_ms);
        QVERIFY(w().viewport().scene().has(Layer::part) && action(w(), "locate")->isEnabled());
        QVERIFY(QFile::rename(away, part));
        QTRY_COMPARE_WITH_TIMEOUT(w().document().state(0), OperationState::planned, patience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(said().isEmpty() && !button().isVisible(), patience_ms);
        QVERIFY(QFile::rename(part, away));
        open(saved);
        QVERIFY2(says("surface.stl") && !w().document().part(), qPrintable(said()));
        QVERIFY(QFile::rename(away, part));
        QTRY_VERIFY_WITH_TIMEOUT(w().document().part_is_current(), patience_ms);
        QVERIFY(wait_until_settled(w()) && said().isEmpty());
    }

    /// File > Replace part…
    void the_part_is_replaced() {
        const QString root = scratch_folder(QStringLiteral("replaced")), saved = make_project(root);
        QVERIFY(!saved.isEmpty() && plan());
        QTest::keyClick(&w(), Qt::Key_F6);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().verification().model().current());
        const std::size_t facets = w().document().part()->report.facets;
        QVERIFY(QDir().mkpath(root + QStringLiteral("/new")));
        const QString other = root + QStringLiteral("/new/finer.stl");
        save_stl(*make_sample("convex", 0.1, {}), other.toStdString(), LengthUnit::inch, {});

        bool asked = false;
        answer_file_dialog(asked); // Cancel
        action(w(), "replace_part")->trigger();
        QVERIFY(asked && wait_until_settled(w()) && !w().document().modified());
        asked = false;
        answer_file_dialog(asked, write_bad(root + QStringLiteral("/new/bad.stl"))); // nothing changes
        action(w(), "replace_part")->trigger();
        QVERIFY(asked && wait_until_settled(w()) && !w().document().modified());
        QVERIFY2(says("bad.stl") && !button().isVisible(), qPrintable(said()));
        asked = false;
        answer_file_dialog(asked, other);
        action(w(), "replace_part")->trigger();
        QVERIFY(asked && wait_until_settled(w()));
        const Project& project = w().document().project();
        QCOMPARE(project.part.file, std::string("../new/finer.stl"));
        QVERIFY(w().document().part_is_current());
        const std::size_t now = w().document().part()->report.facets;
        QVERIFY(now > facets);
        QVERIFY2(says(QStringLiteral("“finer.stl” in place of “surface.stl”: %1 facets (%2 facets before)")
                          .arg(ui::count_text(now), ui::count_text(facets)))
                     && says("Out of date: the plan of “Finish”, the verification."),
                 qPrintable(said()));
        QCOMPARE(w().document().state(0), OperationState::stale);
        shot(w(), QStringLiteral("inputs-replaced"));
        QCOMPARE(w().document().undo_stack().index(), 1);
        QVERIFY(w().viewport().scene().former().any()); // until the message is dismissed
        QTest::mouseClick(w().message_bar().findChild<QToolButton*>(), Qt::LeftButton);
        QVERIFY(!w().viewport().scene().former().any() && said().isEmpty());

        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().viewport().scene().former().any()); // or something else is done
        QCOMPARE(project.part.file, std::string("surface.stl"));
        QCOMPARE(w().document().part()->report.facets, facets);
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(w().verification().model().current());
        QVERIFY2(says("“surface.stl” in place of “finer.stl”") && !says("Out of date"), qPrintable(said()));
        w().document().undo_stack().redo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().part()->report.facets, now);
        const QImage both = view_picture(w());
        w().document().change(QStringLiteral("Other"), [](Project& p) { p.tools[0].name = "Other"; });
        QVERIFY(wait_until_settled(w()) && !w().viewport().scene().former().any());
        QVERIFY(changed_pixels(both, view_picture(w())) > 100);

        // Saved elsewhere, steps from before name the same files from there.
        QVERIFY(QDir().mkpath(root + QStringLiteral("/a/b")));
        QVERIFY(w().files().save_to(root + QStringLiteral("/a/b/p.facetmill")));
        QCOMPARE(project.part.file, std::string("../../new/finer.stl"));
        w().document().undo_stack().setIndex(0);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(project.part.file, std::string("../../job/surface.stl"));
        QCOMPARE(w().document().state(0), OperationState::planned);
    }

    /// A scan in metres for one in inches; and what was picked on the old part is named.
    void a_replaced_part_of_another_size() {
        QVERIFY(plan_five_axes());
        w().document().change(QStringLiteral("Keep"), [](Project& p) {
            p.operations[0]->set(
                "manual_postures",
                p.operations[0]
                    ->parameter("manual_postures")
                    .parse(R"([{"point": [1, 1, 0], "lead": 5, "yaw": 0}])", LengthUnit::inch));
            p.programs.zero = {1, 2, 3};
        });
        QVERIFY(wait_until_settled(w()));
        const QString other = scratch_folder(QStringLiteral("metres")) + QStringLiteral("/metres.stl");
        save_stl(*make_sample("convex", 0.5, {}), other.toStdString(), LengthUnit::m, {});
        bool asked = false;
        answer_file_dialog(asked, other);
        action(w(), "replace_part")->trigger();
        QVERIFY(asked && wait_until_settled(w()));
        QVERIFY2(says("Its size suggests metres (millimetres before); it is read in inches."),
                 qPrintable(said()));
        QVERIFY2(says("Still at places of the part before: 1 kept posture of “") && says("the work zero"),
                 qPrintable(said()));
    }

    void a_part_that_changes_on_disk() {
        const QString root = scratch_folder(QStringLiteral("changes")), saved = make_project(root);
        QVERIFY(!saved.isEmpty() && plan());
        const std::size_t facets = w().document().part()->report.facets;
        save_stl(*make_sample("convex", 0.1, {}), (root + QStringLiteral("/job/surface.stl")).toStdString(),
                 LengthUnit::inch, {});
        QTRY_VERIFY_WITH_TIMEOUT(w().document().part()->report.facets != facets, patience_ms);
        QVERIFY(wait_until_settled(w()));
        const auto figures = [&] {
            return QStringLiteral("%1 facets (%2 facets before)")
                .arg(ui::count_text(w().document().part()->report.facets), ui::count_text(facets));
        };
        QVERIFY2(says("“surface.stl” has changed on disk: " + figures())
                     && says("Out of date: the plan of “Finish”."),
                 qPrintable(said()));
        shot(w(), QStringLiteral("inputs-changed"));
        // Read by the plan, before the window does: the plan is not out of date then.
        QVERIFY(plan());
        w().message_bar().dismiss();
        write_mesh(root + QStringLiteral("/job"));
        QVERIFY(plan());
        QVERIFY2(says("“surface.stl” has changed on disk") && !says("Out of date"), qPrintable(said()));
        // A change of its place is none of its file.
        w().message_bar().dismiss();
        w().document().change(QStringLiteral("Turn"), [](Project& p) { p.part.rotate = {0, 0, 1}; });
        QVERIFY(wait_until_settled(w()) && w().document().part_is_current());
        QVERIFY2(said().isEmpty(), qPrintable(said()));
    }

    /// A step from before the project took the sample along names the copy.
    /// What changes of the part that is shown does not cancel the opening of another one.
    void a_change_while_another_part_is_opened() {
        QVERIFY(open_part());
        const QString other = write_mesh(scratch_folder(QStringLiteral("other")));
        const auto turn = [&](double angle) {
            w().document().change(QStringLiteral("Turn"), [&](Project& p) { p.part.rotate = {0, 0, angle}; });
        };
        w().open_file(other, LengthUnit::inch);
        QVERIFY(w().job().running());
        turn(1);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(ui::path_text(w().document().project().part_path()), other);
        QVERIFY(w().document().part_is_current());
        // An opening that ends otherwise lets it be read.
        w().open_file(scratch_folder(QStringLiteral("none")) + QStringLiteral("/none.stl"), LengthUnit::inch);
        turn(2);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(ui::path_text(w().document().project().part_path()), other);
        QVERIFY(w().document().part_is_current());
    }

    void undo_behind_a_save() {
        action(w(), "sample_convex")->trigger();
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.02"));
        const QString folder = scratch_folder(QStringLiteral("behind"));
        QVERIFY(w().files().save_to(folder + QStringLiteral("/job.facetmill")));
        QCOMPARE(w().document().project().part.file, std::string("convex.stl"));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().project().part.file, std::string("convex.stl"));
        QVERIFY(w().document().part_is_current() && w().document().modified());
        QVERIFY2(said().isEmpty(), qPrintable(said()));
    }

private:
    /// A project with a mesh stock and a machine of its own, at a tolerance of 0.02 in, saved in root/job and
    /// open. Its path, or nothing where that failed.
    QString make_project(const QString& root) {
        const QString folder = root + QStringLiteral("/job"), saved = folder + QStringLiteral("/p.facetmill");
        if (!QDir().mkpath(folder)) return {};
        w().open_file(write_mesh(folder), LengthUnit::inch);
        if (!wait_until_settled(w()) || !w().document().part()) return {};
        write_block(folder + QStringLiteral("/raw.stl"), w().document().part()->box);
        QFile machine(folder + QStringLiteral("/own.json"));
        if (!machine.open(QIODevice::WriteOnly)) return {};
        machine.write(QByteArray::fromStdString(find_machine("generic-3-axis").source));
        machine.close();
        if (!w().files().save_to(saved)) return {};
        w().document().change(QStringLiteral("Own files"), [](Project& p) {
            p.machine = "own.json";
            p.stock.kind = StockSpec::Kind::mesh;
            p.stock.unit = LengthUnit::inch;
            p.stock.file = "raw.stl";
            p.operations[0]->common().tolerance = 0.02 * 25.4;
        });
        if (!wait_until_settled(w()) || !w().files().save()) return {};
        return open(saved) ? saved : QString();
    }

    /// From root/job to root/elsewhere.
    static bool move_files(const QString& root) {
        bool good = QDir().mkpath(root + QStringLiteral("/elsewhere"));
        for (const char* name : {"surface.stl", "raw.stl", "own.json"})
            good &= QFile::rename(root + QStringLiteral("/job/") + QLatin1String(name),
                                  root + QStringLiteral("/elsewhere/") + QLatin1String(name));
        return good;
    }

    /// Neither a mesh nor a machine.
    static QString write_bad(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::WriteOnly) && file.write("hello") == 5 ? path : QString();
    }

    bool open(const QString& saved) {
        w().open_file(saved);
        return wait_until_settled(w());
    }

    bool plan() {
        w().plan();
        return wait_until_settled(w()) && w().document().state(0) == OperationState::planned;
    }

    bool locate(const QString& file) {
        bool asked = false;
        answer_file_dialog(asked, file);
        QTest::mouseClick(&button(), Qt::LeftButton);
        return asked && wait_until_settled(w());
    }

    static QByteArray bytes_of(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QPushButton& button() {
        return *w().message_bar().findChild<QPushButton*>(QStringLiteral("message_button"));
    }
    QString said() { return w().message_bar().message(); }
    bool says(const QString& words) { return said().contains(words); }
    bool says(const char* words) { return says(QString::fromUtf8(words)); }
};
FACETMILL_TEST(TestWindowInputs)

#include "test_window_inputs.moc"
