#include "app/cli_pictures.h"

#ifdef FACETMILL_PICTURES_APART
#include "core/base/error.h"

#include <filesystem>

#include <unistd.h>
#endif

namespace facetmill::cli {

#ifdef FACETMILL_PICTURES_APART

void go_on_with_pictures(const std::vector<std::string>& words) {
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    std::vector<std::string> all{"facetmill-cli"};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& word : all)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::filesystem::path places[] = {folder / "facetmill-pictures",
                                            folder / "../libexec/facetmill/facetmill-pictures"};
    for (const auto& place : places)
        execv(place.c_str(), arguments.data());
    throw Error(ErrorCode::not_found, "facetmill-pictures", "the program that draws is not beside this one",
                "install all of Facetmill, or keep the two in one folder");
}

#else

void go_on_with_pictures(const std::vector<std::string>&) {}

#endif

} // namespace facetmill::cli
