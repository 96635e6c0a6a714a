#include "tests/screenshot/long_texts.h"

#include <QRegularExpression>

#include <algorithm>

namespace facetmill::test {

QString LongTexts::translate(const char* context, const char* source, const char* /*comment*/,
                             int /*n*/) const {
    const QLatin1String asked(context ? context : "");
    if (asked.startsWith(QLatin1Char('Q')) && asked != QLatin1String("QObject")) return {};
    return lengthened(QString::fromUtf8(source));
}

QString LongTexts::lengthened(const QString& text) {
    static const QRegularExpression kept(
        QStringLiteral("%L?\\d|%n|\\{\\d+\\}|&\\w|<[^>]*>|`[^`]*`|\\*\\.\\w+|;;"));
    static const QRegularExpression letters(QStringLiteral("[A-Za-z]{3,}"));
    if (!text.contains(letters)) return text;
    QString spoken = text;
    for (qsizetype i = 0; i < spoken.size(); ++i) {
        const auto at = kept.match(spoken, i, QRegularExpression::NormalMatch,
                                   QRegularExpression::AnchorAtOffsetMatchOption);
        if (at.hasMatch())
            i += at.capturedLength() - 1;
        else if (const qsizetype k = QStringLiteral("aeiou").indexOf(spoken[i]); k >= 0)
            spoken[i] = QStringLiteral("äéîöû")[k];
    }
    // Behind the last letter, so that dots, colons and blanks at the end stay there.
    static const QRegularExpression end(QStringLiteral("[\\s.:;,…)*]*$"));
    const qsizetype more = (text.size() * 4 + 9) / 10;
    QString filler;
    while (filler.size() < more)
        filler += filler.size() % 9 == 0 ? QChar(' ') : QChar(0x00F6);
    const qsizetype tail = end.match(spoken).capturedStart();
    // Words of menus and buttons grow as words do; a blank first would break them in two.
    return spoken.left(tail) + (more < 6 ? filler.mid(0).replace(QChar(' '), QChar(0x00F6)) : filler)
           + spoken.mid(tail);
}

} // namespace facetmill::test
