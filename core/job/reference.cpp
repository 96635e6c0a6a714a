#include "core/job/reference.h"

#include "core/job/project.h"
#include "core/output/post/post.h"
#include "core/setup/machine.h"

namespace facetmill {

namespace {

constexpr LengthUnit shown_unit = LengthUnit::mm;

std::string type_text(const ParameterInfo& p) {
    std::string words;
    for (const auto& w : p.words)
        words += (words.empty() ? "`" : ", `") + w + "`";
    switch (p.kind) {
    case ParameterKind::number:
        return "number";
    case ParameterKind::number_or_word:
        return "number or " + words;
    case ParameterKind::integer:
        return "whole number";
    case ParameterKind::boolean:
        return "`true` or `false`";
    case ParameterKind::choice:
        return words;
    case ParameterKind::text:
        return "text";
    case ParameterKind::pair:
        return "two numbers";
    case ParameterKind::triple:
        return "three numbers";
    case ParameterKind::names:
        return "names, separated by commas";
    case ParameterKind::records:
        return "list, see below";
    }
    return {};
}

/// A cell of a table: no bars, no line breaks.
std::string cell(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') text[i] = ' ';
        if (text[i] == '|') text.insert(i++, "\\");
    }
    return text;
}

/// What stands where the key is missing, in a cell.
std::string default_text(const ParameterInfo& p) {
    if (!p.required.empty()) return "required";
    if (p.kind == ParameterKind::records) return "none";
    const std::string value = p.value_text(p.default_value, shown_unit);
    return value.empty() ? "" : "`" + cell(value) + "`";
}

/// `level`: of the headings of lists, which follow the table.
void table(std::string& page, const std::vector<const ParameterInfo*>& parameters, const std::string& level) {
    page += "| key | meaning | value | unit | range | default |\n|---|---|---|---|---|---|\n";
    for (const ParameterInfo* p : parameters)
        page += "| `" + p->key + "` | **" + cell(p->label) + ".** " + cell(p->help) + " | "
                + cell(type_text(*p)) + " | " + std::string(edge_unit_name(p->quantity, shown_unit)) + " | "
                + cell(p->range_text(shown_unit)) + " | " + default_text(*p) + " |\n";
    page += '\n';
    for (const ParameterInfo* p : parameters) {
        if (p->kind != ParameterKind::records) continue;
        page += level + " Each of `" + p->key + "`\n\n";
        table(page, p->record, level + "#");
    }
}

/// Keys of the project file itself, one row each.
std::string program_rows() {
    std::string rows;
    for (const ParameterInfo* p : program_parameters().infos())
        rows += "| `" + p->key + "` | **" + cell(p->label) + ".** " + cell(p->help) + " |\n";
    return rows;
}

void post_table(std::string& page) {
    page += "\n## Controls\n\n| `post` | meaning | extension | several axes |\n|---|---|---|---|\n";
    const char* const kinds[] = {"no", "joints", "tip and rotary axes (TCP)", "tip and tool axis (TCP)"};
    for (const Post& p : posts())
        page += "| `" + p.name + "` | **" + cell(p.label) + ".** " + cell(p.description) + " | `"
                + p.extension + "` | " + kinds[std::size_t(p.multi_axis)] + " |\n";
}

void machine_tables(std::string& page) {
    page += "## Machines\n\n| `machine` | meaning | kind |\n|---|---|---|\n";
    for (const Machine& m : machines())
        page += "| `" + m.name + "` | **" + cell(m.label) + ".** " + cell(m.description) + " | "
                + machine_kind(m) + " |\n";
    page +=
        "\nTheir axes; a rotary one that a head carries turns the tool, one of a table the part.\n\n"
        "| machine | axis | carries | travel | largest speed | acceleration |\n|---|---|---|---|---|---|\n";
    for (const Machine& m : machines())
        for (int k = 0; k < m.joints(); ++k) {
            const bool rotary = k >= 3;
            const double unit = rotary ? radians(1) : 1;
            const std::string name = rotary ? "°" : " mm";
            const Travel& t = m.joint_travel(k);
            const bool head = rotary && m.rotary[std::size_t(k - 3)].carries == RotaryAxis::Carries::tool;
            page +=
                "| `" + m.name + "` | " + m.axis_name(k) + " | " + (rotary ? head ? "tool" : "table" : "")
                + " | "
                + (t.limited() ? format_number(t.lo / unit) + " to " + format_number(t.hi / unit) + name : "")
                + " | " + format_number(m.speed(k) / unit) + name + "/s | "
                + (m.acceleration(k) < infinity ? format_number(m.acceleration(k) / unit) + name + "/s²" : "")
                + " |\n";
        }
}

/// What keys the kinds of a stock, fixture or boundary have.
template <class Spec, class Keys>
void kind_rows(std::string& page, const ParameterTable<Spec>& parameters, const Keys& keys_of) {
    for (const std::string& kind : parameters.find("kind")->info.words) {
        Spec spec;
        ParameterView<Spec>(spec, parameters).set("kind", kind);
        std::string keys;
        for (const std::string& key : keys_of(spec))
            if (key != "kind") keys += (keys.empty() ? "`" : ", `") + key + "`";
        page += "- `" + kind + "`" + (keys.empty() ? "" : ": ") + keys
                + (kind == "mesh" ? "; `file` is required" : "") + "\n";
    }
}

} // namespace

