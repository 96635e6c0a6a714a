// Recipes as plain data: what they refuse, and files.
#include "core/repair/recipe.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Kind = RepairStep::Kind;

std::string refusal(const RepairStep& step, std::string* message = nullptr) {
    return code_of([&] { check_recipe({step}, "part.repair"); }, message);
}

std::string written(QTemporaryDir& folder, const QByteArray& text) {
    const QString path = folder.filePath("recipe.json");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return {};
    file.write(text);
    return path.toStdString();
}

} // namespace

class TestRecipe : public QObject {
    Q_OBJECT
private slots:
    void a_step_says_what_it_needs() {
        std::string message;
        for (const Kind kind : {Kind::pieces, Kind::needles, Kind::smooth, Kind::decimate, Kind::thicken,
                                Kind::join, Kind::fins, Kind::crossings})
            QCOMPARE(refusal({.kind = kind}, &message), std::string("missing_key"));
        QVERIFY(message.find("part.repair[0].size") != std::string::npos);
        for (const Kind kind : {Kind::turn, Kind::holes, Kind::cut})
            QCOMPARE(refusal({.kind = kind}), std::string("none"));
    }

    void what_a_step_does_not_read_is_refused() {
        RepairStep step{.kind = Kind::turn};
        step.size = 3;
        QCOMPARE(refusal(step), std::string("out_of_range"));
        step = {.kind = Kind::cut};
        step.normal = {0, 0, 0};
        QCOMPARE(refusal(step), std::string("missing_key"));
        step = {.kind = Kind::smooth};
        step.bound = -1;
        QCOMPARE(refusal(step), std::string("out_of_range"));
        step.bound = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(refusal(step), std::string("out_of_range"));
    }

    void every_kind_has_keys_that_there_are() {
        for (int k = 0; k <= int(Kind::fins); ++k)
            for (const std::string& key : repair_keys(Kind(k)))
                QVERIFY(repair_step_parameters().find(key) != nullptr);
    }

    void a_file_is_read_in_its_unit() {
        QTemporaryDir folder;
        const auto recipe = load_recipe(written(
            folder,
            R"({"units": "in", "repair": [{"kind": "holes", "size": 1, "fill": "flat"}, {"kind": "turn"},
                        {"kind": "pieces", "area": 1}]})"));
        QCOMPARE(recipe.size(), std::size_t(3));
        QCOMPARE(recipe[0].size, 25.4);
        QVERIFY(recipe[0].fill == RepairStep::Fill::flat);
        QVERIFY(recipe[1].kind == Kind::turn);
        QVERIFY(std::abs(recipe[2].area - 25.4 * 25.4) < 1e-9);
    }

    void bad_files_name_the_place() {
        QTemporaryDir folder;
        const auto code = [&](const char* text) {
            const std::string path = written(folder, text);
            return code_of([&] { load_recipe(path); });
        };
        QCOMPARE(code(R"({"repair": [{"kind": "hols"}]})"), std::string("out_of_range"));
        QCOMPARE(code(R"({"repair": [{"size": 3}]})"), std::string("missing_key"));
        QCOMPARE(code(R"({"repair": [{"kind": "holes", "siez": 3}]})"), std::string("unknown_key"));
        QCOMPARE(code(R"({"repair": {}})"), std::string("wrong_type"));
        QCOMPARE(code(R"({"steps": []})"), std::string("unknown_key"));
        QCOMPARE(code(R"({})"), std::string("missing_key"));
        QCOMPARE(code(R"([])"), std::string("wrong_type"));
        QCOMPARE(code("{"), std::string("truncated"));
    }
};

FACETMILL_TEST(TestRecipe)
#include "test_recipe.moc"
