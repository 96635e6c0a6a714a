// Which candidates are looked at, and who wins: whoever finds out what, and in whatever order.
#include "core/study/halving.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

RungResult result_of(double time, std::optional<double> excess, bool passed = true) {
    RungResult r;
    r.measures[Measure::machining_time] = time;
    r.measures[Measure::cusp_max] = 0.1;
    r.measures[Measure::excess_max] = excess;
    r.passed = passed;
    if (!passed) r.why = "failed";
    return r;
}

/// Candidates of which all is known, and what is told of them.
struct KnownStudy {
    Study study;
    std::vector<CandidateState> truth, told;
    std::size_t looks = 0;

    void begin() {
        told.assign(truth.size(), {});
        for (std::size_t i = 0; i < truth.size(); ++i)
            told[i].usable = truth[i].usable;
    }
    void tell(const StudyTask& task) {
        auto& known = told[task.candidate].rungs[std::size_t(task.rung)];
        if (!known) ++looks;
        known = truth[task.candidate].rungs[std::size_t(task.rung)];
    }
    StudyDecision to_the_end() {
        begin();
        for (;;) {
            const StudyDecision d = decide(study, told);
            if (d.missing.empty()) return d;
            for (const StudyTask& t : d.missing)
                tell(t);
        }
    }
};

KnownStudy random_study(std::mt19937& random, std::size_t n) {
    std::uniform_int_distribution<int> small(1, 12), percent(0, 99);
    KnownStudy s;
    s.study.want = {Measure::machining_time, Measure::excess_max};
    s.study.limits = {{Measure::excess_max, 8.0, false}};
    for (std::size_t i = 0; i < n; ++i) {
        CandidateState c;
        c.usable = i == 0 || percent(random) < 90;
        const double time = small(random), excess = small(random);
        const bool passes = percent(random) < 70, coarsely = passes || percent(random) < 20;
        c.rungs = {result_of(time, std::nullopt), result_of(time, excess, coarsely),
                   result_of(time, excess, passes)};
        s.truth.push_back(c);
    }
    return s;
}

bool wins_by_force(const KnownStudy& s, std::optional<std::size_t>& best) {
    best.reset();
    for (std::size_t i = 0; i < s.truth.size(); ++i) {
        const RungResult& r = *s.truth[i].at(Rung::fine);
        if (!s.truth[i].usable || !r.passed || *r.measures[Measure::excess_max] > 8) continue;
        const auto key = [&](std::size_t k) {
            const Measures& m = s.truth[k].at(Rung::fine)->measures;
            return std::pair(*m[Measure::machining_time], *m[Measure::excess_max]);
        };
        if (!best || key(i) < key(*best)) best = i;
    }
    return best.has_value();
}

} // namespace

class TestHalving : public QObject {
    Q_OBJECT
private slots:
    void order_of_answers_makes_no_difference() {
        std::mt19937 random(5);
        for (int round = 0; round < 300; ++round) {
            KnownStudy s = random_study(random, 2 + std::size_t(round % 25));
            const StudyDecision whole = s.to_the_end();
            const std::size_t looks = s.looks;
            // One answer at a time, any of those that are missing; asked again after each.
            s.begin();
            s.looks = 0;
            StudyDecision d = decide(s.study, s.told);
            while (!d.missing.empty()) {
                s.tell(
                    d.missing[std::uniform_int_distribution<std::size_t>(0, d.missing.size() - 1)(random)]);
                d = decide(s.study, s.told);
            }
            QCOMPARE(s.looks, looks);
            QCOMPARE(d.winner, whole.winner);
            QCOMPARE(d.front, whole.front);
            QCOMPARE(d.nearest, whole.nearest);
        }
    }

