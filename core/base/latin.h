// Names for controls and files that know the letters a to z alone.
#pragma once

#include <string>
#include <string_view>

namespace facetmill {

/// UTF-8 text whose letters of European languages have lost their marks: "Höhe, Ébauche" is "Hoehe, Ebauche".
/// All else stays.
std::string without_marks(std::string_view text);

} // namespace facetmill
