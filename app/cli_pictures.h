// The commands that draw, in a program of their own: facetmill-pictures, which has VTK.
#pragma once

#include <string>
#include <vector>

namespace facetmill::cli {

/// Goes on as that program, with the same words, files and process; does not come back. Comes back at once
/// where this program draws by itself, or was built without pictures. Throws Error(not_found) where the other
/// is neither beside this one nor in ../libexec/facetmill.
void go_on_with_pictures(const std::vector<std::string>& words);

} // namespace facetmill::cli
