// Suggestions of operations: looked for, explained, made by a click, taken back by undo; and what is advised
// about a verification that failed.
#include "core/job/project.h"
#include "core/mesh/mesh_io.h"
#include "core/verify/verify.h"
#include "tests/screenshot/window_support.h"
#include "ui/controllers.h"
#include "ui/project_tree.h"
#include "ui/suggest_controller.h"
#include "ui/suggest_dialog.h"
#include "ui/theme.h"
#include "ui/verdict_advice.h"
#include "ui/verification_controller.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QUndoStack>

#include <array>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

namespace {

/// A closed block, `high` up to `wall` in Y and `low` behind it.
Mesh step_block(double length, double width, double wall, double low, double high) {
    Mesh m;
    const std::array<Vec2, 6> outline{Vec2(0, 0),  {width, 0},   {width, low},
                                      {wall, low}, {wall, high}, {0, high}};
    for (const double x : {0.0, length})
        for (const Vec2& p : outline)
            m.vertices.emplace_back(x, p.x(), p.y());
    for (Index k = 0; k < 6; ++k) {
        const Index next = (k + 1) % 6;
        m.facets.push_back({k, next, next + 6});
        m.facets.push_back({k, next + 6, k + 6});
    }
    for (const auto& [a, b, c] : {std::array<Index, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
        m.facets.push_back({a, c, b});
        m.facets.push_back({a + 6, b + 6, c + 6});
    }
    return m;
}

} // namespace

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
        // A button that does enough comes before words about most of it.
        v.uncut[0].area = 2.5;
        QVERIFY(says(v, "slimmer holder"));
        v.uncut_share = 0.04;
        QVERIFY(says(v, "slimmer holder"));
        v.uncut_share = 0.035;
        QVERIFY(says(v, "add Clean-up", "cleanup"));
        v.uncut_share = 0.307;
        v.uncut[0].area = 1;
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
        // Another one after it, as long as there are smaller tools.
        QVERIFY(says(v, "accept what stays"));
        project.tools.resize(2);
        project.tools[1].number = 2;
        project.tools[0].diameter = 2 * (project.tools[1].diameter = 2);
        project.tools[0].corner_radius = 2 * (project.tools[1].corner_radius = 1);
        project.operations.back()->common().tool = 2;
        QVERIFY(says(v, "another Clean-up", "cleanup"));
        QVERIFY(ui::verdict_advice(v, project).wish.previous_tool == 2);
        project.tools[1].diameter = 2 * (project.tools[1].corner_radius = 0.25);
        QVERIFY(says(v, "smaller tool in Clean-up"));
        // Not where nobody could judge what it leaves: places a quarter of its diameter apart would be too
        // many.
        project.tools[1].diameter = 2 * (project.tools[1].corner_radius = 1);
        auto surface = std::make_shared<DeviationSurface>();
        surface->points = {{0, 0, 0}, {100, 0, 0}, {0, 100, 0}};
        surface->normals.assign(3, {0, 0, 1});
        surface->triangles = {{0, 1, 2}};
        v.surface = surface;
        // A quarter of 1 mm apart they are 160 000, twice as many each way on a curved one; four times as
        // many as usual are looked at.
        v.used.max_samples = 39000;
        QVERIFY(says(v, "too fine to be judged"));
        v.used.max_samples = 41000;
        QVERIFY(says(v, "another Clean-up", "cleanup"));
        surface->normals[2] = {0.1F, 0, 0.995F};
        QVERIFY(says(v, "too fine to be judged"));
        v.surface.reset();
        // Of a flat that cleaned floors after a narrower ball, the ball is what the next one comes after.
        project.tools[1].diameter = 6;
        project.tools[1].corner_radius = 0;
        QVERIFY(says(v, "another Clean-up", "cleanup"));
        QVERIFY(ui::verdict_advice(v, project).wish.previous_tool == 1);
    }

    /// Where only the flat that roughs fits, clean-up is to take that one.
    void a_failure_names_the_tool_that_fits() {
        Project project;
        project.tools.resize(2);
        project.tools[1].number = 2;
        project.tools[1].name = "Flat 4";
        project.operations.push_back(make_operation("finish3"));
        project.operations.push_back(make_operation("rough"));
        project.operations.back()->common().name = "Block";
        project.operations.back()->common().tool = 2;
        UncutReason floors;
        floors.why = UncutReason::Why::no_operation;
        floors.program = "Block";
        floors.area = 1;
        Verification v;
        v.used.uncut_limit = 0.02;
        v.uncut_share = 0.1;
        v.uncut = {floors};
        const ui::VerdictAdvice advice = ui::verdict_advice(v, project);
        QCOMPARE(advice.text, QStringLiteral("What to do: add Clean-up with Flat 4, which fits there."));
        QCOMPARE(advice.add, std::string("cleanup"));
        QVERIFY(advice.wish.tool == 2 && !advice.wish.previous_tool);
        // Not once more, but after one with another tool.
        project.operations.push_back(make_operation("cleanup"));
        QVERIFY(ui::verdict_advice(v, project).wish.tool == 2);
        project.operations.back()->common().tool = 2;
        QVERIFY(ui::verdict_advice(v, project).add.empty());
        QVERIFY(ui::verdict_advice(v, project).text.contains(QStringLiteral("a finish with the tool")));
    }

    /// What lies beyond the limits of slope of all finishes is for another one.
    void a_failure_names_the_finish_for_what_is_steep() {
        Project project;
        project.tools.resize(2);
        project.tools[1].number = 2;
        const auto add = [&](const char* kind) {
            project.operations.push_back(make_operation(kind));
            project.operations.back()->common().tool = 2;
        };
        UncutReason walls;
        walls.why = UncutReason::Why::not_cut;
        walls.area = 1;
        Verification v;
        v.used.uncut_limit = 0.02;
        v.uncut_share = 0.2;
        v.uncut = {walls};
        v.bands.resize(6);
        for (std::size_t i = 0; i < v.bands.size(); ++i) {
            v.bands[i].from = radians(15) * double(i);
            v.bands[i].to = radians(15) * double(i + 1);
            v.bands[i].figures.area = 10;
        }
        v.bands.back().figures.uncut_fraction = 0.8;
        add("scallop");
        const double limit = std::get<double>(project.operations[0]->get("slope_limit"));
        ui::VerdictAdvice advice = ui::verdict_advice(v, project);
        QCOMPARE(advice.add, std::string("waterline"));
        QVERIFY2(advice.text.contains(QStringLiteral("add Waterline, which goes round what is steeper")),
                 qPrintable(advice.text));
        const NewOperation made = new_operation(advice.add, project, advice.wish);
        QCOMPARE(made.operation->common().tool, 2L);
        const auto slopes = std::get<std::array<double, 2>>(made.operation->get("slope_limits"));
        QVERIFY(slopes[0] < limit && slopes[0] > limit - radians(10) && slopes[1] == radians(90));
        // Not where hollows are what stays, nor where it is there already, or a finish of all slopes.
        v.uncut[0].why = UncutReason::Why::no_tool;
        QCOMPARE(ui::verdict_advice(v, project).add, std::string("cleanup"));
        v.uncut[0].why = UncutReason::Why::not_cut;
        for (const char* kind : {"waterline", "finish3"}) {
            add(kind);
            QCOMPARE(ui::verdict_advice(v, project).add, std::string("cleanup"));
            project.operations.pop_back();
        }
        // Most of it is level.
        v.bands.front().figures.uncut_fraction = 0.9;
        QCOMPARE(ui::verdict_advice(v, project).add, std::string("cleanup"));
        project.operations.clear();
        add("waterline");
        advice = ui::verdict_advice(v, project);
        QCOMPARE(advice.add, std::string("scallop"));
        QVERIFY(advice.wish.tool == 2);
    }

    /// A floor beside a wall, of which a ball leaves a fillet where the flat that roughs would fit: whoever
    /// takes the defaults and presses what is advised has a verified job, cleaned up with that flat.
    void what_is_advised_leads_to_a_verified_job() {
        const QString file = scratch_folder(QStringLiteral("advised")) + QStringLiteral("/step.stl");
        save_stl(step_block(24, 14, 7, 2, 9), file.toStdString(), LengthUnit::mm, {});
        w().open_file(file, LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        auto* advised = w().findChild<QPushButton*>(QStringLiteral("advised_button"));
        const ui::VerificationModel& model = w().verification().model();
        QStringList added;
        for (int round = 0; round < 4; ++round) {
            w().plan();
            QVERIFY(wait_until_settled(w()));
            QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
            w().verify();
            QVERIFY(wait_until_settled(w()));
            if (model.verdict() == ui::Verdict::verified) break;
            QVERIFY2(!advised->isHidden(), qPrintable(model.failure_text()));
            added << advised->text();
            advised->click();
            QVERIFY(wait_until_settled(w()));
        }
        QVERIFY2(model.verdict() == ui::Verdict::verified, qPrintable(model.failure_text()));
        const Project& project = w().document().project();
        QVERIFY2(added.contains(QStringLiteral("Add Clean-up")), qPrintable(added.join(QChar(','))));
        const OperationCommon& last = project.operations.back()->common();
        QCOMPARE(project.operations.back()->kind(), std::string_view("cleanup"));
        QCOMPARE(last.tool, project.operations.front()->common().tool);
        QCOMPARE(project.tool_of(*project.operations.back()).corner_radius, 0.0);
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