std::string reference_page() {
    std::string page =
        "# Parameters\n\n"
        "Written by `facetmill-cli reference` from the program's own descriptions; a test keeps it current.\n"
        "Units, ranges and defaults are shown for a project in mm. In a project file lengths are in its "
        "`units`,\n"
        "angles in degrees, feeds in units per minute. `--set NAME.key=value` sets any key of an operation "
        "for\n"
        "one run, `part.key=value` one of the part; keys of programs go without a name, or with a "
        "setup's.\n\n"
        "## Project file\n\n"
        "JSON in UTF-8. An unknown key, a key that occurs twice, a wrong type and a value out of range are\n"
        "errors that name the key.\n\n"
        "| key | meaning |\n|---|---|\n"
        "| `facetmill` | Version of the file: "
        + std::to_string(single_setup_version) + ", or " + std::to_string(project_version)
        + " where it lists `setups`. Older files are migrated. Required. |\n"
          "| `units` | `mm` or `in`: unit of every length in the file. Required. |\n"
          "| `part` | The part, see below. Required. |\n"
          "| `stock` | The raw material, see below. Default: the part's box. |\n"
          "| `fixtures` | List of what holds the part, see below; written in a setup. |\n"
          "| `boundaries` | List of regions that operations may name, see below; written in a setup. |\n"
          "| `machine` | Name of a machine, see below, or a machine file of your own "
          "(`resources/machines/README.md`); its "
          "name ends with `.json`, a relative one starts at the project file. Default: `"
        + Project().machine + "`. |\n" + program_rows()
        + "| `verification` | What may happen to the part, see below. |\n"
          "| `tools` | List of tools, see below. |\n"
          "| `operations` | List of operations in machining order; each has a `kind` and the keys of that "
          "kind. |\n\n"
          "## Setups\n\n"
          "A file of version "
        + std::to_string(project_version)
        + " has `setups`, a list in machining order. Each has its own `stock`, `fixtures`, `boundaries`,\n"
          "`operations`, `machine` and keys of programs (`post`, `wcs`, `zero`, ...), as above; what the "
          "file itself says "
          "of machine "
          "and programs\n"
          "holds for setups that say nothing of them. `units`, `part`, `tools` and `verification` are "
          "shared. "
          "Names of\n"
          "operations occur once in a project. In a setup, all places are those of the part as the setup "
          "holds it.\n\n"
          "| key | meaning |\n|---|---|\n"
          "| `name` | Each setup has its own. Default: `"
        + usual_setup_name(0)
        + "`, and so on. |\n"
          "| `place` | How the part lies in this setup, see below. Default: as `part` places it. |\n"
          "| `stock` | Default after the first setup: `rest`, what the setup before left. |\n\n"
          "### `place`\n\n";
    table(page, place_parameters().infos(), "###");
    page += "## Part\n\n";
    table(page, part_parameters().infos(), "###");
    page += "## Stock\n\n";
    kind_rows(page, stock_parameters(), [](const StockSpec& s) { return stock_keys(s.kind); });
    page += "\n";
    table(page, stock_parameters().infos(), "###");
    page +=
        "## Fixtures\n\nEvery operation keeps its tool off them, and the verification watches that. Places "
        "are those of the\nsetup.\n\n";
    kind_rows(page, fixture_parameters(), [](const Fixture& f) { return fixture_keys(f.kind); });
    page += "\n";
    table(page, fixture_parameters().infos(), "###");
    page += "## Boundaries\n\nRegions of the part's surface. An operation names one as `boundary`, and cuts "
            "within it, or as `avoid`, and\nkeeps off. Places are those of the setup.\n\n";
    kind_rows(page, boundary_parameters(), [](const Boundary& b) { return boundary_keys(b.kind); });
    page += "\n";
    table(page, boundary_parameters().infos(), "###");
    page += "## Verification\n\n";
    table(page, verify_limit_parameters().infos(), "###");
    machine_tables(page);
    post_table(page);
    page += "\n## Tools\n\n`shank_diameter` is the tool's diameter where it is not given.\n\n";
    table(page, tool_parameters().infos(), "###");
    page += "## Operations\n\n| key | meaning |\n|---|---|\n"
            "| `kind` | The kind of operation: what the headings below say. Required. |\n\n";
    for (const OperationKind& kind : operation_kinds()) {
        page += "### `" + kind.kind + "`: " + kind.label + "\n\n";
        table(page, kind.make()->parameters(), "####");
    }
    page.pop_back();
    return page;
}

} // namespace facetmill
