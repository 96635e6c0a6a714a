// facetmill-cli tools: the user's tool libraries, and those of other programs.
#include "app/cli_commands.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/base/strict_json.h"
#include "core/job/project.h"
#include "core/tools/library_file.h"

#include <algorithm>

namespace facetmill::cli {

namespace fs = std::filesystem;

namespace {

Json account_of(const ToolLibrary& library, const std::vector<std::string>& remarks) {
    const double per = mm_per(library.unit);
    Json tools = Json::array(), holders = Json::array();
    for (const LibraryTool& t : library.tools)
        tools.push_back({{"number", t.tool.number},
                         {"name", t.tool.name},
                         {"shape", t.tool.shape_name()},
                         {"diameter", json_number(t.tool.diameter / per, "diameter")}});
    for (const ToolHolder& h : library.holders)
        holders.push_back(h.name);
    return {{"library", library.name},
            {"units", std::string(unit_name(library.unit))},
            {"tools", tools},
            {"holders", holders},
            {"remarks", remarks}};
}

fs::path library_folder(const Arguments& arguments) {
    const std::string folder = arguments.value("--library");
    return folder.empty() ? user_library_folder() : fs::path(folder);
}

/// Every library of the folder, one after the other, by their names.
ToolLibrary all_of(const fs::path& folder) {
    const std::vector<KeptLibrary> kept = kept_libraries(folder);
    if (kept.empty())
        throw Error(ErrorCode::not_found, printable(folder.string(), 400), "has no tool library",
                    "import one first, or name a project by --project");
    ToolLibrary all;
    for (const KeptLibrary& one : kept) {
        // What cannot be read is told by reading it once more.
        const ToolLibrary library =
            one.trouble.empty() ? one.library : load_library(one.file, LengthUnit::mm).library;
        if (all.tools.empty() && all.holders.empty()) {
            all.name = library.name;
            all.unit = library.unit;
        }
        all.tools.insert(all.tools.end(), library.tools.begin(), library.tools.end());
        all.holders.insert(all.holders.end(), library.holders.begin(), library.holders.end());
    }
    return all;
}

ToolLibrary tools_of(const Project& project) {
    return library_of(project.tools, project.unit, printable(project.path.stem().string(), 200));
}

/// Those whose numbers are asked for, or all.
void keep_asked(ToolLibrary& library, const Arguments& arguments) {
    const std::vector<std::string> asked = arguments.values("--tool");
    if (asked.empty()) return;
    std::vector<LibraryTool> kept;
    for (const std::string& text : asked) {
        double number = 0;
        const bool is_number = parse_number(text, number);
        const auto found =
            std::find_if(library.tools.begin(), library.tools.end(), [&](const LibraryTool& t) {
                return is_number ? double(t.tool.number) == number : t.tool.name == text;
            });
        if (found == library.tools.end())
            throw Error(ErrorCode::missing_reference, "--tool", "there is no tool '" + printable(text) + "'",
                        "name one of the library by its number or name");
        kept.push_back(*found);
    }
    library.tools = std::move(kept);
    library.holders.clear();
}

void import_library(const Arguments& arguments, Session& session) {
    const std::string& input = arguments.operand(1);
    const ReadLibrary read = load_library(input, arguments.unit("--units", LengthUnit::mm));
    ToolLibrary library = read.library;
    keep_asked(library, arguments);
    Json account = account_of(library, read.remarks);
    if (const std::string into = arguments.value("--project"); !into.empty()) {
        const std::string output = arguments.value("-o");
        if (output.empty())
            throw Error(ErrorCode::usage, "-o", "is missing",
                        "name the project to write with the tools in it");
        Project project = load_project(into);
        refuse_to_overwrite(into, output);
        for (const LibraryTool& t : library.tools)
            project.tools.push_back(numbered_for(t, project.tools));
        account["file"] = printable(output, 400);
        session.print(pretty_json(account));
        save_project(project, output);
        return;
    }
    if (arguments.has("-o"))
        throw Error(ErrorCode::usage, "-o", "is for a project",
                    "give --project, or leave it out: libraries are kept in their folder");
    keep_library(library, library_folder(arguments), fs::path(input).stem().string(),
                 [&](const fs::path& place) {
                     account["file"] = printable(place.string(), 400);
                     session.print(pretty_json(account));
                 });
}

void export_library(const Arguments& arguments, Session& session) {
    const fs::path output = arguments.operand(1);
    const std::string from = arguments.value("--project");
    ToolLibrary library = from.empty() ? all_of(library_folder(arguments)) : tools_of(load_project(from));
    keep_asked(library, arguments);
    library.unit = arguments.unit("--units", library.unit);
    const std::string format = arguments.value("--format");
    const WrittenLibrary written =
        write_library(library, format.empty() ? format_of(output) : library_format(format, "--format"),
                      output.filename().string());
    if (!from.empty()) refuse_to_overwrite(from, output);
    OutputSet set;
    Json files = Json::array();
    for (const WrittenLibrary::File& file : written.files) {
        const fs::path place = output.parent_path() / file.name;
        files.push_back(printable(place.string(), 400));
        set.add(place).write(file.bytes);
    }
    Json account = account_of(library, written.remarks);
    account["files"] = files;
    set.commit([&] { session.print(pretty_json(account)); });
}

void run_tools(const Arguments& arguments, Session& session) {
    const std::string& what = arguments.operand(0);
    if (what == "import") return import_library(arguments, session);
    if (what == "export") return export_library(arguments, session);
    throw Error(ErrorCode::usage, "tools", "'" + printable(what) + "' is neither import nor export",
                "give import or export, and a file");
}

} // namespace

Command tools_command() {
    return {
        .name = "tools",
        .operands = {"import|export", "FILE"},
        .summary = "Takes tool libraries of other programs over, and writes them.",
        .help =
            "Reads and writes Facetmill (.fmtools), FreeCAD (.fctb, .fctl, .fcholder), Fusion (.json, "
            ".tools),\n"
            "LinuxCNC (.tbl), CAMotics and Kiri:Moto (.json). What is imported is kept among the user's own\n"
            "libraries, or put into a project; what is exported comes from there. Every field that cannot "
            "be\n"
            "carried is named under \"remarks\". Cones of holders become steps that lie outside of them.",
        .options =
            {{.name = "--project",
              .value = "PROJECT",
              .help = "takes the tools from this project, or puts them into it"},
             {.name = "-o",
              .value = "FILE.facetmill",
              .help = "import: the project to write with the tools in it"},
             {.name = "--tool",
              .value = "T",
              .help = "only the tool of this number or name",
              .repeated = true},
             {.name = "--format",
              .value = "F",
              .help =
                  "export: camotics or kirimoto for a .json that is not Fusion's; else by the file's name"},
             {.name = "--units",
              .value = "U",
              .help = "mm or in: of a file that does not say (.tbl, .fctb), or of the file that is written"},
             {.name = "--library",
              .value = "DIR",
              .help = "the user's libraries (default: facetmill/tools in the user's data folder)"}},
        .run = run_tools};
}

} // namespace facetmill::cli
