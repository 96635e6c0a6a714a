// facetmill-cli template: what of a project serves other parts.
#include "app/cli_commands.h"
#include "app/cli_mesh.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/base/strict_json.h"
#include "core/job/asked_operations.h"
#include "core/job/job_template.h"
#include "core/mesh/mesh_format.h"
#include "core/mesh/mesh_io.h"

namespace facetmill::cli {

namespace {

constexpr std::string_view template_project_ending = ".facetmill";

Json template_account(const std::string& file, const Project& project) {
    Json operations = Json::array();
    for (const auto& o : project.operations)
        operations.push_back({{"name", o->common().name}, {"kind", std::string(o->kind())}});
    Json tools = Json::array();
    const std::vector<long> used = tools_of(project);
    for (const Tool& t : project.tools)
        if (std::find(used.begin(), used.end(), t.number) != used.end()) tools.push_back(t.number);
    return {{"file", printable(file, 400)}, {"operations", operations}, {"tools", tools}};
}

void refuse_extra(const Arguments& arguments) {
    if (arguments.has_operand(2))
        throw Error(ErrorCode::usage, "template", "save takes one project", "leave the rest out");
    if (arguments.has("--units"))
        throw Error(ErrorCode::usage, "--units", "a project says the unit of its part", "leave it out");
}

void run_save(const Arguments& arguments, Session& session) {
    refuse_extra(arguments);
    const std::string &input = arguments.operand(1), output = arguments.value("-o");
    const Project project = asked_setup(arguments, load_project(input), true);
    refuse_to_overwrite(input, output);
    keep_inputs(project, output);
    const std::string text = template_text(project);
    OutputSet set;
    set.add(output).write(text);
    const Json account = template_account(output, parse_project(text, output));
    set.commit([&] { session.print(pretty_json(account)); });
}

/// What a new project for a part begins with.
Project project_for(const std::string& part, const Arguments& arguments, const Progress& progress) {
    const MeshFormat* format = mesh_format_named(part);
    if (format && format->needs_unit() && !arguments.has("--units"))
        throw Error(ErrorCode::usage, "--units", "the file of the part does not say its unit",
                    "write --units mm or --units in");
    const LoadedMesh loaded = load_mesh(part, asked_reading(arguments), progress);
    return default_project(part, loaded.report.assumed_unit, loaded.mesh->box());
}

void run_apply(const Arguments& arguments, Session& session) {
    if (!arguments.has_operand(2))
        throw Error(ErrorCode::usage, "template", "apply wants a template, and a part or a project",
                    "write facetmill-cli template apply FILE PART -o PROJECT");
    const std::string &kept = arguments.operand(1), &onto = arguments.operand(2);
    const std::string output = arguments.value("-o");
    const bool is_project = onto.ends_with(template_project_ending);
    if (is_project && arguments.has("--units")) refuse_extra(arguments);
    if (!is_project && arguments.has("--setup"))
        throw Error(ErrorCode::usage, "--setup", "a part has no setups", "leave it out");
    const Project before = is_project ? asked_setup(arguments, load_project(onto), true)
                                      : project_for(onto, arguments, session.progress());
    for (const std::string& input : {kept, onto})
        refuse_to_overwrite(input, output);
    const InputFile file(kept);
    AppliedTemplate applied = apply_template(file.bytes(), printable(kept, 400), before);
    move_project(applied.project, output);
    for (const std::string& remark : applied.remarks)
        session.say(remark);
    Json account = template_account(output, applied.project);
    account["remarks"] = applied.remarks;
    session.print(pretty_json(account));
    save_project(applied.project, output);
}

void run_template(const Arguments& arguments, Session& session) {
    const std::string& what = arguments.operand(0);
    if (what == "save") return run_save(arguments, session);
    if (what == "apply") return run_apply(arguments, session);
    throw Error(ErrorCode::usage, "template", "'" + printable(what) + "' is neither save nor apply",
                "give save and a project, or apply, a template and a part");
}

} // namespace

Command template_command() {
    return {
        .name = "template",
        .operands = {"save|apply", "FILE", "[PART|PROJECT]"},
        .summary = "Keeps operations, tools and settings for other parts, and applies them.",
        .help =
            "save PROJECT -o FILE writes the setup's operations, the tools that they need, stock, machine,\n"
            "programs and limits as a template. apply FILE PART -o PROJECT makes a project of them for a\n"
            "mesh; apply FILE PROJECT -o PROJECT puts them in place of those of a project's setup. What\n"
            "does not fit there is said on stderr, and stands under \"remarks\".",
        .options = {{.name = "-o", .value = "FILE", .help = "the file to write", .required = true},
                    {.name = "--units",
                     .value = "U",
                     .help =
                         "apply: unit of the part's file, where that does not say it: mm, cm, m, in or ft"},
                    setup_option()},
        .run = run_template};
}

} // namespace facetmill::cli
