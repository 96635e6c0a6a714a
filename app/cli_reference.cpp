// facetmill-cli reference: the page of all parameters.
#include "app/cli_commands.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/job/reference.h"

namespace facetmill::cli {

namespace {

void run_reference(const Arguments& arguments, Session& session) {
    const std::string page = reference_page();
    if (!arguments.has("-o")) {
        session.print(page);
        return;
    }
    OutputFile file(arguments.value("-o"));
    file.write(page);
    file.commit();
}

} // namespace

Command reference_command() {
    return {.name = "reference",
            .summary = "Prints all parameters of projects, tools and operations as a Markdown page.",
            .options = {{.name = "-o", .value = "FILE", .help = "writes it to a file instead"}},
            .run = run_reference};
}

} // namespace facetmill::cli
