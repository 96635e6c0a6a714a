// What overlays say, in the language of the window. Viz knows no languages: it says everything in English,
// and who knows others tells how it is said in them.
#pragma once

#include <functional>
#include <string>

namespace facetmill {

/// From now on every text of an overlay is drawn, and measured, as `words` says it; none: as it is. Of the
/// thread that draws.
void set_overlay_words(std::function<std::string(const std::string&)> words);

std::string overlay_words(const std::string& english);

} // namespace facetmill
