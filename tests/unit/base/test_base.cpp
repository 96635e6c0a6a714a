// The base room: errors, units, parameters, progress, loops, files.
#include "core/base/figures.h"
#include "core/base/file.h"
#include "core/base/parallel.h"
#include "core/base/parameter.h"
#include "core/base/plane_geometry.h"
#include "core/base/turn.h"
#include "core/base/usual_value.h"
#include "core/base/vec.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

using namespace facetmill;
using facetmill::test::code_of;

namespace {

struct Spot {
    std::array<double, 3> place{0, 0, 0};
    double size = 1;
    bool operator==(const Spot&) const = default;
};

const ParameterTable<Spot>& spot_parameters() {
    static const auto t = [] {
        ParameterTable<Spot> p;
        p.add(&Spot::place, {.key = "place",
                             .kind = ParameterKind::triple,
                             .quantity = Quantity::length,
                             .required = "say where"});
        p.add(&Spot::size, {.key = "size", .quantity = Quantity::length, .minimum = 0, .maximum = 10});
        return p;
    }();
    return t;
}

constexpr RecordList<Spot> spot_list{"spots", spot_parameters};

struct Sample {
    double length = 2.0;
    NumberOrWord step{0.0, "auto"};
    long count = 3;
    bool flag = true;
    std::string name = "a";
    std::array<double, 2> limits{0.0, 0.5};
    enum class Kind { box, round } kind = Kind::round;
    std::string off;
    std::vector<Spot> spots;
};

const ParameterTable<Sample>& table() {
    static const auto t = [] {
        using K = ParameterKind;
        ParameterTable<Sample> p;
        p.add(&Sample::length, {.key = "length",
                                .label = "Length",
                                .quantity = Quantity::length,
                                .minimum = 0,
                                .maximum = 254,
                                .open_minimum = true});
        p.add(&Sample::step, {.key = "step",
                              .kind = K::number_or_word,
                              .quantity = Quantity::length,
                              .minimum = 0,
                              .words = {"auto", "adaptive"}});
        p.add(&Sample::count, {.key = "count", .kind = K::integer, .minimum = 1, .maximum = 9});
        p.add(&Sample::flag, {.key = "flag", .kind = K::boolean});
        p.add(&Sample::name, {.key = "name", .kind = K::text});
        p.add(&Sample::limits, {.key = "limits",
                                .kind = K::pair,
                                .quantity = Quantity::angle,
                                .minimum = 0,
                                .maximum = pi / 2,
                                .ordered = true});
        p.add_choice(&Sample::kind, {.key = "kind", .words = {"box", "round"}});
        p.add(&Sample::off, {.key = "off", .kind = K::names, .nouns = {"strip", "strips"}});
        p.add_records(&Sample::spots, spot_list, {.label = "Spots", .nouns = {"spot", "spots"}});
        return p;
    }();
    return t;
}

} // namespace

