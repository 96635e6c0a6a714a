// What a call throws, for tests to compare.
#pragma once

#include "core/base/error.h"

#include <string>

namespace facetmill::test {

/// Word of the Error's code (code_name), "cancelled", or "none"; `message` gets the error's line.
template <class Call>
std::string code_of(Call&& call, std::string* message = nullptr) {
    try {
        call();
    } catch (const Error& e) {
        if (message) *message = e.what();
        return std::string(code_name(e.code()));
    } catch (const Cancelled&) {
        return "cancelled";
    }
    return "none";
}

} // namespace facetmill::test
