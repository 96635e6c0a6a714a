// JSON as projects and machines are read: what is read and written again is the same.
#include "core/base/strict_json.h"
#include "tests/fuzz/fuzz.h"

using namespace facetmill;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::reads([&] {
        const Json json = parse_strict_json(fuzz::text_of(data, size), "a.json");
        const std::string text = pretty_json(json);
        if (parse_strict_json(text, "again") != json) fuzz::found("written JSON reads differently");
        if (pretty_json(json) != text) fuzz::found("the same JSON is written differently");
    });
    return 0;
}
