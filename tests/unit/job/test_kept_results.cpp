// What was planned and verified, as bytes and back: nothing of it changes, and of damaged bytes nothing
// comes.
#include "core/base/byte_coder.h"
#include "core/base/keyed_hash.h"
#include "core/job/kept_folder.h"
#include "core/job/kept_result.h"
#include "core/job/program_files.h"
#include "core/job/verification.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "core/strategy/global_local/rework_plan.h"
#include "tests/property/shapes.h"
#include "tests/property/turned_part.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

namespace fs = std::filesystem;

std::string file_bytes(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A part with operations, planned.
struct KeptJob {
    QTemporaryDir dir;
    fs::path root{dir.path().toStdString()};
    Project project;
    Planner planner;
    std::shared_ptr<const PlanResult> plan;

    KeptJob(const Mesh& part, const std::string& setup, const std::string& operations) {
        save_stl(part, root / "part.stl", LengthUnit::mm, {});
        project = parse_project(
            R"({ "facetmill": 2, "units": "mm", "part": { "file": "part.stl" }, "tools": [)"
            R"( { "number": 1, "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_length": 30 },)"
            R"( { "number": 2, "diameter": 2, "corner_radius": 1, "flute_length": 10, "shank_length": 30 },)"
            R"( { "number": 3, "diameter": 6, "corner_radius": 1, "flute_length": 20, "shank_length": 30 } ],)"
            R"( "setups": [ { "name": "Top", )"
                + setup + R"(, "operations": [ )" + operations + " ] } ] }",
            "part");
        project.path = root / "part.facetmill";
        plan = planner.plan(project, {}, Progress());
    }
    /// What an operation came to, also nothing.
    std::shared_ptr<const OperationResult> result(std::size_t i) const {
        for (const auto* all : {&plan->operations, &plan->idle})
            for (const auto& one : *all)
                if (one->name == project.operations[i]->common().name) return one;
        return nullptr;
    }
    std::shared_ptr<const OperationResult> again(std::size_t i) const {
        return result_from_bytes(result_bytes(*result(i), *plan->part, {}), project, i, *plan->part, {});
    }
    /// The plan as it comes back from bytes.
    std::shared_ptr<PlanResult> back() const {
        auto all = std::make_shared<PlanResult>(*plan);
        all->operations.clear();
        for (std::size_t i = 0; i < project.operations.size(); ++i)
            for (const auto& program : programs_of(again(i)))
                all->operations.push_back(program);
        return all;
    }
    std::map<std::string, std::string> files(const PlanResult& of, const std::string& name) const {
        std::map<std::string, std::string> all;
        for (const fs::path& file : write_plan(project, of, root / name, {}))
            all[file.filename().string()] = file_bytes(file);
        return all;
    }
};

/// One operation of each kind that a mill of five axes can plan on a bowl.
const KeptJob& bowl() {
    static const KeptJob job(
        height_field([](double x, double y) { return -5 * std::exp(-(x * x / 60 + y * y / 40)) + 0.02 * x; },
                     Vec2(-14, -10), Vec2(14, 10), 28, 20),
        R"("machine": "tarus-tpi-2000", "stock": { "kind": "box", "margin": [0, 0, 1] },)"
        R"( "boundaries": [ { "name": "Middle", "kind": "slope", "slope": [0, 60] } ])",
        R"({ "kind": "rough", "name": "Rough", "tool": 3, "tolerance": 0.3, "depth": 2 },)"
        R"({ "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.1, "boundary": "Middle" },)"
        R"({ "kind": "finish5", "name": "Five", "tool": 3, "tolerance": 0.2, "grid_degrees": 15 },)"
        R"({ "kind": "global_local", "name": "Local", "tool": 3, "tolerance": 0.2, "lead_limit": 10,)"
        R"( "assumed_lead_limit": 40, "rework_tool": 2 },)"
        R"({ "kind": "finish3", "name": "Tilted", "tool": 1, "tolerance": 0.2, "tool_axis": [0.3, 0, 1],)"
        R"( "boundary": "Middle" },)"
        R"({ "kind": "cleanup", "name": "Clean", "tool": 2, "tolerance": 0.1, "previous_tool": 1 })");
    return job;
}

