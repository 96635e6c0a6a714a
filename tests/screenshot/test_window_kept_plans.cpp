// What was planned and verified is there again when a project is opened, without planning; what does not fit,
// or is damaged, is not.
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/part_meshes.h"
#include "ui/all_setups.h"
#include "ui/cspace_controller.h"
#include "ui/deviation_view.h"
#include "ui/log_view.h"
#include "ui/plan_runner.h"
#include "ui/project_tree.h"
#include "ui/report_view.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/verification_panel.h"
#include "ui/viewport.h"
#include "ui/workspaces.h"
#include "viz/scene.h"

#include <QDir>
#include <QFile>
#include <QMap>
#include <QPushButton>
#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;
using ui::OperationState;

namespace {

constexpr const char* two_sides = R"({ "facetmill": 2, "units": "mm", "part": { "file": "block.stl" },
  "tools": [ { "number": 1, "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_length": 30 } ],
  "setups": [
    { "name": "Top", "stock": { "kind": "box", "margin": [0, 0, 1] },
      "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.2, "clearance": 3 } ] },
    { "name": "Bottom", "place": { "rotate": [180, 0, 0], "translate": [0, 30, 24] },
      "operations": [ { "kind": "finish3", "name": "Below", "tool": 1, "tolerance": 0.2, "clearance": 3 } ] } ] })";

QByteArray file_content(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList kept_names(const QString& folder) {
    return QDir(folder).entryList(QDir::Files, QDir::Name);
}

QMap<QString, QByteArray> folder_contents(const QString& folder) {
    QMap<QString, QByteArray> all;
    const QStringList names = kept_names(folder);
    for (const QString& name : names)
        all[name] = file_content(folder + QChar('/') + name);
    return all;
}

} // namespace

class TestWindowKeptPlans : public QObject, private WindowFixture {
    Q_OBJECT

    QString folder_;

    QString job() const { return folder_ + QStringLiteral("/job.facetmill"); }
    QString kept() const { return folder_ + QStringLiteral("/job.facetmill-cache"); }
    QStringList kept_files() const {
        return QDir(kept()).entryList({QStringLiteral("*.kept")}, QDir::Files, QDir::Name);
    }
    QString log() { return w().findChild<ui::LogView*>()->toPlainText(); }
    QMap<QString, QByteArray> exported(const QString& name) {
        const QString folder = folder_ + QChar('/') + name;
        QDir().mkpath(folder);
        w().exports().save_programs(folder);
        if (!wait_until_settled(w()) || !w().last_failure().isEmpty()) return {};
        return folder_contents(folder);
    }
    bool reopen() {
        close_window();
        if (!show_window()) return false;
        w().open_file(job());
        return wait_until_settled(w()) && w().document().has_part();
    }
    /// Planned, verified and saved.
    bool save_verified(const QString& name) {
        folder_ = scratch_folder(name);
        if (!open_and_plan() || !w().files().save_to(job())) return false;
        w().verify();
        return wait_until_settled(w()) && w().verification().model().current();
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void reopened_means_as_it_was() {
        QVERIFY(save_verified(QStringLiteral("kept")));
        QCOMPARE(kept_files().size(), 2);
        QVERIFY(kept_names(kept()).contains(QStringLiteral("CACHEDIR.TAG")));
        QVERIFY2(log().contains(QStringLiteral("Kept with the project")), qPrintable(log()));
        const auto before = exported(QStringLiteral("before"));
        QVERIFY(!before.isEmpty());
        const Verification was = w().verification().model().verification();
        const auto planned = w().document().result(0);
        QVERIFY(reopen());
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(!w().document().modified());
        const auto result = w().document().result(0);
        QVERIFY(result != planned);
        QCOMPARE(result->totals.time_seconds, planned->totals.time_seconds);
        QCOMPARE(result->path.cusp_max, planned->path.cusp_max);
        QVERIFY(result->warnings() == planned->warnings());
        const ui::VerificationModel& model = w().verification().model();
        QVERIFY(model.current());
        QCOMPARE(model.verdict(), ui::Verdict::verified);
        QCOMPARE(model.verification().figures.gouge_max, was.figures.gouge_max);
        QCOMPARE(model.verification().figures.excess_p99, was.figures.excess_p99);
        QVERIFY(w().verification().doubt().isEmpty());
        QVERIFY(w().viewport().scene().has(Layer::deviation));
        QCOMPARE(w().workspaces().current(), ui::Workspace::verify);
        QVERIFY(w().verification().playback().loaded());
        shot(w(), QStringLiteral("reopened-verified"));
        // The same bytes, and no planner was asked.
        QCOMPARE(exported(QStringLiteral("after")), before);
        QCOMPARE(w().document().result(0), result);
        // Planned again, it is the one that was kept, not one that was made anew.
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().result(0), result);
    }

