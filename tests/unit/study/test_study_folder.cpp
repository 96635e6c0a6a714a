// A study on disk: found once, never asked again, and never taken from somebody else.
#include "core/base/parallel.h"
#include "core/job/chain_verification.h"
#include "core/job/setup_plan.h"
#include "core/study/evaluation.h"
#include "core/study/study_results.h"
#include "core/study/study_run.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/study/study_job.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;
namespace fs = std::filesystem;

namespace {

const std::string some = R"("vary": [ { "path": "operations[Fine].direction", "values": ["x", "y"] },
    { "path": "operations[Fine].tolerance", "values": [0.2, 0.3] } ], "limits": { "excess_max": { "project_times": 1.5 } })";

/// Works as it is asked to, and counts.
StudyEngine counting(std::size_t& looks, std::size_t stop_after = std::size_t(-1)) {
    return [&looks, stop_after](const StudyFolder& folder, const std::vector<StudyWork>& work,
                                const Progress& progress) -> std::map<std::string, std::string> {
        for (const StudyWork& w : work) {
            if (looks == stop_after) throw Cancelled();
            ++looks;
            work_on(folder, w.key, w.rung, progress);
        }
        return {};
    };
}

} // namespace

class TestStudyFolder : public QObject {
    Q_OBJECT

    static StudyFolder made(const StudyJob& job, const std::string& members, const char* name = "s.study") {
        job.write("study.json", StudyJob::text(members));
        return StudyFolder::make(job.path(name), job.path("study.json"), "program 1");
    }

private slots:
    void initTestCase() { set_thread_count(1); } // the looks are too small for several
    void cleanupTestCase() { set_thread_count(0); }

    void found_once_and_not_asked_again() {
        const StudyJob job;
        const StudyFolder whole = made(job, some, "whole.study");
        std::size_t looks = 0;
        const StudyOutcome once = run_study(whole, counting(looks), {});
        QVERIFY(once.decision.winner && looks > 4);
        const std::string text = study_json(whole, once);
        // Stopped after each look in turn, and gone on with.
        const StudyFolder parts = made(job, some);
        std::size_t done = 0;
        for (std::size_t stop = 1; stop < looks; ++stop)
            QCOMPARE(code_of([&] { run_study(parts, counting(done, stop), {}); }), std::string("cancelled"));
        const StudyOutcome again = run_study(parts, counting(done), {});
        QCOMPARE(done, looks);
        QCOMPARE(study_json(parts, again), text);
        QCOMPARE(study_csv(parts, again), study_csv(whole, once));
        std::size_t none = 0;
        QCOMPARE(study_json(parts, run_study(parts, counting(none), {})), text);
        QCOMPARE(none, std::size_t(0));
        // A result that the disk has torn is found out again.
        const std::string file = "s.study/candidates/" + again.keys[1] + "/estimate.json";
        QVERIFY(!job.read(file).empty());
        job.write(file, job.read(file).substr(0, 20));
        QCOMPARE(study_json(parts, run_study(parts, counting(none), {})), text);
        QCOMPARE(none, std::size_t(1));
        // Another part is another study.
        std::string roof = job.read("roof.stl");
        job.write("roof.stl", roof.replace(roof.find("20 10 4"), 7, "20 10 3"));
        QVERIFY(!look_at_study(parts, {}, {}).decision.missing.empty());
        QCOMPARE(code_of([&] { parts.candidate(again.keys[1]); }), std::string("out_of_range"));
    }

