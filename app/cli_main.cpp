// facetmill-cli: Facetmill without a display. Results go to stdout, messages to stderr; see `usage_text` for
// the exit status.
#include "app/cli_commands.h"
#include "app/cli_pictures.h"
#include "app/cli_session.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/parallel.h"
#include "core/base/parameter.h"
#include "facetmill_version.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace facetmill::cli {

const std::vector<Command>& commands() {
    static const std::vector<Command> all = {
        info_command(),     sample_command(),   place_command(),  repair_command(),   plan_command(),
        simulate_command(), cspace_command(),   drop_command(),   render_command(),   report_command(),
        export_command(),   pack_command(),     unpack_command(), template_command(), study_command(),
        tools_command(),    reference_command()};
    return all;
}

OptionInfo threads_option() {
    return {.name = "--threads",
            .value = "N",
            .help = "threads to use; results do not depend on it (default: all cores)"};
}

void use_threads(const Arguments& arguments) {
    if (!arguments.has("--threads")) return;
    constexpr double most = 4096;
    const double n = arguments.number("--threads", 0);
    if (n != double(long(n)) || n < 1 || n > most)
        throw Error(ErrorCode::usage, "--threads",
                    "'" + printable(arguments.value("--threads")) + "' is not a number of threads",
                    "write a whole number from 1");
    set_thread_count(int(n));
}

namespace {

enum Status { done = 0, failed = 1, wrong_usage = 2 };

std::string usage_text() {
    std::string text = "usage: facetmill-cli COMMAND ...\n\ncommands:\n";
    for (const Command& c : commands()) {
        std::string left = "  " + c.name;
        left.resize(14, ' ');
        text += left + c.summary + "\n";
    }
    text += "\nfacetmill-cli COMMAND --help explains a command, --version prints the version.\n"
            "Exit status: 0 done; 1 the job failed (one line on stderr) or was cancelled; 2 wrong usage.\n"
            "Ctrl-C cancels and leaves no partial file.\n";
    return text;
}

void report_error(const Error& e) {
    std::fprintf(stderr, "facetmill-cli: error [%s] %s\n", std::string(code_name(e.code())).c_str(),
                 printable(e.what(), 4000).c_str());
}

int run_command(const Command& command, const std::vector<std::string>& words) {
    const Arguments arguments(command, words);
    Session session;
    const InputsKept kept;
    command.run(arguments, session);
    session.finish();
    return session.failed() ? failed : done;
}

int run(const std::vector<std::string>& words) {
    std::string usage = "usage: facetmill-cli COMMAND ... (see facetmill-cli --help)";
    try {
        if (words.empty())
            throw Error(ErrorCode::usage, "", "no command is given", "see facetmill-cli --help");
        const std::string& first = words[0];
        if (first == "--version") {
            Session().print("facetmill-cli " FACETMILL_VERSION "\n");
            return done;
        }
        if (first == "--help" || first == "-h" || first == "help") {
            Session().print(usage_text());
            return done;
        }
        std::vector<std::string> names;
        for (const Command& c : commands()) {
            names.push_back(c.name);
            if (c.name != first) continue;
            const std::vector<std::string> rest(words.begin() + 1, words.end());
            usage = "usage: " + c.usage();
            for (const auto& w : rest) {
                if (w == "--") break;
                if (w != "--help" && w != "-h") continue;
                Session().print(c.help_text());
                return done;
            }
            if (c.draws) go_on_with_pictures(words);
            return run_command(c, rest);
        }
        const std::string near = nearest_name(first, names);
        throw Error(ErrorCode::usage, "", "unknown command '" + printable(first) + "'",
                    near.empty() ? "see facetmill-cli --help" : "did you mean '" + near + "'?");
    } catch (const Cancelled&) {
        std::fputs("facetmill-cli: cancelled\n", stderr);
        return failed;
    } catch (const Error& e) {
        report_error(e);
        if (e.code() != ErrorCode::usage) return failed;
        std::fprintf(stderr, "%s\n", usage.c_str());
        return wrong_usage;
    } catch (const std::bad_alloc&) {
        report_error(Error(ErrorCode::limit_exceeded, "", "the memory is not sufficient",
                           "use a smaller part or a coarser tolerance"));
    } catch (const std::exception& e) {
        report_error(
            Error(ErrorCode::internal, "", printable(e.what(), 400), "report this with the command line"));
    }
    return failed;
}

} // namespace
} // namespace facetmill::cli

int main(int argc, char** argv) {
    // A closed pipe is an error of the write, not the end of the process: outputs are then cleaned up.
    std::signal(SIGPIPE, SIG_IGN);
    return facetmill::cli::run(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
}