    void five_axes_have_their_configuration_spaces() {
        folder_ = scratch_folder(QStringLiteral("kept_five"));
        QVERIFY(plan_five_axes());
        QVERIFY(w().files().save_to(job()));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(reopen());
        QCOMPARE(w().document().state(0), OperationState::planned);
        const auto record = w().document().result(0)->path.five_axis();
        QVERIFY(record && !record->points.empty());
        QCOMPARE(w().workspaces().current(), ui::Workspace::plan);
        QVERIFY(w().cspace().point().has_value());
        w().cspace().step(5, 0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().cspace().shown());
        const std::size_t point = w().cspace().shown()->index;
        QCOMPARE(point, *w().cspace().point());
        QVERIFY(w().cspace().shown()->place.surface == record->points[point].place.surface);
        QVERIFY(!w().cspace().shown()->space.bottom.empty());
        shot(w(), QStringLiteral("reopened-cspace"));
    }

    void what_does_not_fit_is_not_used() {
        QVERIFY(save_verified(QStringLiteral("kept_changed")));
        close_window();
        // Another parameter, written by somebody who planned nothing.
        Project project = load_project(job().toStdString());
        project.operations[0]->common().tolerance = 0.6;
        save_project(project, job().toStdString());
        QVERIFY(show_window());
        w().open_file(job());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::not_planned);
        QVERIFY(!w().verification().model().any());

