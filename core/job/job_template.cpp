#include "core/job/job_template.h"

#include "core/base/text.h"
#include "core/job/asked_operations.h"
#include "core/job/copied_operations.h"
#include "core/job/setting_remarks.h"

#include <algorithm>

namespace facetmill {

namespace {

/// No part has this name: nothing of a template belongs to places of one.
constexpr const char* no_part = "template";

/// A place in space, that of the part it was made for.
bool is_place(const ParameterInfo& info) {
    return info.kind == ParameterKind::triple && info.quantity == Quantity::length;
}

void leave_places(Operation& operation) {
    forget_places(operation);
    for (const ParameterInfo* info : operation.parameters())
        if (is_place(*info)) operation.set(info->key, info->default_value);
    // A turning axis by points is one of that part.
    if (operation.turning() && operation.get("axis") == ParameterValue(std::string("points")))
        operation.set("axis", operation.parameter("axis").default_value);
}

/// A stock that other parts can have; of a mesh, and of what a setup before left, only that it was one.
StockSpec general_stock(const StockSpec& stock) {
    StockSpec general = stock;
    if (stock.kind == StockSpec::Kind::mesh || stock.kind == StockSpec::Kind::rest) general = StockSpec();
    general.diameter = StockSpec().diameter;
    return general;
}

/// Those that any part has.
bool serves_others(const Boundary& b) {
    return b.kind == Boundary::Kind::slope || b.kind == Boundary::Kind::silhouette;
}

/// Operations may name it, and it is none: facets of no part.
Boundary without_facets(const std::string& name) {
    Boundary b;
    b.name = name;
    return b;
}

/// Control, files and arcs of the one; zero, work coordinate system and numbers, which belong to a part in
/// its vice and to the programs beside, of the other.
ProgramSpec with_programs_of(const ProgramSpec& from, ProgramSpec to) {
    to.post = from.post;
    to.files = from.files;
    to.arcs = from.arcs;
    return to;
}

std::string counted(std::size_t n, const char* one, const char* several) {
    return std::to_string(n) + " " + (n == 1 ? one : several);
}

std::vector<long> used_tools(const Project& project) {
    std::vector<long> used;
    for (std::size_t i = 0; i < setup_count(project); ++i) {
        const std::vector<long> its = tools_of(setup_at(project, i));
        used.insert(used.end(), its.begin(), its.end());
        for (const Boundary& b : setup_at(project, i).boundaries)
            used.push_back(b.tool);
    }
    return used;
}

class Applying {
public:
    Applying(const Project& kept, const Project& project) : kept_(kept) { applied_.project = project; }

    AppliedTemplate run() {
        remove_operations();
        take_settings();
        take_boundaries();
        take_operations();
        for (std::size_t i = 0; i < applied_.project.operations.size(); ++i)
            for (const SettingRemark& r : setting_remarks(applied_.project, i))
                say(i, r);
        return std::move(applied_);
    }

private:
    /// And the tools that nothing else uses: those of the template may have their numbers then.
    void remove_operations() {
        Project& p = applied_.project;
        const std::vector<long> freed = tools_of(p);
        p.operations.clear();
        const std::vector<long> used = used_tools(p);
        const auto holds = [](const std::vector<long>& list, long number) {
            return std::find(list.begin(), list.end(), number) != list.end();
        };
        std::erase_if(p.tools,
                      [&](const Tool& t) { return holds(freed, t.number) && !holds(used, t.number); });
    }

    void take_settings() {
        Project& p = applied_.project;
        p.machine = kept_.machine;
        p.programs = with_programs_of(kept_.programs, p.programs);
        p.limits = kept_.limits;
        // What the setups before left is the stock, whatever a template says.
        if (p.stock.kind == StockSpec::Kind::rest)
            applied_.remarks.push_back("The stock stays what the setup before leaves.");
        else
            p.stock = kept_.stock;
    }

    void take_boundaries() {
        auto& there = applied_.project.boundaries;
        for (const Boundary& b : kept_.boundaries)
            if (serves_others(b) && std::none_of(there.begin(), there.end(), [&](const Boundary& t) {
                    return t.name == b.name;
                }))
                there.push_back(b);
    }

    void take_operations() {
        Project& p = applied_.project;
        PastedOperations pasted = pasted_operations(kept_, p);
        p.tools.insert(p.tools.end(), pasted.tools.begin(), pasted.tools.end());
        p.operations = std::move(pasted.operations);
        for (const std::string& remark : pasted.remarks)
            applied_.remarks.push_back(remark + ".");
    }

    void say(std::size_t operation, const SettingRemark& r) {
        const Operation& o = *applied_.project.operations[operation];
        const std::string label = r.key.empty() ? std::string() : ", " + o.parameter(r.key).label;
        const bool ends = r.message.ends_with('.');
        applied_.remarks.push_back("'" + printable(o.common().name) + "'" + label + ": " + r.message
                                   + (ends ? "" : "."));
    }

    const Project& kept_;
    AppliedTemplate applied_;
};

} // namespace

std::string template_text(const Project& project) {
    Project kept;
    kept.unit = project.unit;
    kept.part.file = no_part;
    kept.part.unit = project.unit;
    kept.limits = project.limits;
    kept.stock = general_stock(project.stock);
    kept.programs = with_programs_of(project.programs, ProgramSpec());
    kept.machine = is_machine_file(project.machine) ? project.machine_path().string() : project.machine;
    if (is_post_file(project.programs.post)) kept.programs.post = project.post_path().string();
    for (const auto& o : project.operations) {
        kept.operations.push_back(o->clone());
        leave_places(*kept.operations.back());
    }
    const std::vector<long> used = tools_of(kept);
    for (const Tool& t : project.tools)
        if (std::find(used.begin(), used.end(), t.number) != used.end()) kept.tools.push_back(t);
    for (const Boundary& b : project.boundaries)
        kept.boundaries.push_back(serves_others(b) ? b : without_facets(b.name));
    return project_to_json(kept);
}

AppliedTemplate apply_template(std::string_view text, const std::string& name, const Project& project) {
    return Applying(parse_project(text, name), project).run();
}

std::string template_summary(std::string_view text, const std::string& name) {
    const Project kept = parse_project(text, name);
    return counted(kept.operations.size(), "operation", "operations") + ", "
           + counted(kept.tools.size(), "tool", "tools");
}

} // namespace facetmill
