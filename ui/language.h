// The language of the window: texts of the program, what core says (worded.h), Qt's own words, and how
// numbers are written.
#pragma once

#include <QLocale>
#include <QString>

#include <memory>
#include <span>

class QTranslator;

namespace facetmill::ui {

struct Language {
    const char* code; ///< "de", as files and settings have it
    const char* name; ///< as those who speak it write it
};

/// Those that the program speaks; first English, which the sources are written in.
std::span<const Language> languages();

/// The code of the language that `wanted` asks for: one of `languages`, or empty for the first of the
/// system's (LANGUAGE, LC_MESSAGES, LANG) that is among them. English where there is none.
QString language_for(const QString& wanted);

/// How numbers are written where `code` is spoken: as the system says where that is one of the language's
/// countries or was not asked otherwise, else as most who speak it do.
QLocale number_locale(const QString& wanted);

/// From now on texts come in the language that `wanted` asks for, and numbers are written its way. Windows
/// that are there keep what they say.
void speak(const QString& wanted);

/// The same by other texts and another way to write numbers: for tests of languages that the program has not.
void speak_by(std::unique_ptr<QTranslator> texts, const QLocale& numbers);

/// The code of what is spoken; empty by `speak_by`.
QString spoken_language();

/// What the 3D view writes, which is told in English, in the language that is spoken.
std::string said_in_view(const std::string& english);
/// A label in the middle of a sentence: in small letters, but for languages whose nouns have capitals.
QString in_a_sentence(const QString& label);

} // namespace facetmill::ui
