#include "viz/overlay_words.h"

#include <utility>

namespace facetmill {

namespace {

std::function<std::string(const std::string&)>& said_as() {
    static std::function<std::string(const std::string&)> words;
    return words;
}

} // namespace

void set_overlay_words(std::function<std::string(const std::string&)> words) {
    said_as() = std::move(words);
}

std::string overlay_words(const std::string& english) {
    return said_as() ? said_as()(english) : english;
}

} // namespace facetmill
