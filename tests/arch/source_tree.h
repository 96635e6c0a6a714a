// The files of the source tree, as the tests of its order read them.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace facetmill::test {

/// Text of every header and source below `folders` (both written from the root), by its path from the root.
std::map<std::string, std::string> sources(const std::vector<std::string>& folders);

} // namespace facetmill::test