    void a_look_says_what_planning_and_judging_say() {
        const StudyJob job;
        SetupPlanners planners;
        const auto setups = plan_setups(job.project, "", planners, {});
        const auto chains = stock_chains(setups);
        const JudgedChain judged =
            judge_chain(chains[0], planned_programs(chains[0]), chain_settings(chains[0]), {});
        double time = 0;
        for (const auto& o : setups[0].plan->operations)
            time += o->totals.time_seconds;
        const RungResult fine = evaluate(job.project, job.project, Rung::fine, {});
        QVERIFY2(fine.passed, fine.why.c_str());
        QCOMPARE(*fine.measures[Measure::machining_time], time);
        QCOMPARE(*fine.measures[Measure::excess_max], judged.result->figures.excess_max);
        QCOMPARE(*fine.measures[Measure::tool_changes], 2.0);
        const auto& loads = judged.result->program_loads;
        QCOMPARE(loads.size(), std::size_t(2));
        QVERIFY(loads[0].peak_rate > 0 && loads[1].peak_rate > 0 && loads[0].volume > loads[1].volume);
        QCOMPARE(*fine.measures[Measure::peak_load], std::max(loads[0].peak_rate, loads[1].peak_rate));
        // Each tool has two edges where it does not say.
        double wear = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const double wide = 2 * judged.programs.programs[i].tool.cutter.max_radius();
            wear = std::max(wear, loads[i].volume / (2 * wide * wide));
        }
        QCOMPARE(*fine.measures[Measure::wear], wear);
        Project four = job.project;
        for (Tool& tool : four.tools)
            tool.flutes = 4;
        QCOMPARE(*evaluate(four, job.project, Rung::coarse, {}).measures[Measure::wear],
                 *evaluate(job.project, job.project, Rung::coarse, {}).measures[Measure::wear] / 2);
        QVERIFY(!evaluate(job.project, job.project, Rung::estimate, {}).measures[Measure::excess_max]);
        // A path with a larger tolerance is held against that of the project as it stands.
        Project loose = job.project;
        loose.operations[1]->common().tolerance = 1.2;
        const RungResult judged_loose = evaluate(loose, job.project, Rung::fine, {});
        QVERIFY(!judged_loose.passed);
        QVERIFY(evaluate(loose, loose, Rung::fine, {}).passed);
        // What it cannot do is a result; what says nothing of it is an error.
        loose.operations[0]->common().tool = 77;
        QVERIFY(!evaluate(loose, job.project, Rung::estimate, {}).passed);
        loose.part.file = "gone.stl";
        loose.operations[0]->common().tool = 1;
        QCOMPARE(code_of([&] { evaluate(loose, job.project, Rung::estimate, {}); }),
                 std::string("not_found"));
    }

    void lost_candidates_cost_themselves_alone() {
        const StudyJob job;
        const StudyFolder folder = made(job, some);
        std::string victim;
        const StudyEngine engine = [&](const StudyFolder& f, const std::vector<StudyWork>& work,
                                       const Progress& p) -> std::map<std::string, std::string> {
            if (victim.empty()) victim = work[1].key;
            for (const StudyWork& w : work)
                if (w.key != victim) work_on(f, w.key, w.rung, p);
            return {{victim, "its worker was ended by signal 11"}};
        };
        const StudyOutcome outcome = run_study(folder, engine, {});
        QVERIFY(outcome.decision.winner);
        QCOMPARE(outcome.lost.size(), std::size_t(1));
        QVERIFY(study_markdown(folder, outcome).find("lost: its worker was ended by signal 11")
                != std::string::npos);
        // Whoever goes on asks for it again.
        const auto missing = look_at_study(folder, {}, {}).decision.missing;
        QCOMPARE(missing.size(), std::size_t(1));
        QCOMPARE(missing[0].candidate, std::size_t(1));
    }

    void winners_are_adopted() {
        const StudyJob job;
        const StudyFolder folder = made(job, some);
        std::size_t looks = 0;
        const StudyOutcome outcome = run_study(folder, counting(looks), {});
        const std::size_t winner = *outcome.decision.winner;
        fs::create_directory(job.path("below"));
        adopt_candidate(outcome, winner, job.path("below/best.facetmill"));
        const Project best = load_project(job.path("below/best.facetmill"));
        QVERIFY(fs::equivalent(best.part_path(), job.path("roof.stl")));
        const RungResult again = evaluate(best, job.project, Rung::fine, {});
        QVERIFY(again.passed);
        for (const Measure m : all_measures()) // files have fifteen digits
            QCOMPARE(1 + *again.measures[m], 1 + *outcome.states[winner].at(Rung::fine)->measures[m]);
        QCOMPARE(code_of([&] { adopt_candidate(outcome, 99, job.path("x.facetmill")); }),
                 std::string("out_of_range"));
        // Four that are possible: with the project as it stands the last of them is the same as another.
        QVERIFY(outcome.same.back() == 4);
        write_study(folder, outcome);
        QCOMPARE(job.read("s.study/study.json"), study_json(folder, outcome));
    }

    void what_is_not_for_it_is_refused() {
        const StudyJob job;
        const StudyFolder folder = made(job, some);
        std::string message;
        QCOMPARE(code_of([&] { StudyFolder(job.path("s.study"), "program 2"); }, &message),
                 std::string("newer_version"));
        QVERIFY(message.find("program 2") != std::string::npos);
        QCOMPARE(code_of([&] { StudyFolder(job.path("none"), "program 1"); }), std::string("not_found"));
        // Two runs in one folder.
        std::size_t looks = 0;
        const StudyEngine second = [&](const StudyFolder& f, const std::vector<StudyWork>&,
                                       const Progress&) -> std::map<std::string, std::string> {
            QTest::qCompare(code_of([&] { run_study(f, counting(looks), {}); }), std::string("unwritable"),
                            "second run", "unwritable", __FILE__, __LINE__);
            throw Cancelled();
        };
        QCOMPARE(code_of([&] { run_study(folder, second, {}); }), std::string("cancelled"));
        // No limit is met: the nearest is named, with what it misses.
        const StudyFolder hard =
            made(job, R"("vary": [ { "path": "operations[Fine].tool", "values": "tools" } ],
            "limits": { "excess_max": 0.0001 })",
                 "hard.study");
        const StudyOutcome outcome = run_study(hard, counting(looks), {});
        QCOMPARE(code_of([&] { check_winner(hard, outcome); }, &message), std::string("empty_result"));
        QVERIFY2(message.find("nearest comes") != std::string::npos
                     && message.find("at most 0.0001 is allowed") != std::string::npos,
                 message.c_str());
        // There is no room for a candidate.
        job.write("full.study", "a file");
        job.write("study.json", StudyJob::text(some));
        QCOMPARE(code_of([&] { StudyFolder::make(job.path("full.study"), job.path("study.json"), "p"); }),
                 std::string("unwritable"));
        fs::remove_all(job.path("s.study/candidates"));
        job.write("s.study/candidates", "a file");
        QCOMPARE(code_of([&] { run_study(folder, counting(looks), {}); }), std::string("unwritable"));
    }
};

FACETMILL_TEST(TestStudyFolder)
#include "test_study_folder.moc"
