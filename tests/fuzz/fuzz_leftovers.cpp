// The record of a set of files that a killed run left: whatever it says, only files of its own folder are
// meant.
#include "core/base/leftovers.h"
#include "tests/fuzz/fuzz.h"

using namespace facetmill;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto set = detail::read_set_record(std::string(fuzz::text_of(data, size)));
    for (const detail::Replaced& r : set)
        if (r.target.empty() || (r.target + r.before).find('/') != std::string::npos || r.target == "..")
            fuzz::found("a record names another folder");
    if (set.empty()) return 0;
    const auto again = detail::read_set_record(detail::set_record(set));
    if (again.size() != set.size()) fuzz::found("a record reads differently once it is written");
    return 0;
}
