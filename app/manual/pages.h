// The pages of the manual in a language: those of resources/manual, the glossary and the reference of
// parameters. A page that is not in the language stands in English.
#pragma once

#include "app/manual/markdown.h"
#include "app/manual/words.h"

#include <filesystem>
#include <string>
#include <vector>

namespace facetmill::manual {

struct NamedPage {
    std::string file; ///< without ".html"
    Page page;
    std::filesystem::path source;
};

/// In the order of contents.txt. Links, anchors and pictures that lead nowhere are errors.
std::vector<NamedPage> manual_pages(const std::filesystem::path& resources, const Words& words);

/// Pictures that are there in a language of their own, resources/pictures/manual/de: their names, sorted.
std::vector<std::string> own_pictures(const std::filesystem::path& resources, const std::string& language);

/// The folders of resources/manual, "de", sorted; English is none of them.
std::vector<std::string> manual_languages(const std::filesystem::path& resources);

} // namespace facetmill::manual
