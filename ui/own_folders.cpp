#include "ui/own_folders.h"

#include "core/tools/library_file.h"
#include "ui/settings.h"
#include "ui/text.h"

namespace facetmill::ui {

std::filesystem::path usual_own_folder() {
    return user_library_folder().parent_path();
}

std::filesystem::path own_folder() {
    const QString chosen = settings::own_folder();
    return chosen.isEmpty() ? usual_own_folder() : path_of(chosen);
}

std::filesystem::path own_library_folder() {
    return own_folder() / user_library_folder().filename();
}

std::filesystem::path own_template_folder() {
    return own_folder() / "templates";
}

} // namespace facetmill::ui
