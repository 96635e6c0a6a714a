// What a recipe begins with, and what becomes of holes.
#include "core/repair/suggestion.h"
#include "tests/support/test_runner.h"
#include "tests/unit/repair/repair_support.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Kind = RepairStep::Kind;

/// A grid of n x n squares of 1 mm in the plane z, without the squares from `from` to `to` both ways.
void add_sheet(Mesh& mesh, std::size_t n, double x, double z, std::size_t from = 0, std::size_t to = 0) {
    const auto first = Index(mesh.vertices.size());
    for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i)
            mesh.vertices.emplace_back(x + double(i), double(j), z);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            if (i >= from && i < to && j >= from && j < to) continue;
            const auto a = Index(first + j * (n + 1) + i), b = Index(a + n + 1);
            mesh.facets.push_back({a, a + 1, b});
            mesh.facets.push_back({b, a + 1, b + 1});
        }
}

/// A sheet of 40 mm with a hole of 4 mm, and a loose one of 2 mm above it.
Mesh scan() {
    Mesh mesh;
    add_sheet(mesh, 40, 0, 0, 10, 14);
    add_sheet(mesh, 2, 50, 5);
    return mesh;
}

std::vector<Kind> kinds_of(const std::vector<RepairStep>& recipe) {
    std::vector<Kind> kinds;
    for (const RepairStep& step : recipe)
        kinds.push_back(step.kind);
    return kinds;
}

} // namespace

class TestSuggestion : public QObject {
    Q_OBJECT
private slots:
    void it_is_for_what_was_found() {
        const Mesh mesh = scan();
        const Survey survey = survey_mesh(mesh, {});
        const auto recipe = suggested_recipe(mesh, survey, false, LengthUnit::mm);
        QCOMPARE(kinds_of(recipe), (std::vector<Kind>{Kind::pieces, Kind::holes}));
        QCOMPARE(recipe[0].size, 5.0);  // the loose piece is 2.83 mm across
        QCOMPARE(recipe[1].size, 10.0); // the hole is 5.66 mm across
        check_recipe(recipe, "repair");
        // It does what it says, and the rim of the sheet is left.
        const Repaired done = repaired(mesh, recipe);
        QCOMPARE(done.steps[0].count("pieces_removed"), std::size_t(1));
        QCOMPARE(done.steps[1].count("filled"), std::size_t(1));
        QCOMPARE(survey_mesh(*done.mesh, {}).holes.holes.size(), std::size_t(1));
        // In inches the numbers are round there.
        QVERIFY(std::abs(suggested_recipe(mesh, survey, false, LengthUnit::inch)[0].size - 0.2 * 25.4)
                < 1e-9);
        QCOMPARE(kinds_of(suggested_recipe(mesh, survey, true, LengthUnit::mm)),
                 (std::vector<Kind>{Kind::pieces, Kind::turn, Kind::holes}));
    }

    void nothing_is_suggested_for_what_is_whole() {
        Mesh sheet;
        add_sheet(sheet, 10, 0, 0);
        QVERIFY(suggested_recipe(sheet, survey_mesh(sheet, {}), false, LengthUnit::mm).empty());
        // Facets against their neighbours ask for a turn.
        std::swap(sheet.facets[33][0], sheet.facets[33][1]);
        const auto recipe = suggested_recipe(sheet, survey_mesh(sheet, {}), false, LengthUnit::mm);
        QVERIFY(!recipe.empty());
        QVERIFY(recipe.front().kind == Kind::turn);
    }

    void a_step_begins_with_amounts_that_are_allowed() {
        const Box3 box = scan().box();
        for (std::size_t k = 0; k < repair_step_parameters().find("kind")->info.words.size(); ++k) {
            RepairStep step = starting_step(Kind(k), box, LengthUnit::mm);
            if (step.kind == Kind::join) step.file = "other.stl"; // which nobody could know
            check_recipe({step}, "repair");
        }
    }

    void holes_go_as_limits_say() {
        const Mesh mesh = scan();
        const Survey survey = survey_mesh(mesh, {});
        using Fates = std::vector<HoleFate>;
        constexpr auto left = HoleFate::left, filled = HoleFate::filled, goes = HoleFate::goes;
        // The rim of the sheet, the hole, the rim of the loose piece.
        QCOMPARE(survey.holes.holes.size(), std::size_t(3));
        RepairStep holes{.kind = Kind::holes}, pieces{.kind = Kind::pieces};
        holes.size = 5;
        pieces.size = 5;
        QVERIFY(hole_fates(mesh, survey, {}) == (Fates{left, left, left}));
        QVERIFY(hole_fates(mesh, survey, {holes}) == (Fates{left, left, filled}));
        QVERIFY(hole_fates(mesh, survey, {pieces, holes}) == (Fates{left, left, goes}));
        holes.size = 6;
        QVERIFY(hole_fates(mesh, survey, {holes, pieces}) == (Fates{left, filled, filled}));
        holes.size = 0;
        QVERIFY(hole_fates(mesh, survey, {holes}) == (Fates{filled, filled, filled}));
        RepairStep one{.kind = Kind::hole};
        const Vec3 at = survey.holes.holes[1].center;
        one.at = {at.x(), at.y(), at.z()};
        QVERIFY(hole_fates(mesh, survey, {one}) == (Fates{left, filled, left}));
        one.fill = RepairStep::Fill::left;
        QVERIFY(hole_fates(mesh, survey, {one, holes}) == (Fates{filled, left, filled}));
        QVERIFY(hole_fates(mesh, survey, {holes, one}) == (Fates{filled, filled, filled}));
        holes.off = true;
        QVERIFY(hole_fates(mesh, survey, {holes, pieces}) == (Fates{left, left, goes}));
    }

    void a_step_that_is_off_is_left_out() {
        const Mesh mesh = scan();
        RepairStep pieces{.kind = Kind::pieces}, holes{.kind = Kind::holes};
        pieces.size = holes.size = 6;
        pieces.off = true;
        const Repaired done = repaired(mesh, {pieces, holes});
        QCOMPARE(done.steps.size(), std::size_t(1));
        QVERIFY(done.steps[0].kind == Kind::holes);
        // Off as it is, it has to say what it would do.
        pieces.size = 0;
        QVERIFY_EXCEPTION_THROWN(check_recipe({pieces}, "repair"), Error);
    }
};

FACETMILL_TEST(TestSuggestion)
#include "test_suggestion.moc"
