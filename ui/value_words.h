// The words of files and of the command line as the window says them: "oneway" is "one way". Files, programs
// and the reference keep theirs.
#pragma once

#include "core/base/parameter.h"

#include <QString>

namespace facetmill::ui {

/// A value of `info` that is a word, for a field or a list.
QString shown_word(const ParameterInfo& info, const std::string& word);
/// What shown_word makes of a word of `info`, or the word itself, back again; other texts stay.
QString word_of(const ParameterInfo& info, const QString& shown);
/// What a list holds: "3 kept postures", "none".
QString shown_count(const ParameterInfo& info, const ParameterValue& value);
/// A sentence about the parameter, such as its help, with its words as fields show them.
QString with_shown_words(const ParameterInfo& info, const QString& sentence);

/// A number for a field, in the edge's unit. What was typed is round, and stays as it is. What was worked
/// out, or typed in the other unit (2 mm in a project in inches), has the digits that mean something: of
/// lengths the decimals of a position, and four digits at least. What the user does not touch keeps all its
/// digits.
QString shown_number(double core_value, const ParameterInfo& info, LengthUnit unit);

/// "-3.141": where something is, in the unit of the project, as finely as one measures there.
QString position_text(double mm, LengthUnit unit);
/// How many decimals that are: thousandths of a millimetre, ten-thousandths of an inch.
int position_decimals(LengthUnit unit);

} // namespace facetmill::ui
