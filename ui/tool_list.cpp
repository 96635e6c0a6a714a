#include "ui/tool_list.h"

#include "core/job/asked_operations.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QLocale>

#include <algorithm>

namespace facetmill::ui {

ToolNameStyle spoken_tool_names() {
    return {[](const std::string& english) { return utf8(worded(english)); }, utf8(QLocale().decimalPoint())};
}

std::string usual_tool_name_said(const Tool& tool, LengthUnit unit) {
    return usual_tool_name(tool, unit, spoken_tool_names());
}

void name_tools(Project& project) {
    for (Tool& tool : project.tools)
        if (tool.name == usual_tool_name(tool, project.unit))
            tool.name = usual_tool_name_said(tool, project.unit);
}

void add_tool(Document& document, const Tool& tool) {
    document.change(Document::tr("Add tool"), [&](Project& p) { p.tools.push_back(tool); });
}

void set_tool(Document& document, std::size_t i, const Tool& tool) {
    document.change(Document::tr("Edit tool"), [&](Project& p) {
        const long old_number = p.tools.at(i).number;
        p.tools[i] = tool;
        for (Operation* o : all_operations(p)) // the operations stay with their tool when its number changes
            o->renumber_tool(old_number, tool.number);
        for (std::size_t k = 0; k < setup_count(p); ++k)
            for (Boundary& b : setup_at(p, k).boundaries)
                if (b.tool == old_number) b.tool = tool.number;
    });
}

void duplicate_tool(Document& document, std::size_t i) {
    Tool copy = document.project().tools.at(i);
    copy.number = document.free_tool_number();
    document.change(Document::tr("Duplicate tool"),
                    [&](Project& p) { p.tools.insert(p.tools.begin() + std::ptrdiff_t(i) + 1, copy); });
}

void remove_tool(Document& document, std::size_t i) {
    const Project& project = document.project();
    const Tool& tool = project.tools.at(i);
    for (const Operation* o : all_operations(project))
        if (const auto numbers = tools_of(*o);
            std::find(numbers.begin(), numbers.end(), tool.number) != numbers.end())
            throw Error(ErrorCode::missing_reference, "tool " + std::to_string(tool.number),
                        "operation '" + o->common().name + "' uses this tool",
                        "give the operation another tool first");
    for (std::size_t k = 0; k < setup_count(project); ++k)
        for (const Boundary& b : setup_at(project, k).boundaries)
            if (b.kind == Boundary::Kind::rest && b.tool == tool.number)
                throw Error(ErrorCode::missing_reference, "tool " + std::to_string(tool.number),
                            "boundary '" + b.name + "' is what this tool leaves",
                            "give the boundary another tool first");
    document.change(Document::tr("Remove tool"),
                    [&](Project& p) { p.tools.erase(p.tools.begin() + std::ptrdiff_t(i)); });
}

} // namespace facetmill::ui