    void what_nobody_asked_for_changes_nothing() {
        std::mt19937 random(8);
        std::size_t more = 0;
        for (int round = 0; round < 300; ++round) {
            KnownStudy s = random_study(random, 2 + std::size_t(round % 25));
            const StudyDecision whole = s.to_the_end();
            const std::size_t looks = s.looks;
            for (std::size_t i = 0; i < s.truth.size(); ++i)
                for (const Rung rung : all_rungs)
                    if (s.truth[i].usable && random() % 2 == 0) s.tell({i, rung});
            more += s.looks - looks;
            const StudyDecision d = decide(s.study, s.told);
            QVERIFY(d.missing.empty());
            QCOMPARE(d.winner, whole.winner);
            QCOMPARE(d.front, whole.front);
            QCOMPARE(d.nearest, whole.nearest);
            for (std::size_t i = 0; i < s.truth.size(); ++i)
                QVERIFY(d.seen[i].rungs == whole.seen[i].rungs);
        }
        QVERIFY(more > 1000);
    }

    void all_looked_at_is_the_best_of_all() {
        std::mt19937 random(6);
        int won = 0;
        for (int round = 0; round < 300; ++round) {
            KnownStudy s = random_study(random, 1 + std::size_t(round % 20));
            s.study.coarse = s.study.fine = 1;
            const StudyDecision d = s.to_the_end();
            std::optional<std::size_t> best;
            won += wins_by_force(s, best);
            QCOMPARE(d.winner, best);
            QCOMPARE(d.nearest.has_value(), !best);
            for (const std::size_t f : d.front)
                for (const std::size_t g : d.front) {
                    const Measures &a = s.truth[f].at(Rung::fine)->measures,
                                   &b = s.truth[g].at(Rung::fine)->measures;
                    const bool surpassed = *a[Measure::machining_time] <= *b[Measure::machining_time]
                                           && *a[Measure::excess_max] <= *b[Measure::excess_max]
                                           && (*a[Measure::machining_time] < *b[Measure::machining_time]
                                               || *a[Measure::excess_max] < *b[Measure::excess_max]);
                    QVERIFY(!surpassed);
                }
            if (best) QVERIFY(std::find(d.front.begin(), d.front.end(), *best) != d.front.end());
        }
        QVERIFY(won > 100);
    }

    void a_winner_is_found_where_there_is_one() {
        std::mt19937 random(7);
        for (int round = 0; round < 300; ++round) {
            KnownStudy s = random_study(random, 2 + std::size_t(round % 30));
            s.study.coarse = 0.1;
            s.study.fine = 0.05;
            std::optional<std::size_t> best;
            const bool any = wins_by_force(s, best);
            QCOMPARE(s.to_the_end().winner.has_value(), any);
        }
    }

    void worse_ones_are_not_looked_at_closely() {
        KnownStudy s;
        s.study.want = {Measure::machining_time};
        s.study.coarse = 0.5;
        s.study.fine = 0.25;
        for (int i = 0; i < 8; ++i)
            s.truth.push_back(
                {true, {result_of(8 - i, std::nullopt), result_of(8 - i, 1), result_of(8 - i, 1)}});
        const StudyDecision d = s.to_the_end();
        QCOMPARE(d.winner, std::optional<std::size_t>(7));
        QCOMPARE(s.looks,
                 std::size_t(1 + 7 + 4 + 2)); // the project finely, others planned, a half, a quarter
        QVERIFY(s.told[7].at(Rung::fine) && s.told[6].at(Rung::fine) && !s.told[5].at(Rung::fine));
        QVERIFY(s.told[4].at(Rung::coarse) && !s.told[3].at(Rung::coarse));
    }

