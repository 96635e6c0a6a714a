// Tool libraries. The first character chooses the format; what is read is written in every format, and read
// again where that was possible.
#include "core/tools/library_file.h"
#include "tests/fuzz/fuzz.h"

#include <array>

using namespace facetmill;

namespace {

constexpr char first_choice = 'a';
constexpr std::array names = {"a.fmtools", "a.fctb", "a.fctl", "a.fcholder", "a.json", "a.tools", "a.tbl"};
constexpr std::array formats = {LibraryFormat::facetmill, LibraryFormat::fusion, LibraryFormat::camotics,
                                LibraryFormat::kiri, LibraryFormat::linuxcnc};
constexpr std::array written_names = {"a.fmtools", "a.json", "a.json", "a.json", "a.tbl"};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const char* name = names[std::uint8_t(data[0] - first_choice) % names.size()];
    ReadLibrary read;
    if (!fuzz::reads([&] { read = read_library(fuzz::text_of(data + 1, size - 1), name, LengthUnit::mm); }))
        return 0;
    for (const LibraryTool& t : read.library.tools)
        if (!fuzz::reads([&] { check_tool(t.tool); })) fuzz::found("a tool that makes no cutter");
    for (std::size_t i = 0; i < formats.size(); ++i) {
        WrittenLibrary written;
        if (!fuzz::reads([&] { written = write_library(read.library, formats[i], written_names[i]); }))
            continue;
        ReadLibrary again;
        const bool back = fuzz::reads(
            [&] { again = read_library(written.files[0].bytes, written_names[i], LengthUnit::mm); });
        if (formats[i] == LibraryFormat::facetmill
            && (!back || again.library.tools.size() != read.library.tools.size()))
            fuzz::found("a library of our own does not come back");
    }
    return 0;
}
