// Random dirty meshes under random projects of every kind, from the file to the verdict. Whatever is planned,
// the verifier takes: a job may be refused, in words, and may leave something and say so, and nothing else.
// FACETMILL_PIPELINE=FIRST,COUNT tries other seeds, and says what became of each; with
// FACETMILL_PIPELINE_KEEP=FOLDER their files stay.
#include "core/job/planner.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/job/work_estimate.h"
#include "tests/property/random_jobs.h"
#include "tests/support/test_runner.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <future>
#include <numeric>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Some of every outcome; 39, 40: a finished part that was roughed once more was called gouged. 62: a
/// clean-up of points that lay in one place went on for ever. 27, 287: a part of a closed border that shank
/// or holder had cut short was begun in its middle, with a way straight through the part from end to end.
constexpr qulonglong usual_seeds[] = {0, 2, 5, 7, 9, 13, 17, 24, 27, 39, 40, 62, 287};

/// Jobs this small take a second or two, a few of five axes minutes: those are cut short. What does not end
/// then hangs.
constexpr auto longest = std::chrono::seconds(120);

struct Outcome {
    std::string what;  ///< "verified", "refused: ...", "said so"
    bool right = true; ///< nobody is fooled
};

std::string verdict_of(const Project& project, const PlanResult& plan,
                       const std::vector<VerifyProgram>& programs, const Verification& v, bool& right) {
    bool warned = false;
    for (const auto& o : plan.operations)
        warned = warned || !o->warnings().empty() || !o->out_of_reach.empty();
    const std::string findings = findings_line(project, programs, v);
    if (v.verdict() == Verdict::verified) return "verified";
    if (v.verdict() == Verdict::not_judged) return "not judged: " + v.not_judged;
    const bool touched = v.gouged() || !v.collisions.empty();
    // Planners keep shank and holder out of the part; out of stock that nobody roughed they do not, nor say
    // so.
    const bool in_stock = std::all_of(v.collisions.begin(), v.collisions.end(), [](const Collision& c) {
        return !c.with_part && c.kind != Collision::Kind::rapid;
    });
    // Offset by vertices cuts into the allowance, says so and is there for comparison.
    const bool said = std::any_of(plan.operations.begin(), plan.operations.end(), [](const auto& o) {
        const auto warnings = o->warnings();
        return std::any_of(warnings.begin(), warnings.end(), [](const std::string& w) {
            return w.find("into the allowance") != std::string::npos;
        });
    });
    right = (said || !v.gouged()) && in_stock && (warned || touched);
    return std::string(touched ? "TOUCHED" : "uncut") + (warned ? " and said so: " : ": ") + findings;
}

/// Where FACETMILL_PIPELINE_KEEP says, as SEED/p.facetmill, to be looked at.
std::filesystem::path folder_for(std::uint64_t seed, QTemporaryDir& passing) {
    const QByteArray keep = qgetenv("FACETMILL_PIPELINE_KEEP");
    if (keep.isEmpty()) return passing.path().toStdString();
    const auto folder = std::filesystem::path(keep.toStdString()) / std::to_string(seed);
    std::filesystem::create_directories(folder);
    return folder;
}

Outcome tried(std::uint64_t seed, const Progress& progress) {
    QTemporaryDir dir;
    try {
        const Project made = random_job(seed, folder_for(seed, dir));
        if (qEnvironmentVariableIsSet("FACETMILL_PIPELINE_KEEP")) save_project(made, made.path);
        // As a user's: through the file.
        Project project = parse_project(project_to_json(made), "p.facetmill");
        project.path = made.path;
        check_project(project);
        Planner planner;
        const auto part = planner.prepare(project, progress);
        for (const WorkEstimate& e : estimate_plan(project, *part, {}))
            if (e.large()) return {"large: " + e.text()};
        const auto plan = planner.plan(project, {}, progress.part(0, 0.5));
        plan->check_programs();
        plan->check_reach();
        const auto programs = verify_programs(project, plan);
        VerifySettings settings = verify_settings(project, plan.get());
        settings.sample_spacing = settings.resolution = 0.02 * (part->box.hi - part->box.lo).norm();
        const Verification v =
            verify(*plan->part->mesh, plan->stock, programs, settings, progress.part(0.5, 1));
        Outcome outcome;
        outcome.what = verdict_of(project, *plan, programs, v, outcome.right);
        return outcome;
    } catch (const Cancelled&) {
        return {"cut short"};
    } catch (const Error& e) {
        return {std::string("refused: ") + e.what(), e.code() != ErrorCode::internal};
    }
}

Outcome tried_in_time(std::uint64_t seed) {
    Job job;
    auto outcome = std::async(std::launch::async, [&] { return tried(seed, Progress(job)); });
    if (outcome.wait_for(longest) == std::future_status::ready) return outcome.get();
    job.cancel();
    if (outcome.wait_for(std::chrono::seconds(2)) == std::future_status::ready) return outcome.get();
    outcome.wait();
    return {"HANGS", false};
}

} // namespace

class TestPipeline : public QObject {
    Q_OBJECT
private slots:
    void nobody_is_fooled_data() {
        QTest::addColumn<qulonglong>("seed");
        const QList<QByteArray> asked = qgetenv("FACETMILL_PIPELINE").split(',');
        std::vector<qulonglong> seeds(std::begin(usual_seeds), std::end(usual_seeds));
        if (asked.size() == 2) {
            seeds.resize(std::size_t(asked[1].toULongLong()));
            std::iota(seeds.begin(), seeds.end(), asked[0].toULongLong());
        }
        for (const qulonglong seed : seeds)
            QTest::addRow("%llu", seed) << seed;
    }
    void nobody_is_fooled() {
        QFETCH(qulonglong, seed);
        QElapsedTimer timer;
        timer.start();
        const Outcome outcome = tried_in_time(seed);
        if (qEnvironmentVariableIsSet("FACETMILL_PIPELINE")) {
            std::printf("%llu %.1f s %s%s\n", seed, 1e-3 * double(timer.elapsed()),
                        outcome.right ? "" : "WRONG ", outcome.what.c_str());
            std::fflush(stdout);
        }
        QVERIFY2(outcome.right, outcome.what.c_str());
    }
};

FACETMILL_TEST(TestPipeline)
#include "test_pipeline.moc"
