// A language that the program has not: every text with accents and 40 % longer, what no layout was drawn for.
#pragma once

#include <QTranslator>

namespace facetmill::test {

class LongTexts : public QTranslator {
public:
    QString translate(const char* context, const char* source, const char* comment, int n) const override;
    bool isEmpty() const override { return false; }
    /// Places, mnemonics, tags and patterns of files stay.
    static QString lengthened(const QString& text);
};

} // namespace facetmill::test
