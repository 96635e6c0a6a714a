#include "ui/value_words.h"

#include "ui/text.h"
#include "ui/worded.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

struct ValueWord {
    const char *key, *word; ///< key: empty for all parameters
    const char* shown;
    const char* said; ///< in a sentence; empty: as it is
};

constexpr ValueWord value_words[] = {
    {"", "from_tolerance", QT_TRANSLATE_NOOP("ValueWords", "from the tolerance"),
     QT_TRANSLATE_NOOP("ValueWords", "“from the tolerance”")},
    {"", "oneway", QT_TRANSLATE_NOOP("ValueWords", "one way"), QT_TRANSLATE_NOOP("ValueWords", "“one way”")},
    {"", "cm2", QT_TRANSLATE_NOOP("ValueWords", "curvature matched (CM²)"),
     QT_TRANSLATE_NOOP("ValueWords", "CM²")},
    {"programs", "each", QT_TRANSLATE_NOOP("ValueWords", "one for each operation"), ""},
    {"programs", "one", QT_TRANSLATE_NOOP("ValueWords", "one with tool changes"), ""},
    {"zero_from", "origin", QT_TRANSLATE_NOOP("ValueWords", "the part's origin"), ""},
    {"zero_from", "stock", QT_TRANSLATE_NOOP("ValueWords", "the stock's box"), ""},
    {"zero_from", "part", QT_TRANSLATE_NOOP("ValueWords", "the part's box"), ""},
    {"contain", "contact", QT_TRANSLATE_NOOP("ValueWords", "where it touches"), ""},
    {"contain", "tip", QT_TRANSLATE_NOOP("ValueWords", "the tip"), ""},
    {"contain", "tool", QT_TRANSLATE_NOOP("ValueWords", "all of the cutter"), ""},
    {"axis", "points", QT_TRANSLATE_NOOP("ValueWords", "through two points"), ""},
    {"passes", "morph", QT_TRANSLATE_NOOP("ValueWords", "from edge to edge"),
     QT_TRANSLATE_NOOP("ValueWords", "“from edge to edge”")},
    {"passes", "around", QT_TRANSLATE_NOOP("ValueWords", "in rings"),
     QT_TRANSLATE_NOOP("ValueWords", "“in rings”")},
    {"lift", "strip", QT_TRANSLATE_NOOP("ValueWords", "as the strip asks"), ""},
    {"lift", "z", QT_TRANSLATE_NOOP("ValueWords", "along Z"), ""},
    {"offset", "contact", QT_TRANSLATE_NOOP("ValueWords", "exact, at the contact"), ""},
    {"offset", "vertices", QT_TRANSLATE_NOOP("ValueWords", "by moved vertices"),
     QT_TRANSLATE_NOOP("ValueWords", "“by moved vertices”")},
};

QString translated(const char* text) {
    return QCoreApplication::translate("ValueWords", text);
}

const ValueWord* value_word(const ParameterInfo& info, const std::string& word) {
    for (const ValueWord& w : value_words)
        if (word == w.word && (!*w.key || info.key == w.key)) return &w;
    return nullptr;
}

} // namespace

QString shown_word(const ParameterInfo& info, const std::string& word) {
    if (const ValueWord* w = value_word(info, word)) return translated(w->shown);
    return worded(text(word).replace(QChar('_'), QChar(' ')));
}

QString word_of(const ParameterInfo& info, const QString& shown) {
    for (const std::string& word : info.words)
        if (shown.trimmed().compare(shown_word(info, word), Qt::CaseInsensitive) == 0) return text(word);
    return shown;
}

QString shown_count(const ParameterInfo& info, const ParameterValue& value) {
    const QString count = text(info.count_text(value));
    const QString number = count.section(QChar(' '), 0, 0), noun = count.section(QChar(' '), 1);
    return noun.isEmpty() ? worded(count) : number + QChar(' ') + worded(noun);
}

QString with_shown_words(const ParameterInfo& info, const QString& sentence) {
    QString result = sentence;
    for (const std::string& word : info.words)
        if (const ValueWord* w = value_word(info, word); w && *w->said)
            result.replace(QRegularExpression(QStringLiteral("(?<![\\w'])%1(?!\\w)").arg(text(word))),
                           translated(w->said));
    return result;
}

QString shown_number(double core_value, const ParameterInfo& info, LengthUnit unit) {
    constexpr int all_digits = 9, few_digits = 4, decimals_of_others = 4;
    const double value = core_value / info.scale(unit);
    const double nearest = std::stod(format_number(value, all_digits));
    if (std::abs(nearest - value) <= 1e-12 * std::abs(value)) return number_text(value, all_digits);
    const int decimals = info.quantity == Quantity::length ? position_decimals(unit) : decimals_of_others;
    const int digits = int(std::floor(std::log10(std::abs(value)))) + 1 + decimals;
    return number_text(value, std::clamp(digits, few_digits, all_digits));
}

int position_decimals(LengthUnit unit) {
    return unit == LengthUnit::inch ? 4 : 3;
}

QString position_text(double mm, LengthUnit unit) {
    const double value = mm / mm_per(unit);
    const int whole = value == 0 ? 0 : int(std::floor(std::log10(std::abs(value)))) + 1;
    const int digits = whole + position_decimals(unit);
    return number_text(digits < 1 ? 0 : value, std::max(digits, 1));
}

} // namespace facetmill::ui
