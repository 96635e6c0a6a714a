// Machine files.
#include "core/setup/machine.h"
#include "tests/fuzz/fuzz.h"

using namespace facetmill;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::reads([&] {
        const Machine machine = parse_machine(fuzz::text_of(data, size), "a.json");
        if (machine.rotary.size() > 2) fuzz::found("more than two rotary axes");
    });
    return 0;
}
