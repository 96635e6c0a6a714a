// Where the user's own libraries and templates lie: in the folder that the preferences name, or where the
// command line looks, too.
#pragma once

#include <filesystem>

namespace facetmill::ui {

/// Without a word of the preferences.
std::filesystem::path usual_own_folder();
std::filesystem::path own_folder();
std::filesystem::path own_library_folder();
std::filesystem::path own_template_folder();

} // namespace facetmill::ui
