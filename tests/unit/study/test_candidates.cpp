// What may vary of a project: places, values, combinations, and what is wrong with them.
#include "core/job/project_setup.h"
#include "core/study/candidates.h"
#include "core/study/project_place.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/study/study_job.h"

#include <QTest>

#include <set>

using namespace facetmill;
using namespace facetmill::test;

class TestCandidates : public QObject {
    Q_OBJECT

    StudyJob job_;

    std::vector<Candidate> of(const std::string& members) const {
        return study_candidates(job_.study(members), job_.project, {});
    }
    std::string line(const std::string& members) const {
        std::string message;
        code_of([&] { of(members); }, &message);
        return message;
    }
    static const Operation& operation(const Candidate& c, const std::string& name) {
        for (const auto& o : c.project->operations)
            if (o->common().name == name) return *o;
        qFatal("there is no operation %s", name.c_str());
    }

private slots:
    void combinations_stand_in_order() {
        const auto all = of(R"("vary": [
            { "path": "operations[Fine].tool", "values": "tools" },
            { "path": "operations[1].tolerance", "from": 0.1, "to": 0.3, "steps": 3 },
            { "path": "stock.margin", "values": [[1, 1, 1], [2, 2, 2]] } ])");
        QCOMPARE(all.size(), std::size_t(1 + 2 * 3 * 2));
        QVERIFY(all[0].chosen.empty());
        QCOMPARE(project_to_json(*all[0].project), project_to_json(job_.project));
        std::set<std::string> texts;
        for (std::size_t i = 1; i < all.size(); ++i) {
            QVERIFY2(all[i].usable(), all[i].impossible.c_str());
            const std::size_t n = i - 1;
            QCOMPARE(all[i].chosen, (std::vector<std::size_t>{n / 6, n / 2 % 3, n % 2}));
            const Operation& fine = operation(all[i], "Fine");
            QCOMPARE(fine.common().tool, long(1 + n / 6));
            QCOMPARE(fine.common().tolerance, std::vector<double>({0.1, 0.2, 0.3})[n / 2 % 3]);
            QCOMPARE(all[i].project->stock.margin[0], double(1 + n % 2));
            QCOMPARE(all[i].project->path, job_.project.path);
            texts.insert(project_to_json(*all[i].project));
        }
        QCOMPARE(texts.size(), all.size() - 1);
    }

    void samples_are_some_of_them() {
        const std::string vary =
            R"("vary": [ { "path": "operations[Fine].tolerance", "from": 0.1, "to": 0.4, "steps": 31 },
            { "path": "operations[Rough].tolerance", "from": 0.5, "to": 0.8, "steps": 31 } ], )";
        const auto a = of(vary + R"("samples": 20)"), b = of(vary + R"("samples": 20, "seed": 1)"),
                   other = of(vary + R"("samples": 20, "seed": 2)");
        QCOMPARE(a.size(), std::size_t(21));
        std::set<std::vector<std::size_t>> chosen;
        bool same = true;
        for (std::size_t i = 1; i < a.size(); ++i) {
            QCOMPARE(a[i].chosen, b[i].chosen);
            same = same && a[i].chosen == other[i].chosen;
            QVERIFY(i < 2 || a[i - 1].chosen < a[i].chosen);
            chosen.insert(a[i].chosen);
        }
        QCOMPARE(chosen.size(), std::size_t(20));
        QVERIFY(!same);
        // Of each number of numbers as many as there are, all below the total.
        for (const std::uint64_t total : {1u, 2u, 5u, 100u})
            for (std::size_t count = 1; count <= total + 1; ++count) {
                const auto numbers = chosen_numbers(total, count, 7);
                QCOMPARE(numbers.size(), std::min<std::size_t>(count, total));
                QVERIFY(std::is_sorted(numbers.begin(), numbers.end()) && numbers.back() < total);
            }
    }

    void kinds_orders_and_tools_vary() {
        const auto all = of(
            R"("tools": [ { "number": 7, "diameter": 3, "corner_radius": 1.5, "flute_length": 20, "shank_length": 20 } ],
            "vary": [ { "name": "strategy", "choices": [ { "label": "as it is" },
                { "operations[Fine].kind": "finish5", "operations[Fine].posture": "cm2", "operations[Fine].tool": 7, "machine": "trunnion-ac" } ] },
              { "path": "operations", "values": "orders" } ])");
        QCOMPARE(all.size(), std::size_t(5));
        for (const Candidate& c : all)
            QVERIFY2(c.usable(), c.impossible.c_str());
        QCOMPARE(std::string(operation(all[1], "Fine").kind()), std::string("finish3"));
        QCOMPARE(std::string(operation(all[3], "Fine").kind()), std::string("finish5"));
        QCOMPARE(operation(all[3], "Fine").common().tolerance, 0.3); // both kinds have it
        QCOMPARE(all[1].project->tools.size(), std::size_t(2));      // it serves nothing there
        QCOMPARE(all[3].project->tools.size(), std::size_t(3));
        QCOMPARE(all[2].project->operations[0]->common().name, std::string("Fine"));
        QCOMPARE(candidate_text(job_.study(R"("vary": [ { "path": "machine", "values": ["a", "b"] } ])"),
                                Candidate{{1}, nullptr, {}}),
                 std::string("machine b"));
    }

    void what_does_not_fit_is_told() {
        // Keys of one kind alone: the combinations with another kind are none.
        const auto all = of(R"("vary": [
            { "name": "kind", "choices": [ {}, { "operations[Fine].kind": "finish5", "machine": "trunnion-ac" } ] },
            { "path": "operations[Fine].posture", "values": ["cm2", "local"] } ])");
        QCOMPARE(all.size(), std::size_t(5));
        for (std::size_t i = 0; i < all.size(); ++i)
            QCOMPARE(all[i].usable(), i == 0 || i > 2);
        QVERIFY(all[1].impossible.find("posture") != std::string::npos);
        const std::vector<std::array<std::string, 3>> wrong = {
            {R"("vary": [])", "missing_key", "nothing may vary"},
            {R"("vary": [ { "path": "machine", "values": ["a"] } ])", "missing_key", "nothing may vary"},
            {R"("vary": [ { "path": "machine" } ])", "missing_key", "vary[0]: there are no values"},
            {R"("vary": [ { "path": "operations[Fine].tolerence", "values": [1, 2] } ])", "unknown_key",
             "tolerance"},
            {R"("vary": [ { "path": "operations[None].tool", "values": [1, 2] } ])", "missing_reference",
             "Rough, Fine"},
            {R"("vary": [ { "path": "tools[9].diameter", "values": [1, 2] } ])", "missing_reference", "1, 2"},
            {R"("vary": [ { "path": "nothing.there", "values": [1, 2] } ])", "unknown_key",
             "there is no 'nothing'"},
            {R"("vary": [ { "path": "operations\u005bFine", "values": [1, 2] } ])", "unknown_key",
             "not closed"},
            {R"("vary": [ { "path": "operations[Fine].tool", "values": [1, 2, 5] } ])", "missing_reference",
             "vary[0]: 5"},
            {R"("vary": [ { "path": "operations", "values": [["Rough"], ["Fine", "Rough"]] } ])",
             "missing_reference", "leaves operations out"},
            {R"("vary": [ { "path": "operations[Fine].kind", "values": ["finish3", "finsh"] } ])",
             "out_of_range", "finsh"},
            {R"("vary": [ { "path": "operations[Fine].tool", "values": [1, 2] } ], "wants": 1)",
             "unknown_key", "want"},
            {R"("vary": [ { "path": "operations[Fine].tool", "values": [1, 2] } ], "limits": { "exces_max": 1 })",
             "unknown_key", "excess_max"},
            {R"("vary": [ { "path": "operations[Fine].tool", "values": [1, 2] } ], "limits": { "excess_max": "its" })",
             "wrong_type", "project"},
            {R"("vary": [ { "path": "operations[Fine].tolerance", "from": 0.1, "to": 0.2, "steps": 15000 },
                                { "path": "operations[Rough].tolerance", "from": 0.1, "to": 0.2, "steps": 15000 } ])",
             "limit_exceeded", "samples"},
            {R"("vary": [ { "path": "operations[Fine].tool", "values": [1, 2] } ], "samples": 0)",
             "out_of_range", "samples"},
        };
        for (const auto& [members, code, says] : wrong) {
            std::string message;
            const std::string found = code_of([&] { of(members); }, &message);
            QVERIFY2(found == code && message.find(says) != std::string::npos,
                     (members + "\n" + found + ": " + message).c_str());
        }
        QCOMPARE(code_of([&] { parse_study(R"({ "study": 2, "project": "a" })", "s", job_.project); }),
                 std::string("newer_version"));
    }

    void places_of_several_setups() {
        Json file = Json::parse(R"({ "setups": [
            { "name": "Top", "machine": "a", "operations": [ { "name": "One" }, { "name": "Same" } ] },
            { "name": "Bottom", "machine": "b", "operations": [ { "name": "Two [x]" }, { "name": "Same" } ] } ] })");
        set_at(file, "operations[Two [x]].feed", 5);
        QCOMPARE(file["setups"][1]["operations"][0]["feed"].get<int>(), 5);
        set_at(file, "setups[Top].machine", "c");
        QCOMPARE(file["setups"][0]["machine"].get<std::string>(), std::string("c"));
        set_at(file, "setups[1].operations", Json::parse(R"(["Same", "Two [x]"])"));
        QCOMPARE(file["setups"][1]["operations"][0]["name"].get<std::string>(), std::string("Same"));
        QCOMPARE(code_of([&] { set_at(file, "operations[Same].feed", 1); }), std::string("unknown_key"));
        QCOMPARE(code_of([&] { set_at(file, "machine", "d"); }), std::string("missing_reference"));
    }
};

FACETMILL_TEST(TestCandidates)
#include "test_candidates.moc"
