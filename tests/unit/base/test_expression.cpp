// Arithmetic in fields: against values worked out by hand, and random sums against the same sums in C++.
#include "core/base/error.h"
#include "core/base/expression.h"
#include "core/base/vec.h"
#include "tests/support/error_code.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const NamedLengths names{{"stock.x", 120}, {"part.z", 30}, {"tool.diameter", 6}};

double mm(std::string_view text, LengthUnit unit = LengthUnit::mm) {
    return evaluate(text, Quantity::length, unit, names, "depth");
}

std::string trouble(std::string_view text, Quantity quantity = Quantity::length) {
    std::string message;
    const std::string code =
        code_of([&] { evaluate(text, quantity, LengthUnit::mm, names, "depth"); }, &message);
    return code + ": " + message;
}

/// A random expression over + - * and brackets, and its value.
std::string random_sum(Random& rng, int depth, double& value) {
    if (depth == 0 || uniform(rng, 0, 1) < 0.2) {
        const int n = whole(rng, 1, 99);
        value = n;
        return std::to_string(n);
    }
    double a = 0, b = 0;
    const std::string left = random_sum(rng, depth - 1, a), right = random_sum(rng, depth - 1, b);
    switch (whole(rng, 0, 3)) {
    case 0:
        value = a + b;
        return "(" + left + "+" + right + ")";
    case 1:
        value = a - b;
        return "( " + left + " - " + right + ")";
    case 2:
        value = a * b;
        return left + "*(" + right + ")";
    default:
        value = a / (b * b + 1);
        return "(" + left + ")/((" + right + ")*(" + right + ")+1)";
    }
}

} // namespace

class TestExpression : public QObject {
    Q_OBJECT
private slots:
    void what_people_type() {
        QCOMPARE(mm("25.4/2"), 12.7);
        QCOMPARE(mm("25.4/2", LengthUnit::inch), 12.7 * 25.4);
        QCOMPARE(mm("1/4 in"), 6.35);
        QCOMPARE(mm("1 1/4 in"), 31.75);
        QCOMPARE(mm("1/8\" + 3 mm", LengthUnit::inch), 6.175);
        QCOMPARE(mm("3 mm * 2", LengthUnit::inch), 6.0);
        QCOMPARE(mm("1 in + 2"), 27.4);
        QCOMPARE(mm("= stock.x"), 120.0);
        QCOMPARE(mm("= stock.x / 2 - 1", LengthUnit::inch), 60 - 25.4);
        QCOMPARE(mm("2*tool.diameter"), 12.0);
        QCOMPARE(mm("(1+2)*-3"), -9.0);
        QCOMPARE(mm("-.5"), -0.5);
        QCOMPARE(mm("1e-3"), 1e-3);
        QCOMPARE(mm("stock.x/part.z"), 4.0); // plain, so in the field's unit
        QCOMPARE(mm("2 - 3 - 4"), -5.0);
        QCOMPARE(mm("8/2/2"), 2.0);
        QCOMPARE(evaluate("90/2", Quantity::angle, LengthUnit::mm, names, "a"), radians(45));
        QCOMPARE(evaluate("0.5 rad", Quantity::angle, LengthUnit::mm, names, "a"), 0.5);
        QCOMPARE(evaluate("40 in/min", Quantity::feed, LengthUnit::mm, names, "f"), 1016.0);
        QCOMPARE(evaluate("2*600", Quantity::feed, LengthUnit::mm, names, "f"), 1200.0);
        QCOMPARE(evaluate("40 %", Quantity::ratio, LengthUnit::mm, names, "r"), 0.4);
    }

    void what_is_wrong_is_said() {
        for (const auto& [text, said] :
             {std::pair("25.4/", "missing"), std::pair("1/0", "divides by 0"), std::pair("(1", "not closed"),
              std::pair("1)", "left over"), std::pair("3 4", "sign is missing"), std::pair("5 kg", "no unit"),
              std::pair("stok.x", "stock.x"), std::pair("stock.x*part.z", "multiplied"),
              std::pair("1/stock.x", "divided by a measure"), std::pair("", "missing"),
              std::pair("*2", "out of place"), std::pair("1.2.3", "no number"),
              std::pair("1 mm mm", "left over"), std::pair("1e999", "no")})
            QVERIFY2(trouble(text).find(said) != std::string::npos, trouble(text).c_str());
        QVERIFY(trouble("stock.x", Quantity::angle).find("the field has none") != std::string::npos);
        QVERIFY(trouble("5 mm", Quantity::count).find("no unit") != std::string::npos);
        QVERIFY(trouble(std::string(1000, '(')).find("too many brackets") != std::string::npos);
        QVERIFY(trouble(std::string(1000, '-') + "1").starts_with("wrong_type"));
    }

    void random_sums() {
        Random rng(3);
        for (int trial = 0; trial < 2000; ++trial) {
            double value = 0;
            const std::string text = random_sum(rng, 4, value);
            QVERIFY2(std::abs(mm(text) - value) <= 1e-9 * std::max(1.0, std::abs(value)), text.c_str());
        }
    }
};

FACETMILL_TEST(TestExpression)
#include "test_expression.moc"
