// facetmill-cli pack, unpack: a project in one file with all that it names.
#include "app/cli_commands.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/base/strict_json.h"
#include "core/job/packed_project.h"

namespace facetmill::cli {

namespace {

/// `path_key`: what a file's place on disk is called.
std::string account(const std::string& target_key, const std::string& target,
                    const std::vector<PackedFile>& files, const char* path_key) {
    Json list = Json::array();
    for (const PackedFile& file : files)
        list.push_back(
            {{"name", file.name}, {path_key, printable(file.path.string(), 400)}, {"bytes", file.bytes}});
    Json out;
    out[target_key] = printable(target, 400);
    out["project"] = files.front().name;
    out["files"] = list;
    return pretty_json(out);
}

void run_pack(const Arguments& arguments, Session& session) {
    const std::string& input = arguments.operand(0);
    const std::string output = arguments.value("-o");
    const Project project = asked_project(arguments);
    refuse_to_overwrite(input, output);
    const std::string name = project.path.stem().string();
    try {
        pack_project(project, name, output, session.progress().part(0, 1, "Packing"),
                     [&](const std::vector<PackedFile>& files) {
                         session.print(account("file", output, files, "from"));
                     });
    } catch (const Error& e) {
        // Files on disk are named by themselves.
        throw e.code() == ErrorCode::not_found && !e.where().starts_with('/')
            ? e.within(printable(input, 400))
            : e;
    }
}

void run_unpack(const Arguments& arguments, Session& session) {
    const std::string folder = arguments.value("-o");
    check_folder(folder);
    unpack_project(arguments.operand(0), folder, session.progress().part(0, 1, "Unpacking"),
                   [&](const std::vector<PackedFile>& files) {
                       session.print(account("folder", folder, files, "file"));
                   });
}

} // namespace

Command pack_command() {
    return {
        .name = "pack",
        .operands = {"PROJECT"},
        .summary = "Packs a project and all files that it names into one file, to be sent.",
        .help = "Meshes of part, stocks and fixtures, machine and post files of all setups are packed as\n"
                "they are. Every command that takes a project takes a packed one; it is a zip archive.",
        .options = {set_option(),
                    {.name = "-o", .value = "FILE.facetmill", .help = "the file to write", .required = true}},
        .run = run_pack};
}

Command unpack_command() {
    return {
        .name = "unpack",
        .operands = {"FILE"},
        .summary = "Unpacks a packed project into a folder.",
        .help = "The folder is made where there is none. A file that is there already is never replaced;\n"
                "another one than that of the project is an error.",
        .options = {{.name = "-o", .value = "FOLDER", .help = "the folder to unpack into", .required = true}},
        .run = run_unpack};
}

} // namespace facetmill::cli
