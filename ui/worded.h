// What core says, in the language of the window. Core knows no languages: it puts its messages together in
// English, "the diameter 0 is not above 0", and each has a template, "the diameter {1} is not above 0", which
// is its id in the catalogues (resources/languages). A message is known again by its template, and what fills
// the places stands in the translation's.
#pragma once

#include "core/base/error.h"

#include <QString>

#include <optional>
#include <string_view>

namespace facetmill::ui {

/// A message, warning, label or help text of core; where the catalogue has no such text, as it is. Of a whole
/// line of an error, "where: what (what to do)", each by itself. Names in quotes stay.
QString worded(std::string_view english);
QString worded(const QString& english);
QString worded(const char* english);

/// The whole line of an error.
QString worded(const Error& e);

/// What fills the places of a template, where the text is one of it: "the diameter {1} is not above 0".
std::optional<QStringList> filled_places(const QString& message, const QString& id);

/// The template that says most of a message, of all that it may be one of; empty where there is none.
QString message_id(const QString& message);

} // namespace facetmill::ui