        // The mesh is another one under the same name.
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY2(kept_files().size() == 1, "what is of no use to the saved project goes");
        close_window();
        const QString mesh = QString::fromStdString(load_project(job().toStdString()).part_path().string());
        QByteArray bytes = file_content(mesh);
        const auto stamp = std::filesystem::last_write_time(mesh.toStdString());
        bytes[200] = char(bytes[200] ^ 1); // the last bits of a coordinate
        QFile file(mesh);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        std::filesystem::last_write_time(mesh.toStdString(), stamp); // by its time nobody would know
        QVERIFY(show_window());
        w().open_file(job());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::not_planned);
    }

    /// What was planned and judged of values that the project had before is shown as that again.
    void out_of_date_is_out_of_date_again() {
        QVERIFY(save_verified(QStringLiteral("kept_stale")));
        const auto planned = w().document().result(0);
        w().tree().select({ui::TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.6"));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::stale);
        QCOMPARE(w().verification().model().verdict(), ui::Verdict::stale);
        const QString report = w().report().toPlainText();
        const QString figures = w().verification().panel()->figures_text();
        QVERIFY(w().files().save_to(job()));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(kept_files().size(), 4); // both, and which they are
        for (int i = 0; i < 2; ++i) {     // what was taken up is kept on
            QVERIFY(reopen());
            QVERIFY(!w().document().modified());
            QCOMPARE(w().document().state(0), OperationState::stale);
            QCOMPARE(w().document().result(0)->totals.time_seconds, planned->totals.time_seconds);
            QVERIFY(!w().document().complete_plan() && !w().verification().playback().loaded());
            const ui::VerificationModel& model = w().verification().model();
            QVERIFY(model.any() && !model.current());
            QCOMPARE(model.verdict(), ui::Verdict::stale);
            QCOMPARE(model.verdict(0), ui::Verdict::stale);
            QCOMPARE(model.program_name(0), QStringLiteral("Finish"));
            QVERIFY(w().viewport().scene().has(Layer::deviation) && w().viewport().scene().has(Layer::cl));
            QVERIFY(w().verification().doubt().contains(QStringLiteral("since the project was changed")));
            w().tree().select({ui::TreeNode::Kind::operation, 0});
            QCOMPARE(w().report().toPlainText(), report);
            QCOMPARE(w().verification().panel()->figures_text(), figures);
            QCOMPARE(kept_files().size(), 4);
        }
        shot(w(), QStringLiteral("reopened-stale"));
        // Planned as it is set, nothing of it is wanted any more.
        w().plan();
        QVERIFY(wait_until_settled(w()));
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().verification().model().verdict(), ui::Verdict::verified);
        QVERIFY(w().files().save_to(job()));
        QVERIFY(reopen());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(w().verification().model().current());
        w().document().change(QStringLiteral("Limits"), [](Project& p) { p.limits.uncut_limit = 0.5; });
        QVERIFY(w().files().save_to(job()));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().verification().model().verdict() == ui::Verdict::stale);
        QVERIFY2(kept_files().size() <= 4, "what nothing leads to goes");
    }

    /// By content: what was kept goes along with a project that is moved, and with a packed copy.
    void moved_and_packed_it_goes_along() {
        QVERIFY(save_verified(QStringLiteral("kept_moved")));
        const auto programs = exported(QStringLiteral("before"));
        const QString packed = folder_ + QStringLiteral("/sent.facetmill");
        w().files().save_packed_to(packed);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(kept_names(folder_ + QStringLiteral("/sent.facetmill-cache")), kept_names(kept()));
        const auto is_as_it_was = [&](const QString& project) {
            close_window();
            if (!show_window()) return false;
            w().open_file(project);
            return wait_until_settled(w()) && w().document().has_part()
                   && w().document().state(0) == OperationState::planned
                   && w().verification().model().current()
                   && w().verification().model().verdict() == ui::Verdict::verified;
        };
        // The part lies elsewhere than the project, where it stays.
        QVERIFY(QDir().mkpath(folder_ + QStringLiteral("/other/place")));
        Project project = load_project(job().toStdString());
        const QString moved = folder_ + QStringLiteral("/other/place/job.facetmill");
        move_project(project, moved.toStdString());
        save_project(project, moved.toStdString());
        QVERIFY(QDir().rename(kept(), folder_ + QStringLiteral("/other/place/job.facetmill-cache")));
        QVERIFY(is_as_it_was(moved));

        w().open_file(packed);
        QVERIFY(wait_until_settled(w()));
        auto* unpack = w().findChild<QPushButton*>(QStringLiteral("unpack"));
        QVERIFY(unpack && unpack->isEnabled());
        unpack->click();
        QVERIFY(wait_until_settled(w()));
        const QString unpacked = folder_ + QStringLiteral("/sent/job.facetmill");
        QCOMPARE(ui::path_text(w().document().project().path), unpacked);
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(w().verification().model().current());
        const QString program = QStringLiteral("01-Finish.apt"); // beside it the report names other files
        QCOMPARE(exported(QStringLiteral("after"))[program], programs[program]);
        // A packed file alone is planned again.
        QVERIFY(QDir(folder_ + QStringLiteral("/sent")).removeRecursively());
        QVERIFY(QDir(folder_ + QStringLiteral("/sent.facetmill-cache")).removeRecursively());
        close_window();
        QVERIFY(show_window());
        w().open_file(packed);
        QVERIFY(wait_until_settled(w()));
        w().findChild<QPushButton*>(QStringLiteral("unpack"))->click();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::not_planned);
    }

    void damaged_it_is_not_used() {
        QVERIFY(save_verified(QStringLiteral("kept_damaged")));
        const auto programs = exported(QStringLiteral("before"));
        const auto good = folder_contents(kept());
        std::mt19937 random(5);
        for (int i = 0; i < 6; ++i) {
            for (auto it = good.begin(); it != good.end(); ++it) {
                QByteArray torn = it.value();
                if (i == 0)
                    torn.truncate(torn.size() / 2);
                else
                    torn[qsizetype(random() % std::size_t(torn.size()))] ^= char(1 << (random() % 8));
                QFile file(kept() + QChar('/') + it.key());
                QVERIFY(file.open(QIODevice::WriteOnly) && file.write(torn) == torn.size());
            }
            QVERIFY(reopen());
            QCOMPARE(w().document().state(0), OperationState::not_planned);
            QVERIFY(!w().verification().model().any());
            QVERIFY2(log().contains(QStringLiteral("damaged")), qPrintable(log()));
            QVERIFY(w().message_bar().message().isEmpty());
        }
        // Planned again it is what it was.
        w().verify();
        QVERIFY(wait_until_settled(w()));
        auto after = exported(QStringLiteral("after"));
        after[QStringLiteral("report.json")] = programs[QStringLiteral("report.json")]; // it has other times
        QCOMPARE(after, programs);
    }

    void deleted_it_is_made_again() {
        QVERIFY(save_verified(QStringLiteral("kept_deleted")));
        close_window();
        QVERIFY(QDir(kept()).removeRecursively());
        QVERIFY(show_window());
        w().open_file(job());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::not_planned);
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(kept_files().size(), 1);
    }

    /// What one setup leaves for the next one is kept, too.
    void setups_go_on_with_what_was_left() {
        folder_ = scratch_folder(QStringLiteral("kept_setups"));
        save_stl(HollowedBlock::mesh(), (folder_ + "/block.stl").toStdString(), LengthUnit::mm, {});
        QFile file(job());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(two_sides);
        file.close();
        w().open_file(job());
        QVERIFY(wait_until_settled(w()));
        w().planning().all_setups().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QCOMPARE(kept_files().size(), 3); // two plans, and what stands between them
        QVERIFY(reopen());
        QVERIFY(!w().document().modified());
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(w().document().complete_plan());
        w().tree().select({ui::TreeNode::Kind::setup, 1});
        w().tree().go_to_setup_action()->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(w().document().has_stock());
        QVERIFY(w().document().complete_plan());
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
    }

    /// Of setups that were judged as one job, and of each alone.
    void verdicts_of_several_setups() {
        folder_ = scratch_folder(QStringLiteral("kept_chain"));
        save_stl(HollowedBlock::mesh(), (folder_ + "/block.stl").toStdString(), LengthUnit::mm, {});
        QFile file(job());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(two_sides);
        file.close();
        w().open_file(job());
        QVERIFY(wait_until_settled(w()));
        w().planning().all_setups().verify();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        const ui::Verdict verdict = w().verification().model().verdict();
        QVERIFY(verdict == ui::Verdict::verified || verdict == ui::Verdict::failed);
        const QString line = w().verification().panel()->verdict_line();
        QVERIFY2(line.contains(QStringLiteral("2 setups as one job")), qPrintable(line));
        const std::size_t findings = w().verification().model().findings().size();
        QCOMPARE(kept_files().size(), 4); // two plans, what stands between them, and the verdict
        QVERIFY(reopen());
        const auto* model = &w().verification().model();
        QVERIFY(model->current() && model->covers_all());
        QCOMPARE(model->verdict(), verdict);
        QCOMPARE(w().verification().panel()->verdict_line(), line);
        QCOMPARE(model->findings().size(), findings);
        QCOMPARE(model->outcome().setups.size(), std::size_t(2));
        QCOMPARE(model->outcome().programs.size(), std::size_t(2));
        QCOMPARE(model->outcome().chain.size(), std::size_t(2));
        const auto top = model->shown_setup()->display;
        QVERIFY(top && w().viewport().scene().has(Layer::deviation));
        // The other setup knows of it, too, in its own coordinates.
        w().tree().select({ui::TreeNode::Kind::setup, 1});
        w().tree().go_to_setup_action()->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(model->current() && model->shown_setup() && model->shown_setup()->display != top);
        QVERIFY(!model->shown_setup()->frame.is_identity());
        QCOMPARE(model->verdict(), verdict);
        // One that is judged alone says so of itself.
        w().tree().select({ui::TreeNode::Kind::setup, 0});
        w().tree().go_to_setup_action()->trigger();
        QVERIFY(wait_until_settled(w()));
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(kept_files().size(), 5);
    }

    /// That there is no plan, and why, is there again as well.
    void a_failure_is_kept_with_its_words() {
        folder_ = scratch_folder(QStringLiteral("kept_failure"));
        QVERIFY(open_and_plan());
        w().tree().select({ui::TreeNode::Kind::part, 0});
        enter(w(), "tessellation_tolerance1", QStringLiteral("1")); // leaves nothing of the tolerance
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::failed);
        const QString why = w().document().failure(0);
        QVERIFY(!why.isEmpty());
        QVERIFY(w().files().save_to(job()));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(kept_files().size(), 1);
        QVERIFY(reopen());
        QCOMPARE(w().document().state(0), OperationState::failed);
        QCOMPARE(w().document().failure(0), why);
        QVERIFY(!w().document().modified());
        // Not of another operation.
        w().tree().select({ui::TreeNode::Kind::part, 0});
        enter(w(), "tessellation_tolerance1", QStringLiteral("0"));
        QCOMPARE(w().document().state(0), OperationState::not_planned);
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(w().files().save_to(job()));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(kept_files().size(), 1); // the failure is of no use to the project any more
    }

    void saved_and_closed_at_once() {
        folder_ = scratch_folder(QStringLiteral("kept_at_once"));
        QVERIFY(open_and_plan());
        QVERIFY(w().files().save_to(job()));
        close_window();
        QCOMPARE(kept_files().size(), 1);
    }
};

FACETMILL_TEST(TestWindowKeptPlans)
#include "test_window_kept_plans.moc"
