// Programs of controls. The first character chooses the control, upright or tilted; with "--seeds FOLDER" the
// target writes a program for each of them and ends.
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/small_program.h"

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace facetmill;

namespace {

constexpr char first_choice = 'a';

void write_seeds(const std::filesystem::path& folder) {
    char choice = first_choice;
    for (const Post& post : posts())
        for (const bool tilted : {false, true}) {
            fuzz::reads([&] {
                const std::string text = fuzz::posted(post, tilted);
                std::ofstream(folder / (post.name + (tilted ? "-tilted" : "")), std::ios::binary)
                    << choice << text;
            });
            ++choice;
        }
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    if (*argc != 3 || std::string_view((*argv)[1]) != "--seeds") return 0;
    write_seeds((*argv)[2]);
    std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::size_t choice = std::uint8_t(data[0] - first_choice) % (2 * posts().size());
    const bool tilted = choice % 2 == 1;
    fuzz::reads([&] {
        fuzz::check_program(read_nc(fuzz::text_of(data + 1, size - 1), "a.nc", posts()[choice / 2],
                                    fuzz::nc_setup(tilted), Progress()));
    });
    return 0;
}
