// CL files.
#include "core/output/apt.h"
#include "tests/fuzz/fuzz.h"

using namespace facetmill;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::reads([&] {
        const AptReadResult read = parse_apt(fuzz::text_of(data, size), "a.apt", LengthUnit::mm, Progress());
        if (read.tools.size() != read.program.sections.size()) fuzz::found("tools and sections differ");
        for (const auto& section : read.program.sections)
            fuzz::check_motions(section->motions.motions);
        for (const std::string& line : read.ignored)
            if (line != printable(line, line.size())) fuzz::found("a statement that cannot be shown");
    });
    return 0;
}
