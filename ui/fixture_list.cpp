#include "ui/fixture_list.h"

#include "core/job/project_inputs.h"
#include "core/job/stock_solid.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QRegularExpression>

#include <algorithm>
#include <set>
#include <string>

namespace facetmill::ui {

std::size_t add_fixture(Document& document, NewFixture what) {
    const Project& project = document.project();
    const std::size_t at = project.fixtures.size();
    if (!document.part_is_current()) return at;
    const StockSolid stock = stock_solid(project.stock, *document.part());
    const Box3& box = stock.box.empty() ? document.part()->box : stock.box;
    std::vector<Fixture> made = new_fixtures(project, what, *document.part()->mesh, box);
    if (made.empty())
        throw Error(ErrorCode::empty_result, "tabs", "nowhere is the part's outline straight and free enough",
                    "add a box, choose the kind \"tab\" and move it to its place");
    // Core says in English what they are, and numbers them: "Clamp 2".
    std::set<std::string> taken;
    for (Fixture& f : made) {
        static const QRegularExpression number(QStringLiteral(" \\d+$"));
        const std::string wish = utf8(worded(text(f.name).remove(number)));
        f.name = free_name(wish, [&](const std::string& name) {
            return taken.contains(name)
                   || std::any_of(project.fixtures.begin(), project.fixtures.end(),
                                  [&](const Fixture& other) { return other.name == name; });
        });
        taken.insert(f.name);
    }
    document.change(Document::tr("Add fixture"),
                    [&](Project& p) { p.fixtures.insert(p.fixtures.end(), made.begin(), made.end()); });
    return at;
}

void duplicate_fixture(Document& document, std::size_t i) {
    Fixture copy = document.project().fixtures.at(i);
    copy.name = free_fixture_name(document.project(), copy.name);
    copy.translate[1] += copy.kind == Fixture::Kind::cylinder ? copy.diameter : copy.size[1];
    document.change(Document::tr("Duplicate fixture"),
                    [&](Project& p) { p.fixtures.insert(p.fixtures.begin() + std::ptrdiff_t(i) + 1, copy); });
}

void remove_fixture(Document& document, std::size_t i) {
    document.change(Document::tr("Remove fixture"),
                    [&](Project& p) { p.fixtures.erase(p.fixtures.begin() + std::ptrdiff_t(i)); });
}

void set_fixture_file(Document& document, std::size_t i, const std::filesystem::path& file) {
    document.change(Document::tr("Choose fixture"), [&](Project& p) {
        if (i == p.fixtures.size()) {
            Fixture made;
            made.name = free_fixture_name(p, file.stem().string());
            made.unit = p.unit;
            p.fixtures.push_back(made);
        }
        Fixture& fixture = p.fixtures.at(i);
        // A mesh stands where its file has it.
        if (fixture.kind != Fixture::Kind::mesh) fixture.translate = fixture.rotate = {0, 0, 0};
        fixture.kind = Fixture::Kind::mesh;
        set_input(p, {ProjectInput::Kind::fixture, {}, i}, file);
    });
}

} // namespace facetmill::ui