    /// A coarse look is no proof that a percentile is beyond its limit; of what it has found it is.
    void near_a_limit_a_fine_look_decides() {
        for (const Measure m : {Measure::excess_p99, Measure::excess_p95, Measure::peak_load, Measure::wear,
                                Measure::uncut_share, Measure::excess_max, Measure::gouge_max})
            for (const double coarsely : {1.0, 1.05, 1.3}) {
                KnownStudy s;
                s.study.want = {Measure::machining_time};
                s.study.limits = {{m, 1, true}};
                for (const double time : {9.0, 5.0}) {
                    CandidateState c;
                    for (auto& look : c.rungs)
                        look = result_of(time, 0.1);
                    c.rungs[1]->measures[m] = coarsely * 0.1;
                    c.rungs[2]->measures[m] = 0.1;
                    s.truth.push_back(c);
                }
                const bool found = m == Measure::excess_max || m == Measure::gouge_max;
                const bool open = coarsely == 1 || (coarsely < 1.1 && !found);
                QCOMPARE(s.to_the_end().winner, std::optional<std::size_t>(open ? 1 : 0));
                // And what it says itself counts at the end.
                s.truth[1].rungs[2]->measures[m] = 0.101;
                QCOMPARE(s.to_the_end().winner, std::optional<std::size_t>(0));
            }
    }

    /// That the project meets the limits is no reason to look at no others.
    void the_next_ones_come_where_the_project_alone_passes() {
        KnownStudy s;
        s.study.want = {Measure::machining_time, Measure::excess_max};
        s.study.coarse = s.study.fine = 0.1;
        s.truth.push_back({true, {result_of(9, std::nullopt), result_of(9, 1), result_of(9, 1)}});
        for (auto& look : s.truth[0].rungs) // with the smallest cusp: one of the first that are looked at
            look->measures[Measure::cusp_max] = 0.05;
        for (int i = 1; i < 20; ++i) { // the fastest do not pass, the last ones are no faster
            const bool passes = i >= 12;
            s.truth.push_back({true,
                               {result_of(i < 16 ? i * 0.5 : 9.5, std::nullopt),
                                result_of(i * 0.5, 1, passes), result_of(i * 0.5, 1, passes)}});
        }
        QCOMPARE(s.to_the_end().winner, std::optional<std::size_t>(12));
        for (int i = 12; i < 16; ++i)
            s.truth[std::size_t(i)].rungs[1]->passed = s.truth[std::size_t(i)].rungs[2]->passed = false;
        QCOMPARE(s.to_the_end().winner, std::optional<std::size_t>(0));
        for (int i = 1; i < 16; ++i)
            QVERIFY(s.told[std::size_t(i)].at(Rung::coarse));
        QVERIFY(!s.told[19].at(Rung::coarse)); // it takes longer than the project
    }

    void limits_are_told_and_the_nearest_is_named() {
        KnownStudy s;
        s.study.want = {Measure::machining_time};
        s.study.limits = {{Measure::excess_max, 1, true}, {Measure::machining_time, 2, false}};
        s.truth.push_back({true, {result_of(9, std::nullopt), result_of(9, 0.2), result_of(9, 0.2)}});
        s.truth.push_back({true, {result_of(3, std::nullopt), result_of(3, 0.2), result_of(3, 0.2)}});
        s.truth.push_back({true, {result_of(1, std::nullopt), result_of(1, 0.5), result_of(1, 0.5)}});
        StudyDecision d = s.to_the_end();
        QVERIFY(!d.winner && d.front.empty());
        QCOMPARE(d.nearest, std::optional<std::size_t>(1)); // half over; the other one is by one and a half
        QCOMPARE(missed_limits(*s.told[2].last(), Rung::coarse, d.limits),
                 std::string("excess_max is 0.5, at most 0.2 is allowed"));
        // As the project itself is the limit, it meets that.
        s.study.limits = {{Measure::excess_max, 1, true}};
        d = s.to_the_end();
        QCOMPARE(d.winner, std::optional<std::size_t>(1));
        // What the project comes to is no limit where it does not come to it.
        s.truth[0].rungs[2] = RungResult{{}, false, "out of reach"};
        std::string message;
        QCOMPARE(code_of([&] { s.to_the_end(); }, &message), std::string("missing_reference"));
        QVERIFY(message.find("out of reach") != std::string::npos);
    }
};

FACETMILL_TEST(TestHalving)
#include "test_halving.moc"
