// Between core's values and the words on the screen.
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace facetmill::ui {

inline QString text(std::string_view s) {
    return QString::fromUtf8(s.data(), qsizetype(s.size()));
}
inline std::string utf8(const QString& s) {
    return s.toStdString();
}

/// For what is said outside of a class, in the user's language: there is no QObject::tr to inherit.
inline QString tr(const char* text) {
    return QObject::tr(text);
}

QString path_text(const std::filesystem::path& path);
std::filesystem::path path_of(const QString& text);

/// "*.stl *.STL *.obj *.OBJ": the names of mesh files, for a file dialog.
QString mesh_patterns();
/// The unit of this name that a mesh may be in; none for other texts.
std::optional<LengthUnit> mesh_unit_of(const QString& name);
/// The filters of a file dialog for a mesh: all formats together, each by itself, and all files.
QString mesh_filters();

/// A number as `format_number` rounds it, with the user's decimal mark.
QString number_text(double value, int digits = 6);
/// The same for the numbers in a text of core, "0.5 mm"; names and words that hold digits stay. Where the
/// mark is a comma, semicolons stand between numbers.
QString in_user_numbers(const QString& text);
/// Numbers one after the other: "1.5, 2", "1,5; 2".
QString number_list(const QStringList& numbers);
/// What stands between clauses that are put one after the other: "; ".
QString clause_mark();
/// Names that stand 'in quotes', as core has them, in the quotes of the language; apostrophes stay.
QString in_user_quotes(const QString& text);
/// What the user typed, with points for decimal marks, as core reads it. Who writes commas may write points
/// as well; only "1.500", which may be meant for thousands, is refused: Error(wrong_type), with `where` for
/// its place.
QString with_decimal_point(const QString& entered, const std::string& where);

/// "12.7 mm", "0.5 in": a length of core (mm) in the unit of the project.
QString shown_length(double mm, LengthUnit unit, int digits = 5);
/// "12.7 mm²".
QString shown_area(double mm2, LengthUnit unit, int digits = 3);
/// "10 × 8 × 2 in".
QString size_text(const double (&mm)[3], LengthUnit unit, int digits = 5);
/// "1 234 567" with narrow spaces.
QString count_text(std::size_t n);
/// "0.4 s", "12 s", "3 min 20 s", "1 h 05 min".
QString duration_text(double seconds);
/// A share as "12.5 %"; "< 0.01 %" where it is not quite nothing.
QString percent_text(double share);
/// `text` cut in the middle so that it has at most `characters` ones.
QString elided(const QString& text, int characters);
/// The first names as a sentence has them: "a", "a and b", "a, b, c and 4 more"; what is longer is shortened.
QString some_of(const QStringList& names, int longest = 32);
/// "What: this of it", as the language has its colons.
QString said_of(const QString& what, const QString& said);
/// Messages of core name lengths in millimetres ("1.5 mm"); the same message with them in the unit of the
/// project.
QString with_lengths_in(const QString& message, LengthUnit unit);
/// A sentence for a widget that breaks lines, or HTML for it: a number stays in one line with its unit. Texts
/// that files and other programs get keep their plain spaces.
QString kept_together(const QString& text);
/// First letter in upper case: messages of core begin in lower case.
QString sentence(const QString& text);
/// "What is wrong: what to do about it", without a full stop.
QString failure_text(const Error& e);

} // namespace facetmill::ui