const KeptJob& rod() {
    static const KeptJob job(
        turned_part(36, 12, 24,
                    [](double angle, double x) { return 8 + 1.2 * std::cos(3 * angle) + 0.02 * x; }),
        R"("machine": "lathe-mill", "stock": { "kind": "cylinder", "axis": "x", "margin": [0, 1, 1] })",
        R"({ "kind": "lathe_rough", "name": "Rough", "tool": 1, "tolerance": 0.3, "depth_of_cut": 2 },)"
        R"({ "kind": "lathe_finish", "name": "Finish", "tool": 1, "tolerance": 0.2 })");
    return job;
}

bool same(const FiveAxisStudy::Point& a, const FiveAxisStudy::Point& b) {
    return a.space.bottom == b.space.bottom && a.space.top == b.space.top && a.space.block == b.space.block
           && a.cm2_lead == b.cm2_lead && a.planned.free == b.planned.free
           && a.planned.posture.lead == b.planned.posture.lead;
}

} // namespace

class TestKeptResults : public QObject {
    Q_OBJECT
private slots:
    /// Test vectors of the authors (SipHash-2-4-128, key 00..0f, input 00, 01, 02 ...).
    void hashes_as_its_authors_do() {
        HashKey key;
        key.words = {0x0706050403020100u, 0x0f0e0d0c0b0a0908u};
        std::string input;
        const auto hex = [&](std::size_t n) {
            while (input.size() < n)
                input += char(input.size());
            return keyed_hash(key, std::string_view(input).substr(0, n)).hex();
        };
        QCOMPARE(hex(0), std::string("a3817f04ba25a8e66df67214c7550293"));
        QCOMPARE(hex(1), std::string("da87c1d86b99af44347659119b22fc45"));
        QCOMPARE(hex(15), std::string("5493e99933b0a8117e08ec0f97cfc3d9"));
        // However it is cut.
        KeyedHasher pieces(key);
        hex(63);
        for (std::size_t i = 0; i < 63; i += 5)
            pieces.add(std::string_view(input).substr(i, std::min<std::size_t>(5, 63 - i)));
        QCOMPARE(pieces.hash().hex(), hex(63));
    }

    void every_kind_comes_back_as_it_was_data() {
        QTest::addColumn<bool>("turns");
        QTest::newRow("bowl") << false;
        QTest::newRow("rod") << true;
    }
    void every_kind_comes_back_as_it_was() {
        QFETCH(bool, turns);
        const auto& job = turns ? rod() : bowl();
        const auto again = job.back();
        QCOMPARE(again->operations.size(), job.plan->operations.size());
        for (std::size_t i = 0; i < again->operations.size(); ++i) {
            const OperationResult &was = *job.plan->operations[i], &is = *again->operations[i];
            // All that is written of it is the same once more.
            QVERIFY2(result_bytes(was, *job.plan->part, {}) == result_bytes(is, *job.plan->part, {}),
                     was.name.c_str());
            QCOMPARE(bool(is.within), bool(was.within));
            QCOMPARE(is.further.size(), was.further.size());
            QCOMPARE(is.warnings(), was.warnings());
        }
        // All kinds are there, some with nothing to do.
        for (std::size_t i = 0; i < job.project.operations.size(); ++i)
            QCOMPARE(job.again(i)->nothing_to_do, job.result(i)->nothing_to_do);
        // Programs and report are the same bytes.
        const auto before = job.files(*job.plan, "before"), after = job.files(*again, "after");
        QVERIFY(before.size() >= again->operations.size());
        for (const auto& [name, bytes] : before)
            QVERIFY2(after.at(name) == bytes, name.c_str());
    }

    void configuration_spaces_are_the_same() {
        const auto& job = bowl();
        const auto again = job.back();
        int compared = 0;
        for (std::size_t i = 0; i < again->operations.size(); ++i) {
            const auto was = job.plan->operations[i]->path.five_axis(),
                       is = again->operations[i]->path.five_axis();
            QCOMPARE(bool(is), bool(was));
            if (!was || was->points.empty()) continue;
            QVERIFY(!is->context.contact && is->kept_off);
            const FiveAxisStudy before(was, {}), after(is, {});
            const std::size_t middle = was->points.size() / 2;
            QVERIFY(same(before.point(middle, {}), after.point(middle, {})));
            ++compared;
        }
        QVERIFY(compared >= 2);
    }

