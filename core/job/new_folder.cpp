#include "core/job/new_folder.h"

#include "core/base/error.h"

#include <system_error>

namespace facetmill {

namespace fs = std::filesystem;

NewFolder::NewFolder(const fs::path& path) {
    std::error_code ec;
    fs::path top = path;
    while (!top.empty() && !fs::exists(top, ec)) {
        made_.push_back(top);
        top = top.has_relative_path() ? top.parent_path() : fs::path();
    }
    fs::create_directories(path, ec);
    if (std::error_code none; !fs::is_directory(path, none)) {
        remove();
        throw Error(ErrorCode::unwritable, printable(path.string(), 400),
                    "cannot make the folder" + (ec ? ": " + ec.message() : std::string()),
                    "name a folder that exists or can be made");
    }
}

void NewFolder::remove() {
    std::error_code ec;
    for (const fs::path& p : made_)
        fs::remove(p, ec); // only when empty
}

} // namespace facetmill
