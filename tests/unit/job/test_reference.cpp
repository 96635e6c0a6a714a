// The reference page: as the program writes it, with every key that the reader of projects takes.
#include "core/base/file.h"
#include "core/job/project.h"
#include "core/job/reference.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;

namespace {

/// A key that the reader of projects takes, and where on the reference page it has to stand.
struct Known {
    std::string heading, list, key; ///< list: whose records have it; empty: none
    std::string name() const { return heading + " " + list + (list.empty() ? "" : ".") + key; }
};

/// The keys that the reader names to one that it does not know, and that has no likeness to any of them; none
/// where it wants no object. `text`: a project with these members in the object's beginning.
std::vector<std::string> named_keys(const std::function<std::string(const std::string&)>& text) {
    const std::string stranger(70, 'q');
    std::string members = "\"" + stranger + "\": 0";
    for (int i = 0; i < 20; ++i) {
        try {
            parse_project(text(members), "p.facetmill");
            return {};
        } catch (const Error& e) {
            const std::string last = e.where().substr(e.where().find_last_of(".: ") + 1);
            if (e.code() == ErrorCode::missing_key) { // it wants that first
                members += ", \"" + last + "\": 0";
                continue;
            }
            if (e.code() != ErrorCode::unknown_key || !last.starts_with("qqqq")) return {};
            const std::string title = "known keys: ";
            if (!e.remedy().starts_with(title)) qFatal("%s", e.what());
            std::vector<std::string> keys;
            for (std::size_t at = title.size(); at < e.remedy().size();) {
                const std::size_t end = std::min(e.remedy().find(", ", at), e.remedy().size());
                keys.push_back(e.remedy().substr(at, end - at));
                at = end + 2;
            }
            return keys;
        }
    }
    qFatal("the reader wants ever more keys");
}

/// Those of an object, and of the records of its lists.
void add_known(std::vector<Known>& all, const std::string& heading,
               const std::function<std::string(const std::string&)>& text) {
    for (const std::string& key : named_keys(text)) {
        if (key == "kind" && heading.starts_with("###")) continue; // stands once, before the kinds
        all.push_back({heading, "", key});
        const auto in_list = [&](const std::string& members) {
            return text("\"" + key + "\": [ { " + members + " } ]");
        };
        if (heading == "## Project file") continue; // its lists have headings of their own
        for (const std::string& field : named_keys(in_list))
            all.push_back({heading, key, field});
    }
}

/// All that the reader takes anywhere in a project.
std::vector<Known> keys_of_the_reader() {
    std::vector<Known> all;
    const std::string head = "{ \"facetmill\": 1, \"units\": \"mm\"",
                      part = ", \"part\": { \"file\": \"a.stl\" }";
    add_known(all, "## Project file",
              [&](const std::string& members) { return "{ " + members + ", \"facetmill\": 1 }"; });
    add_known(all, "## Part",
              [&](const std::string& members) { return head + ", \"part\": { " + members + " } }"; });
    add_known(all, "## Stock",
              [&](const std::string& members) { return head + part + ", \"stock\": { " + members + " } }"; });
    add_known(all, "## Fixtures", [&](const std::string& members) {
        return head + part + ", \"fixtures\": [ { " + members + " } ] }";
    });
    add_known(all, "## Tools", [&](const std::string& members) {
        return head + part + ", \"tools\": [ { " + members + ", \"number\": 1, \"diameter\": 1 } ] }";
    });
    all.push_back({"## Operations", "", "kind"});
    for (const OperationKind& kind : operation_kinds())
        add_known(all, "### `" + kind.kind + "`", [&](const std::string& members) {
            return head + part + ", \"operations\": [ { " + members + ", \"tool\": 1, \"kind\": \""
                   + kind.kind + "\" } ] }";
        });
    return all;
}

/// Lines of the page, from and to.
struct Section {
    std::size_t first = std::string::npos, last = std::string::npos;
};

/// Where the page has to have the key: below its heading, before the next one, or in the lists' own.
Section section_of(const std::string& page, const Known& known) {
    Section section;
    const std::string level = known.heading.substr(0, known.heading.find(' '));
    section.first = page.find("\n" + known.heading);
    if (section.first == std::string::npos) return section;
    if (!known.list.empty()) {
        const std::size_t end = std::min(page.find("\n" + level + " ", section.first + 1), page.size());
        section.first = page.find("\n" + level + "# Each of `" + known.list + "`", section.first + 1);
        if (section.first > end) return {};
    }
    section.last = std::min(page.find("\n#", section.first + 1), page.size());
    return section;
}

std::string row_of(const Known& known) {
    return "\n| `" + known.key + "` |";
}

/// The keys that the page does not have where they belong, a line each.
std::string not_on(const std::string& page, const std::vector<Known>& all) {
    std::string missing;
    for (const Known& known : all) {
        const Section section = section_of(page, known);
        const bool there =
            section.first != std::string::npos && page.find(row_of(known), section.first) < section.last;
        if (!there) missing += known.name() + "\n";
    }
    return missing;
}

} // namespace

class TestReference : public QObject {
    Q_OBJECT
private slots:
    void the_reference_page_is_current() {
        const std::filesystem::path path = test::data_path("../resources/reference.md");
        QVERIFY2(std::filesystem::exists(path),
                 "write it with: facetmill-cli reference -o resources/reference.md");
        QVERIFY2(std::string(InputFile(path).bytes()) == reference_page(),
                 "renew it with: facetmill-cli reference -o resources/reference.md");
        for (const OperationKind& kind : operation_kinds())
            for (const ParameterInfo* info : kind.make()->parameters()) {
                QVERIFY2(!info->label.empty() && !info->help.empty(), info->key.c_str());
                for (const ParameterInfo* field : info->record)
                    QVERIFY2(!field->label.empty() && !field->help.empty(), field->key.c_str());
            }
    }

    /// Every key that the reader takes has its row where it belongs, and a row that is missing is missed.
    void the_reference_page_has_every_key_of_the_reader() {
        const std::string page = reference_page();
        const std::vector<Known> all = keys_of_the_reader();
        QVERIFY2(all.size() > 150, std::to_string(all.size()).c_str());
        const auto has = [&](const char* heading, const char* list, const char* key) {
            return std::any_of(all.begin(), all.end(), [&](const Known& k) {
                return k.heading == heading && k.list == list && k.key == key;
            });
        };
        QVERIFY(has("### `finish5`", "manual_postures", "yaw"));
        QVERIFY(has("### `global_local`", "region_edits", "enabled"));
        QVERIFY(has("### `global_local`", "boundary_drags", "from"));
        QVERIFY(has("### `cleanup`", "", "switched_off"));
        QVERIFY(has("## Tools", "holder", "length"));
        QVERIFY(has("## Fixtures", "", "clearance"));
        QVERIFY(has("## Stock", "", "margin") && has("## Project file", "", "machine"));
        QCOMPARE(not_on(page, all), std::string());
        for (const Known& k : all) {
            std::string torn = page;
            torn.erase(torn.find(row_of(k), section_of(page, k).first), row_of(k).size());
            QCOMPARE(not_on(torn, all), k.name() + "\n");
        }
    }
};

FACETMILL_TEST(TestReference)
#include "test_reference.moc"
