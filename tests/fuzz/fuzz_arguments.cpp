// Command lines: words between zeros, for a command with every kind of option; and the texts of cutters.
#include "app/cli_arguments.h"
#include "core/cutter/cutter.h"
#include "tests/fuzz/fuzz.h"

using namespace facetmill;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const cli::Command command = {
        .name = "drop",
        .operands = {"PART"},
        .options = {{.name = "--cutter", .value = "SHAPE", .required = true},
                    {.name = "--set", .value = "NAME.key=value", .repeated = true},
                    {.name = "--units", .value = "mm|in"},
                    {.name = "--threads", .value = "N"},
                    {.name = "--yes-large"},
                    {.name = "-o", .value = "FILE"}}};
    std::vector<std::string> words(1);
    for (const char c : fuzz::text_of(data, size)) {
        if (c == '\0')
            words.emplace_back();
        else
            words.back() += c;
    }
    fuzz::reads([&] {
        const cli::Arguments arguments(command, words);
        fuzz::reads([&] { arguments.unit("--units", LengthUnit::mm); });
        fuzz::reads([&] { arguments.number("--threads", 1); });
        fuzz::reads([&] {
            const CutterProfile profile(parse_cutter(arguments.value("--cutter"), 1));
            if (!(profile.max_radius() > 0)) fuzz::found("a cutter without extent");
        });
    });
    return 0;
}
