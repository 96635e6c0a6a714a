// Post files: what is taken for a post writes a program that its own reader takes, or says why it cannot.
#include "core/output/post/post.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/small_program.h"

using namespace facetmill;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Post post;
    if (!fuzz::reads([&] { post = parse_post(fuzz::text_of(data, size), "a.json"); })) return 0;
    for (const bool tilted : {false, true}) {
        std::string text;
        if (!fuzz::reads([&] { text = fuzz::posted(post, tilted); })) continue;
        fuzz::reads(
            [&] { fuzz::check_program(read_nc(text, "a.nc", post, fuzz::nc_setup(tilted), Progress())); });
    }
    return 0;
}