class TestBase : public QObject {
    Q_OBJECT
private slots:
    /// One direction ends in the other by the shortest turn, close to the opposite one and at it, too.
    void directions_turn_into_each_other() {
        std::mt19937 random(7);
        std::normal_distribution<double> normal;
        const auto direction = [&] {
            return Vec3(normal(random), normal(random), normal(random)).normalized();
        };
        double worst = 0;
        const auto check = [&](const Vec3& from, const Vec3& to) {
            const Eigen::Quaterniond q = turn_between(from, to);
            worst = std::max({worst, std::abs(q.norm() - 1), (q * from.normalized() - to.normalized()).norm(),
                              std::abs(2 * std::atan2(q.vec().norm(), q.w()) - angle_between(from, to))});
        };
        for (int i = 0; i < 20000; ++i) {
            const Vec3 from = (0.1 + i) * direction();
            check(from, direction());
            check(from, from);
            check(from, -from);
            check(from, -from.normalized() + std::pow(10.0, -1 - i % 16) * direction());
        }
        for (int k = 0; k < 3; ++k)
            for (const double sign : {-1.0, 1.0}) {
                const Vec3 from = sign * Vec3::Unit(k);
                check(from, -from);
                // Half way round about Z, and the upright one about X.
                const Vec3 axis = turn_between(from, -from).vec();
                QVERIFY(axis.cwiseAbs() == (k == 2 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ())));
            }
        QVERIFY2(worst < 1e-11, qPrintable(QString::number(worst)));
    }

    void principal_forms_are_eigenvectors() {
        std::mt19937 random(8);
        std::normal_distribution<double> normal;
        double worst = 0;
        const auto check = [&](double xx, double xy, double yy) {
            const PrincipalForm p = principal_form(xx, xy, yy);
            const double size = std::max({std::abs(xx), std::abs(xy), std::abs(yy)});
            const Vec2 high(std::cos(p.angle), std::sin(p.angle)), low(-high.y(), high.x());
            const auto form = [&](const Vec2& v) {
                return Vec2(xx * v.x() + xy * v.y(), xy * v.x() + yy * v.y());
            };
            QVERIFY(p.high >= p.low);
            const double off = (form(high) - p.high * high).norm() + (form(low) - p.low * low).norm();
            if (off > 0) worst = std::max(worst, off / size);
        };
        for (int i = 0; i < 20000; ++i)
            check(normal(random), std::pow(10.0, -(i % 20)) * normal(random), normal(random));
        check(0, 0, 0);
        check(2, 0, 2);
        check(-3, 0, 5);
        check(1, -4, 1);
        QVERIFY2(worst < 1e-14, qPrintable(QString::number(worst)));
    }

    /// In a row, as in loops over vertices, where the compiler converts two at once.
    void vectors_are_rounded_to_floats() {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> number(-100, 100);
        std::vector<Vec3> exact(300), rounded;
        for (Vec3& v : exact)
            v = Vec3(number(random), number(random), number(random));
        rounded = exact;
        for (Vec3& v : rounded)
            v = rounded_to_float(v);
        for (std::size_t i = 0; i < exact.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const double r = rounded[i][k];
                QCOMPARE(std::bit_cast<std::uint64_t>(r) & ((std::uint64_t(1) << 29) - 1), std::uint64_t(0));
                QVERIFY(std::abs(r - exact[i][k]) <= std::ldexp(std::abs(exact[i][k]), -24));
            }
    }

    void numbers_parse_strictly() {
        double v = 0;
        for (const char* good : {"1", "+1.5", "-.5", "1e3", "1E-3", "0", "-0", "5."})
            QVERIFY2(parse_number(good, v), good);
        for (const char* bad :
             {"", "+", "-", "1,5", "0x10", "inf", "nan", "-inf", "1.5mm", " 1", "1 ", "+-1", "1e999", "e5"})
            QVERIFY2(!parse_number(bad, v), bad);
    }

    void numbers_round_trip() {
        std::mt19937_64 rng(1);
        std::uniform_real_distribution<double> mantissa(-1, 1), exponent(-7, 12);
        for (int i = 0; i < 20000; ++i) {
            const double v = mantissa(rng) * std::pow(10.0, exponent(rng));
            double back = 0;
            QVERIFY(parse_number(format_number(v, 9), back));
            QVERIFY(std::abs(back - v) <= 1e-8 * std::abs(v));
        }
        QCOMPARE(format_number(0.25), std::string("0.25"));
        QCOMPARE(format_number(-0.0), std::string("0"));
        QCOMPARE(format_number(100000.0), std::string("100000"));
    }

    void figures_have_a_floor() {
        QCOMPARE(percent_text(0), std::string("0 %"));
        QCOMPARE(percent_text(6.08e-8), std::string("< 0.01 %"));
        QCOMPARE(percent_text(1e-4), std::string("0.01 %"));
        QCOMPARE(percent_text(0.12345), std::string("12.3 %"));
        QCOMPARE(percent_text(0.12345, 2), std::string("12 %"));
        QCOMPARE(length_text(6.08e-8, LengthUnit::mm), std::string("< 0.0001 mm"));
        QCOMPARE(length_text(-6.08e-8, LengthUnit::mm), std::string("> -0.0001 mm"));
        QCOMPARE(length_text(1e-14, LengthUnit::mm), std::string("0 mm"));
        QCOMPARE(length_text(1e-4, LengthUnit::mm), std::string("0.0001 mm"));
        QCOMPARE(length_text(1e-4, LengthUnit::inch), std::string("< 0.00001 in"));
        QCOMPARE(length_text(0.02, LengthUnit::inch), std::string("0.0007874 in"));
        QCOMPARE(coordinate_text(-1.2e-16), std::string("0"));
        QCOMPARE(coordinate_text(12.345678), std::string("12.346"));
        QCOMPARE(coordinate_text(4.1234e-7), std::string("0"));
    }

    void parameters_read_in_units() {
        Sample s;
        ParameterView<Sample> view(s, table());
        view.set("length", view.parameter("length").parse("2", LengthUnit::inch));
        QCOMPARE(s.length, 50.8);
        view.set("limits", view.parameter("limits").parse("[0, 45]", LengthUnit::inch));
        QVERIFY(std::abs(s.limits[1] - pi / 4) < 1e-15);
        view.set("step", view.parameter("step").parse("adaptive", LengthUnit::mm));
        QVERIFY(s.step.is("adaptive"));
        view.set("step", view.parameter("step").parse("0.5", LengthUnit::inch));
        QVERIFY(s.step.is_number() && s.step.number == 12.7);
        view.set("kind", view.parameter("kind").parse("box", LengthUnit::mm));
        QVERIFY(s.kind == Sample::Kind::box);
        QCOMPARE(std::get<std::string>(view.get("kind")), std::string("box"));
        for (const auto* p : view.parameters()) // text form reads back to the same value
            QVERIFY2(
                p->value_text(p->parse(p->value_text(view.get(p->key), LengthUnit::inch), LengthUnit::inch),
                              LengthUnit::inch)
                    == p->value_text(view.get(p->key), LengthUnit::inch),
                p->key.c_str());
    }

    void lists_of_records_are_parameters() {
        Sample s;
        ParameterView<Sample> view(s, table());
        const ParameterInfo& info = view.parameter("spots");
        QVERIFY(info.is_list() && info.record.size() == 2);
        QCOMPARE(info.count_text(view.get("spots")), std::string("none"));
        // As structs, as values and as text.
        const std::vector<Spot> two{{{25.4, 0, -2.54}, 1}, {{0, 0, 1}, 5.08}};
        QVERIFY(spot_list.is_in(view));
        spot_list.set(view, two);
        QVERIFY(s.spots == two && spot_list.of(view) == two);
        QCOMPARE(info.count_text(view.get("spots")), std::string("2 spots"));
        const std::string text = info.value_text(view.get("spots"), LengthUnit::inch);
        QVERIFY2(text.starts_with(R"([{"place":[1,0,-0.1],"size":)"), text.c_str());
        QCOMPARE(info.value_text(info.parse(text, LengthUnit::inch), LengthUnit::inch), text);
        QVERIFY(info.parse(info.value_text(view.get("spots"), LengthUnit::mm), LengthUnit::mm)
                == view.get("spots"));
        view.set("spots", info.parse(R"( [{ "place": [1, 2, 3] }] )", LengthUnit::mm));
        QVERIFY((s.spots == std::vector<Spot>{{{1, 2, 3}, 1}})); // the size has its default
        QCOMPARE(info.count_text(view.get("spots")), std::string("1 spot"));
        view.set("spots", info.empty_list());
        QVERIFY(s.spots.empty() && info.parse("[]", LengthUnit::mm) == info.empty_list());

        const ParameterInfo& off = view.parameter("off");
        QCOMPARE(off.count_text(std::string(" V1,V 2 , ,")), std::string("2 strips"));
        QCOMPARE(off.count_text(std::string("V1")), std::string("1 strip"));
        QVERIFY(off.empty_list() == view.get("off"));

        // Who has no such list has none of it.
        Spot spot;
        const ParameterView<Spot> other(spot, spot_parameters());
        QVERIFY(!spot_list.is_in(other) && spot_list.of(other).empty());
    }

    void bad_records_are_refused_and_change_nothing() {
        Sample s;
        s.spots = {{{1, 2, 3}, 4}};
        ParameterView<Sample> view(s, table());
        const ParameterInfo& info = view.parameter("spots");
        const auto wrong = [&](const std::string& text, const char* code, const char* where) {
            try {
                view.set("spots", info.parse(text, LengthUnit::mm));
            } catch (const Error& e) {
                return code_name(e.code()) == code && e.where() == where;
            }
            return false;
        };
        QVERIFY(wrong("7", "wrong_type", "spots"));
        QVERIFY(wrong("[7]", "wrong_type", "spots[0]"));
        QVERIFY(wrong("[{}]", "missing_key", "spots[0].place"));
        QVERIFY(wrong(R"([{"place": [0, 0]}])", "wrong_type", "spots[0].place"));
        QVERIFY(wrong(R"([{"place": [0, 0, 0]}, {"place": [0, 0, 0], "size": 11}])", "out_of_range",
                      "spots[1].size"));
        QVERIFY(wrong(R"([{"place": [0, 0, 0], "sise": 1}])", "unknown_key", "spots[0].sise"));
        // In code, too.
        QCOMPARE(code_of([&] { spot_list.set(view, {{{0, 0, 0}, -1}}); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { view.set("spots", 1.0); }), std::string("wrong_type"));
        QCOMPARE(code_of([&] { view.set("spots", ParameterRecords{{{1.0}}}); }), std::string("wrong_type"));
        QVERIFY((s.spots == std::vector<Spot>{{{1, 2, 3}, 4}}));
        s.spots[0].size = 11;
        try {
            info.check(view.get("spots"));
            QFAIL("no error");
        } catch (const Error& e) {
            QCOMPARE(e.where(), std::string("spots[0].size"));
        }
    }

    void what_is_not_described_cannot_be_described_otherwise() {
        ParameterTable<Spot> t = spot_parameters();
        t.set_help("size", "How wide it is.").set_stage("size", Stage::link);
        QCOMPARE(t.find("size")->info.help, std::string("How wide it is."));
        QVERIFY(t.find("size")->info.stage == Stage::link);
        QCOMPARE(code_of([&] { t.set_help("sise", "No."); }), std::string("unknown_key"));
        QCOMPARE(code_of([&] { t.set_stage("sise", Stage::link); }), std::string("unknown_key"));
    }

    void bad_values_are_refused_and_change_nothing() {
        Sample s;
        ParameterView<Sample> view(s, table());
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(code_of([&] { view.set("length", 0.0); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { view.set("length", -1.0); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { view.set("length", nan); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { view.set("length", infinity); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { view.set("length", std::string("2")); }), std::string("wrong_type"));
        QCOMPARE(code_of([&] { view.set("count", 2.0); }), std::string("wrong_type"));
        QCOMPARE(code_of([&] { view.set("count", 10L); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { view.set("step", std::string("adaptiv")); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] {
                     view.set("limits", std::array<double, 2>{0.5, 0.5});
                 }),
                 std::string("out_of_range"));
        QCOMPARE(code_of([&] { view.set("kind", std::string("cone")); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { view.set("lenght", 1.0); }), std::string("unknown_key"));
        QCOMPARE(code_of([&] { view.parameter("count").parse("1.5", LengthUnit::mm); }),
                 std::string("wrong_type"));
        QCOMPARE(s.length, 2.0);
        QCOMPARE(s.count, 3L);
        try {
            view.set("lenght", 1.0);
            QFAIL("no error");
        } catch (const Error& e) {
            QVERIFY2(std::string(e.what()).find("did you mean 'length'") != std::string::npos, e.what());
        }
        try {
            view.parameter("length").parse("11", LengthUnit::inch);
            QFAIL("no error");
        } catch (const Error& e) {
            QVERIFY2(std::string(e.what()).find("at most 10 in") != std::string::npos, e.what());
        }
    }

    /// Bounds that are round in one unit are told in the other by three digits, and no wider than they are.
    void ranges_are_round() {
        ParameterInfo info;
        info.quantity = Quantity::length;
        info.minimum = 0;
        info.maximum = 1000;
        QCOMPARE(info.range_text(LengthUnit::mm), std::string("0 to 1000 mm"));
        QCOMPARE(info.range_text(LengthUnit::inch), std::string("0 to 39.3 in"));
        info.open_minimum = true;
        info.maximum = 100000;
        QCOMPARE(info.range_text(LengthUnit::inch), std::string("above 0 in and at most 3930 in"));
        info.open_minimum = false;
        info.minimum = -10;
        info.maximum = 25.4;
        QCOMPARE(info.range_text(LengthUnit::inch), std::string("-0.393 to 1 in"));
        info.maximum = infinity;
        info.minimum = 0.01;
        QCOMPARE(info.range_text(LengthUnit::inch), std::string("at least 0.000394 in"));
        info.quantity = Quantity::angle;
        info.minimum = 0;
        info.maximum = pi / 4;
        QCOMPARE(info.range_text(LengthUnit::inch), std::string("0 to 45 °"));
        // What is no length is told as it is.
        info.maximum = radians(89.9427);
        QCOMPARE(info.range_text(LengthUnit::inch), std::string("0 to 89.9427 °"));
        info.quantity = Quantity::count;
        info.maximum = 99999;
        QCOMPARE(info.range_text(LengthUnit::inch), std::string("0 to 99999"));
    }
    void usual_values_are_round() {
        ParameterInfo info;
        info.quantity = Quantity::length;
        info.default_value = 1.0;
        QCOMPARE(std::get<double>(usual_value(info, LengthUnit::mm)), 1.0);
        QCOMPARE(std::get<double>(usual_value(info, LengthUnit::inch)), 0.04 * mm_per_inch);
        info.maximum = 1.0; // a wider one is not allowed
        QCOMPARE(std::get<double>(usual_value(info, LengthUnit::inch)), 1.0);
        info.maximum = infinity;
        info.default_value = std::array<double, 3>{40, -20, 0};
        const auto three = std::get<std::array<double, 3>>(usual_value(info, LengthUnit::inch));
        QVERIFY(std::abs(three[0] / mm_per_inch - 2) < 1e-12
                && std::abs(three[1] / mm_per_inch + 0.8) < 1e-12);
        QCOMPARE(three[2], 0.0);
        info.default_value = std::string("auto");
        QCOMPARE(std::get<std::string>(usual_value(info, LengthUnit::inch)), std::string("auto"));
        info.quantity = Quantity::angle;
        info.default_value = 0.7;
        QCOMPARE(std::get<double>(usual_value(info, LengthUnit::inch)), 0.7);
        const std::pair<double, double> rounded[] = {
            {0.0393, 0.04}, {39.37, 40}, {0.00197, 0.002}, {9.7, 10}, {-0.0787, -0.08}};
        for (const auto& [v, round] : rounded)
            QVERIFY(std::abs(round_to_digit(v) / round - 1) < 1e-12);
    }

    void progress_is_monotone_and_shares_the_flag() {
        Job job;
        const Progress p(job);
        const Progress half = p.part(0.5, 1.0, "second");
        QCOMPARE(job.fraction(), 0.5);
        QCOMPARE(job.label(), std::string("second"));
        Progress(job).task("Finish (2 of 3)");
        QCOMPARE(job.label(), std::string("Finish (2 of 3)"));
        Progress(job).part(0, 1, "Looking");
        QCOMPARE(job.label(), std::string("Finish (2 of 3): Looking"));
        Progress(job).task({});
        QCOMPARE(job.label(), std::string());
        p.part(0.0, 0.5).set(0.3); // an earlier interval must not pull the bar back
        QCOMPARE(job.fraction(), 0.5);
        half.set(0.5);
        QCOMPARE(job.fraction(), 0.75);
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(half.part(0.1, 0.2).check(), Cancelled);
        Progress().check();
    }

    void a_job_is_cancelled_where_it_was_told() {
        Job job;
        job.cancel_at(0.4);
        const Progress p(job);
        p.set(0.39);
        QVERIFY(!job.cancelled());
        QVERIFY_EXCEPTION_THROWN(p.set(0.4), Cancelled);
        Job late;
        Progress(late).set(0.5);
        late.cancel_at(0.5);
        QVERIFY(late.cancelled());
    }

    void loops_are_deterministic_and_cancellable() {
        std::vector<double> values(100001);
        std::mt19937_64 rng(7);
        for (double& v : values)
            v = std::ldexp(double(rng() % 1000003), int(rng() % 60) - 30);
        const auto sum = [&] {
            return parallel_reduce(
                values.size(), 1000, 0.0, Progress(),
                [&](std::size_t b, std::size_t e) {
                    double s = 0;
                    for (; b < e; ++b)
                        s += values[b];
                    return s;
                },
                [](double a, double b) { return a + b; });
        };
        set_thread_count(1);
        const double one = sum();
        for (int n : {2, 3, 0}) {
            set_thread_count(n);
            QCOMPARE(sum(), one);
        }
        std::vector<int> seen(1237, 0);
        parallel_for(seen.size(), 10, Progress(), [&](std::size_t i) { ++seen[i]; });
        QVERIFY(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));

        Job job;
        std::thread canceller([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            job.cancel();
        });
        QVERIFY_EXCEPTION_THROWN(
            parallel_for(100000, 1, Progress(job),
                         [](std::size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }),
            Cancelled);
        canceller.join();
        QCOMPARE(code_of([&] {
                     parallel_for(1000, 1, Progress(), [](std::size_t i) {
                         if (i == 500) throw Error(ErrorCode::not_stl, "", "x", "");
                     });
                 }),
                 std::string("not_stl"));
    }

    void loops_may_run_within_loops_and_beside_others() {
        constexpr std::size_t outer = 37, inner = 53;
        const auto sums = [&] {
            std::vector<std::size_t> sum(outer);
            parallel_for(outer, 1, Progress(), [&](std::size_t i) {
                std::vector<std::size_t> part(inner);
                parallel_for(inner, 5, Progress(), [&](std::size_t k) { part[k] = i * k; });
                sum[i] = std::accumulate(part.begin(), part.end(), std::size_t(0));
            });
            return sum;
        };
        std::array<bool, 3> right{};
        std::vector<std::thread> callers;
        for (bool& r : right)
            callers.emplace_back([&r, &sums] {
                for (int round = 0; round < 20; ++round) {
                    const auto sum = sums();
                    for (std::size_t i = 0; i < outer; ++i)
                        if (sum[i] != i * (inner * (inner - 1) / 2)) return;
                }
                r = true;
            });
        for (std::thread& c : callers)
            c.join();
        QVERIFY(std::all_of(right.begin(), right.end(), [](bool r) { return r; }));
        // What fails within a loop within a loop comes out, and loops go on working after it.
        QCOMPARE(code_of([&] {
                     parallel_for(outer, 1, Progress(), [&](std::size_t) {
                         parallel_for(inner, 1, Progress(), [](std::size_t k) {
                             if (k == 50) throw Error(ErrorCode::not_stl, "", "x", "");
                         });
                     });
                 }),
                 std::string("not_stl"));
        QCOMPARE(sums().size(), outer);
    }

    void outputs_appear_whole_or_not_at_all() {
        QTemporaryDir dir;
        const std::filesystem::path folder = dir.path().toStdString();
        const auto entries = [&] {
            return std::distance(std::filesystem::directory_iterator(folder),
                                 std::filesystem::directory_iterator());
        };
        {
            OutputFile file(folder / "a.txt");
            file.write("half");
        }
        QCOMPARE(entries(), 0);
        {
            OutputFile file(folder / "a.txt");
            file.write("whole");
            file.commit();
        }
        QCOMPARE(entries(), 1);
        QCOMPARE(std::string(InputFile(folder / "a.txt").bytes()), std::string("whole"));
        QCOMPARE(code_of([&] { OutputFile f(folder / "no" / "b.txt"); }), std::string("unwritable"));
        QCOMPARE(code_of([&] { OutputFile f(folder); }), std::string("unwritable"));
        QCOMPARE(code_of([&] { InputFile f(folder); }), std::string("is_directory"));
        QCOMPARE(code_of([&] { InputFile f(folder / "none"); }), std::string("not_found"));
        QCOMPARE(code_of([&] { InputFile f("/dev/zero"); }), std::string("unreadable"));
        std::ofstream(folder / "empty").close();
        QCOMPARE(code_of([&] { InputFile f(folder / "empty"); }), std::string("empty_file"));
        {
            OutputSet set;
            set.add(folder / "x").write("1");
            set.add(folder / "y").write("2");
        }
        QVERIFY(!std::filesystem::exists(folder / "x"));
        QCOMPARE(code_of([&] { OutputFile f("/dev/null"); }), std::string("unwritable"));
        QCOMPARE(code_of([&] {
                     OutputSet set;
                     set.add(folder / "x");
                     set.add(folder / "x");
                 }),
                 std::string("unwritable"));
    }

    void a_set_puts_back_what_was_there() {
        QTemporaryDir dir;
        const std::filesystem::path folder = dir.path().toStdString();
        const auto entries = [&] {
            return std::distance(std::filesystem::directory_iterator(folder),
                                 std::filesystem::directory_iterator());
        };
        const auto text = [&](const char* name) { return std::string(InputFile(folder / name).bytes()); };
        const auto write_both = [&](const std::string& content, bool block) {
            OutputSet set;
            set.add(folder / "new").write(content);
            set.add(folder / "old").write(content);
            set.add(folder / "z").write(content);
            // A folder that appears meanwhile: the last rename cannot succeed.
            if (block) std::filesystem::create_directories(folder / "z" / "in");
            set.commit();
        };
        std::ofstream(folder / "old") << "before";
        QCOMPARE(code_of([&] { write_both("after", true); }), std::string("unwritable"));
        QCOMPARE(text("old"), std::string("before"));
        QCOMPARE(entries(), 2); // "old" and the folder
        std::filesystem::remove_all(folder / "z");
        write_both("after", false);
        QCOMPARE(text("old"), std::string("after"));
        QCOMPARE(text("new"), std::string("after"));
        QCOMPARE(entries(), 3);
    }

    void an_abandoned_process_leaves_nothing() {
        QTemporaryDir dir;
        const std::filesystem::path folder = dir.path().toStdString();
        const auto exit_status = [&](bool commit) {
            const pid_t child = ::fork();
            if (child == 0) { // the lock is never given back: in a process of its own
                const std::size_t before = committed_outputs();
                OutputFile half(folder / "half");
                half.write("1");
                if (commit) {
                    OutputFile done(folder / "done");
                    done.commit();
                }
                const bool abandoned = abandon_outputs(before);
                // Only a process that was not told to end may still commit.
                if (!abandoned) half.commit();
                ::_exit(abandoned ? 7 : 8);
            }
            int status = 0;
            return ::waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        };
        const auto names = [&] {
            QStringList all;
            for (const auto& entry : std::filesystem::directory_iterator(folder))
                all << QString::fromStdString(entry.path().filename().string());
            all.sort();
            return all;
        };
        QCOMPARE(exit_status(false), 7);
        QCOMPARE(names(), QStringList());
        QCOMPARE(exit_status(true), 8);
        QCOMPARE(names(), (QStringList{"done", "half"}));
    }

    void links_lead_to_their_file() {
        QTemporaryDir dir;
        const std::filesystem::path folder = dir.path().toStdString();
        std::ofstream(folder / "real") << "1";
        std::filesystem::create_symlink("real", folder / "link");
        OutputFile file(folder / "link");
        file.write("2");
        file.commit();
        QVERIFY(std::filesystem::is_symlink(folder / "link"));
        QCOMPARE(std::string(InputFile(folder / "real").bytes()), std::string("2"));
    }

    void near_names_are_found() {
        const std::vector<std::string> known = {"tool", "tolerance", "stepover", "feed"};
        QCOMPARE(nearest_name("tol", known), std::string("tolerance"));
        QCOMPARE(nearest_name("toool", known), std::string("tool"));
        QCOMPARE(nearest_name("step_over", known), std::string("stepover"));
        QCOMPARE(nearest_name("spindle", known), std::string());
    }

    void messages_stay_on_one_line() {
        QCOMPARE(printable("a\nb\x01\xff"
                           "c"),
                 std::string("a?b??c"));
        QCOMPARE(printable("d\xc3\xa9j\xc3\xa0"), std::string("d\xc3\xa9j\xc3\xa0"));
        QVERIFY(printable(std::string(1000, 'x')).size() < 100);
        const Error e = Error(ErrorCode::wrong_type, "tolerance", "bad", "fix it").within("file");
        QCOMPARE(std::string(e.what()), std::string("file: tolerance: bad (fix it)"));
    }
};

FACETMILL_TEST(TestBase)
#include "test_base.moc"