    /// A window's part has none until an operation turns its axis; they are not written a second time.
    void normals_of_the_part_are_worked_out_where_it_has_none() {
        const auto& job = bowl();
        PreparedPart bare = *job.plan->part;
        QVERIFY(bare.geometry);
        bare.geometry = nullptr;
        int compared = 0;
        for (std::size_t i = 0; i < job.project.operations.size(); ++i) {
            const std::string bytes = result_bytes(*job.result(i), *job.plan->part, {});
            QVERIFY(result_bytes(*job.result(i), bare, {}) == bytes);
            const auto was = job.result(i)->path.five_axis(),
                       is = result_from_bytes(bytes, job.project, i, bare, {})->path.five_axis();
            if (!was || was->context.part != bare.mesh) continue;
            QVERIFY(is->context.geometry->vertex_normals == was->context.geometry->vertex_normals);
            QVERIFY(is->context.geometry->facet_normals == was->context.geometry->facet_normals);
            ++compared;
        }
        QVERIFY(compared >= 1);
    }

    void a_planner_has_what_it_adopts() {
        const auto& job = bowl();
        Planner other;
        for (std::size_t i = 0; i < job.project.operations.size(); ++i)
            other.adopt(job.again(i));
        const auto plan = other.plan(job.project, {}, {});
        QCOMPARE(other.work().strategies, 0);
        QCOMPARE(other.work().links, 0);
        QCOMPARE(plan->operations.size(), job.plan->operations.size());
        // And with another value it plans that operation, and what comes of it.
        Project changed = job.project;
        changed.operations.back()->common().tolerance = 0.15;
        other.plan(changed, {}, {});
        QCOMPARE(other.work().strategies, 1);
    }

    void verdicts_come_back() {
        const auto& job = bowl();
        auto first = std::make_shared<PlanResult>(*job.plan);
        first->operations.resize(1);
        const auto programs = verify_programs(job.project, first);
        const auto verdict = std::make_shared<Verification>(verify(
            *first->part->mesh, first->stock, programs, verify_settings(job.project, first.get()), {}));
        const std::string bytes = verdict_bytes({17, verdict}, {});
        const KeptVerdict back = verdict_from_bytes(bytes, {});
        QCOMPARE(back.posted_blocks, std::size_t(17));
        Verification with_stock = *back.verification;
        QVERIFY(!with_stock.stock);
        with_stock.stock = verdict->stock;
        QCOMPARE(verify_json(job.project, programs, with_stock),
                 verify_json(job.project, programs, *verdict));
        QVERIFY(back.verification->surface->deviation == verdict->surface->deviation);
        QVERIFY(verdict_bytes(back, {}) == bytes);
    }

    /// Bytes that nobody wrote: an error, at once, and in little memory. Seals keep them from being read at
    /// all.
    void damaged_bytes_are_refused() {
        const auto& job = bowl();
        std::mt19937 random(7);
        for (const std::size_t k : {std::size_t(0), std::size_t(2)}) {
            const std::string good = result_bytes(*job.plan->operations[k], *job.plan->part, {});
            const auto refused = [&](const std::string& bytes) {
                try {
                    result_from_bytes(bytes, job.project, k, *job.plan->part, {});
                    return false;
                } catch (const Error&) {
                    return true;
                }
            };
            QVERIFY(!refused(good));
            QVERIFY(refused(good + 'x'));
            for (int i = 0; i < trials(60); ++i) {
                QVERIFY(refused(
                    good.substr(0, std::uniform_int_distribution<std::size_t>(0, good.size() - 1)(random))));
                std::string torn = good;
                for (int n = 0; n < 4; ++n)
                    torn[std::uniform_int_distribution<std::size_t>(
                        0, std::min<std::size_t>(good.size(), 2000) - 1)(random)] ^=
                        char(1 << (random() % 8));
                refused(torn); // or values that are others; never more than an error
            }
        }
    }

    void only_what_was_sealed_is_read() {
        QTemporaryDir dir;
        const fs::path project = fs::path(dir.path().toStdString()) / "job.facetmill";
        HashKey key;
        key.words = {1, 2};
        const KeptFolder folder(project, key, "program 1");
        QVERIFY(folder.empty());
        QVERIFY(folder.path().filename() == "job.facetmill-cache");
        const std::string name = folder.name_of("plan", "values");
        QVERIFY(name != folder.name_of("verdict", "values") && name != folder.name_of("plan", "values2"));
        const std::string content = "what was planned, " + std::string(3000, 'x');
        QVERIFY(folder.write(name, content, {}));
        QVERIFY(folder.has(name) && *folder.read(name, {}) == content);
        // Another program, another user, another name.
        QVERIFY(KeptFolder(project, key, "program 2").name_of("plan", "values") != name);
        HashKey other;
        other.words = {1, 3};
        QVERIFY(!KeptFolder(project, other, "program 1").read(name, {}));
        const fs::path file = folder.path() / (name + ".kept");
        const std::string second = folder.name_of("plan", "other values");
        fs::copy_file(file, folder.path() / (second + ".kept"));
        QVERIFY(!folder.read(second, {}));
        // Any byte of it, and any length.
        const std::string good = file_bytes(file);
        std::mt19937 random(3);
        const auto with = [&](const std::string& bytes) {
            std::ofstream(file, std::ios::binary) << bytes;
            return folder.read(name, {});
        };
        for (std::size_t i = 0; i < good.size(); i += i < 80 || i + 40 > good.size() ? 1 : 97) {
            std::string torn = good;
            torn[i] ^= char(1 << (random() % 8));
            QVERIFY2(!with(torn), std::to_string(i).c_str());
        }
        for (const std::size_t n : {std::size_t(0), std::size_t(1), std::size_t(60), good.size() - 1})
            QVERIFY(!with(good.substr(0, n)));
        QVERIFY(!with(good + "x") && *with(good) == content);
        // A pipe or a folder of that name is none.
        fs::remove(file);
        fs::create_directory(file);
        QVERIFY(!folder.read(name, {}) && !folder.has(name));
        fs::remove(file);
        QVERIFY(folder.write(name, content, {}));
        std::ofstream(folder.path() / "mine.txt") << "mine";
        folder.keep_only({name});
        QVERIFY(folder.has(name) && !folder.has(second) && fs::exists(folder.path() / "mine.txt"));
        QVERIFY(fs::exists(folder.path() / "CACHEDIR.TAG"));
        folder.keep_only({});
        QVERIFY(folder.empty());
    }

    /// What is kept of a project goes along with a copy of it, and never stands in its way.
    void a_copy_takes_it_along() {
        QTemporaryDir dir;
        const fs::path root(dir.path().toStdString()), from = root / "job.facetmill",
                                                       to = root / "elsewhere" / "sent.facetmill";
        const KeptFolder folder(from, {}, "p"), copy(to, {}, "p");
        copy_kept(from, to, {}); // there is none
        QVERIFY(copy.empty());
        const std::string a = folder.name_of("plan", "a"), b = folder.name_of("plan", "b");
        QVERIFY(folder.write(a, "what was planned", {}) && folder.write(b, std::string(100000, 'b'), {}));
        std::ofstream(folder.path() / "mine.txt") << "mine";
        copy_kept(from, to, {}); // its project has no folder yet
        QVERIFY(!fs::exists(root / "elsewhere"));
        fs::create_directories(root / "elsewhere");
        copy_kept(from, to, {});
        QVERIFY(*copy.read(a, {}) == "what was planned" && copy.read(b, {})->size() == 100000);
        QVERIFY(fs::exists(copy.path() / "CACHEDIR.TAG") && !fs::exists(copy.path() / "mine.txt"));
        // What is there stays as it is; onto itself nothing happens.
        std::ofstream(copy.path() / (a + ".kept"), std::ios::binary) << "torn";
        copy_kept(from, to, {});
        QVERIFY(!copy.read(a, {}));
        copy_kept(from, from, {});
        QVERIFY(folder.read(a, {}) && folder.read(b, {}));
        fs::remove_all(copy.path());
        Job job;
        job.cancel();
        QVERIFY_THROWS_EXCEPTION(Cancelled, copy_kept(from, to, Progress(job)));
        QVERIFY(copy.empty());
        // No more than one project may keep.
        fs::resize_file(folder.path() / (b + ".kept"), KeptFolder::largest_total);
        copy_kept(from, to, {});
        QVERIFY(copy.size() < KeptFolder::largest_total);
    }

    void no_more_than_its_share_is_kept() {
        QTemporaryDir dir;
        const KeptFolder folder(fs::path(dir.path().toStdString()) / "job.facetmill", {}, "p");
        const std::string name = folder.name_of("plan", "a");
        QVERIFY(folder.write(name, "a", {}));
        // As large as all may be, without a byte on the disk.
        fs::resize_file(folder.path() / (name + ".kept"), KeptFolder::largest_total - 20);
        QVERIFY(!folder.write(folder.name_of("plan", "b"), "b", {}));
        QVERIFY(!folder.has(folder.name_of("plan", "b")));
        fs::resize_file(folder.path() / (name + ".kept"), KeptFolder::largest_total + 1);
        QVERIFY(!folder.read(name, {}));
    }
};

FACETMILL_TEST(TestKeptResults)
#include "test_kept_results.moc"
